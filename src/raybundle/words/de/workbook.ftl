workbook-no_table = Für die Arbeitsmappe gibt es keine Tabelle mit Zeilen.

workbook-too_many_rows = Die Tabelle hat mehr als { $most } Zeilen, die Grenze eines Tabellenblatts.
    .do = Die CSV-Datei verwenden.
