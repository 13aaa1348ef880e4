mesh-no_triangles = Die Vermaschung { $name } hat keine Dreiecke.
    .do = Aus der Punktwolke eine Vermaschung erzeugen oder eine andere Datei angeben.

mesh-vertex_not_finite = Vermaschung { $name }: Eckpunkt { $vertex } hat eine Koordinate, die keine endliche Zahl ist.
    .do = Die Koordinate berichtigen oder den Eckpunkt mit seinen Dreiecken löschen.

mesh-unknown_vertex = Vermaschung { $name }: Ein Dreieck verweist auf Eckpunkt { $vertex }, es gibt aber nur { $n }.
    .do = Das Dreieck berichtigen oder die fehlenden Eckpunkte ergänzen.

mesh-no_area = Vermaschung { $name }: Die Dreiecke haben keine Fläche.
    .do = Einheit und Eckpunkte der Vermaschung prüfen.

mesh-nothing_to_measure = Vermaschung { $name }: Alle Dreiecke sind von der Messung ausgenommen.
    .do = Mindestens einen Teil wählen, der zu messen ist.

mesh-not_readable = Die Datei ist nicht als Vermaschung lesbar ({ $detail }).
    .do = Eine Vermaschung als STL, PLY oder OBJ angeben.

mesh-too_many_triangles = Die Vermaschung hat { $n } Dreiecke; höchstens { $most } werden gelesen.
    .do = Sie zuvor vereinfachen.

mesh-too_small = Die Vermaschung ist { $extent_mm } mm groß, wenn ihre Einheit { $unit_m } m ist; nötig sind { $least_mm } mm.
    .do = Ihre Einheit angeben; { OPTION("unit", 0.001) } steht für Millimeter.
