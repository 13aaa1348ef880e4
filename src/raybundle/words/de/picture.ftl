picture-no_scale = Der Maßstab des Bildes ist unbekannt: { $plane } und { $world } fehlen daneben.
    .do = Die Aufnahme zuerst entzerren oder eine dieser Dateien ergänzen.

picture-other_system = Das Bild ist in { $picture }, der Block in { $block ->
        [none] eigenen Achsen
        *[other] { $block }
    }.
    .do = Den Block transformieren: { OPTION("crs", "EPSG:25832") }.

picture-earlier_adjustment = Das Bild gehört zu einer früheren Ausgleichung: Die Aufnahme { $photograph } hat sich um { $offset } { $unit } verschoben.
    .why = Punkte dieser Ausgleichung passen nicht zum Bild (Pixel { $pixel } { $unit }).
    .do = Neu entzerren.

picture-suffix = Der Name des Bildes endet nicht auf { LIST($known, most: 8) }.
    .do = Einen Namen mit einer dieser Endungen angeben.

picture-not_geotiff = Das Bild lässt sich nicht als GeoTIFF schreiben ({ $detail }).
    .do = Ein Raster angeben, das GDAL liest, oder NAME_RPC.TXT, NAME.RPB oder NAME.geom schreiben.

picture-free_scale = Der Maßstab dieses Bildes ist nicht bestimmt; eine Zeichnung braucht ihn.
    .do = Der Ausgleichung eine Maßstabsstrecke, zwei Passpunkte oder beobachtete Positionen geben und neu entzerren.

picture-world_file_only = Eine World-Datei legt die Lage der Ebene im Raum nicht fest.
    .why = Punkte eines Blocks lassen sich auf dieses Bild nicht zeichnen.
    .do = { $missing } ergänzen, das rectify schreibt.

picture-no_plane_points = Eine einzelne Aufnahme braucht Punkte der Ebene.
    .do = { OPTION("control", "FILE") } angeben.

picture-setting_of_other_source = { OPTION($setting) } gehört zu { $result ->
        [yes] einem Ergebnis
       *[no] einer einzelnen Aufnahme
     }.
    .do = Es weglassen{ $result ->
        [yes] ; eine Aufnahme hat { OPTION("control") }
       *[no] ; ein Ergebnis hat Kalibrierung und Orientierung schon
     }.

picture-not_readable = Das Bild ist nicht lesbar ({ $detail }).
    .do = Das Bild neu schreiben.

picture-area_empty = Ein Gebiet von { $width } x { $height } mit einem Pixel von { $pixel } ergibt kein Bild.
    .do = Gebiet und Pixel größer als 0 angeben.

picture-pixel_too_large = Ein Pixel von { $pixel } ist größer als das Gebiet von { NUM($width, digits: 4) } x { NUM($height, digits: 4) }.
    .do = { OPTION($setting) } kleiner wählen.

picture-too_large = Das Bild hätte { $width_px } x { $height_px } px (Grenze { $limit_px } px).
    .do = { OPTION($setting, $needed) } oder eine kleinere { OPTION("extent") } angeben.

picture-area_far_away = { OPTION($setting) } liegt weit entfernt von den Punkten des Ergebnisses.
    .why = Das Gebiet umfasst Ost { NUM($west, digits: 10) } bis { NUM($east, digits: 10) }, Nord { NUM($south, digits: 10) } bis { NUM($north, digits: 10) }; die Punkte liegen in { NUM($block_west, decimals: 0) } bis { NUM($block_east, decimals: 0) }, { NUM($block_south, decimals: 0) } bis { NUM($block_north, decimals: 0) }.
    .do = Landeskoordinaten angeben ({ $system }).

picture-no_photograph = Keine Aufnahme zeigt das Gebiet, oder keine wurde gelesen.
    .do = Den Ordner der Aufnahmen ({ OPTION("photos") }) oder eine andere { OPTION("extent") } angeben.

picture-control_on_line = Die Passpunkte liegen auf einer Geraden (Grenze { PERCENT($limit) } % ihrer Länge).
    .why = { $alone ->
        [yes] Nur { $exception } liegt neben der Geraden; neben ihr ist nichts geprüft
       *[no] Das Bild neben der Geraden ist nicht bestimmt
    }.
    .do = Punkte rings um das Gebiet des Bildes messen.

picture-area_not_shown = Die Aufnahme zeigt das Gebiet nicht.
    .do = Eine andere { OPTION("extent") } angeben.

picture-hidden_places = Von Steilhängen oder Gebäuden verdeckte Stellen werden nicht erkannt.
    .why = Eine solche Stelle kann zweimal im Bild erscheinen.

picture-few_points_in_plane = { PERCENT($share) } % der Punkte liegen in dieser Ebene.
    .why = Das meiste im Bild ist versetzt.
    .do = Wählen Sie die Wand mit { OPTION("plane") }.

picture-points_displaced = Punkte sind im Bild um { NUM($off, digits: 2) } { $unit } versetzt ({ NUM($pixels, digits: 2) } px, mittlerer Fehler), da sie nicht in der Ebene liegen.
    .do = Messen Sie in den Aufnahmen, was genauer sein muss.

picture-residuals = Verbesserungen von { NUM($x, digits: 3) }, { NUM($y, digits: 3) } px (quadratisches Mittel) sind { NUM($sigma0, digits: 3) }-mal so groß wie erwartet; größte: { $worst }.
    .why = Eine Marke oder Koordinate ist falsch, Namen sind vertauscht, ein Punkt liegt nicht in der Ebene, oder das Objektiv verzeichnet.
    .do = Prüfen Sie { $worst }, oder nehmen Sie eine kalibrierte Kamera.

picture-no_redundancy = Das Bild beruht auf der Mindestzahl von Punkten: Fehler fallen nicht auf.
    .do = Nehmen Sie einen Punkt hinzu.

picture-mirrored = Das Bild ist gespiegelt.
    .why = Die Passpunkte laufen in der Aufnahme andersherum als in der Ebene.
    .do = Prüfen Sie links und rechts, die Vorzeichen der Achsen und die Seite des Films.

picture-relief = Das Relief versetzt { PERCENT($share) } % der Punkte der Wand um mehr als { NUM($limit, digits: 2) } { $unit } (Grenze { PERCENT($limit_share) } %).
    .why = Die Wand reicht von { NUM($back, digits: 2) } bis { NUM($front, digits: 2) } { $unit } um die Ebene; ein Bild einer Ebene verschiebt oder verdoppelt sie um { NUM($displacement, digits: 2) } { $unit }.
    .do = Mit raybundle facade zeichnen oder die Versetzung hinnehmen: { OPTION("relief", "LENGTH") }.
