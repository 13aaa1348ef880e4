workbook-no_table = Für die Arbeitsmappe gibt es keine Tabelle mit Zeilen.
    .do = Einen Ergebnisordner mit Tabellen angeben oder andere Tabellen wählen: { OPTION("tables", "NAME") }.

workbook-too_many_rows = Die Tabelle hat mehr als { $most } Zeilen, die Grenze eines Tabellenblatts.
    .do = Die CSV-Datei verwenden.

workbook-unknown_table = Es gibt keine Tabelle { $table }.
    .do = { $n ->
        [0] Ein Ergebnis oder Projekt mit Tabellen angeben
       *[other] Eine von { LIST($known, most: 40) } verwenden
     }.
