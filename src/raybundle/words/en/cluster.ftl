cluster-no_shards = Shards cannot be used here: the sweeps of an adjustment depend on each other.
    .do = Start a scheduler and workers as jobs, and give their folder: { OPTION("cluster", "FOLDER") }.

# $package = "distributed"
cluster-package_missing = A cluster needs the package { $package }.
    .do = Run: pip install 'raybundle[cluster]'

# $address = "127.0.0.1"
cluster-no_address = { $address } is not an address of a scheduler.
    .do = Give an address such as tcp://127.0.0.1:8786, or the folder of the cluster.

cluster-other_machine = The scheduler is on another machine; its address alone has no certificates.
    .do = Give the folder of the cluster, which raybundle scheduler FOLDER creates.

cluster-needs_certificates = This address needs certificates.
    .do = Give the folder that contains them.

# $names = ["key.pem"]
# $others = ["ca.pem"]
# $n = 1
cluster-certificates_missing = Certificates are missing: { $names }.
    .why = Without them nothing is sent over a network.
    .do = { $n ->
        [0] Start the scheduler again; it creates new ones
       *[other] Delete { $others } there and start the scheduler again; it creates new ones
     }.

# $address = "tcp://10.0.0.1:8786"
cluster-not_encrypted = { $address } is not encrypted (tls://).
    .do = Start the scheduler again.

cluster-no_certificate = This file contains no certificate.
    .do = Delete the certificates of the cluster and start the scheduler again; it creates new ones.

# $date = "2026-01-31"
cluster-certificates_expired = The certificates expired on { $date }.
    .do = Delete the certificates of the cluster and start the scheduler again; it creates new ones.

# $detail = "bad base64 decode"
cluster-certificates_not_usable = The certificates cannot be used ({ $detail }).
    .do = Delete the certificates of the cluster and start the scheduler again; it creates new ones.

# $names = ["key.pem"]
cluster-certificates_incomplete = Certificates are missing: { $names }.
    .do = Add them, or delete the other certificates.

# $address = "tls://10.0.0.1:8786"
cluster-second_scheduler = A scheduler of this cluster is already running ({ $address }).
    .do = Use it, or choose another folder.

# $host = "node7"
# $port = "8786"
# $detail = "Address already in use"
cluster-cannot_listen = The scheduler cannot listen at host { $host }, port { $port } ({ $detail }).
    .do = Give { OPTION("host") } by which other machines reach this one, and a free { OPTION("port") }, or none.

# $wait_s = 60.0
# $folder = "cluster"
cluster-no_folder = There is no such folder, and none was created within { $wait_s } s.
    .do = Run raybundle scheduler { $folder }; all machines must see it under this path.

# $found = "raybundle 1.0"
# $version = "raybundle 1.1"
cluster-other_version = The versions differ: { $found } there, { $version } here.
    .do = Install the same version on all machines.

# $detail = "timed out"
# $folder = "facade"
cluster-connection_lost = The scheduler does not answer ({ $detail }).
    .why = Finished products remain in { $folder }.
    .do = Start a scheduler and run the same command again, or run it without one.

# $host = "node7"
# $url = false
cluster-worker_blind = The worker on { $host } does not see the { $url ->
        [yes] store
       *[no] folder
     } as this machine does:
    .do = { $url ->
        [yes] Give it access
       *[no] Mount the folder there under the same path
     }, or stop that worker.

# $host = "node7"
# $n = 3
cluster-worker_fails = The worker on { $host } failed in { $n } tasks that this machine can do.
    .do = Make the photographs visible there under the same path, or stop that worker.

# $n = 2
# $version = "raybundle 1.1"
# $others = ["node7: raybundle 1.0"]
cluster-no_worker = No worker can do the tasks: { $n ->
        [0] there is none
       *[other] none of { $n } has { $version }
     }.
    .why = { $n ->
        [0] Finished products remain.
       *[other] Workers have { $others }. Finished products remain.
     }
    .do = Run raybundle worker with the same version as here.

# $file_name = "scheduler.json"
# $folder = "cluster"
cluster-no_scheduler = No scheduler was started there: { $file_name } is missing.
    .do = Run: raybundle scheduler { $folder }

# $address = "tls://10.0.0.1:8786"
# $detail = "unknown authority"
cluster-foreign_certificate = Scheduler { $address } has a certificate of another cluster ({ $detail }).
    .why = Finished products remain.
    .do = Start a scheduler of this cluster, or run without one.

# $address = "tls://10.0.0.1:8786"
# $detail = "BAD_CERTIFICATE"
cluster-certificate_refused = Scheduler { $address } rejects the certificates of this folder ({ $detail }).
    .why = Finished products remain.
    .do = Start a scheduler of this cluster, or run without one.

# $address = "tcp://127.0.0.1:8786"
# $wait_s = 10.0
cluster-timeout = The scheduler at { $address } does not answer within { $wait_s } s.
    .why = It may require certificates. Finished products remain.
    .do = Start a scheduler, or run without one.

# $address = "tcp://127.0.0.1:8786"
# $detail = "Connection refused"
cluster-no_answer = No scheduler answers at { $address } ({ $detail }).
    .why = Finished products remain.
    .do = Start a scheduler, or run without one.

# $n = 3
# $wanted = 8
# $wait_s = 600.0
# $differing = 1
# $others = ["node7: raybundle 1.0"]
cluster-too_few_workers = { $n } of { $wanted } workers came within { $wait_s } s.
    .why = { $differing ->
        [0] Nothing was computed.
       *[other] Workers of other versions: { $others }. Nothing was computed.
     }
    .do = Start more workers, wait longer ({ OPTION("wait_limit", "S") }), or ask for fewer.

cluster-nothing_awaited = Workers are awaited, but no scheduler is given.
    .do = Give the folder of the cluster: { OPTION("cluster", "FOLDER") }.

# $given = "here"
cluster-dashboard_address = { $given } is neither a port nor HOST:PORT.
    .do = Give a port such as 8787.

# $package = "bokeh"
cluster-dashboard_package = The dashboard needs the package { $package }.
    .do = Run: pip install { $package }
