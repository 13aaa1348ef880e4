photographs-targets = Zielmarken der Aufnahme { $photograph }:

photographs-not_usable = { $n } { $n ->
        [one] Datei wird
        *[other] Dateien werden
    } nicht verwendet: { $names }.
    .why = Im Ergebnis fehlt, was nur sie zeigen.
    .do = Die Gründe stehen im Bericht und erscheinen mit { OPTION("verbose", "True") }.
