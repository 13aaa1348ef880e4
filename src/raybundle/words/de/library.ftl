library-not_determinable = Die Aufnahmen haben diese Kamera nicht bestimmt; sie wird nicht in die Bibliothek aufgenommen.
    .why = Diese Kamera würde jeden Block verfälschen, der sie verwendet.
    .do = Die im Bericht genannten Aufnahmen machen und neu kalibrieren.

library-no_key = Die Bibliothek findet eine Kalibrierung über Kameramodell und EXIF-Brennweite; eines fehlt.
    .do = Eine Aufnahme des Satzes ({ OPTION("photo", "FILE") }) oder { OPTION("camera_model", "NAME") } und { OPTION("focal", "MM") } angeben.
