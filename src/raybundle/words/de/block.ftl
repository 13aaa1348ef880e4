block-no_oriented_image = Block { $block } hat kein orientiertes Bild.
    .do = Den Block zuerst orientieren oder ausgleichen.

block-nothing_to_write = Block { $block } hat weder Punkte noch Aufnahmen; es gibt nichts zu schreiben.
    .do = Einen Block mit Punkten oder Aufnahmen angeben.

block-is_a_file = Das ist eine Datei und nicht der Ordner eines Blocks.
    .do = Einen Ordner mit block.toml, images.csv und observations.csv angeben.

block-result_folder = Das ist der Ordner eines Ergebnisses und nicht der eines Blocks.
    .do = Dessen Block { $block } angeben.

block-no_block_toml = Der Ordner hat keine block.toml; er ist kein Block.
    .do = Einen Ordner mit block.toml, images.csv und observations.csv angeben.

block-file_missing = Die Datei fehlt; ein Block braucht sie.
    .do = Die Datei ergänzen oder einen anderen Ordner angeben.

block-file_name = Unter diesem Namen wird die Datei nicht gelesen.
    .do = Die Datei in { $meant } umbenennen oder anderswohin verschieben.

block-observations_not_parquet = Die Tabelle wird auf einmal gelesen; ein Block größer als der Arbeitsspeicher braucht Parquet.
    .do = Den Block mit tables="parquet" schreiben (write_block).

block-no_camera = Der Block hat keine Kamera.
    .do = Für jede Kamera eine Tabelle [cameras.ID] ergänzen.

block-no_scene = Block { $block } hat keine Satellitenszene; RPC werden nur für Szenen geschrieben.
    .do = Ein anderes Format wählen oder einen Block mit Satellitenszenen angeben.

block-not_numbers = Block { $block }: { $name } enthält { $type }; nötig sind Zahlen.
    .do = { $name } in ein Feld von Zahlen umwandeln, mit nan für unbekannte Werte.

block-not_whole_numbers = Block { $block }: { $name } enthält { $type }; Positionen müssen ganze Zahlen sein.
    .do = { $name } in ein Feld ganzer Zahlen umwandeln.

block-position_out_of_range = Block { $block }: { $name }[{ $row }] ist { $position }; Positionen gehen von 0 bis { $last }.
    .do = Diese Position korrigieren oder die fehlende Zeile in der Zieltabelle ergänzen.

block-shape = Block { $block }: { $name } muss ein Feld der Dimension ({ $shape }) sein.
    .why = Der Typ ist { $type }, die Dimension ({ $found }).
    .do = Ein Feld dieser Dimension angeben, mit einer Zeile je Zeile der Tabelle.

block-number_too_large = { $kind ->
        [image] Bild { $image }
        [point] Punkt { $point }
       *[observation] Bild { $image }, Punkt { $point }
     }: { $number } ist keine Zahl bis zum Betrag { $limit }.
    .do = Die Einheit prüfen oder den Wert weglassen.

block-single_image = Das Bild { $image } allein bestimmt die Objektpunkte { $points } nicht.
    .why = Ohne genug Passpunkte sind auch seine äußere Orientierung und die Parameter der Kamera { $camera } ({ LIST($parameters, most: 20) }) unbestimmt.
    .do = Bilder von anderen Standpunkten ergänzen oder Passpunkte für einen Rückwärtsschnitt angeben.

block-parts_without_datum = Der Block hat { $parts } Teile ohne gemeinsame Verknüpfungspunkte; { $n } { $n ->
        [one] hat
       *[other] haben
     } kein Datum.
    .do = Punkte messen, die die Teile verbinden, jedem Teil Passpunkte geben oder die Teile einzeln ausgleichen.

block-open_part = Nicht bestimmt für die Bilder { LIST($images, most: 10) }: { datum-part }.

block-scale_free = Der Maßstab des Blocks ist nicht bestimmt: Keine Länge legt ihn fest.
    .do = Der Ausgleichung eine Maßstabsstrecke, zwei Passpunkte oder beobachtete Positionen geben{ $optional ->
        [yes] { " " }oder { OPTION("free_scale", "True") } für ein Bild ohne Einheit verwenden
       *[no] { "" }
     }.

block-not_adjusted = Bilder haben keine Orientierung oder Punkte keine Koordinaten: Der Block ist nicht ausgeglichen.
    .do = Den Block ausgleichen und das Ergebnis angeben.

block-heights_defined = Block { $block } legt den Bezug seiner Höhen bereits fest.
    .do = { OPTION("undulation") } weglassen.

block-place_defined = Block { $block } legt die Lage seines Systems auf der Erde bereits fest.
    .do = { OPTION("crs") } weglassen oder auch { OPTION("frame_origin") } angeben.

block-origin_missing = Block { $block } hat Längen in { $unit }; seine Koordinaten sind nicht die von { $system }.
    .do = { OPTION("frame_origin") } angeben.

block-folder_needs_observations = Block { $block } hat keine Bildbeobachtungen; ein Blockordner benötigt sie.
    .do = In ein anderes Format umwandeln.
