plumb_line_suspect = { suspect-value }
    .why = { suspect-value.why }
    .do = { suspect-value.do }
