tiff-ends_early = Die TIFF-Datei endet vor Byte { $byte }.
    .do = Sie neu kopieren.

tiff-no_tiff = Das ist keine TIFF-Datei.

tiff-too_many_tags = Das TIFF-Verzeichnis hat { $n } Tags; höchstens { $most } werden gelesen.
    .do = Prüfen, ob die Datei beschädigt ist.
