# $name = "client"
report_page-division = { $name ->
        [client] For the client
        [specialist] For the specialist
        *[appendix] Appendix
    }

# $name = "Control"
# $n = 40
report_page-rows_of = { $name }, { $n } { $n ->
        [one] row
        *[other] rows
    }

# $name = "Residuals"
# $n = 4
report_page-figures_of = { $name }, { $n } { $n ->
        [one] figure
        *[other] figures
    }

report_page-contents = Contents

report_page-page = page

report_page-of_pages = of

# $columns = ["point", "X"]
report_page-table = Table: { LIST($columns, most: 40) }

report_page-not_printed = Further tables and figures are in report.html and in the tables of the result folder.
    .do = { OPTION("appendix") } short prints them.
