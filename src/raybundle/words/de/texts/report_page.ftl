report_page-division = { $name ->
        [client] Für den Auftraggeber
        [specialist] Für den Fachmann
        *[appendix] Anhang
    }

report_page-rows_of = { $name }, { $n } { $n ->
        [one] Zeile
        *[other] Zeilen
    }

report_page-figures_of = { $name }, { $n } { $n ->
        [one] Abbildung
        *[other] Abbildungen
    }

report_page-contents = Inhalt

report_page-page = Seite

report_page-of_pages = von

report_page-table = Tabelle: { LIST($columns, most: 40) }

report_page-not_printed = Weitere Tabellen und Abbildungen stehen in report.html und in den Tabellen des Ergebnisordners.
    .do = { OPTION("appendix") } short druckt sie.
