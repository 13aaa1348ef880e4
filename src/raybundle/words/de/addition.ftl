addition-camera_not_supported = Kamera { $camera }: Die Wirkung einer weiteren Aufnahme lässt sich nicht vorhersagen.
    .why = Die Kamera ist eine Szene, bewegt sich beim Auslesen oder hat in jedem Bild eigene Parameter.
    .do = Eine Flächenkamera ohne Parameter einzelner Bilder (per_image) wählen.

addition-camera_without_photograph = Kamera { $camera } hat keine Aufnahme, die in die Ausgleichung eingeht.
    .do = Eine Kamera mit orientierten Aufnahmen wählen.
