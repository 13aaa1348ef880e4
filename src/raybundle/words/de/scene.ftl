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
