fit-unknown_points = Für die Einpassung gewählte Punkte sind nicht zugleich gemessen und Sollpunkte: { $names }.
    .do = Die Namen korrigieren oder diese Punkte weglassen.

fit-too_few_selected = Nur { $n } Punkte sind für die Einpassung gewählt ({ $names }).
    .do = Mindestens { $least } Punkte wählen.

fit-too_few_common = { $n } von { $nominal } Sollpunkten sind unter demselben Namen gemessen; nötig sind { $least }.
    .do = In beiden dieselben Namen verwenden; nicht gemessen: { $missing }.

fit-points_in_line = Die { $n } { $kind ->
        [nominal] Sollpunkte
       *[measured] gemessenen Punkte
     } der Einpassung liegen auf einer Geraden oder sind ein Punkt.
    .why = Die Drehung um diese Gerade ist nicht bestimmt ({ $names }).
    .do = Drei Punkte wählen, die nicht auf einer Geraden liegen.

fit-covariance_singular = Die gemeinsame Kovarianzmatrix der eingepassten Punkte ist singulär.
    .why = Einige dieser Punkte sind fehlerfrei festgehalten.
    .do = Mit gleichen Gewichten einpassen.

fit-other_unit = Sollpunkte liegen { NUM($ratio, digits: 4) }-mal so weit auseinander wie die gemessenen.
    .why = Die Einheit der Sollpunkte oder der Maßstabsstrecken ist falsch{ $likely ->
        [yes] { " " }(vermutlich { $units })
       *[no] { "" }
     }.
    .do = Maßstabsstrecken in Metern angeben; { OPTION("unit", 0.001) } liest Dateien in Millimetern.
