depth_map-density = Die Dichte einer Tiefenkarte ist { $density }; möglich sind 1, 2 und 4.
    .do = 1 für eine Tiefe in jedem Pixel angeben, 2 in jedem zweiten, 4 in jedem vierten.

depth_map-no_source = Bild { $image }: Keine andere Aufnahme eignet sich zur dichten Zuordnung mit ihm.
    .do = Aufnahmen von anderen Standpunkten machen, die sich mit diesem Bild überdecken.

depth_map-outside_region = Bild { $image } zeigt das Gebiet nicht.
    .do = Es weglassen oder ein anderes Gebiet wählen.

depth_map-too_few_points = Bild { $image } hat { $n } Verknüpfungspunkte; der Tiefenbereich braucht { $least }.
    .do = Es weglassen oder Aufnahmen mit mehr Überdeckung machen.

depth_map-source_count = Das Referenzbild hat { $n } Quellbilder; 1 bis { $most } sind möglich.
    .do = Die besten Quellbilder wählen.

depth_map-array_shape = Das Feld { $array } hat die Dimension ({ $shape }).
    .do = Ein Feld der Dimension ({ $needed }) angeben.

depth_map-grid_outside = Das Pixelraster reicht bis { $x_px }, { $y_px }; das Bild hat { $width_px } x { $height_px } px.
    .do = Ein Raster innerhalb des Bildes angeben.

depth_map-memory = Tiefen von { $width_px } x { $height_px } px brauchen mehr als { NUM($memory_gb, digits: 2) } GB Speicher.
    .do = Mehr Speicher zulassen oder die Aufnahmen verkleinern.

depth_map-single_photograph = Eine Oberfläche braucht mindestens zwei Aufnahmen desselben Teils des Objekts.
    .do = Überdeckende Aufnahmen ergänzen.

depth_map-depth_range = Tiefenparameter von { $low } bis { $high } sind kein Tiefenbereich.
    .do = Zwei ansteigende Werte über 0 angeben.

depth_map-projection_table = Bild { $image }: Die Tabelle seiner Abbildung hat Fehler von { $error_px } px (Grenze { $limit_px } px).
    .do = Es als Quellbild weglassen.
