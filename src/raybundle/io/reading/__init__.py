"""The one place where foreign bytes become numbers, texts, trees and rows: bounded, finite, with file and place.

    words    numbers and whole numbers in ASCII, bounded; how a foreign text is quoted in a message
    files    bytes and UTF-8 text of a file, bounded; lines
    trees    JSON and TOML: duplicate keys, nesting, non-finite numbers
    xml      XML without document types and entities
    rows     the cells of CSV lines
    binary   records, every count held against what is left of the file
    ledger   elements that a reader passes over, counted for one remark

A reader of a format takes its values from here; a test fails where one calls `json.loads`, `tomllib`, `csv` or
`float` on a text itself.
"""
