studio_product-title = Produkte
    .title = Oberfläche, Orthophoto, Zeichnung, Volumen, Profile, Austauschdateien, Archiv

studio_product-part = { $part ->
        [plan] Plan
        [surface] Oberfläche
        [facade] Aufriss
        [volume] Volumen
        [section] Profil
        [contours] Höhenlinien
        [drawing] Zeichnung
        [exchange] Austauschdateien
        [archive] Archiv
        [pages] Seiten
        *[files] Dateien
    }

studio_product-about = { $product ->
        [surface] Punkte mit Standardabweichungen; mit Zellgrößen auch Höhen (DOM), Orthophoto, Netz.
        [facade] Aufriss einer Wand: wahres Orthophoto, Blatt im Maßstab (PDF), Zeichnung (DXF), Schnitte.
        [volume] Volumen über und unter einer Basis mit Standardabweichungen. Die Fläche auf dem Plan zeichnen.
        [section] Profil entlang einer Linie: Tabelle, Bild, Zeichnung. Die Linie auf dem Plan zeichnen.
        [contours] Höhenlinien für GIS und CAD.
        [drawing] Linien und Flächen, die auf dem Plan gezeichnet sind, mit Höhen, für CAD und GIS.
        [exchange] Dateien für andere Programme: GIS, CAD, COLMAP, Metashape, OPF, LAS.
        *[archive] Ein Paket zur Ablage: Ergebnis, Aufnahmebogen, Parameter, Prüfsummen (RO-Crate).
    }

studio_product-draw = { $shape ->
        [area] Fläche zeichnen
        *[line] Linie zeichnen
    }
    .title = Ecken anklicken; Rücktaste entfernt die letzte, Escape alle

studio_product-use = { $shape ->
        [area] Volumen dieser Fläche
        *[line] Profil entlang dieser Linie
    }

studio_product-name = Name

studio_product-layer = Layer

studio_product-note = Notiz

studio_product-keep = Behalten
    .title = Das Gezeichnete im Projekt behalten; Rückgängig nimmt es zurück

studio_product-kept = { $name } ist im Projekt.

studio_product-drawings = Zeichnungen

studio_product-default_name = { $shape ->
        [area] Fläche
        *[line] Linie
    } { $n }

studio_product-erase = { $name } löschen

studio_product-erased = { $name } ist gelöscht.

studio_product-edit = { $name } ändern

studio_product-page = Seite

studio_product-make = Erzeugen
    .title = Diesen Befehl im Hintergrund ausführen

studio_product-picture = Bild

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
