export-no_csv_name = Der Name einer Punkttabelle endet auf .csv.
    .do = Einen solchen Namen wählen.

export-no_points = Kein Punkt ist von Hand gemessen; es gibt nichts zu exportieren.
    .do = Zuerst einen Punkt markieren.

export-name_not_possible = { $kind ->
        [image] Bild
       *[point] Punkt
     } { $name } lässt sich nicht in gcp_list.txt schreiben.
    .do = Eine CSV-Tabelle exportieren.

export-no_control = Kein Pass- oder Kontrollpunkt mit X, Y und Z ist markiert; es gibt nichts zu exportieren.
    .do = Zuerst einen solchen Punkt markieren.
