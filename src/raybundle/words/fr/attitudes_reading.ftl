attitudes_reading = Les photographies décident : les attitudes de { $source } sont { $reading }.
