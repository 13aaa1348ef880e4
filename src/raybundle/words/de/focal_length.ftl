focal_length-not_positive = Die Brennweite ist { $lengths }; sie muss positiv sein.
    .do = Den Wert korrigieren oder die Datei neu exportieren.
