video-count_and_time = Anzahl der Bilder und Zeit dazwischen schließen einander aus.
    .do = Eines von beiden angeben.

video-option_not_positive = { $option ->
        [count] Die Anzahl der Bilder
        [every_s] Die Zeit zwischen Bildern [s]
       *[motion] Die Bewegung zwischen Bildern
     } ist { $value }.
    .do = Einen Wert über 0 angeben.

video-not_decoded = Das Video ist nicht dekodierbar.
    .do = In MP4 (H.264) umwandeln.

video-no_frame = Das Video hat kein dekodierbares Bild.
    .do = Prüfen, ob die Datei vollständig ist.
