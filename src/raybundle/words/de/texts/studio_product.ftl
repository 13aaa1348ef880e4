studio_product-title = Produkte
    .title = Oberfläche, Orthophoto, Zeichnung, Volumen, Profile, Austauschdateien, Archiv

studio_product-plan = Plan
    .title = Orthophoto, Höhen und Bilder; Flächen und Linien darauf zeichnen

studio_product-surface = Oberfläche

studio_product-facade = Aufriss

studio_product-volume = Volumen

studio_product-section = Profil

studio_product-contours = Höhenlinien

studio_product-exchange = Austauschdateien

studio_product-archive = Archiv

studio_product-pages = Seiten
    .title = Die Oberfläche im Raum mit Standardabweichungen als Farben; ihre Güte

studio_product-page = Seite

studio_product-files = Dateien

studio_product-about_surface = Punktwolke des aktuellen Ergebnisses mit Standardabweichungen. Mit Zellgrößen auch Höhen (DOM), Orthophoto und Netz.

studio_product-about_facade = Aufriss einer Wand: wahres Orthophoto, Blatt im Maßstab (PDF), Zeichnung (DXF), Schnitte.

studio_product-about_volume = Volumen über und unter einer Basis mit Standardabweichungen. Die Fläche auf dem Plan zeichnen.

studio_product-about_section = Profil entlang einer Linie: Tabelle, Bild, Zeichnung. Die Linie auf dem Plan zeichnen.

studio_product-about_contours = Höhenlinien für GIS und CAD.

studio_product-about_exchange = Dateien für andere Programme: GIS, CAD, COLMAP, Metashape, OPF, LAS.

studio_product-about_archive = Ein Paket zur Ablage: Ergebnis, Aufnahmebogen, Parameter, Prüfsummen (RO-Crate).

studio_product-make = Erzeugen
    .title = Diesen Befehl im Hintergrund ausführen

studio_product-picture = Bild

studio_product-draw_area = Fläche zeichnen
    .title = Ecken anklicken; Rücktaste entfernt die letzte, Escape alle

studio_product-draw_line = Linie zeichnen
    .title = Ecken anklicken; Rücktaste entfernt die letzte, Escape alle

studio_product-use_area = Volumen dieser Fläche

studio_product-use_line = Profil entlang dieser Linie

studio_product-clear = Leeren

studio_product-show = Zeigen

studio_product-no_files = Noch keine Produkte.

studio_product-no_picture = Noch keine Bilder. Zuerst eine Oberfläche mit Orthophoto erzeugen.

studio_product-more = { $n } weitere Dateien sind im Ordner.

studio_product-place = X { $x }, Y { $y }{ $z ->
        [none] {""}
        *[other] , Höhe { $z }
    }{ $s ->
        [none] {""}
        *[other] , Standardabweichung { $s }
    }
