workbook-no_table = Für die Arbeitsmappe gibt es keine Tabelle mit Zeilen.

workbook-too_many_rows = Die Tabelle hat mehr als { $most } Zeilen, die Grenze eines Tabellenblatts.
    .do = Die CSV-Datei verwenden.

workbook-unknown_table = Es gibt keine Tabelle { $table }.
    .do = { $n ->
        [0] Ein Ergebnis oder Projekt mit Tabellen angeben
       *[other] Eine von { LIST($known, most: 40) } verwenden
     }.
