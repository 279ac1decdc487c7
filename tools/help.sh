#!/usr/bin/env bash
# The targets of the Makefile, each with what the line above it says.
awk '/^## /{told = substr($0, 4)}
     /^[a-z-]+:/{sub(":.*", ""); printf "make %-12s %s\n", $0, told; told = ""}' \
    "$(dirname "${BASH_SOURCE[0]}")/../Makefile"
