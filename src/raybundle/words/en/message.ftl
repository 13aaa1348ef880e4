# $language = "it"
# $known = ["en", "de", "fr"]
message-unknown_language = There are no messages in the language { $language }.
    .do = Use one of { $known }.

# $code_name = "scale.one_bar"
# $close = ["scale.single_bar"]
message-unknown_code = No message has the code { $code_name }.
    .do = Copy the code in square brackets after the message; similar codes: { $close }.
