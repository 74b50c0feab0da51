#!/usr/bin/env bash
# Installs what is missing of ci/packages.txt. Needs root (or sudo) only where something is missing.
set -euo pipefail
cd "$(dirname "$0")/.."

# What is installed, and what that provides: other builds of nodejs bring npm along.
declare -A have
while read -r status name provided; do
    if [ "$status" = installed ]; then
        for each in "$name" $(sed 's/([^)]*)//g; s/,/ /g' <<<"$provided"); do
            have[$each]=1
        done
    fi
done < <(dpkg-query -W -f='${db:Status-Status} ${Package} ${Provides}\n')
missing=()
while read -r package; do
    if [ -z "${have[$package]:-}" ]; then
        missing+=("$package")
    fi
done < <(sed 's/#.*//' ci/packages.txt | awk 'NF { print $1 }')

if [ "${#missing[@]}" -eq 0 ]; then
    exit 0
fi
echo "installing: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
    as_root=(sudo)
fi
"${as_root[@]}" apt-get update -qq
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}"
