workbook-written = Arbeitsmappe: { $n } { $n ->
        [one] Tabellenblatt
        *[other] Tabellenblätter
    } ({ $names }).
