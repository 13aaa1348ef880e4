image_left_out = Bild { $image } ist von der Ausgleichung ausgeschlossen.
    .why = Das Ergebnis enthält keine Orientierung dieses Bildes; die Objektpunkte beruhen auf den anderen Bildern.
    .do = Die folgende Ursache beheben und neu ausgleichen oder das Ergebnis ohne dieses Bild verwenden.
