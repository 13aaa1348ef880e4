# $url = "s3://bucket/facade"
# $worker = "raybundle worker"
store-not_confirmed = The project names the store { $url }, which was not used from this machine yet.
    .why = A project folder from others could name any store.
    .do = Confirm it once with { OPTION("store") } (for { $worker }: the URL in place of the project), or use { OPTION("store", "project") }.

# $folder = "/tmp/products"
# $place = "/tmp/products"
# $variable = "RAYBUNDLE_PRODUCTS"
store-copies_no_folder = The folder for copies, { $folder }, is not possible: { $place } is a file.
    .do = Set { $variable } to a folder.

# $variable = "RAYBUNDLE_PRODUCTS_GB"
# $value = "'many'"
store-copies_size = { $variable } = { $value } is not a number of gigabytes.
    .do = Set it to a number of at least 0.

# $variable = "RAYBUNDLE_PRODUCTS"
# $full = true
# $detail = "No space left on device"
store-copies_not_writable = Copies of products cannot be written ({ $detail }).
    .why = Finished products remain.
    .do = { $full ->
        [yes] Free disk space
       *[no] Set { $variable } to another folder
     }, and run the same command again.

# $place = "bucket/facade/token"
store-occupied = Another folder already exists at { $place }.
    .do = Move it elsewhere and run the same command again.

store-no_bucket = The bucket does not exist, or nothing can be written into it.
    .do = Create it, or choose another place.

store-foreign_token = The object named token there does not belong to raybundle.
    .do = Choose another place.

# $package = "fsspec"
store-package_missing = A store at a URL needs the package { $package }.
    .do = Run: pip install 'raybundle[cluster]'

store-secret = The URL contains a secret, which would be visible in files and messages of the run.
    .do = Set the credentials as the tools of this service do.

# $detail = "Install s3fs to access S3"
# $package = "s3fs"
store-service_package = A package for this kind of store is missing ({ $detail }).
    .do = Install it: pip install { $package }

# $detail = "Protocol not known: s4"
store-invalid_url = The URL is not valid ({ $detail }).
    .do = Give s3://bucket/folder, gs://, az:// or file:///folder.

# $detail = "timed out"
store-not_reachable = The store cannot be reached ({ $detail }).
    .do = Check that this machine is online, and the address.

store-no_bucket_name = The URL names no bucket or folder.
    .do = Give s3://bucket/folder, gs://, az:// or file:///folder.

store-no_url = The store is not given as a URL.
    .do = Give s3://bucket/folder, gs://, az:// or file:///folder.

store-no_products = The store contains no products of a project.
    .do = Run the command that starts the tasks first.

store-in_memory = The store is in the memory of this process; other processes cannot see it.
    .do = Let threads of this process do all tasks, or choose another place.

# $detail = "Too many open files"
store-not_readable = The store cannot be read ({ $detail }).
    .do = End other programs and run the same command again.

store-no_folder_name = The URL names no folder.
    .do = Give a folder for this project alone, as file:///folder.

# $text = "%20"
store-escaped = In this URL { $text } would be part of the name of the folder.
    .do = Write the character itself, and quote the URL in the shell.

store-is_a_file = The store is a file.
    .do = Give a folder.

# $kind = "result"
# $place = "facade"
store-not_separate = The store is in the folder of { $kind ->
        [result] the result
       *[input] the input
     } ({ $place }).
    .do = Give it a folder of its own.

# $detail = "Permission denied"
store-not_writable = The store cannot be created or written ({ $detail }).
    .do = Give a folder with write permission.

# $cause = "refused"
# $n = 5
# $detail = "403 Forbidden"
store-lost = The store does not work ({ $detail }), { $n } attempts.
    .why = Finished products remain; the same command continues.
    .do = { $cause ->
        [refused] Set the credentials of this service as its own tools do
        [full] Free space in the store
       *[other] Check that this machine is online, and the address
     }.

store-chained = A chained URL (::) cannot be a store.
    .do = Give s3://bucket/folder, gs://, az:// or file:///folder.

# $scheme = "https"
store-web_page = Nothing can be written by { $scheme }.
    .do = Give s3://bucket/folder, gs://, az:// or file:///folder.

# $scheme = "s4"
# $known = ["az", "file", "gs", "s3"]
store-unknown_scheme = { $scheme }:// is not a kind of store.
    .do = Use one of { LIST($known, most: 20) }.

# $here = "project"
store-of_last_run = The store of the last run cannot be used.
    .do = Give another one, { OPTION("store", "URL") }, or { OPTION("store", $here) } for the folder of the project.
