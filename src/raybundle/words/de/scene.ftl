scene-orientation_given = Bild { $image } ist eine Satellitenszene; ihre Orientierung steht in der Datei der Szene.
    .do = Diese Zellen leer lassen.

scene-second_image = Kamera { $camera } ist eine Satellitenszene und hat schon ein Bild.
    .do = Für jede Szene eine eigene Kamera verwenden.

scene-size_unknown = Die Datei der Szene enthält die Bildgröße nicht.
    .do = width_px und height_px angeben.

scene-no_rpc = { $scene } hat keine RPC.
    .do = model = "linescan" angeben, bei Radar "range_doppler".

scene-no_rigorous_model = { $scene } hat kein unterstütztes strenges Modell.
    .do = model = "rpc" angeben.

scene-file_gone = Kamera { $camera }: Die Datei ihrer Szene ({ $scene }) fehlt; der Block kann nicht geschrieben werden.
    .do = Die Datei dort wiederherstellen, wo sie gelesen wurde.

scene-companion_gone = Kamera { $camera }: { $scene } verweist auf diese Datei, die fehlt.
    .do = Die Datei wiederherstellen.

scene-length_unit = Satellitenszenen brauchen length_unit = "m", nicht "{ $unit }".
    .do = In block.toml length_unit = "m" setzen und alle Längen und Koordinaten in Metern angeben.

scene-file_elsewhere = { $name } ist nicht der Name einer Datei im Ordner dieser Datei.
    .do = Die Datei in diesen Ordner kopieren und nur ihren Namen angeben.

scene-keys_exclusive = Dieser Schlüssel und { $other } schließen einander aus.
    .do = Einen der beiden löschen.

scene-crs_superfluous = Die Tabelle hat geographische Länge und Breite, die kein Koordinatensystem brauchen.
    .do = Diesen Schlüssel löschen.

scene-crs_missing = Das Koordinatensystem der Positionen X, Y, Z fehlt.
    .do = Es in die Datei schreiben, zum Beispiel crs = "EPSG:25832".

scene-format_unknown = Das Format der Satellitenszene ist unbekannt.
    .why = Bekannte Formate: { LIST($formats, most: 30) }.
    .do = Die Metadaten oder das RPC der Szene angeben.

scene-pixel_count = { NUM($value, digits: 6) } ist keine mögliche Anzahl von Pixeln.
    .do = Eine ganze Zahl über 0 angeben.

scene-position_count = Positionen der Bahn: { $n }; mindestens { $least } sind nötig.
    .do = Eine vollständige Datei beschaffen.

scene-attitude_count = Lagewinkel: { $n }; mindestens { $least } sind nötig.
    .do = Eine vollständige Datei beschaffen.

scene-not_an_orbit = Eine Position liegt { NUM($distance_m, digits: 6) } m vom Erdmittelpunkt (Grenzen { $least_m } bis { $most_m } m).
    .do = Die Positionen in Metern angeben.

scene-no_look_angles = Die Blickrichtungen ({ $element }) fehlen.
    .why = Blickrichtungen in anderer Form werden nicht unterstützt.
    .do = Eine vollständige Datei beschaffen oder das RPC des Produkts verwenden.

scene-no_picture = Die Szene hat kein Bild.
    .do = Das Raster der Szene angeben.

scene-look_angle_count = Blickrichtungen: { $n }; das Bild hat { $columns } Spalten.
    .do = Eine vollständige Datei beschaffen.

scene-detector_order = Detektor { NUM($number, digits: 6) } steht außer der Reihe: Die Tabelle hat eine Lücke.
    .do = Eine vollständige Datei beschaffen.

scene-same_time = Zwei Positionen haben dieselbe Zeit.
    .do = Eine davon löschen.

scene-models_contradict = { $scene }: Strenges Modell und RPC unterscheiden sich um { $meets ->
     [yes] { NUM($rms_px, digits: 4) } px (quadratisches Mittel)
     *[no] mehr als das Bild
    }, Grenze { $limit_px } px.
    .why = Die Grenze ist { $stated ->
     [yes] der angegebene Fehler des RPC
     *[no] Aberration und Refraktion zusammen
    }; eines der beiden Modelle ist falsch.
    .do = Die Datei neu beschaffen oder das RPC allein verwenden (Modell rpc).

scene-rpc_preferred = Nur das RPC wird verwendet: Das strenge Modell weicht um { $meets ->
     [yes] { NUM($rms_px, digits: 4) } px (quadratisches Mittel)
     *[no] mehr als das Bild
    } ab, Grenze { $limit_px } px.
    .why = Die Grenze ist { $stated ->
     [yes] der angegebene Fehler des RPC
     *[no] Aberration und Refraktion zusammen
    }.
    .do = Die Datei neu beschaffen, wenn das strenge Modell gebraucht wird.

scene-no_geometry = Die Datei enthält weder ein RPC noch ein verwendbares strenges Modell.
    .do = Eine vollständige Datei der Szene beschaffen.

scene-rpc_range_adapted = Das RPC wurde für den Bereich dieses Bildes umgeschrieben, das ein Teil einer Szene ist.
    .why = Seine Verschiebungen lagen außerhalb des Bildes; die Polynome sind dieselben.

scene-one_band = Die Szene hat { $n } Kanäle; die Blickrichtungen des Kanals { $band } werden verwendet.

scene-model_missing = Die Szene hat { $model ->
        [rpc] keine RPC
       *[rigorous] kein strenges Modell
     }.
    .do = { $choice ->
        [yes] { OPTION("model", "auto") } verwenden
       *[no] Eine Szene mit strengem Modell angeben, aus dem sich RPC berechnen lassen
     }.

scene-none_here = Hier ist keine Szene: kein Bild mit RPC und keine Datei mit RPC.
    .do = Den Pfad prüfen.

scene-none_corrected = Keine von { $n } { $n ->
        [one] Szene
       *[other] Szenen
     } lässt sich korrigieren:
    .do = Szenen oder Passpunkte wie unten beschrieben korrigieren.

scene-not_corrected = Szene { $scene } ist nicht korrigiert:

scene-name_twice = Zwei Szenen heißen { $name }.
    .do = Eine umbenennen.

scene-rpc_missing = Die Szene hat keine RPC.
    .do = Die RPC berechnen: raybundle rpc fit.

scene-height_range_missing = Der Höhenbereich ist unbekannt: Die Szene hat keine RPC.
    .do = { OPTION("heights", "LOW", "HIGH") } angeben.

scene-original_rpc = Die Datei der ursprünglichen RPC existiert schon; sie wird nie überschrieben.
    .do = Die Datei verschieben oder eine neue Datei schreiben: { OPTION("out", "FILE") }.

scene-no_geotiff = Dies ist kein GeoTIFF; RPC lassen sich nur in ein GeoTIFF schreiben.
    .do = Eine neue Datei schreiben: { OPTION("out", "FILE") }.

scene-rpc_of_no_picture = { OPTION("rpc") } gehört zu einem Bild; dies ist keines.
    .do = Es weglassen.

scene-object_without_rpc = Weder das Objekt vom Typ { $kind } noch seine Datei hat RPC.
    .do = { OPTION("rpc", "FILE") } angeben.

scene-rpc_not_in_picture = In diesem Bild (Tag 50844) und daneben sind keine RPC.
    .why = Dateien daneben sind NAME_RPC.TXT, NAME.RPB, NAME.rpc, NAME.XML und NAME.geom.
    .do = Die Datei mit den RPC angeben: { OPTION("rpc", "FILE") }.

scene-outside_map = Die Szene zeigt keinen Teil des Kartengebiets.
    .do = { OPTION("extent") } anders wählen.

scene-map_too_large = Die Karte hat { $width_px } x { $height_px } px mit { $bands } Kanälen, zu viele für den Speicher.
    .do = Die Karte in eine Datei schreiben: { OPTION("out", "FILE.tif") }.

scene-no_data_type = { OPTION("nodata", $value) } ist kein Wert vom Typ { $type } der Pixel.
    .do = Einen Wert dieses Typs angeben.

scene-single = Es gibt eine Satellitenszene und keine Aufnahme; zwei Bilder desselben Geländes sind nötig.
    .do = Eine zweite Szene oder Aufnahmen desselben Geländes angeben.

scene-no_tie_points = { $n } { $n ->
        [one] brauchbare Szene
       *[other] brauchbare Szenen
    } ohne Verknüpfungspunkte und ohne markierte Passpunkte.
    .why = Paare mit gemeinsamem Gelände: { $pairs }.
    .do = Prüfen, ob die Szenen denselben Ort zu ähnlicher Jahreszeit mit ihren eigenen RPC zeigen, oder Passpunkte markieren: { OPTION("control") }.

scene-middle = Szene { $scene }: Mitte bei { NUM($longitude_deg, decimals: 3) }° geographischer Länge, { NUM($latitude_deg, decimals: 3) }° Breite.

scene-control_far_away = In dieser Szene markierte Passpunkte liegen weit außerhalb.
    .do = Das Koordinatensystem und die Nummern der Passpunkte prüfen.

scene-control_shifted = { $n } markierte Passpunkte liegen um { NUM($dx_px, decimals: 0) }, { NUM($dy_px, decimals: 0) } px daneben (Grenze { NUM($limit_x_px, decimals: 0) }, { NUM($limit_y_px, decimals: 0) } px).
    .why = Die Grenze folgt aus der angegebenen Genauigkeit von { $model }.
    .do = Prüfen, ob { $model } zu diesem Bild gehört, dazu Koordinatensystem, Höhen und Nummern der Passpunkte.

scene-control_scattered = { $n } markierte Passpunkte streuen um { NUM($spread_x_px, decimals: 1) }, { NUM($spread_y_px, decimals: 1) } px (Grenze { NUM($limit_x_px, decimals: 1) }, { NUM($limit_y_px, decimals: 1) } px).
    .why = Keine gemeinsame Verschiebung passt (Median { NUM($dx_px, decimals: 0) }, { NUM($dy_px, decimals: 0) } px).
    .do = Prüfen, ob { $model } zu diesem Bild gehört, dazu Koordinatensystem, Höhen und Nummern der Passpunkte.

scene-pixels_not_supported = Pixel von { $suffix }-Dateien werden nicht unterstützt.
    .do = In TIFF umwandeln (gdal_translate { $source } { $target }), die RPC daneben.

scene-other_size = Das Bild hat { $width_px } x { $height_px } px, { $model } gilt für { $model_width_px } x { $model_height_px } px.
    .do = Die Datei dieses Bildes angeben.

scene-all_zero = Das Bild hat keinen Grauwert über 0.
    .do = Ein Bild des Geländes angeben.

scene-no_texture = Das Bild hat keine Textur.
    .do = Prüfen, ob es ein Bild des Geländes ist.

scene-outside_system = Die Szene bei { NUM($longitude_deg, decimals: 4) }° geographischer Länge, { NUM($latitude_deg, decimals: 4) }° Breite liegt außerhalb von { $system }.
    .do = Ein anderes Koordinatensystem angeben: { OPTION("crs") }.

scene-not_covered = Das Raster deckt die Szene nicht, bei { NUM($longitude_deg, decimals: 5) }° geographischer Länge, { NUM($latitude_deg, decimals: 5) }° Breite.
    .do = Das Höhenraster dieses Gebiets angeben.

scene-control_without_system = Die Passpunkte haben kein Koordinatensystem, und { NUM($x, digits: 8) }, { NUM($y, digits: 8) } sind keine Grad nahe den Szenen.
    .why = Die Szenen liegen bei { NUM($longitude_deg, decimals: 4) }° geographischer Länge, { NUM($latitude_deg, decimals: 4) }° Breite.
    .do = Das Koordinatensystem angeben: { OPTION("crs", "EPSG:...") }.

scene-name_taken = Eine andere Szene hat denselben Namen.
    .do = Eine der beiden umbenennen.

scene-pair_shifted = { $n } gemeinsame Punkte ergeben eine Verschiebung von { NUM($shift_px, decimals: 0) } px (Grenze { NUM($limit_px, decimals: 0) } px).
    .why = Die Grenze ist das { $times }-Fache der angegebenen Genauigkeit von { NUM($prior_px, decimals: 1) } px.
    .do = Prüfen, ob jedes Bild seine eigene RPC- oder XML-Datei hat und ob es beschnitten, skaliert oder gedreht wurde.

scene-pair_scattered = { $n } gemeinsame Punkte streuen um { NUM($spread_px, decimals: 0) } px (Grenze { $limit_px } px); keine gemeinsame Verschiebung passt.
    .do = Prüfen, ob jedes Bild seine eigene RPC- oder XML-Datei hat und ob es beschnitten, skaliert oder gedreht wurde.

scene-pair_height = Die Strahlen von { $n } gemeinsamen Punkten schneiden sich bei { NUM($height_m, decimals: 0) } m; die RPC gelten für { NUM($low_m, decimals: 0) } bis { NUM($high_m, decimals: 0) } m.
    .do = Prüfen, ob jedes Bild seine eigene RPC- oder XML-Datei hat und ob es beschnitten, skaliert oder gedreht wurde.

scene-contradicts_other = Die Geometrie dieser Szene ({ $model }) widerspricht der Szene { $other }, die zu anderen Szenen passt.

scene-pair_contradicts = Die Szenen { $first } und { $second } widersprechen sich; welche falsch ist, ist mehrdeutig.
    .do = Eine dritte Szene desselben Gebiets ergänzen oder Passpunkte angeben: { OPTION("control") }.

scene-no_place = { $name }, Punkt { $point }: Keiner der { $n } Punkte hat einen Ort.
    .do = Die Koordinaten der Punkte prüfen.

scene-no_ground_found = Für { $n } Bildpunkte der Radarszene wurden in der Höhe { $height_m } m keine Bodenpunkte gefunden.
    .do = Die Höhen prüfen.

scene-range_too_short = Die Entfernung { $range_m } m des Bildpunkts { $x_px }, { $y_px } erreicht die Höhe { $height_m } m nicht.
    .do = Höhe und Spalte prüfen.

scene-several_in_folder = Der Ordner enthält mehrere Szenen: { $names }.
    .do = Eine dieser Dateien angeben.

scene-radar_delays = Laufzeiten der Atmosphäre und Gezeiten der Erde bleiben der Verschiebung von Entfernung und Uhr.

scene-orbit_noise = { $n } verrauschte Zustandsvektoren ({ NUM($noise_m, digits: 2) } m, { NUM($noise_m_s, digits: 2) } m/s) durch ein Ausgleichspolynom ersetzt.
    .why = Die Interpolation verstärkt ihr Rauschen.

scene-bursts = { $n } Bursts: Zeilen zwischen ihnen sind doppelt aufgenommen, und keine RPC passt zum ganzen Bild.

scene-burst_lines = { $n } Bursts zu { $lines } Zeilen ergeben nicht { $rows } Zeilen.
    .do = Die Datei erneut beschaffen.

scene-no_ground_range = Die Tabelle der Bodenentfernungen ist leer.
    .do = Die Datei erneut beschaffen.

scene-ground_range_origins = Der Ursprung der Bodenentfernungen wechselt im Bild; das wird nicht unterstützt.

scene-wrong_side = Die Radarszene blickt nach { $side ->
    [right] rechts
   *[left] links
  } der Bahn, aber alle { $n } Punkte liegen auf der anderen Seite.
    .why = Entfernungen und Zeiten sind auf beiden Seiten gleich.
    .do = Die Blickrichtung der Szene oder die Koordinaten korrigieren.

scene-map_product = Das Bild dieses Produkts ({ $kind }) ist eine Karte und liegt nicht in der Geometrie des Radars.
    .do = Das Produkt in Schräg- oder Bodenentfernung beschaffen oder dieses als Orthophoto verwenden.

scene-burst_images = Die { $n } Bursts dieses Produkts sind eigene Bilder, die sich überlappen.
    .do = Das Produkt in Bodenentfernung beschaffen.

scene-values_differ = Dieses Element kommt { $n } mal mit verschiedenen Werten vor.
    .do = Das Produkt eines Strahls oder einer Polarisation beschaffen.

scene-line_order = Die Zeiten der ersten und der letzten Zeile ({ $seconds } s Abstand) widersprechen diesem Element.
    .do = Die Datei erneut beschaffen.

scene-range_extent = Die Spalten enden bei { NUM($reached_m, digits: 8) } m, die Datei nennt { NUM($stated_m, digits: 8) } m.
    .do = Die Datei erneut beschaffen.

scene-tie_points = Die { $n } Verknüpfungspunkte der Datei weichen von Bahn und Entfernungen um { $meets ->
     [yes] { NUM($rms_px, digits: 4) } px (quadratisches Mittel)
     *[no] mehr als das Bild
    } ab, Grenze { $limit_px } px.
    .do = Die Szene mit Passpunkten prüfen oder die Datei erneut beschaffen.

scene-rpc_only = Nur das RPC wird verwendet: Der Datei fehlt { $path }.

scene-delays_applied = Angegebene Laufzeiten sind angebracht: { $range_m } m der Entfernung, { $seconds } s der Zeit.

scene-delays_missing = Laufzeiten sind nicht angegeben (ANNOTATION/GEOREF.xml fehlt) und bleiben Entfernung und Uhr.

scene-image_formation = Bilder aus { $kind } haben keine Zeilen einer Zeit; gelesen wird nur Entfernung mit Null-Doppler (RMA, INCA).
    .do = Das Produkt in Schrägentfernung mit Null-Doppler (RGZERO) oder eines in Bodenentfernung beschaffen.

scene-times_curved = Die Zeiten der Spalten weichen um { $seconds } s von einer Geraden ab; das wird nicht unterstützt.
    .do = Das RPC der Szene verwenden.

scene-no_sicd = Keine Datenerweiterung dieses NITF enthält die Metadaten eines SICD.
    .do = Die Datei erneut beschaffen.

scene-is_map = { $what ->
     [landsat] Ein Landsat-Produkt
     [sentinel2] Ein Sentinel-2-Produkt
     [orthoimage] Ein Orthobild (DIMAP)
    *[raster] Ein georeferenziertes Raster
    } ist schon eine Karte; es hat keine Sensorgeometrie, die ausgeglichen werden kann.
    .do = Als Karte verwenden: als Referenz für Passpunkte, als Hintergrund. Zum Orientieren einer Szene ihr Produkt in Sensorgeometrie mit RPC oder Bahn angeben.

scene-no_orbit = Das Bild hat { $n } Punkte am Boden, aber weder Bahn noch RPC.
    .why = So liegen GRD-Raster von Radaren ohne ihre Annotation vor.
    .do = Die Annotation (XML) oder den Produktordner (SAFE) angeben.

scene-product_not_read = { $what ->
     [aster] ASTER Stufe 1A (HDF)
     [sentinel2] Sentinel-2 Stufe 1B
     [ceos] Verzeichnis- und Bilddateien von CEOS
     [saocom] SAOCOM-Produkte
     [kompsat5] Hilfsdateien (XML) von KOMPSAT-5
     [cphd] Phasenverläufe (CPHD)
    *[hdf] HDF-Dateien
    } werden nicht gelesen.
    .do = { $what ->
     [aster] Ein RPC dazu angeben, wie es aster2asp der Ames Stereo Pipeline schreibt
     [sentinel2] Das Produkt der Stufe 1C verwenden, das eine Karte ist
     [ceos] Die Leader-Datei daneben angeben (LEA_01.001)
     [saocom] In SICD umwandeln
     [kompsat5] Das HDF5-Produkt angeben
     [cphd] Das Bild dazu angeben (SICD)
    *[hdf] Ein RPC der Szene angeben, oder sie nach SICD umwandeln
    }.

scene-record_missing = Die Datei hat kein { $name }.
    .do = Die vollständige Datei beschaffen.

scene-raw_product = { $kind } ist ein Rohdatenprodukt (Stufe 0): Es enthält Signale, kein Bild.
    .do = Das Produkt in Schrägentfernung oder Bodenentfernung (Stufe 1) beschaffen.

scene-times_rounded = Die Zeiten der Zeilen sind um bis zu { $seconds } s gerundet ({ $n_px } Zeilen), was die Uhr aufnimmt.

scene-not_uniform = Die Werte dieser Tabelle weichen um { $steps } Schritte von gleichen Abständen ab (Grenze { $limit }).
    .do = Die Datei erneut beschaffen.

scene-image_used = Das Bild { $name } wird verwendet; die Datei enthält auch { $others }.
