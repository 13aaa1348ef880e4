store-not_confirmed = Das Projekt nennt den Speicher { $url }, der von diesem Rechner noch nicht verwendet wurde.
    .why = Ein fremder Projektordner könnte jeden Speicher nennen.
    .do = Den Speicher einmal mit { OPTION("store") } bestätigen (für { $worker }: die URL anstelle des Projekts) oder { OPTION("store", "project") } verwenden.

store-copies_no_folder = Der Ordner für Kopien, { $folder }, ist nicht möglich: { $place } ist eine Datei.
    .do = { $variable } auf einen Ordner setzen.

store-copies_size = { $variable } = { $value } ist keine Zahl von Gigabytes.
    .do = Auf eine Zahl ab 0 setzen.

store-copies_not_writable = Kopien von Produkten lassen sich nicht schreiben ({ $detail }).
    .why = Fertige Produkte bleiben erhalten.
    .do = { $full ->
        [yes] Speicherplatz freigeben
       *[no] { $variable } auf einen anderen Ordner setzen
     } und denselben Befehl erneut ausführen.

store-occupied = An { $place } gibt es schon einen anderen Ordner.
    .do = Den Ordner verlegen und denselben Befehl erneut ausführen.

store-no_bucket = Den Bucket gibt es nicht, oder er ist schreibgeschützt.
    .do = Den Bucket anlegen oder einen anderen Ort wählen.

store-foreign_token = Das Objekt namens token dort gehört nicht zu raybundle.
    .do = Einen anderen Ort wählen.

store-package_missing = Ein Speicher unter einer URL braucht das Paket { $package }.
    .do = Ausführen: pip install 'raybundle[cluster]'

store-secret = Die URL enthält ein Geheimnis, das in Dateien und Meldungen des Laufs sichtbar wäre.
    .do = Die Zugangsdaten so setzen wie für die Werkzeuge des Dienstes.

store-service_package = Ein Paket für diese Art von Speicher fehlt ({ $detail }).
    .do = Es installieren: pip install { $package }

store-invalid_url = Die URL ist nicht gültig ({ $detail }).
    .do = s3://bucket/ordner, gs://, az:// oder file:///ordner angeben.

store-not_reachable = Der Speicher ist nicht erreichbar ({ $detail }).
    .do = Prüfen, ob dieser Rechner online ist, und die Adresse prüfen.

store-no_bucket_name = Die URL nennt keinen Bucket oder Ordner.
    .do = s3://bucket/ordner, gs://, az:// oder file:///ordner angeben.

store-no_url = Der Speicher ist nicht als URL angegeben.
    .do = s3://bucket/ordner, gs://, az:// oder file:///ordner angeben.

store-no_products = Der Speicher enthält keine Produkte eines Projekts.
    .do = Zuerst den Befehl ausführen, der die Aufgaben beginnt.

store-in_memory = Der Speicher liegt im Arbeitsspeicher dieses Prozesses; andere Prozesse sehen ihn nicht.
    .do = Alle Aufgaben von Threads dieses Prozesses erledigen lassen oder einen anderen Ort wählen.

store-not_readable = Der Speicher ist nicht lesbar ({ $detail }).
    .do = Andere Programme beenden und denselben Befehl erneut ausführen.

store-no_folder_name = Die URL nennt keinen Ordner.
    .do = Einen Ordner nur für dieses Projekt angeben, z. B. file:///ordner.

store-escaped = In dieser URL wäre { $text } Teil des Ordnernamens.
    .do = Das Zeichen selbst schreiben und die URL in der Shell in Anführungszeichen setzen.

store-is_a_file = Der Speicher ist eine Datei.
    .do = Einen Ordner angeben.

store-not_separate = Der Speicher liegt im Ordner { $kind ->
        [result] des Ergebnisses
       *[input] der Eingaben
     } ({ $place }).
    .do = Dem Speicher einen eigenen Ordner geben.

store-not_writable = Der Speicher lässt sich nicht anlegen oder beschreiben ({ $detail }).
    .do = Einen Ordner mit Schreibrecht angeben.

store-lost = Der Speicher arbeitet nicht ({ $detail }), { $n } Versuche.
    .why = Fertige Produkte bleiben erhalten; derselbe Befehl setzt fort.
    .do = { $cause ->
        [refused] Die Zugangsdaten des Dienstes so setzen wie für seine eigenen Werkzeuge
        [full] Platz im Speicher schaffen
       *[other] Prüfen, ob dieser Rechner online ist, und die Adresse prüfen
     }.

store-chained = Eine verkettete URL (::) kann kein Speicher sein.
    .do = s3://bucket/ordner, gs://, az:// oder file:///ordner angeben.

store-web_page = Mit { $scheme } lässt sich nichts schreiben.
    .do = s3://bucket/ordner, gs://, az:// oder file:///ordner angeben.

store-unknown_scheme = { $scheme }:// ist keine Art von Speicher.
    .do = Eine von { LIST($known, most: 20) } verwenden.

store-of_last_run = Der Speicher des letzten Laufs lässt sich nicht verwenden.
    .do = Einen anderen angeben, { OPTION("store", "URL") }, oder { OPTION("store", $here) } für den Ordner des Projekts.
