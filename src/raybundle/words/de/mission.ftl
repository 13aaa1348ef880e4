mission-no_crs = Die Mission hat lokale Koordinaten; ein Fluggerät braucht Positionen auf der Erde.
    .do = Sie in einem Koordinatensystem planen: { OPTION("crs", "EPSG:CODE") }.

mission-vehicle_unknown = Das Fluggerät { $vehicle } ist unbekannt.
    .do = Eines von { LIST($known, most: 20) } verwenden oder { OPTION("speed", "M_S") }, { OPTION("climb", "M_S") }, { OPTION("battery", "MINUTES") } angeben.

mission-camera_missing = Die Kamera fehlt.
    .do = Ein Fluggerät ({ LIST($known, most: 20) }) oder { OPTION("camera") } als Aufnahme, Kalibrierung oder WIDTHxHEIGHT,C in Pixeln angeben.

mission-camera_unknown = Die Kamera { $camera } ist weder eine Datei noch eine bekannte Kamera.
    .do = Eine von { LIST($known, most: 20) } verwenden oder WIDTHxHEIGHT,C in Pixeln, etwa 5472x3648,3650.

mission-no_folder = Die Datei hat keinen Ordner mit Wegpunkten; sie wurde nicht als Mission geschrieben.
    .do = Prüfen, ob es die richtige Datei ist.

mission-no_way_point = Die Mission hat keinen Wegpunkt.
    .do = Prüfen, ob es die richtige Datei ist.

mission-no_height = Die Höhe über dem Startpunkt fehlt; die Datei wurde nicht als Mission geschrieben.
    .do = Prüfen, ob es die richtige Datei ist.

mission-height_reference = Die Höhen beziehen sich auf { $reference }; unterstützt werden nur Höhen über dem Startpunkt ({ $needed }).
    .do = Die Mission mit diesen Höhen speichern.

mission-no_table = Die Datei hat kein [way_points]; sie ist kein Flugplan.
    .do = Prüfen, ob es die richtige Datei ist.

mission-columns = Die Spalten der Wegpunkte weichen von den nötigen ab.
    .do = { LIST($needed, most: 12) } angeben.

mission-line_unknown = Die Fluglinie { $line_number } gibt es nicht; definiert sind { $n }, ab 0 gezählt.
    .do = Die Nummer berichtigen.
