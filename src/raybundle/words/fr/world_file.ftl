world_file-six_numbers = Un fichier world contient six nombres, un par ligne.

world_file-rotated = Les pixels ne sont pas carrés, ou l'image est tournée.
