# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of numbers: aligned for the terminal, in Markdown, and with all digits as CSV."""

import csv
import math


def number(value, form):
    return "-" if math.isnan(value) else form.format(value)  # volumes of open surfaces


def print_table(head, rows):
    columns = list(zip(head, *rows))
    widths = [max(len(text) for text in column) for column in columns]
    for row in [head] + rows:
        print("  ".join([row[0].ljust(widths[0])] +
                        [text.rjust(width) for text, width in zip(row[1:], widths[1:])]))


def markdown_table(head, rows, words=2):
    """The first columns are words, the others numbers."""
    # A reason for a failure may be long; it does not make its column so.
    widths = [max(len(text) for text in column if not text.startswith("failed"))
              for column in zip(head, *rows)]
    rule = ["-" * width if i < words else "-" * (width - 1) + ":" for i, width in enumerate(widths)]
    return "\n".join(
        "| " + " | ".join(text.ljust(width) if i < words else text.rjust(width)
                          for i, (text, width) in enumerate(zip(row, widths))) + " |"
        for row in [head, rule] + rows)


def write_csv(file, rows):
    """A column for every name in one of the rows, which are dictionaries; what a row does not have
    is empty."""
    names = list(dict.fromkeys(name for row in rows for name in row))
    with open(file, "w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, names, restval="")
        writer.writeheader()
        writer.writerows(rows)
