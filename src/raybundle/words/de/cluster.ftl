cluster-no_shards = Teile (shards) sind hier nicht möglich: Die Durchläufe einer Ausgleichung hängen voneinander ab.
    .do = Scheduler und Worker als Jobs starten und ihren Ordner angeben: { OPTION("cluster", "FOLDER") }.

cluster-package_missing = Ein Cluster braucht das Paket { $package }.
    .do = Ausführen: pip install 'raybundle[cluster]'

cluster-no_address = { $address } ist keine Adresse eines Schedulers.
    .do = Eine Adresse wie tcp://127.0.0.1:8786 oder den Ordner des Clusters angeben.

cluster-other_machine = Der Scheduler ist auf einem anderen Rechner; seine Adresse allein hat keine Zertifikate.
    .do = Den Ordner des Clusters angeben, den raybundle scheduler FOLDER anlegt.

cluster-needs_certificates = Diese Adresse braucht Zertifikate.
    .do = Den Ordner angeben, der sie enthält.

cluster-certificates_missing = Zertifikate fehlen: { $names }.
    .why = Ohne sie wird nichts über ein Netzwerk gesendet.
    .do = { $n ->
        [0] Den Scheduler neu starten; er erzeugt neue
       *[other] { $others } dort löschen und den Scheduler neu starten; er erzeugt neue
     }.

cluster-not_encrypted = { $address } ist nicht verschlüsselt (tls://).
    .do = Den Scheduler neu starten.

cluster-no_certificate = Diese Datei enthält kein Zertifikat.
    .do = Die Zertifikate des Clusters löschen und den Scheduler neu starten; er erzeugt neue.

cluster-certificates_expired = Die Zertifikate sind am { $date } abgelaufen.
    .do = Die Zertifikate des Clusters löschen und den Scheduler neu starten; er erzeugt neue.

cluster-certificates_not_usable = Die Zertifikate sind nicht benutzbar ({ $detail }).
    .do = Die Zertifikate des Clusters löschen und den Scheduler neu starten; er erzeugt neue.

cluster-certificates_incomplete = Zertifikate fehlen: { $names }.
    .do = Die fehlenden Zertifikate ergänzen oder die anderen löschen.

cluster-second_scheduler = Ein Scheduler dieses Clusters läuft bereits ({ $address }).
    .do = Diesen Scheduler verwenden oder einen anderen Ordner wählen.

cluster-cannot_listen = Der Scheduler kann an Host { $host }, Port { $port } nicht empfangen ({ $detail }).
    .do = { OPTION("host") } angeben, unter dem andere diesen Rechner erreichen, und einen freien { OPTION("port") } oder keinen.

cluster-no_folder = Diesen Ordner gibt es nicht, und in { $wait_s } s wurde keiner angelegt.
    .do = raybundle scheduler { $folder } ausführen; alle Rechner müssen ihn unter diesem Pfad sehen.

cluster-other_version = Die Versionen sind verschieden: dort { $found }, hier { $version }.
    .do = Auf allen Rechnern dieselbe Version installieren.

cluster-connection_lost = Der Scheduler antwortet nicht ({ $detail }).
    .why = Fertige Produkte bleiben in { $folder }.
    .do = Einen Scheduler starten und denselben Befehl erneut ausführen, oder ihn ohne Cluster ausführen.

cluster-worker_blind = Der Worker auf { $host } sieht { $url ->
        [yes] den Speicher
       *[no] den Ordner
     } nicht so wie dieser Rechner:
    .do = { $url ->
        [yes] Dem Worker Zugang geben
       *[no] Den Ordner dort unter demselben Pfad einbinden
     } oder diesen Worker beenden.

cluster-worker_fails = Der Worker auf { $host } scheiterte an { $n } Aufgaben, die dieser Rechner kann.
    .do = Die Aufnahmen dort unter demselben Pfad sichtbar machen oder diesen Worker beenden.

cluster-no_worker = Kein Worker kann die Aufgaben erledigen: { $n ->
        [0] Es gibt keinen
       *[other] Keiner von { $n } hat { $version }
     }.
    .why = { $n ->
        [0] Fertige Produkte bleiben erhalten.
       *[other] Worker haben { $others }. Fertige Produkte bleiben erhalten.
     }
    .do = raybundle worker mit derselben Version wie hier ausführen.

cluster-no_scheduler = Dort wurde kein Scheduler gestartet: { $file_name } fehlt.
    .do = Ausführen: raybundle scheduler { $folder }

cluster-foreign_certificate = Der Scheduler an { $address } hat ein Zertifikat eines anderen Clusters ({ $detail }).
    .why = Fertige Produkte bleiben erhalten.
    .do = Einen Scheduler dieses Clusters starten oder den Befehl ohne Cluster ausführen.

cluster-certificate_refused = Der Scheduler an { $address } weist die Zertifikate dieses Ordners zurück ({ $detail }).
    .why = Fertige Produkte bleiben erhalten.
    .do = Einen Scheduler dieses Clusters starten oder den Befehl ohne Cluster ausführen.

cluster-timeout = Der Scheduler an { $address } antwortet nicht innerhalb von { $wait_s } s.
    .why = Vielleicht verlangt er Zertifikate. Fertige Produkte bleiben erhalten.
    .do = Einen Scheduler starten oder den Befehl ohne Cluster ausführen.

cluster-no_answer = An { $address } antwortet kein Scheduler ({ $detail }).
    .why = Fertige Produkte bleiben erhalten.
    .do = Einen Scheduler starten oder den Befehl ohne Cluster ausführen.

cluster-too_few_workers = { $n } von { $wanted } Workern kamen innerhalb von { $wait_s } s.
    .why = { $differing ->
        [0] Berechnet wurde nichts.
       *[other] Worker anderer Versionen: { $others }. Berechnet wurde nichts.
     }
    .do = Mehr Worker starten, länger warten ({ OPTION("wait_limit", "S") }) oder weniger verlangen.

cluster-nothing_awaited = Auf Worker soll gewartet werden, aber es ist kein Scheduler angegeben.
    .do = Den Ordner des Clusters angeben: { OPTION("cluster", "FOLDER") }.

cluster-dashboard_address = { $given } ist weder ein Port noch HOST:PORT.
    .do = Einen Port wie 8787 angeben.

cluster-dashboard_package = Das Dashboard braucht das Paket { $package }.
    .do = Ausführen: pip install { $package }
