report_page-division = { $name ->
        [client] Pour le client
        [specialist] Pour le spécialiste
        *[appendix] Annexe
    }

report_page-contents = Sommaire

report_page-page = page

report_page-of_pages = sur

report_page-not_printed = D'autres tableaux et figures se trouvent dans report.html et dans les tableaux du dossier de résultats.
