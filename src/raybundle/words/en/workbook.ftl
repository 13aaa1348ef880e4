workbook-no_table = No table with rows is available for the workbook.
    .do = Give a result folder with tables, or choose other tables: { OPTION("tables", "NAME") }.

# $most = 1048575
workbook-too_many_rows = The table has more than { $most } rows, the limit of a spreadsheet.
    .do = Use the CSV file.

# $table = "lengths"
# $n = 2
# $known = ["points", "images"]
workbook-unknown_table = There is no table { $table }.
    .do = { $n ->
        [0] Give a result or a project with tables
       *[other] Use one of { LIST($known, most: 40) }
     }.
