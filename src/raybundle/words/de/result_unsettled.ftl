result_unsettled = Das verwendete Ergebnis { $name } hat { $n } { $n ->
        [one] Mangel
       *[other] Mängel
     }.
    .why = Seine Fehler sind in dieser Messung enthalten.
    .do = Zuerst die Mängel in dessen Bericht beheben.
