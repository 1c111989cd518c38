"""Reads the tables of one answer in three formats, each with a reader of its own, and compares them cell by cell.

compare.py FOLDER QUESTION [BOOK.xlsx] [PARQUET-FOLDER]: the tables in CSV lie in FOLDER. Prints how many cells were compared.
"""

import csv
import pathlib
import sys

FORMULA = ("=", "+", "-", "@")


def tables(folder, question, ending):
    """The file of each table by its name in the answer: the main one is ''."""
    found = {}
    for path in sorted(pathlib.Path(folder).glob(f"{question}*.{ending}")):
        found[path.stem.removeprefix(question).removeprefix("-")] = path
    assert found, (folder, ending)
    return found


def in_csv(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return rows[0], rows[1:]


def agree(field, value, place):
    """Whether a field of CSV is the value that another reader found."""
    if value is None or value == "":
        assert field == "", (place, field, value)
    elif isinstance(value, bool):
        assert field == str(value).lower(), (place, field, value)
    elif isinstance(value, (int, float)):
        assert float(field) == float(value), (place, field, value)
    else:
        inert = "'" + value if value.startswith(FORMULA) and not is_exact(value) else value
        assert field == inert, (place, field, value)


def is_exact(text):
    """Exact numbers that are negative stand as they are: -1/3."""
    return text.lstrip("-").replace("/", "").replace(".", "").isdigit()


def book(path, folder, question):
    import openpyxl

    workbook = openpyxl.load_workbook(path)
    assert workbook.properties.created.year == 2000, workbook.properties.created
    known = tables(folder, question, "csv")
    sheets = [name for name in workbook.sheetnames if name != "columns"]
    assert len(sheets) == len(known), (sheets, list(known))
    cells = 0
    told = {(row[0], row[1]): row for row in workbook["columns"].iter_rows(min_row=2, values_only=True)}
    for name in sheets:
        header, rows = in_csv(known.get(name, known[""]))
        sheet = list(workbook[name].iter_rows())
        assert [cell.value for cell in sheet[0]] == header, name
        assert all((name, column) in told and told[name, column][4] for column in header), name
        assert len(sheet) - 1 == len(rows), name
        for number, (fields, found) in enumerate(zip(rows, sheet[1:])):
            for column, field, cell in zip(header, fields, found):
                assert cell.data_type != "f", (name, number, column, cell.value)
                agree(field, cell.value, (name, number, column))
                cells += 1
    return cells


def parquet(other, folder, question):
    import duckdb

    cells = 0
    known, found = tables(folder, question, "csv"), tables(other, question, "parquet")
    assert known.keys() == found.keys()
    for name, path in found.items():
        header, rows = in_csv(known[name])
        read = duckdb.sql(f"SELECT * FROM read_parquet('{path}')")
        assert read.columns == header, name
        kinds = {str(kind) for kind in read.types}
        assert kinds <= {"VARCHAR", "BIGINT", "DOUBLE", "BOOLEAN"}, kinds
        for column, kind in zip(header, read.types):
            if column.endswith("vanishes") or column in ("complete", "everywhere", "exists"):
                assert str(kind) == "BOOLEAN", (name, column, kind)
            if "exact" in column:
                assert str(kind) == "VARCHAR", (name, column, kind)
        values = read.fetchall()
        assert len(values) == len(rows), name
        for number, (fields, row) in enumerate(zip(rows, values)):
            for column, field, value in zip(header, fields, row):
                agree(field, value, (name, number, column))
                cells += 1
        told = duckdb.sql(f"SELECT key, value FROM parquet_kv_metadata('{path}')").fetchall()
        told = {key.decode(): value.decode() for key, value in told}
        assert all(told[f"meaning:{column}"] for column in header) and told["table"], name
    return cells


folder, question, of_book, of_parquet = sys.argv[1:]
print(book(of_book, folder, question) if of_book != "-" else parquet(of_parquet, folder, question))
