workbook-no_table = No table with rows is available for the workbook.

# $most = 1048575
workbook-too_many_rows = The table has more than { $most } rows, the limit of a spreadsheet.
    .do = Use the CSV file.
