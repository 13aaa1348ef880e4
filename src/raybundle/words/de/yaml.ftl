yaml-indentation = Die Zeile ist weniger eingerückt als ihr Block.
    .do = Die Einrückung korrigieren.

yaml-second_document = Hier beginnt ein zweites Dokument.
    .do = Jedes Dokument in einer eigenen Datei angeben.

yaml-tab = Die Zeile ist mit einem Tabulator eingerückt.
    .do = Leerzeichen verwenden.

yaml-open_list = Eine hier begonnene Liste hat kein Ende.
    .do = Prüfen, ob die Datei vollständig ist.

yaml-no_entry = Hier wird ein Eintrag KEY: VALUE erwartet.
    .do = Diese Zeile korrigieren.

yaml-list_form = Die Liste hat eine falsche Form.
    .do = Die Elemente durch Kommas trennen und die Liste schließen.

yaml-not_supported = Anker und Blocktexte von YAML werden nicht unterstützt.
    .do = Einfache Werte schreiben.
