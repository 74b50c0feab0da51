// What is wrong with a report.json, by its schema.

import { readFileSync } from "node:fs";
import { library } from "./browser.js";

const Ajv = library("ajv/dist/2020").default;
const validate = new Ajv({ allErrors: true, strict: true, allowUnionTypes: true, strictRequired: false })
    .compile(JSON.parse(readFileSync(process.env.ETALON_PAGE_SCHEMA, "utf8")));

export const faults = json => (validate(json) ? [] : validate.errors.map(error => `${error.instancePath} ${error.message}`));
