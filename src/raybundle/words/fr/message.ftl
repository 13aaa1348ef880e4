message-unknown_language = Il n'y a pas de messages en { $language }.

message-unknown_code = Aucun message n'a le code { $code_name }.
