scene-orientation_given = Bild { $image } ist eine Satellitenszene; ihre Orientierung steht in der Datei der Szene.
    .do = Diese Zellen leer lassen.

scene-second_image = Kamera { $camera } ist eine Satellitenszene und hat schon ein Bild.
    .do = Für jede Szene eine eigene Kamera verwenden.

scene-size_unknown = Die Datei der Szene enthält die Bildgröße nicht.
    .do = width_px und height_px angeben.

scene-no_rpc = { $scene } hat keine RPC.
    .do = model = "linescan" angeben.

scene-no_rigorous_model = { $scene } hat kein unterstütztes strenges Modell.
    .do = model = "rpc" angeben.

scene-file_gone = Kamera { $camera }: Die Datei ihrer Szene ({ $scene }) fehlt; der Block kann nicht geschrieben werden.
    .do = Die Datei dort wiederherstellen, wo sie gelesen wurde.

scene-companion_gone = Kamera { $camera }: { $scene } verweist auf diese Datei, die fehlt.
    .do = Die Datei wiederherstellen.

scene-length_unit = Satellitenszenen brauchen length_unit = "m", nicht "{ $unit }".

scene-file_elsewhere = { $name } ist nicht der Name einer Datei im Ordner dieser Datei.
    .do = Die Datei in diesen Ordner kopieren und nur ihren Namen angeben.

scene-keys_exclusive = Dieser Schlüssel und { $other } schließen einander aus.
    .do = Einen der beiden löschen.

scene-crs_superfluous = Die Tabelle hat Länge und Breite, die kein Koordinatensystem brauchen.
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
