// Elements, in short.

// el("td", { class: "x", onclick: f }, "text", child, null): null and false are left out.
export function el(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
        else if (value === true) element.setAttribute(name, "");
        else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, value);
    }
    element.append(...children.flat(Infinity).filter(child => child !== null && child !== undefined && child !== false));
    return element;
}

// A select with a label: options are [value, text]; the callback gets the value.
export function choice(label, options, chosen, onchange) {
    const select = el("select", { onchange: event => onchange(event.target.value) },
        options.map(([value, text]) => el("option", { value, selected: value === chosen }, text)));
    return el("label", {}, label + " ", select);
}

// A command with a button that copies it.
export function command(text) {
    const button = el("button", { type: "button", class: "copy", "aria-label": "copy the command" }, "copy");
    button.addEventListener("click", async () => {
        let copied = true;
        try {
            await navigator.clipboard.writeText(text);
        } catch {
            copied = copyBySelection(text);
        }
        button.textContent = copied ? "copied" : "no access";
        setTimeout(() => { button.textContent = "copy"; }, 1500);
    });
    return el("div", { class: "command" }, el("code", {}, text), button);
}

// Where the browser keeps its clipboard from pages of files.
function copyBySelection(text) {
    const area = el("textarea", { class: "aside" });
    area.value = text;
    document.body.append(area);
    area.select();
    const copied = document.execCommand("copy");
    area.remove();
    return copied;
}

export function table(headings, rows, attributes = {}) {
    return el("div", { class: "scroll", tabindex: "0", role: "group", "aria-label": attributes["aria-label"] },
        el("table", attributes,
            el("thead", {}, el("tr", {}, headings.map(heading => el("th", { scope: "col" }, heading)))),
            el("tbody", {}, rows.map(cells => el("tr", {}, cells.map((cell, index) =>
                index === 0 ? el("th", { scope: "row" }, cell) : el("td", {}, cell)))))));
}
