costs-measure_and_shipped = { OPTION("measure", "True") } und { OPTION("shipped", "True", flag: "no-measure") } schließen sich aus.
    .do = Eines davon angeben.

costs-no_photographs = Die Zahl der Aufnahmen ist unbekannt.
    .do = Den Ordner der Aufnahmen oder { OPTION("images", "N") } angeben.

costs-photographs_and_number = Aufnahmen und { OPTION("images", $n) } schließen sich aus.
    .do = Eines davon angeben.

costs-overlap_too_small = { OPTION("flight_overlap", $along, $across) }: Eine Stelle ist in { $n } Aufnahmen; nötig sind { $needed }.
    .do = Mindestens 0,6 längs und 0,3 quer angeben.

costs-exceeded = { $what }: { $needed } nötig, { $given } vorhanden.

costs-unread = { $n } unlesbare { $n ->
        [one] Datei zählt
        *[other] Dateien zählen
    } nicht mit: { $names }.
