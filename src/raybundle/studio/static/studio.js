"use strict";(()=>{var Ri=class{constructor(t){this.value=t}valueOf(){return this.value}},he=class extends Ri{constructor(t="???"){super(t)}toString(t){return`{${this.value}}`}},Le=class extends Ri{constructor(t,e={}){super(t),this.opts=e}toString(t){if(t)try{return t.memoizeIntlObject(Intl.NumberFormat,this.opts).format(this.value)}catch(e){t.reportError(e)}return this.value.toString(10)}},Ci=class n extends Ri{static supportsValue(t){if(typeof t=="number"||t instanceof Date)return!0;if(t instanceof Ri)return n.supportsValue(t.valueOf());if("Temporal"in globalThis){let e=globalThis.Temporal;if(t instanceof e.Instant||t instanceof e.PlainDateTime||t instanceof e.PlainDate||t instanceof e.PlainMonthDay||t instanceof e.PlainTime||t instanceof e.PlainYearMonth)return!0}return!1}constructor(t,e={}){t instanceof n?(e={...t.opts,...e},t=t.value):t instanceof Ri&&(t=t.valueOf()),typeof t=="object"&&"calendarId"in t&&e.calendar===void 0&&(e={...e,calendar:t.calendarId}),super(t),this.opts=e}[Symbol.toPrimitive](t){return t==="string"?this.toString():this.toNumber()}toNumber(){let t=this.value;if(typeof t=="number")return t;if(t instanceof Date)return t.getTime();if("epochMilliseconds"in t)return t.epochMilliseconds;if("toZonedDateTime"in t)return t.toZonedDateTime("UTC").epochMilliseconds;throw new TypeError("Unwrapping a non-number value as a number")}toString(t){if(t)try{return t.memoizeIntlObject(Intl.DateTimeFormat,this.opts).format(this.value)}catch(e){t.reportError(e)}return typeof this.value=="number"||this.value instanceof Date?new Date(this.value).toISOString():this.value.toString()}};var yh=100,_f="\u2068",vf="\u2069";function yf(n,t,e){if(e===t||e instanceof Le&&t instanceof Le&&e.value===t.value)return!0;if(t instanceof Le&&typeof e=="string"){let i=n.memoizeIntlObject(Intl.PluralRules,t.opts).select(t.value);if(e===i)return!0}return!1}function xh(n,t,e){return t[e]?Yn(n,t[e].value):(n.reportError(new RangeError("No default")),new he)}function Tl(n,t){let e=[],i=Object.create(null);for(let s of t)s.type==="narg"?i[s.name]=Is(n,s.value):e.push(Is(n,s));return{positional:e,named:i}}function Is(n,t){switch(t.type){case"str":return t.value;case"num":return new Le(t.value,{minimumFractionDigits:t.precision});case"var":return xf(n,t);case"mesg":return bf(n,t);case"term":return Mf(n,t);case"func":return wf(n,t);case"select":return Sf(n,t);default:return new he}}function xf(n,{name:t}){let e;if(n.params)if(Object.prototype.hasOwnProperty.call(n.params,t))e=n.params[t];else return new he(`$${t}`);else if(n.args&&Object.prototype.hasOwnProperty.call(n.args,t))e=n.args[t];else return n.reportError(new ReferenceError(`Unknown variable: $${t}`)),new he(`$${t}`);if(e instanceof Ri)return e;switch(typeof e){case"string":return e;case"number":return new Le(e);case"object":if(Ci.supportsValue(e))return new Ci(e);default:return n.reportError(new TypeError(`Variable type not supported: $${t}, ${typeof e}`)),new he(`$${t}`)}}function bf(n,{name:t,attr:e}){let i=n.bundle._messages.get(t);if(!i)return n.reportError(new ReferenceError(`Unknown message: ${t}`)),new he(t);if(e){let s=i.attributes[e];return s?Yn(n,s):(n.reportError(new ReferenceError(`Unknown attribute: ${e}`)),new he(`${t}.${e}`))}return i.value?Yn(n,i.value):(n.reportError(new ReferenceError(`No value: ${t}`)),new he(t))}function Mf(n,{name:t,attr:e,args:i}){let s=`-${t}`,r=n.bundle._terms.get(s);if(!r)return n.reportError(new ReferenceError(`Unknown term: ${s}`)),new he(s);if(e){let a=r.attributes[e];if(a){n.params=Tl(n,i).named;let l=Yn(n,a);return n.params=null,l}return n.reportError(new ReferenceError(`Unknown attribute: ${e}`)),new he(`${s}.${e}`)}n.params=Tl(n,i).named;let o=Yn(n,r.value);return n.params=null,o}function wf(n,{name:t,args:e}){let i=n.bundle._functions[t];if(!i)return n.reportError(new ReferenceError(`Unknown function: ${t}()`)),new he(`${t}()`);if(typeof i!="function")return n.reportError(new TypeError(`Function ${t}() is not callable`)),new he(`${t}()`);try{let s=Tl(n,e);return i(s.positional,s.named)}catch(s){return n.reportError(s),new he(`${t}()`)}}function Sf(n,{selector:t,variants:e,star:i}){let s=Is(n,t);if(s instanceof he)return xh(n,e,i);for(let r of e){let o=Is(n,r.key);if(yf(n,s,o))return Yn(n,r.value)}return xh(n,e,i)}function Al(n,t){if(n.dirty.has(t))return n.reportError(new RangeError("Cyclic reference")),new he;n.dirty.add(t);let e=[],i=n.bundle._useIsolating&&t.length>1;for(let s of t){if(typeof s=="string"){e.push(n.bundle._transform(s));continue}if(n.placeables++,n.placeables>yh)throw n.dirty.delete(t),new RangeError(`Too many placeables expanded: ${n.placeables}, max allowed is ${yh}`);i&&e.push(_f),e.push(Is(n,s).toString(n)),i&&e.push(vf)}return n.dirty.delete(t),e.join("")}function Yn(n,t){return typeof t=="string"?n.bundle._transform(t):Al(n,t)}var Or=class{constructor(t,e,i){this.dirty=new WeakSet,this.params=null,this.placeables=0,this.bundle=t,this.errors=e,this.args=i}reportError(t){if(!this.errors||!(t instanceof Error))throw t;this.errors.push(t)}memoizeIntlObject(t,e){let i=this.bundle._intls.get(t);i||(i={},this.bundle._intls.set(t,i));let s=JSON.stringify(e);return i[s]||(i[s]=new t(this.bundle.locales,e)),i[s]}};function Rl(n,t){let e=Object.create(null);for(let[i,s]of Object.entries(n))t.includes(i)&&(e[i]=s.valueOf());return e}var bh=["unitDisplay","currencyDisplay","useGrouping","minimumIntegerDigits","minimumFractionDigits","maximumFractionDigits","minimumSignificantDigits","maximumSignificantDigits"];function Mh(n,t){let e=n[0];if(e instanceof he)return new he(`NUMBER(${e.valueOf()})`);if(e instanceof Le)return new Le(e.valueOf(),{...e.opts,...Rl(t,bh)});if(e instanceof Ci)return new Le(e.toNumber(),{...Rl(t,bh)});throw new TypeError("Invalid argument to NUMBER")}var Ef=["dateStyle","timeStyle","fractionalSecondDigits","dayPeriod","hour12","weekday","era","year","month","day","hour","minute","second","timeZoneName"];function wh(n,t){let e=n[0];if(e instanceof he)return new he(`DATETIME(${e.valueOf()})`);if(e instanceof Ci||e instanceof Le)return new Ci(e,Rl(t,Ef));throw new TypeError("Invalid argument to DATETIME")}var Sh=new Map;function Eh(n){let t=Array.isArray(n)?n.join(" "):n,e=Sh.get(t);return e===void 0&&(e=new Map,Sh.set(t,e)),e}var Ls=class{constructor(t,{functions:e,useIsolating:i=!0,transform:s=r=>r}={}){this._terms=new Map,this._messages=new Map,this.locales=Array.isArray(t)?t:[t],this._functions={NUMBER:Mh,DATETIME:wh,...e},this._useIsolating=i,this._transform=s,this._intls=Eh(t)}hasMessage(t){return this._messages.has(t)}getMessage(t){return this._messages.get(t)}addResource(t,{allowOverrides:e=!1}={}){let i=[];for(let s=0;s<t.body.length;s++){let r=t.body[s];if(r.id.startsWith("-")){if(e===!1&&this._terms.has(r.id)){i.push(new Error(`Attempt to override an existing term: "${r.id}"`));continue}this._terms.set(r.id,r)}else{if(e===!1&&this._messages.has(r.id)){i.push(new Error(`Attempt to override an existing message: "${r.id}"`));continue}this._messages.set(r.id,r)}}return i}formatPattern(t,e=null,i=null){if(typeof t=="string")return this._transform(t);let s=new Or(this,i,e);try{return Al(s,t).toString(s)}catch(r){if(s.errors&&r instanceof Error)return s.errors.push(r),new he().toString(s);throw r}}};var Cl=/^(-?[a-zA-Z][\w-]*) *= */gm,Th=/\.([a-zA-Z][\w-]*) *= */y,Tf=/\*?\[/y,Pl=/(-?[0-9]+(?:\.([0-9]+))?)/y,Af=/([a-zA-Z][\w-]*)/y,Ah=/([$-])?([a-zA-Z][\w-]*)(?:\.([a-zA-Z][\w-]*))?/y,Rf=/^[A-Z][A-Z0-9_-]*$/,kr=/([^{}\n\r]+)/y,Cf=/([^\\"\n\r]*)/y,Rh=/\\([\\"])/y,Ch=/\\u([a-fA-F0-9]{4})|\\U([a-fA-F0-9]{6})/y,Pf=/^\n+/,Ph=/ +$/,If=/ *\r?\n/g,Lf=/( *)$/,Df=/{\s*/y,Ih=/\s*}/y,Uf=/\[\s*/y,Nf=/\s*] */y,Ff=/\s*\(\s*/y,Of=/\s*->\s*/y,kf=/\s*:\s*/y,Bf=/\s*,?\s*/y,zf=/\s+/y,Ds=class{constructor(t){this.body=[],Cl.lastIndex=0;let e=0;for(;;){let y=Cl.exec(t);if(y===null)break;e=Cl.lastIndex;try{this.body.push(l(y[1]))}catch(b){if(b instanceof SyntaxError)continue;throw b}}function i(y){return y.lastIndex=e,y.test(t)}function s(y,b){if(t[e]===y)return e++,!0;if(b)throw new b(`Expected ${y}`);return!1}function r(y,b){if(i(y))return e=y.lastIndex,!0;if(b)throw new b(`Expected ${y.toString()}`);return!1}function o(y){y.lastIndex=e;let b=y.exec(t);if(b===null)throw new SyntaxError(`Expected ${y.toString()}`);return e=y.lastIndex,b}function a(y){return o(y)[1]}function l(y){let b=h(),C=c();if(b===null&&Object.keys(C).length===0)throw new SyntaxError("Expected message value or attributes");return{id:y,value:b,attributes:C}}function c(){let y=Object.create(null);for(;i(Th);){let b=a(Th),C=h();if(C===null)throw new SyntaxError("Expected attribute value");y[b]=C}return y}function h(){let y;if(i(kr)&&(y=a(kr)),t[e]==="{"||t[e]==="}")return u(y?[y]:[],1/0);let b=P();return b?y?u([y,b],b.length):(b.value=D(b.value,Pf),u([b],b.length)):y?D(y,Ph):null}function u(y=[],b){for(;;){if(i(kr)){y.push(a(kr));continue}if(t[e]==="{"){y.push(d());continue}if(t[e]==="}")throw new SyntaxError("Unbalanced closing brace");let X=P();if(X){y.push(X),b=Math.min(b,X.length);continue}break}let C=y.length-1,B=y[C];typeof B=="string"&&(y[C]=D(B,Ph));let V=[];for(let X of y)X instanceof Br&&(X=X.value.slice(0,X.value.length-b)),X&&V.push(X);return V}function d(){r(Df,SyntaxError);let y=m();if(r(Ih))return y;if(r(Of)){let b=g();return r(Ih,SyntaxError),{type:"select",selector:y,...b}}throw new SyntaxError("Unclosed placeable")}function m(){if(t[e]==="{")return d();if(i(Ah)){let[,y,b,C=null]=o(Ah);if(y==="$")return{type:"var",name:b};if(r(Ff)){let B=v();if(y==="-")return{type:"term",name:b,attr:C,args:B};if(Rf.test(b))return{type:"func",name:b,args:B};throw new SyntaxError("Function names must be all upper-case")}return y==="-"?{type:"term",name:b,attr:C,args:[]}:{type:"mesg",name:b,attr:C}}return R()}function v(){let y=[];for(;;){switch(t[e]){case")":return e++,y;case void 0:throw new SyntaxError("Unclosed argument list")}y.push(w()),r(Bf)}}function w(){let y=m();return y.type!=="mesg"?y:r(kf)?{type:"narg",name:y.name,value:R()}:y}function g(){let y=[],b=0,C;for(;i(Tf);){s("*")&&(C=b);let B=f(),V=h();if(V===null)throw new SyntaxError("Expected variant value");y[b++]={key:B,value:V}}if(b===0)return null;if(C===void 0)throw new SyntaxError("Expected default variant");return{variants:y,star:C}}function f(){r(Uf,SyntaxError);let y;return i(Pl)?y=T():y={type:"str",value:a(Af)},r(Nf,SyntaxError),y}function R(){if(i(Pl))return T();if(t[e]==='"')return S();throw new SyntaxError("Invalid expression")}function T(){let[,y,b=""]=o(Pl),C=b.length;return{type:"num",value:parseFloat(y),precision:C}}function S(){s('"',SyntaxError);let y="";for(;;){if(y+=a(Cf),t[e]==="\\"){y+=I();continue}if(s('"'))return{type:"str",value:y};throw new SyntaxError("Unclosed string literal")}}function I(){if(i(Rh))return a(Rh);if(i(Ch)){let[,y,b]=o(Ch),C=parseInt(y||b,16);return C<=55295||57344<=C?String.fromCodePoint(C):"\uFFFD"}throw new SyntaxError("Unknown escape sequence")}function P(){let y=e;switch(r(zf),t[e]){case".":case"[":case"*":case"}":case void 0:return!1;case"{":return k(t.slice(y,e))}return t[e-1]===" "?k(t.slice(y,e)):!1}function D(y,b){return y.replace(b,"")}function k(y){let b=y.replace(If,`
`),C=Lf.exec(y)[1].length;return new Br(b,C)}}},Br=class{constructor(t,e){this.value=t,this.length=e}};var Hf=1.5.toLocaleString(document.documentElement.lang)[1],gi=n=>n.replace(".",Hf),Pi=n=>String(n).replace(/\B(?=(\d{3})+(?!\d))/g,"\u202F");function si(n,t=4){return n==null||!(n>0)||!Number.isFinite(n)?t:Math.min(Math.max(1-Math.floor(Math.log10(n)),0),9)}function Ct(n,t){return n==null||!Number.isFinite(n)?"\u2013":gi(n.toFixed(t))}function Et(n,t=3){if(n==null||!Number.isFinite(n))return"\u2013";let e=Math.abs(n);return e!==0&&(e>=1e7||e<1e-6)?gi(n.toExponential(t-1)):gi(e>=10**(t-1)?n.toFixed(0):String(Number(n.toPrecision(t))))}var Te=(n,t)=>t?`${n} ${t}`:n;var zr=class extends Le{constructor(e,i){super(e);this.text=i}toString(){return this.text}},Vf=([n],{digits:t,decimals:e})=>n instanceof Le?new zr(n.value,e?Ct(n.value,Number(e.valueOf())):Et(n.value,t?Number(t.valueOf()):3)):n,Gf=([n])=>`--${String(n)}`,Il=new Ls(document.documentElement.lang,{useIsolating:!1,functions:{NUM:Vf,OPTION:Gf}});Il.addResource(new Ds(JSON.parse(document.getElementById("words").textContent)));function Lh(n,t,e){let i=Il.getMessage(n.replace(".","-")),s=t?i?.attributes[t]:i?.value,r=Object.entries(e).map(([o,a])=>[o,typeof a=="number"?new zr(a,Number.isInteger(a)?Pi(a):Et(a)):a??"\u2013"]);return s?Il.formatPattern(s,Object.fromEntries(r),[]):void 0}var x=(n,t={})=>["","why","do"].map(e=>Lh(n,e,t)).filter(e=>e).join(" ")||n,Fe=(n,t={})=>Lh(n,"title",t)??"",wn=n=>n.replace(/\W+/g,"_");function Dh(){for(let n of document.querySelectorAll("[data-say], [data-label], [data-hint], [data-tip]")){let{say:t,label:e,hint:i,tip:s}=n.dataset;t&&(n.textContent=x(t)),t&&Fe(t)&&(n.title=Fe(t)),e&&n.setAttribute("aria-label",x(e)),i&&n.setAttribute("placeholder",x(i)),s&&(n.title=x(s))}}var ot=n=>document.getElementById(n);function p(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))typeof r=="function"?i.addEventListener(s.slice(2),r):r===!0?i.setAttribute(s,""):r!==!1&&i.setAttribute(s,String(r));return i.append(...e),i}var jt=(n,t,e,i="")=>p("button",{type:"button",title:t,class:i,onclick:e},n),Bt=(n,t,e="",i={})=>jt(x(n,i),Fe(n,i),t,e),De=(n,t=[])=>p("thead",{},p("tr",{},...n.map((e,i)=>p("th",{scope:"col",class:t.includes(i)?"l":"",title:Fe(e)},e&&x(e))))),we=(n,t,e="")=>n.map(i=>p("option",{value:i,selected:i===e},t(i)));function Uh(n){return n instanceof HTMLInputElement?!["checkbox","range","radio","button","file"].includes(n.type):n instanceof HTMLTextAreaElement||n instanceof HTMLSelectElement}function Gi(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function $n(n){let t=!1;return()=>{if(!document.hidden)return n();t||(t=!0,document.addEventListener("visibilitychange",()=>{t=!1,n()},{once:!0}))}}function Oe(n,t){let e=0;return()=>{clearTimeout(e),e=window.setTimeout(n,t)}}var _i=class extends Error{constructor(e,i,s=""){super(i);this.status=e;this.code=s}};function Wf(n,t){let e=new URLSearchParams;for(let[s,r]of Object.entries(t))for(let o of Array.isArray(r)?r:[r])e.append(s,String(o));let i=e.toString();return i?`${n}?${i}`:n}async function Ll(n){let{status:t}=n;try{let{error:e,code:i}=await n.json();return new _i(t,e,i)}catch{return new _i(t,x("studio_page.server_status",{status:t}),"studio_page.server_status")}}async function Ot(n,t={}){let e=await fetch(Wf(n,t));if(!e.ok)throw await Ll(e);return await e.json()}async function Hr(n){let t=await fetch(n);if(!t.ok)throw await Ll(t);return t.arrayBuffer()}async function Ue(n,t){let e=await fetch(n,{method:"POST",headers:{"content-type":"application/json"},body:JSON.stringify(t)});if(!e.ok)throw await Ll(e);return await e.json()}var Xf=["auto","free","held"],qf=["label.parameter","studio_decide.next","studio_decide.last_status","label.value","studio_decide.sigma","label.unit","studio_decide.t","studio_decide.p","studio_decide.effect","studio_decide.effect_sigma","studio_decide.correlation"],Vr=class{constructor(t){this.model=t;this.root=p("section",{class:"leaf","aria-label":x("studio_decide.parameters")});this.box=p("div",{});this.root.append(p("p",{class:"note"},x("studio_decide.parameters_note")),this.box)}async show(){let t=await Ot("/api/parameters"),e=document.activeElement?.id??"",i=t.total>t.interiors.length?[p("p",{class:"note"},x("studio_decide.interiors_shown",{n:t.interiors.length,of:t.total}))]:[];this.box.replaceChildren(...t.interiors.map(s=>this.table(s,t)),...i),e.startsWith("choice-")&&document.getElementById(e)?.focus()}table(t,e){let i=t.image===null?x("studio_decide.camera",{camera:t.camera}):x("studio_decide.camera_image",{camera:t.camera,image:t.image}),s=t.tests.map(r=>p("li",{},x("studio_decide.joint_test",{group:r.group,F:Et(r.F),p:Nh(r.probability)})));return p("div",{class:"card"},p("h3",{},i),p("table",{class:"parameters","aria-label":x("studio_decide.parameters_of",{name:i})},De(qf),p("tbody",{},...t.parameters.map(r=>this.row(t,r,e)))),...s.length?[p("p",{class:"note"},x("studio_decide.joint_tests")),p("ul",{class:"tests"},...s)]:[])}row(t,e,{strong:i,significance:s}){let r=si(e.sigma,6),o=e.correlation,a=o?.with||x("studio_decide.exterior"),l=o?`${Ct(o.value,2)} ${a}`:"\u2013",c=e.probability!==null&&e.probability>s,h=o?.strong?p("span",{class:"flag",title:x("studio_decide.strong",{strong:i})},"\u26A0 "):"";return p("tr",{},p("th",{scope:"row",title:e.meaning},e.symbol),p("td",{class:"l"},this.choice(t,e)),p("td",{class:`l ${e.status==="not determinable"?"doubt":""}`,title:e.remark},x("studio_decide.status",{status:wn(e.status)})),p("td",{},e.sigma===null?Et(e.value,6):Nl(e.value,e.sigma,r)),p("td",{},Dl(e.sigma)),p("td",{class:"l"},Ul(e.unit)),p("td",{},Et(e.t)),p("td",{class:c?"doubt":""},Nh(e.probability)),p("td",{},Et(e.effect_px)),p("td",{},Et(e.effect_sigma_px,2)),p("td",{class:"l",title:o?x("studio_decide.correlated",{other:a}):""},h,l))}choice(t,e){let i=`choice-${t.camera}-${t.image??""}-${e.symbol}`,s=p("select",{id:i,"aria-label":x("studio_decide.choice_of",{symbol:e.symbol,camera:t.camera}),class:e.choice==="auto"?"":"chosen"},...we(Xf,r=>x("studio_decide.choice",{choice:r}),e.choice));return s.addEventListener("change",()=>void this.model.act("parameter",{camera:t.camera,symbol:e.symbol,choice:s.value},"studio_decide.choice_stored",{symbol:e.symbol,camera:t.camera,choice:s.value})),s}},Fh=1e-4,Dl=n=>n!==null&&n>0&&n<Fh?gi(n.toExponential(1)):Et(n,2),Ul=n=>n.replace(/\^(-?\d)/,(t,e)=>[...e].map(i=>i==="-"?"\u207B":"\u2070\xB9\xB2\xB3\u2074\u2075\u2076\u2077\u2078\u2079"[Number(i)]).join(""));function Nl(n,t,e){return n===null?"\u2013":t>0&&t<Fh?gi(n.toExponential(Math.min(Math.max(Math.floor(Math.log10(Math.abs(n)/t))+1,1),8))):Ct(n,e)}var Nh=n=>n===null?"\u2013":n<1e-4?`< ${gi("0.0001")}`:Ct(n,n<.01?4:2);var Yf={good:"good",usable:"remarks"},Gr=class{constructor(t){this.model=t;this.root=p("section",{class:"leaf",tabindex:0,"aria-label":x("studio_decide.calibration")});this.status=p("p",{class:"note",role:"status"});this.box=p("div",{});this.turn=0;this.root.append(this.status,this.box)}async show(){let t=++this.turn;this.status.hidden=!1,this.status.textContent=x("studio_decide.judging");try{let{cameras:e,why:i}=await Ot("/api/calibration");if(t!==this.turn)return;this.status.hidden=!i,this.status.textContent=i,this.box.replaceChildren(...e.map(s=>this.camera(s)))}catch(e){if(t!==this.turn)return;this.status.textContent=e.message,this.box.replaceChildren()}}camera(t){let e=t.verdict;return p("div",{class:"camera"},p("h3",{},x("studio_decide.camera",{camera:t.camera})),p("p",{class:"note"},t.about),...e?this.verdict(t,e):[p("p",{class:"note"},x("studio_decide.no_verdict"))],p("div",{class:"halves"},this.parameters(t),...e?[$f(e)]:[]),p("div",{class:"figures"},...t.figures.map(i=>p("figure",{},p("img",{src:`/figure/calibration/${i.number}.svg?of=${this.model.overview.times}-${this.turn}`,alt:i.caption,loading:"lazy"}),p("figcaption",{},i.caption)))))}verdict(t,e){let i=[p("p",{class:`verdict ${Yf[e.grade]??"attention"}`},e.headline),p("p",{class:"note"},x("studio_decide.verdict_source",{source:t.verdict_is}))];e.reasons.length&&i.push(p("h4",{},x("studio_decide.weaknesses")),p("ul",{class:"reasons"},...e.reasons.map(o=>p("li",{},o))));let s=e.advice[e.advice.length-1],r=s?.ratio&&s.uncertainty_px?s.uncertainty_px/s.ratio:e.uncertainty_px;return e.advice.length?i.push(p("h4",{},x("studio_decide.next_photographs")),p("table",{class:"figures-of","aria-label":x("studio_decide.next_photographs_of",{camera:t.camera})},De(["label.photograph","studio_decide.uncertainty_then","studio_decide.smaller_by"]),p("tbody",{},...e.advice.map((o,a)=>p("tr",{},p("th",{scope:"row"},`${a+1}. ${o.photographs}`),p("td",{},Et(o.uncertainty_px,2)),p("td",{},o.ratio===null||!(o.ratio>0)?"\u2013":`${Math.round(100*(1-o.ratio))} %`))))),p("p",{class:"note"},x("studio_decide.next_photographs_note",{now_px:Et(r,2)}))):i.push(p("p",{class:"note"},x("studio_decide.no_next_photographs"))),i}parameters(t){return p("div",{class:"wide"},p("table",{class:"figures-of","aria-label":x("studio_decide.parameters_of",{name:t.camera})},De(["label.parameter","label.value","label.sigma","label.unit","studio_decide.determinability","label.status"],[3,5]),p("tbody",{},...t.parameters.map(e=>p("tr",{},p("th",{scope:"row"},e.symbol,p("small",{class:"note"},` ${e.meaning}`)),p("td",{},e.sigma===null?Et(e.value,6):Nl(e.value,e.sigma,si(e.sigma,6))),p("td",{},Dl(e.sigma)),p("td",{class:"l"},Ul(e.unit)),p("td",{},Et(e.determinability,2)),p("td",{class:`l ${e.status==="not determinable"?"doubt":""}`},x("studio_decide.status",{status:wn(e.status)})))))))}};function $f(n){let t=i=>i===null?"\u2013":`${Math.round(100*i)} %`,e=[["studio_decide.largest_uncertainty",`${Et(n.uncertainty_px,2)} px`],["studio_decide.median_uncertainty",`${Et(n.typical_uncertainty_px,2)} px`],["studio_decide.image_sigma",`${Et(n.image_sigma_px,2)} px`],["studio_decide.coverage",t(n.coverage)],["studio_decide.reach",t(n.reach)],["label.photographs",String(n.photographs)],["studio_decide.quarter_turns",x("label.n_of",{n:n.rolls,of:4})],["studio_decide.convergence",`${Et(n.convergence_deg,2)}\xB0`],["label.cross_validation",n.cross_validation?x("studio_decide.cross_validation",{rms_px:Et(n.cross_validation.rms_px,2),fit_px:Et(n.cross_validation.fit_px,2)}):"\u2013"]];return p("dl",{class:"facts"},...e.map(([i,s])=>p("div",{},p("dt",{},x(i)),p("dd",{},s))))}function Fl(n){return p("iframe",{class:"page",sandbox:"allow-scripts",referrerpolicy:"no-referrer",title:n})}var Us=n=>`${n.number}: ${x("studio_decide.origin",{origin:n.origin})}`,Wr=class{constructor(){this.root=p("section",{class:"leaf whole","aria-label":x("studio_page.report")});this.select=p("select",{id:"report-of"});this.status=p("p",{class:"note",role:"status"});this.links=p("span",{class:"links"});this.frame=Fl(x("studio_decide.report"));this.at="";this.select.addEventListener("change",()=>void this.show()),this.root.append(p("div",{class:"deeds"},p("label",{for:"report-of"},x("studio_decide.of_adjustment")),this.select,this.links),this.status,this.frame)}async show(){let{adjustments:t}=await Ot("/api/adjustments"),i=this.select.options.length===t.length?Number(this.select.value):t[t.length-1]?.number??-1;this.select.replaceChildren(...t.map(o=>p("option",{value:o.number,selected:o.number===i},Us(o))));let s=t.find(o=>o.number===i),r=s?.report?`/adjustment/${s.number}/report.html`:"";this.select.disabled=!t.length,this.frame.hidden=!r,this.status.textContent=s?r?"":x("studio_decide.no_report"):x("studio_decide.not_adjusted"),this.status.hidden=!this.status.textContent,this.links.replaceChildren(...r?[Oh(x("studio_decide.window"),r)]:[],...s?.network?[Oh(x("studio_decide.network"),`/adjustment/${s.number}/network.html`)]:[]),r&&r!==this.at&&(this.frame.src=r),this.at=r}},Oh=(n,t)=>p("a",{href:t,target:"_blank",rel:"noopener"},n);var Xr=class{constructor(t,e){this.model=t;this.ways=e;this.root=p("section",{class:"leaf whole","aria-label":x("studio_decide.compare")});this.body=p("tbody",{});this.worst=p("div",{class:"beside"});this.status=p("p",{class:"note",role:"status"});this.frame=Fl(x("studio_decide.comparison"));this.adjustments=[];this.pair=[-1,-1];this.at="";this.root.append(p("table",{class:"adjustments","aria-label":x("studio_decide.adjustments")},De(["studio_decide.first","studio_decide.second","studio_decide.adjustment","studio_decide.sigma0","label.redundancy","label.rejected","studio_decide.free","studio_decide.mean_sigma","studio_decide.rms_check"]),this.body),this.worst,this.status,this.frame)}async show(){let t=this.adjustments.length?this.adjustments[this.adjustments.length-1].number:-1;this.adjustments=(await Ot("/api/adjustments")).adjustments;let e=this.adjustments.map(i=>i.number);(e[e.length-1]!==t||!this.pair.every(i=>e.includes(i)))&&(this.pair=[e[e.length-2]??-1,e[e.length-1]??-1]),this.body.replaceChildren(...this.adjustments.map(i=>this.row(i))),this.compare()}row(t){let e=t.check.points?t.check.rms.map(s=>Et(s,2)).join(", "):"\u2013",i=t.parameters.filter(s=>s.sigma!==null).length;return p("tr",{},p("td",{},this.radio(0,t)),p("td",{},this.radio(1,t)),p("th",{scope:"row"},Us(t),p("small",{class:"note",title:t.options.join(" ")},t.options.join(" ")||x("studio_decide.defaults"))),p("td",{},Ct(t.sigma0,4)),p("td",{},t.redundancy===null?"\u2013":Pi(t.redundancy)),p("td",{},t.rejected===null?"\u2013":Pi(t.rejected)),p("td",{},String(i)),p("td",{},Te(Et(t.mean_std,2),t.unit)),p("td",{},t.check.points?Te(e,t.unit):e))}radio(t,e){let i=t?"second":"first",s=p("input",{type:"radio",name:`compare-${i}`,id:`compare-${i}-${e.number}`,checked:this.pair[t]===e.number,"aria-label":x("studio_decide.as_side",{name:Us(e),side:i})});return s.addEventListener("change",()=>{this.pair[t]=e.number,this.compare()}),s}compare(){let t=this.pair.map(o=>this.adjustments.find(a=>a.number===o)),[e,i]=t,s=e!==void 0&&i!==void 0&&e!==i;this.status.textContent=s?"":this.adjustments.length<2?x("studio_decide.adjust_again"):x("studio_decide.choose_two"),this.status.hidden=s,this.worst.replaceChildren(...t.filter(o=>o!==void 0).filter((o,a,l)=>l.indexOf(o)===a).map(o=>this.largest(o)));let r=s?`/comparison/${e.number}/${i.number}`:"";this.frame.hidden=!s,s&&r!==this.at&&(this.frame.src=r),this.at=r}largest(t){let e=x("studio_decide.largest_residuals",{name:Us(t)});return p("div",{},p("h3",{},e),p("table",{"aria-label":e},De(["studio_table.observation","studio_table.w","studio_decide.v"]),p("tbody",{},...t.worst.map(i=>p("tr",{},p("td",{class:"l"},jt(x("studio_decide.point_in_image",{...i}),x("studio_decide.show_point",{...i}),()=>this.visit(i.point,i.image),"link")),p("td",{},Ct(i.w,2)),p("td",{},Ct(i.v_px,2)))))))}visit(t,e){this.model.images.has(e)&&this.ways.visit(t,e)}};var nn=class{constructor(t,e){this.prefix=t;this.root=p("form",{class:"options"});this.inputs=new Map;this.root.addEventListener("submit",i=>i.preventDefault()),this.root.addEventListener("change",()=>e(this.values()))}values(){let t={};for(let[e,[i,s]]of this.inputs)i.kind==="flag"?t[e]=s.checked:i.kind==="number"?t[e]=s.value.trim()?Number(s.value.replace(",",".")):i.default:t[e]=s.value;return t}fill(t){this.inputs.size||this.root.append(...t.map(e=>this.row(e)));for(let{name:e,value:i,default:s}of t){let[r,o]=this.inputs.get(e);r.kind==="flag"?o.checked=i===!0:(document.activeElement!==o||o instanceof HTMLSelectElement)&&(o.value=i===null?"":String(i)),o.closest(".option").classList.toggle("changed",i!==s)}}row(t){let e=`${this.prefix}-${t.name}`,i={id:e,name:t.name,"aria-describedby":`${e}-help`,title:t.help},s;return t.kind==="choice"?s=p("select",i,...we(t.choices,r=>r.replace("_"," ")||"\u2013")):t.kind==="flag"?s=p("input",{...i,type:"checkbox"}):t.kind==="number"?s=p("input",{...i,type:"number",min:t.low??"",max:t.high??"",step:t.whole?1:"any",placeholder:t.metavar}):s=p("input",{...i,type:"text",placeholder:t.metavar,autocomplete:"off",spellcheck:"false"}),this.inputs.set(t.name,[t,s]),p("div",{class:"option"},p("label",{for:e},t.flag.replace(/^--/,"").replace(/-/g," ")),s,p("p",{class:"note",id:`${e}-help`},t.help))}};var qr=class{constructor(t){this.model=t;this.root=p("section",{class:"leaf","aria-label":x("studio_decide.options")});this.form=new nn("option",t=>void this.send(t));this.command=p("code",{class:"command"});let e=Bt("studio_decide.adjust",()=>ot("adjust").click(),"main");e.id="options-adjust";let i=Bt("studio_decide.reset",()=>void this.send({}));i.id="options-usual",this.root.append(p("p",{class:"note"},x("studio_decide.options_note")),this.form.root,p("div",{class:"deeds"},e,i),p("h3",{},x("studio_decide.command")),p("p",{},this.command))}async show(){this.fill(await Ot("/api/options"))}async send(t){try{this.fill(await Ue("/api/options",{values:t})),this.model.say("studio_decide.options_stored",{},"good")}catch(e){this.model.fail(e)}}fill({fields:t,command:e}){this.form.fill(t),this.command.textContent=e}};var $r=class{constructor(t){this.model=t;this.root=p("section",{class:"leaf","aria-label":x("studio_run.title")});this.form=new nn("run",t=>void this.send(t));this.command=p("code",{class:"command"});this.why=p("p",{class:"note"});this.go=Bt("studio_run.begin",()=>void this.begin(),"main",{name:""});this.stop=Bt("studio_run.stop",()=>ot("stop").click());this.usual=Bt("studio_decide.reset",()=>void this.send({}));this.status=p("p",{class:"counts",role:"status","aria-live":"polite"});this.bar=p("progress",{max:1,value:0,"aria-label":x("studio_run.progress")});this.body=p("tbody",{});this.table=p("table",{class:"stages","aria-label":x("studio_run.stages")},De(["studio_run.stage","studio_run.state","label.time","label.result"]),this.body);this.words=p("pre",{class:"printed",tabindex:0,"aria-label":x("studio_run.output")});this.go.id="run-begin",this.stop.id="run-stop",this.usual.id="run-usual",this.settings=p("div",{},p("h3",{},x("studio_decide.command")),p("p",{},this.command),p("h3",{},x("studio_run.settings")),p("p",{class:"note"},x("studio_run.settings_note")),this.form.root),this.root.append(this.why,p("div",{class:"deeds first"},this.go,this.stop,this.usual),this.status,this.bar,this.table,this.words,this.settings),t.on("run",()=>this.run(t.run))}async show(){this.take(await Ot("/api/run"))}take({form:t,why:e,run:i}){this.why.textContent=e,this.why.hidden=!e,this.settings.hidden=this.usual.hidden=this.go.hidden=!t,t&&(this.form.fill(t.fields),this.command.textContent=t.command,this.go.textContent=x("studio_run.begin",{name:t.name})),this.model.run=i,this.run(i)}async send(t){try{this.take(await Ue("/api/run/settings",{values:t})),this.model.say("studio_run.settings_stored",{},"good")}catch(e){this.model.fail(e)}}async begin(){try{this.take(await Ue("/api/run",{})),this.model.say("studio_run.begun")}catch(t){this.model.fail(t)}}run(t){let e=t?.outcome==="running";this.go.disabled=e,this.stop.disabled=!e,this.bar.hidden=!e,this.status.hidden=this.table.hidden=!t,this.words.hidden=!t?.words,t&&(this.bar.value=t.share,this.status.textContent=Zf(t),this.body.replaceChildren(...t.stages.map(Kf)),this.words.textContent=t.words,this.words.classList.toggle("bad",t.outcome==="failed"))}};function Zf(n){if(n.outcome!=="running")return x("studio_run.ended",{outcome:n.outcome,time:Yr(n.seconds)});let t=Ns(n.step);if(n.stopping)return x("studio_run.stopping",{step:t});let e=n.left_s===null?"none":Yr(n.left_s);return x("studio_run.going",{step:t,percent:Math.round(100*n.share),rest:e,time:Yr(n.seconds)})}var Ns=n=>x("studio_run.stage_name",{stage:wn(n.split(":")[0]),name:n}),Kf=n=>p("tr",{class:n.state.replace(" ","-")},p("th",{scope:"row"},Ns(n.title)),p("td",{class:"l"},x("studio_run.stage_state",{state:wn(n.state)})),p("td",{},n.seconds===null?"\u2013":Yr(n.seconds)),p("td",{class:"l"},n.summary));function Yr(n){return n<9.95?`${Ct(n,1)} s`:n<120?`${Math.round(n)} s`:n<7200?`${Math.round(n/60)} min`:`${Ct(n/3600,1)} h`}var Ol=class{constructor(){this.images=new Map;this.points=new Set;this.listeners=[]}onchange(t){this.listeners.push(t)}show(t){this.images=new Map,this.points=new Set;for(let[e,i]of t){this.points.add(i);let s=this.images.get(e);s?s.add(i):this.images.set(e,new Set([i]))}for(let e of this.listeners)e()}has(t,e){return this.images.get(t)?.has(e)??!1}get worstImage(){let t="";for(let[e,i]of this.images)i.size>(this.images.get(t)?.size??0)&&(t=e);return t}},Qe=new Ol;var kl=1e3,jf=60,Zr=class{constructor(t,e){this.model=t;this.ways=e;this.root=p("section",{class:"leaf","aria-label":x("studio_decide.select")});this.kinds=p("fieldset",{class:"kinds"},p("legend",{},x("studio_decide.observations_by")));this.slider=p("input",{type:"range",id:"select-slider",min:0,max:kl,value:0,"aria-label":x("studio_decide.limit")});this.limit=p("input",{type:"text",id:"select-limit",inputmode:"decimal",autocomplete:"off"});this.unit=p("span",{class:"note"});this.words=p("p",{class:"note"});this.counts=p("p",{class:"counts",role:"status","aria-live":"polite"});this.hand=p("p",{class:"note"});this.command=p("code",{class:"command"});this.list=p("div",{class:"found",tabindex:0,role:"region","aria-label":x("studio_decide.beyond")});this.draw=p("input",{type:"checkbox",id:"select-draw"});this.criteria=[];this.by="w";this.limits=new Map;this.turn=0;this.soon=Oe(()=>void this.count(),50);this.reject=Bt("studio_decide.reject_all",()=>void this.rejectAll(),"main"),this.reject.id="select-reject",this.slider.disabled=this.limit.disabled=!0,this.shows=[Bt("studio_decide.show_in_images",()=>this.drawn(()=>e.images(Qe.worstImage))),Bt("studio_decide.show_in_space",()=>this.drawn(()=>e.space()))],this.draw.addEventListener("change",()=>void this.count()),t.on(["read","state"],()=>this.draw.checked&&void this.count()),this.slider.addEventListener("input",()=>this.moved()),this.limit.addEventListener("change",()=>this.setLimit()),this.root.append(this.kinds,this.words,p("div",{class:"limit"},p("label",{for:"select-limit"},x("studio_decide.limit")),this.slider,this.limit,this.unit),this.counts,this.hand,p("div",{class:"deeds"},this.reject,...this.shows,p("label",{class:"row"},this.draw,x("studio_decide.draw"))),p("h3",{},x("studio_decide.command")),p("p",{},this.command),this.list)}async show(){this.criteria=(await Ot("/api/criteria")).criteria,this.kinds.childElementCount<2&&this.kinds.append(...this.criteria.map(t=>this.kind(t)));for(let t of this.criteria)this.limits.has(t.name)||this.limits.set(t.name,Number(t.begin.toPrecision(3)));this.slider.disabled=this.limit.disabled=!1,this.take()}kind(t){let e=p("input",{type:"radio",name:"select-by",id:`select-${t.name}`,value:t.name,checked:t.name===this.by});return e.addEventListener("change",()=>{this.by=t.name,this.take()}),p("label",{title:x("studio_decide.quantity_meaning",{quantity:t.name})},e,x("studio_decide.quantity",{quantity:t.name}))}get criterion(){return this.criteria.find(t=>t.name===this.by)}at(t){let e=this.criterion,i=t/kl;if(e.whole)return Math.round(2+i*Math.max(e.high-2,1));if(e.name==="redundancy")return Number((i*Math.min(e.high,1)).toPrecision(3));let s=Math.max(e.middle,e.high/1e4)||1e-9;return Number((s*(Math.max(e.high,s)/s)**i).toPrecision(3))}step(t){let e=0;for(let i=0;i<=kl;i+=5)Math.abs(this.at(i)-t)<Math.abs(this.at(e)-t)&&(e=i);return e}take(){let t=this.criterion,[e,i,s]=[t.low,t.high,t.middle].map(a=>Te(Et(a),t.unit)),r=t.above?"above":"below",o=t.known?x("studio_decide.range",{low:e,high:i,middle:s}):x("studio_decide.no_range");this.words.textContent=[x("studio_decide.quantity_meaning",{quantity:t.name}),o,x("studio_decide.selected",{side:r})].join(" "),this.limit.value=String(this.limits.get(this.by)),this.slider.value=String(this.step(this.limits.get(this.by))),this.slider.setAttribute("aria-valuetext",this.limit.value),this.unit.textContent=t.unit,this.count()}moved(){let t=this.at(Number(this.slider.value));this.limits.set(this.by,t),this.limit.value=String(t),this.slider.setAttribute("aria-valuetext",Te(String(t),this.criterion.unit)),this.soon()}setLimit(){let t=this.limit.value.trim()?Number(this.limit.value.replace(",",".")):NaN;if(!(t>=0))return this.model.say("studio_point.number_missing",{field:x("studio_decide.limit")},"bad");this.limits.set(this.by,t),this.slider.value=String(this.step(t)),this.count()}drawn(t){this.draw.checked=!0,this.count().then(t)}async count(){let t=++this.turn;this.reject.disabled=!0,this.counts.setAttribute("aria-busy","true");try{let e=await Ot("/api/selection",{by:this.by,limit:this.limits.get(this.by)});t===this.turn&&this.report(e)}catch(e){this.model.fail(e)}}report(t){Qe.show(this.draw.checked?t.rows:[]);let e=t.used?100*t.observations/t.used:0;this.counts.setAttribute("aria-busy","false"),this.counts.textContent=x("studio_decide.counts",{n:t.observations,points:t.points,percent:Et(e,2),used:t.used}),this.hand.textContent=t.marks?x("studio_decide.marks_beyond",{n:t.marks}):"",this.command.textContent=t.command,this.reject.disabled=!t.observations,this.shows.forEach(r=>r.disabled=!t.observations);let i=t.rows.slice(0,jf).map(([r,o])=>p("li",{},jt(x("studio_decide.point_in_image",{point:o,image:r}),x("studio_decide.show_point",{point:o,image:r}),()=>this.ways.visit(o,r),"link"))),s=t.observations-i.length;this.list.hidden=!i.length,this.list.replaceChildren(p("ul",{},...i),...s>0?[p("p",{class:"note"},x("studio_decide.more",{n:s,drawn:t.all_shown?"all":"some"}))]:[])}async rejectAll(){this.reject.disabled=!0;let t=this.limits.get(this.by);try{let e=await this.model.actions.reject(this.by,t);this.model.command=e.command,this.model.take(e.state),this.model.say("studio_decide.rejected",{limit:Et(t),quantity:this.by},"good")}catch(e){this.model.fail(e),await this.count()}}};var Xt={brightness:1,contrast:1,vectors:40,filter:"worst",loupe:!1,linked:!0,snap:"auto"},Fs=["auto","ellipse","corner","cross","patch","hand"],ie={used:"#56b4e9",weak:"#e69f00",rejected:"#d55e00",control:"#f0e442",check:"#2fc79a",mark:"#f5a3cf",current:"#ffffff",predicted:"#f0e442",beyond:"#ff5ad1",masked:"#ff7f2a",off:"#ff3b30"},Bl=()=>Xt.brightness===1&&Xt.contrast===1?"none":`brightness(${Xt.brightness}) contrast(${Xt.contrast})`;var Jf=20,zl=2*Math.PI;function Kr(n,t,e){return n.rejected[t]||e.has(n.point[t])?"rejected":n.role[t]===1?"control":n.role[t]===2?"check":n.rays[t]<3?"weak":"used"}function Hl(n,t,e){let i=[...n.x.keys()];if(t==="none")return[];if(t==="worst")return i.filter(r=>n.w[r]!==null).sort((r,o)=>n.w[o]-n.w[r]).slice(0,Jf);if(t==="all")return i;let s=t==="control"?["control","check"]:[t];return i.filter(r=>s.includes(Kr(n,r,e)))}function kh(n,t,e,i,s,r=9){let o=-1,a=r;for(let l of t){let[c,h]=e.toScreen(n.x[l],n.y[l]),u=Math.hypot(c-i,h-s);u<a&&(a=u,o=l)}return o}function Bh(n,t,e,i){n.setTransform(i,0,0,i,0,0);let{observations:s}=e;if(s){let r=Hl(s,Xt.filter,e.rejectedHere);Qf(n,t,s,r),ep(n,t,s,r,e),ip(n,t,s,e.image)}e.prediction&&rp(n,t,e.prediction,e.current);for(let r of e.marks)np(n,t,r,r.mark.point===e.current,e.off);for(let r of e.fiducials)sp(n,t,r,r.name===e.fiducial);e.hair&&ap(n,t)}function Qf(n,t,e,i){if(Xt.vectors<=0)return;let s=Xt.vectors/t.scale;for(let[r,o]of[["#00000099",2.8],[ie.used,1.3]]){n.strokeStyle=r,n.lineWidth=o,n.beginPath();for(let a of i){let l=e.vx[a],c=e.vy[a];l===null||c===null||(n.moveTo(...t.toScreen(e.x[a],e.y[a])),n.lineTo(...t.toScreen(e.x[a]+l*s,e.y[a]+c*s)))}n.stroke()}}function tp(n,t,e,i,s){let r=t==="control"||t==="check"?6:s;t==="rejected"?(n.moveTo(e-r,i-r),n.lineTo(e+r,i+r),n.moveTo(e+r,i-r),n.lineTo(e-r,i+r)):t==="control"?(n.moveTo(e,i-r),n.lineTo(e+r,i+.75*r),n.lineTo(e-r,i+.75*r),n.closePath()):t==="check"?(n.moveTo(e,i-r),n.lineTo(e+r,i),n.lineTo(e,i+r),n.lineTo(e-r,i),n.closePath()):t==="weak"?n.rect(e-r,i-r,2*r,2*r):(n.moveTo(e+r,i),n.arc(e,i,r,0,zl))}function ep(n,t,e,i,s){let r=Math.min(Math.max(2.6*Math.sqrt(t.scale),1.6),4);for(let o of["used","weak","rejected","check","control"]){n.beginPath();for(let a of i){if(Kr(e,a,s.rejectedHere)!==o)continue;let[l,c]=t.toScreen(e.x[a],e.y[a]);l<-9||c<-9||l>t.width+9||c>t.height+9||tp(n,o,l,c,r)}n.lineWidth=r<2.5?2.2:3,n.strokeStyle="#000000a0",n.stroke(),n.lineWidth=r<2.5?1.2:1.6,n.strokeStyle=ie[o],n.stroke()}if(s.hover>=0&&s.hover<e.x.length){let[o,a]=t.toScreen(e.x[s.hover],e.y[s.hover]);Os(n,o,a,9,"#ffffff")}}function ip(n,t,e,i){if(Qe.points.size)for(let[s,r]of e.point.entries()){if(!Qe.has(i,r))continue;let[o,a]=t.toScreen(e.x[s],e.y[s]);o<-16||a<-16||o>t.width+16||a>t.height+16||Os(n,o,a,8,ie.beyond)}}function Os(n,t,e,i,s){n.beginPath(),n.arc(t,e,i,0,zl),Wi(n,s,1.6)}function Wi(n,t,e){n.lineWidth=e+2,n.strokeStyle="#000000b0",n.stroke(),n.lineWidth=e,n.strokeStyle=t,n.stroke()}function np(n,t,{mark:e,x:i,y:s},r,o){let[a,l]=t.toScreen(i,s),c=r?11:8,h=r&&o?ie.off:r?ie.current:ie.mark;n.beginPath();for(let[u,d]of[[1,0],[-1,0],[0,1],[0,-1]])n.moveTo(a+2.5*u,l+2.5*d),n.lineTo(a+c*u,l+c*d);Wi(n,h,r?2:1.6),r&&Os(n,a,l,14,o?ie.off:ie.mark),ks(n,r&&o?`${e.point} !`:e.point,a+c+4,l-7,h)}function sp(n,t,e,i){let[s,r]=t.toScreen(e.x,e.y),o=i?ie.current:ie.control;n.beginPath(),n.rect(s-9,r-9,18,18);for(let[a,l]of[[1,0],[-1,0],[0,1],[0,-1]])n.moveTo(s+3*a,r+3*l),n.lineTo(s+9*a,r+9*l);Wi(n,o,1.6),ks(n,e.name,s+14,r-7,o)}function ks(n,t,e,i,s){n.font="600 12.5px system-ui, 'Noto Sans', 'Liberation Sans', sans-serif",n.textBaseline="middle",n.lineJoin="round",n.lineWidth=3.5,n.strokeStyle="#000000c8",n.strokeText(t,e,i),n.fillStyle=s,n.fillText(t,e,i)}function rp(n,t,e,i){if(e.segment&&op(n,t,e),e.x===null||e.y===null)return;let[s,r]=t.toScreen(e.x,e.y),o=Math.atan2(t.sin,t.cos);if(e.ellipse){let a=e.ellipse.angle_deg*Math.PI/180+o;for(let l of[1,3])n.beginPath(),n.setLineDash(l===3?[5,4]:[]),n.ellipse(s,r,l*e.ellipse.a*t.scale,l*e.ellipse.b*t.scale,a,0,zl),Wi(n,ie.predicted,1.4);n.setLineDash([])}Os(n,s,r,3,ie.predicted),(!e.ellipse||e.ellipse.a*t.scale<12)&&(n.setLineDash([3,4]),Os(n,s,r,20,ie.predicted),n.setLineDash([])),ks(n,`${i} ?`,s+16,r+17,ie.predicted)}function op(n,t,e){n.beginPath(),e.segment.forEach(([i,s],r)=>r?n.lineTo(...t.toScreen(i,s)):n.moveTo(...t.toScreen(i,s))),n.lineJoin="round",e.segment_sigma_px!==null&&(n.lineWidth=Math.max(6*e.segment_sigma_px*t.scale,2),n.strokeStyle="#f0e44238",n.stroke()),Wi(n,ie.predicted,1.2)}function ap(n,t){let[e,i]=[t.width/2,t.height/2];n.beginPath();for(let[s,r]of[[1,0],[-1,0],[0,1],[0,-1]])n.moveTo(e+5*s,i+5*r),n.lineTo(e+26*s,i+26*r);Wi(n,"#ffffff",1.2)}var lp=2*Math.PI,cp=400,hp=5,Zn=[["used",ie.used,"\u25EF"],["rejected",ie.rejected,"\u2297"],["apart",ie.check,"\u25CC"],["unidentified",ie.weak,"\u25CD"]],up={used:[],rejected:[],apart:[6,4],unidentified:[2,3]};function Hh(n,t,e){let i=Math.atan2(t.sin,t.cos),s=e.rows.filter(o=>{let[a,l]=t.toScreen(o.x,o.y);return a>-40&&l>-40&&a<t.width+40&&l<t.height+40});for(let[o,a]of Zn)for(let l of s.filter(c=>c.fate===o))dp(n,t,l,a,i);let r=[];for(let[o,a]of Zn)for(let l of s.filter(c=>c.fate===o)){let[c,h]=t.toScreen(l.x,l.y),u=t.scale>1.5&&l.s!==null?` \xB1 ${Ct(l.s,3)} px`:"",d=`${l.name}${u}`,m=Vh(l,t)+9;d&&r.length<cp&&fp(r,[c-5,h-m-7,7.6*d.length,14])&&ks(n,d,c-5,h-m,a)}}var Vh=(n,t)=>Math.max((n.ellipse?.a??0)*t.scale,hp);function dp(n,t,e,i,s){let[r,o]=t.toScreen(e.x,e.y),a=Vh(e,t);n.setLineDash(up[e.fate]),n.beginPath(),e.ellipse?n.ellipse(r,o,a,a*e.ellipse.b/e.ellipse.a,e.ellipse.angle_deg*Math.PI/180+s,0,lp):n.rect(r-a,o-a,2*a,2*a),Wi(n,i,1.8),n.setLineDash([]),e.fate==="rejected"?zh(n,r,o,a+3,i):t.scale>1&&zh(n,r,o,3,i)}function fp(n,t){let[e,i,s,r]=t;return n.some(([o,a,l,c])=>e<o+l&&o<e+s&&i<a+c&&a<i+r)?!1:(n.push(t),!0)}function zh(n,t,e,i,s){n.beginPath(),n.moveTo(t-i,e-i),n.lineTo(t+i,e+i),n.moveTo(t+i,e-i),n.lineTo(t-i,e+i),Wi(n,s,1.2)}var Vl=class{constructor(){this.on=!1;this.families=null;this.reason="";this.found=new Map;this.requested=new Set;this.sought=new Set;this.listeners=[]}onchange(t){this.listeners.push(t)}changed(){this.listeners.forEach(t=>t())}switch(t){this.on=t,this.changed()}choose(t){t!==this.families&&(this.families=t,this.forget())}get query(){return this.families===null?{}:{families:this.families}}forget(){this.found.clear(),this.requested.clear(),this.changed()}of(t){let e=this.found.get(t);return!e&&!this.requested.has(t)&&this.read(t),e??null}async read(t){this.requested.add(t);try{let e=await Ot("/api/targets/image",{image:t,...this.query});this.found.set(t,e),this.reason=e.why||(e.families?"":x("studio_target.name_family"));let i=`${t} ${e.families}`;!e.from&&!e.why&&e.families&&!this.sought.has(i)&&(this.sought.add(i),await Ue("/api/targets",{families:e.families,images:[t]}))}catch(e){this.reason=e.message}this.changed()}},Se=new Vl;var Gh=["label.image","studio_target.found","studio_target.used","studio_target.rejected","studio_target.apart","studio_target.unidentified","studio_target.median_sigma","studio_target.source"],jr=class{constructor(t,e){this.model=t;this.ways=e;this.root=p("section",{class:"leaf","aria-label":x("studio_decide.targets")});this.family=p("input",{type:"text",id:"targets-family",list:"targets-known",placeholder:x("studio_target.family"),autocomplete:"off",spellcheck:"false"});this.known=p("datalist",{id:"targets-known"});this.forms=p("p",{class:"note"});this.go=Bt("studio_target.find",()=>void this.begin(),"main");this.status=p("p",{class:"note",role:"status"});this.body=p("tbody",{});this.one=p("div",{});this.sheet=new nn("sheet",()=>{});this.command=p("code",{class:"command"});this.files=p("span",{class:"links"});this.go.id="targets-begin";let i=Bt("studio_target.make_sheet",()=>void this.print(),"main");i.id="sheet-make",this.family.addEventListener("change",()=>{Se.choose(this.family.value.trim()),this.show()}),this.root.append(p("div",{class:"deeds first"},p("label",{for:"targets-family"},x("studio_target.family")),this.family,this.known,this.go),this.forms,this.status,p("table",{class:"figures-of","aria-label":x("studio_target.by_photograph"),id:"targets-by-photograph"},De(Gh,[Gh.length-1]),this.body),this.one,p("h3",{},x("studio_target.sheet")),p("p",{class:"note"},x("studio_target.sheet_note")),this.sheet.root,p("div",{class:"deeds"},i,this.files),p("p",{},this.command)),Se.onchange(()=>this.root.offsetParent&&void this.details())}async show(){let[t,e]=await Promise.all([Ot("/api/targets",Se.query),Ot("/api/sheet")]);document.activeElement!==this.family&&(this.family.value=t.families),this.known.replaceChildren(...t.known.map(s=>p("option",{value:s}))),this.forms.textContent=x("studio_target.families",{names:t.forms.join("; ")}),this.go.disabled=!t.families;let i=t.images.every(s=>s.found===null);this.status.textContent=t.families?i?x("studio_target.none_stored"):"":x("studio_target.family_missing"),this.status.hidden=!this.status.textContent,this.body.replaceChildren(...t.images.map(s=>this.row(s))),this.take(e),await this.details()}row(t){let e=t.why||t.remarks.join("; ");return p("tr",{},p("th",{scope:"row"},jt(t.image,x("studio_target.show",{image:t.image}),()=>this.look(t.image),"link")),p("td",{},t.found===null?"\u2013":String(t.found)),...Zn.map(([i])=>p("td",{},t.found===null?"\u2013":String(t.fates[i]??0))),p("td",{},Ct(t.median_s,3)),p("td",{class:`l ${t.why?"doubt":""}`},[t.from&&x("studio_target.origin",{origin:t.from}),e].filter(i=>i).join("; ")||x("studio_target.not_found")))}look(t){Se.switch(!0),this.ways.images(t)}async details(){let t=this.model.panes[this.model.active];if(!t)return;let e=await Ot("/api/targets/image",{image:t,...Se.query}),i=e.rows.slice(0,500).map(s=>p("tr",{},p("th",{scope:"row"},s.name||"\u2013"),p("td",{},Ct(s.x,2)),p("td",{},Ct(s.y,2)),p("td",{},Ct(s.s,3)),p("td",{},s.ellipse?Ct(s.ellipse.a,2):"\u2013"),p("td",{},s.ellipse?Ct(s.ellipse.b,2):"\u2013"),p("td",{class:"l"},x("studio_target.fate",{fate:s.fate}))));this.one.replaceChildren(...i.length?[p("details",{},p("summary",{},x("studio_target.of_image",{image:t,n:e.rows.length})),p("table",{class:"figures-of","aria-label":x("studio_target.of_image",{image:t,n:e.rows.length})},De(["label.name","studio_table.x","studio_table.y","studio_target.sigma","studio_target.semi_axis_a","studio_target.semi_axis_b","label.status"],[6]),p("tbody",{},...i)))]:[])}async begin(){try{await Ue("/api/targets",{families:this.family.value.trim(),images:[]}),this.model.say("studio_target.finding")}catch(t){this.model.fail(t)}}async print(){try{let t=Object.fromEntries(Object.entries(this.sheet.values()).filter(([,e])=>e!==null));this.take(await Ue("/api/sheet",{values:t})),this.model.say("studio_target.sheet_made",{},"good")}catch(t){this.model.fail(t)}}take(t){this.sheet.fill(t.fields),this.command.textContent=t.command,this.files.replaceChildren(...t.files.map(e=>p("a",{href:`/sheet/${e}`,download:e},e)))}};var Jr=class{constructor(t,e,i){this.model=t;this.isOpen=e;this.now=0;this.leaves=[["run","studio_decide.run",new $r(t)],["options","studio_decide.options",new qr(t)],["parameters","studio_decide.parameters",new Vr(t)],["select","studio_decide.select",new Zr(t,i)],["compare","studio_decide.compare",new Xr(t,i)],["calibration","studio_decide.calibration",new Gr(t)],["targets","studio_decide.targets",new jr(t,i)],["report","studio_page.report",new Wr]],this.heads=this.leaves.map(([s,r],o)=>{let a=Bt(r,()=>this.turn(o));return a.id=`decide-${s}`,a}),ot("decide-bar").append(p("span",{class:"group",role:"group","aria-label":x("studio_decide.parts")},...this.heads)),ot("decide").append(...this.leaves.map(([,,s])=>s.root)),this.turn(1),t.on(["read","state","targets"],()=>this.isOpen()&&this.show())}turn(t){this.now=t,this.heads.forEach((e,i)=>e.setAttribute("aria-pressed",String(i===t))),this.leaves.forEach(([,,e],i)=>e.root.hidden=i!==t),this.isOpen()&&this.show()}show(){this.leaves[this.now][2].show().catch(t=>this.model.fail(t))}};var pp=9,Gl=class{constructor(){this.on=!1;this.image="";this.corners=[];this.calls=[]}onchange(t){this.calls.push(t)}begin(t="",e=[]){this.on=!0,this.image=t,this.set(e)}end(){this.on=!1,this.image="",this.set([])}add(t,e){return this.image&&t!==this.image?!1:(this.image=t,this.set([...this.corners,e]),!0)}move(t,e){this.set(this.corners.map((i,s)=>s===t?e:i))}removeLast(){this.set(this.corners.slice(0,-1)),this.corners.length||(this.image="")}cornerAt(t,e,i,s){return!this.on||t!==this.image?-1:this.corners.findIndex(([r,o])=>{let[a,l]=e.toScreen(r,o);return Math.hypot(a-i,l-s)<pp})}set(t){this.corners=t;for(let e of this.calls)e()}},Zt=new Gl;var Qr=class{constructor(t){this.model=t;this.rows=p("table",{"aria-label":x("studio_point.fiducials")});this.head=p("summary",{},x("studio_point.fiducials"));this.about=p("p",{class:"note"});this.card=p("details",{class:"card",id:"fiducials",open:!0,hidden:!0},this.head,this.about,this.rows,Bt("studio_point.find_fiducials",()=>void this.find()));ot("right").prepend(this.card),t.on(["state","overview","panes","fiducial"],()=>this.show())}async find(){let{model:t}=this,e=t.panes[t.active];try{let i=await t.actions.fiducials(e);t.take(i.state);let s=Object.entries(i.left).map(([r,o])=>`${r}: ${o}`);t.show([x("studio_point.fiducials_found",{n:i.found.length}),...s].join("; "),s.length?"bad":"good","studio_point.fiducials_found"),t.chooseFiducial("")}catch(i){t.fail(i)}}show(){let{model:t}=this,e=t.overview.fiducials;this.card.hidden=!e.length;let i=t.panes[t.active];if(!e.length||!i)return;let s=new Map(t.fiducialsIn(i).map(r=>[r.name,r]));this.head.textContent=x("studio_point.fiducials_of",{image:i,n:s.size,of:e.length}),this.about.textContent=t.fiducial?x("studio_point.click_fiducial",{name:t.fiducial}):x("studio_point.fiducials_note"),this.rows.replaceChildren(...e.map(r=>{let o=s.get(r),a=jt(r,x("studio_point.measure",{name:r}),()=>t.chooseFiducial(t.fiducial===r?"":r),"link");a.setAttribute("aria-pressed",String(t.fiducial===r));let l=()=>void t.act("fiducial",{image:i,name:r},"studio_point.removed",{name:r});return p("tr",{class:t.fiducial===r?"at":""},p("td",{},a),p("td",{},o?`${Ct(o.x,1)}; ${Ct(o.y,1)}`:"\u2013"),p("td",{},o?x("studio_point.how",{how:o.how}):""),p("td",{},...o?[jt("\u2715",x("studio_point.remove",{name:r}),l,"small")]:[]))}))}};var ri=(n,t,e={})=>p("input",{id:n,"aria-label":t,placeholder:t,autocomplete:"off",spellcheck:"false",...e});function Kn(n){let t=n.value.trim().replace(",",".");return t?Number(t):null}function Bs(n,t,e){return e!==null&&Number.isFinite(e)?!0:(n.say("studio_point.number_missing",{field:t.getAttribute("aria-label")},"bad"),t.focus(),!1)}var jn=(n,t)=>t?`${n}: ${t}`:n,to=class{constructor(t){this.model=t;this.start=ri("bar-start",x("studio_point.bar_start"),{list:"bar-names"});this.end=ri("bar-end",x("studio_point.bar_end"),{list:"bar-names"});this.length=ri("bar-length",x("label.length"),{inputmode:"decimal"});this.sigma=ri("bar-sigma",x("label.sigma"),{inputmode:"decimal"});this.names=p("datalist",{id:"bar-names"});this.rows=p("table",{"aria-label":x("studio_point.bars")});this.head=p("summary",{},x("studio_point.bars"));let e=p("form",{},p("div",{class:"row"},this.start,this.end,jt("\u21E4",x("studio_point.last_two"),()=>this.latest())),p("div",{class:"row"},this.length,this.sigma,p("button",{type:"submit",id:"bar-add"},x("studio_point.give")),this.names));e.addEventListener("submit",i=>{i.preventDefault(),this.give()}),ot("right").append(p("details",{class:"card",open:!0},this.head,this.rows,e)),t.on(["state","overview"],()=>this.show()),t.on("current",()=>{!t.current||document.activeElement===this.start||document.activeElement===this.end||this.start.value||(this.start.placeholder=x("studio_point.bar_start_as",{point:t.current}))})}latest(){let t=[...new Set([...this.model.state.marks].reverse().map(e=>e.point))];[this.end.value,this.start.value]=[t[0]??"",t[1]??""],this.length.focus()}async give(){let[t,e]=[Kn(this.length),Kn(this.sigma)];if(!Bs(this.model,this.length,t)||!Bs(this.model,this.sigma,e))return;let[i,s]=[this.start.value.trim(),this.end.value.trim()];await this.model.act("bar",{start:i,end:s,length:t,sigma:e},"studio_point.bar_given",{start:i,end:s,length:String(t)})&&[this.start,this.end,this.length,this.sigma].forEach(o=>o.value="")}show(){let{state:t,overview:e}=this.model,i=e.unit;this.head.textContent=jn(x("studio_point.bars"),t.bars.length),this.length.placeholder=Te(x("label.length"),i||"m"),this.sigma.placeholder=Te(x("label.sigma"),i||"m"),this.names.replaceChildren(...t.points.slice(-200).map(s=>p("option",{value:s.point}))),this.rows.hidden=!t.bars.length,this.rows.replaceChildren(...t.bars.map(s=>p("tr",{},p("td",{},`${s.start} \u2013 ${s.end}`),p("td",{},String(s.length)),p("td",{},`\xB1 ${Et(s.sigma)}`),p("td",{},jt("\u2715",x("studio_point.remove",{name:`${s.start} \u2013 ${s.end}`}),()=>void this.model.act("unbar",{start:s.start,end:s.end},"studio_point.removed",{name:`${s.start} \u2013 ${s.end}`}),"small")))))}},eo=class{constructor(t){this.model=t;this.role=p("select",{id:"control-role","aria-label":x("studio_point.role_of_current")},...we(["tie","control","check"],t=>x("studio_point.role",{role:t})));this.xyz=["X","Y","Z"].map(t=>ri(`control-${t}`,t,{inputmode:"decimal"}));this.sigma=["X","Y","Z"].map(t=>ri(`control-s${t}`,x("label.sigma_of",{symbol:t}),{inputmode:"decimal"}));this.rows=p("table",{"aria-label":x("studio_point.control")});this.head=p("summary",{},x("studio_point.control"));this.about=p("p",{class:"note"});let e=p("input",{type:"file",id:"control-file",accept:".csv,.txt,text/csv","aria-label":x("studio_point.control_table")});e.addEventListener("change",()=>void(e.files?.[0]&&this.drop(e.files[0]).then(()=>e.value="")));let i=p("form",{},this.about,p("div",{class:"row"},this.role,p("button",{type:"submit",id:"control-give"},x("studio_point.give"))),p("div",{class:"row three"},...this.xyz),p("div",{class:"row three"},...this.sigma),p("p",{class:"note"},x("studio_point.control_note")),e);i.addEventListener("submit",s=>{s.preventDefault(),this.give()}),ot("right").append(p("details",{class:"card"},this.head,this.rows,i)),t.on(["state","overview"],()=>this.show()),t.on("current",()=>void this.fill()),document.body.dataset.drop=x("studio_point.drop"),this.dropping()}dropping(){addEventListener("dragover",t=>{t.dataTransfer?.types.includes("Files")&&(t.preventDefault(),document.body.classList.add("dropping"))}),addEventListener("dragleave",t=>t.relatedTarget===null&&document.body.classList.remove("dropping")),addEventListener("drop",t=>{t.preventDefault(),document.body.classList.remove("dropping");let e=t.dataTransfer?.files[0];e&&this.drop(e)})}async drop(t){if(t.size>4e6)return this.model.say("studio_point.table_too_large",{name:t.name},"bad");try{let e=await this.model.actions.control(t.name,await t.text());this.model.command=e.command,this.model.take(e.state),this.model.show([x("studio_point.control_added",{n:e.added.length,name:t.name}),...e.remarks].join("; "),"good","studio_point.control_added")}catch(e){this.model.fail(e)}}async give(){let{model:t}=this;if(!t.current)return t.say("studio_point.none_chosen",{},"bad");let[e,i]=[this.xyz.map(Kn),this.sigma.map(Kn)];for(let[r,o]of[...e,...i].entries()){let a=[...this.xyz,...this.sigma][r];if(o!==null&&!Bs(t,a,o))return}let s=this.role.value;await t.act("point",{point:t.current,role:s,xyz:e,sigma:i},"studio_point.role_given",{point:t.current,role:s})}fields(t,e,i){this.role.value=t,this.xyz.forEach((s,r)=>s.value=e[r]===null?"":String(e[r])),this.sigma.forEach((s,r)=>s.value=i[r]===null?"":String(i[r]))}async fill(){let{model:t}=this,e=t.current,i=t.state.points.find(o=>o.point===e);if(this.about.textContent=e?x("studio_point.of_point",{point:e}):x("studio_point.none_chosen"),this.fields(i?.role??"tie",i?.xyz??[null,null,null],i?.sigma??[null,null,null]),i||!e)return;let r=(await Ot("/api/points",{search:e,limit:200})).rows.find(o=>o.point===e);r&&t.current===e&&(this.role.value=r.role)}show(){let{state:t}=this.model,e=t.points.filter(i=>i.role!=="tie"||i.xyz.some(s=>s!==null));this.head.textContent=jn(x("studio_point.control"),e.length),this.rows.hidden=!e.length,this.rows.replaceChildren(...e.slice(0,300).map(i=>p("tr",{},p("td",{},jt(i.point,x("studio_point.choose",{point:i.point}),()=>this.model.choose(i.point),"link")),p("td",{},x("studio_point.role",{role:i.role})),...i.xyz.map(s=>p("td",{},Et(s,7)))))),document.activeElement instanceof HTMLInputElement||this.fill()}};function Xh(n,t){let e=p("datalist",{id:`${n}-names`}),i=ri(n,t,{list:`${n}-names`,maxlength:"200"});return i.addEventListener("input",Oe(()=>void Ot("/api/points",{search:i.value.trim(),limit:12}).then(s=>e.replaceChildren(...s.rows.map(r=>p("option",{value:r.point}))),()=>{}),150)),[i,e]}var io=class{constructor(t){this.model=t;this.name=ri("line-name",x("studio_point.line_name"),{maxlength:"200"});this.kind=p("select",{id:"line-kind","aria-label":x("studio_point.line_kinds")},...we(["straight","plumb","level","plane"],t=>x("studio_point.line_kind",{kind:t})));this.sigma=ri("line-sigma",x("label.sigma"),{inputmode:"decimal"});this.follow=p("input",{type:"checkbox",id:"line-follow"});this.picked=p("ol",{class:"picked",id:"line-points","aria-label":x("studio_point.line_points")});this.rows=p("table",{"aria-label":x("studio_point.lines")});this.head=p("summary",{},x("studio_point.lines"));this.points=[];let[e,i]=Xh("line-point",x("label.point"));this.point=e,e.addEventListener("keydown",r=>{r.key!=="Enter"||!e.value.trim()||(r.preventDefault(),this.add())});let s=p("form",{},p("div",{class:"row"},this.name),p("div",{class:"row"},this.kind,this.sigma),p("div",{class:"row"},e,i,Bt("studio_point.add",()=>this.add())),p("label",{class:"check",title:Fe("studio_point.add_chosen")},this.follow,x("studio_point.add_chosen")),this.picked,p("div",{class:"row"},p("button",{type:"submit",id:"line-give"},x("studio_point.give")),Bt("studio_point.clear",()=>this.pick([]))));s.addEventListener("submit",r=>{r.preventDefault(),this.give()}),ot("right").append(p("details",{class:"card"},this.head,this.rows,s)),t.on(["state","overview"],()=>this.show()),t.on("current",()=>this.follow.checked&&t.current&&this.pick([...this.points,t.current]))}add(){let t=this.point.value.trim()||this.model.current;if(!t)return this.model.say("studio_point.none_chosen",{},"bad");this.pick([...this.points,t]),this.point.value="",this.point.focus()}pick(t){this.points=[...new Set(t)],this.picked.hidden=!this.points.length,this.picked.replaceChildren(...this.points.map(e=>p("li",{},e," ",jt("\u2715",x("studio_point.remove",{name:e}),()=>this.pick(this.points.filter(i=>i!==e)),"small"))))}async give(){let{model:t}=this,e=Kn(this.sigma);if(!Bs(t,this.sigma,e))return;let i=this.name.value.trim(),s=this.kind.value;await t.act("line",{line:i,points:this.points,kind:s,sigma:e},"studio_point.line_given",{kind:s,line:i,points:this.points.join(", ")})&&(this.name.value="",this.follow.checked=!1,this.pick([]))}show(){let{state:t,overview:e}=this.model;this.sigma.placeholder=Te(x("label.sigma"),e.unit),this.sigma.title=x("studio_point.line_sigma"),this.head.textContent=jn(x("studio_point.lines"),t.lines.length),this.rows.hidden=!t.lines.length,this.rows.replaceChildren(...t.lines.map(i=>p("tr",{},p("td",{},i.line),p("td",{},x("studio_point.line_kind",{kind:i.kind})),p("td",{class:"l"},i.points.join(", ")),p("td",{},`\xB1 ${Et(i.sigma)}`),p("td",{},jt("\u2715",x("studio_point.remove",{name:i.line}),()=>void this.model.act("line",{line:i.line,points:[]},"studio_point.removed",{name:i.line}),"small"))))),this.picked.hidden=!this.points.length}},Wh=[["origin","studio_point.origin"],["axis","studio_point.on_axis"],["plane","studio_point.in_plane"]],no=class{constructor(t){this.model=t;this.about=p("p",{class:"note"});this.away=Bt("studio_point.remove_datum",()=>void this.model.act("datum",{},"studio_point.datum_removed"));let e=Wh.map(([r,o])=>Xh(`datum-${r}`,x(o)));this.inputs=e.map(([r])=>r);let i=(r,o)=>jt("\u21E4",x("studio_point.use_current",{role:x(o)}),()=>r.value=t.current),s=p("form",{},this.about,...e.map(([r,o],a)=>p("div",{class:"row"},r,o,i(r,Wh[a][1]))),p("div",{class:"row"},p("button",{type:"submit",id:"datum-give"},x("studio_point.give")),this.away));s.addEventListener("submit",r=>{r.preventDefault(),this.give()}),ot("right").append(p("details",{class:"card"},p("summary",{},x("studio_point.datum")),s)),t.on("state",()=>this.show())}async give(){let[t,e,i]=this.inputs.map(r=>r.value.trim());await this.model.act("datum",{origin:t,axis:e,plane:i},"studio_point.datum_given",{points:[t,e,i].filter(r=>r).join(", ")})&&this.inputs.forEach(r=>r.value="")}show(){let{datum:t}=this.model.state;this.away.disabled=!t,this.about.textContent=t?x("studio_point.datum_is",{...t,plane:t.plane||"none"}):x("studio_point.datum_note")}},so=class{constructor(t){this.model=t;this.to=ri("rename-to",x("studio_point.new_name"),{maxlength:"200"});this.about=p("p",{class:"note"});let e=p("form",{},this.about,p("div",{class:"row"},this.to,p("button",{type:"submit",id:"rename-give"},x("studio_point.rename")),Bt("studio_point.forget",()=>this.forget())));e.addEventListener("submit",i=>{i.preventDefault(),this.rename()}),ot("right").append(p("details",{class:"card"},p("summary",{},x("studio_point.rename_or_forget")),e)),t.on("current",()=>this.show()),this.show()}show(){this.about.textContent=this.model.current?x("studio_point.of_point",{point:this.model.current}):x("studio_point.none_chosen")}async rename(){let{model:t}=this,e=t.current;if(!e)return t.say("studio_point.none_chosen",{},"bad");let i=this.to.value.trim();await t.act("rename",{point:e,to:i},"studio_point.renamed",{point:e,to:i})&&(this.to.value="",t.choose(i))}forget(){let{model:t}=this;if(!t.current)return t.say("studio_point.none_chosen",{},"bad");t.act("forget",{point:t.current},"studio_point.forgotten",{point:t.current})}};var mp=0,Sn=class{constructor(t,e,i,s){this.keyOf=e;this.row=i;this.chosen=s;this.items=[];this.at=-1;this.id=`list${mp++}`;this.root=p("div",{role:"listbox",tabindex:0,class:"choice","aria-label":t}),this.root.addEventListener("keydown",r=>this.key(r)),this.root.addEventListener("click",r=>{let o=r.target.closest("[role=option]"),a=o?[...this.root.children].indexOf(o):-1;a<0||(this.point(a),this.chosen(this.items[a],r))})}set(t,e=""){this.items=t,this.root.replaceChildren(...t.map((i,s)=>p("div",{role:"option",id:`${this.id}-${s}`,"aria-selected":"false"},...this.row(i)))),this.at=-1,this.select(e)}select(t){this.items.forEach((e,i)=>{let s=this.keyOf(e)===t;this.root.children[i].setAttribute("aria-selected",String(s)),s&&this.point(i)})}get length(){return this.items.length}point(t){this.root.children[this.at]?.classList.remove("at"),this.at=t;let e=this.root.children[t];if(!e)return;e.classList.add("at"),this.root.setAttribute("aria-activedescendant",e.id);let{offsetTop:i,offsetHeight:s}=e,{scrollTop:r,clientHeight:o}=this.root;i<r?this.root.scrollTop=i:i+s>r+o&&(this.root.scrollTop=i+s-o)}key(t){let e=this.items.length-1,i={ArrowDown:Math.min(this.at+1,e),ArrowUp:Math.max(this.at-1,0),Home:0,End:e,PageDown:Math.min(this.at+8,e),PageUp:Math.max(this.at-8,0)};if(t.key in i)this.point(i[t.key]);else if(t.key==="Enter"&&this.at>=0)this.chosen(this.items[this.at],t);else return;t.preventDefault(),t.stopPropagation()}};var zs=512,gp=4,_p=320,vp=2500,En=(n,t,e,i)=>`${n}/${t}/${e}/${i}`;function Hs(n,t){let e=0;for(;Math.max(n,t)>zs;)n=Math.ceil(n/2),t=Math.ceil(t/2),e++;return e}var Wl=class{constructor(){this.cache=new Map;this.loading=new Map;this.wanted=new Map;this.failed=new Map;this.listeners=new Set;this.arrived=Gi(()=>this.listeners.forEach(t=>t()));this.timesRead=0;this.times=[]}onarrival(t){return this.listeners.add(t),()=>this.listeners.delete(t)}readAnew(t){t!==this.timesRead&&(this.timesRead=t,this.loading.forEach(e=>e.abort()),this.cache.forEach(e=>e.close()),this.cache.clear(),this.failed.clear())}get(t){let e=this.cache.get(t);return e&&(this.cache.delete(t),this.cache.set(t,e)),e}why(t){return this.failed.get(t)??""}want(t,e,i=!1){let s=e.filter(o=>!this.cache.has(o)&&!this.failed.has(o));s.length?this.wanted.set(t,{keys:s,late:i}):this.wanted.delete(t);let r=new Set([...this.wanted.values()].flatMap(o=>o.keys));for(let[o,a]of this.loading)r.has(o)||a.abort();this.pump()}pump(){for(;this.loading.size<gp;){let t=this.next();if(!t)return;this.load(t)}}next(){for(let t of[!1,!0]){if(t&&this.loading.size)return;let e=[...this.wanted.values()].filter(s=>s.late===t),i=Math.max(0,...e.map(s=>s.keys.length));for(let s=0;s<i;s++)for(let{keys:r}of e){let o=r[s];if(o&&!this.loading.has(o)&&!this.cache.has(o)&&!this.failed.has(o))return o}}}async load(t){let e=new AbortController;this.loading.set(t,e);let i=performance.now(),s=this.timesRead;try{let r=await fetch(`/api/tile/${t}?read=${s}`,{signal:e.signal});if(r.status===404)this.failed.set(t,(await r.json()).error);else if(r.ok){let o=await createImageBitmap(await r.blob());s===this.timesRead&&this.keep(t,o),this.times.push(performance.now()-i)}else throw new Error(String(r.status))}catch{e.signal.aborted||await new Promise(r=>setTimeout(r,vp))}this.loading.delete(t),this.arrived(),this.pump()}keep(t,e){for(this.cache.set(t,e);this.cache.size>_p;){let i=this.cache.keys().next().value;this.cache.get(i).close(),this.cache.delete(i)}}},ke=new Wl;var yp=72,xp=54,ro=class{constructor(t,e){this.model=t;this.filter=ot("image-filter");this.small=new Map;this.list=new Sn(x("studio_page.images"),s=>s.id,s=>this.row(s),(s,r)=>{e(s.id,r.shiftKey)}),ot("image-list").append(this.list.root),this.watch=new IntersectionObserver(s=>s.forEach(r=>this.seen(r)),{root:this.list.root}),ke.onarrival(()=>this.small.forEach((s,r)=>this.draw(r,s))),this.filter.addEventListener("input",()=>this.show()),t.on("overview",()=>this.show()),t.on("panes",()=>this.list.select(t.panes[t.active]??""))}show(){let t=this.filter.value.toLowerCase();this.watch.disconnect(),this.small.forEach((i,s)=>ke.want(s,[])),this.small.clear();let e=[...this.model.images.values()].filter(i=>i.id.toLowerCase().includes(t));this.list.set(e,this.model.panes[this.model.active]),ot("images-head").textContent=x("studio_photo.count",{n:e.length})}row(t){let e=p("canvas",{width:yp*2,height:xp*2,"aria-hidden":"true"});this.small.set(e,t),queueMicrotask(()=>this.watch.observe(e));let i=t.rms_px===null?"":`, ${Et(t.rms_px,2)}\xA0px`,s=t.oriented?x("studio_photo.rays",{n:t.rays})+i:x("studio_photo.not_oriented",{n:this.model.marksIn(t.id).length}),r=t.p_wrong===null?"":`
${x("studio_photo.p_wrong",{percent:100*t.p_wrong})}`;return[e,p("span",{class:"about",title:t.id+r},p("b",{},t.id),p("small",{class:t.oriented?"":"open"},s))]}seen(t){let e=this.small.get(t.target);if(!e?.photo)return;let i=En(e.k,Hs(e.width,e.height),0,0);ke.want(t.target,t.isIntersecting?[i]:[],!0),this.draw(t.target,e)}draw(t,e){let i=Hs(e.width,e.height),s=t.dataset.drawn?void 0:ke.get(En(e.k,i,0,0));if(!s)return;t.dataset.drawn="yes";let r=t.getContext("2d"),[o,a]=e.turn&1?[s.height,s.width]:[s.width,s.height],l=Math.min(t.width/o,t.height/a);r.translate(t.width/2,t.height/2),r.rotate(e.turn*Math.PI/2),r.imageSmoothingQuality="high",r.drawImage(s,-s.width*l/2,-s.height*l/2,s.width*l,s.height*l)}};var Yh=.36,Xl=class{constructor(){this.areas=new Map;this.pictures=new Map}draw(t,e,i,s,r){let o=this.picture(i,s.id);o&&(e.apply(t,r),t.imageSmoothingEnabled=!1,t.globalAlpha=Yh,t.drawImage(o,0,0,s.width,s.height),t.globalAlpha=1),t.setTransform(r,0,0,r,0,0);for(let a of this.drawn(i,s.id))qh(t,e,a.polygon,!0);if(!(!Zt.on||Zt.image!==s.id)){qh(t,e,Zt.corners,!1);for(let[a,l]of Zt.corners){let[c,h]=e.toScreen(a,l);t.beginPath(),t.rect(c-4,h-4,8,8),t.fillStyle=ie.current,t.fill(),t.lineWidth=1.5,t.strokeStyle="#000000",t.stroke()}}}drawn(t,e){let{masks:i}=t.state;if(!i.length)return[];let s=i.filter(a=>a.image===e);if(!i.some(a=>a.camera&&a.image!==e))return s;let r=JSON.stringify(i),o=this.areas.get(e);return o?.of===r?o.found:(this.areas.set(e,{of:r,found:s}),Ot("/api/masks",{image:e}).then(({areas:a})=>{this.areas.set(e,{of:r,found:a}),t.emit("looks")},()=>this.areas.delete(e)),s)}picture(t,e){if(!t.overview.masks_given)return null;let i=this.pictures.get(e);return i!==void 0?i:(this.pictures.set(e,null),Hr(`/api/mask?image=${encodeURIComponent(e)}`).then(async s=>{s.byteLength&&(this.pictures.set(e,await createImageBitmap(new Blob([s],{type:"image/png"}))),t.emit("looks"))}).catch(()=>this.pictures.delete(e)),null)}};function qh(n,t,e,i){n.beginPath(),e.forEach(([s,r],o)=>o?n.lineTo(...t.toScreen(s,r)):n.moveTo(...t.toScreen(s,r))),n.globalAlpha=Yh,n.fillStyle=ie.masked,n.fill("evenodd"),n.globalAlpha=1,i&&n.closePath();for(let[s,r]of[["#000000b0",3.2],[ie.masked,1.4]])n.lineWidth=r,n.strokeStyle=s,n.stroke()}var $h=new Xl;var Zh=.5,bp=450,Vs=(n,t,e)=>({x_px:n,y_px:t,covariance:[Zh**2,Zh**2,0],how:"hand",clicked:e,quality:null}),Mp=2,wp=6,[Sp,Ep]=[2,12],Tp=n=>Math.min(Math.max(wp/n,Sp),Ep);function oo(n,t,e,i){let s=Math.sqrt(Math.max(e.covariance[0],e.covariance[1])),r=e.clicked?Math.hypot(e.x_px-e.clicked[0],e.y_px-e.clicked[1]):0;return[n,{point:t,how:e.how,sigma_px:Et(s,2),cause:i||"none",far_px:i||r<Mp?0:r}]}var Tn=class n{constructor(t){this.model=t;this.moving=new Map;this.resting=0;this.worstOnes=[];this.worstAt=-1;t.on("read",()=>this.worstAt=-1)}static key(t,e){return`${t}
${e}`}async place(t,e,i,s){let{model:r}=this;if(r.fiducial)return this.placeFiducial(t,e,i,s);let o=r.current;if(!o)return r.say("studio_point.none_chosen",{},"bad");if(r.mark(t,o))return r.say("studio_point.marked_before",{point:o},"bad");let[a,l]=await this.snapped(t,o,e,i,s);await r.act("put",{image:t,point:o,...a},...oo("studio_point.marked",o,a,l))}async placeFiducial(t,e,i,s){let{model:r}=this,o=r.fiducial,[a,l]=await this.snapped(t,"",e,i,s);if(!await r.act("fiducial",{image:t,name:o,...a},...oo("studio_point.marked",o,a,l)))return;let h=new Set(r.fiducialsIn(t).map(m=>m.name)),u=r.overview.fiducials,d=[...u.slice(u.indexOf(o)),...u].find(m=>!h.has(m))??"";r.chooseFiducial(d)}async move(t,e,i,s,r){let[o,a]=await this.snapped(t,e,i,s,r);await this.model.act("move",{image:t,point:e,...o},...oo("studio_point.moved",e,o,a)),this.moving.delete(n.key(t,e)),this.model.emit("looks")}async snapped(t,e,i,s,r){if(Xt.snap==="hand")return[Vs(i,s,[i,s]),""];try{let o=await Ue("/api/snap",{image:t,x:i,y:s,kind:Xt.snap,point:e,reach:Tp(r)});if("why"in o)return[Vs(i,s,[i,s]),o.why];let{cov:a,how:l,quality:c}=o;return[{x_px:o.x,y_px:o.y,covariance:a,how:l,clicked:[i,s],quality:c},""]}catch(o){return[Vs(i,s,[i,s]),o instanceof _i?o.message:x("studio_page.no_answer")]}}nudge(t,e,i){let{model:s}=this,r=s.mark(t,s.current);if(!r)return s.say("studio_point.not_marked",{},"bad");let o=n.key(t,r.point),[a,l]=this.moving.get(o)??[r.x,r.y];this.moving.set(o,[a+e,l+i]),s.emit("looks"),clearTimeout(this.resting),this.resting=window.setTimeout(()=>void this.rest(t,r.point,r.clicked),bp)}async rest(t,e,i){let s=n.key(t,e),r=this.moving.get(s);r&&(await this.model.act("move",{image:t,point:e,...Vs(r[0],r[1],i)},...oo("studio_point.moved",e,Vs(r[0],r[1],null),"")),this.moving.delete(s),this.model.emit("looks"))}async remove(t){let e=this.model.current;if(!this.model.mark(t,e))return this.model.say("studio_point.not_marked",{},"bad");await this.model.act("remove",{image:t,point:e},"studio_point.mark_removed",{point:e})}async reject(t,e){(this.model.isRejected(t,e)?await this.model.act("accept",{image:t,point:e},"studio_point.accepted",{point:e}):await this.model.act("reject",{image:t,point:e},"studio_point.rejected",{point:e}))&&this.model.emit("looks")}async undo(){await this.model.act("undo",{},"studio_page.undone")}async redo(){await this.model.act("redo",{},"studio_page.redone")}async newPoint(){let t=new Set(this.model.state.points.map(e=>e.point));for(let e=1;;e++){let i=`M${e}`;if(!(t.has(i)||(await Ot("/api/points",{search:i,limit:500})).rows.some(r=>r.point===i))){this.model.choose(i),this.model.say("studio_point.new_point",{point:i});return}}}async worstNext(){if(this.worstAt<0&&(this.worstOnes=(await Ot("/api/worst")).worst),!this.worstOnes.length)return this.model.say("studio_point.no_worst"),null;this.worstAt=(this.worstAt+1)%this.worstOnes.length;let t=this.worstOnes[this.worstAt],{kind:e,point:i,value:s}=t;return this.model.say("studio_point.worst",{number:this.worstAt+1,of:this.worstOnes.length,point:i,kind:e,value:Et(s),n:Math.round(s),unit:this.model.overview.unit}),t}};var Ap={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},Rp=40;function Kh(n,t){let e=Ap[t.key];if(e)return Cp(n,t,...e);if(t.ctrlKey||t.metaKey||t.altKey)return!1;switch(t.key){case"+":case"=":return n.zoom(1.25),!0;case"-":return n.zoom(.8),!0;case"0":return n.fit(),!0;case"1":return n.zoom(1/n.view.scale),!0;case"Enter":return n.enter(),!0;case"r":return n.turn(1),!0;case"Delete":case"Backspace":return Zt.on?Zt.removeLast():n.measuring.remove(n.picture.id),!0;case"p":return Pp(n);case"x":return Ip(n);default:return!1}}function Cp(n,t,e,i){let{view:s}=n;if(t.shiftKey||t.altKey){let[o,a]=s.along(e,i),l=t.altKey?.01:.1;return n.measuring.nudge(n.picture.id,l*o,l*a),!0}let r=t.ctrlKey||t.metaKey?s.scale:Rp;return n.pan(-r*e,-r*i),!0}function Pp(n){let t=n.pointHere();return t?n.model.choose(t):n.model.say("studio_photo.no_point_here"),!0}function Ip(n){let t=n.pointHere();return t?n.measuring.reject(n.picture.id,t):n.model.say("studio_photo.no_point_here"),!0}function ql(n,t,e,i,s=[0,0]){let r=Hs(e.width,e.height),o=Math.min(Math.max(Math.floor(-Math.log2(t.scale*i)+.25),0),r);t.apply(n,i,s),n.imageSmoothingEnabled=t.scale*i<4,n.imageSmoothingQuality="high",n.save(),n.beginPath(),n.rect(0,0,e.width,e.height),n.clip();let a=En(e.k,r,0,0),l=ke.get(a);l&&n.drawImage(l,0,0,l.width*2**r,l.height*2**r);let c=[a];return o<r&&c.push(...Lp(n,t,e,o,r)),n.restore(),c}function Lp(n,t,e,i,s){let r=zs*2**i,[o,a,l,c]=t.seen(),h=[];for(let u=Math.floor(a/r);u*r<c;u++)for(let d=Math.floor(o/r);d*r<l;d++){let m=En(e.k,i,d,u),v=Math.hypot((d+.5)*r-t.x,(u+.5)*r-t.y);h.push([v,m]);let w=ke.get(m);w?n.drawImage(w,d*r,u*r,w.width*2**i,w.height*2**i):Dp(n,e.k,i,d,u,s)}return h.sort((u,d)=>u[0]-d[0]).map(([,u])=>u)}function Dp(n,t,e,i,s,r){for(let o=1;e+o<r;o++){let a=ke.get(En(t,e+o,i>>o,s>>o));if(!a)continue;let l=zs>>o,c=(i&(1<<o)-1)*l,h=(s&(1<<o)-1)*l,u=Math.min(l,a.width-c),d=Math.min(l,a.height-h),m=zs*2**e,v=2**(e+o);u>0&&d>0&&n.drawImage(a,c,h,u,d,i*m,s*m,u*v,d*v);return}}var Up=[1,0,-1,0],Np=[0,1,0,-1],Gs=class{constructor(t,e,i){this.columns=t;this.rows=e;this.turn=i;this.scale=1;this.width=1;this.height=1;this.fitted=!0;this.x=t/2,this.y=e/2}get cos(){return Up[this.turn&3]}get sin(){return Np[this.turn&3]}toScreen(t,e){let i=(t-this.x)*this.scale,s=(e-this.y)*this.scale;return[this.width/2+this.cos*i-this.sin*s,this.height/2+this.sin*i+this.cos*s]}toImage(t,e){let[i,s]=this.along((t-this.width/2)/this.scale,(e-this.height/2)/this.scale);return[this.x+i,this.y+s]}along(t,e){return[this.cos*t+this.sin*e,-this.sin*t+this.cos*e]}inside(t,e){return t>=0&&e>=0&&t<=this.columns&&e<=this.rows}get whole(){let t=this.turn&1;return Math.min(this.width/(t?this.rows:this.columns),this.height/(t?this.columns:this.rows))}fit(){this.x=this.columns/2,this.y=this.rows/2,this.scale=this.whole*.98,this.fitted=!0}resize(t,e){this.width=Math.max(t,1),this.height=Math.max(e,1),this.fitted&&this.fit()}zoomAt(t,e=this.width/2,i=this.height/2){let[s,r]=this.toImage(e,i);this.scale=Math.min(Math.max(this.scale*t,Math.min(this.whole/2,1)),64);let[o,a]=this.toImage(e,i);this.centre(this.x+s-o,this.y+r-a)}panBy(t,e){let[i,s]=this.along(t/this.scale,e/this.scale);this.centre(this.x-i,this.y-s)}centre(t,e){this.fitted=!1,this.x=Math.min(Math.max(t,0),this.columns),this.y=Math.min(Math.max(e,0),this.rows)}seen(){let[t,e]=this.toImage(0,0),[i,s]=this.toImage(this.width,this.height);return[Math.max(Math.min(t,i),0),Math.max(Math.min(e,s),0),Math.min(Math.max(t,i),this.columns),Math.min(Math.max(e,s),this.rows)]}apply(t,e,i=[0,0]){let s=this.scale*e,r=(this.width/2+i[0])*e,o=(this.height/2+i[1])*e,{cos:a,sin:l,x:c,y:h}=this;t.setTransform(s*a,s*l,-s*l,s*a,r-s*(a*c-l*h),o-s*(l*c+a*h))}};var Be=190,ao=class{constructor(t,e,i,s){this.model=t;this.measuring=e;this.stage=i;this.picture=s;this.photo=p("canvas",{class:"photo"});this.over=p("canvas",{class:"over"});this.status=p("p",{class:"status"});this.tip=p("div",{class:"tip",hidden:!0});this.observations=null;this.hover=-1;this.at=null;this.keyboard=!1;this.draw=Gi(()=>this.drawn());this.watch=new ResizeObserver(()=>this.sized());this.view=new Gs(s.width,s.height,s.turn),this.body=p("div",{class:"canvas",tabindex:0,role:"application","aria-label":x("studio_photo.canvas",{image:s.id})},this.photo,this.over,this.status,this.tip),this.root=p("section",{class:"pane","aria-label":x("studio_photo.pane",{image:s.id})},this.head(),this.body),this.forget=ke.onarrival(()=>this.draw()),this.watch.observe(this.body),this.pointers(),this.body.addEventListener("keydown",r=>this.key(r)),this.body.addEventListener("focus",()=>this.stage.activate(this)),this.body.addEventListener("blur",()=>this.redraw()),this.read()}head(){let t=this.picture.id;return p("header",{},p("b",{class:"name"},t),jt("\u27F2",x("studio_photo.turn_left",{image:t}),()=>this.turn(3)),jt("\u27F3",x("studio_photo.turn_right",{image:t}),()=>this.turn(1)),jt("1:1",x("studio_photo.pixels",{image:t}),()=>this.zoom(1/this.view.scale)),Bt("studio_photo.fit",()=>this.fit(),"",{image:t}),jt("\u2715",x("studio_photo.close",{image:t}),()=>this.stage.close(this)))}async read(){try{this.observations=await this.model.observations(this.picture.id)}catch(t){this.model.fail(t)}this.redraw()}gone(){this.forget(),this.watch.disconnect(),ke.want(this,[]),this.root.remove()}redraw(){this.draw()}sized(){let{clientWidth:t,clientHeight:e}=this.body;for(let i of[this.photo,this.over])i.width=Math.round(t*devicePixelRatio),i.height=Math.round(e*devicePixelRatio);this.view.resize(t,e),this.drawn()}rejectedHere(){return new Set(this.model.state.rejected.filter(([t])=>t===this.picture.id).map(([,t])=>t))}placed(t){let e=this.measuring.moving.get(Tn.key(t.image,t.point));return{mark:t,x:e?.[0]??t.x,y:e?.[1]??t.y}}marks(){return this.model.marksIn(this.picture.id).map(t=>this.placed(t))}shown(){let{model:t,picture:e}=this,i=t.prediction?.predictions.find(s=>s.image===e.id)??null;return{observations:this.observations,rejectedHere:this.rejectedHere(),marks:this.marks(),prediction:i,off:t.prediction?.off.includes(e.id)??!1,image:e.id,fiducials:t.fiducialsIn(e.id),fiducial:t.fiducial,current:t.current,hover:this.hover,hair:this.keyboard&&document.activeElement===this.body}}drawn(){let{view:t,picture:e}=this,i=devicePixelRatio,s=this.photo.getContext("2d",{alpha:!1});s.setTransform(1,0,0,1,0,0),s.fillStyle="#2b2b2b",s.fillRect(0,0,this.photo.width,this.photo.height),this.photo.style.filter=Bl();let r=ql(s,t,e,i),o=this.over.getContext("2d");o.setTransform(1,0,0,1,0,0),o.clearRect(0,0,this.over.width,this.over.height),$h.draw(o,t,this.model,e,i),Bh(o,t,this.shown(),i);let a=Se.on?Se.of(e.id):null;a&&Hh(o,t,a),Xt.loupe&&(this.at||document.activeElement===this.body)&&r.push(...this.loupe(o,i)),ke.want(this,r),this.status.textContent=e.photo?ke.why(r[0]):x("studio_photo.unknown")}loupe(t,e){let[i,s]=this.at??[this.view.width/2,this.view.height/2],[r,o]=this.view.toImage(i,s),a=new Gs(this.picture.width,this.picture.height,this.view.turn);Object.assign(a,{x:r,y:o,scale:Math.min(4*this.view.scale,Math.max(16,this.view.scale)),width:Be,height:Be,fitted:!1});let l=i+Be+30<this.view.width?i+24:i-Be-24,c=s+Be+30<this.view.height?s+24:s-Be-24;t.save(),t.setTransform(e,0,0,e,0,0),t.beginPath(),t.rect(l,c,Be,Be),t.fillStyle="#2b2b2b",t.fill(),t.clip(),t.filter=Bl();let h=ql(t,a,this.picture,e,[l,c]);return t.restore(),t.setTransform(e,0,0,e,0,0),t.beginPath(),t.rect(l,c,Be,Be),t.moveTo(l+Be/2,c),t.lineTo(l+Be/2,c+Be),t.moveTo(l,c+Be/2),t.lineTo(l+Be,c+Be/2),t.lineWidth=1,t.strokeStyle=ie.current,t.stroke(),h}turn(t){this.view.turn=this.view.turn+t&3,this.view.fitted&&this.view.fit(),this.redraw()}fit(){this.view.fit(),this.redraw(),this.showPlace()}zoom(t,e,i){this.view.zoomAt(t,e,i),this.stage.moved(this,0,0,t),this.redraw(),this.showPlace()}pan(t,e){this.view.panBy(t,e),this.stage.moved(this,t,e,1),this.redraw(),this.showPlace()}show(t,e,i=1){this.view.scale=Math.max(this.view.scale,i),this.view.centre(t,e),this.redraw(),this.showPlace()}showPlace(){let[t,e]=this.keyboard||!this.at?[this.view.x,this.view.y]:this.view.toImage(...this.at);this.stage.pointer(`${this.picture.id}  x ${Ct(t,2)}  y ${Ct(e,2)} px  \xB7  ${Et(100*this.view.scale,3)} %`)}pointers(){let{body:t}=this,e=null,i=[0,0],s=null,r=-1,o=!1;t.addEventListener("pointerdown",a=>{a.button>1||(t.focus(),t.setPointerCapture(a.pointerId),e=i=this.place(a),r=a.button===0?Zt.cornerAt(this.picture.id,this.view,...e):-1,s=a.button===0&&!Zt.on?this.markAt(...e):null,o=!1)}),t.addEventListener("pointermove",a=>{let l=this.place(a);this.keyboard=!1,this.at=l,e?(o||=Math.hypot(l[0]-e[0],l[1]-e[1])>4,o&&r>=0?Zt.move(r,this.clamped(...l)):o&&s?this.measuring.moving.set(Tn.key(s.image,s.point),this.view.toImage(...l)):o&&this.pan(l[0]-i[0],l[1]-i[1]),i=l,this.redraw()):this.hovered(...l),this.showPlace()}),t.addEventListener("pointerup",a=>{let l=this.place(a);e&&o&&s?this.measuring.move(s.image,s.point,...this.view.toImage(...l),this.view.scale):e&&!o&&a.button===0&&this.click(a,...l),e=s=null}),t.addEventListener("pointercancel",()=>e=s=null),t.addEventListener("pointerleave",()=>this.left()),t.addEventListener("wheel",a=>{a.preventDefault(),this.zoom(Math.exp(-a.deltaY*(a.deltaMode?.05:.0016)),...this.place(a))},{passive:!1})}place(t){let e=this.body.getBoundingClientRect();return[t.clientX-e.left,t.clientY-e.top]}markAt(t,e){let i=null,s=10;for(let{mark:r,x:o,y:a}of this.marks()){let[l,c]=this.view.toScreen(o,a),h=Math.hypot(l-t,c-e)-(r.point===this.model.current?2:0);h<s&&(s=h,i=r)}return i}pointAt(t,e){let i=this.observations;return i?kh(i,Hl(i,Xt.filter,this.rejectedHere()),this.view,t,e):-1}click(t,e,i){let{model:s}=this;if(Zt.on){Zt.cornerAt(this.picture.id,this.view,e,i)<0&&this.enter(e,i);return}if(s.fiducial)return this.enter(e,i);let r=this.markAt(e,i);if(r)return s.choose(r.point);let o=this.pointAt(e,i),a=!s.current||s.mark(this.picture.id,s.current)!==void 0;if(o>=0&&(a||t.ctrlKey||t.metaKey))return s.choose(this.observations.point[o]);this.enter(e,i)}enter(t=this.view.width/2,e=this.view.height/2){if(Zt.on){Zt.add(this.picture.id,this.clamped(t,e))||this.model.say("studio_point.mask_elsewhere",{image:Zt.image},"bad");return}let[i,s]=this.view.toImage(t,e);if(!this.view.inside(i,s))return this.model.say("studio_photo.outside",{},"bad");this.measuring.place(this.picture.id,i,s,this.view.scale)}clamped(t,e){let i=(o,a)=>Math.round(100*Math.min(Math.max(o,0),a))/100,[s,r]=this.view.toImage(t,e);return[i(s,this.picture.width),i(r,this.picture.height)]}left(){this.at=null,this.hover=-1,this.tip.hidden=!0,this.redraw()}hovered(t,e){let i=this.pointAt(t,e);if((i!==this.hover||Xt.loupe)&&this.redraw(),this.hover=i,this.tip.hidden=i<0,i<0)return;this.tip.textContent=this.words(i);let s=t>this.view.width-240;this.tip.style.left=`${s?Math.max(t-230,4):t+16}px`,this.tip.style.top=`${Xt.loupe?Math.max(e-60,4):Math.min(e+14,this.view.height-70)}px`}words(t){let e=this.observations,i=Kr(e,t,this.rejectedHere()),s=x("studio_photo.legend",{name:i}),r=[`${e.point[t]} (${s})`,x("studio_photo.residual",{vx:Et(e.vx[t],2),vy:Et(e.vy[t],2),w:Et(e.w[t],2),n:e.rays[t]})];return i==="rejected"&&r.push(x("studio_photo.rejected",{cause:e.rejected[t]||x("studio_photo.by_hand")})),r.join(`
`)}pointHere(){let t=this.at&&!this.keyboard?this.hover:this.pointAt(this.view.width/2,this.view.height/2);return t>=0?this.observations.point[t]:null}key(t){Kh(this,t)&&(t.preventDefault(),t.stopPropagation(),this.keyboard=!0,this.tip.hidden=!0,this.redraw(),this.showPlace())}};var Fp={used:"\u25CB",weak:"\u25A1",rejected:"\u2715",control:"\u25B3",check:"\u25C7",mark:"\u271B",predicted:"\u25CC",beyond:"\u25EF",masked:"\u25A8"},Op=["all","rejected","weak","control","worst","none"],lo=class{constructor(t,e,i){this.model=t;this.measuring=e;this.showPlace=i;this.panes=[];this.most=1;this.box=ot("panes");this.counts=[];this.targets=p("input",{type:"checkbox",id:"targets"});ot("looks").append(...this.bar()),ot("image-legend").append(...Object.entries(Fp).map(([r,o])=>{let a=p("span",{class:"sign","aria-hidden":"true"},o);return a.style.color=ie[r],p("li",{id:`legend-${r}`,hidden:r==="beyond"||r==="masked"},a,x("studio_photo.legend",{name:r}))})),t.on(["looks","state","prediction","current","fiducial"],()=>this.panes.forEach(r=>r.redraw())),Qe.onchange(()=>{ot("legend-beyond").hidden=!Qe.points.size,this.panes.forEach(r=>r.redraw())}),this.targets.addEventListener("change",()=>Se.switch(this.targets.checked));let s=Zn.map(([r,o,a])=>{let l=p("span",{class:"sign","aria-hidden":"true"},a);return l.style.color=o,p("li",{hidden:!0,id:`legend-target-${r}`},l,x("studio_target.legend",{fate:r}))});ot("image-legend").append(...s),Se.onchange(()=>{this.targets.checked=Se.on,s.forEach(r=>r.hidden=!Se.on),Se.on&&Se.reason&&t.show(Se.reason,"bad"),this.panes.forEach(r=>r.redraw())}),t.on("read",()=>Se.forget()),t.on("observations",()=>this.panes.forEach(r=>void r.read())),t.on("overview",()=>this.begin()),t.on(["overview","state"],()=>ot("legend-masked").hidden=!t.state.masks.length&&!t.overview.masks_given)}bar(){this.counts=[1,2,4].map(i=>{let s=x("studio_photo.panes",{n:i}),r=jt(String(i),s,()=>this.setCount(i));return r.setAttribute("aria-label",s),r});let t=p("select",{id:"filter"},...we(Op,i=>x("studio_photo.filter",{filter:i}),Xt.filter));t.addEventListener("change",()=>this.look(()=>Xt.filter=t.value)),this.loupe=p("input",{type:"checkbox",id:"loupe"}),this.loupe.addEventListener("change",()=>this.look(()=>Xt.loupe=this.loupe.checked));let e=p("input",{type:"checkbox",id:"linked",checked:!0});return e.addEventListener("change",()=>Xt.linked=e.checked),[p("span",{class:"group",role:"group","aria-label":x("studio_photo.pane_count")},...this.counts),p("label",{},e,x("studio_photo.linked")),p("label",{},this.loupe,x("studio_photo.loupe")),p("label",{title:Fe("studio_photo.targets")},this.targets,x("studio_photo.targets")),p("label",{},x("label.points"),t),this.slider("vectors","studio_photo.residuals",0,30,16,i=>Xt.vectors=i?Math.round(10**(i/10)):0,()=>String(Xt.vectors)),this.slider("brightness","studio_photo.brightness",2,30,10,i=>Xt.brightness=i/10,()=>Ct(Xt.brightness,1)),this.slider("contrast","studio_photo.contrast",2,30,10,i=>Xt.contrast=i/10,()=>Ct(Xt.contrast,1))]}slider(t,e,i,s,r,o,a){let l=p("input",{type:"range",id:t,min:i,max:s,value:r}),c=p("output",{for:t},a());return l.addEventListener("input",()=>this.look(()=>{o(Number(l.value)),c.textContent=a()})),l.addEventListener("dblclick",()=>{l.value=String(r),l.dispatchEvent(new Event("input"))}),p("label",{title:Fe(e)},x(e),l,c)}look(t){t(),this.model.emit("looks")}toggleLoupe(t=!Xt.loupe){this.loupe.checked=t,this.look(()=>Xt.loupe=t)}begin(){this.panes=this.panes.filter(e=>this.model.images.has(e.picture.id)||(e.gone(),!1));for(let{picture:e}of this.panes)Object.assign(e,this.model.images.get(e.id));let t=[...this.model.images.values()];!this.panes.length&&t.length&&this.open((t.find(e=>e.photo)??t[0]).id),this.arranged()}setCount(t){for(this.most=t;this.panes.length>t;)this.panes.pop().gone();let e=new Set(this.panes.map(r=>r.picture.id)),i=this.activePane?.picture.k??0,s=[...this.model.images.values()];for(let r=1;r<s.length&&this.panes.length<t;r++){let o=s[(i+r)%s.length];e.has(o.id)||this.add(o.id)}this.arranged()}open(t,e=!1){let i=this.panes.find(o=>o.picture.id===t);if(i)return this.activate(i),i;if(e&&this.panes.length<4){this.most=Math.max(this.most,this.panes.length+1>2?4:2);let o=this.add(t);return this.activate(o),o}let s=this.activePane,r=this.add(t,s);return s&&(this.panes.splice(this.panes.indexOf(s),1),s.gone()),this.model.active=this.panes.indexOf(r),this.arranged(),r}add(t,e){let i=new ao(this.model,this.measuring,this,this.model.images.get(t));return e?(e.root.before(i.root),this.panes.splice(this.panes.indexOf(e),0,i)):(this.box.append(i.root),this.panes.push(i)),i}arranged(){this.box.className=`panes${this.most>2?4:this.most}`,[1,2,4].forEach((e,i)=>this.counts[i].setAttribute("aria-pressed",String(e===this.most)));let t=Math.min(Math.max(this.model.active,0),this.panes.length-1);this.panes.forEach((e,i)=>e.root.classList.toggle("active",i===t)),this.model.setPanes(this.panes.map(e=>e.picture.id),t)}get activePane(){return this.panes[this.model.active]??this.panes[0]}activate(t){let e=this.panes.indexOf(t);e===this.model.active&&t.root.classList.contains("active")||(this.model.active=e,this.arranged())}close(t){if(this.panes.length<2)return this.model.say("studio_photo.last_open");this.panes.splice(this.panes.indexOf(t),1),t.gone(),this.most=this.panes.length>2?4:this.panes.length,this.arranged(),this.activePane?.body.focus()}moved(t,e,i,s){if(Xt.linked)for(let r of this.panes)r!==t&&(s!==1?r.view.zoomAt(s):r.view.panBy(e,i),r.redraw())}pointer(t){this.showPlace(t)}visit(t,e,i,s=1){let r=this.open(t);requestAnimationFrame(()=>{r.show(e,i,s),r.body.focus()})}step(t){let e=[...this.model.images.keys()],i=e.indexOf(this.activePane?.picture.id??"");this.open(e[(i+t+e.length)%e.length]).body.focus()}centre(){for(let t of this.panes){let e=this.model.mark(t.picture.id,this.model.current),i=this.model.prediction?.predictions.find(s=>s.image===t.picture.id);e?t.show(e.x,e.y):i&&i.x!==null&&i.y!==null&&i.inside&&t.show(i.x,i.y)}}};var jh=500,co=class{constructor(t,e){this.model=t;this.isOpen=e;this.author=p("input",{id:"author",type:"text",autocomplete:"off",spellcheck:"false",maxlength:100});this.status=p("span",{class:"note"});this.entries=[];this.author.value=t.actions.author=localStorage.getItem("raybundle-author")??"",this.author.addEventListener("change",()=>{t.actions.author=this.author.value.trim(),localStorage.setItem("raybundle-author",t.actions.author)}),ot("journal-bar").append(p("label",{},x("studio_page.author"),this.author),Bt("studio_page.copy_all",()=>this.copy(this.entries.map(i=>i.command).filter(i=>i).join(`
`))),this.status),t.on("state",$n(()=>this.isOpen()&&void this.show()))}async show(){this.entries=(await Ot("/api/journal")).actions;let t=this.entries.slice(-jh).reverse();this.status.textContent=x("studio_page.actions",{n:this.entries.length,shown:Math.min(this.entries.length,jh)}),ot("journal").replaceChildren(p("table",{"aria-label":x("studio_page.journal")},De(["studio_page.number","label.time","studio_page.by","studio_page.action","studio_page.command","studio_page.copy"]),p("tbody",{},...t.map(e=>this.row(e)))))}row(t){let e=Bt("studio_page.copy",()=>this.copy(t.command),"small",{n:t.seq}),{image:i,point:s,start:r,end:o,line:a}=t.arguments,l=[i,s,r,o,a].filter(c=>typeof c=="string").join(" \xB7 ");return p("tr",{},p("td",{},String(t.seq)),p("td",{class:"whole"},t.time.replace("T"," ").slice(0,19)),p("td",{},t.author),p("td",{class:"l"},p("b",{},x("studio_page.verb",{verb:t.verb})),` ${l}`),p("td",{class:"l"},p("code",{},t.command)),p("td",{},t.command?e:""))}copy(t){navigator.clipboard.writeText(t).then(()=>this.model.say("studio_page.copied",{},"good"),()=>this.model.say("studio_page.not_copied",{},"bad"))}};var kp=[["studio_keys.anywhere",[["N","studio_keys.new_point"],["V","studio_keys.next_image"],["W","studio_keys.worst"],["studio_keys.ctrl_z","studio_keys.undo"],["studio_keys.ctrl_shift_z","studio_keys.redo"],["S","studio_keys.snap"],["L","studio_keys.loupe"],["C","studio_keys.centre"],["G","studio_keys.panes"],["[  ]","studio_keys.neighbour"],["Esc","studio_keys.no_point"],["F2","studio_keys.name"],["?","studio_keys.this_table"]]],["studio_keys.in_photograph",[["studio_keys.arrows","studio_keys.hair"],["Enter","studio_keys.mark"],["studio_keys.shift_arrows","studio_keys.move"],["studio_keys.delete","studio_keys.remove"],["P","studio_keys.choose"],["X","studio_keys.reject"],["studio_keys.of_mask","studio_keys.mask"],["+  -","studio_keys.zoom"],["0","studio_keys.whole"],["1","studio_keys.pixels"],["R","studio_keys.turn"]]],["studio_keys.by_mouse",[["studio_keys.click","studio_keys.click_deed"],["studio_keys.ctrl_click","studio_keys.choose"],["studio_keys.drag","studio_keys.drag_deed"],["studio_keys.wheel","studio_keys.zoom"],["studio_keys.shift_click","studio_keys.beside"]]]];function Yl(){let n=ot("keys");if(n.open)return n.close();n.replaceChildren(p("h2",{id:"keys-head"},x("studio_keys.title")),p("div",{class:"keys"},...kp.map(([t,e])=>p("section",{},p("h3",{},x(t)),p("dl",{},...e.flatMap(([i,s])=>[p("dt",{},p("kbd",{},x(i))),p("dd",{},x(s))]))))),Bt("studio_keys.close",()=>n.close(),"main")),n.showModal()}function Jh(n,t,e){let i=0,s=!1;addEventListener("keydown",r=>{if(ot("keys").open&&r.key!=="?")return;let o=r.ctrlKey||r.metaKey;if(Uh(r.target)&&r.key!=="Escape"&&r.key!=="F2")return;if(!o&&!r.altKey&&r.key.toLowerCase()==="l")return r.repeat||(i=performance.now(),s=e(),t(!0)),r.preventDefault();let a=`${o?"ctrl ":""}${o&&r.shiftKey?"shift ":""}${r.key.toLowerCase()}`,l=r.altKey?void 0:n[a];l&&(r.preventDefault(),l())}),addEventListener("keyup",r=>{r.key.toLowerCase()!=="l"||!i||(performance.now()-i>350?t(!1):t(!s),i=0)})}function Qh(n,t){let e=500,i=!1,s=()=>{let r=new WebSocket(`${location.protocol==="https:"?"wss":"ws"}://${location.host}/api/live`),o=setInterval(()=>r.readyState===WebSocket.OPEN&&r.send('{"type":"here"}'),2e4);r.addEventListener("open",()=>{e=500,t(!0,i),i=!0}),r.addEventListener("message",a=>n(JSON.parse(a.data))),r.addEventListener("close",()=>{clearInterval(o),t(!1,i),setTimeout(s,e),e=Math.min(2*e,8e3)})};s()}var ho=class{constructor(t,e){this.model=t;this.toPhoto=e;this.name=ri("mask-name",x("studio_point.mask_name"),{maxlength:"200"});this.camera=p("input",{type:"checkbox",id:"mask-camera"});this.rows=p("table",{"aria-label":x("studio_point.masks")});this.head=p("summary",{},x("studio_point.masks"));this.about=p("p",{class:"note","aria-live":"polite"});this.begin=Bt("studio_point.draw_mask",()=>this.draw());this.give=p("button",{type:"submit",id:"mask-give",class:"main"},x("studio_point.exclude"));this.last=Bt("studio_point.last_corner",()=>Zt.removeLast());this.form=p("form",{hidden:!0},p("div",{class:"row"},this.name),p("label",{class:"check"},this.camera,x("studio_point.mask_of_camera")),p("div",{class:"row"},this.last,Bt("studio_point.cancel_mask",()=>Zt.end()),this.give)),this.form.addEventListener("submit",i=>{i.preventDefault(),this.exclude()}),this.begin.id="mask-draw",ot("right").append(p("details",{class:"card",id:"masks"},this.head,this.about,this.rows,this.begin,this.form)),t.on(["state","overview"],()=>this.show()),Zt.onchange(()=>{this.show(),t.emit("looks")})}draw(){let t=new Set(this.model.state.masks.map(i=>i.mask)),e=1;for(;t.has(x("studio_point.mask_default",{number:e}));)e++;this.name.value=x("studio_point.mask_default",{number:e}),this.camera.checked=!1,Zt.begin(),this.toPhoto(""),this.form.scrollIntoView({block:"nearest"})}edit(t){this.name.value=t.mask,this.camera.checked=t.camera,Zt.begin(t.image,t.polygon.map(([e,i])=>[e,i])),this.toPhoto(t.image),this.form.scrollIntoView({block:"nearest"})}async exclude(){let{corners:t,image:e}=Zt;if(!e)return this.model.say("studio_point.no_corner",{},"bad");let i=this.name.value.trim(),s={mask:i,image:e,polygon:t,camera:this.camera.checked};await this.model.act("mask",s,"studio_point.mask_given",{mask:i})&&Zt.end()}show(){let{state:t,overview:e}=this.model;this.head.textContent=jn(x("studio_point.masks"),t.masks.length),this.form.hidden=!Zt.on,this.begin.hidden=Zt.on,this.give.disabled=Zt.corners.length<3,this.last.disabled=!Zt.corners.length,this.about.textContent=Zt.on?x("studio_point.corners",{n:Zt.corners.length,image:Zt.image||"none"}):x("studio_point.masks_note",{folder:e.masks_given||"none"}),this.rows.hidden=!t.masks.length,this.rows.replaceChildren(...t.masks.map(i=>p("tr",{},p("td",{},jt(i.mask,x("studio_point.edit_mask",{mask:i.mask}),()=>this.edit(i),"link")),p("td",{class:"l"},i.camera?x("studio_point.camera_of",{image:i.image}):i.image),p("td",{},jt("\u2715",x("studio_point.remove",{name:i.mask}),()=>void this.model.act("unmask",{mask:i.mask},"studio_point.removed",{name:i.mask}),"small")))))}};var Bp=5e3,uo=class{constructor(){this.waiting=[];this.busy=!1;this.author="";this.onwaiting=()=>{};addEventListener("beforeunload",t=>{this.waiting.length&&t.preventDefault()})}send(t,e){return this.put("/api/action",{verb:t,arguments:e})}control(t,e){return this.put("/api/control",{file:t,text:e})}reject(t,e){return this.put("/api/reject",{by:t,limit:e})}fiducials(t){return this.put("/api/fiducials",{image:t})}put(t,e){let i={id:crypto.randomUUID(),author:this.author,...e};return new Promise((s,r)=>{this.waiting.push({path:t,body:i,done:s,refused:r}),this.work()})}async work(){if(this.busy)return;this.busy=!0;let t=250;for(;this.waiting.length;){let{path:e,body:i,done:s,refused:r}=this.waiting[0];this.onwaiting(this.waiting.length,t>250);try{let o=await Ue(e,i);this.waiting.shift(),t=250,s(o)}catch(o){if(o instanceof _i&&o.status<500){this.waiting.shift(),r(o);continue}t=Math.min(2*t,Bp),this.onwaiting(this.waiting.length,!0),await new Promise(a=>setTimeout(a,t))}}this.busy=!1,this.onwaiting(0,!1)}};var fo=class{constructor(){this.images=new Map;this.actions=new uo;this.current="";this.fiducial="";this.prediction=null;this.panes=[];this.active=0;this.run=null;this.message={code:"",words:"",kind:""};this.command="";this.marks=new Map;this.given=new Map;this.listeners=new Map;this.turn=0;this.predictSoon=Oe($n(()=>void this.predict()),20)}on(t,e){for(let i of Array.isArray(t)?t:[t])this.listeners.set(i,[...this.listeners.get(i)??[],e])}emit(t){for(let e of this.listeners.get(t)??[])e()}async read(){this.overview=await Ot("/api/overview"),ke.readAnew(this.overview.times),this.images.clear(),this.overview.images.forEach((t,e)=>this.images.set(t.id,{...t,k:e})),this.given.clear(),this.take(this.overview.state),this.emit("overview"),this.emit("read"),this.emit("observations"),this.predictSoon()}take(t){if(!(this.state&&t.seq<this.state.seq)){this.state=t,this.marks.clear();for(let e of t.marks)this.marks.set(e.image,[...this.marks.get(e.image)??[],e]);this.emit("state"),this.predictSoon()}}async act(t,e,i,s={}){try{let r=await this.actions.send(t,e);this.command=r.command,this.take(r.state);let{test:o}=r;return this.show([x(i,s),o?.words??""].filter(a=>a).reverse().join(" "),o?.off?"bad":"good",i),!0}catch(r){return this.fail(r),!1}}say(t,e={},i=""){this.show(x(t,e),i,t)}show(t,e="",i=""){let s=e==="bad"&&i&&!i.startsWith("studio_");this.message={code:i,words:s?`${t} [${i}]`:t,kind:e},this.emit("message")}fail(t){this.show(t.message,"bad",t instanceof _i?t.code:"")}choose(t){this.fiducial&&this.chooseFiducial(""),t!==this.current&&(this.current=t,this.prediction=null,this.emit("current"),this.predictSoon())}chooseFiducial(t){this.fiducial=t,this.emit("fiducial")}fiducialsIn(t){return this.state.fiducials.filter(e=>e.image===t)}marksIn(t){return this.marks.get(t)??[]}mark(t,e){return this.marksIn(t).find(i=>i.point===e)}marksOf(t){return this.state.marks.filter(e=>e.point===t)}isRejected(t,e){return this.state.rejected.some(([i,s])=>i===t&&s===e)}roleOf(t){return this.state.points.find(e=>e.point===t)?.role??"tie"}observations(t){let e=this.given.get(t);return e||(e=Ot("/api/observations",{image:t}),e.catch(()=>this.given.delete(t)),this.given.set(t,e)),e}setPanes(t,e){this.panes=t,this.active=e,this.emit("panes"),this.predictSoon()}async predict(){let t=++this.turn,e=this.current;if(!e){this.prediction=null,this.emit("prediction");return}try{let i=await Ot("/api/predict",{point:e,images:[...new Set(this.panes)]});if(t!==this.turn)return;this.prediction=i,this.emit("prediction")}catch(i){i instanceof _i&&this.fail(i)}}};var po=class{constructor(t,e,i){this.model=t;this.measuring=e;this.going=i;this.name=p("input",{id:"point-name",type:"text","aria-label":x("studio_point.current_name"),placeholder:x("studio_point.current_none"),autocomplete:"off",spellcheck:"false",list:"point-names",maxlength:200});this.names=p("datalist",{id:"point-names"});this.where=p("table",{class:"where","aria-label":x("studio_point.coordinates")});this.about=p("p",{class:"note","aria-live":"polite"});this.marks=p("table",{class:"marks","aria-label":x("studio_point.marks")});this.visibleHead=p("h3",{});this.search=p("input",{type:"search",id:"point-search","aria-label":x("studio_point.filter"),placeholder:x("studio_point.filter"),autocomplete:"off",spellcheck:"false"});this.pointsHead=p("summary",{},x("studio_point.points"));this.snap=p("select",{id:"snap"},...we(Fs,t=>x("studio_point.how",{how:t})));this.visited=-1;this.visible=new Sn(x("studio_point.visible_images"),r=>r.image,r=>[p("b",{},r.image),p("small",{title:x("studio_point.angle")},`${r.angle_deg.toFixed(0)}\xB0`)],r=>i.visit(r.image,r.x,r.y)),this.points=new Sn(x("studio_point.points"),r=>r.point,r=>this.pointRow(r),r=>t.choose(r.point)),ot("right").append(this.current(),this.list()),this.name.addEventListener("change",()=>this.chooseNamed()),this.name.addEventListener("input",Oe(()=>void this.suggest(),150)),this.search.addEventListener("input",Oe(()=>void this.showPoints(),150)),this.snap.addEventListener("change",()=>Xt.snap=this.snap.value),t.on("current",()=>{this.visited=-1,this.name.value=t.current,this.points.select(t.current)}),t.on(["current","prediction","state"],()=>this.show());let s=Oe($n(()=>void this.showPoints()),60);t.on(["state","read"],s)}current(){return p("section",{class:"card","aria-label":x("studio_point.current")},p("h2",{},x("studio_point.current")),p("div",{class:"row"},this.name,this.names,Bt("studio_point.new",()=>void this.measuring.newPoint(),"main")),p("div",{class:"row"},p("label",{},x("studio_point.snap"),this.snap),Bt("studio_point.worst_next",()=>void this.worst())),this.where,this.about,this.marks,this.visibleHead,this.visible.root)}list(){return p("details",{class:"card",open:!0},this.pointsHead,p("div",{class:"row"},this.search),this.points.root)}chooseNamed(){this.model.choose(this.name.value.trim()),this.name.blur()}async suggest(){let t=await Ot("/api/points",{search:this.name.value.trim(),limit:12});this.names.replaceChildren(...t.rows.map(e=>p("option",{value:e.point})))}typeName(){this.name.focus(),this.name.select()}nextSnap(){Xt.snap=Fs[(Fs.indexOf(Xt.snap)+1)%Fs.length],this.snap.value=Xt.snap,this.model.say("studio_point.snapping",{how:Xt.snap})}visitNext(){let t=this.model.prediction?.visible??[];if(!t.length)return this.model.say("studio_point.none_visible");this.visited=(this.visited+1)%t.length;let{image:e,x:i,y:s}=t[this.visited];this.visible.select(e),this.going.visit(e,i,s)}async worst(){let t=await this.measuring.worstNext();t&&(this.model.choose(t.point),await this.goTo(t.point,t.image))}async goTo(t,e=""){let i=this.model.marksOf(t).find(o=>!e||o.image===e);if(i)return this.going.visit(i.image,i.x,i.y);let s=e?[e]:[...this.model.images.keys()].slice(0,400);for(let o of s){let a=await this.model.observations(o),l=a.point.indexOf(t);if(l>=0)return this.going.visit(o,a.x[l],a.y[l])}let r=this.model.prediction?.visible[0];r&&this.going.visit(r.image,r.x,r.y)}show(){let{model:t}=this,e=t.prediction?.point===t.current?t.prediction:null,{unit:i}=t.overview;if(this.where.replaceChildren(),e?.located.xyz){let r=e.located.sigma,o=p("tr",{},p("td"),p("th",{scope:"col"},i||x("studio_point.no_unit")),p("th",{scope:"col"},x("label.sigma")));this.where.append(o,...["X","Y","Z"].map((a,l)=>p("tr",{},p("th",{scope:"row"},a),p("td",{},Ct(e.located.xyz[l],si(r?.[l]))),p("td",{class:"sigma"},r?Ct(r[l],si(r[l])):"\u2013"))))}this.about.textContent=this.words(e),this.showMarks(e);let s=e?.visible??[];this.visibleHead.hidden=this.visible.root.hidden=!s.length,this.visibleHead.textContent=x("studio_point.visible",{n:s.length}),this.visible.set(s)}words(t){let{model:e}=this;if(!e.current)return x("studio_point.choose_or_begin");if(!t)return"";let{source:i,rays:s,neglected:r}=t.located;return[x("studio_point.located",{source:i,n:s}),r].join(" ")}showMarks(t){let{model:e}=this,i=e.marksOf(e.current);this.marks.hidden=!i.length,this.marks.replaceChildren(De(["label.image","studio_point.by","studio_point.sigma_px","studio_point.vx","studio_point.vy",""]),...i.map(s=>{let r=t?.located.residuals[s.image],o=jt(s.image,x("studio_point.show",{point:s.image}),()=>this.going.visit(s.image,s.x,s.y),"link"),a=jt("\u2715",x("studio_point.remove",{name:s.image}),()=>void e.act("remove",{image:s.image,point:s.point},"studio_point.mark_removed",{point:s.point}),"small"),l=Math.sqrt(Math.max(s.cov[0],s.cov[1]));return p("tr",{},p("td",{},o),p("td",{},x("studio_point.how",{how:s.how})),p("td",{},Et(l,2)),...this.residual(s,r),p("td",{},a))}))}residual(t,e){let i=[0,1].map(s=>p("td",{},Ct(e?.[s],2)));return e||this.model.observations(t.image).then(s=>{let r=s.point.indexOf(t.point);r>=0&&Math.hypot(s.x[r]-t.x,s.y[r]-t.y)<.001&&([i[0].textContent,i[1].textContent]=[Ct(s.vx[r],2),Ct(s.vy[r],2)])},()=>{}),i}pointRow(t){let e=this.model.marksOf(t.point).length,i=Math.max(...t.sigma.map(r=>r??-1)),s=[t.role==="tie"?"":x("studio_point.role",{role:t.role}),e?x("studio_point.mark_count",{n:e}):"",t.rays?x("studio_photo.rays",{n:t.rays}):"",i>=0?`s ${Et(i,2)}`:""];return[p("b",{},t.point),p("small",{},s.filter(r=>r).join(" \xB7 "))]}async showPoints(){let{model:t}=this,e=this.search.value.trim(),i=await Ot("/api/points",{search:e,limit:60}),s=new Map(i.rows.map(a=>[a.point,a])),r=t.state.points.filter(a=>a.point.toLowerCase().includes(e.toLowerCase())).map(a=>({...s.get(a.point)??{rays:0,w:null,xyz:a.xyz,sigma:[null,null,null]},point:a.point,role:a.role})),o=new Set(r.map(a=>a.point));this.points.set([...r,...i.rows.filter(a=>!o.has(a.point))],t.current),this.pointsHead.textContent=x("studio_point.points_of",{n:t.state.points.length,of:t.overview.points})}};var gn={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},_n={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Tu=0,wc=1,Au=2;var Sc=1,Ru=2,Oi=3,ji=0,je=1,ki=2,Qi=0,Dn=1,Ec=2,Tc=3,Ac=4,Cu=5,dn=100,Pu=101,Iu=102,Lu=103,Du=104,Uu=200,Nu=201,Fu=202,Ou=203,Bo=204,zo=205,ku=206,Bu=207,zu=208,Hu=209,Vu=210,Gu=211,Wu=212,Xu=213,qu=214,da=0,fa=1,pa=2,Un=3,ma=4,ga=5,_a=6,va=7,ya=0,Yu=1,$u=2,tn=0,Zu=1,Ku=2,ju=3,Ju=4,Qu=5,td=6,ed=7;var Rc=300,Bn=301,zn=302,xa=303,ba=304,wr=306,Ho=1e3,un=1001,Vo=1002,ti=1003,id=1004;var Sr=1005;var Mi=1006,Ma=1007;var vn=1008;var Bi=1009,Cc=1010,Pc=1011,xs=1012,wa=1013,yn=1014,Ti=1015,bs=1016,Sa=1017,Ea=1018,Ms=1020,Ic=35902,Lc=35899,Dc=1021,Uc=1022,pi=1023,fs=1026,ws=1027,Ta=1028,Aa=1029,Nc=1030,Ra=1031;var Ca=1033,Er=33776,Tr=33777,Ar=33778,Rr=33779,Pa=35840,Ia=35841,La=35842,Da=35843,Ua=36196,Na=37492,Fa=37496,Oa=37808,ka=37809,Ba=37810,za=37811,Ha=37812,Va=37813,Ga=37814,Wa=37815,Xa=37816,qa=37817,Ya=37818,$a=37819,Za=37820,Ka=37821,ja=36492,Ja=36494,Qa=36495,tl=36283,el=36284,il=36285,nl=36286;var Qs=2300,Go=2301,ko=2302,gc=2400,_c=2401,vc=2402;var nd=3200,sd=3201;var Fc=0,rd=1,en="",li="srgb",Nn="srgb-linear",tr="linear",ne="srgb";var In=7680;var yc=519,od=512,ad=513,ld=514,Oc=515,cd=516,hd=517,ud=518,dd=519,xc=35044;var kc="300 es",bi=2e3,er=2001;var Ii=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},ze=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],tu=1234567,js=Math.PI/180,ps=180/Math.PI;function Ss(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ze[n&255]+ze[n>>8&255]+ze[n>>16&255]+ze[n>>24&255]+"-"+ze[t&255]+ze[t>>8&255]+"-"+ze[t>>16&15|64]+ze[t>>24&255]+"-"+ze[e&63|128]+ze[e>>8&255]+"-"+ze[e>>16&255]+ze[e>>24&255]+ze[i&255]+ze[i>>8&255]+ze[i>>16&255]+ze[i>>24&255]).toLowerCase()}function qt(n,t,e){return Math.max(t,Math.min(e,n))}function Bc(n,t){return(n%t+t)%t}function zp(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function Hp(n,t,e){return n!==t?(e-n)/(t-n):0}function Js(n,t,e){return(1-e)*n+e*t}function Vp(n,t,e,i){return Js(n,t,1-Math.exp(-e*i))}function Gp(n,t=1){return t-Math.abs(Bc(n,t*2)-t)}function Wp(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Xp(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function qp(n,t){return n+Math.floor(Math.random()*(t-n+1))}function Yp(n,t){return n+Math.random()*(t-n)}function $p(n){return n*(.5-Math.random())}function Zp(n){n!==void 0&&(tu=n);let t=tu+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Kp(n){return n*js}function jp(n){return n*ps}function Jp(n){return(n&n-1)===0&&n!==0}function Qp(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function tm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function em(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),h=o((t+i)/2),u=r((t-i)/2),d=o((t-i)/2),m=r((i-t)/2),v=o((i-t)/2);switch(s){case"XYX":n.set(a*h,l*u,l*d,a*c);break;case"YZY":n.set(l*d,a*h,l*u,a*c);break;case"ZXZ":n.set(l*u,l*d,a*h,a*c);break;case"XZX":n.set(a*h,l*v,l*m,a*c);break;case"YXY":n.set(l*m,a*h,l*v,a*c);break;case"ZYZ":n.set(l*v,l*m,a*h,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function us(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function Ye(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}var zc={DEG2RAD:js,RAD2DEG:ps,generateUUID:Ss,clamp:qt,euclideanModulo:Bc,mapLinear:zp,inverseLerp:Hp,lerp:Js,damp:Vp,pingpong:Gp,smoothstep:Wp,smootherstep:Xp,randInt:qp,randFloat:Yp,randFloatSpread:$p,seededRandom:Zp,degToRad:Kp,radToDeg:jp,isPowerOfTwo:Jp,ceilPowerOfTwo:Qp,floorPowerOfTwo:tm,setQuaternionFromProperEuler:em,normalize:Ye,denormalize:us},zt=class n{constructor(t=0,e=0){n.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=qt(this.x,t.x,e.x),this.y=qt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=qt(this.x,t,e),this.y=qt(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(qt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(qt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},fi=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],d=r[o+0],m=r[o+1],v=r[o+2],w=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u;return}if(a===1){t[e+0]=d,t[e+1]=m,t[e+2]=v,t[e+3]=w;return}if(u!==w||l!==d||c!==m||h!==v){let g=1-a,f=l*d+c*m+h*v+u*w,R=f>=0?1:-1,T=1-f*f;if(T>Number.EPSILON){let I=Math.sqrt(T),P=Math.atan2(I,f*R);g=Math.sin(g*P)/I,a=Math.sin(a*P)/I}let S=a*R;if(l=l*g+d*S,c=c*g+m*S,h=h*g+v*S,u=u*g+w*S,g===1-a){let I=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=I,c*=I,h*=I,u*=I}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[o],d=r[o+1],m=r[o+2],v=r[o+3];return t[e]=a*v+h*u+l*m-c*d,t[e+1]=l*v+h*d+c*u-a*m,t[e+2]=c*v+h*m+a*d-l*u,t[e+3]=h*v-a*u-l*d-c*m,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),u=a(r/2),d=l(i/2),m=l(s/2),v=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*m*v,this._y=c*m*u-d*h*v,this._z=c*h*v+d*m*u,this._w=c*h*u-d*m*v;break;case"YXZ":this._x=d*h*u+c*m*v,this._y=c*m*u-d*h*v,this._z=c*h*v-d*m*u,this._w=c*h*u+d*m*v;break;case"ZXY":this._x=d*h*u-c*m*v,this._y=c*m*u+d*h*v,this._z=c*h*v+d*m*u,this._w=c*h*u-d*m*v;break;case"ZYX":this._x=d*h*u-c*m*v,this._y=c*m*u+d*h*v,this._z=c*h*v-d*m*u,this._w=c*h*u+d*m*v;break;case"YZX":this._x=d*h*u+c*m*v,this._y=c*m*u+d*h*v,this._z=c*h*v-d*m*u,this._w=c*h*u-d*m*v;break;case"XZY":this._x=d*h*u-c*m*v,this._y=c*m*u-d*h*v,this._z=c*h*v+d*m*u,this._w=c*h*u+d*m*v;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=i+a+u;if(d>0){let m=.5/Math.sqrt(d+1);this._w=.25/m,this._x=(h-l)*m,this._y=(r-c)*m,this._z=(o-s)*m}else if(i>a&&i>u){let m=2*Math.sqrt(1+i-a-u);this._w=(h-l)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+c)/m}else if(a>u){let m=2*Math.sqrt(1+a-i-u);this._w=(r-c)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(l+h)/m}else{let m=2*Math.sqrt(1+u-i-a);this._w=(o-s)/m,this._x=(r+c)/m,this._y=(l+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(qt(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);let i=this._x,s=this._y,r=this._z,o=this._w,a=o*t._w+i*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=i,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let m=1-e;return this._w=m*o+e*this._w,this._x=m*i+e*this._x,this._y=m*s+e*this._y,this._z=m*r+e*this._z,this.normalize(),this}let c=Math.sqrt(l),h=Math.atan2(c,a),u=Math.sin((1-e)*h)/c,d=Math.sin(e*h)/c;return this._w=o*u+this._w*d,this._x=i*u+this._x*d,this._y=s*u+this._y*d,this._z=r*u+this._z*d,this._onChangeCallback(),this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},F=class n{constructor(t=0,e=0,i=0){n.prototype.isVector3=!0,this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(eu.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(eu.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),h=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+l*c+o*u-a*h,this.y=i+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=qt(this.x,t.x,e.x),this.y=qt(this.y,t.y,e.y),this.z=qt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=qt(this.x,t,e),this.y=qt(this.y,t,e),this.z=qt(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(qt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return $l.copy(this).projectOnVector(t),this.sub($l)}reflect(t){return this.sub($l.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(qt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},$l=new F,eu=new fi,Ht=class n{constructor(t,e,i,s,r,o,a,l,c){n.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],u=i[7],d=i[2],m=i[5],v=i[8],w=s[0],g=s[3],f=s[6],R=s[1],T=s[4],S=s[7],I=s[2],P=s[5],D=s[8];return r[0]=o*w+a*R+l*I,r[3]=o*g+a*T+l*P,r[6]=o*f+a*S+l*D,r[1]=c*w+h*R+u*I,r[4]=c*g+h*T+u*P,r[7]=c*f+h*S+u*D,r[2]=d*w+m*R+v*I,r[5]=d*g+m*T+v*P,r[8]=d*f+m*S+v*D,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=a*l-h*r,m=c*r-o*l,v=e*u+i*d+s*m;if(v===0)return this.set(0,0,0,0,0,0,0,0,0);let w=1/v;return t[0]=u*w,t[1]=(s*c-h*i)*w,t[2]=(a*i-s*o)*w,t[3]=d*w,t[4]=(h*e-s*l)*w,t[5]=(s*r-a*e)*w,t[6]=m*w,t[7]=(i*l-c*e)*w,t[8]=(o*e-i*r)*w,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(Zl.makeScale(t,e)),this}rotate(t){return this.premultiply(Zl.makeRotation(-t)),this}translate(t,e){return this.premultiply(Zl.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Zl=new Ht;function Hc(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function ir(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function fd(){let n=ir("canvas");return n.style.display="block",n}var iu={};function ms(n){n in iu||(iu[n]=!0,console.warn(n))}function pd(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var nu=new Ht().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),su=new Ht().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function im(){let n={enabled:!0,workingColorSpace:Nn,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===ne&&(s.r=Ki(s.r),s.g=Ki(s.g),s.b=Ki(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===ne&&(s.r=ds(s.r),s.g=ds(s.g),s.b=ds(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===en?tr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return ms("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),n.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return ms("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),n.colorSpaceToWorking(s,r)}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Nn]:{primaries:t,whitePoint:i,transfer:tr,toXYZ:nu,fromXYZ:su,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:li},outputColorSpaceConfig:{drawingBufferColorSpace:li}},[li]:{primaries:t,whitePoint:i,transfer:ne,toXYZ:nu,fromXYZ:su,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:li}}}),n}var Jt=im();function Ki(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ds(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Jn,Wo=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Jn===void 0&&(Jn=ir("canvas")),Jn.width=t.width,Jn.height=t.height;let s=Jn.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Jn}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ir("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ki(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Ki(e[i]/255)*255):e[i]=Ki(e[i]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},nm=0,gs=class{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:nm++}),this.uuid=Ss(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):e instanceof VideoFrame?t.set(e.displayHeight,e.displayWidth,0):e!==null?t.set(e.width,e.height,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Kl(s[o].image)):r.push(Kl(s[o]))}else r=Kl(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Kl(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Wo.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var sm=0,jl=new F,Ke=class n extends Ii{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=un,s=un,r=Mi,o=vn,a=pi,l=Bi,c=n.DEFAULT_ANISOTROPY,h=en){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:sm++}),this.uuid=Ss(),this.name="",this.source=new gs(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new zt(0,0),this.repeat=new zt(1,1),this.center=new zt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ht,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(jl).x}get height(){return this.source.getSize(jl).y}get depth(){return this.source.getSize(jl).z}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){console.warn(`THREE.Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Rc)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ho:t.x=t.x-Math.floor(t.x);break;case un:t.x=t.x<0?0:1;break;case Vo:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ho:t.y=t.y-Math.floor(t.y);break;case un:t.y=t.y<0?0:1;break;case Vo:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Ke.DEFAULT_IMAGE=null;Ke.DEFAULT_MAPPING=Rc;Ke.DEFAULT_ANISOTROPY=1;var xe=class n{constructor(t=0,e=0,i=0,s=1){n.prototype.isVector4=!0,this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],m=l[5],v=l[9],w=l[2],g=l[6],f=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-w)<.01&&Math.abs(v-g)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+w)<.1&&Math.abs(v+g)<.1&&Math.abs(c+m+f-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let T=(c+1)/2,S=(m+1)/2,I=(f+1)/2,P=(h+d)/4,D=(u+w)/4,k=(v+g)/4;return T>S&&T>I?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=P/i,r=D/i):S>I?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=P/s,r=k/s):I<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),i=D/r,s=k/r),this.set(i,s,r,e),this}let R=Math.sqrt((g-v)*(g-v)+(u-w)*(u-w)+(d-h)*(d-h));return Math.abs(R)<.001&&(R=1),this.x=(g-v)/R,this.y=(u-w)/R,this.z=(d-h)/R,this.w=Math.acos((c+m+f-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=qt(this.x,t.x,e.x),this.y=qt(this.y,t.y,e.y),this.z=qt(this.z,t.z,e.z),this.w=qt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=qt(this.x,t,e),this.y=qt(this.y,t,e),this.z=qt(this.z,t,e),this.w=qt(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(qt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Xo=class extends Ii{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Mi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new xe(0,0,t,e),this.scissorTest=!1,this.viewport=new xe(0,0,t,e);let s={width:t,height:e,depth:i.depth},r=new Ke(s);this.textures=[];let o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview}_setTextureOptions(t={}){let e={minFilter:Mi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),t!==null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new gs(s)}return this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Li=class extends Xo{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},nr=class extends Ke{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ti,this.minFilter=ti,this.wrapR=un,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var qo=class extends Ke{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ti,this.minFilter=ti,this.wrapR=un,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Di=class{constructor(t=new F(1/0,1/0,1/0),e=new F(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(vi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(vi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=vi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,vi):vi.fromBufferAttribute(r,o),vi.applyMatrix4(t.matrixWorld),this.expandByPoint(vi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),mo.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),mo.copy(i.boundingBox)),mo.applyMatrix4(t.matrixWorld),this.union(mo)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,vi),vi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ws),go.subVectors(this.max,Ws),Qn.subVectors(t.a,Ws),ts.subVectors(t.b,Ws),es.subVectors(t.c,Ws),sn.subVectors(ts,Qn),rn.subVectors(es,ts),An.subVectors(Qn,es);let e=[0,-sn.z,sn.y,0,-rn.z,rn.y,0,-An.z,An.y,sn.z,0,-sn.x,rn.z,0,-rn.x,An.z,0,-An.x,-sn.y,sn.x,0,-rn.y,rn.x,0,-An.y,An.x,0];return!Jl(e,Qn,ts,es,go)||(e=[1,0,0,0,1,0,0,0,1],!Jl(e,Qn,ts,es,go))?!1:(_o.crossVectors(sn,rn),e=[_o.x,_o.y,_o.z],Jl(e,Qn,ts,es,go))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,vi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(vi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Xi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Xi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Xi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Xi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Xi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Xi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Xi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Xi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Xi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Xi=[new F,new F,new F,new F,new F,new F,new F,new F],vi=new F,mo=new Di,Qn=new F,ts=new F,es=new F,sn=new F,rn=new F,An=new F,Ws=new F,go=new F,_o=new F,Rn=new F;function Jl(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Rn.fromArray(n,r);let a=s.x*Math.abs(Rn.x)+s.y*Math.abs(Rn.y)+s.z*Math.abs(Rn.z),l=t.dot(Rn),c=e.dot(Rn),h=i.dot(Rn);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var rm=new Di,Xs=new F,Ql=new F,Ui=class{constructor(t=new F,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):rm.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Xs.subVectors(t,this.center);let e=Xs.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Xs,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Ql.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Xs.copy(t.center).add(Ql)),this.expandByPoint(Xs.copy(t.center).sub(Ql))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},qi=new F,tc=new F,vo=new F,on=new F,ec=new F,yo=new F,ic=new F,fn=class{constructor(t=new F,e=new F(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,qi)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=qi.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(qi.copy(this.origin).addScaledVector(this.direction,e),qi.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){tc.copy(t).add(e).multiplyScalar(.5),vo.copy(e).sub(t).normalize(),on.copy(this.origin).sub(tc);let r=t.distanceTo(e)*.5,o=-this.direction.dot(vo),a=on.dot(this.direction),l=-on.dot(vo),c=on.lengthSq(),h=Math.abs(1-o*o),u,d,m,v;if(h>0)if(u=o*l-a,d=o*a-l,v=r*h,u>=0)if(d>=-v)if(d<=v){let w=1/h;u*=w,d*=w,m=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),m=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),m=-u*u+d*(d+2*l)+c;else d<=-v?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),m=-u*u+d*(d+2*l)+c):d<=v?(u=0,d=Math.min(Math.max(-r,-l),r),m=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),m=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),m=-u*u+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(tc).addScaledVector(vo,d),m}intersectSphere(t,e){qi.subVectors(t.center,this.origin);let i=qi.dot(this.direction),s=qi.dot(qi)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,qi)!==null}intersectTriangle(t,e,i,s,r){ec.subVectors(e,t),yo.subVectors(i,t),ic.crossVectors(ec,yo);let o=this.direction.dot(ic),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;on.subVectors(this.origin,t);let l=a*this.direction.dot(yo.crossVectors(on,yo));if(l<0)return null;let c=a*this.direction.dot(ec.cross(on));if(c<0||l+c>o)return null;let h=-a*on.dot(ic);return h<0?null:this.at(h/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ae=class n{constructor(t,e,i,s,r,o,a,l,c,h,u,d,m,v,w,g){n.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,h,u,d,m,v,w,g)}set(t,e,i,s,r,o,a,l,c,h,u,d,m,v,w,g){let f=this.elements;return f[0]=t,f[4]=e,f[8]=i,f[12]=s,f[1]=r,f[5]=o,f[9]=a,f[13]=l,f[2]=c,f[6]=h,f[10]=u,f[14]=d,f[3]=m,f[7]=v,f[11]=w,f[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){let e=this.elements,i=t.elements,s=1/is.setFromMatrixColumn(t,0).length(),r=1/is.setFromMatrixColumn(t,1).length(),o=1/is.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,m=o*u,v=a*h,w=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=m+v*c,e[5]=d-w*c,e[9]=-a*l,e[2]=w-d*c,e[6]=v+m*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*h,m=l*u,v=c*h,w=c*u;e[0]=d+w*a,e[4]=v*a-m,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=m*a-v,e[6]=w+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*h,m=l*u,v=c*h,w=c*u;e[0]=d-w*a,e[4]=-o*u,e[8]=v+m*a,e[1]=m+v*a,e[5]=o*h,e[9]=w-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*h,m=o*u,v=a*h,w=a*u;e[0]=l*h,e[4]=v*c-m,e[8]=d*c+w,e[1]=l*u,e[5]=w*c+d,e[9]=m*c-v,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,m=o*c,v=a*l,w=a*c;e[0]=l*h,e[4]=w-d*u,e[8]=v*u+m,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=m*u+v,e[10]=d-w*u}else if(t.order==="XZY"){let d=o*l,m=o*c,v=a*l,w=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+w,e[5]=o*h,e[9]=m*u-v,e[2]=v*u-m,e[6]=a*h,e[10]=w*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(om,t,am)}lookAt(t,e,i){let s=this.elements;return oi.subVectors(t,e),oi.lengthSq()===0&&(oi.z=1),oi.normalize(),an.crossVectors(i,oi),an.lengthSq()===0&&(Math.abs(i.z)===1?oi.x+=1e-4:oi.z+=1e-4,oi.normalize(),an.crossVectors(i,oi)),an.normalize(),xo.crossVectors(oi,an),s[0]=an.x,s[4]=xo.x,s[8]=oi.x,s[1]=an.y,s[5]=xo.y,s[9]=oi.y,s[2]=an.z,s[6]=xo.z,s[10]=oi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],u=i[5],d=i[9],m=i[13],v=i[2],w=i[6],g=i[10],f=i[14],R=i[3],T=i[7],S=i[11],I=i[15],P=s[0],D=s[4],k=s[8],y=s[12],b=s[1],C=s[5],B=s[9],V=s[13],X=s[2],K=s[6],Y=s[10],nt=s[14],G=s[3],lt=s[7],dt=s[11],Tt=s[15];return r[0]=o*P+a*b+l*X+c*G,r[4]=o*D+a*C+l*K+c*lt,r[8]=o*k+a*B+l*Y+c*dt,r[12]=o*y+a*V+l*nt+c*Tt,r[1]=h*P+u*b+d*X+m*G,r[5]=h*D+u*C+d*K+m*lt,r[9]=h*k+u*B+d*Y+m*dt,r[13]=h*y+u*V+d*nt+m*Tt,r[2]=v*P+w*b+g*X+f*G,r[6]=v*D+w*C+g*K+f*lt,r[10]=v*k+w*B+g*Y+f*dt,r[14]=v*y+w*V+g*nt+f*Tt,r[3]=R*P+T*b+S*X+I*G,r[7]=R*D+T*C+S*K+I*lt,r[11]=R*k+T*B+S*Y+I*dt,r[15]=R*y+T*V+S*nt+I*Tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],m=t[14],v=t[3],w=t[7],g=t[11],f=t[15];return v*(+r*l*u-s*c*u-r*a*d+i*c*d+s*a*m-i*l*m)+w*(+e*l*m-e*c*d+r*o*d-s*o*m+s*c*h-r*l*h)+g*(+e*c*u-e*a*m-r*o*u+i*o*m+r*a*h-i*c*h)+f*(-s*a*h-e*l*u+e*a*d+s*o*u-i*o*d+i*l*h)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],m=t[11],v=t[12],w=t[13],g=t[14],f=t[15],R=u*g*c-w*d*c+w*l*m-a*g*m-u*l*f+a*d*f,T=v*d*c-h*g*c-v*l*m+o*g*m+h*l*f-o*d*f,S=h*w*c-v*u*c+v*a*m-o*w*m-h*a*f+o*u*f,I=v*u*l-h*w*l-v*a*d+o*w*d+h*a*g-o*u*g,P=e*R+i*T+s*S+r*I;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let D=1/P;return t[0]=R*D,t[1]=(w*d*r-u*g*r-w*s*m+i*g*m+u*s*f-i*d*f)*D,t[2]=(a*g*r-w*l*r+w*s*c-i*g*c-a*s*f+i*l*f)*D,t[3]=(u*l*r-a*d*r-u*s*c+i*d*c+a*s*m-i*l*m)*D,t[4]=T*D,t[5]=(h*g*r-v*d*r+v*s*m-e*g*m-h*s*f+e*d*f)*D,t[6]=(v*l*r-o*g*r-v*s*c+e*g*c+o*s*f-e*l*f)*D,t[7]=(o*d*r-h*l*r+h*s*c-e*d*c-o*s*m+e*l*m)*D,t[8]=S*D,t[9]=(v*u*r-h*w*r-v*i*m+e*w*m+h*i*f-e*u*f)*D,t[10]=(o*w*r-v*a*r+v*i*c-e*w*c-o*i*f+e*a*f)*D,t[11]=(h*a*r-o*u*r-h*i*c+e*u*c+o*i*m-e*a*m)*D,t[12]=I*D,t[13]=(h*w*s-v*u*s+v*i*d-e*w*d-h*i*g+e*u*g)*D,t[14]=(v*a*s-o*w*s-v*i*l+e*w*l+o*i*g-e*a*g)*D,t[15]=(o*u*s-h*a*s+h*i*l-e*u*l-o*i*d+e*a*d)*D,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,d=r*c,m=r*h,v=r*u,w=o*h,g=o*u,f=a*u,R=l*c,T=l*h,S=l*u,I=i.x,P=i.y,D=i.z;return s[0]=(1-(w+f))*I,s[1]=(m+S)*I,s[2]=(v-T)*I,s[3]=0,s[4]=(m-S)*P,s[5]=(1-(d+f))*P,s[6]=(g+R)*P,s[7]=0,s[8]=(v+T)*D,s[9]=(g-R)*D,s[10]=(1-(d+w))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements,r=is.set(s[0],s[1],s[2]).length(),o=is.set(s[4],s[5],s[6]).length(),a=is.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],yi.copy(this);let c=1/r,h=1/o,u=1/a;return yi.elements[0]*=c,yi.elements[1]*=c,yi.elements[2]*=c,yi.elements[4]*=h,yi.elements[5]*=h,yi.elements[6]*=h,yi.elements[8]*=u,yi.elements[9]*=u,yi.elements[10]*=u,e.setFromRotationMatrix(yi),i.x=r,i.y=o,i.z=a,this}makePerspective(t,e,i,s,r,o,a=bi,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(i-s),d=(e+t)/(e-t),m=(i+s)/(i-s),v,w;if(l)v=r/(o-r),w=o*r/(o-r);else if(a===bi)v=-(o+r)/(o-r),w=-2*o*r/(o-r);else if(a===er)v=-o/(o-r),w=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=m,c[13]=0,c[2]=0,c[6]=0,c[10]=v,c[14]=w,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=bi,l=!1){let c=this.elements,h=2/(e-t),u=2/(i-s),d=-(e+t)/(e-t),m=-(i+s)/(i-s),v,w;if(l)v=1/(o-r),w=o/(o-r);else if(a===bi)v=-2/(o-r),w=-(o+r)/(o-r);else if(a===er)v=-1/(o-r),w=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=m,c[2]=0,c[6]=0,c[10]=v,c[14]=w,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},is=new F,yi=new ae,om=new F(0,0,0),am=new F(1,1,1),an=new F,xo=new F,oi=new F,ru=new ae,ou=new fi,wi=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],m=s[10];switch(e){case"XYZ":this._y=Math.asin(qt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-qt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(qt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-qt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(qt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-qt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return ru.makeRotationFromQuaternion(t),this.setFromRotationMatrix(ru,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return ou.setFromEuler(this),this.setFromQuaternion(ou,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};wi.DEFAULT_ORDER="XYZ";var sr=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},lm=0,au=new F,ns=new fi,Yi=new ae,bo=new F,qs=new F,cm=new F,hm=new fi,lu=new F(1,0,0),cu=new F(0,1,0),hu=new F(0,0,1),uu={type:"added"},um={type:"removed"},ss={type:"childadded",child:null},nc={type:"childremoved",child:null},Ge=class n extends Ii{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:lm++}),this.uuid=Ss(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new F,e=new wi,i=new fi,s=new F(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ae},normalMatrix:{value:new Ht}}),this.matrix=new ae,this.matrixWorld=new ae,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new sr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ns.setFromAxisAngle(t,e),this.quaternion.multiply(ns),this}rotateOnWorldAxis(t,e){return ns.setFromAxisAngle(t,e),this.quaternion.premultiply(ns),this}rotateX(t){return this.rotateOnAxis(lu,t)}rotateY(t){return this.rotateOnAxis(cu,t)}rotateZ(t){return this.rotateOnAxis(hu,t)}translateOnAxis(t,e){return au.copy(t).applyQuaternion(this.quaternion),this.position.add(au.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(lu,t)}translateY(t){return this.translateOnAxis(cu,t)}translateZ(t){return this.translateOnAxis(hu,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Yi.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?bo.copy(t):bo.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),qs.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Yi.lookAt(qs,bo,this.up):Yi.lookAt(bo,qs,this.up),this.quaternion.setFromRotationMatrix(Yi),s&&(Yi.extractRotation(s.matrixWorld),ns.setFromRotationMatrix(Yi),this.quaternion.premultiply(ns.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(uu),ss.child=t,this.dispatchEvent(ss),ss.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(um),nc.child=t,this.dispatchEvent(nc),nc.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Yi.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Yi.multiply(t.parent.matrixWorld)),t.applyMatrix4(Yi),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(uu),ss.child=t,this.dispatchEvent(ss),ss.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qs,t,cm),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qs,hm,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e){let i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),m=o(t.animations),v=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),m.length>0&&(i.animations=m),v.length>0&&(i.nodes=v)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}};Ge.DEFAULT_UP=new F(0,1,0);Ge.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ge.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var xi=new F,$i=new F,sc=new F,Zi=new F,rs=new F,os=new F,du=new F,rc=new F,oc=new F,ac=new F,lc=new xe,cc=new xe,hc=new xe,hn=class n{constructor(t=new F,e=new F,i=new F){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),xi.subVectors(t,e),s.cross(xi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){xi.subVectors(s,e),$i.subVectors(i,e),sc.subVectors(t,e);let o=xi.dot(xi),a=xi.dot($i),l=xi.dot(sc),c=$i.dot($i),h=$i.dot(sc),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,m=(c*l-a*h)*d,v=(o*h-a*l)*d;return r.set(1-m-v,v,m)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Zi)===null?!1:Zi.x>=0&&Zi.y>=0&&Zi.x+Zi.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Zi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Zi.x),l.addScaledVector(o,Zi.y),l.addScaledVector(a,Zi.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return lc.setScalar(0),cc.setScalar(0),hc.setScalar(0),lc.fromBufferAttribute(t,e),cc.fromBufferAttribute(t,i),hc.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(lc,r.x),o.addScaledVector(cc,r.y),o.addScaledVector(hc,r.z),o}static isFrontFacing(t,e,i,s){return xi.subVectors(i,e),$i.subVectors(t,e),xi.cross($i).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return xi.subVectors(this.c,this.b),$i.subVectors(this.a,this.b),xi.cross($i).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;rs.subVectors(s,i),os.subVectors(r,i),rc.subVectors(t,i);let l=rs.dot(rc),c=os.dot(rc);if(l<=0&&c<=0)return e.copy(i);oc.subVectors(t,s);let h=rs.dot(oc),u=os.dot(oc);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0)return o=l/(l-h),e.copy(i).addScaledVector(rs,o);ac.subVectors(t,r);let m=rs.dot(ac),v=os.dot(ac);if(v>=0&&m<=v)return e.copy(r);let w=m*c-l*v;if(w<=0&&c>=0&&v<=0)return a=c/(c-v),e.copy(i).addScaledVector(os,a);let g=h*v-m*u;if(g<=0&&u-h>=0&&m-v>=0)return du.subVectors(r,s),a=(u-h)/(u-h+(m-v)),e.copy(s).addScaledVector(du,a);let f=1/(g+w+d);return o=w*f,a=d*f,e.copy(i).addScaledVector(rs,o).addScaledVector(os,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},md={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ln={h:0,s:0,l:0},Mo={h:0,s:0,l:0};function uc(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Nt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=li){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Jt.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Jt.workingColorSpace){return this.r=t,this.g=e,this.b=i,Jt.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Jt.workingColorSpace){if(t=Bc(t,1),e=qt(e,0,1),i=qt(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=uc(o,r,t+1/3),this.g=uc(o,r,t),this.b=uc(o,r,t-1/3)}return Jt.colorSpaceToWorking(this,s),this}setStyle(t,e=li){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=li){let i=md[t.toLowerCase()];return i!==void 0?this.setHex(i,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Ki(t.r),this.g=Ki(t.g),this.b=Ki(t.b),this}copyLinearToSRGB(t){return this.r=ds(t.r),this.g=ds(t.g),this.b=ds(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=li){return Jt.workingToColorSpace(He.copy(this),t),Math.round(qt(He.r*255,0,255))*65536+Math.round(qt(He.g*255,0,255))*256+Math.round(qt(He.b*255,0,255))}getHexString(t=li){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Jt.workingColorSpace){Jt.workingToColorSpace(He.copy(this),e);let i=He.r,s=He.g,r=He.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Jt.workingColorSpace){return Jt.workingToColorSpace(He.copy(this),e),t.r=He.r,t.g=He.g,t.b=He.b,t}getStyle(t=li){Jt.workingToColorSpace(He.copy(this),t);let e=He.r,i=He.g,s=He.b;return t!==li?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(ln),this.setHSL(ln.h+t,ln.s+e,ln.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(ln),t.getHSL(Mo);let i=Js(ln.h,Mo.h,e),s=Js(ln.s,Mo.s,e),r=Js(ln.l,Mo.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},He=new Nt;Nt.NAMES=md;var dm=0,Ni=class extends Ii{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:dm++}),this.uuid=Ss(),this.name="",this.type="Material",this.blending=Dn,this.side=ji,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Bo,this.blendDst=zo,this.blendEquation=dn,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Nt(0,0,0),this.blendAlpha=0,this.depthFunc=Un,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=yc,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=In,this.stencilZFail=In,this.stencilZPass=In,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Dn&&(i.blending=this.blending),this.side!==ji&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Bo&&(i.blendSrc=this.blendSrc),this.blendDst!==zo&&(i.blendDst=this.blendDst),this.blendEquation!==dn&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==Un&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==yc&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==In&&(i.stencilFail=this.stencilFail),this.stencilZFail!==In&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==In&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},rr=class extends Ni{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new wi,this.combine=ya,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}};var Ee=new F,wo=new zt,fm=0,ye=class{constructor(t,e,i=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:fm++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=xc,this.updateRanges=[],this.gpuType=Ti,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)wo.fromBufferAttribute(this,e),wo.applyMatrix3(t),this.setXY(e,wo.x,wo.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Ee.fromBufferAttribute(this,e),Ee.applyMatrix3(t),this.setXYZ(e,Ee.x,Ee.y,Ee.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Ee.fromBufferAttribute(this,e),Ee.applyMatrix4(t),this.setXYZ(e,Ee.x,Ee.y,Ee.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Ee.fromBufferAttribute(this,e),Ee.applyNormalMatrix(t),this.setXYZ(e,Ee.x,Ee.y,Ee.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Ee.fromBufferAttribute(this,e),Ee.transformDirection(t),this.setXYZ(e,Ee.x,Ee.y,Ee.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=us(i,this.array)),i}setComponent(t,e,i){return this.normalized&&(i=Ye(i,this.array)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=us(e,this.array)),e}setX(t,e){return this.normalized&&(e=Ye(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=us(e,this.array)),e}setY(t,e){return this.normalized&&(e=Ye(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=us(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Ye(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=us(e,this.array)),e}setW(t,e){return this.normalized&&(e=Ye(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=Ye(e,this.array),i=Ye(i,this.array)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=Ye(e,this.array),i=Ye(i,this.array),s=Ye(s,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=Ye(e,this.array),i=Ye(i,this.array),s=Ye(s,this.array),r=Ye(r,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==xc&&(t.usage=this.usage),t}};var or=class extends ye{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var ar=class extends ye{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Ze=class extends ye{constructor(t,e,i){super(new Float32Array(t),e,i)}},pm=0,di=new ae,dc=new Ge,as=new F,ai=new Di,Ys=new Di,Ie=new F,be=class n extends Ii{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:pm++}),this.uuid=Ss(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Hc(t)?ar:or)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Ht().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return di.makeRotationFromQuaternion(t),this.applyMatrix4(di),this}rotateX(t){return di.makeRotationX(t),this.applyMatrix4(di),this}rotateY(t){return di.makeRotationY(t),this.applyMatrix4(di),this}rotateZ(t){return di.makeRotationZ(t),this.applyMatrix4(di),this}translate(t,e,i){return di.makeTranslation(t,e,i),this.applyMatrix4(di),this}scale(t,e,i){return di.makeScale(t,e,i),this.applyMatrix4(di),this}lookAt(t){return dc.lookAt(t),dc.updateMatrix(),this.applyMatrix4(dc.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(as).negate(),this.translate(as.x,as.y,as.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ze(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Di);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new F(-1/0,-1/0,-1/0),new F(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];ai.setFromBufferAttribute(r),this.morphTargetsRelative?(Ie.addVectors(this.boundingBox.min,ai.min),this.boundingBox.expandByPoint(Ie),Ie.addVectors(this.boundingBox.max,ai.max),this.boundingBox.expandByPoint(Ie)):(this.boundingBox.expandByPoint(ai.min),this.boundingBox.expandByPoint(ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ui);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new F,1/0);return}if(t){let i=this.boundingSphere.center;if(ai.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Ys.setFromBufferAttribute(a),this.morphTargetsRelative?(Ie.addVectors(ai.min,Ys.min),ai.expandByPoint(Ie),Ie.addVectors(ai.max,Ys.max),ai.expandByPoint(Ie)):(ai.expandByPoint(Ys.min),ai.expandByPoint(Ys.max))}ai.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Ie.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Ie));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Ie.fromBufferAttribute(a,c),l&&(as.fromBufferAttribute(t,c),Ie.add(as)),s=Math.max(s,i.distanceToSquared(Ie))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new ye(new Float32Array(4*i.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let k=0;k<i.count;k++)a[k]=new F,l[k]=new F;let c=new F,h=new F,u=new F,d=new zt,m=new zt,v=new zt,w=new F,g=new F;function f(k,y,b){c.fromBufferAttribute(i,k),h.fromBufferAttribute(i,y),u.fromBufferAttribute(i,b),d.fromBufferAttribute(r,k),m.fromBufferAttribute(r,y),v.fromBufferAttribute(r,b),h.sub(c),u.sub(c),m.sub(d),v.sub(d);let C=1/(m.x*v.y-v.x*m.y);isFinite(C)&&(w.copy(h).multiplyScalar(v.y).addScaledVector(u,-m.y).multiplyScalar(C),g.copy(u).multiplyScalar(m.x).addScaledVector(h,-v.x).multiplyScalar(C),a[k].add(w),a[y].add(w),a[b].add(w),l[k].add(g),l[y].add(g),l[b].add(g))}let R=this.groups;R.length===0&&(R=[{start:0,count:t.count}]);for(let k=0,y=R.length;k<y;++k){let b=R[k],C=b.start,B=b.count;for(let V=C,X=C+B;V<X;V+=3)f(t.getX(V+0),t.getX(V+1),t.getX(V+2))}let T=new F,S=new F,I=new F,P=new F;function D(k){I.fromBufferAttribute(s,k),P.copy(I);let y=a[k];T.copy(y),T.sub(I.multiplyScalar(I.dot(y))).normalize(),S.crossVectors(P,y);let C=S.dot(l[k])<0?-1:1;o.setXYZW(k,T.x,T.y,T.z,C)}for(let k=0,y=R.length;k<y;++k){let b=R[k],C=b.start,B=b.count;for(let V=C,X=C+B;V<X;V+=3)D(t.getX(V+0)),D(t.getX(V+1)),D(t.getX(V+2))}}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new ye(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,m=i.count;d<m;d++)i.setXYZ(d,0,0,0);let s=new F,r=new F,o=new F,a=new F,l=new F,c=new F,h=new F,u=new F;if(t)for(let d=0,m=t.count;d<m;d+=3){let v=t.getX(d+0),w=t.getX(d+1),g=t.getX(d+2);s.fromBufferAttribute(e,v),r.fromBufferAttribute(e,w),o.fromBufferAttribute(e,g),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,v),l.fromBufferAttribute(i,w),c.fromBufferAttribute(i,g),a.add(h),l.add(h),c.add(h),i.setXYZ(v,a.x,a.y,a.z),i.setXYZ(w,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,m=e.count;d<m;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Ie.fromBufferAttribute(t,e),Ie.normalize(),t.setXYZ(e,Ie.x,Ie.y,Ie.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),m=0,v=0;for(let w=0,g=l.length;w<g;w++){a.isInterleavedBufferAttribute?m=l[w]*a.data.stride+a.offset:m=l[w]*h;for(let f=0;f<h;f++)d[v++]=c[m++]}return new ye(d,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],m=t(d,i);l.push(m)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let m=c[u];h.push(m.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,m=u.length;d<m;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},fu=new ae,Cn=new fn,So=new Ui,pu=new F,Eo=new F,To=new F,Ao=new F,fc=new F,Ro=new F,mu=new F,Co=new F,We=class extends Ge{constructor(t=new be,e=new rr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Ro.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(fc.fromBufferAttribute(u,t),o?Ro.addScaledVector(fc,h):Ro.addScaledVector(fc.sub(e),h))}e.add(Ro)}return e}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),So.copy(i.boundingSphere),So.applyMatrix4(r),Cn.copy(t.ray).recast(t.near),!(So.containsPoint(Cn.origin)===!1&&(Cn.intersectSphere(So,pu)===null||Cn.origin.distanceToSquared(pu)>(t.far-t.near)**2))&&(fu.copy(r).invert(),Cn.copy(t.ray).applyMatrix4(fu),!(i.boundingBox!==null&&Cn.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Cn)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let v=0,w=d.length;v<w;v++){let g=d[v],f=o[g.materialIndex],R=Math.max(g.start,m.start),T=Math.min(a.count,Math.min(g.start+g.count,m.start+m.count));for(let S=R,I=T;S<I;S+=3){let P=a.getX(S),D=a.getX(S+1),k=a.getX(S+2);s=Po(this,f,t,i,c,h,u,P,D,k),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let v=Math.max(0,m.start),w=Math.min(a.count,m.start+m.count);for(let g=v,f=w;g<f;g+=3){let R=a.getX(g),T=a.getX(g+1),S=a.getX(g+2);s=Po(this,o,t,i,c,h,u,R,T,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let v=0,w=d.length;v<w;v++){let g=d[v],f=o[g.materialIndex],R=Math.max(g.start,m.start),T=Math.min(l.count,Math.min(g.start+g.count,m.start+m.count));for(let S=R,I=T;S<I;S+=3){let P=S,D=S+1,k=S+2;s=Po(this,f,t,i,c,h,u,P,D,k),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let v=Math.max(0,m.start),w=Math.min(l.count,m.start+m.count);for(let g=v,f=w;g<f;g+=3){let R=g,T=g+1,S=g+2;s=Po(this,o,t,i,c,h,u,R,T,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function mm(n,t,e,i,s,r,o,a){let l;if(t.side===je?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===ji,a),l===null)return null;Co.copy(a),Co.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Co);return c<e.near||c>e.far?null:{distance:c,point:Co.clone(),object:n}}function Po(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Eo),n.getVertexPosition(l,To),n.getVertexPosition(c,Ao);let h=mm(n,t,e,i,Eo,To,Ao,mu);if(h){let u=new F;hn.getBarycoord(mu,Eo,To,Ao,u),s&&(h.uv=hn.getInterpolatedAttribute(s,a,l,c,u,new zt)),r&&(h.uv1=hn.getInterpolatedAttribute(r,a,l,c,u,new zt)),o&&(h.normal=hn.getInterpolatedAttribute(o,a,l,c,u,new F),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new F,materialIndex:0};hn.getNormal(Eo,To,Ao,d.normal),h.face=d,h.barycoord=u}return h}var _s=class n extends be{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,m=0;v("z","y","x",-1,-1,i,e,t,o,r,0),v("z","y","x",1,-1,i,e,-t,o,r,1),v("x","z","y",1,1,t,i,e,s,o,2),v("x","z","y",1,-1,t,i,-e,s,o,3),v("x","y","z",1,-1,t,e,i,s,r,4),v("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ze(c,3)),this.setAttribute("normal",new Ze(h,3)),this.setAttribute("uv",new Ze(u,2));function v(w,g,f,R,T,S,I,P,D,k,y){let b=S/D,C=I/k,B=S/2,V=I/2,X=P/2,K=D+1,Y=k+1,nt=0,G=0,lt=new F;for(let dt=0;dt<Y;dt++){let Tt=dt*C-V;for(let Yt=0;Yt<K;Yt++){let le=Yt*b-B;lt[w]=le*R,lt[g]=Tt*T,lt[f]=X,c.push(lt.x,lt.y,lt.z),lt[w]=0,lt[g]=0,lt[f]=P>0?1:-1,h.push(lt.x,lt.y,lt.z),u.push(Yt/D),u.push(1-dt/k),nt+=1}}for(let dt=0;dt<k;dt++)for(let Tt=0;Tt<D;Tt++){let Yt=d+Tt+K*dt,le=d+Tt+K*(dt+1),fe=d+(Tt+1)+K*(dt+1),te=d+(Tt+1)+K*dt;l.push(Yt,le,te),l.push(le,fe,te),G+=6}a.addGroup(m,G,y),m+=G,d+=nt}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};function Hn(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone():Array.isArray(s)?t[e][i]=s.slice():t[e][i]=s}}return t}function Xe(n){let t={};for(let e=0;e<n.length;e++){let i=Hn(n[e]);for(let s in i)t[s]=i[s]}return t}function gm(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Vc(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Jt.workingColorSpace}var gd={clone:Hn,merge:Xe},_m=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,vm=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Si=class extends Ni{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=_m,this.fragmentShader=vm,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Hn(t.uniforms),this.uniformsGroups=gm(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}},lr=class extends Ge{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ae,this.projectionMatrix=new ae,this.projectionMatrixInverse=new ae,this.coordinateSystem=bi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},cn=new F,gu=new zt,_u=new zt,Ve=class extends lr{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=ps*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(js*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return ps*2*Math.atan(Math.tan(js*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){cn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(cn.x,cn.y).multiplyScalar(-t/cn.z),cn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(cn.x,cn.y).multiplyScalar(-t/cn.z)}getViewSize(t,e){return this.getViewBounds(t,gu,_u),e.subVectors(_u,gu)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(js*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}},ls=-90,cs=1,Yo=class extends Ge{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Ve(ls,cs,t,e);s.layers=this.layers,this.add(s);let r=new Ve(ls,cs,t,e);r.layers=this.layers,this.add(r);let o=new Ve(ls,cs,t,e);o.layers=this.layers,this.add(o);let a=new Ve(ls,cs,t,e);a.layers=this.layers,this.add(a);let l=new Ve(ls,cs,t,e);l.layers=this.layers,this.add(l);let c=new Ve(ls,cs,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===bi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===er)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),m=t.getActiveMipmapLevel(),v=t.xr.enabled;t.xr.enabled=!1;let w=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,t.setRenderTarget(i,0,s),t.render(e,r),t.setRenderTarget(i,1,s),t.render(e,o),t.setRenderTarget(i,2,s),t.render(e,a),t.setRenderTarget(i,3,s),t.render(e,l),t.setRenderTarget(i,4,s),t.render(e,c),i.texture.generateMipmaps=w,t.setRenderTarget(i,5,s),t.render(e,h),t.setRenderTarget(u,d,m),t.xr.enabled=v,i.texture.needsPMREMUpdate=!0}},cr=class extends Ke{constructor(t=[],e=Bn,i,s,r,o,a,l,c,h){super(t,e,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},$o=class extends Li{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new cr(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new _s(5,5,5),r=new Si({name:"CubemapFromEquirect",uniforms:Hn(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:je,blending:Qi});r.uniforms.tEquirect.value=e;let o=new We(s,r),a=e.minFilter;return e.minFilter===vn&&(e.minFilter=Mi),new Yo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Ln=class extends Ge{constructor(){super(),this.isGroup=!0,this.type="Group"}},ym={type:"move"},vs=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ln,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ln,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new F,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new F),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ln,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new F,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new F),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let w of t.hand.values()){let g=e.getJointPose(w,i),f=this._getHandJoint(c,w);g!==null&&(f.matrix.fromArray(g.transform.matrix),f.matrix.decompose(f.position,f.rotation,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=g.radius),f.visible=g!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),m=.02,v=.005;c.inputState.pinching&&d>m+v?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=m-v&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ym)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Ln;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}};var hr=class extends Ge{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new wi,this.environmentIntensity=1,this.environmentRotation=new wi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};var Zo=class extends Ke{constructor(t=null,e=1,i=1,s,r,o,a,l,c=ti,h=ti,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ur=class extends ye{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},hs=new ae,vu=new ae,Io=[],yu=new Di,xm=new ae,$s=new We,Zs=new Ui,dr=class extends We{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new ur(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,xm)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Di),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,hs),yu.copy(t.boundingBox).applyMatrix4(hs),this.boundingBox.union(yu)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Ui),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,hs),Zs.copy(t.boundingSphere).applyMatrix4(hs),this.boundingSphere.union(Zs)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),t.morphTexture!==null&&(this.morphTexture=t.morphTexture.clone()),t.instanceColor!==null&&(this.instanceColor=t.instanceColor.clone()),this.count=t.count,t.boundingBox!==null&&(this.boundingBox=t.boundingBox.clone()),t.boundingSphere!==null&&(this.boundingSphere=t.boundingSphere.clone()),this}getColorAt(t,e){e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if($s.geometry=this.geometry,$s.material=this.material,$s.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Zs.copy(this.boundingSphere),Zs.applyMatrix4(i),t.ray.intersectsSphere(Zs)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,hs),vu.multiplyMatrices(i,hs),$s.matrixWorld=vu,$s.raycast(t,Io);for(let o=0,a=Io.length;o<a;o++){let l=Io[o];l.instanceId=r,l.object=this,e.push(l)}Io.length=0}}setColorAt(t,e){this.instanceColor===null&&(this.instanceColor=new ur(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3)}setMatrixAt(t,e){e.toArray(this.instanceMatrix.array,t*16)}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Zo(new Float32Array(s*this.count),s,this.count,Ta,Ti));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;r[l]=a,r.set(i,l+1)}updateMorphTargets(){}dispose(){this.dispatchEvent({type:"dispose"}),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},pc=new F,bm=new F,Mm=new Ht,$e=class{constructor(t=new F(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=pc.subVectors(i,e).cross(bm.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){let i=t.delta(pc),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(i,r)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||Mm.getNormalMatrix(t),s=this.coplanarPoint(pc).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}},Pn=new Ui,wm=new zt(.5,.5),Lo=new F,fr=class{constructor(t=new $e,e=new $e,i=new $e,s=new $e,r=new $e,o=new $e){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=bi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],m=r[7],v=r[8],w=r[9],g=r[10],f=r[11],R=r[12],T=r[13],S=r[14],I=r[15];if(s[0].setComponents(c-o,m-h,f-v,I-R).normalize(),s[1].setComponents(c+o,m+h,f+v,I+R).normalize(),s[2].setComponents(c+a,m+u,f+w,I+T).normalize(),s[3].setComponents(c-a,m-u,f-w,I-T).normalize(),i)s[4].setComponents(l,d,g,S).normalize(),s[5].setComponents(c-l,m-d,f-g,I-S).normalize();else if(s[4].setComponents(c-l,m-d,f-g,I-S).normalize(),e===bi)s[5].setComponents(c+l,m+d,f+g,I+S).normalize();else if(e===er)s[5].setComponents(l,d,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Pn.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Pn.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Pn)}intersectsSprite(t){Pn.center.set(0,0,0);let e=wm.distanceTo(t.center);return Pn.radius=.7071067811865476+e,Pn.applyMatrix4(t.matrixWorld),this.intersectsSphere(Pn)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Lo.x=s.normal.x>0?t.max.x:t.min.x,Lo.y=s.normal.y>0?t.max.y:t.min.y,Lo.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Lo)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var Ei=class extends Ni{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Nt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ko=new F,jo=new F,xu=new ae,Ks=new fn,Do=new Ui,mc=new F,bu=new F,Fn=class extends Ge{constructor(t=new be,e=new Ei){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Ko.fromBufferAttribute(e,s-1),jo.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Ko.distanceTo(jo);t.setAttribute("lineDistance",new Ze(i,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Do.copy(i.boundingSphere),Do.applyMatrix4(s),Do.radius+=r,t.ray.intersectsSphere(Do)===!1)return;xu.copy(s).invert(),Ks.copy(t.ray).applyMatrix4(xu);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){let m=Math.max(0,o.start),v=Math.min(h.count,o.start+o.count);for(let w=m,g=v-1;w<g;w+=c){let f=h.getX(w),R=h.getX(w+1),T=Uo(this,t,Ks,l,f,R,w);T&&e.push(T)}if(this.isLineLoop){let w=h.getX(v-1),g=h.getX(m),f=Uo(this,t,Ks,l,w,g,v-1);f&&e.push(f)}}else{let m=Math.max(0,o.start),v=Math.min(d.count,o.start+o.count);for(let w=m,g=v-1;w<g;w+=c){let f=Uo(this,t,Ks,l,w,w+1,w);f&&e.push(f)}if(this.isLineLoop){let w=Uo(this,t,Ks,l,v-1,m,v-1);w&&e.push(w)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Uo(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Ko.fromBufferAttribute(a,s),jo.fromBufferAttribute(a,r),e.distanceSqToSegment(Ko,jo,mc,bu)>i)return;mc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(mc);if(!(c<t.near||c>t.far))return{distance:c,point:bu.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Mu=new F,wu=new F,Ji=class extends Fn{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Mu.fromBufferAttribute(e,s),wu.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Mu.distanceTo(wu);t.setAttribute("lineDistance",new Ze(i,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var On=class extends Ni{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Nt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Su=new ae,bc=new fn,No=new Ui,Fo=new F,Fi=class extends Ge{constructor(t=new be,e=new On){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),No.copy(i.boundingSphere),No.applyMatrix4(s),No.radius+=r,t.ray.intersectsSphere(No)===!1)return;Su.copy(s).invert(),bc.copy(t.ray).applyMatrix4(Su);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,u=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),m=Math.min(c.count,o.start+o.count);for(let v=d,w=m;v<w;v++){let g=c.getX(v);Fo.fromBufferAttribute(u,g),Eu(Fo,g,l,s,t,e,this)}}else{let d=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let v=d,w=m;v<w;v++)Fo.fromBufferAttribute(u,v),Eu(Fo,v,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Eu(n,t,e,i,s,r,o){let a=bc.distanceSqToPoint(n);if(a<e){let l=new F;bc.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var pr=class extends Ke{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}},mr=class extends Ke{constructor(t,e,i=yn,s,r,o,a=ti,l=ti,c,h=fs,u=1){if(h!==fs&&h!==ws)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new gs(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}},gr=class extends Ke{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}};var _r=class n extends be{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,m=[],v=[],w=[],g=[];for(let f=0;f<h;f++){let R=f*d-o;for(let T=0;T<c;T++){let S=T*u-r;v.push(S,-R,0),w.push(0,0,1),g.push(T/a),g.push(1-f/l)}}for(let f=0;f<l;f++)for(let R=0;R<a;R++){let T=R+c*f,S=R+c*(f+1),I=R+1+c*(f+1),P=R+1+c*f;m.push(T,S,P),m.push(S,I,P)}this.setIndex(m),this.setAttribute("position",new Ze(v,3)),this.setAttribute("normal",new Ze(w,3)),this.setAttribute("uv",new Ze(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var vr=class n extends be{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new F,d=new F,m=[],v=[],w=[],g=[];for(let f=0;f<=i;f++){let R=[],T=f/i,S=0;f===0&&o===0?S=.5/e:f===i&&l===Math.PI&&(S=-.5/e);for(let I=0;I<=e;I++){let P=I/e;u.x=-t*Math.cos(s+P*r)*Math.sin(o+T*a),u.y=t*Math.cos(o+T*a),u.z=t*Math.sin(s+P*r)*Math.sin(o+T*a),v.push(u.x,u.y,u.z),d.copy(u).normalize(),w.push(d.x,d.y,d.z),g.push(P+S,1-T),R.push(c++)}h.push(R)}for(let f=0;f<i;f++)for(let R=0;R<e;R++){let T=h[f][R+1],S=h[f][R],I=h[f+1][R],P=h[f+1][R+1];(f!==0||o>0)&&m.push(T,S,P),(f!==i-1||l<Math.PI)&&m.push(S,I,P)}this.setIndex(m),this.setAttribute("position",new Ze(v,3)),this.setAttribute("normal",new Ze(w,3)),this.setAttribute("uv",new Ze(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var yr=class extends Ni{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Nt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Fc,this.normalScale=new zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new wi,this.combine=ya,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Jo=class extends Ni{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=nd,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Qo=class extends Ni{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Oo(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Sm(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}var kn=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];i:{t:{let o;e:{n:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break n;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break i}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},ta=class extends kn{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:gc,endingEnd:gc}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case _c:r=t,a=2*e-i;break;case vc:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case _c:o=t,l=2*i-e;break;case vc:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,m=this._weightNext,v=(i-e)/(s-e),w=v*v,g=w*v,f=-d*g+2*d*w-d*v,R=(1+d)*g+(-1.5-2*d)*w+(-.5+d)*v+1,T=(-1-m)*g+(1.5+m)*w+.5*v,S=m*g-m*w;for(let I=0;I!==a;++I)r[I]=f*o[h+I]+R*o[c+I]+T*o[l+I]+S*o[u+I];return r}},ea=class extends kn{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(i-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},ia=class extends kn{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},ci=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Oo(e,this.TimeBufferType),this.values=Oo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Oo(t.times,Array),values:Oo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s)}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new ia(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new ea(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new ta(this.times,this.values,this.getValueSize(),t)}setInterpolation(t){let e;switch(t){case Qs:e=this.InterpolantFactoryMethodDiscrete;break;case Go:e=this.InterpolantFactoryMethodLinear;break;case ko:e=this.InterpolantFactoryMethodSmooth;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return console.warn("THREE.KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Qs;case this.InterpolantFactoryMethodLinear:return Go;case this.InterpolantFactoryMethodSmooth:return ko}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Sm(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===ko,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*i,d=u-i,m=u+i;for(let v=0;v!==i;++v){let w=e[u+v];if(w!==e[d+v]||w!==e[m+v]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*i,d=o*i;for(let m=0;m!==i;++m)e[d+m]=e[u+m]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,s}};ci.prototype.ValueTypeName="";ci.prototype.TimeBufferType=Float32Array;ci.prototype.ValueBufferType=Float32Array;ci.prototype.DefaultInterpolation=Go;var pn=class extends ci{constructor(t,e,i){super(t,e,i)}};pn.prototype.ValueTypeName="bool";pn.prototype.ValueBufferType=Array;pn.prototype.DefaultInterpolation=Qs;pn.prototype.InterpolantFactoryMethodLinear=void 0;pn.prototype.InterpolantFactoryMethodSmooth=void 0;var na=class extends ci{constructor(t,e,i,s){super(t,e,i,s)}};na.prototype.ValueTypeName="color";var sa=class extends ci{constructor(t,e,i,s){super(t,e,i,s)}};sa.prototype.ValueTypeName="number";var ra=class extends kn{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)fi.slerpFlat(r,0,o,c-a,o,c,l);return r}},xr=class extends ci{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new ra(this.times,this.values,this.getValueSize(),t)}};xr.prototype.ValueTypeName="quaternion";xr.prototype.InterpolantFactoryMethodSmooth=void 0;var mn=class extends ci{constructor(t,e,i){super(t,e,i)}};mn.prototype.ValueTypeName="string";mn.prototype.ValueBufferType=Array;mn.prototype.DefaultInterpolation=Qs;mn.prototype.InterpolantFactoryMethodLinear=void 0;mn.prototype.InterpolantFactoryMethodSmooth=void 0;var oa=class extends ci{constructor(t,e,i,s){super(t,e,i,s)}};oa.prototype.ValueTypeName="vector";var aa=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this.abortController=new AbortController,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let m=c[u],v=c[u+1];if(m.global&&(m.lastIndex=0),m.test(h))return v}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},_d=new aa,la=class{constructor(t){this.manager=t!==void 0?t:_d,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}abort(){return this}};la.DEFAULT_MATERIAL_NAME="__DEFAULT";var ca=class extends Ge{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Nt(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}},br=class extends ca{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Ge.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Nt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}};var ha=class extends lr{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var ua=class extends Ve{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t}};var Gc="\\[\\]\\.:\\/",Em=new RegExp("["+Gc+"]","g"),Wc="[^"+Gc+"]",Tm="[^"+Gc.replace("\\.","")+"]",Am=/((?:WC+[\/:])*)/.source.replace("WC",Wc),Rm=/(WCOD+)?/.source.replace("WCOD",Tm),Cm=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Wc),Pm=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Wc),Im=new RegExp("^"+Am+Rm+Cm+Pm+"$"),Lm=["material","materials","bones","map"],Mc=class{constructor(t,e,i){let s=i||de.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},de=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Em,"")}static parseTrackName(t){let e=Im.exec(t);if(e===null)throw new Error("PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Lm.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};de.Composite=Mc;de.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};de.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};de.prototype.GetterByBindingType=[de.prototype._getValue_direct,de.prototype._getValue_array,de.prototype._getValue_arrayElement,de.prototype._getValue_toArray];de.prototype.SetterByBindingTypeAndVersioning=[[de.prototype._setValue_direct,de.prototype._setValue_direct_setNeedsUpdate,de.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[de.prototype._setValue_array,de.prototype._setValue_array_setNeedsUpdate,de.prototype._setValue_array_setMatrixWorldNeedsUpdate],[de.prototype._setValue_arrayElement,de.prototype._setValue_arrayElement_setNeedsUpdate,de.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[de.prototype._setValue_fromArray,de.prototype._setValue_fromArray_setNeedsUpdate,de.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var xw=new Float32Array(1);var ys=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=qt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(qt(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Mr=class extends Ii{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){if(t===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Xc(n,t,e,i){let s=Dm(i);switch(e){case Dc:return n*t;case Ta:return n*t/s.components*s.byteLength;case Aa:return n*t/s.components*s.byteLength;case Nc:return n*t*2/s.components*s.byteLength;case Ra:return n*t*2/s.components*s.byteLength;case Uc:return n*t*3/s.components*s.byteLength;case pi:return n*t*4/s.components*s.byteLength;case Ca:return n*t*4/s.components*s.byteLength;case Er:case Tr:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ar:case Rr:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ia:case Da:return Math.max(n,16)*Math.max(t,8)/4;case Pa:case La:return Math.max(n,8)*Math.max(t,8)/2;case Ua:case Na:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Fa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Oa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case ka:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Ba:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case za:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Ha:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Va:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Ga:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Wa:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Xa:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case qa:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Ya:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case $a:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Za:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Ka:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case ja:case Ja:case Qa:return Math.ceil(n/4)*Math.ceil(t/4)*16;case tl:case el:return Math.ceil(n/4)*Math.ceil(t/4)*8;case il:case nl:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Dm(n){switch(n){case Bi:case Cc:return{byteLength:1,components:1};case xs:case Pc:case bs:return{byteLength:2,components:1};case Sa:case Ea:return{byteLength:2,components:4};case yn:case wa:case Ti:return{byteLength:4,components:1};case Ic:case Lc:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");function Hd(){let n=null,t=!1,e=null,i=null;function s(r,o){e(r,o),i=n.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Nm(n){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,h),a.onUploadCallback();let m;if(c instanceof Float32Array)m=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)m=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=n.HALF_FLOAT:m=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=n.SHORT;else if(c instanceof Uint32Array)m=n.UNSIGNED_INT;else if(c instanceof Int32Array)m=n.INT;else if(c instanceof Int8Array)m=n.BYTE;else if(c instanceof Uint8Array)m=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,h);else{u.sort((m,v)=>m.start-v.start);let d=0;for(let m=1;m<u.length;m++){let v=u[d],w=u[m];w.start<=v.start+v.count+1?v.count=Math.max(v.count,w.start+w.count-v.start):(++d,u[d]=w)}u.length=d+1;for(let m=0,v=u.length;m<v;m++){let w=u[m];n.bufferSubData(c,w.start*h.BYTES_PER_ELEMENT,h,w.start,w.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Fm=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Om=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,km=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Bm=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,zm=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Hm=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Vm=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Gm=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Wm=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,Xm=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,qm=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Ym=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,$m=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Zm=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Km=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,jm=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Jm=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Qm=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,tg=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,eg=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,ig=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,ng=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,sg=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,rg=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,og=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,ag=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,lg=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,cg=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,hg=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ug=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,dg="gl_FragColor = linearToOutputTexel( gl_FragColor );",fg=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,pg=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,mg=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,gg=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,_g=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,vg=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,yg=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,xg=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,bg=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Mg=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,wg=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Sg=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Eg=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Tg=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Ag=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,Rg=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,Cg=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Pg=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Ig=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Lg=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Dg=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Ug=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Ng=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Fg=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Og=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,kg=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Bg=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,zg=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Hg=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Vg=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Gg=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Wg=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Xg=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,qg=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Yg=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,$g=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Zg=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Kg=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jg=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Jg=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Qg=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,t_=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,e_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,i_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,n_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,s_=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,r_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,o_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,a_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,l_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,c_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,h_=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,u_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,d_=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,f_=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,p_=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,m_=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,g_=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,__=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		float depth = unpackRGBAToDepth( texture2D( depths, uv ) );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			return step( depth, compare );
		#else
			return step( compare, depth );
		#endif
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow( sampler2D shadow, vec2 uv, float compare ) {
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			float hard_shadow = step( distribution.x, compare );
		#else
			float hard_shadow = step( compare, distribution.x );
		#endif
		if ( hard_shadow != 1.0 ) {
			float distance = compare - distribution.x;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,v_=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,y_=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,x_=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,b_=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,M_=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,w_=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,S_=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,E_=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,T_=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,A_=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,R_=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,C_=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,P_=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,I_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,L_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,D_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,U_=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,N_=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,F_=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,O_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,k_=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,B_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,z_=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,H_=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,V_=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,G_=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,W_=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,X_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,q_=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Y_=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,$_=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Z_=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,K_=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,j_=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,J_=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Q_=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,tv=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ev=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,iv=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,nv=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,sv=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,rv=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,ov=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,av=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,lv=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,cv=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,hv=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,uv=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,dv=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,fv=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,pv=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Wt={alphahash_fragment:Fm,alphahash_pars_fragment:Om,alphamap_fragment:km,alphamap_pars_fragment:Bm,alphatest_fragment:zm,alphatest_pars_fragment:Hm,aomap_fragment:Vm,aomap_pars_fragment:Gm,batching_pars_vertex:Wm,batching_vertex:Xm,begin_vertex:qm,beginnormal_vertex:Ym,bsdfs:$m,iridescence_fragment:Zm,bumpmap_pars_fragment:Km,clipping_planes_fragment:jm,clipping_planes_pars_fragment:Jm,clipping_planes_pars_vertex:Qm,clipping_planes_vertex:tg,color_fragment:eg,color_pars_fragment:ig,color_pars_vertex:ng,color_vertex:sg,common:rg,cube_uv_reflection_fragment:og,defaultnormal_vertex:ag,displacementmap_pars_vertex:lg,displacementmap_vertex:cg,emissivemap_fragment:hg,emissivemap_pars_fragment:ug,colorspace_fragment:dg,colorspace_pars_fragment:fg,envmap_fragment:pg,envmap_common_pars_fragment:mg,envmap_pars_fragment:gg,envmap_pars_vertex:_g,envmap_physical_pars_fragment:Rg,envmap_vertex:vg,fog_vertex:yg,fog_pars_vertex:xg,fog_fragment:bg,fog_pars_fragment:Mg,gradientmap_pars_fragment:wg,lightmap_pars_fragment:Sg,lights_lambert_fragment:Eg,lights_lambert_pars_fragment:Tg,lights_pars_begin:Ag,lights_toon_fragment:Cg,lights_toon_pars_fragment:Pg,lights_phong_fragment:Ig,lights_phong_pars_fragment:Lg,lights_physical_fragment:Dg,lights_physical_pars_fragment:Ug,lights_fragment_begin:Ng,lights_fragment_maps:Fg,lights_fragment_end:Og,logdepthbuf_fragment:kg,logdepthbuf_pars_fragment:Bg,logdepthbuf_pars_vertex:zg,logdepthbuf_vertex:Hg,map_fragment:Vg,map_pars_fragment:Gg,map_particle_fragment:Wg,map_particle_pars_fragment:Xg,metalnessmap_fragment:qg,metalnessmap_pars_fragment:Yg,morphinstance_vertex:$g,morphcolor_vertex:Zg,morphnormal_vertex:Kg,morphtarget_pars_vertex:jg,morphtarget_vertex:Jg,normal_fragment_begin:Qg,normal_fragment_maps:t_,normal_pars_fragment:e_,normal_pars_vertex:i_,normal_vertex:n_,normalmap_pars_fragment:s_,clearcoat_normal_fragment_begin:r_,clearcoat_normal_fragment_maps:o_,clearcoat_pars_fragment:a_,iridescence_pars_fragment:l_,opaque_fragment:c_,packing:h_,premultiplied_alpha_fragment:u_,project_vertex:d_,dithering_fragment:f_,dithering_pars_fragment:p_,roughnessmap_fragment:m_,roughnessmap_pars_fragment:g_,shadowmap_pars_fragment:__,shadowmap_pars_vertex:v_,shadowmap_vertex:y_,shadowmask_pars_fragment:x_,skinbase_vertex:b_,skinning_pars_vertex:M_,skinning_vertex:w_,skinnormal_vertex:S_,specularmap_fragment:E_,specularmap_pars_fragment:T_,tonemapping_fragment:A_,tonemapping_pars_fragment:R_,transmission_fragment:C_,transmission_pars_fragment:P_,uv_pars_fragment:I_,uv_pars_vertex:L_,uv_vertex:D_,worldpos_vertex:U_,background_vert:N_,background_frag:F_,backgroundCube_vert:O_,backgroundCube_frag:k_,cube_vert:B_,cube_frag:z_,depth_vert:H_,depth_frag:V_,distanceRGBA_vert:G_,distanceRGBA_frag:W_,equirect_vert:X_,equirect_frag:q_,linedashed_vert:Y_,linedashed_frag:$_,meshbasic_vert:Z_,meshbasic_frag:K_,meshlambert_vert:j_,meshlambert_frag:J_,meshmatcap_vert:Q_,meshmatcap_frag:tv,meshnormal_vert:ev,meshnormal_frag:iv,meshphong_vert:nv,meshphong_frag:sv,meshphysical_vert:rv,meshphysical_frag:ov,meshtoon_vert:av,meshtoon_frag:lv,points_vert:cv,points_frag:hv,shadow_vert:uv,shadow_frag:dv,sprite_vert:fv,sprite_frag:pv},at={common:{diffuse:{value:new Nt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ht},alphaMap:{value:null},alphaMapTransform:{value:new Ht},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ht}},envmap:{envMap:{value:null},envMapRotation:{value:new Ht},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ht}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ht}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ht},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ht},normalScale:{value:new zt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ht},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ht}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ht}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ht}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Nt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new Nt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ht},alphaTest:{value:0},uvTransform:{value:new Ht}},sprite:{diffuse:{value:new Nt(16777215)},opacity:{value:1},center:{value:new zt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ht},alphaMap:{value:null},alphaMapTransform:{value:new Ht},alphaTest:{value:0}}},zi={basic:{uniforms:Xe([at.common,at.specularmap,at.envmap,at.aomap,at.lightmap,at.fog]),vertexShader:Wt.meshbasic_vert,fragmentShader:Wt.meshbasic_frag},lambert:{uniforms:Xe([at.common,at.specularmap,at.envmap,at.aomap,at.lightmap,at.emissivemap,at.bumpmap,at.normalmap,at.displacementmap,at.fog,at.lights,{emissive:{value:new Nt(0)}}]),vertexShader:Wt.meshlambert_vert,fragmentShader:Wt.meshlambert_frag},phong:{uniforms:Xe([at.common,at.specularmap,at.envmap,at.aomap,at.lightmap,at.emissivemap,at.bumpmap,at.normalmap,at.displacementmap,at.fog,at.lights,{emissive:{value:new Nt(0)},specular:{value:new Nt(1118481)},shininess:{value:30}}]),vertexShader:Wt.meshphong_vert,fragmentShader:Wt.meshphong_frag},standard:{uniforms:Xe([at.common,at.envmap,at.aomap,at.lightmap,at.emissivemap,at.bumpmap,at.normalmap,at.displacementmap,at.roughnessmap,at.metalnessmap,at.fog,at.lights,{emissive:{value:new Nt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Wt.meshphysical_vert,fragmentShader:Wt.meshphysical_frag},toon:{uniforms:Xe([at.common,at.aomap,at.lightmap,at.emissivemap,at.bumpmap,at.normalmap,at.displacementmap,at.gradientmap,at.fog,at.lights,{emissive:{value:new Nt(0)}}]),vertexShader:Wt.meshtoon_vert,fragmentShader:Wt.meshtoon_frag},matcap:{uniforms:Xe([at.common,at.bumpmap,at.normalmap,at.displacementmap,at.fog,{matcap:{value:null}}]),vertexShader:Wt.meshmatcap_vert,fragmentShader:Wt.meshmatcap_frag},points:{uniforms:Xe([at.points,at.fog]),vertexShader:Wt.points_vert,fragmentShader:Wt.points_frag},dashed:{uniforms:Xe([at.common,at.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Wt.linedashed_vert,fragmentShader:Wt.linedashed_frag},depth:{uniforms:Xe([at.common,at.displacementmap]),vertexShader:Wt.depth_vert,fragmentShader:Wt.depth_frag},normal:{uniforms:Xe([at.common,at.bumpmap,at.normalmap,at.displacementmap,{opacity:{value:1}}]),vertexShader:Wt.meshnormal_vert,fragmentShader:Wt.meshnormal_frag},sprite:{uniforms:Xe([at.sprite,at.fog]),vertexShader:Wt.sprite_vert,fragmentShader:Wt.sprite_frag},background:{uniforms:{uvTransform:{value:new Ht},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Wt.background_vert,fragmentShader:Wt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ht}},vertexShader:Wt.backgroundCube_vert,fragmentShader:Wt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Wt.cube_vert,fragmentShader:Wt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Wt.equirect_vert,fragmentShader:Wt.equirect_frag},distanceRGBA:{uniforms:Xe([at.common,at.displacementmap,{referencePosition:{value:new F},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Wt.distanceRGBA_vert,fragmentShader:Wt.distanceRGBA_frag},shadow:{uniforms:Xe([at.lights,at.fog,{color:{value:new Nt(0)},opacity:{value:1}}]),vertexShader:Wt.shadow_vert,fragmentShader:Wt.shadow_frag}};zi.physical={uniforms:Xe([zi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ht},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ht},clearcoatNormalScale:{value:new zt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ht},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ht},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ht},sheen:{value:0},sheenColor:{value:new Nt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ht},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ht},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ht},transmissionSamplerSize:{value:new zt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ht},attenuationDistance:{value:0},attenuationColor:{value:new Nt(0)},specularColor:{value:new Nt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ht},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ht},anisotropyVector:{value:new zt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ht}}]),vertexShader:Wt.meshphysical_vert,fragmentShader:Wt.meshphysical_frag};var sl={r:0,b:0,g:0},Vn=new wi,mv=new ae;function gv(n,t,e,i,s,r,o){let a=new Nt(0),l=r===!0?0:1,c,h,u=null,d=0,m=null;function v(T){let S=T.isScene===!0?T.background:null;return S&&S.isTexture&&(S=(T.backgroundBlurriness>0?e:t).get(S)),S}function w(T){let S=!1,I=v(T);I===null?f(a,l):I&&I.isColor&&(f(I,1),S=!0);let P=n.xr.getEnvironmentBlendMode();P==="additive"?i.buffers.color.setClear(0,0,0,1,o):P==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(n.autoClear||S)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function g(T,S){let I=v(S);I&&(I.isCubeTexture||I.mapping===wr)?(h===void 0&&(h=new We(new _s(1,1,1),new Si({name:"BackgroundCubeMaterial",uniforms:Hn(zi.backgroundCube.uniforms),vertexShader:zi.backgroundCube.vertexShader,fragmentShader:zi.backgroundCube.fragmentShader,side:je,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(P,D,k){this.matrixWorld.copyPosition(k.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),Vn.copy(S.backgroundRotation),Vn.x*=-1,Vn.y*=-1,Vn.z*=-1,I.isCubeTexture&&I.isRenderTargetTexture===!1&&(Vn.y*=-1,Vn.z*=-1),h.material.uniforms.envMap.value=I,h.material.uniforms.flipEnvMap.value=I.isCubeTexture&&I.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(mv.makeRotationFromEuler(Vn)),h.material.toneMapped=Jt.getTransfer(I.colorSpace)!==ne,(u!==I||d!==I.version||m!==n.toneMapping)&&(h.material.needsUpdate=!0,u=I,d=I.version,m=n.toneMapping),h.layers.enableAll(),T.unshift(h,h.geometry,h.material,0,0,null)):I&&I.isTexture&&(c===void 0&&(c=new We(new _r(2,2),new Si({name:"BackgroundMaterial",uniforms:Hn(zi.background.uniforms),vertexShader:zi.background.vertexShader,fragmentShader:zi.background.fragmentShader,side:ji,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=I,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.toneMapped=Jt.getTransfer(I.colorSpace)!==ne,I.matrixAutoUpdate===!0&&I.updateMatrix(),c.material.uniforms.uvTransform.value.copy(I.matrix),(u!==I||d!==I.version||m!==n.toneMapping)&&(c.material.needsUpdate=!0,u=I,d=I.version,m=n.toneMapping),c.layers.enableAll(),T.unshift(c,c.geometry,c.material,0,0,null))}function f(T,S){T.getRGB(sl,Vc(n)),i.buffers.color.setClear(sl.r,sl.g,sl.b,S,o)}function R(){h!==void 0&&(h.geometry.dispose(),h.material.dispose(),h=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(T,S=1){a.set(T),l=S,f(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(T){l=T,f(a,l)},render:w,addToRenderList:g,dispose:R}}function _v(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(b,C,B,V,X){let K=!1,Y=u(V,B,C);r!==Y&&(r=Y,c(r.object)),K=m(b,V,B,X),K&&v(b,V,B,X),X!==null&&t.update(X,n.ELEMENT_ARRAY_BUFFER),(K||o)&&(o=!1,S(b,C,B,V),X!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(X).buffer))}function l(){return n.createVertexArray()}function c(b){return n.bindVertexArray(b)}function h(b){return n.deleteVertexArray(b)}function u(b,C,B){let V=B.wireframe===!0,X=i[b.id];X===void 0&&(X={},i[b.id]=X);let K=X[C.id];K===void 0&&(K={},X[C.id]=K);let Y=K[V];return Y===void 0&&(Y=d(l()),K[V]=Y),Y}function d(b){let C=[],B=[],V=[];for(let X=0;X<e;X++)C[X]=0,B[X]=0,V[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:B,attributeDivisors:V,object:b,attributes:{},index:null}}function m(b,C,B,V){let X=r.attributes,K=C.attributes,Y=0,nt=B.getAttributes();for(let G in nt)if(nt[G].location>=0){let dt=X[G],Tt=K[G];if(Tt===void 0&&(G==="instanceMatrix"&&b.instanceMatrix&&(Tt=b.instanceMatrix),G==="instanceColor"&&b.instanceColor&&(Tt=b.instanceColor)),dt===void 0||dt.attribute!==Tt||Tt&&dt.data!==Tt.data)return!0;Y++}return r.attributesNum!==Y||r.index!==V}function v(b,C,B,V){let X={},K=C.attributes,Y=0,nt=B.getAttributes();for(let G in nt)if(nt[G].location>=0){let dt=K[G];dt===void 0&&(G==="instanceMatrix"&&b.instanceMatrix&&(dt=b.instanceMatrix),G==="instanceColor"&&b.instanceColor&&(dt=b.instanceColor));let Tt={};Tt.attribute=dt,dt&&dt.data&&(Tt.data=dt.data),X[G]=Tt,Y++}r.attributes=X,r.attributesNum=Y,r.index=V}function w(){let b=r.newAttributes;for(let C=0,B=b.length;C<B;C++)b[C]=0}function g(b){f(b,0)}function f(b,C){let B=r.newAttributes,V=r.enabledAttributes,X=r.attributeDivisors;B[b]=1,V[b]===0&&(n.enableVertexAttribArray(b),V[b]=1),X[b]!==C&&(n.vertexAttribDivisor(b,C),X[b]=C)}function R(){let b=r.newAttributes,C=r.enabledAttributes;for(let B=0,V=C.length;B<V;B++)C[B]!==b[B]&&(n.disableVertexAttribArray(B),C[B]=0)}function T(b,C,B,V,X,K,Y){Y===!0?n.vertexAttribIPointer(b,C,B,X,K):n.vertexAttribPointer(b,C,B,V,X,K)}function S(b,C,B,V){w();let X=V.attributes,K=B.getAttributes(),Y=C.defaultAttributeValues;for(let nt in K){let G=K[nt];if(G.location>=0){let lt=X[nt];if(lt===void 0&&(nt==="instanceMatrix"&&b.instanceMatrix&&(lt=b.instanceMatrix),nt==="instanceColor"&&b.instanceColor&&(lt=b.instanceColor)),lt!==void 0){let dt=lt.normalized,Tt=lt.itemSize,Yt=t.get(lt);if(Yt===void 0)continue;let le=Yt.buffer,fe=Yt.type,te=Yt.bytesPerElement,$=fe===n.INT||fe===n.UNSIGNED_INT||lt.gpuType===wa;if(lt.isInterleavedBufferAttribute){let J=lt.data,mt=J.stride,Ut=lt.offset;if(J.isInstancedInterleavedBuffer){for(let St=0;St<G.locationSize;St++)f(G.location+St,J.meshPerAttribute);b.isInstancedMesh!==!0&&V._maxInstanceCount===void 0&&(V._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let St=0;St<G.locationSize;St++)g(G.location+St);n.bindBuffer(n.ARRAY_BUFFER,le);for(let St=0;St<G.locationSize;St++)T(G.location+St,Tt/G.locationSize,fe,dt,mt*te,(Ut+Tt/G.locationSize*St)*te,$)}else{if(lt.isInstancedBufferAttribute){for(let J=0;J<G.locationSize;J++)f(G.location+J,lt.meshPerAttribute);b.isInstancedMesh!==!0&&V._maxInstanceCount===void 0&&(V._maxInstanceCount=lt.meshPerAttribute*lt.count)}else for(let J=0;J<G.locationSize;J++)g(G.location+J);n.bindBuffer(n.ARRAY_BUFFER,le);for(let J=0;J<G.locationSize;J++)T(G.location+J,Tt/G.locationSize,fe,dt,Tt*te,Tt/G.locationSize*J*te,$)}}else if(Y!==void 0){let dt=Y[nt];if(dt!==void 0)switch(dt.length){case 2:n.vertexAttrib2fv(G.location,dt);break;case 3:n.vertexAttrib3fv(G.location,dt);break;case 4:n.vertexAttrib4fv(G.location,dt);break;default:n.vertexAttrib1fv(G.location,dt)}}}}R()}function I(){k();for(let b in i){let C=i[b];for(let B in C){let V=C[B];for(let X in V)h(V[X].object),delete V[X];delete C[B]}delete i[b]}}function P(b){if(i[b.id]===void 0)return;let C=i[b.id];for(let B in C){let V=C[B];for(let X in V)h(V[X].object),delete V[X];delete C[B]}delete i[b.id]}function D(b){for(let C in i){let B=i[C];if(B[b.id]===void 0)continue;let V=B[b.id];for(let X in V)h(V[X].object),delete V[X];delete B[b.id]}}function k(){y(),o=!0,r!==s&&(r=s,c(r.object))}function y(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:y,dispose:I,releaseStatesOfGeometry:P,releaseStatesOfProgram:D,initAttributes:w,enableAttribute:g,disableUnusedAttributes:R}}function vv(n,t,e){let i;function s(c){i=c}function r(c,h){n.drawArrays(i,c,h),e.update(h,i,1)}function o(c,h,u){u!==0&&(n.drawArraysInstanced(i,c,h,u),e.update(h,i,u))}function a(c,h,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,h,0,u);let m=0;for(let v=0;v<u;v++)m+=h[v];e.update(m,i,1)}function l(c,h,u,d){if(u===0)return;let m=t.get("WEBGL_multi_draw");if(m===null)for(let v=0;v<c.length;v++)o(c[v],h[v],d[v]);else{m.multiDrawArraysInstancedWEBGL(i,c,0,h,0,d,0,u);let v=0;for(let w=0;w<u;w++)v+=h[w]*d[w];e.update(v,i,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function yv(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let D=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==pi&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){let k=D===bs&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==Bi&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Ti&&!k)}function l(D){if(D==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.logarithmicDepthBuffer===!0,d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),m=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),w=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),f=n.getParameter(n.MAX_VERTEX_ATTRIBS),R=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),I=v>0,P=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:m,maxVertexTextures:v,maxTextureSize:w,maxCubemapSize:g,maxAttributes:f,maxVertexUniforms:R,maxVaryings:T,maxFragmentUniforms:S,vertexTextures:I,maxSamples:P}}function xv(n){let t=this,e=null,i=0,s=!1,r=!1,o=new $e,a=new Ht,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let m=u.length!==0||d||i!==0||s;return s=d,i=u.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,m){let v=u.clippingPlanes,w=u.clipIntersection,g=u.clipShadows,f=n.get(u);if(!s||v===null||v.length===0||r&&!g)r?h(null):c();else{let R=r?0:i,T=R*4,S=f.clippingState||null;l.value=S,S=h(v,d,T,m);for(let I=0;I!==T;++I)S[I]=e[I];f.clippingState=S,this.numIntersection=w?this.numPlanes:0,this.numPlanes+=R}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,d,m,v){let w=u!==null?u.length:0,g=null;if(w!==0){if(g=l.value,v!==!0||g===null){let f=m+w*4,R=d.matrixWorldInverse;a.getNormalMatrix(R),(g===null||g.length<f)&&(g=new Float32Array(f));for(let T=0,S=m;T!==w;++T,S+=4)o.copy(u[T]).applyMatrix4(R,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=w,t.numIntersection=0,g}}function bv(n){let t=new WeakMap;function e(o,a){return a===xa?o.mapping=Bn:a===ba&&(o.mapping=zn),o}function i(o){if(o&&o.isTexture){let a=o.mapping;if(a===xa||a===ba)if(t.has(o)){let l=t.get(o).texture;return e(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new $o(l.height);return c.fromEquirectangularTexture(n,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:i,dispose:r}}var Ts=4,vd=[.125,.215,.35,.446,.526,.582],Xn=20,qc=new ha,yd=new Nt,Yc=null,$c=0,Zc=0,Kc=!1,Wn=(1+Math.sqrt(5))/2,Es=1/Wn,xd=[new F(-Wn,Es,0),new F(Wn,Es,0),new F(-Es,0,Wn),new F(Es,0,Wn),new F(0,Wn,-Es),new F(0,Wn,Es),new F(-1,1,-1),new F(1,1,-1),new F(-1,1,1),new F(1,1,1)],Mv=new F,al=class{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=Mv}=r;Yc=this._renderer.getRenderTarget(),$c=this._renderer.getActiveCubeFace(),Zc=this._renderer.getActiveMipmapLevel(),Kc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(t,i,s,l,a),e>0&&this._blur(l,0,0,e),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=wd(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Md(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(Yc,$c,Zc),this._renderer.xr.enabled=Kc,t.scissorTest=!1,rl(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===Bn||t.mapping===zn?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),Yc=this._renderer.getRenderTarget(),$c=this._renderer.getActiveCubeFace(),Zc=this._renderer.getActiveMipmapLevel(),Kc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let i=e||this._allocateTargets();return this._textureToCubeUV(t,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){let t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,i={magFilter:Mi,minFilter:Mi,generateMipmaps:!1,type:bs,format:pi,colorSpace:Nn,depthBuffer:!1},s=bd(t,e,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=bd(t,e,i);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=wv(r)),this._blurMaterial=Sv(r,t,e)}return s}_compileMaterial(t){let e=new We(this._lodPlanes[0],t);this._renderer.compile(e,qc)}_sceneToCubeUV(t,e,i,s,r){let l=new Ve(90,1,e,i),c=[1,-1,1,1,1,1],h=[1,1,1,-1,-1,-1],u=this._renderer,d=u.autoClear,m=u.toneMapping;u.getClearColor(yd),u.toneMapping=tn,u.autoClear=!1,u.state.buffers.depth.getReversed()&&(u.setRenderTarget(s),u.clearDepth(),u.setRenderTarget(null));let w=new rr({name:"PMREM.Background",side:je,depthWrite:!1,depthTest:!1}),g=new We(new _s,w),f=!1,R=t.background;R?R.isColor&&(w.color.copy(R),t.background=null,f=!0):(w.color.copy(yd),f=!0);for(let T=0;T<6;T++){let S=T%3;S===0?(l.up.set(0,c[T],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+h[T],r.y,r.z)):S===1?(l.up.set(0,0,c[T]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+h[T],r.z)):(l.up.set(0,c[T],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+h[T]));let I=this._cubeSize;rl(s,S*I,T>2?I:0,I,I),u.setRenderTarget(s),f&&u.render(g,l),u.render(t,l)}g.geometry.dispose(),g.material.dispose(),u.toneMapping=m,u.autoClear=d,t.background=R}_textureToCubeUV(t,e){let i=this._renderer,s=t.mapping===Bn||t.mapping===zn;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=wd()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Md());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new We(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;let l=this._cubeSize;rl(e,0,0,3*l,2*l),i.setRenderTarget(e),i.render(o,qc)}_applyPMREM(t){let e=this._renderer,i=e.autoClear;e.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=xd[(s-r-1)%xd.length];this._blur(t,r-1,r,o,a)}e.autoClear=i}_blur(t,e,i,s,r){let o=this._pingPongRenderTarget;this._halfBlur(t,o,e,i,s,"latitudinal",r),this._halfBlur(o,t,i,i,s,"longitudinal",r)}_halfBlur(t,e,i,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let h=3,u=new We(this._lodPlanes[s],c),d=c.uniforms,m=this._sizeLods[i]-1,v=isFinite(r)?Math.PI/(2*m):2*Math.PI/(2*Xn-1),w=r/v,g=isFinite(r)?1+Math.floor(h*w):Xn;g>Xn&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${g} samples when the maximum is set to ${Xn}`);let f=[],R=0;for(let D=0;D<Xn;++D){let k=D/w,y=Math.exp(-k*k/2);f.push(y),D===0?R+=y:D<g&&(R+=2*y)}for(let D=0;D<f.length;D++)f[D]=f[D]/R;d.envMap.value=t.texture,d.samples.value=g,d.weights.value=f,d.latitudinal.value=o==="latitudinal",a&&(d.poleAxis.value=a);let{_lodMax:T}=this;d.dTheta.value=v,d.mipInt.value=T-i;let S=this._sizeLods[s],I=3*S*(s>T-Ts?s-T+Ts:0),P=4*(this._cubeSize-S);rl(e,I,P,3*S,2*S),l.setRenderTarget(e),l.render(u,qc)}};function wv(n){let t=[],e=[],i=[],s=n,r=n-Ts+1+vd.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>n-Ts?l=vd[o-n+Ts-1]:o===0&&(l=0),i.push(l);let c=1/(a-2),h=-c,u=1+c,d=[h,h,u,h,u,u,h,h,u,u,h,u],m=6,v=6,w=3,g=2,f=1,R=new Float32Array(w*v*m),T=new Float32Array(g*v*m),S=new Float32Array(f*v*m);for(let P=0;P<m;P++){let D=P%3*2/3-1,k=P>2?0:-1,y=[D,k,0,D+2/3,k,0,D+2/3,k+1,0,D,k,0,D+2/3,k+1,0,D,k+1,0];R.set(y,w*v*P),T.set(d,g*v*P);let b=[P,P,P,P,P,P];S.set(b,f*v*P)}let I=new be;I.setAttribute("position",new ye(R,w)),I.setAttribute("uv",new ye(T,g)),I.setAttribute("faceIndex",new ye(S,f)),t.push(I),s>Ts&&s--}return{lodPlanes:t,sizeLods:e,sigmas:i}}function bd(n,t,e){let i=new Li(n,t,e);return i.texture.mapping=wr,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function rl(n,t,e,i,s){n.viewport.set(t,e,i,s),n.scissor.set(t,e,i,s)}function Sv(n,t,e){let i=new Float32Array(Xn),s=new F(0,1,0);return new Si({name:"SphericalGaussianBlur",defines:{n:Xn,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:oh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:Qi,depthTest:!1,depthWrite:!1})}function Md(){return new Si({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:oh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:Qi,depthTest:!1,depthWrite:!1})}function wd(){return new Si({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:oh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:Qi,depthTest:!1,depthWrite:!1})}function oh(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function Ev(n){let t=new WeakMap,e=null;function i(a){if(a&&a.isTexture){let l=a.mapping,c=l===xa||l===ba,h=l===Bn||l===zn;if(c||h){let u=t.get(a),d=u!==void 0?u.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==d)return e===null&&(e=new al(n)),u=c?e.fromEquirectangular(a,u):e.fromCubemap(a,u),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),u.texture;if(u!==void 0)return u.texture;{let m=a.image;return c&&m&&m.height>0||h&&m&&s(m)?(e===null&&(e=new al(n)),u=c?e.fromEquirectangular(a):e.fromCubemap(a),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),a.addEventListener("dispose",r),u.texture):null}}}return a}function s(a){let l=0,c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:i,dispose:o}}function Tv(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&ms("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function Av(n,t,e,i){let s={},r=new WeakMap;function o(u){let d=u.target;d.index!==null&&t.remove(d.index);for(let v in d.attributes)t.remove(d.attributes[v]);d.removeEventListener("dispose",o),delete s[d.id];let m=r.get(d);m&&(t.remove(m),r.delete(d)),i.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,e.memory.geometries--}function a(u,d){return s[d.id]===!0||(d.addEventListener("dispose",o),s[d.id]=!0,e.memory.geometries++),d}function l(u){let d=u.attributes;for(let m in d)t.update(d[m],n.ARRAY_BUFFER)}function c(u){let d=[],m=u.index,v=u.attributes.position,w=0;if(m!==null){let R=m.array;w=m.version;for(let T=0,S=R.length;T<S;T+=3){let I=R[T+0],P=R[T+1],D=R[T+2];d.push(I,P,P,D,D,I)}}else if(v!==void 0){let R=v.array;w=v.version;for(let T=0,S=R.length/3-1;T<S;T+=3){let I=T+0,P=T+1,D=T+2;d.push(I,P,P,D,D,I)}}else return;let g=new(Hc(d)?ar:or)(d,1);g.version=w;let f=r.get(u);f&&t.remove(f),r.set(u,g)}function h(u){let d=r.get(u);if(d){let m=u.index;m!==null&&d.version<m.version&&c(u)}else c(u);return r.get(u)}return{get:a,update:l,getWireframeAttribute:h}}function Rv(n,t,e){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,m){n.drawElements(i,m,r,d*o),e.update(m,i,1)}function c(d,m,v){v!==0&&(n.drawElementsInstanced(i,m,r,d*o,v),e.update(m,i,v))}function h(d,m,v){if(v===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,m,0,r,d,0,v);let g=0;for(let f=0;f<v;f++)g+=m[f];e.update(g,i,1)}function u(d,m,v,w){if(v===0)return;let g=t.get("WEBGL_multi_draw");if(g===null)for(let f=0;f<d.length;f++)c(d[f]/o,m[f],w[f]);else{g.multiDrawElementsInstancedWEBGL(i,m,0,r,d,0,w,0,v);let f=0;for(let R=0;R<v;R++)f+=m[R]*w[R];e.update(f,i,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function Cv(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function Pv(n,t,e){let i=new WeakMap,s=new xe;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=i.get(a);if(d===void 0||d.count!==u){let y=function(){D.dispose(),i.delete(a),a.removeEventListener("dispose",y)};d!==void 0&&d.texture.dispose();let m=a.morphAttributes.position!==void 0,v=a.morphAttributes.normal!==void 0,w=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],f=a.morphAttributes.normal||[],R=a.morphAttributes.color||[],T=0;m===!0&&(T=1),v===!0&&(T=2),w===!0&&(T=3);let S=a.attributes.position.count*T,I=1;S>t.maxTextureSize&&(I=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let P=new Float32Array(S*I*4*u),D=new nr(P,S,I,u);D.type=Ti,D.needsUpdate=!0;let k=T*4;for(let b=0;b<u;b++){let C=g[b],B=f[b],V=R[b],X=S*I*4*b;for(let K=0;K<C.count;K++){let Y=K*k;m===!0&&(s.fromBufferAttribute(C,K),P[X+Y+0]=s.x,P[X+Y+1]=s.y,P[X+Y+2]=s.z,P[X+Y+3]=0),v===!0&&(s.fromBufferAttribute(B,K),P[X+Y+4]=s.x,P[X+Y+5]=s.y,P[X+Y+6]=s.z,P[X+Y+7]=0),w===!0&&(s.fromBufferAttribute(V,K),P[X+Y+8]=s.x,P[X+Y+9]=s.y,P[X+Y+10]=s.z,P[X+Y+11]=V.itemSize===4?s.w:1)}}d={count:u,texture:D,size:new zt(S,I)},i.set(a,d),a.addEventListener("dispose",y)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let m=0;for(let w=0;w<c.length;w++)m+=c[w];let v=a.morphTargetsRelative?1:1-m;l.getUniforms().setValue(n,"morphTargetBaseInfluence",v),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function Iv(n,t,e,i){let s=new WeakMap;function r(l){let c=i.render.frame,h=l.geometry,u=t.get(l,h);if(s.get(u)!==c&&(t.update(u),s.set(u,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let d=l.skeleton;s.get(d)!==c&&(d.update(),s.set(d,c))}return u}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}var Vd=new Ke,Sd=new mr(1,1),Gd=new nr,Wd=new qo,Xd=new cr,Ed=[],Td=[],Ad=new Float32Array(16),Rd=new Float32Array(9),Cd=new Float32Array(4);function Rs(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Ed[s];if(r===void 0&&(r=new Float32Array(s),Ed[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Ae(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Re(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function cl(n,t){let e=Td[t];e===void 0&&(e=new Int32Array(t),Td[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function Lv(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function Dv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ae(e,t))return;n.uniform2fv(this.addr,t),Re(e,t)}}function Uv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Ae(e,t))return;n.uniform3fv(this.addr,t),Re(e,t)}}function Nv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ae(e,t))return;n.uniform4fv(this.addr,t),Re(e,t)}}function Fv(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ae(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Re(e,t)}else{if(Ae(e,i))return;Cd.set(i),n.uniformMatrix2fv(this.addr,!1,Cd),Re(e,i)}}function Ov(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ae(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Re(e,t)}else{if(Ae(e,i))return;Rd.set(i),n.uniformMatrix3fv(this.addr,!1,Rd),Re(e,i)}}function kv(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ae(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Re(e,t)}else{if(Ae(e,i))return;Ad.set(i),n.uniformMatrix4fv(this.addr,!1,Ad),Re(e,i)}}function Bv(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function zv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ae(e,t))return;n.uniform2iv(this.addr,t),Re(e,t)}}function Hv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ae(e,t))return;n.uniform3iv(this.addr,t),Re(e,t)}}function Vv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ae(e,t))return;n.uniform4iv(this.addr,t),Re(e,t)}}function Gv(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function Wv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ae(e,t))return;n.uniform2uiv(this.addr,t),Re(e,t)}}function Xv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ae(e,t))return;n.uniform3uiv(this.addr,t),Re(e,t)}}function qv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ae(e,t))return;n.uniform4uiv(this.addr,t),Re(e,t)}}function Yv(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(Sd.compareFunction=Oc,r=Sd):r=Vd,e.setTexture2D(t||r,s)}function $v(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Wd,s)}function Zv(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTextureCube(t||Xd,s)}function Kv(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Gd,s)}function jv(n){switch(n){case 5126:return Lv;case 35664:return Dv;case 35665:return Uv;case 35666:return Nv;case 35674:return Fv;case 35675:return Ov;case 35676:return kv;case 5124:case 35670:return Bv;case 35667:case 35671:return zv;case 35668:case 35672:return Hv;case 35669:case 35673:return Vv;case 5125:return Gv;case 36294:return Wv;case 36295:return Xv;case 36296:return qv;case 35678:case 36198:case 36298:case 36306:case 35682:return Yv;case 35679:case 36299:case 36307:return $v;case 35680:case 36300:case 36308:case 36293:return Zv;case 36289:case 36303:case 36311:case 36292:return Kv}}function Jv(n,t){n.uniform1fv(this.addr,t)}function Qv(n,t){let e=Rs(t,this.size,2);n.uniform2fv(this.addr,e)}function ty(n,t){let e=Rs(t,this.size,3);n.uniform3fv(this.addr,e)}function ey(n,t){let e=Rs(t,this.size,4);n.uniform4fv(this.addr,e)}function iy(n,t){let e=Rs(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function ny(n,t){let e=Rs(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function sy(n,t){let e=Rs(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function ry(n,t){n.uniform1iv(this.addr,t)}function oy(n,t){n.uniform2iv(this.addr,t)}function ay(n,t){n.uniform3iv(this.addr,t)}function ly(n,t){n.uniform4iv(this.addr,t)}function cy(n,t){n.uniform1uiv(this.addr,t)}function hy(n,t){n.uniform2uiv(this.addr,t)}function uy(n,t){n.uniform3uiv(this.addr,t)}function dy(n,t){n.uniform4uiv(this.addr,t)}function fy(n,t,e){let i=this.cache,s=t.length,r=cl(e,s);Ae(i,r)||(n.uniform1iv(this.addr,r),Re(i,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||Vd,r[o])}function py(n,t,e){let i=this.cache,s=t.length,r=cl(e,s);Ae(i,r)||(n.uniform1iv(this.addr,r),Re(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Wd,r[o])}function my(n,t,e){let i=this.cache,s=t.length,r=cl(e,s);Ae(i,r)||(n.uniform1iv(this.addr,r),Re(i,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||Xd,r[o])}function gy(n,t,e){let i=this.cache,s=t.length,r=cl(e,s);Ae(i,r)||(n.uniform1iv(this.addr,r),Re(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Gd,r[o])}function _y(n){switch(n){case 5126:return Jv;case 35664:return Qv;case 35665:return ty;case 35666:return ey;case 35674:return iy;case 35675:return ny;case 35676:return sy;case 5124:case 35670:return ry;case 35667:case 35671:return oy;case 35668:case 35672:return ay;case 35669:case 35673:return ly;case 5125:return cy;case 36294:return hy;case 36295:return uy;case 36296:return dy;case 35678:case 36198:case 36298:case 36306:case 35682:return fy;case 35679:case 36299:case 36307:return py;case 35680:case 36300:case 36308:case 36293:return my;case 36289:case 36303:case 36311:case 36292:return gy}}var Jc=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=jv(e.type)}},Qc=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=_y(e.type)}},th=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},jc=/(\w+)(\])?(\[|\.)?/g;function Pd(n,t){n.seq.push(t),n.map[t.id]=t}function vy(n,t,e){let i=n.name,s=i.length;for(jc.lastIndex=0;;){let r=jc.exec(i),o=jc.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Pd(e,c===void 0?new Jc(a,n,t):new Qc(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new th(a),Pd(e,u)),e=u}}}var As=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){let r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);vy(r,o,this)}}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Id(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var yy=37297,xy=0;function by(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Ld=new Ht;function My(n){Jt._getMatrix(Ld,Jt.workingColorSpace,n);let t=`mat3( ${Ld.elements.map(e=>e.toFixed(4))} )`;switch(Jt.getTransfer(n)){case tr:return[t,"LinearTransferOETF"];case ne:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Dd(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+by(n.getShaderSource(t),a)}else return r}function wy(n,t){let e=My(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function Sy(n,t){let e;switch(t){case Zu:e="Linear";break;case Ku:e="Reinhard";break;case ju:e="Cineon";break;case Ju:e="ACESFilmic";break;case td:e="AgX";break;case ed:e="Neutral";break;case Qu:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ol=new F;function Ey(){Jt.getLuminanceCoefficients(ol);let n=ol.x.toFixed(4),t=ol.y.toFixed(4),e=ol.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Ty(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Cr).join(`
`)}function Ay(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function Ry(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Cr(n){return n!==""}function Ud(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function Nd(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Cy=/^[ \t]*#include +<([\w\d./]+)>/gm;function eh(n){return n.replace(Cy,Iy)}var Py=new Map;function Iy(n,t){let e=Wt[t];if(e===void 0){let i=Py.get(t);if(i!==void 0)e=Wt[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,i);else throw new Error("Can not resolve #include <"+t+">")}return eh(e)}var Ly=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Fd(n){return n.replace(Ly,Dy)}function Dy(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Od(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function Uy(n){let t="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===Sc?t="SHADOWMAP_TYPE_PCF":n.shadowMapType===Ru?t="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===Oi&&(t="SHADOWMAP_TYPE_VSM"),t}function Ny(n){let t="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case Bn:case zn:t="ENVMAP_TYPE_CUBE";break;case wr:t="ENVMAP_TYPE_CUBE_UV";break}return t}function Fy(n){let t="ENVMAP_MODE_REFLECTION";if(n.envMap)switch(n.envMapMode){case zn:t="ENVMAP_MODE_REFRACTION";break}return t}function Oy(n){let t="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case ya:t="ENVMAP_BLENDING_MULTIPLY";break;case Yu:t="ENVMAP_BLENDING_MIX";break;case $u:t="ENVMAP_BLENDING_ADD";break}return t}function ky(n){let t=n.envMapCubeUVHeight;if(t===null)return null;let e=Math.log2(t)-2,i=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:i,maxMip:e}}function By(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=Uy(e),c=Ny(e),h=Fy(e),u=Oy(e),d=ky(e),m=Ty(e),v=Ay(r),w=s.createProgram(),g,f,R=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,v].filter(Cr).join(`
`),g.length>0&&(g+=`
`),f=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,v].filter(Cr).join(`
`),f.length>0&&(f+=`
`)):(g=[Od(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,v,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Cr).join(`
`),f=[Od(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,v,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==tn?"#define TONE_MAPPING":"",e.toneMapping!==tn?Wt.tonemapping_pars_fragment:"",e.toneMapping!==tn?Sy("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Wt.colorspace_pars_fragment,wy("linearToOutputTexel",e.outputColorSpace),Ey(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Cr).join(`
`)),o=eh(o),o=Ud(o,e),o=Nd(o,e),a=eh(a),a=Ud(a,e),a=Nd(a,e),o=Fd(o),a=Fd(a),e.isRawShaderMaterial!==!0&&(R=`#version 300 es
`,g=[m,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+g,f=["#define varying in",e.glslVersion===kc?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===kc?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);let T=R+g+o,S=R+f+a,I=Id(s,s.VERTEX_SHADER,T),P=Id(s,s.FRAGMENT_SHADER,S);s.attachShader(w,I),s.attachShader(w,P),e.index0AttributeName!==void 0?s.bindAttribLocation(w,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(w,0,"position"),s.linkProgram(w);function D(C){if(n.debug.checkShaderErrors){let B=s.getProgramInfoLog(w)||"",V=s.getShaderInfoLog(I)||"",X=s.getShaderInfoLog(P)||"",K=B.trim(),Y=V.trim(),nt=X.trim(),G=!0,lt=!0;if(s.getProgramParameter(w,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,w,I,P);else{let dt=Dd(s,I,"vertex"),Tt=Dd(s,P,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(w,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+K+`
`+dt+`
`+Tt)}else K!==""?console.warn("THREE.WebGLProgram: Program Info Log:",K):(Y===""||nt==="")&&(lt=!1);lt&&(C.diagnostics={runnable:G,programLog:K,vertexShader:{log:Y,prefix:g},fragmentShader:{log:nt,prefix:f}})}s.deleteShader(I),s.deleteShader(P),k=new As(s,w),y=Ry(s,w)}let k;this.getUniforms=function(){return k===void 0&&D(this),k};let y;this.getAttributes=function(){return y===void 0&&D(this),y};let b=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return b===!1&&(b=s.getProgramParameter(w,yy)),b},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(w),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=xy++,this.cacheKey=t,this.usedTimes=1,this.program=w,this.vertexShader=I,this.fragmentShader=P,this}var zy=0,ih=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){let e=t.vertexShader,i=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(i),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new nh(t),e.set(t,i)),i}},nh=class{constructor(t){this.id=zy++,this.code=t,this.usedTimes=0}};function Hy(n,t,e,i,s,r,o){let a=new sr,l=new ih,c=new Set,h=[],u=s.logarithmicDepthBuffer,d=s.vertexTextures,m=s.precision,v={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function w(y){return c.add(y),y===0?"uv":`uv${y}`}function g(y,b,C,B,V){let X=B.fog,K=V.geometry,Y=y.isMeshStandardMaterial?B.environment:null,nt=(y.isMeshStandardMaterial?e:t).get(y.envMap||Y),G=nt&&nt.mapping===wr?nt.image.height:null,lt=v[y.type];y.precision!==null&&(m=s.getMaxPrecision(y.precision),m!==y.precision&&console.warn("THREE.WebGLProgram.getParameters:",y.precision,"not supported, using",m,"instead."));let dt=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,Tt=dt!==void 0?dt.length:0,Yt=0;K.morphAttributes.position!==void 0&&(Yt=1),K.morphAttributes.normal!==void 0&&(Yt=2),K.morphAttributes.color!==void 0&&(Yt=3);let le,fe,te,$;if(lt){let ee=zi[lt];le=ee.vertexShader,fe=ee.fragmentShader}else le=y.vertexShader,fe=y.fragmentShader,l.update(y),te=l.getVertexShaderID(y),$=l.getFragmentShaderID(y);let J=n.getRenderTarget(),mt=n.state.buffers.depth.getReversed(),Ut=V.isInstancedMesh===!0,St=V.isBatchedMesh===!0,Kt=!!y.map,Ne=!!y.matcap,A=!!nt,pe=!!y.aoMap,kt=!!y.lightMap,Lt=!!y.bumpMap,vt=!!y.normalMap,me=!!y.displacementMap,yt=!!y.emissiveMap,Gt=!!y.metalnessMap,Pe=!!y.roughnessMap,Me=y.anisotropy>0,E=y.clearcoat>0,_=y.dispersion>0,O=y.iridescence>0,q=y.sheen>0,j=y.transmission>0,W=Me&&!!y.anisotropyMap,wt=E&&!!y.clearcoatMap,st=E&&!!y.clearcoatNormalMap,xt=E&&!!y.clearcoatRoughnessMap,bt=O&&!!y.iridescenceMap,et=O&&!!y.iridescenceThicknessMap,ut=q&&!!y.sheenColorMap,It=q&&!!y.sheenRoughnessMap,Mt=!!y.specularMap,ct=!!y.specularColorMap,Vt=!!y.specularIntensityMap,L=j&&!!y.transmissionMap,it=j&&!!y.thicknessMap,rt=!!y.gradientMap,pt=!!y.alphaMap,Q=y.alphaTest>0,Z=!!y.alphaHash,_t=!!y.extensions,Ft=tn;y.toneMapped&&(J===null||J.isXRRenderTarget===!0)&&(Ft=n.toneMapping);let ce={shaderID:lt,shaderType:y.type,shaderName:y.name,vertexShader:le,fragmentShader:fe,defines:y.defines,customVertexShaderID:te,customFragmentShaderID:$,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:m,batching:St,batchingColor:St&&V._colorsTexture!==null,instancing:Ut,instancingColor:Ut&&V.instanceColor!==null,instancingMorph:Ut&&V.morphTexture!==null,supportsVertexTextures:d,outputColorSpace:J===null?n.outputColorSpace:J.isXRRenderTarget===!0?J.texture.colorSpace:Nn,alphaToCoverage:!!y.alphaToCoverage,map:Kt,matcap:Ne,envMap:A,envMapMode:A&&nt.mapping,envMapCubeUVHeight:G,aoMap:pe,lightMap:kt,bumpMap:Lt,normalMap:vt,displacementMap:d&&me,emissiveMap:yt,normalMapObjectSpace:vt&&y.normalMapType===rd,normalMapTangentSpace:vt&&y.normalMapType===Fc,metalnessMap:Gt,roughnessMap:Pe,anisotropy:Me,anisotropyMap:W,clearcoat:E,clearcoatMap:wt,clearcoatNormalMap:st,clearcoatRoughnessMap:xt,dispersion:_,iridescence:O,iridescenceMap:bt,iridescenceThicknessMap:et,sheen:q,sheenColorMap:ut,sheenRoughnessMap:It,specularMap:Mt,specularColorMap:ct,specularIntensityMap:Vt,transmission:j,transmissionMap:L,thicknessMap:it,gradientMap:rt,opaque:y.transparent===!1&&y.blending===Dn&&y.alphaToCoverage===!1,alphaMap:pt,alphaTest:Q,alphaHash:Z,combine:y.combine,mapUv:Kt&&w(y.map.channel),aoMapUv:pe&&w(y.aoMap.channel),lightMapUv:kt&&w(y.lightMap.channel),bumpMapUv:Lt&&w(y.bumpMap.channel),normalMapUv:vt&&w(y.normalMap.channel),displacementMapUv:me&&w(y.displacementMap.channel),emissiveMapUv:yt&&w(y.emissiveMap.channel),metalnessMapUv:Gt&&w(y.metalnessMap.channel),roughnessMapUv:Pe&&w(y.roughnessMap.channel),anisotropyMapUv:W&&w(y.anisotropyMap.channel),clearcoatMapUv:wt&&w(y.clearcoatMap.channel),clearcoatNormalMapUv:st&&w(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:xt&&w(y.clearcoatRoughnessMap.channel),iridescenceMapUv:bt&&w(y.iridescenceMap.channel),iridescenceThicknessMapUv:et&&w(y.iridescenceThicknessMap.channel),sheenColorMapUv:ut&&w(y.sheenColorMap.channel),sheenRoughnessMapUv:It&&w(y.sheenRoughnessMap.channel),specularMapUv:Mt&&w(y.specularMap.channel),specularColorMapUv:ct&&w(y.specularColorMap.channel),specularIntensityMapUv:Vt&&w(y.specularIntensityMap.channel),transmissionMapUv:L&&w(y.transmissionMap.channel),thicknessMapUv:it&&w(y.thicknessMap.channel),alphaMapUv:pt&&w(y.alphaMap.channel),vertexTangents:!!K.attributes.tangent&&(vt||Me),vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,pointsUvs:V.isPoints===!0&&!!K.attributes.uv&&(Kt||pt),fog:!!X,useFog:y.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:y.flatShading===!0&&y.wireframe===!1,sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:mt,skinning:V.isSkinnedMesh===!0,morphTargets:K.morphAttributes.position!==void 0,morphNormals:K.morphAttributes.normal!==void 0,morphColors:K.morphAttributes.color!==void 0,morphTargetsCount:Tt,morphTextureStride:Yt,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:Ft,decodeVideoTexture:Kt&&y.map.isVideoTexture===!0&&Jt.getTransfer(y.map.colorSpace)===ne,decodeVideoTextureEmissive:yt&&y.emissiveMap.isVideoTexture===!0&&Jt.getTransfer(y.emissiveMap.colorSpace)===ne,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===ki,flipSided:y.side===je,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:_t&&y.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(_t&&y.extensions.multiDraw===!0||St)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return ce.vertexUv1s=c.has(1),ce.vertexUv2s=c.has(2),ce.vertexUv3s=c.has(3),c.clear(),ce}function f(y){let b=[];if(y.shaderID?b.push(y.shaderID):(b.push(y.customVertexShaderID),b.push(y.customFragmentShaderID)),y.defines!==void 0)for(let C in y.defines)b.push(C),b.push(y.defines[C]);return y.isRawShaderMaterial===!1&&(R(b,y),T(b,y),b.push(n.outputColorSpace)),b.push(y.customProgramCacheKey),b.join()}function R(y,b){y.push(b.precision),y.push(b.outputColorSpace),y.push(b.envMapMode),y.push(b.envMapCubeUVHeight),y.push(b.mapUv),y.push(b.alphaMapUv),y.push(b.lightMapUv),y.push(b.aoMapUv),y.push(b.bumpMapUv),y.push(b.normalMapUv),y.push(b.displacementMapUv),y.push(b.emissiveMapUv),y.push(b.metalnessMapUv),y.push(b.roughnessMapUv),y.push(b.anisotropyMapUv),y.push(b.clearcoatMapUv),y.push(b.clearcoatNormalMapUv),y.push(b.clearcoatRoughnessMapUv),y.push(b.iridescenceMapUv),y.push(b.iridescenceThicknessMapUv),y.push(b.sheenColorMapUv),y.push(b.sheenRoughnessMapUv),y.push(b.specularMapUv),y.push(b.specularColorMapUv),y.push(b.specularIntensityMapUv),y.push(b.transmissionMapUv),y.push(b.thicknessMapUv),y.push(b.combine),y.push(b.fogExp2),y.push(b.sizeAttenuation),y.push(b.morphTargetsCount),y.push(b.morphAttributeCount),y.push(b.numDirLights),y.push(b.numPointLights),y.push(b.numSpotLights),y.push(b.numSpotLightMaps),y.push(b.numHemiLights),y.push(b.numRectAreaLights),y.push(b.numDirLightShadows),y.push(b.numPointLightShadows),y.push(b.numSpotLightShadows),y.push(b.numSpotLightShadowsWithMaps),y.push(b.numLightProbes),y.push(b.shadowMapType),y.push(b.toneMapping),y.push(b.numClippingPlanes),y.push(b.numClipIntersection),y.push(b.depthPacking)}function T(y,b){a.disableAll(),b.supportsVertexTextures&&a.enable(0),b.instancing&&a.enable(1),b.instancingColor&&a.enable(2),b.instancingMorph&&a.enable(3),b.matcap&&a.enable(4),b.envMap&&a.enable(5),b.normalMapObjectSpace&&a.enable(6),b.normalMapTangentSpace&&a.enable(7),b.clearcoat&&a.enable(8),b.iridescence&&a.enable(9),b.alphaTest&&a.enable(10),b.vertexColors&&a.enable(11),b.vertexAlphas&&a.enable(12),b.vertexUv1s&&a.enable(13),b.vertexUv2s&&a.enable(14),b.vertexUv3s&&a.enable(15),b.vertexTangents&&a.enable(16),b.anisotropy&&a.enable(17),b.alphaHash&&a.enable(18),b.batching&&a.enable(19),b.dispersion&&a.enable(20),b.batchingColor&&a.enable(21),b.gradientMap&&a.enable(22),y.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reversedDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),y.push(a.mask)}function S(y){let b=v[y.type],C;if(b){let B=zi[b];C=gd.clone(B.uniforms)}else C=y.uniforms;return C}function I(y,b){let C;for(let B=0,V=h.length;B<V;B++){let X=h[B];if(X.cacheKey===b){C=X,++C.usedTimes;break}}return C===void 0&&(C=new By(n,b,y,r),h.push(C)),C}function P(y){if(--y.usedTimes===0){let b=h.indexOf(y);h[b]=h[h.length-1],h.pop(),y.destroy()}}function D(y){l.remove(y)}function k(){l.dispose()}return{getParameters:g,getProgramCacheKey:f,getUniforms:S,acquireProgram:I,releaseProgram:P,releaseShaderCache:D,programs:h,dispose:k}}function Vy(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function Gy(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.z!==t.z?n.z-t.z:n.id-t.id}function kd(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Bd(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(u,d,m,v,w,g){let f=n[t];return f===void 0?(f={id:u.id,object:u,geometry:d,material:m,groupOrder:v,renderOrder:u.renderOrder,z:w,group:g},n[t]=f):(f.id=u.id,f.object=u,f.geometry=d,f.material=m,f.groupOrder=v,f.renderOrder=u.renderOrder,f.z=w,f.group=g),t++,f}function a(u,d,m,v,w,g){let f=o(u,d,m,v,w,g);m.transmission>0?i.push(f):m.transparent===!0?s.push(f):e.push(f)}function l(u,d,m,v,w,g){let f=o(u,d,m,v,w,g);m.transmission>0?i.unshift(f):m.transparent===!0?s.unshift(f):e.unshift(f)}function c(u,d){e.length>1&&e.sort(u||Gy),i.length>1&&i.sort(d||kd),s.length>1&&s.sort(d||kd)}function h(){for(let u=t,d=n.length;u<d;u++){let m=n[u];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:a,unshift:l,finish:h,sort:c}}function Wy(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Bd,n.set(i,[o])):s>=r.length?(o=new Bd,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function Xy(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new F,color:new Nt};break;case"SpotLight":e={position:new F,direction:new F,color:new Nt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new F,color:new Nt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new F,skyColor:new Nt,groundColor:new Nt};break;case"RectAreaLight":e={color:new Nt,position:new F,halfWidth:new F,halfHeight:new F};break}return n[t.id]=e,e}}}function qy(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new zt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new zt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new zt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var Yy=0;function $y(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function Zy(n){let t=new Xy,e=qy(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new F);let s=new F,r=new ae,o=new ae;function a(c){let h=0,u=0,d=0;for(let y=0;y<9;y++)i.probe[y].set(0,0,0);let m=0,v=0,w=0,g=0,f=0,R=0,T=0,S=0,I=0,P=0,D=0;c.sort($y);for(let y=0,b=c.length;y<b;y++){let C=c[y],B=C.color,V=C.intensity,X=C.distance,K=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)h+=B.r*V,u+=B.g*V,d+=B.b*V;else if(C.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(C.sh.coefficients[Y],V);D++}else if(C.isDirectionalLight){let Y=t.get(C);if(Y.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let nt=C.shadow,G=e.get(C);G.shadowIntensity=nt.intensity,G.shadowBias=nt.bias,G.shadowNormalBias=nt.normalBias,G.shadowRadius=nt.radius,G.shadowMapSize=nt.mapSize,i.directionalShadow[m]=G,i.directionalShadowMap[m]=K,i.directionalShadowMatrix[m]=C.shadow.matrix,R++}i.directional[m]=Y,m++}else if(C.isSpotLight){let Y=t.get(C);Y.position.setFromMatrixPosition(C.matrixWorld),Y.color.copy(B).multiplyScalar(V),Y.distance=X,Y.coneCos=Math.cos(C.angle),Y.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),Y.decay=C.decay,i.spot[w]=Y;let nt=C.shadow;if(C.map&&(i.spotLightMap[I]=C.map,I++,nt.updateMatrices(C),C.castShadow&&P++),i.spotLightMatrix[w]=nt.matrix,C.castShadow){let G=e.get(C);G.shadowIntensity=nt.intensity,G.shadowBias=nt.bias,G.shadowNormalBias=nt.normalBias,G.shadowRadius=nt.radius,G.shadowMapSize=nt.mapSize,i.spotShadow[w]=G,i.spotShadowMap[w]=K,S++}w++}else if(C.isRectAreaLight){let Y=t.get(C);Y.color.copy(B).multiplyScalar(V),Y.halfWidth.set(C.width*.5,0,0),Y.halfHeight.set(0,C.height*.5,0),i.rectArea[g]=Y,g++}else if(C.isPointLight){let Y=t.get(C);if(Y.color.copy(C.color).multiplyScalar(C.intensity),Y.distance=C.distance,Y.decay=C.decay,C.castShadow){let nt=C.shadow,G=e.get(C);G.shadowIntensity=nt.intensity,G.shadowBias=nt.bias,G.shadowNormalBias=nt.normalBias,G.shadowRadius=nt.radius,G.shadowMapSize=nt.mapSize,G.shadowCameraNear=nt.camera.near,G.shadowCameraFar=nt.camera.far,i.pointShadow[v]=G,i.pointShadowMap[v]=K,i.pointShadowMatrix[v]=C.shadow.matrix,T++}i.point[v]=Y,v++}else if(C.isHemisphereLight){let Y=t.get(C);Y.skyColor.copy(C.color).multiplyScalar(V),Y.groundColor.copy(C.groundColor).multiplyScalar(V),i.hemi[f]=Y,f++}}g>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=at.LTC_FLOAT_1,i.rectAreaLTC2=at.LTC_FLOAT_2):(i.rectAreaLTC1=at.LTC_HALF_1,i.rectAreaLTC2=at.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=d;let k=i.hash;(k.directionalLength!==m||k.pointLength!==v||k.spotLength!==w||k.rectAreaLength!==g||k.hemiLength!==f||k.numDirectionalShadows!==R||k.numPointShadows!==T||k.numSpotShadows!==S||k.numSpotMaps!==I||k.numLightProbes!==D)&&(i.directional.length=m,i.spot.length=w,i.rectArea.length=g,i.point.length=v,i.hemi.length=f,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.pointShadow.length=T,i.pointShadowMap.length=T,i.spotShadow.length=S,i.spotShadowMap.length=S,i.directionalShadowMatrix.length=R,i.pointShadowMatrix.length=T,i.spotLightMatrix.length=S+I-P,i.spotLightMap.length=I,i.numSpotLightShadowsWithMaps=P,i.numLightProbes=D,k.directionalLength=m,k.pointLength=v,k.spotLength=w,k.rectAreaLength=g,k.hemiLength=f,k.numDirectionalShadows=R,k.numPointShadows=T,k.numSpotShadows=S,k.numSpotMaps=I,k.numLightProbes=D,i.version=Yy++)}function l(c,h){let u=0,d=0,m=0,v=0,w=0,g=h.matrixWorldInverse;for(let f=0,R=c.length;f<R;f++){let T=c[f];if(T.isDirectionalLight){let S=i.directional[u];S.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(g),u++}else if(T.isSpotLight){let S=i.spot[m];S.position.setFromMatrixPosition(T.matrixWorld),S.position.applyMatrix4(g),S.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(g),m++}else if(T.isRectAreaLight){let S=i.rectArea[v];S.position.setFromMatrixPosition(T.matrixWorld),S.position.applyMatrix4(g),o.identity(),r.copy(T.matrixWorld),r.premultiply(g),o.extractRotation(r),S.halfWidth.set(T.width*.5,0,0),S.halfHeight.set(0,T.height*.5,0),S.halfWidth.applyMatrix4(o),S.halfHeight.applyMatrix4(o),v++}else if(T.isPointLight){let S=i.point[d];S.position.setFromMatrixPosition(T.matrixWorld),S.position.applyMatrix4(g),d++}else if(T.isHemisphereLight){let S=i.hemi[w];S.direction.setFromMatrixPosition(T.matrixWorld),S.direction.transformDirection(g),w++}}}return{setup:a,setupView:l,state:i}}function zd(n){let t=new Zy(n),e=[],i=[];function s(h){c.camera=h,e.length=0,i.length=0}function r(h){e.push(h)}function o(h){i.push(h)}function a(){t.setup(e)}function l(h){t.setupView(e,h)}let c={lightsArray:e,shadowsArray:i,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function Ky(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new zd(n),t.set(s,[a])):r>=o.length?(a=new zd(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var jy=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Jy=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function Qy(n,t,e){let i=new fr,s=new zt,r=new zt,o=new xe,a=new Jo({depthPacking:sd}),l=new Qo,c={},h=e.maxTextureSize,u={[ji]:je,[je]:ji,[ki]:ki},d=new Si({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new zt},radius:{value:4}},vertexShader:jy,fragmentShader:Jy}),m=d.clone();m.defines.HORIZONTAL_PASS=1;let v=new be;v.setAttribute("position",new ye(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let w=new We(v,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Sc;let f=this.type;this.render=function(P,D,k){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||P.length===0)return;let y=n.getRenderTarget(),b=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),B=n.state;B.setBlending(Qi),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let V=f!==Oi&&this.type===Oi,X=f===Oi&&this.type!==Oi;for(let K=0,Y=P.length;K<Y;K++){let nt=P[K],G=nt.shadow;if(G===void 0){console.warn("THREE.WebGLShadowMap:",nt,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let lt=G.getFrameExtents();if(s.multiply(lt),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/lt.x),s.x=r.x*lt.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/lt.y),s.y=r.y*lt.y,G.mapSize.y=r.y)),G.map===null||V===!0||X===!0){let Tt=this.type!==Oi?{minFilter:ti,magFilter:ti}:{};G.map!==null&&G.map.dispose(),G.map=new Li(s.x,s.y,Tt),G.map.texture.name=nt.name+".shadowMap",G.camera.updateProjectionMatrix()}n.setRenderTarget(G.map),n.clear();let dt=G.getViewportCount();for(let Tt=0;Tt<dt;Tt++){let Yt=G.getViewport(Tt);o.set(r.x*Yt.x,r.y*Yt.y,r.x*Yt.z,r.y*Yt.w),B.viewport(o),G.updateMatrices(nt,Tt),i=G.getFrustum(),S(D,k,G.camera,nt,this.type)}G.isPointLightShadow!==!0&&this.type===Oi&&R(G,k),G.needsUpdate=!1}f=this.type,g.needsUpdate=!1,n.setRenderTarget(y,b,C)};function R(P,D){let k=t.update(w);d.defines.VSM_SAMPLES!==P.blurSamples&&(d.defines.VSM_SAMPLES=P.blurSamples,m.defines.VSM_SAMPLES=P.blurSamples,d.needsUpdate=!0,m.needsUpdate=!0),P.mapPass===null&&(P.mapPass=new Li(s.x,s.y)),d.uniforms.shadow_pass.value=P.map.texture,d.uniforms.resolution.value=P.mapSize,d.uniforms.radius.value=P.radius,n.setRenderTarget(P.mapPass),n.clear(),n.renderBufferDirect(D,null,k,d,w,null),m.uniforms.shadow_pass.value=P.mapPass.texture,m.uniforms.resolution.value=P.mapSize,m.uniforms.radius.value=P.radius,n.setRenderTarget(P.map),n.clear(),n.renderBufferDirect(D,null,k,m,w,null)}function T(P,D,k,y){let b=null,C=k.isPointLight===!0?P.customDistanceMaterial:P.customDepthMaterial;if(C!==void 0)b=C;else if(b=k.isPointLight===!0?l:a,n.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0||D.alphaToCoverage===!0){let B=b.uuid,V=D.uuid,X=c[B];X===void 0&&(X={},c[B]=X);let K=X[V];K===void 0&&(K=b.clone(),X[V]=K,D.addEventListener("dispose",I)),b=K}if(b.visible=D.visible,b.wireframe=D.wireframe,y===Oi?b.side=D.shadowSide!==null?D.shadowSide:D.side:b.side=D.shadowSide!==null?D.shadowSide:u[D.side],b.alphaMap=D.alphaMap,b.alphaTest=D.alphaToCoverage===!0?.5:D.alphaTest,b.map=D.map,b.clipShadows=D.clipShadows,b.clippingPlanes=D.clippingPlanes,b.clipIntersection=D.clipIntersection,b.displacementMap=D.displacementMap,b.displacementScale=D.displacementScale,b.displacementBias=D.displacementBias,b.wireframeLinewidth=D.wireframeLinewidth,b.linewidth=D.linewidth,k.isPointLight===!0&&b.isMeshDistanceMaterial===!0){let B=n.properties.get(b);B.light=k}return b}function S(P,D,k,y,b){if(P.visible===!1)return;if(P.layers.test(D.layers)&&(P.isMesh||P.isLine||P.isPoints)&&(P.castShadow||P.receiveShadow&&b===Oi)&&(!P.frustumCulled||i.intersectsObject(P))){P.modelViewMatrix.multiplyMatrices(k.matrixWorldInverse,P.matrixWorld);let V=t.update(P),X=P.material;if(Array.isArray(X)){let K=V.groups;for(let Y=0,nt=K.length;Y<nt;Y++){let G=K[Y],lt=X[G.materialIndex];if(lt&&lt.visible){let dt=T(P,lt,y,b);P.onBeforeShadow(n,P,D,k,V,dt,G),n.renderBufferDirect(k,null,V,dt,P,G),P.onAfterShadow(n,P,D,k,V,dt,G)}}}else if(X.visible){let K=T(P,X,y,b);P.onBeforeShadow(n,P,D,k,V,K,null),n.renderBufferDirect(k,null,V,K,P,null),P.onAfterShadow(n,P,D,k,V,K,null)}}let B=P.children;for(let V=0,X=B.length;V<X;V++)S(B[V],D,k,y,b)}function I(P){P.target.removeEventListener("dispose",I);for(let k in c){let y=c[k],b=P.target.uuid;b in y&&(y[b].dispose(),delete y[b])}}}var t0={[da]:fa,[pa]:_a,[ma]:va,[Un]:ga,[fa]:da,[_a]:pa,[va]:ma,[ga]:Un};function e0(n,t){function e(){let L=!1,it=new xe,rt=null,pt=new xe(0,0,0,0);return{setMask:function(Q){rt!==Q&&!L&&(n.colorMask(Q,Q,Q,Q),rt=Q)},setLocked:function(Q){L=Q},setClear:function(Q,Z,_t,Ft,ce){ce===!0&&(Q*=Ft,Z*=Ft,_t*=Ft),it.set(Q,Z,_t,Ft),pt.equals(it)===!1&&(n.clearColor(Q,Z,_t,Ft),pt.copy(it))},reset:function(){L=!1,rt=null,pt.set(-1,0,0,0)}}}function i(){let L=!1,it=!1,rt=null,pt=null,Q=null;return{setReversed:function(Z){if(it!==Z){let _t=t.get("EXT_clip_control");Z?_t.clipControlEXT(_t.LOWER_LEFT_EXT,_t.ZERO_TO_ONE_EXT):_t.clipControlEXT(_t.LOWER_LEFT_EXT,_t.NEGATIVE_ONE_TO_ONE_EXT),it=Z;let Ft=Q;Q=null,this.setClear(Ft)}},getReversed:function(){return it},setTest:function(Z){Z?J(n.DEPTH_TEST):mt(n.DEPTH_TEST)},setMask:function(Z){rt!==Z&&!L&&(n.depthMask(Z),rt=Z)},setFunc:function(Z){if(it&&(Z=t0[Z]),pt!==Z){switch(Z){case da:n.depthFunc(n.NEVER);break;case fa:n.depthFunc(n.ALWAYS);break;case pa:n.depthFunc(n.LESS);break;case Un:n.depthFunc(n.LEQUAL);break;case ma:n.depthFunc(n.EQUAL);break;case ga:n.depthFunc(n.GEQUAL);break;case _a:n.depthFunc(n.GREATER);break;case va:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}pt=Z}},setLocked:function(Z){L=Z},setClear:function(Z){Q!==Z&&(it&&(Z=1-Z),n.clearDepth(Z),Q=Z)},reset:function(){L=!1,rt=null,pt=null,Q=null,it=!1}}}function s(){let L=!1,it=null,rt=null,pt=null,Q=null,Z=null,_t=null,Ft=null,ce=null;return{setTest:function(ee){L||(ee?J(n.STENCIL_TEST):mt(n.STENCIL_TEST))},setMask:function(ee){it!==ee&&!L&&(n.stencilMask(ee),it=ee)},setFunc:function(ee,Vi,Ai){(rt!==ee||pt!==Vi||Q!==Ai)&&(n.stencilFunc(ee,Vi,Ai),rt=ee,pt=Vi,Q=Ai)},setOp:function(ee,Vi,Ai){(Z!==ee||_t!==Vi||Ft!==Ai)&&(n.stencilOp(ee,Vi,Ai),Z=ee,_t=Vi,Ft=Ai)},setLocked:function(ee){L=ee},setClear:function(ee){ce!==ee&&(n.clearStencil(ee),ce=ee)},reset:function(){L=!1,it=null,rt=null,pt=null,Q=null,Z=null,_t=null,Ft=null,ce=null}}}let r=new e,o=new i,a=new s,l=new WeakMap,c=new WeakMap,h={},u={},d=new WeakMap,m=[],v=null,w=!1,g=null,f=null,R=null,T=null,S=null,I=null,P=null,D=new Nt(0,0,0),k=0,y=!1,b=null,C=null,B=null,V=null,X=null,K=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),Y=!1,nt=0,G=n.getParameter(n.VERSION);G.indexOf("WebGL")!==-1?(nt=parseFloat(/^WebGL (\d)/.exec(G)[1]),Y=nt>=1):G.indexOf("OpenGL ES")!==-1&&(nt=parseFloat(/^OpenGL ES (\d)/.exec(G)[1]),Y=nt>=2);let lt=null,dt={},Tt=n.getParameter(n.SCISSOR_BOX),Yt=n.getParameter(n.VIEWPORT),le=new xe().fromArray(Tt),fe=new xe().fromArray(Yt);function te(L,it,rt,pt){let Q=new Uint8Array(4),Z=n.createTexture();n.bindTexture(L,Z),n.texParameteri(L,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(L,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let _t=0;_t<rt;_t++)L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY?n.texImage3D(it,0,n.RGBA,1,1,pt,0,n.RGBA,n.UNSIGNED_BYTE,Q):n.texImage2D(it+_t,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Q);return Z}let $={};$[n.TEXTURE_2D]=te(n.TEXTURE_2D,n.TEXTURE_2D,1),$[n.TEXTURE_CUBE_MAP]=te(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),$[n.TEXTURE_2D_ARRAY]=te(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),$[n.TEXTURE_3D]=te(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),J(n.DEPTH_TEST),o.setFunc(Un),Lt(!1),vt(wc),J(n.CULL_FACE),pe(Qi);function J(L){h[L]!==!0&&(n.enable(L),h[L]=!0)}function mt(L){h[L]!==!1&&(n.disable(L),h[L]=!1)}function Ut(L,it){return u[L]!==it?(n.bindFramebuffer(L,it),u[L]=it,L===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=it),L===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=it),!0):!1}function St(L,it){let rt=m,pt=!1;if(L){rt=d.get(it),rt===void 0&&(rt=[],d.set(it,rt));let Q=L.textures;if(rt.length!==Q.length||rt[0]!==n.COLOR_ATTACHMENT0){for(let Z=0,_t=Q.length;Z<_t;Z++)rt[Z]=n.COLOR_ATTACHMENT0+Z;rt.length=Q.length,pt=!0}}else rt[0]!==n.BACK&&(rt[0]=n.BACK,pt=!0);pt&&n.drawBuffers(rt)}function Kt(L){return v!==L?(n.useProgram(L),v=L,!0):!1}let Ne={[dn]:n.FUNC_ADD,[Pu]:n.FUNC_SUBTRACT,[Iu]:n.FUNC_REVERSE_SUBTRACT};Ne[Lu]=n.MIN,Ne[Du]=n.MAX;let A={[Uu]:n.ZERO,[Nu]:n.ONE,[Fu]:n.SRC_COLOR,[Bo]:n.SRC_ALPHA,[Vu]:n.SRC_ALPHA_SATURATE,[zu]:n.DST_COLOR,[ku]:n.DST_ALPHA,[Ou]:n.ONE_MINUS_SRC_COLOR,[zo]:n.ONE_MINUS_SRC_ALPHA,[Hu]:n.ONE_MINUS_DST_COLOR,[Bu]:n.ONE_MINUS_DST_ALPHA,[Gu]:n.CONSTANT_COLOR,[Wu]:n.ONE_MINUS_CONSTANT_COLOR,[Xu]:n.CONSTANT_ALPHA,[qu]:n.ONE_MINUS_CONSTANT_ALPHA};function pe(L,it,rt,pt,Q,Z,_t,Ft,ce,ee){if(L===Qi){w===!0&&(mt(n.BLEND),w=!1);return}if(w===!1&&(J(n.BLEND),w=!0),L!==Cu){if(L!==g||ee!==y){if((f!==dn||S!==dn)&&(n.blendEquation(n.FUNC_ADD),f=dn,S=dn),ee)switch(L){case Dn:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ec:n.blendFunc(n.ONE,n.ONE);break;case Tc:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Ac:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",L);break}else switch(L){case Dn:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ec:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Tc:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Ac:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",L);break}R=null,T=null,I=null,P=null,D.set(0,0,0),k=0,g=L,y=ee}return}Q=Q||it,Z=Z||rt,_t=_t||pt,(it!==f||Q!==S)&&(n.blendEquationSeparate(Ne[it],Ne[Q]),f=it,S=Q),(rt!==R||pt!==T||Z!==I||_t!==P)&&(n.blendFuncSeparate(A[rt],A[pt],A[Z],A[_t]),R=rt,T=pt,I=Z,P=_t),(Ft.equals(D)===!1||ce!==k)&&(n.blendColor(Ft.r,Ft.g,Ft.b,ce),D.copy(Ft),k=ce),g=L,y=!1}function kt(L,it){L.side===ki?mt(n.CULL_FACE):J(n.CULL_FACE);let rt=L.side===je;it&&(rt=!rt),Lt(rt),L.blending===Dn&&L.transparent===!1?pe(Qi):pe(L.blending,L.blendEquation,L.blendSrc,L.blendDst,L.blendEquationAlpha,L.blendSrcAlpha,L.blendDstAlpha,L.blendColor,L.blendAlpha,L.premultipliedAlpha),o.setFunc(L.depthFunc),o.setTest(L.depthTest),o.setMask(L.depthWrite),r.setMask(L.colorWrite);let pt=L.stencilWrite;a.setTest(pt),pt&&(a.setMask(L.stencilWriteMask),a.setFunc(L.stencilFunc,L.stencilRef,L.stencilFuncMask),a.setOp(L.stencilFail,L.stencilZFail,L.stencilZPass)),yt(L.polygonOffset,L.polygonOffsetFactor,L.polygonOffsetUnits),L.alphaToCoverage===!0?J(n.SAMPLE_ALPHA_TO_COVERAGE):mt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Lt(L){b!==L&&(L?n.frontFace(n.CW):n.frontFace(n.CCW),b=L)}function vt(L){L!==Tu?(J(n.CULL_FACE),L!==C&&(L===wc?n.cullFace(n.BACK):L===Au?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):mt(n.CULL_FACE),C=L}function me(L){L!==B&&(Y&&n.lineWidth(L),B=L)}function yt(L,it,rt){L?(J(n.POLYGON_OFFSET_FILL),(V!==it||X!==rt)&&(n.polygonOffset(it,rt),V=it,X=rt)):mt(n.POLYGON_OFFSET_FILL)}function Gt(L){L?J(n.SCISSOR_TEST):mt(n.SCISSOR_TEST)}function Pe(L){L===void 0&&(L=n.TEXTURE0+K-1),lt!==L&&(n.activeTexture(L),lt=L)}function Me(L,it,rt){rt===void 0&&(lt===null?rt=n.TEXTURE0+K-1:rt=lt);let pt=dt[rt];pt===void 0&&(pt={type:void 0,texture:void 0},dt[rt]=pt),(pt.type!==L||pt.texture!==it)&&(lt!==rt&&(n.activeTexture(rt),lt=rt),n.bindTexture(L,it||$[L]),pt.type=L,pt.texture=it)}function E(){let L=dt[lt];L!==void 0&&L.type!==void 0&&(n.bindTexture(L.type,null),L.type=void 0,L.texture=void 0)}function _(){try{n.compressedTexImage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function O(){try{n.compressedTexImage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function q(){try{n.texSubImage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function j(){try{n.texSubImage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function W(){try{n.compressedTexSubImage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function wt(){try{n.compressedTexSubImage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function st(){try{n.texStorage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function xt(){try{n.texStorage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function bt(){try{n.texImage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function et(){try{n.texImage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function ut(L){le.equals(L)===!1&&(n.scissor(L.x,L.y,L.z,L.w),le.copy(L))}function It(L){fe.equals(L)===!1&&(n.viewport(L.x,L.y,L.z,L.w),fe.copy(L))}function Mt(L,it){let rt=c.get(it);rt===void 0&&(rt=new WeakMap,c.set(it,rt));let pt=rt.get(L);pt===void 0&&(pt=n.getUniformBlockIndex(it,L.name),rt.set(L,pt))}function ct(L,it){let pt=c.get(it).get(L);l.get(it)!==pt&&(n.uniformBlockBinding(it,pt,L.__bindingPointIndex),l.set(it,pt))}function Vt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),h={},lt=null,dt={},u={},d=new WeakMap,m=[],v=null,w=!1,g=null,f=null,R=null,T=null,S=null,I=null,P=null,D=new Nt(0,0,0),k=0,y=!1,b=null,C=null,B=null,V=null,X=null,le.set(0,0,n.canvas.width,n.canvas.height),fe.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:J,disable:mt,bindFramebuffer:Ut,drawBuffers:St,useProgram:Kt,setBlending:pe,setMaterial:kt,setFlipSided:Lt,setCullFace:vt,setLineWidth:me,setPolygonOffset:yt,setScissorTest:Gt,activeTexture:Pe,bindTexture:Me,unbindTexture:E,compressedTexImage2D:_,compressedTexImage3D:O,texImage2D:bt,texImage3D:et,updateUBOMapping:Mt,uniformBlockBinding:ct,texStorage2D:st,texStorage3D:xt,texSubImage2D:q,texSubImage3D:j,compressedTexSubImage2D:W,compressedTexSubImage3D:wt,scissor:ut,viewport:It,reset:Vt}}function i0(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new zt,h=new WeakMap,u,d=new WeakMap,m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function v(E,_){return m?new OffscreenCanvas(E,_):ir("canvas")}function w(E,_,O){let q=1,j=Me(E);if((j.width>O||j.height>O)&&(q=O/Math.max(j.width,j.height)),q<1)if(typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&E instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&E instanceof ImageBitmap||typeof VideoFrame<"u"&&E instanceof VideoFrame){let W=Math.floor(q*j.width),wt=Math.floor(q*j.height);u===void 0&&(u=v(W,wt));let st=_?v(W,wt):u;return st.width=W,st.height=wt,st.getContext("2d").drawImage(E,0,0,W,wt),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+W+"x"+wt+")."),st}else return"data"in E&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),E;return E}function g(E){return E.generateMipmaps}function f(E){n.generateMipmap(E)}function R(E){return E.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:E.isWebGL3DRenderTarget?n.TEXTURE_3D:E.isWebGLArrayRenderTarget||E.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(E,_,O,q,j=!1){if(E!==null){if(n[E]!==void 0)return n[E];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+E+"'")}let W=_;if(_===n.RED&&(O===n.FLOAT&&(W=n.R32F),O===n.HALF_FLOAT&&(W=n.R16F),O===n.UNSIGNED_BYTE&&(W=n.R8)),_===n.RED_INTEGER&&(O===n.UNSIGNED_BYTE&&(W=n.R8UI),O===n.UNSIGNED_SHORT&&(W=n.R16UI),O===n.UNSIGNED_INT&&(W=n.R32UI),O===n.BYTE&&(W=n.R8I),O===n.SHORT&&(W=n.R16I),O===n.INT&&(W=n.R32I)),_===n.RG&&(O===n.FLOAT&&(W=n.RG32F),O===n.HALF_FLOAT&&(W=n.RG16F),O===n.UNSIGNED_BYTE&&(W=n.RG8)),_===n.RG_INTEGER&&(O===n.UNSIGNED_BYTE&&(W=n.RG8UI),O===n.UNSIGNED_SHORT&&(W=n.RG16UI),O===n.UNSIGNED_INT&&(W=n.RG32UI),O===n.BYTE&&(W=n.RG8I),O===n.SHORT&&(W=n.RG16I),O===n.INT&&(W=n.RG32I)),_===n.RGB_INTEGER&&(O===n.UNSIGNED_BYTE&&(W=n.RGB8UI),O===n.UNSIGNED_SHORT&&(W=n.RGB16UI),O===n.UNSIGNED_INT&&(W=n.RGB32UI),O===n.BYTE&&(W=n.RGB8I),O===n.SHORT&&(W=n.RGB16I),O===n.INT&&(W=n.RGB32I)),_===n.RGBA_INTEGER&&(O===n.UNSIGNED_BYTE&&(W=n.RGBA8UI),O===n.UNSIGNED_SHORT&&(W=n.RGBA16UI),O===n.UNSIGNED_INT&&(W=n.RGBA32UI),O===n.BYTE&&(W=n.RGBA8I),O===n.SHORT&&(W=n.RGBA16I),O===n.INT&&(W=n.RGBA32I)),_===n.RGB&&(O===n.UNSIGNED_INT_5_9_9_9_REV&&(W=n.RGB9_E5),O===n.UNSIGNED_INT_10F_11F_11F_REV&&(W=n.R11F_G11F_B10F)),_===n.RGBA){let wt=j?tr:Jt.getTransfer(q);O===n.FLOAT&&(W=n.RGBA32F),O===n.HALF_FLOAT&&(W=n.RGBA16F),O===n.UNSIGNED_BYTE&&(W=wt===ne?n.SRGB8_ALPHA8:n.RGBA8),O===n.UNSIGNED_SHORT_4_4_4_4&&(W=n.RGBA4),O===n.UNSIGNED_SHORT_5_5_5_1&&(W=n.RGB5_A1)}return(W===n.R16F||W===n.R32F||W===n.RG16F||W===n.RG32F||W===n.RGBA16F||W===n.RGBA32F)&&t.get("EXT_color_buffer_float"),W}function S(E,_){let O;return E?_===null||_===yn||_===Ms?O=n.DEPTH24_STENCIL8:_===Ti?O=n.DEPTH32F_STENCIL8:_===xs&&(O=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):_===null||_===yn||_===Ms?O=n.DEPTH_COMPONENT24:_===Ti?O=n.DEPTH_COMPONENT32F:_===xs&&(O=n.DEPTH_COMPONENT16),O}function I(E,_){return g(E)===!0||E.isFramebufferTexture&&E.minFilter!==ti&&E.minFilter!==Mi?Math.log2(Math.max(_.width,_.height))+1:E.mipmaps!==void 0&&E.mipmaps.length>0?E.mipmaps.length:E.isCompressedTexture&&Array.isArray(E.image)?_.mipmaps.length:1}function P(E){let _=E.target;_.removeEventListener("dispose",P),k(_),_.isVideoTexture&&h.delete(_)}function D(E){let _=E.target;_.removeEventListener("dispose",D),b(_)}function k(E){let _=i.get(E);if(_.__webglInit===void 0)return;let O=E.source,q=d.get(O);if(q){let j=q[_.__cacheKey];j.usedTimes--,j.usedTimes===0&&y(E),Object.keys(q).length===0&&d.delete(O)}i.remove(E)}function y(E){let _=i.get(E);n.deleteTexture(_.__webglTexture);let O=E.source,q=d.get(O);delete q[_.__cacheKey],o.memory.textures--}function b(E){let _=i.get(E);if(E.depthTexture&&(E.depthTexture.dispose(),i.remove(E.depthTexture)),E.isWebGLCubeRenderTarget)for(let q=0;q<6;q++){if(Array.isArray(_.__webglFramebuffer[q]))for(let j=0;j<_.__webglFramebuffer[q].length;j++)n.deleteFramebuffer(_.__webglFramebuffer[q][j]);else n.deleteFramebuffer(_.__webglFramebuffer[q]);_.__webglDepthbuffer&&n.deleteRenderbuffer(_.__webglDepthbuffer[q])}else{if(Array.isArray(_.__webglFramebuffer))for(let q=0;q<_.__webglFramebuffer.length;q++)n.deleteFramebuffer(_.__webglFramebuffer[q]);else n.deleteFramebuffer(_.__webglFramebuffer);if(_.__webglDepthbuffer&&n.deleteRenderbuffer(_.__webglDepthbuffer),_.__webglMultisampledFramebuffer&&n.deleteFramebuffer(_.__webglMultisampledFramebuffer),_.__webglColorRenderbuffer)for(let q=0;q<_.__webglColorRenderbuffer.length;q++)_.__webglColorRenderbuffer[q]&&n.deleteRenderbuffer(_.__webglColorRenderbuffer[q]);_.__webglDepthRenderbuffer&&n.deleteRenderbuffer(_.__webglDepthRenderbuffer)}let O=E.textures;for(let q=0,j=O.length;q<j;q++){let W=i.get(O[q]);W.__webglTexture&&(n.deleteTexture(W.__webglTexture),o.memory.textures--),i.remove(O[q])}i.remove(E)}let C=0;function B(){C=0}function V(){let E=C;return E>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+E+" texture units while this GPU supports only "+s.maxTextures),C+=1,E}function X(E){let _=[];return _.push(E.wrapS),_.push(E.wrapT),_.push(E.wrapR||0),_.push(E.magFilter),_.push(E.minFilter),_.push(E.anisotropy),_.push(E.internalFormat),_.push(E.format),_.push(E.type),_.push(E.generateMipmaps),_.push(E.premultiplyAlpha),_.push(E.flipY),_.push(E.unpackAlignment),_.push(E.colorSpace),_.join()}function K(E,_){let O=i.get(E);if(E.isVideoTexture&&Gt(E),E.isRenderTargetTexture===!1&&E.isExternalTexture!==!0&&E.version>0&&O.__version!==E.version){let q=E.image;if(q===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(q.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{$(O,E,_);return}}else E.isExternalTexture&&(O.__webglTexture=E.sourceTexture?E.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,O.__webglTexture,n.TEXTURE0+_)}function Y(E,_){let O=i.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&O.__version!==E.version){$(O,E,_);return}e.bindTexture(n.TEXTURE_2D_ARRAY,O.__webglTexture,n.TEXTURE0+_)}function nt(E,_){let O=i.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&O.__version!==E.version){$(O,E,_);return}e.bindTexture(n.TEXTURE_3D,O.__webglTexture,n.TEXTURE0+_)}function G(E,_){let O=i.get(E);if(E.version>0&&O.__version!==E.version){J(O,E,_);return}e.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+_)}let lt={[Ho]:n.REPEAT,[un]:n.CLAMP_TO_EDGE,[Vo]:n.MIRRORED_REPEAT},dt={[ti]:n.NEAREST,[id]:n.NEAREST_MIPMAP_NEAREST,[Sr]:n.NEAREST_MIPMAP_LINEAR,[Mi]:n.LINEAR,[Ma]:n.LINEAR_MIPMAP_NEAREST,[vn]:n.LINEAR_MIPMAP_LINEAR},Tt={[od]:n.NEVER,[dd]:n.ALWAYS,[ad]:n.LESS,[Oc]:n.LEQUAL,[ld]:n.EQUAL,[ud]:n.GEQUAL,[cd]:n.GREATER,[hd]:n.NOTEQUAL};function Yt(E,_){if(_.type===Ti&&t.has("OES_texture_float_linear")===!1&&(_.magFilter===Mi||_.magFilter===Ma||_.magFilter===Sr||_.magFilter===vn||_.minFilter===Mi||_.minFilter===Ma||_.minFilter===Sr||_.minFilter===vn)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(E,n.TEXTURE_WRAP_S,lt[_.wrapS]),n.texParameteri(E,n.TEXTURE_WRAP_T,lt[_.wrapT]),(E===n.TEXTURE_3D||E===n.TEXTURE_2D_ARRAY)&&n.texParameteri(E,n.TEXTURE_WRAP_R,lt[_.wrapR]),n.texParameteri(E,n.TEXTURE_MAG_FILTER,dt[_.magFilter]),n.texParameteri(E,n.TEXTURE_MIN_FILTER,dt[_.minFilter]),_.compareFunction&&(n.texParameteri(E,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(E,n.TEXTURE_COMPARE_FUNC,Tt[_.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(_.magFilter===ti||_.minFilter!==Sr&&_.minFilter!==vn||_.type===Ti&&t.has("OES_texture_float_linear")===!1)return;if(_.anisotropy>1||i.get(_).__currentAnisotropy){let O=t.get("EXT_texture_filter_anisotropic");n.texParameterf(E,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(_.anisotropy,s.getMaxAnisotropy())),i.get(_).__currentAnisotropy=_.anisotropy}}}function le(E,_){let O=!1;E.__webglInit===void 0&&(E.__webglInit=!0,_.addEventListener("dispose",P));let q=_.source,j=d.get(q);j===void 0&&(j={},d.set(q,j));let W=X(_);if(W!==E.__cacheKey){j[W]===void 0&&(j[W]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,O=!0),j[W].usedTimes++;let wt=j[E.__cacheKey];wt!==void 0&&(j[E.__cacheKey].usedTimes--,wt.usedTimes===0&&y(_)),E.__cacheKey=W,E.__webglTexture=j[W].texture}return O}function fe(E,_,O){return Math.floor(Math.floor(E/O)/_)}function te(E,_,O,q){let W=E.updateRanges;if(W.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,_.width,_.height,O,q,_.data);else{W.sort((et,ut)=>et.start-ut.start);let wt=0;for(let et=1;et<W.length;et++){let ut=W[wt],It=W[et],Mt=ut.start+ut.count,ct=fe(It.start,_.width,4),Vt=fe(ut.start,_.width,4);It.start<=Mt+1&&ct===Vt&&fe(It.start+It.count-1,_.width,4)===ct?ut.count=Math.max(ut.count,It.start+It.count-ut.start):(++wt,W[wt]=It)}W.length=wt+1;let st=n.getParameter(n.UNPACK_ROW_LENGTH),xt=n.getParameter(n.UNPACK_SKIP_PIXELS),bt=n.getParameter(n.UNPACK_SKIP_ROWS);n.pixelStorei(n.UNPACK_ROW_LENGTH,_.width);for(let et=0,ut=W.length;et<ut;et++){let It=W[et],Mt=Math.floor(It.start/4),ct=Math.ceil(It.count/4),Vt=Mt%_.width,L=Math.floor(Mt/_.width),it=ct,rt=1;n.pixelStorei(n.UNPACK_SKIP_PIXELS,Vt),n.pixelStorei(n.UNPACK_SKIP_ROWS,L),e.texSubImage2D(n.TEXTURE_2D,0,Vt,L,it,rt,O,q,_.data)}E.clearUpdateRanges(),n.pixelStorei(n.UNPACK_ROW_LENGTH,st),n.pixelStorei(n.UNPACK_SKIP_PIXELS,xt),n.pixelStorei(n.UNPACK_SKIP_ROWS,bt)}}function $(E,_,O){let q=n.TEXTURE_2D;(_.isDataArrayTexture||_.isCompressedArrayTexture)&&(q=n.TEXTURE_2D_ARRAY),_.isData3DTexture&&(q=n.TEXTURE_3D);let j=le(E,_),W=_.source;e.bindTexture(q,E.__webglTexture,n.TEXTURE0+O);let wt=i.get(W);if(W.version!==wt.__version||j===!0){e.activeTexture(n.TEXTURE0+O);let st=Jt.getPrimaries(Jt.workingColorSpace),xt=_.colorSpace===en?null:Jt.getPrimaries(_.colorSpace),bt=_.colorSpace===en||st===xt?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,_.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,_.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,bt);let et=w(_.image,!1,s.maxTextureSize);et=Pe(_,et);let ut=r.convert(_.format,_.colorSpace),It=r.convert(_.type),Mt=T(_.internalFormat,ut,It,_.colorSpace,_.isVideoTexture);Yt(q,_);let ct,Vt=_.mipmaps,L=_.isVideoTexture!==!0,it=wt.__version===void 0||j===!0,rt=W.dataReady,pt=I(_,et);if(_.isDepthTexture)Mt=S(_.format===ws,_.type),it&&(L?e.texStorage2D(n.TEXTURE_2D,1,Mt,et.width,et.height):e.texImage2D(n.TEXTURE_2D,0,Mt,et.width,et.height,0,ut,It,null));else if(_.isDataTexture)if(Vt.length>0){L&&it&&e.texStorage2D(n.TEXTURE_2D,pt,Mt,Vt[0].width,Vt[0].height);for(let Q=0,Z=Vt.length;Q<Z;Q++)ct=Vt[Q],L?rt&&e.texSubImage2D(n.TEXTURE_2D,Q,0,0,ct.width,ct.height,ut,It,ct.data):e.texImage2D(n.TEXTURE_2D,Q,Mt,ct.width,ct.height,0,ut,It,ct.data);_.generateMipmaps=!1}else L?(it&&e.texStorage2D(n.TEXTURE_2D,pt,Mt,et.width,et.height),rt&&te(_,et,ut,It)):e.texImage2D(n.TEXTURE_2D,0,Mt,et.width,et.height,0,ut,It,et.data);else if(_.isCompressedTexture)if(_.isCompressedArrayTexture){L&&it&&e.texStorage3D(n.TEXTURE_2D_ARRAY,pt,Mt,Vt[0].width,Vt[0].height,et.depth);for(let Q=0,Z=Vt.length;Q<Z;Q++)if(ct=Vt[Q],_.format!==pi)if(ut!==null)if(L){if(rt)if(_.layerUpdates.size>0){let _t=Xc(ct.width,ct.height,_.format,_.type);for(let Ft of _.layerUpdates){let ce=ct.data.subarray(Ft*_t/ct.data.BYTES_PER_ELEMENT,(Ft+1)*_t/ct.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,Q,0,0,Ft,ct.width,ct.height,1,ut,ce)}_.clearLayerUpdates()}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,Q,0,0,0,ct.width,ct.height,et.depth,ut,ct.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,Q,Mt,ct.width,ct.height,et.depth,0,ct.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else L?rt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,Q,0,0,0,ct.width,ct.height,et.depth,ut,It,ct.data):e.texImage3D(n.TEXTURE_2D_ARRAY,Q,Mt,ct.width,ct.height,et.depth,0,ut,It,ct.data)}else{L&&it&&e.texStorage2D(n.TEXTURE_2D,pt,Mt,Vt[0].width,Vt[0].height);for(let Q=0,Z=Vt.length;Q<Z;Q++)ct=Vt[Q],_.format!==pi?ut!==null?L?rt&&e.compressedTexSubImage2D(n.TEXTURE_2D,Q,0,0,ct.width,ct.height,ut,ct.data):e.compressedTexImage2D(n.TEXTURE_2D,Q,Mt,ct.width,ct.height,0,ct.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):L?rt&&e.texSubImage2D(n.TEXTURE_2D,Q,0,0,ct.width,ct.height,ut,It,ct.data):e.texImage2D(n.TEXTURE_2D,Q,Mt,ct.width,ct.height,0,ut,It,ct.data)}else if(_.isDataArrayTexture)if(L){if(it&&e.texStorage3D(n.TEXTURE_2D_ARRAY,pt,Mt,et.width,et.height,et.depth),rt)if(_.layerUpdates.size>0){let Q=Xc(et.width,et.height,_.format,_.type);for(let Z of _.layerUpdates){let _t=et.data.subarray(Z*Q/et.data.BYTES_PER_ELEMENT,(Z+1)*Q/et.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Z,et.width,et.height,1,ut,It,_t)}_.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,et.width,et.height,et.depth,ut,It,et.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,Mt,et.width,et.height,et.depth,0,ut,It,et.data);else if(_.isData3DTexture)L?(it&&e.texStorage3D(n.TEXTURE_3D,pt,Mt,et.width,et.height,et.depth),rt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,et.width,et.height,et.depth,ut,It,et.data)):e.texImage3D(n.TEXTURE_3D,0,Mt,et.width,et.height,et.depth,0,ut,It,et.data);else if(_.isFramebufferTexture){if(it)if(L)e.texStorage2D(n.TEXTURE_2D,pt,Mt,et.width,et.height);else{let Q=et.width,Z=et.height;for(let _t=0;_t<pt;_t++)e.texImage2D(n.TEXTURE_2D,_t,Mt,Q,Z,0,ut,It,null),Q>>=1,Z>>=1}}else if(Vt.length>0){if(L&&it){let Q=Me(Vt[0]);e.texStorage2D(n.TEXTURE_2D,pt,Mt,Q.width,Q.height)}for(let Q=0,Z=Vt.length;Q<Z;Q++)ct=Vt[Q],L?rt&&e.texSubImage2D(n.TEXTURE_2D,Q,0,0,ut,It,ct):e.texImage2D(n.TEXTURE_2D,Q,Mt,ut,It,ct);_.generateMipmaps=!1}else if(L){if(it){let Q=Me(et);e.texStorage2D(n.TEXTURE_2D,pt,Mt,Q.width,Q.height)}rt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,ut,It,et)}else e.texImage2D(n.TEXTURE_2D,0,Mt,ut,It,et);g(_)&&f(q),wt.__version=W.version,_.onUpdate&&_.onUpdate(_)}E.__version=_.version}function J(E,_,O){if(_.image.length!==6)return;let q=le(E,_),j=_.source;e.bindTexture(n.TEXTURE_CUBE_MAP,E.__webglTexture,n.TEXTURE0+O);let W=i.get(j);if(j.version!==W.__version||q===!0){e.activeTexture(n.TEXTURE0+O);let wt=Jt.getPrimaries(Jt.workingColorSpace),st=_.colorSpace===en?null:Jt.getPrimaries(_.colorSpace),xt=_.colorSpace===en||wt===st?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,_.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,_.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,xt);let bt=_.isCompressedTexture||_.image[0].isCompressedTexture,et=_.image[0]&&_.image[0].isDataTexture,ut=[];for(let Z=0;Z<6;Z++)!bt&&!et?ut[Z]=w(_.image[Z],!0,s.maxCubemapSize):ut[Z]=et?_.image[Z].image:_.image[Z],ut[Z]=Pe(_,ut[Z]);let It=ut[0],Mt=r.convert(_.format,_.colorSpace),ct=r.convert(_.type),Vt=T(_.internalFormat,Mt,ct,_.colorSpace),L=_.isVideoTexture!==!0,it=W.__version===void 0||q===!0,rt=j.dataReady,pt=I(_,It);Yt(n.TEXTURE_CUBE_MAP,_);let Q;if(bt){L&&it&&e.texStorage2D(n.TEXTURE_CUBE_MAP,pt,Vt,It.width,It.height);for(let Z=0;Z<6;Z++){Q=ut[Z].mipmaps;for(let _t=0;_t<Q.length;_t++){let Ft=Q[_t];_.format!==pi?Mt!==null?L?rt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t,0,0,Ft.width,Ft.height,Mt,Ft.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t,Vt,Ft.width,Ft.height,0,Ft.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):L?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t,0,0,Ft.width,Ft.height,Mt,ct,Ft.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t,Vt,Ft.width,Ft.height,0,Mt,ct,Ft.data)}}}else{if(Q=_.mipmaps,L&&it){Q.length>0&&pt++;let Z=Me(ut[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,pt,Vt,Z.width,Z.height)}for(let Z=0;Z<6;Z++)if(et){L?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0,0,0,ut[Z].width,ut[Z].height,Mt,ct,ut[Z].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0,Vt,ut[Z].width,ut[Z].height,0,Mt,ct,ut[Z].data);for(let _t=0;_t<Q.length;_t++){let ce=Q[_t].image[Z].image;L?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t+1,0,0,ce.width,ce.height,Mt,ct,ce.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t+1,Vt,ce.width,ce.height,0,Mt,ct,ce.data)}}else{L?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0,0,0,Mt,ct,ut[Z]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0,Vt,Mt,ct,ut[Z]);for(let _t=0;_t<Q.length;_t++){let Ft=Q[_t];L?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t+1,0,0,Mt,ct,Ft.image[Z]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t+1,Vt,Mt,ct,Ft.image[Z])}}}g(_)&&f(n.TEXTURE_CUBE_MAP),W.__version=j.version,_.onUpdate&&_.onUpdate(_)}E.__version=_.version}function mt(E,_,O,q,j,W){let wt=r.convert(O.format,O.colorSpace),st=r.convert(O.type),xt=T(O.internalFormat,wt,st,O.colorSpace),bt=i.get(_),et=i.get(O);if(et.__renderTarget=_,!bt.__hasExternalTextures){let ut=Math.max(1,_.width>>W),It=Math.max(1,_.height>>W);j===n.TEXTURE_3D||j===n.TEXTURE_2D_ARRAY?e.texImage3D(j,W,xt,ut,It,_.depth,0,wt,st,null):e.texImage2D(j,W,xt,ut,It,0,wt,st,null)}e.bindFramebuffer(n.FRAMEBUFFER,E),yt(_)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,q,j,et.__webglTexture,0,me(_)):(j===n.TEXTURE_2D||j>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,q,j,et.__webglTexture,W),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ut(E,_,O){if(n.bindRenderbuffer(n.RENDERBUFFER,E),_.depthBuffer){let q=_.depthTexture,j=q&&q.isDepthTexture?q.type:null,W=S(_.stencilBuffer,j),wt=_.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,st=me(_);yt(_)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st,W,_.width,_.height):O?n.renderbufferStorageMultisample(n.RENDERBUFFER,st,W,_.width,_.height):n.renderbufferStorage(n.RENDERBUFFER,W,_.width,_.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,wt,n.RENDERBUFFER,E)}else{let q=_.textures;for(let j=0;j<q.length;j++){let W=q[j],wt=r.convert(W.format,W.colorSpace),st=r.convert(W.type),xt=T(W.internalFormat,wt,st,W.colorSpace),bt=me(_);O&&yt(_)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,bt,xt,_.width,_.height):yt(_)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,bt,xt,_.width,_.height):n.renderbufferStorage(n.RENDERBUFFER,xt,_.width,_.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function St(E,_){if(_&&_.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(n.FRAMEBUFFER,E),!(_.depthTexture&&_.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let q=i.get(_.depthTexture);q.__renderTarget=_,(!q.__webglTexture||_.depthTexture.image.width!==_.width||_.depthTexture.image.height!==_.height)&&(_.depthTexture.image.width=_.width,_.depthTexture.image.height=_.height,_.depthTexture.needsUpdate=!0),K(_.depthTexture,0);let j=q.__webglTexture,W=me(_);if(_.depthTexture.format===fs)yt(_)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,j,0,W):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,j,0);else if(_.depthTexture.format===ws)yt(_)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,j,0,W):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,j,0);else throw new Error("Unknown depthTexture format")}function Kt(E){let _=i.get(E),O=E.isWebGLCubeRenderTarget===!0;if(_.__boundDepthTexture!==E.depthTexture){let q=E.depthTexture;if(_.__depthDisposeCallback&&_.__depthDisposeCallback(),q){let j=()=>{delete _.__boundDepthTexture,delete _.__depthDisposeCallback,q.removeEventListener("dispose",j)};q.addEventListener("dispose",j),_.__depthDisposeCallback=j}_.__boundDepthTexture=q}if(E.depthTexture&&!_.__autoAllocateDepthBuffer){if(O)throw new Error("target.depthTexture not supported in Cube render targets");let q=E.texture.mipmaps;q&&q.length>0?St(_.__webglFramebuffer[0],E):St(_.__webglFramebuffer,E)}else if(O){_.__webglDepthbuffer=[];for(let q=0;q<6;q++)if(e.bindFramebuffer(n.FRAMEBUFFER,_.__webglFramebuffer[q]),_.__webglDepthbuffer[q]===void 0)_.__webglDepthbuffer[q]=n.createRenderbuffer(),Ut(_.__webglDepthbuffer[q],E,!1);else{let j=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,W=_.__webglDepthbuffer[q];n.bindRenderbuffer(n.RENDERBUFFER,W),n.framebufferRenderbuffer(n.FRAMEBUFFER,j,n.RENDERBUFFER,W)}}else{let q=E.texture.mipmaps;if(q&&q.length>0?e.bindFramebuffer(n.FRAMEBUFFER,_.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,_.__webglFramebuffer),_.__webglDepthbuffer===void 0)_.__webglDepthbuffer=n.createRenderbuffer(),Ut(_.__webglDepthbuffer,E,!1);else{let j=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,W=_.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,W),n.framebufferRenderbuffer(n.FRAMEBUFFER,j,n.RENDERBUFFER,W)}}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ne(E,_,O){let q=i.get(E);_!==void 0&&mt(q.__webglFramebuffer,E,E.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),O!==void 0&&Kt(E)}function A(E){let _=E.texture,O=i.get(E),q=i.get(_);E.addEventListener("dispose",D);let j=E.textures,W=E.isWebGLCubeRenderTarget===!0,wt=j.length>1;if(wt||(q.__webglTexture===void 0&&(q.__webglTexture=n.createTexture()),q.__version=_.version,o.memory.textures++),W){O.__webglFramebuffer=[];for(let st=0;st<6;st++)if(_.mipmaps&&_.mipmaps.length>0){O.__webglFramebuffer[st]=[];for(let xt=0;xt<_.mipmaps.length;xt++)O.__webglFramebuffer[st][xt]=n.createFramebuffer()}else O.__webglFramebuffer[st]=n.createFramebuffer()}else{if(_.mipmaps&&_.mipmaps.length>0){O.__webglFramebuffer=[];for(let st=0;st<_.mipmaps.length;st++)O.__webglFramebuffer[st]=n.createFramebuffer()}else O.__webglFramebuffer=n.createFramebuffer();if(wt)for(let st=0,xt=j.length;st<xt;st++){let bt=i.get(j[st]);bt.__webglTexture===void 0&&(bt.__webglTexture=n.createTexture(),o.memory.textures++)}if(E.samples>0&&yt(E)===!1){O.__webglMultisampledFramebuffer=n.createFramebuffer(),O.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let st=0;st<j.length;st++){let xt=j[st];O.__webglColorRenderbuffer[st]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,O.__webglColorRenderbuffer[st]);let bt=r.convert(xt.format,xt.colorSpace),et=r.convert(xt.type),ut=T(xt.internalFormat,bt,et,xt.colorSpace,E.isXRRenderTarget===!0),It=me(E);n.renderbufferStorageMultisample(n.RENDERBUFFER,It,ut,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+st,n.RENDERBUFFER,O.__webglColorRenderbuffer[st])}n.bindRenderbuffer(n.RENDERBUFFER,null),E.depthBuffer&&(O.__webglDepthRenderbuffer=n.createRenderbuffer(),Ut(O.__webglDepthRenderbuffer,E,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(W){e.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture),Yt(n.TEXTURE_CUBE_MAP,_);for(let st=0;st<6;st++)if(_.mipmaps&&_.mipmaps.length>0)for(let xt=0;xt<_.mipmaps.length;xt++)mt(O.__webglFramebuffer[st][xt],E,_,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+st,xt);else mt(O.__webglFramebuffer[st],E,_,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+st,0);g(_)&&f(n.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(wt){for(let st=0,xt=j.length;st<xt;st++){let bt=j[st],et=i.get(bt),ut=n.TEXTURE_2D;(E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(ut=E.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ut,et.__webglTexture),Yt(ut,bt),mt(O.__webglFramebuffer,E,bt,n.COLOR_ATTACHMENT0+st,ut,0),g(bt)&&f(ut)}e.unbindTexture()}else{let st=n.TEXTURE_2D;if((E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(st=E.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(st,q.__webglTexture),Yt(st,_),_.mipmaps&&_.mipmaps.length>0)for(let xt=0;xt<_.mipmaps.length;xt++)mt(O.__webglFramebuffer[xt],E,_,n.COLOR_ATTACHMENT0,st,xt);else mt(O.__webglFramebuffer,E,_,n.COLOR_ATTACHMENT0,st,0);g(_)&&f(st),e.unbindTexture()}E.depthBuffer&&Kt(E)}function pe(E){let _=E.textures;for(let O=0,q=_.length;O<q;O++){let j=_[O];if(g(j)){let W=R(E),wt=i.get(j).__webglTexture;e.bindTexture(W,wt),f(W),e.unbindTexture()}}}let kt=[],Lt=[];function vt(E){if(E.samples>0){if(yt(E)===!1){let _=E.textures,O=E.width,q=E.height,j=n.COLOR_BUFFER_BIT,W=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=i.get(E),st=_.length>1;if(st)for(let bt=0;bt<_.length;bt++)e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,wt.__webglMultisampledFramebuffer);let xt=E.texture.mipmaps;xt&&xt.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer);for(let bt=0;bt<_.length;bt++){if(E.resolveDepthBuffer&&(E.depthBuffer&&(j|=n.DEPTH_BUFFER_BIT),E.stencilBuffer&&E.resolveStencilBuffer&&(j|=n.STENCIL_BUFFER_BIT)),st){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,wt.__webglColorRenderbuffer[bt]);let et=i.get(_[bt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,et,0)}n.blitFramebuffer(0,0,O,q,0,0,O,q,j,n.NEAREST),l===!0&&(kt.length=0,Lt.length=0,kt.push(n.COLOR_ATTACHMENT0+bt),E.depthBuffer&&E.resolveDepthBuffer===!1&&(kt.push(W),Lt.push(W),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,Lt)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,kt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),st)for(let bt=0;bt<_.length;bt++){e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.RENDERBUFFER,wt.__webglColorRenderbuffer[bt]);let et=i.get(_[bt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.TEXTURE_2D,et,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglMultisampledFramebuffer)}else if(E.depthBuffer&&E.resolveDepthBuffer===!1&&l){let _=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[_])}}}function me(E){return Math.min(s.maxSamples,E.samples)}function yt(E){let _=i.get(E);return E.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&_.__useRenderToTexture!==!1}function Gt(E){let _=o.render.frame;h.get(E)!==_&&(h.set(E,_),E.update())}function Pe(E,_){let O=E.colorSpace,q=E.format,j=E.type;return E.isCompressedTexture===!0||E.isVideoTexture===!0||O!==Nn&&O!==en&&(Jt.getTransfer(O)===ne?(q!==pi||j!==Bi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",O)),_}function Me(E){return typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement?(c.width=E.naturalWidth||E.width,c.height=E.naturalHeight||E.height):typeof VideoFrame<"u"&&E instanceof VideoFrame?(c.width=E.displayWidth,c.height=E.displayHeight):(c.width=E.width,c.height=E.height),c}this.allocateTextureUnit=V,this.resetTextureUnits=B,this.setTexture2D=K,this.setTexture2DArray=Y,this.setTexture3D=nt,this.setTextureCube=G,this.rebindTextures=Ne,this.setupRenderTarget=A,this.updateRenderTargetMipmap=pe,this.updateMultisampleRenderTarget=vt,this.setupDepthRenderbuffer=Kt,this.setupFrameBufferTexture=mt,this.useMultisampledRTT=yt}function n0(n,t){function e(i,s=en){let r,o=Jt.getTransfer(s);if(i===Bi)return n.UNSIGNED_BYTE;if(i===Sa)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Ea)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Ic)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Lc)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Cc)return n.BYTE;if(i===Pc)return n.SHORT;if(i===xs)return n.UNSIGNED_SHORT;if(i===wa)return n.INT;if(i===yn)return n.UNSIGNED_INT;if(i===Ti)return n.FLOAT;if(i===bs)return n.HALF_FLOAT;if(i===Dc)return n.ALPHA;if(i===Uc)return n.RGB;if(i===pi)return n.RGBA;if(i===fs)return n.DEPTH_COMPONENT;if(i===ws)return n.DEPTH_STENCIL;if(i===Ta)return n.RED;if(i===Aa)return n.RED_INTEGER;if(i===Nc)return n.RG;if(i===Ra)return n.RG_INTEGER;if(i===Ca)return n.RGBA_INTEGER;if(i===Er||i===Tr||i===Ar||i===Rr)if(o===ne)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Er)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Tr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ar)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Rr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Er)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Tr)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ar)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Rr)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Pa||i===Ia||i===La||i===Da)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Pa)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Ia)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===La)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Da)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Ua||i===Na||i===Fa)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Ua||i===Na)return o===ne?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Fa)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===Oa||i===ka||i===Ba||i===za||i===Ha||i===Va||i===Ga||i===Wa||i===Xa||i===qa||i===Ya||i===$a||i===Za||i===Ka)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Oa)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===ka)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Ba)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===za)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ha)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Va)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ga)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Wa)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Xa)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===qa)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ya)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===$a)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Za)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Ka)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===ja||i===Ja||i===Qa)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===ja)return o===ne?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Ja)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Qa)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===tl||i===el||i===il||i===nl)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===tl)return r.COMPRESSED_RED_RGTC1_EXT;if(i===el)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===il)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===nl)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Ms?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var s0=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,r0=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,sh=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new gr(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Si({vertexShader:s0,fragmentShader:r0,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new We(new _r(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},rh=class extends Ii{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,m=null,v=null,w=typeof XRWebGLBinding<"u",g=new sh,f={},R=e.getContextAttributes(),T=null,S=null,I=[],P=[],D=new zt,k=null,y=new Ve;y.viewport=new xe;let b=new Ve;b.viewport=new xe;let C=[y,b],B=new ua,V=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function($){let J=I[$];return J===void 0&&(J=new vs,I[$]=J),J.getTargetRaySpace()},this.getControllerGrip=function($){let J=I[$];return J===void 0&&(J=new vs,I[$]=J),J.getGripSpace()},this.getHand=function($){let J=I[$];return J===void 0&&(J=new vs,I[$]=J),J.getHandSpace()};function K($){let J=P.indexOf($.inputSource);if(J===-1)return;let mt=I[J];mt!==void 0&&(mt.update($.inputSource,$.frame,c||o),mt.dispatchEvent({type:$.type,data:$.inputSource}))}function Y(){s.removeEventListener("select",K),s.removeEventListener("selectstart",K),s.removeEventListener("selectend",K),s.removeEventListener("squeeze",K),s.removeEventListener("squeezestart",K),s.removeEventListener("squeezeend",K),s.removeEventListener("end",Y),s.removeEventListener("inputsourceschange",nt);for(let $=0;$<I.length;$++){let J=P[$];J!==null&&(P[$]=null,I[$].disconnect(J))}V=null,X=null,g.reset();for(let $ in f)delete f[$];t.setRenderTarget(T),m=null,d=null,u=null,s=null,S=null,te.stop(),i.isPresenting=!1,t.setPixelRatio(k),t.setSize(D.width,D.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function($){r=$,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function($){a=$,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function($){c=$},this.getBaseLayer=function(){return d!==null?d:m},this.getBinding=function(){return u===null&&w&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return v},this.getSession=function(){return s},this.setSession=async function($){if(s=$,s!==null){if(T=t.getRenderTarget(),s.addEventListener("select",K),s.addEventListener("selectstart",K),s.addEventListener("selectend",K),s.addEventListener("squeeze",K),s.addEventListener("squeezestart",K),s.addEventListener("squeezeend",K),s.addEventListener("end",Y),s.addEventListener("inputsourceschange",nt),R.xrCompatible!==!0&&await e.makeXRCompatible(),k=t.getPixelRatio(),t.getSize(D),w&&"createProjectionLayer"in XRWebGLBinding.prototype){let mt=null,Ut=null,St=null;R.depth&&(St=R.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,mt=R.stencil?ws:fs,Ut=R.stencil?Ms:yn);let Kt={colorFormat:e.RGBA8,depthFormat:St,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Kt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),S=new Li(d.textureWidth,d.textureHeight,{format:pi,type:Bi,depthTexture:new mr(d.textureWidth,d.textureHeight,Ut,void 0,void 0,void 0,void 0,void 0,void 0,mt),stencilBuffer:R.stencil,colorSpace:t.outputColorSpace,samples:R.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}else{let mt={antialias:R.antialias,alpha:!0,depth:R.depth,stencil:R.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,e,mt),s.updateRenderState({baseLayer:m}),t.setPixelRatio(1),t.setSize(m.framebufferWidth,m.framebufferHeight,!1),S=new Li(m.framebufferWidth,m.framebufferHeight,{format:pi,type:Bi,colorSpace:t.outputColorSpace,stencilBuffer:R.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),te.setContext(s),te.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function nt($){for(let J=0;J<$.removed.length;J++){let mt=$.removed[J],Ut=P.indexOf(mt);Ut>=0&&(P[Ut]=null,I[Ut].disconnect(mt))}for(let J=0;J<$.added.length;J++){let mt=$.added[J],Ut=P.indexOf(mt);if(Ut===-1){for(let Kt=0;Kt<I.length;Kt++)if(Kt>=P.length){P.push(mt),Ut=Kt;break}else if(P[Kt]===null){P[Kt]=mt,Ut=Kt;break}if(Ut===-1)break}let St=I[Ut];St&&St.connect(mt)}}let G=new F,lt=new F;function dt($,J,mt){G.setFromMatrixPosition(J.matrixWorld),lt.setFromMatrixPosition(mt.matrixWorld);let Ut=G.distanceTo(lt),St=J.projectionMatrix.elements,Kt=mt.projectionMatrix.elements,Ne=St[14]/(St[10]-1),A=St[14]/(St[10]+1),pe=(St[9]+1)/St[5],kt=(St[9]-1)/St[5],Lt=(St[8]-1)/St[0],vt=(Kt[8]+1)/Kt[0],me=Ne*Lt,yt=Ne*vt,Gt=Ut/(-Lt+vt),Pe=Gt*-Lt;if(J.matrixWorld.decompose($.position,$.quaternion,$.scale),$.translateX(Pe),$.translateZ(Gt),$.matrixWorld.compose($.position,$.quaternion,$.scale),$.matrixWorldInverse.copy($.matrixWorld).invert(),St[10]===-1)$.projectionMatrix.copy(J.projectionMatrix),$.projectionMatrixInverse.copy(J.projectionMatrixInverse);else{let Me=Ne+Gt,E=A+Gt,_=me-Pe,O=yt+(Ut-Pe),q=pe*A/E*Me,j=kt*A/E*Me;$.projectionMatrix.makePerspective(_,O,q,j,Me,E),$.projectionMatrixInverse.copy($.projectionMatrix).invert()}}function Tt($,J){J===null?$.matrixWorld.copy($.matrix):$.matrixWorld.multiplyMatrices(J.matrixWorld,$.matrix),$.matrixWorldInverse.copy($.matrixWorld).invert()}this.updateCamera=function($){if(s===null)return;let J=$.near,mt=$.far;g.texture!==null&&(g.depthNear>0&&(J=g.depthNear),g.depthFar>0&&(mt=g.depthFar)),B.near=b.near=y.near=J,B.far=b.far=y.far=mt,(V!==B.near||X!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),V=B.near,X=B.far),B.layers.mask=$.layers.mask|6,y.layers.mask=B.layers.mask&3,b.layers.mask=B.layers.mask&5;let Ut=$.parent,St=B.cameras;Tt(B,Ut);for(let Kt=0;Kt<St.length;Kt++)Tt(St[Kt],Ut);St.length===2?dt(B,y,b):B.projectionMatrix.copy(y.projectionMatrix),Yt($,B,Ut)};function Yt($,J,mt){mt===null?$.matrix.copy(J.matrixWorld):($.matrix.copy(mt.matrixWorld),$.matrix.invert(),$.matrix.multiply(J.matrixWorld)),$.matrix.decompose($.position,$.quaternion,$.scale),$.updateMatrixWorld(!0),$.projectionMatrix.copy(J.projectionMatrix),$.projectionMatrixInverse.copy(J.projectionMatrixInverse),$.isPerspectiveCamera&&($.fov=ps*2*Math.atan(1/$.projectionMatrix.elements[5]),$.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(d===null&&m===null))return l},this.setFoveation=function($){l=$,d!==null&&(d.fixedFoveation=$),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=$)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(B)},this.getCameraTexture=function($){return f[$]};let le=null;function fe($,J){if(h=J.getViewerPose(c||o),v=J,h!==null){let mt=h.views;m!==null&&(t.setRenderTargetFramebuffer(S,m.framebuffer),t.setRenderTarget(S));let Ut=!1;mt.length!==B.cameras.length&&(B.cameras.length=0,Ut=!0);for(let A=0;A<mt.length;A++){let pe=mt[A],kt=null;if(m!==null)kt=m.getViewport(pe);else{let vt=u.getViewSubImage(d,pe);kt=vt.viewport,A===0&&(t.setRenderTargetTextures(S,vt.colorTexture,vt.depthStencilTexture),t.setRenderTarget(S))}let Lt=C[A];Lt===void 0&&(Lt=new Ve,Lt.layers.enable(A),Lt.viewport=new xe,C[A]=Lt),Lt.matrix.fromArray(pe.transform.matrix),Lt.matrix.decompose(Lt.position,Lt.quaternion,Lt.scale),Lt.projectionMatrix.fromArray(pe.projectionMatrix),Lt.projectionMatrixInverse.copy(Lt.projectionMatrix).invert(),Lt.viewport.set(kt.x,kt.y,kt.width,kt.height),A===0&&(B.matrix.copy(Lt.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),Ut===!0&&B.cameras.push(Lt)}let St=s.enabledFeatures;if(St&&St.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&w){u=i.getBinding();let A=u.getDepthInformation(mt[0]);A&&A.isValid&&A.texture&&g.init(A,s.renderState)}if(St&&St.includes("camera-access")&&w){t.state.unbindTexture(),u=i.getBinding();for(let A=0;A<mt.length;A++){let pe=mt[A].camera;if(pe){let kt=f[pe];kt||(kt=new gr,f[pe]=kt);let Lt=u.getCameraImage(pe);kt.sourceTexture=Lt}}}}for(let mt=0;mt<I.length;mt++){let Ut=P[mt],St=I[mt];Ut!==null&&St!==void 0&&St.update(Ut,J,c||o)}le&&le($,J),J.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:J}),v=null}let te=new Hd;te.setAnimationLoop(fe),this.setAnimationLoop=function($){le=$},this.dispose=function(){}}},Gn=new wi,o0=new ae;function a0(n,t){function e(g,f){g.matrixAutoUpdate===!0&&g.updateMatrix(),f.value.copy(g.matrix)}function i(g,f){f.color.getRGB(g.fogColor.value,Vc(n)),f.isFog?(g.fogNear.value=f.near,g.fogFar.value=f.far):f.isFogExp2&&(g.fogDensity.value=f.density)}function s(g,f,R,T,S){f.isMeshBasicMaterial||f.isMeshLambertMaterial?r(g,f):f.isMeshToonMaterial?(r(g,f),u(g,f)):f.isMeshPhongMaterial?(r(g,f),h(g,f)):f.isMeshStandardMaterial?(r(g,f),d(g,f),f.isMeshPhysicalMaterial&&m(g,f,S)):f.isMeshMatcapMaterial?(r(g,f),v(g,f)):f.isMeshDepthMaterial?r(g,f):f.isMeshDistanceMaterial?(r(g,f),w(g,f)):f.isMeshNormalMaterial?r(g,f):f.isLineBasicMaterial?(o(g,f),f.isLineDashedMaterial&&a(g,f)):f.isPointsMaterial?l(g,f,R,T):f.isSpriteMaterial?c(g,f):f.isShadowMaterial?(g.color.value.copy(f.color),g.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function r(g,f){g.opacity.value=f.opacity,f.color&&g.diffuse.value.copy(f.color),f.emissive&&g.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(g.map.value=f.map,e(f.map,g.mapTransform)),f.alphaMap&&(g.alphaMap.value=f.alphaMap,e(f.alphaMap,g.alphaMapTransform)),f.bumpMap&&(g.bumpMap.value=f.bumpMap,e(f.bumpMap,g.bumpMapTransform),g.bumpScale.value=f.bumpScale,f.side===je&&(g.bumpScale.value*=-1)),f.normalMap&&(g.normalMap.value=f.normalMap,e(f.normalMap,g.normalMapTransform),g.normalScale.value.copy(f.normalScale),f.side===je&&g.normalScale.value.negate()),f.displacementMap&&(g.displacementMap.value=f.displacementMap,e(f.displacementMap,g.displacementMapTransform),g.displacementScale.value=f.displacementScale,g.displacementBias.value=f.displacementBias),f.emissiveMap&&(g.emissiveMap.value=f.emissiveMap,e(f.emissiveMap,g.emissiveMapTransform)),f.specularMap&&(g.specularMap.value=f.specularMap,e(f.specularMap,g.specularMapTransform)),f.alphaTest>0&&(g.alphaTest.value=f.alphaTest);let R=t.get(f),T=R.envMap,S=R.envMapRotation;T&&(g.envMap.value=T,Gn.copy(S),Gn.x*=-1,Gn.y*=-1,Gn.z*=-1,T.isCubeTexture&&T.isRenderTargetTexture===!1&&(Gn.y*=-1,Gn.z*=-1),g.envMapRotation.value.setFromMatrix4(o0.makeRotationFromEuler(Gn)),g.flipEnvMap.value=T.isCubeTexture&&T.isRenderTargetTexture===!1?-1:1,g.reflectivity.value=f.reflectivity,g.ior.value=f.ior,g.refractionRatio.value=f.refractionRatio),f.lightMap&&(g.lightMap.value=f.lightMap,g.lightMapIntensity.value=f.lightMapIntensity,e(f.lightMap,g.lightMapTransform)),f.aoMap&&(g.aoMap.value=f.aoMap,g.aoMapIntensity.value=f.aoMapIntensity,e(f.aoMap,g.aoMapTransform))}function o(g,f){g.diffuse.value.copy(f.color),g.opacity.value=f.opacity,f.map&&(g.map.value=f.map,e(f.map,g.mapTransform))}function a(g,f){g.dashSize.value=f.dashSize,g.totalSize.value=f.dashSize+f.gapSize,g.scale.value=f.scale}function l(g,f,R,T){g.diffuse.value.copy(f.color),g.opacity.value=f.opacity,g.size.value=f.size*R,g.scale.value=T*.5,f.map&&(g.map.value=f.map,e(f.map,g.uvTransform)),f.alphaMap&&(g.alphaMap.value=f.alphaMap,e(f.alphaMap,g.alphaMapTransform)),f.alphaTest>0&&(g.alphaTest.value=f.alphaTest)}function c(g,f){g.diffuse.value.copy(f.color),g.opacity.value=f.opacity,g.rotation.value=f.rotation,f.map&&(g.map.value=f.map,e(f.map,g.mapTransform)),f.alphaMap&&(g.alphaMap.value=f.alphaMap,e(f.alphaMap,g.alphaMapTransform)),f.alphaTest>0&&(g.alphaTest.value=f.alphaTest)}function h(g,f){g.specular.value.copy(f.specular),g.shininess.value=Math.max(f.shininess,1e-4)}function u(g,f){f.gradientMap&&(g.gradientMap.value=f.gradientMap)}function d(g,f){g.metalness.value=f.metalness,f.metalnessMap&&(g.metalnessMap.value=f.metalnessMap,e(f.metalnessMap,g.metalnessMapTransform)),g.roughness.value=f.roughness,f.roughnessMap&&(g.roughnessMap.value=f.roughnessMap,e(f.roughnessMap,g.roughnessMapTransform)),f.envMap&&(g.envMapIntensity.value=f.envMapIntensity)}function m(g,f,R){g.ior.value=f.ior,f.sheen>0&&(g.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),g.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(g.sheenColorMap.value=f.sheenColorMap,e(f.sheenColorMap,g.sheenColorMapTransform)),f.sheenRoughnessMap&&(g.sheenRoughnessMap.value=f.sheenRoughnessMap,e(f.sheenRoughnessMap,g.sheenRoughnessMapTransform))),f.clearcoat>0&&(g.clearcoat.value=f.clearcoat,g.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(g.clearcoatMap.value=f.clearcoatMap,e(f.clearcoatMap,g.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,e(f.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(g.clearcoatNormalMap.value=f.clearcoatNormalMap,e(f.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===je&&g.clearcoatNormalScale.value.negate())),f.dispersion>0&&(g.dispersion.value=f.dispersion),f.iridescence>0&&(g.iridescence.value=f.iridescence,g.iridescenceIOR.value=f.iridescenceIOR,g.iridescenceThicknessMinimum.value=f.iridescenceThicknessRange[0],g.iridescenceThicknessMaximum.value=f.iridescenceThicknessRange[1],f.iridescenceMap&&(g.iridescenceMap.value=f.iridescenceMap,e(f.iridescenceMap,g.iridescenceMapTransform)),f.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=f.iridescenceThicknessMap,e(f.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),f.transmission>0&&(g.transmission.value=f.transmission,g.transmissionSamplerMap.value=R.texture,g.transmissionSamplerSize.value.set(R.width,R.height),f.transmissionMap&&(g.transmissionMap.value=f.transmissionMap,e(f.transmissionMap,g.transmissionMapTransform)),g.thickness.value=f.thickness,f.thicknessMap&&(g.thicknessMap.value=f.thicknessMap,e(f.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=f.attenuationDistance,g.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(g.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(g.anisotropyMap.value=f.anisotropyMap,e(f.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=f.specularIntensity,g.specularColor.value.copy(f.specularColor),f.specularColorMap&&(g.specularColorMap.value=f.specularColorMap,e(f.specularColorMap,g.specularColorMapTransform)),f.specularIntensityMap&&(g.specularIntensityMap.value=f.specularIntensityMap,e(f.specularIntensityMap,g.specularIntensityMapTransform))}function v(g,f){f.matcap&&(g.matcap.value=f.matcap)}function w(g,f){let R=t.get(f).light;g.referencePosition.value.setFromMatrixPosition(R.matrixWorld),g.nearDistance.value=R.shadow.camera.near,g.farDistance.value=R.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function l0(n,t,e,i){let s={},r={},o=[],a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(R,T){let S=T.program;i.uniformBlockBinding(R,S)}function c(R,T){let S=s[R.id];S===void 0&&(v(R),S=h(R),s[R.id]=S,R.addEventListener("dispose",g));let I=T.program;i.updateUBOMapping(R,I);let P=t.render.frame;r[R.id]!==P&&(d(R),r[R.id]=P)}function h(R){let T=u();R.__bindingPointIndex=T;let S=n.createBuffer(),I=R.__size,P=R.usage;return n.bindBuffer(n.UNIFORM_BUFFER,S),n.bufferData(n.UNIFORM_BUFFER,I,P),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,T,S),S}function u(){for(let R=0;R<a;R++)if(o.indexOf(R)===-1)return o.push(R),R;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(R){let T=s[R.id],S=R.uniforms,I=R.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let P=0,D=S.length;P<D;P++){let k=Array.isArray(S[P])?S[P]:[S[P]];for(let y=0,b=k.length;y<b;y++){let C=k[y];if(m(C,P,y,I)===!0){let B=C.__offset,V=Array.isArray(C.value)?C.value:[C.value],X=0;for(let K=0;K<V.length;K++){let Y=V[K],nt=w(Y);typeof Y=="number"||typeof Y=="boolean"?(C.__data[0]=Y,n.bufferSubData(n.UNIFORM_BUFFER,B+X,C.__data)):Y.isMatrix3?(C.__data[0]=Y.elements[0],C.__data[1]=Y.elements[1],C.__data[2]=Y.elements[2],C.__data[3]=0,C.__data[4]=Y.elements[3],C.__data[5]=Y.elements[4],C.__data[6]=Y.elements[5],C.__data[7]=0,C.__data[8]=Y.elements[6],C.__data[9]=Y.elements[7],C.__data[10]=Y.elements[8],C.__data[11]=0):(Y.toArray(C.__data,X),X+=nt.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,B,C.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function m(R,T,S,I){let P=R.value,D=T+"_"+S;if(I[D]===void 0)return typeof P=="number"||typeof P=="boolean"?I[D]=P:I[D]=P.clone(),!0;{let k=I[D];if(typeof P=="number"||typeof P=="boolean"){if(k!==P)return I[D]=P,!0}else if(k.equals(P)===!1)return k.copy(P),!0}return!1}function v(R){let T=R.uniforms,S=0,I=16;for(let D=0,k=T.length;D<k;D++){let y=Array.isArray(T[D])?T[D]:[T[D]];for(let b=0,C=y.length;b<C;b++){let B=y[b],V=Array.isArray(B.value)?B.value:[B.value];for(let X=0,K=V.length;X<K;X++){let Y=V[X],nt=w(Y),G=S%I,lt=G%nt.boundary,dt=G+lt;S+=lt,dt!==0&&I-dt<nt.storage&&(S+=I-dt),B.__data=new Float32Array(nt.storage/Float32Array.BYTES_PER_ELEMENT),B.__offset=S,S+=nt.storage}}}let P=S%I;return P>0&&(S+=I-P),R.__size=S,R.__cache={},this}function w(R){let T={boundary:0,storage:0};return typeof R=="number"||typeof R=="boolean"?(T.boundary=4,T.storage=4):R.isVector2?(T.boundary=8,T.storage=8):R.isVector3||R.isColor?(T.boundary=16,T.storage=12):R.isVector4?(T.boundary=16,T.storage=16):R.isMatrix3?(T.boundary=48,T.storage=48):R.isMatrix4?(T.boundary=64,T.storage=64):R.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",R),T}function g(R){let T=R.target;T.removeEventListener("dispose",g);let S=o.indexOf(T.__bindingPointIndex);o.splice(S,1),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function f(){for(let R in s)n.deleteBuffer(s[R]);o=[],s={},r={}}return{bind:l,update:c,dispose:f}}var ll=class{constructor(t={}){let{canvas:e=fd(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1}=t;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let v=new Uint32Array(4),w=new Int32Array(4),g=null,f=null,R=[],T=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=tn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let S=this,I=!1;this._outputColorSpace=li;let P=0,D=0,k=null,y=-1,b=null,C=new xe,B=new xe,V=null,X=new Nt(0),K=0,Y=e.width,nt=e.height,G=1,lt=null,dt=null,Tt=new xe(0,0,Y,nt),Yt=new xe(0,0,Y,nt),le=!1,fe=new fr,te=!1,$=!1,J=new ae,mt=new F,Ut=new xe,St={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Kt=!1;function Ne(){return k===null?G:1}let A=i;function pe(M,U){return e.getContext(M,U)}try{let M={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"180"}`),e.addEventListener("webglcontextlost",rt,!1),e.addEventListener("webglcontextrestored",pt,!1),e.addEventListener("webglcontextcreationerror",Q,!1),A===null){let U="webgl2";if(A=pe(U,M),A===null)throw pe(U)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(M){throw console.error("THREE.WebGLRenderer: "+M.message),M}let kt,Lt,vt,me,yt,Gt,Pe,Me,E,_,O,q,j,W,wt,st,xt,bt,et,ut,It,Mt,ct,Vt;function L(){kt=new Tv(A),kt.init(),Mt=new n0(A,kt),Lt=new yv(A,kt,t,Mt),vt=new e0(A,kt),Lt.reversedDepthBuffer&&d&&vt.buffers.depth.setReversed(!0),me=new Cv(A),yt=new Vy,Gt=new i0(A,kt,vt,yt,Lt,Mt,me),Pe=new bv(S),Me=new Ev(S),E=new Nm(A),ct=new _v(A,E),_=new Av(A,E,me,ct),O=new Iv(A,_,E,me),et=new Pv(A,Lt,Gt),st=new xv(yt),q=new Hy(S,Pe,Me,kt,Lt,ct,st),j=new a0(S,yt),W=new Wy,wt=new Ky(kt),bt=new gv(S,Pe,Me,vt,O,m,l),xt=new Qy(S,O,Lt),Vt=new l0(A,me,Lt,vt),ut=new vv(A,kt,me),It=new Rv(A,kt,me),me.programs=q.programs,S.capabilities=Lt,S.extensions=kt,S.properties=yt,S.renderLists=W,S.shadowMap=xt,S.state=vt,S.info=me}L();let it=new rh(S,A);this.xr=it,this.getContext=function(){return A},this.getContextAttributes=function(){return A.getContextAttributes()},this.forceContextLoss=function(){let M=kt.get("WEBGL_lose_context");M&&M.loseContext()},this.forceContextRestore=function(){let M=kt.get("WEBGL_lose_context");M&&M.restoreContext()},this.getPixelRatio=function(){return G},this.setPixelRatio=function(M){M!==void 0&&(G=M,this.setSize(Y,nt,!1))},this.getSize=function(M){return M.set(Y,nt)},this.setSize=function(M,U,z=!0){if(it.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}Y=M,nt=U,e.width=Math.floor(M*G),e.height=Math.floor(U*G),z===!0&&(e.style.width=M+"px",e.style.height=U+"px"),this.setViewport(0,0,M,U)},this.getDrawingBufferSize=function(M){return M.set(Y*G,nt*G).floor()},this.setDrawingBufferSize=function(M,U,z){Y=M,nt=U,G=z,e.width=Math.floor(M*z),e.height=Math.floor(U*z),this.setViewport(0,0,M,U)},this.getCurrentViewport=function(M){return M.copy(C)},this.getViewport=function(M){return M.copy(Tt)},this.setViewport=function(M,U,z,H){M.isVector4?Tt.set(M.x,M.y,M.z,M.w):Tt.set(M,U,z,H),vt.viewport(C.copy(Tt).multiplyScalar(G).round())},this.getScissor=function(M){return M.copy(Yt)},this.setScissor=function(M,U,z,H){M.isVector4?Yt.set(M.x,M.y,M.z,M.w):Yt.set(M,U,z,H),vt.scissor(B.copy(Yt).multiplyScalar(G).round())},this.getScissorTest=function(){return le},this.setScissorTest=function(M){vt.setScissorTest(le=M)},this.setOpaqueSort=function(M){lt=M},this.setTransparentSort=function(M){dt=M},this.getClearColor=function(M){return M.copy(bt.getClearColor())},this.setClearColor=function(){bt.setClearColor(...arguments)},this.getClearAlpha=function(){return bt.getClearAlpha()},this.setClearAlpha=function(){bt.setClearAlpha(...arguments)},this.clear=function(M=!0,U=!0,z=!0){let H=0;if(M){let N=!1;if(k!==null){let tt=k.texture.format;N=tt===Ca||tt===Ra||tt===Aa}if(N){let tt=k.texture.type,ht=tt===Bi||tt===yn||tt===xs||tt===Ms||tt===Sa||tt===Ea,gt=bt.getClearColor(),ft=bt.getClearAlpha(),Pt=gt.r,Dt=gt.g,At=gt.b;ht?(v[0]=Pt,v[1]=Dt,v[2]=At,v[3]=ft,A.clearBufferuiv(A.COLOR,0,v)):(w[0]=Pt,w[1]=Dt,w[2]=At,w[3]=ft,A.clearBufferiv(A.COLOR,0,w))}else H|=A.COLOR_BUFFER_BIT}U&&(H|=A.DEPTH_BUFFER_BIT),z&&(H|=A.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),A.clear(H)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",rt,!1),e.removeEventListener("webglcontextrestored",pt,!1),e.removeEventListener("webglcontextcreationerror",Q,!1),bt.dispose(),W.dispose(),wt.dispose(),yt.dispose(),Pe.dispose(),Me.dispose(),O.dispose(),ct.dispose(),Vt.dispose(),q.dispose(),it.dispose(),it.removeEventListener("sessionstart",Ai),it.removeEventListener("sessionend",fh),bn.stop()};function rt(M){M.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),I=!0}function pt(){console.log("THREE.WebGLRenderer: Context Restored."),I=!1;let M=me.autoReset,U=xt.enabled,z=xt.autoUpdate,H=xt.needsUpdate,N=xt.type;L(),me.autoReset=M,xt.enabled=U,xt.autoUpdate=z,xt.needsUpdate=H,xt.type=N}function Q(M){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",M.statusMessage)}function Z(M){let U=M.target;U.removeEventListener("dispose",Z),_t(U)}function _t(M){Ft(M),yt.remove(M)}function Ft(M){let U=yt.get(M).programs;U!==void 0&&(U.forEach(function(z){q.releaseProgram(z)}),M.isShaderMaterial&&q.releaseShaderCache(M))}this.renderBufferDirect=function(M,U,z,H,N,tt){U===null&&(U=St);let ht=N.isMesh&&N.matrixWorld.determinant()<0,gt=uf(M,U,z,H,N);vt.setMaterial(H,ht);let ft=z.index,Pt=1;if(H.wireframe===!0){if(ft=_.getWireframeAttribute(z),ft===void 0)return;Pt=2}let Dt=z.drawRange,At=z.attributes.position,$t=Dt.start*Pt,se=(Dt.start+Dt.count)*Pt;tt!==null&&($t=Math.max($t,tt.start*Pt),se=Math.min(se,(tt.start+tt.count)*Pt)),ft!==null?($t=Math.max($t,0),se=Math.min(se,ft.count)):At!=null&&($t=Math.max($t,0),se=Math.min(se,At.count));let ve=se-$t;if(ve<0||ve===1/0)return;ct.setup(N,H,gt,z,ft);let ue,oe=ut;if(ft!==null&&(ue=E.get(ft),oe=It,oe.setIndex(ue)),N.isMesh)H.wireframe===!0?(vt.setLineWidth(H.wireframeLinewidth*Ne()),oe.setMode(A.LINES)):oe.setMode(A.TRIANGLES);else if(N.isLine){let Rt=H.linewidth;Rt===void 0&&(Rt=1),vt.setLineWidth(Rt*Ne()),N.isLineSegments?oe.setMode(A.LINES):N.isLineLoop?oe.setMode(A.LINE_LOOP):oe.setMode(A.LINE_STRIP)}else N.isPoints?oe.setMode(A.POINTS):N.isSprite&&oe.setMode(A.TRIANGLES);if(N.isBatchedMesh)if(N._multiDrawInstances!==null)ms("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),oe.renderMultiDrawInstances(N._multiDrawStarts,N._multiDrawCounts,N._multiDrawCount,N._multiDrawInstances);else if(kt.get("WEBGL_multi_draw"))oe.renderMultiDraw(N._multiDrawStarts,N._multiDrawCounts,N._multiDrawCount);else{let Rt=N._multiDrawStarts,ge=N._multiDrawCounts,Qt=N._multiDrawCount,ii=ft?E.get(ft).bytesPerElement:1,qn=yt.get(H).currentProgram.getUniforms();for(let ni=0;ni<Qt;ni++)qn.setValue(A,"_gl_DrawID",ni),oe.render(Rt[ni]/ii,ge[ni])}else if(N.isInstancedMesh)oe.renderInstances($t,ve,N.count);else if(z.isInstancedBufferGeometry){let Rt=z._maxInstanceCount!==void 0?z._maxInstanceCount:1/0,ge=Math.min(z.instanceCount,Rt);oe.renderInstances($t,ve,ge)}else oe.render($t,ve)};function ce(M,U,z){M.transparent===!0&&M.side===ki&&M.forceSinglePass===!1?(M.side=je,M.needsUpdate=!0,Fr(M,U,z),M.side=ji,M.needsUpdate=!0,Fr(M,U,z),M.side=ki):Fr(M,U,z)}this.compile=function(M,U,z=null){z===null&&(z=M),f=wt.get(z),f.init(U),T.push(f),z.traverseVisible(function(N){N.isLight&&N.layers.test(U.layers)&&(f.pushLight(N),N.castShadow&&f.pushShadow(N))}),M!==z&&M.traverseVisible(function(N){N.isLight&&N.layers.test(U.layers)&&(f.pushLight(N),N.castShadow&&f.pushShadow(N))}),f.setupLights();let H=new Set;return M.traverse(function(N){if(!(N.isMesh||N.isPoints||N.isLine||N.isSprite))return;let tt=N.material;if(tt)if(Array.isArray(tt))for(let ht=0;ht<tt.length;ht++){let gt=tt[ht];ce(gt,z,N),H.add(gt)}else ce(tt,z,N),H.add(tt)}),f=T.pop(),H},this.compileAsync=function(M,U,z=null){let H=this.compile(M,U,z);return new Promise(N=>{function tt(){if(H.forEach(function(ht){yt.get(ht).currentProgram.isReady()&&H.delete(ht)}),H.size===0){N(M);return}setTimeout(tt,10)}kt.get("KHR_parallel_shader_compile")!==null?tt():setTimeout(tt,10)})};let ee=null;function Vi(M){ee&&ee(M)}function Ai(){bn.stop()}function fh(){bn.start()}let bn=new Hd;bn.setAnimationLoop(Vi),typeof self<"u"&&bn.setContext(self),this.setAnimationLoop=function(M){ee=M,it.setAnimationLoop(M),M===null?bn.stop():bn.start()},it.addEventListener("sessionstart",Ai),it.addEventListener("sessionend",fh),this.render=function(M,U){if(U!==void 0&&U.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;if(M.matrixWorldAutoUpdate===!0&&M.updateMatrixWorld(),U.parent===null&&U.matrixWorldAutoUpdate===!0&&U.updateMatrixWorld(),it.enabled===!0&&it.isPresenting===!0&&(it.cameraAutoUpdate===!0&&it.updateCamera(U),U=it.getCamera()),M.isScene===!0&&M.onBeforeRender(S,M,U,k),f=wt.get(M,T.length),f.init(U),T.push(f),J.multiplyMatrices(U.projectionMatrix,U.matrixWorldInverse),fe.setFromProjectionMatrix(J,bi,U.reversedDepth),$=this.localClippingEnabled,te=st.init(this.clippingPlanes,$),g=W.get(M,R.length),g.init(),R.push(g),it.enabled===!0&&it.isPresenting===!0){let tt=S.xr.getDepthSensingMesh();tt!==null&&Sl(tt,U,-1/0,S.sortObjects)}Sl(M,U,0,S.sortObjects),g.finish(),S.sortObjects===!0&&g.sort(lt,dt),Kt=it.enabled===!1||it.isPresenting===!1||it.hasDepthSensing()===!1,Kt&&bt.addToRenderList(g,M),this.info.render.frame++,te===!0&&st.beginShadows();let z=f.state.shadowsArray;xt.render(z,M,U),te===!0&&st.endShadows(),this.info.autoReset===!0&&this.info.reset();let H=g.opaque,N=g.transmissive;if(f.setupLights(),U.isArrayCamera){let tt=U.cameras;if(N.length>0)for(let ht=0,gt=tt.length;ht<gt;ht++){let ft=tt[ht];mh(H,N,M,ft)}Kt&&bt.render(M);for(let ht=0,gt=tt.length;ht<gt;ht++){let ft=tt[ht];ph(g,M,ft,ft.viewport)}}else N.length>0&&mh(H,N,M,U),Kt&&bt.render(M),ph(g,M,U);k!==null&&D===0&&(Gt.updateMultisampleRenderTarget(k),Gt.updateRenderTargetMipmap(k)),M.isScene===!0&&M.onAfterRender(S,M,U),ct.resetDefaultState(),y=-1,b=null,T.pop(),T.length>0?(f=T[T.length-1],te===!0&&st.setGlobalState(S.clippingPlanes,f.state.camera)):f=null,R.pop(),R.length>0?g=R[R.length-1]:g=null};function Sl(M,U,z,H){if(M.visible===!1)return;if(M.layers.test(U.layers)){if(M.isGroup)z=M.renderOrder;else if(M.isLOD)M.autoUpdate===!0&&M.update(U);else if(M.isLight)f.pushLight(M),M.castShadow&&f.pushShadow(M);else if(M.isSprite){if(!M.frustumCulled||fe.intersectsSprite(M)){H&&Ut.setFromMatrixPosition(M.matrixWorld).applyMatrix4(J);let ht=O.update(M),gt=M.material;gt.visible&&g.push(M,ht,gt,z,Ut.z,null)}}else if((M.isMesh||M.isLine||M.isPoints)&&(!M.frustumCulled||fe.intersectsObject(M))){let ht=O.update(M),gt=M.material;if(H&&(M.boundingSphere!==void 0?(M.boundingSphere===null&&M.computeBoundingSphere(),Ut.copy(M.boundingSphere.center)):(ht.boundingSphere===null&&ht.computeBoundingSphere(),Ut.copy(ht.boundingSphere.center)),Ut.applyMatrix4(M.matrixWorld).applyMatrix4(J)),Array.isArray(gt)){let ft=ht.groups;for(let Pt=0,Dt=ft.length;Pt<Dt;Pt++){let At=ft[Pt],$t=gt[At.materialIndex];$t&&$t.visible&&g.push(M,ht,$t,z,Ut.z,At)}}else gt.visible&&g.push(M,ht,gt,z,Ut.z,null)}}let tt=M.children;for(let ht=0,gt=tt.length;ht<gt;ht++)Sl(tt[ht],U,z,H)}function ph(M,U,z,H){let N=M.opaque,tt=M.transmissive,ht=M.transparent;f.setupLightsView(z),te===!0&&st.setGlobalState(S.clippingPlanes,z),H&&vt.viewport(C.copy(H)),N.length>0&&Nr(N,U,z),tt.length>0&&Nr(tt,U,z),ht.length>0&&Nr(ht,U,z),vt.buffers.depth.setTest(!0),vt.buffers.depth.setMask(!0),vt.buffers.color.setMask(!0),vt.setPolygonOffset(!1)}function mh(M,U,z,H){if((z.isScene===!0?z.overrideMaterial:null)!==null)return;f.state.transmissionRenderTarget[H.id]===void 0&&(f.state.transmissionRenderTarget[H.id]=new Li(1,1,{generateMipmaps:!0,type:kt.has("EXT_color_buffer_half_float")||kt.has("EXT_color_buffer_float")?bs:Bi,minFilter:vn,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:Jt.workingColorSpace}));let tt=f.state.transmissionRenderTarget[H.id],ht=H.viewport||C;tt.setSize(ht.z*S.transmissionResolutionScale,ht.w*S.transmissionResolutionScale);let gt=S.getRenderTarget(),ft=S.getActiveCubeFace(),Pt=S.getActiveMipmapLevel();S.setRenderTarget(tt),S.getClearColor(X),K=S.getClearAlpha(),K<1&&S.setClearColor(16777215,.5),S.clear(),Kt&&bt.render(z);let Dt=S.toneMapping;S.toneMapping=tn;let At=H.viewport;if(H.viewport!==void 0&&(H.viewport=void 0),f.setupLightsView(H),te===!0&&st.setGlobalState(S.clippingPlanes,H),Nr(M,z,H),Gt.updateMultisampleRenderTarget(tt),Gt.updateRenderTargetMipmap(tt),kt.has("WEBGL_multisampled_render_to_texture")===!1){let $t=!1;for(let se=0,ve=U.length;se<ve;se++){let ue=U[se],oe=ue.object,Rt=ue.geometry,ge=ue.material,Qt=ue.group;if(ge.side===ki&&oe.layers.test(H.layers)){let ii=ge.side;ge.side=je,ge.needsUpdate=!0,gh(oe,z,H,Rt,ge,Qt),ge.side=ii,ge.needsUpdate=!0,$t=!0}}$t===!0&&(Gt.updateMultisampleRenderTarget(tt),Gt.updateRenderTargetMipmap(tt))}S.setRenderTarget(gt,ft,Pt),S.setClearColor(X,K),At!==void 0&&(H.viewport=At),S.toneMapping=Dt}function Nr(M,U,z){let H=U.isScene===!0?U.overrideMaterial:null;for(let N=0,tt=M.length;N<tt;N++){let ht=M[N],gt=ht.object,ft=ht.geometry,Pt=ht.group,Dt=ht.material;Dt.allowOverride===!0&&H!==null&&(Dt=H),gt.layers.test(z.layers)&&gh(gt,U,z,ft,Dt,Pt)}}function gh(M,U,z,H,N,tt){M.onBeforeRender(S,U,z,H,N,tt),M.modelViewMatrix.multiplyMatrices(z.matrixWorldInverse,M.matrixWorld),M.normalMatrix.getNormalMatrix(M.modelViewMatrix),N.onBeforeRender(S,U,z,H,M,tt),N.transparent===!0&&N.side===ki&&N.forceSinglePass===!1?(N.side=je,N.needsUpdate=!0,S.renderBufferDirect(z,U,H,N,M,tt),N.side=ji,N.needsUpdate=!0,S.renderBufferDirect(z,U,H,N,M,tt),N.side=ki):S.renderBufferDirect(z,U,H,N,M,tt),M.onAfterRender(S,U,z,H,N,tt)}function Fr(M,U,z){U.isScene!==!0&&(U=St);let H=yt.get(M),N=f.state.lights,tt=f.state.shadowsArray,ht=N.state.version,gt=q.getParameters(M,N.state,tt,U,z),ft=q.getProgramCacheKey(gt),Pt=H.programs;H.environment=M.isMeshStandardMaterial?U.environment:null,H.fog=U.fog,H.envMap=(M.isMeshStandardMaterial?Me:Pe).get(M.envMap||H.environment),H.envMapRotation=H.environment!==null&&M.envMap===null?U.environmentRotation:M.envMapRotation,Pt===void 0&&(M.addEventListener("dispose",Z),Pt=new Map,H.programs=Pt);let Dt=Pt.get(ft);if(Dt!==void 0){if(H.currentProgram===Dt&&H.lightsStateVersion===ht)return vh(M,gt),Dt}else gt.uniforms=q.getUniforms(M),M.onBeforeCompile(gt,S),Dt=q.acquireProgram(gt,ft),Pt.set(ft,Dt),H.uniforms=gt.uniforms;let At=H.uniforms;return(!M.isShaderMaterial&&!M.isRawShaderMaterial||M.clipping===!0)&&(At.clippingPlanes=st.uniform),vh(M,gt),H.needsLights=ff(M),H.lightsStateVersion=ht,H.needsLights&&(At.ambientLightColor.value=N.state.ambient,At.lightProbe.value=N.state.probe,At.directionalLights.value=N.state.directional,At.directionalLightShadows.value=N.state.directionalShadow,At.spotLights.value=N.state.spot,At.spotLightShadows.value=N.state.spotShadow,At.rectAreaLights.value=N.state.rectArea,At.ltc_1.value=N.state.rectAreaLTC1,At.ltc_2.value=N.state.rectAreaLTC2,At.pointLights.value=N.state.point,At.pointLightShadows.value=N.state.pointShadow,At.hemisphereLights.value=N.state.hemi,At.directionalShadowMap.value=N.state.directionalShadowMap,At.directionalShadowMatrix.value=N.state.directionalShadowMatrix,At.spotShadowMap.value=N.state.spotShadowMap,At.spotLightMatrix.value=N.state.spotLightMatrix,At.spotLightMap.value=N.state.spotLightMap,At.pointShadowMap.value=N.state.pointShadowMap,At.pointShadowMatrix.value=N.state.pointShadowMatrix),H.currentProgram=Dt,H.uniformsList=null,Dt}function _h(M){if(M.uniformsList===null){let U=M.currentProgram.getUniforms();M.uniformsList=As.seqWithValue(U.seq,M.uniforms)}return M.uniformsList}function vh(M,U){let z=yt.get(M);z.outputColorSpace=U.outputColorSpace,z.batching=U.batching,z.batchingColor=U.batchingColor,z.instancing=U.instancing,z.instancingColor=U.instancingColor,z.instancingMorph=U.instancingMorph,z.skinning=U.skinning,z.morphTargets=U.morphTargets,z.morphNormals=U.morphNormals,z.morphColors=U.morphColors,z.morphTargetsCount=U.morphTargetsCount,z.numClippingPlanes=U.numClippingPlanes,z.numIntersection=U.numClipIntersection,z.vertexAlphas=U.vertexAlphas,z.vertexTangents=U.vertexTangents,z.toneMapping=U.toneMapping}function uf(M,U,z,H,N){U.isScene!==!0&&(U=St),Gt.resetTextureUnits();let tt=U.fog,ht=H.isMeshStandardMaterial?U.environment:null,gt=k===null?S.outputColorSpace:k.isXRRenderTarget===!0?k.texture.colorSpace:Nn,ft=(H.isMeshStandardMaterial?Me:Pe).get(H.envMap||ht),Pt=H.vertexColors===!0&&!!z.attributes.color&&z.attributes.color.itemSize===4,Dt=!!z.attributes.tangent&&(!!H.normalMap||H.anisotropy>0),At=!!z.morphAttributes.position,$t=!!z.morphAttributes.normal,se=!!z.morphAttributes.color,ve=tn;H.toneMapped&&(k===null||k.isXRRenderTarget===!0)&&(ve=S.toneMapping);let ue=z.morphAttributes.position||z.morphAttributes.normal||z.morphAttributes.color,oe=ue!==void 0?ue.length:0,Rt=yt.get(H),ge=f.state.lights;if(te===!0&&($===!0||M!==b)){let qe=M===b&&H.id===y;st.setState(H,M,qe)}let Qt=!1;H.version===Rt.__version?(Rt.needsLights&&Rt.lightsStateVersion!==ge.state.version||Rt.outputColorSpace!==gt||N.isBatchedMesh&&Rt.batching===!1||!N.isBatchedMesh&&Rt.batching===!0||N.isBatchedMesh&&Rt.batchingColor===!0&&N.colorTexture===null||N.isBatchedMesh&&Rt.batchingColor===!1&&N.colorTexture!==null||N.isInstancedMesh&&Rt.instancing===!1||!N.isInstancedMesh&&Rt.instancing===!0||N.isSkinnedMesh&&Rt.skinning===!1||!N.isSkinnedMesh&&Rt.skinning===!0||N.isInstancedMesh&&Rt.instancingColor===!0&&N.instanceColor===null||N.isInstancedMesh&&Rt.instancingColor===!1&&N.instanceColor!==null||N.isInstancedMesh&&Rt.instancingMorph===!0&&N.morphTexture===null||N.isInstancedMesh&&Rt.instancingMorph===!1&&N.morphTexture!==null||Rt.envMap!==ft||H.fog===!0&&Rt.fog!==tt||Rt.numClippingPlanes!==void 0&&(Rt.numClippingPlanes!==st.numPlanes||Rt.numIntersection!==st.numIntersection)||Rt.vertexAlphas!==Pt||Rt.vertexTangents!==Dt||Rt.morphTargets!==At||Rt.morphNormals!==$t||Rt.morphColors!==se||Rt.toneMapping!==ve||Rt.morphTargetsCount!==oe)&&(Qt=!0):(Qt=!0,Rt.__version=H.version);let ii=Rt.currentProgram;Qt===!0&&(ii=Fr(H,U,N));let qn=!1,ni=!1,Ps=!1,_e=ii.getUniforms(),hi=Rt.uniforms;if(vt.useProgram(ii.program)&&(qn=!0,ni=!0,Ps=!0),H.id!==y&&(y=H.id,ni=!0),qn||b!==M){vt.buffers.depth.getReversed()&&M.reversedDepth!==!0&&(M._reversedDepth=!0,M.updateProjectionMatrix()),_e.setValue(A,"projectionMatrix",M.projectionMatrix),_e.setValue(A,"viewMatrix",M.matrixWorldInverse);let Je=_e.map.cameraPosition;Je!==void 0&&Je.setValue(A,mt.setFromMatrixPosition(M.matrixWorld)),Lt.logarithmicDepthBuffer&&_e.setValue(A,"logDepthBufFC",2/(Math.log(M.far+1)/Math.LN2)),(H.isMeshPhongMaterial||H.isMeshToonMaterial||H.isMeshLambertMaterial||H.isMeshBasicMaterial||H.isMeshStandardMaterial||H.isShaderMaterial)&&_e.setValue(A,"isOrthographic",M.isOrthographicCamera===!0),b!==M&&(b=M,ni=!0,Ps=!0)}if(N.isSkinnedMesh){_e.setOptional(A,N,"bindMatrix"),_e.setOptional(A,N,"bindMatrixInverse");let qe=N.skeleton;qe&&(qe.boneTexture===null&&qe.computeBoneTexture(),_e.setValue(A,"boneTexture",qe.boneTexture,Gt))}N.isBatchedMesh&&(_e.setOptional(A,N,"batchingTexture"),_e.setValue(A,"batchingTexture",N._matricesTexture,Gt),_e.setOptional(A,N,"batchingIdTexture"),_e.setValue(A,"batchingIdTexture",N._indirectTexture,Gt),_e.setOptional(A,N,"batchingColorTexture"),N._colorsTexture!==null&&_e.setValue(A,"batchingColorTexture",N._colorsTexture,Gt));let ui=z.morphAttributes;if((ui.position!==void 0||ui.normal!==void 0||ui.color!==void 0)&&et.update(N,z,ii),(ni||Rt.receiveShadow!==N.receiveShadow)&&(Rt.receiveShadow=N.receiveShadow,_e.setValue(A,"receiveShadow",N.receiveShadow)),H.isMeshGouraudMaterial&&H.envMap!==null&&(hi.envMap.value=ft,hi.flipEnvMap.value=ft.isCubeTexture&&ft.isRenderTargetTexture===!1?-1:1),H.isMeshStandardMaterial&&H.envMap===null&&U.environment!==null&&(hi.envMapIntensity.value=U.environmentIntensity),ni&&(_e.setValue(A,"toneMappingExposure",S.toneMappingExposure),Rt.needsLights&&df(hi,Ps),tt&&H.fog===!0&&j.refreshFogUniforms(hi,tt),j.refreshMaterialUniforms(hi,H,G,nt,f.state.transmissionRenderTarget[M.id]),As.upload(A,_h(Rt),hi,Gt)),H.isShaderMaterial&&H.uniformsNeedUpdate===!0&&(As.upload(A,_h(Rt),hi,Gt),H.uniformsNeedUpdate=!1),H.isSpriteMaterial&&_e.setValue(A,"center",N.center),_e.setValue(A,"modelViewMatrix",N.modelViewMatrix),_e.setValue(A,"normalMatrix",N.normalMatrix),_e.setValue(A,"modelMatrix",N.matrixWorld),H.isShaderMaterial||H.isRawShaderMaterial){let qe=H.uniformsGroups;for(let Je=0,El=qe.length;Je<El;Je++){let Mn=qe[Je];Vt.update(Mn,ii),Vt.bind(Mn,ii)}}return ii}function df(M,U){M.ambientLightColor.needsUpdate=U,M.lightProbe.needsUpdate=U,M.directionalLights.needsUpdate=U,M.directionalLightShadows.needsUpdate=U,M.pointLights.needsUpdate=U,M.pointLightShadows.needsUpdate=U,M.spotLights.needsUpdate=U,M.spotLightShadows.needsUpdate=U,M.rectAreaLights.needsUpdate=U,M.hemisphereLights.needsUpdate=U}function ff(M){return M.isMeshLambertMaterial||M.isMeshToonMaterial||M.isMeshPhongMaterial||M.isMeshStandardMaterial||M.isShadowMaterial||M.isShaderMaterial&&M.lights===!0}this.getActiveCubeFace=function(){return P},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return k},this.setRenderTargetTextures=function(M,U,z){let H=yt.get(M);H.__autoAllocateDepthBuffer=M.resolveDepthBuffer===!1,H.__autoAllocateDepthBuffer===!1&&(H.__useRenderToTexture=!1),yt.get(M.texture).__webglTexture=U,yt.get(M.depthTexture).__webglTexture=H.__autoAllocateDepthBuffer?void 0:z,H.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(M,U){let z=yt.get(M);z.__webglFramebuffer=U,z.__useDefaultFramebuffer=U===void 0};let pf=A.createFramebuffer();this.setRenderTarget=function(M,U=0,z=0){k=M,P=U,D=z;let H=!0,N=null,tt=!1,ht=!1;if(M){let ft=yt.get(M);if(ft.__useDefaultFramebuffer!==void 0)vt.bindFramebuffer(A.FRAMEBUFFER,null),H=!1;else if(ft.__webglFramebuffer===void 0)Gt.setupRenderTarget(M);else if(ft.__hasExternalTextures)Gt.rebindTextures(M,yt.get(M.texture).__webglTexture,yt.get(M.depthTexture).__webglTexture);else if(M.depthBuffer){let At=M.depthTexture;if(ft.__boundDepthTexture!==At){if(At!==null&&yt.has(At)&&(M.width!==At.image.width||M.height!==At.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");Gt.setupDepthRenderbuffer(M)}}let Pt=M.texture;(Pt.isData3DTexture||Pt.isDataArrayTexture||Pt.isCompressedArrayTexture)&&(ht=!0);let Dt=yt.get(M).__webglFramebuffer;M.isWebGLCubeRenderTarget?(Array.isArray(Dt[U])?N=Dt[U][z]:N=Dt[U],tt=!0):M.samples>0&&Gt.useMultisampledRTT(M)===!1?N=yt.get(M).__webglMultisampledFramebuffer:Array.isArray(Dt)?N=Dt[z]:N=Dt,C.copy(M.viewport),B.copy(M.scissor),V=M.scissorTest}else C.copy(Tt).multiplyScalar(G).floor(),B.copy(Yt).multiplyScalar(G).floor(),V=le;if(z!==0&&(N=pf),vt.bindFramebuffer(A.FRAMEBUFFER,N)&&H&&vt.drawBuffers(M,N),vt.viewport(C),vt.scissor(B),vt.setScissorTest(V),tt){let ft=yt.get(M.texture);A.framebufferTexture2D(A.FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.TEXTURE_CUBE_MAP_POSITIVE_X+U,ft.__webglTexture,z)}else if(ht){let ft=U;for(let Pt=0;Pt<M.textures.length;Pt++){let Dt=yt.get(M.textures[Pt]);A.framebufferTextureLayer(A.FRAMEBUFFER,A.COLOR_ATTACHMENT0+Pt,Dt.__webglTexture,z,ft)}}else if(M!==null&&z!==0){let ft=yt.get(M.texture);A.framebufferTexture2D(A.FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.TEXTURE_2D,ft.__webglTexture,z)}y=-1},this.readRenderTargetPixels=function(M,U,z,H,N,tt,ht,gt=0){if(!(M&&M.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ft=yt.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&ht!==void 0&&(ft=ft[ht]),ft){vt.bindFramebuffer(A.FRAMEBUFFER,ft);try{let Pt=M.textures[gt],Dt=Pt.format,At=Pt.type;if(!Lt.textureFormatReadable(Dt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Lt.textureTypeReadable(At)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}U>=0&&U<=M.width-H&&z>=0&&z<=M.height-N&&(M.textures.length>1&&A.readBuffer(A.COLOR_ATTACHMENT0+gt),A.readPixels(U,z,H,N,Mt.convert(Dt),Mt.convert(At),tt))}finally{let Pt=k!==null?yt.get(k).__webglFramebuffer:null;vt.bindFramebuffer(A.FRAMEBUFFER,Pt)}}},this.readRenderTargetPixelsAsync=async function(M,U,z,H,N,tt,ht,gt=0){if(!(M&&M.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ft=yt.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&ht!==void 0&&(ft=ft[ht]),ft)if(U>=0&&U<=M.width-H&&z>=0&&z<=M.height-N){vt.bindFramebuffer(A.FRAMEBUFFER,ft);let Pt=M.textures[gt],Dt=Pt.format,At=Pt.type;if(!Lt.textureFormatReadable(Dt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Lt.textureTypeReadable(At))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let $t=A.createBuffer();A.bindBuffer(A.PIXEL_PACK_BUFFER,$t),A.bufferData(A.PIXEL_PACK_BUFFER,tt.byteLength,A.STREAM_READ),M.textures.length>1&&A.readBuffer(A.COLOR_ATTACHMENT0+gt),A.readPixels(U,z,H,N,Mt.convert(Dt),Mt.convert(At),0);let se=k!==null?yt.get(k).__webglFramebuffer:null;vt.bindFramebuffer(A.FRAMEBUFFER,se);let ve=A.fenceSync(A.SYNC_GPU_COMMANDS_COMPLETE,0);return A.flush(),await pd(A,ve,4),A.bindBuffer(A.PIXEL_PACK_BUFFER,$t),A.getBufferSubData(A.PIXEL_PACK_BUFFER,0,tt),A.deleteBuffer($t),A.deleteSync(ve),tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(M,U=null,z=0){let H=Math.pow(2,-z),N=Math.floor(M.image.width*H),tt=Math.floor(M.image.height*H),ht=U!==null?U.x:0,gt=U!==null?U.y:0;Gt.setTexture2D(M,0),A.copyTexSubImage2D(A.TEXTURE_2D,z,0,0,ht,gt,N,tt),vt.unbindTexture()};let mf=A.createFramebuffer(),gf=A.createFramebuffer();this.copyTextureToTexture=function(M,U,z=null,H=null,N=0,tt=null){tt===null&&(N!==0?(ms("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),tt=N,N=0):tt=0);let ht,gt,ft,Pt,Dt,At,$t,se,ve,ue=M.isCompressedTexture?M.mipmaps[tt]:M.image;if(z!==null)ht=z.max.x-z.min.x,gt=z.max.y-z.min.y,ft=z.isBox3?z.max.z-z.min.z:1,Pt=z.min.x,Dt=z.min.y,At=z.isBox3?z.min.z:0;else{let ui=Math.pow(2,-N);ht=Math.floor(ue.width*ui),gt=Math.floor(ue.height*ui),M.isDataArrayTexture?ft=ue.depth:M.isData3DTexture?ft=Math.floor(ue.depth*ui):ft=1,Pt=0,Dt=0,At=0}H!==null?($t=H.x,se=H.y,ve=H.z):($t=0,se=0,ve=0);let oe=Mt.convert(U.format),Rt=Mt.convert(U.type),ge;U.isData3DTexture?(Gt.setTexture3D(U,0),ge=A.TEXTURE_3D):U.isDataArrayTexture||U.isCompressedArrayTexture?(Gt.setTexture2DArray(U,0),ge=A.TEXTURE_2D_ARRAY):(Gt.setTexture2D(U,0),ge=A.TEXTURE_2D),A.pixelStorei(A.UNPACK_FLIP_Y_WEBGL,U.flipY),A.pixelStorei(A.UNPACK_PREMULTIPLY_ALPHA_WEBGL,U.premultiplyAlpha),A.pixelStorei(A.UNPACK_ALIGNMENT,U.unpackAlignment);let Qt=A.getParameter(A.UNPACK_ROW_LENGTH),ii=A.getParameter(A.UNPACK_IMAGE_HEIGHT),qn=A.getParameter(A.UNPACK_SKIP_PIXELS),ni=A.getParameter(A.UNPACK_SKIP_ROWS),Ps=A.getParameter(A.UNPACK_SKIP_IMAGES);A.pixelStorei(A.UNPACK_ROW_LENGTH,ue.width),A.pixelStorei(A.UNPACK_IMAGE_HEIGHT,ue.height),A.pixelStorei(A.UNPACK_SKIP_PIXELS,Pt),A.pixelStorei(A.UNPACK_SKIP_ROWS,Dt),A.pixelStorei(A.UNPACK_SKIP_IMAGES,At);let _e=M.isDataArrayTexture||M.isData3DTexture,hi=U.isDataArrayTexture||U.isData3DTexture;if(M.isDepthTexture){let ui=yt.get(M),qe=yt.get(U),Je=yt.get(ui.__renderTarget),El=yt.get(qe.__renderTarget);vt.bindFramebuffer(A.READ_FRAMEBUFFER,Je.__webglFramebuffer),vt.bindFramebuffer(A.DRAW_FRAMEBUFFER,El.__webglFramebuffer);for(let Mn=0;Mn<ft;Mn++)_e&&(A.framebufferTextureLayer(A.READ_FRAMEBUFFER,A.COLOR_ATTACHMENT0,yt.get(M).__webglTexture,N,At+Mn),A.framebufferTextureLayer(A.DRAW_FRAMEBUFFER,A.COLOR_ATTACHMENT0,yt.get(U).__webglTexture,tt,ve+Mn)),A.blitFramebuffer(Pt,Dt,ht,gt,$t,se,ht,gt,A.DEPTH_BUFFER_BIT,A.NEAREST);vt.bindFramebuffer(A.READ_FRAMEBUFFER,null),vt.bindFramebuffer(A.DRAW_FRAMEBUFFER,null)}else if(N!==0||M.isRenderTargetTexture||yt.has(M)){let ui=yt.get(M),qe=yt.get(U);vt.bindFramebuffer(A.READ_FRAMEBUFFER,mf),vt.bindFramebuffer(A.DRAW_FRAMEBUFFER,gf);for(let Je=0;Je<ft;Je++)_e?A.framebufferTextureLayer(A.READ_FRAMEBUFFER,A.COLOR_ATTACHMENT0,ui.__webglTexture,N,At+Je):A.framebufferTexture2D(A.READ_FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.TEXTURE_2D,ui.__webglTexture,N),hi?A.framebufferTextureLayer(A.DRAW_FRAMEBUFFER,A.COLOR_ATTACHMENT0,qe.__webglTexture,tt,ve+Je):A.framebufferTexture2D(A.DRAW_FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.TEXTURE_2D,qe.__webglTexture,tt),N!==0?A.blitFramebuffer(Pt,Dt,ht,gt,$t,se,ht,gt,A.COLOR_BUFFER_BIT,A.NEAREST):hi?A.copyTexSubImage3D(ge,tt,$t,se,ve+Je,Pt,Dt,ht,gt):A.copyTexSubImage2D(ge,tt,$t,se,Pt,Dt,ht,gt);vt.bindFramebuffer(A.READ_FRAMEBUFFER,null),vt.bindFramebuffer(A.DRAW_FRAMEBUFFER,null)}else hi?M.isDataTexture||M.isData3DTexture?A.texSubImage3D(ge,tt,$t,se,ve,ht,gt,ft,oe,Rt,ue.data):U.isCompressedArrayTexture?A.compressedTexSubImage3D(ge,tt,$t,se,ve,ht,gt,ft,oe,ue.data):A.texSubImage3D(ge,tt,$t,se,ve,ht,gt,ft,oe,Rt,ue):M.isDataTexture?A.texSubImage2D(A.TEXTURE_2D,tt,$t,se,ht,gt,oe,Rt,ue.data):M.isCompressedTexture?A.compressedTexSubImage2D(A.TEXTURE_2D,tt,$t,se,ue.width,ue.height,oe,ue.data):A.texSubImage2D(A.TEXTURE_2D,tt,$t,se,ht,gt,oe,Rt,ue);A.pixelStorei(A.UNPACK_ROW_LENGTH,Qt),A.pixelStorei(A.UNPACK_IMAGE_HEIGHT,ii),A.pixelStorei(A.UNPACK_SKIP_PIXELS,qn),A.pixelStorei(A.UNPACK_SKIP_ROWS,ni),A.pixelStorei(A.UNPACK_SKIP_IMAGES,Ps),tt===0&&U.generateMipmaps&&A.generateMipmap(ge),vt.unbindTexture()},this.initRenderTarget=function(M){yt.get(M).__webglFramebuffer===void 0&&Gt.setupRenderTarget(M)},this.initTexture=function(M){M.isCubeTexture?Gt.setTextureCube(M,0):M.isData3DTexture?Gt.setTexture3D(M,0):M.isDataArrayTexture||M.isCompressedArrayTexture?Gt.setTexture2DArray(M,0):Gt.setTexture2D(M,0),vt.unbindTexture()},this.resetState=function(){P=0,D=0,k=null,vt.reset(),ct.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return bi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Jt._getDrawingBufferColorSpace(t),e.unpackColorSpace=Jt._getUnpackColorSpace()}};var qd={type:"change"},lh={type:"start"},$d={type:"end"},hl=new fn,Yd=new $e,c0=Math.cos(70*zc.DEG2RAD),Ce=new F,ei=2*Math.PI,re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},ah=1e-6,ul=class extends Mr{constructor(t,e=null){super(t,e),this.state=re.NONE,this.target=new F,this.cursor=new F,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:gn.ROTATE,MIDDLE:gn.DOLLY,RIGHT:gn.PAN},this.touches={ONE:_n.ROTATE,TWO:_n.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new F,this._lastQuaternion=new fi,this._lastTargetPosition=new F,this._quat=new fi().setFromUnitVectors(t.up,new F(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ys,this._sphericalDelta=new ys,this._scale=1,this._panOffset=new F,this._rotateStart=new zt,this._rotateEnd=new zt,this._rotateDelta=new zt,this._panStart=new zt,this._panEnd=new zt,this._panDelta=new zt,this._dollyStart=new zt,this._dollyEnd=new zt,this._dollyDelta=new zt,this._dollyDirection=new F,this._mouse=new zt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=u0.bind(this),this._onPointerDown=h0.bind(this),this._onPointerUp=d0.bind(this),this._onContextMenu=y0.bind(this),this._onMouseWheel=m0.bind(this),this._onKeyDown=g0.bind(this),this._onTouchStart=_0.bind(this),this._onTouchMove=v0.bind(this),this._onMouseDown=f0.bind(this),this._onMouseMove=p0.bind(this),this._interceptControlDown=x0.bind(this),this._interceptControlUp=b0.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(qd),this.update(),this.state=re.NONE}update(t=null){let e=this.object.position;Ce.copy(e).sub(this.target),Ce.applyQuaternion(this._quat),this._spherical.setFromVector3(Ce),this.autoRotate&&this.state===re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ei:i>Math.PI&&(i-=ei),s<-Math.PI?s+=ei:s>Math.PI&&(s-=ei),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Ce.setFromSpherical(this._spherical),Ce.applyQuaternion(this._quatInverse),e.copy(this.target).add(Ce),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Ce.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new F(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new F(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Ce.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(hl.origin.copy(this.object.position),hl.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(hl.direction))<c0?this.object.lookAt(this.target):(Yd.setFromNormalAndCoplanarPoint(this.object.up,this.target),hl.intersectPlane(Yd,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>ah||8*(1-this._lastQuaternion.dot(this.object.quaternion))>ah||this._lastTargetPosition.distanceToSquared(this.target)>ah?(this.dispatchEvent(qd),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ei/60*this.autoRotateSpeed*t:ei/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Ce.setFromMatrixColumn(e,0),Ce.multiplyScalar(-t),this._panOffset.add(Ce)}_panUp(t,e){this.screenSpacePanning===!0?Ce.setFromMatrixColumn(e,1):(Ce.setFromMatrixColumn(e,0),Ce.crossVectors(this.object.up,Ce)),Ce.multiplyScalar(t),this._panOffset.add(Ce)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Ce.copy(s).sub(this.target);let r=Ce.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientX),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new zt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function h0(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n)))}function u0(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function d0(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent($d),this.state=re.NONE;break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function f0(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case gn.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=re.DOLLY;break;case gn.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=re.ROTATE}break;case gn.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=re.PAN}break;default:this.state=re.NONE}this.state!==re.NONE&&this.dispatchEvent(lh)}function p0(n){switch(this.state){case re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function m0(n){this.enabled===!1||this.enableZoom===!1||this.state!==re.NONE||(n.preventDefault(),this.dispatchEvent(lh),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent($d))}function g0(n){this.enabled!==!1&&this._handleKeyDown(n)}function _0(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case _n.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(n),this.state=re.TOUCH_ROTATE;break;case _n.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(n),this.state=re.TOUCH_PAN;break;default:this.state=re.NONE}break;case 2:switch(this.touches.TWO){case _n.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=re.TOUCH_DOLLY_PAN;break;case _n.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=re.TOUCH_DOLLY_ROTATE;break;default:this.state=re.NONE}break;default:this.state=re.NONE}this.state!==re.NONE&&this.dispatchEvent(lh)}function v0(n){switch(this._trackPointer(n),this.state){case re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=re.NONE}}function y0(n){this.enabled!==!1&&n.preventDefault()}function x0(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function b0(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Zd(){let n=document.createElement("canvas");n.width=n.height=64;let t=n.getContext("2d");return t.fillStyle="#fff",t.beginPath(),t.arc(32,32,30,0,7),t.fill(),new pr(n)}function mi(n){return new be().setAttribute("position",new ye(n,3))}function Kd(n){let t=[0,1,0,2,0,3,0,4,1,2,2,3,3,4,4,1],e=n.length/15,i=new Float32Array(e*t.length*3);for(let s=0;s<e;s++)t.forEach((r,o)=>{let a=15*s+3*r;i.set(n.subarray(a,a+3),3*(s*t.length+o))});return i}function jd(n){let t=new dr(new vr(1,16,12),new yr({color:11883306,transparent:!0,opacity:.45,depthWrite:!1}),n);return t.frustumCulled=!1,t}function Jd(n,t,e,i,s){let r=new ae;for(let o=0;o<e.length;o++){let a=i.subarray(9*o,9*o+9),l=3*e[o];r.set(a[0]*s,a[3]*s,a[6]*s,t[l],a[1]*s,a[4]*s,a[7]*s,t[l+1],a[2]*s,a[5]*s,a[8]*s,t[l+2],0,0,0,1),n.setMatrixAt(o,r)}n.instanceMatrix.needsUpdate=!0}function ch(n,t,e,i,s,r=9,o=()=>!0){let a=new ae().multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse).elements,l=null,c=r*r;for(let h=0;h<n.length;h+=t){let u=n[h],d=n[h+1],m=n[h+2],v=a[3]*u+a[7]*d+a[11]*m+a[15];if(v<=0)continue;let w=((a[0]*u+a[4]*d+a[8]*m+a[12])/v+1)/2*i.width-s[0],g=(1-(a[1]*u+a[5]*d+a[9]*m+a[13])/v)/2*i.height-s[1],f=w*w+g*g;f<c&&o(u,d,m)&&(c=f,l=h/t)}return l}var dl=class{constructor(t,e){this.boxes=new Map;this.select=p("select",{id:"space-colour"},...we(["role","rays","sigma","w","redundancy","residual"],t=>x("studio_space.colouring",{by:t})));this.scale=p("input",{type:"range",id:"ellipsoid-scale",min:-20,max:20,value:0});this.scaleWords=p("output",{for:"ellipsoid-scale"});this.typicalSize=1;let i=(s,r)=>{let o=p("input",{type:"checkbox",id:`show-${s}`,checked:r});return o.addEventListener("change",t),this.boxes.set(s,o),p("label",{},o,x("studio_space.shown",{name:s}))};this.select.addEventListener("change",t),this.scale.addEventListener("input",()=>{this.showScale(),t()}),this.parts=[p("label",{},x("studio_space.colour"),this.select),i("points",!0),i("stations",!0),i("bars",!0),i("ellipsoids",!1),p("label",{title:x("studio_space.enlargement")},"\xD7",this.scale,this.scaleWords),Bt("studio_space.all",e)]}shows(t){return this.boxes.get(t).checked}get colouring(){return this.select.value}set typical(t){this.typicalSize=t,this.showScale()}get enlarged(){return this.typicalSize*10**(Number(this.scale.value)/10)}showScale(){this.scaleWords.textContent=gi(String(Number(this.enlarged.toPrecision(2))))}};var M0={f4:Float32Array,u1:Uint8Array,u2:Uint16Array,u4:Uint32Array},fl=class{constructor(t){this.rows=null;let e=new DataView(t).getUint32(0,!0);this.head=JSON.parse(new TextDecoder().decode(new Uint8Array(t,4,e)));let i=new Map,s=4+e;for(let{name:o,kind:a,shape:l}of this.head.arrays){let c=M0[a],h=l.reduce((u,d)=>u*d,1);i.set(o,new c(t,s,h)),s+=Math.ceil(h*c.BYTES_PER_ELEMENT/4)*4}let r=(o,a)=>i.get(o)??a;this.xyz=r("xyz",new Float32Array(0)),this.role=r("role",new Uint8Array(0)),this.rays=r("rays",new Uint16Array(0)),this.sigma=r("sigma",new Float32Array(0)),this.w=r("w",new Float32Array(0)),this.r=r("r",new Float32Array(0)),this.v=r("v",new Float32Array(0)),this.centre=r("centre",new Float32Array(0)),this.ellipsoid=r("ellipsoid_of",new Uint32Array(0)),this.axes=r("ellipsoid",new Float32Array(0)),this.bars=r("bars",new Uint32Array(0)),this.pairs=r("pair",new Uint32Array(0)),this.common=r("common",new Uint32Array(0)),this.frusta=this.pyramids(r("frustum",new Float32Array(0)))}pyramids(t){let e=new Float32Array(5*this.centre.length);for(let i=0;i<this.centre.length/3;i++)e.set(this.centre.subarray(3*i,3*i+3),15*i),e.set(t.subarray(12*i,12*i+12),15*i+3);return e}get points(){return this.role.length}nameOf(t){return this.head.names[t]??""}rowOf(t){return this.rows??=new Map(this.head.names.map((e,i)=>[e,i])),this.rows.get(t)}centreOf(t){let e=this.head.image_ids.indexOf(t);return e<0?null:this.centre.subarray(3*e,3*e+3)}at(t){return this.xyz.subarray(3*t,3*t+3)}};var w0=["","coordinates","distance","angle","area","length","plane","line","to_plane","to_line"],hh=6,Qd=n=>x("studio_space.quantity",{kind:n||"any"}),pl=class{constructor(t,e){this.changed=e;this.names=[];this.words="";this.box=p("input",{type:"checkbox",id:"space-measure"});this.kind=p("select",{id:"space-kind","aria-label":x("studio_space.measured")},...we(w0,Qd));this.turn=0;this.box.addEventListener("change",()=>this.clear()),this.kind.addEventListener("change",()=>void this.answer()),this.parts=[p("span",{class:"group"},p("label",{title:Fe("studio_space.measure")},this.box,x("studio_space.measure")),this.kind,Bt("studio_space.add_current",()=>t.current&&this.add(t.current)),Bt("studio_space.clear",()=>this.clear()))]}get on(){return this.box.checked}get closed(){return this.what==="area"}get what(){let t=this.names.length;return this.kind.value||(t===1?"coordinates":t===2?"distance":t===3?"angle":"area")}take(t){this.names.some(e=>t.rowOf(e)===void 0)&&this.clear()}add(t){this.names=this.names.includes(t)?this.names.filter(e=>e!==t):[...this.names,t],this.answer()}clear(){this.names=[],this.words=this.on?x("studio_space.click_points"):x("studio_space.click"),this.changed()}async answer(){let t=++this.turn;if(this.words=this.names.join(", "),this.changed(),!!this.names.length){try{let e=await Ot("/api/query",{kind:this.what,points:this.names});if(t!==this.turn)return;let i=e.values.map(({name:r,value:o,sigma:a,unit:l})=>{let c=`${Ct(o,si(a))} \xB1 ${Ct(a,si(a))}`;return`${e.values.length>1?`${r} `:""}${Te(c,l.replace("^2","\xB2").replace("deg","\xB0"))}`}),s=i.length>hh?` (+${i.length-hh})`:"";this.words=`${Qd(this.what)} ${this.names.join(", ")}: ${i.slice(0,hh).join("; ")}${s}${e.remark?`
${e.remark}`:""}`}catch(e){if(t!==this.turn)return;this.words=`${this.names.join(", ")}: ${e.message}`}this.changed()}}};var tf=100,ef=["#882255","#ddaa33","#0072b2"],ml=class{constructor(t){this.changed=t;this.lines=new Ji(new be,new Ei({vertexColors:!0}));this.box=p("input",{type:"checkbox",id:"show-pairs"});this.least=p("input",{type:"range",id:"pairs-least",min:0,max:tf,value:0,"aria-label":x("studio_space.fewest")});this.words=p("output",{for:"pairs-least"});this.data=null;for(let e of[this.box,this.least])e.addEventListener("input",()=>this.show());this.parts=[p("span",{class:"group"},p("label",{title:Fe("studio_space.pairs")},this.box,x("studio_space.pairs")),this.least,this.words)],this.lines.frustumCulled=!1,this.showFewest()}take(t){this.data=t;let{pairs:e,common:i,centre:s,head:r}=t,o=new Float32Array(3*e.length),a=new Float32Array(3*e.length),l=ef.map(c=>new Nt(c));e.forEach((c,h)=>{let u=i[h>>1];o.set(s.subarray(3*c,3*c+3),3*h),l[u<r.few?0:u<r.strong?1:2].toArray(a,3*h)}),this.lines.geometry.dispose(),this.lines.geometry=mi(o).setAttribute("color",new ye(a,3)),this.show()}get legend(){if(!this.box.checked||!this.data)return[];let{few:t,strong:e}=this.data.head,i=[0,0,0];for(let r=0;r<this.drawn;r++)i[this.data.common[r]<t?0:this.data.common[r]<e?1:2]++;let s=[x("studio_space.weak_pairs",{limit:t}),`${t}\u2013${e-1}`,`\u2265 ${e}`];return ef.map((r,o)=>[r,`${s[o]}: ${Pi(i[o])}`])}get fewest(){return Math.round(Math.max(this.data?.common[0]??1,1)**(Number(this.least.value)/tf))}get drawn(){let{common:t}=this.data,[e,i]=[0,t.length];for(;e<i;){let s=e+i>>1;t[s]>=this.fewest?e=s+1:i=s}return e}show(){this.lines.visible=this.box.checked,this.data&&this.lines.geometry.setDrawRange(0,2*this.drawn),this.showFewest(),this.changed()}showFewest(){this.words.textContent=`\u2265 ${Pi(this.fewest)}`,this.least.setAttribute("aria-valuetext",String(this.fewest))}};var gl=["#4f7896","#d55e00","#007f5f"],Ir=["#20406e","#2f86b0","#7fb79a","#e69f00","#c2410c"],nf="#9aa3ab";function rf(n,t){return t==="role"?S0(n):t==="rays"?Lr(n.rays,[2,3,5,9],[...Ir].reverse(),[x("studio_space.few_rays"),"3","4\u20135","6\u20139","\u2265 10"]):t==="w"?Lr(n.w,[1,2,2.6,3.3],Ir,uh(t,"",["1","2","2.6","3.3"])):t==="redundancy"?Lr(n.r,[.1,.3,.5,.7],[...Ir].reverse(),uh(t,"",["0.1","0.3","0.5","0.7"])):t==="residual"?sf(n.v,t,"px"):sf(n.sigma,t,n.head.unit)}function S0(n){let t=dh(gl),e=new Uint32Array(n.points);for(let s=0;s<n.points;s++)e[s]=t[Math.min(n.role[s],2)];let i=["tie","control","check"];return{rgb:new Uint8Array(e.buffer),legend:i.map((s,r)=>[gl[r],x("studio_space.role",{role:s})]).filter((s,r)=>n.role.includes(r))}}function sf(n,t,e){let i=n.filter(r=>r>0).sort();if(!i.length)return Lr(n,[0,0,0,0],Ir,[]);let s=[.2,.4,.6,.8].map(r=>i[Math.floor(r*(i.length-1))]);return Lr(n,s,Ir,uh(t,e,s.map(r=>Et(r,2))))}function uh(n,t,e){let i=e.map(s=>Te(gi(s),t));return[x("studio_space.up_to",{by:n,limit:i[0]}),...i.slice(1).map(s=>`\u2264 ${s}`),`> ${i[3]}`]}function Lr(n,t,e,i){let s=dh(e),[r]=dh([nf]),o=new Uint32Array(n.length),a=!1;for(let c=0;c<n.length;c++){let h=n[c];h>=0||(a=!0);let u=0;for(;u<t.length&&h>t[u];)u++;o[c]=h>=0?s[u]:r}let l=i.map((c,h)=>[e[h],c]);return{rgb:new Uint8Array(o.buffer),legend:a?[...l,[nf,x("studio_space.unknown")]]:l}}function dh(n){let t=new Uint8Array(4*n.length).fill(255);return n.forEach((e,i)=>{let{r:s,g:r,b:o}=new Nt(e);t.set([s,r,o].map(a=>Math.round(255*a)),4*i)}),new Uint32Array(t.buffer)}var _l=class{constructor(t,e){this.data=t;this.scene=new hr;this.specialRows=[];let i=Zd(),s=(l,c={vertexColors:!0})=>new On({size:l*Math.min(devicePixelRatio,2),map:i,alphaTest:.4,sizeAttenuation:!1,...c});for(let l=0;l<t.points;l++)t.role[l]>0&&this.specialRows.push(l);let r=t.points>6e4,o=new On({size:2*Math.min(devicePixelRatio,2),sizeAttenuation:!1,vertexColors:!0});this.points=new Fi(mi(t.xyz),r?o:s(4)),this.points.geometry.setIndex(new ye(E0(t.points),1)),this.special=new Fi(mi(this.picked(t.xyz)),s(11)),this.stations=new Ji(mi(Kd(t.frusta)),new Ei({color:2767433})),this.ellipsoids=jd(t.ellipsoid.length),this.bars=new Ji(mi(this.rowsOf(t.bars)),new Ei({color:32607,linewidth:2})),this.rays=new Ji(new be,new Ei({color:5974662})),this.mark=new Fi(new be,s(14,{color:13385103,depthTest:!1})),this.measured=new Fn(new be,new Ei({color:1118481,depthTest:!1})),this.ends=new Fi(new be,s(10,{color:1118481,depthTest:!1})),this.beyond=new Fi(new be,s(8,{color:12720271,depthTest:!1}));for(let l of[this.rays,this.mark,this.measured,this.ends,this.beyond])l.frustumCulled=!1;this.scene.background=new Nt(16250352),this.scene.add(new br(16777215,10129280,3),this.points,this.special,this.stations,this.ellipsoids,this.bars,this.rays,this.mark,this.measured,this.ends,this.beyond,e);let a=t.sigma.filter(l=>l>0).sort();this.typical=a.length?.012*t.head.extent/a[Math.floor(a.length/2)]:1,this.enlarge(this.typical)}picked(t){let e=new Float32Array(3*this.specialRows.length);return this.specialRows.forEach((i,s)=>e.set(t.subarray(3*i,3*i+3),3*s)),e}rowsOf(t){let e=new Float32Array(3*t.length);return t.forEach((i,s)=>e.set(this.data.at(i),3*s)),e}thin(t){this.points.geometry.setDrawRange(0,t<1?Math.ceil(t*this.data.points):1/0),this.ellipsoids.count=Math.ceil(t*this.data.ellipsoid.length)}colour(t){let{rgb:e,legend:i}=rf(this.data,t);this.points.geometry.setAttribute("color",new ye(e,4,!0));let s=new Float32Array(3*this.specialRows.length),r=gl.map(o=>new Nt(o));return this.specialRows.forEach((o,a)=>r[Math.min(this.data.role[o],2)].toArray(s,3*a)),this.special.geometry.setAttribute("color",new ye(s,3)),i}enlarge(t){Jd(this.ellipsoids,this.data.xyz,this.data.ellipsoid,this.data.axes,t)}current(t,e){this.mark.geometry.dispose(),this.rays.geometry.dispose(),this.mark.geometry=t?mi(new Float32Array(t)):new be;let i=t?e.map(r=>this.data.centreOf(r)).filter(r=>r!==null):[],s=new Float32Array(6*i.length);i.forEach((r,o)=>{s.set(Array.from(t),6*o),s.set(r,6*o+3)}),this.rays.geometry=mi(s)}cut(t){for(let e of[this.points,this.special,this.ellipsoids,this.bars])e.material.clippingPlanes=t}far(t){this.beyond.geometry.dispose(),this.beyond.geometry=mi(this.rowsOf(Uint32Array.from(t)))}between(t,e){let i=e&&t.length>2?[...t,t[0]]:t;this.measured.geometry.dispose(),this.ends.geometry.dispose(),this.measured.geometry=mi(this.rowsOf(Uint32Array.from(i))),this.ends.geometry=mi(this.rowsOf(Uint32Array.from(t)))}dispose(){this.scene.traverse(t=>{(t instanceof Fi||t instanceof Fn||t instanceof We)&&(t.geometry.dispose(),t.material.dispose())})}};function E0(n){let t=new Uint32Array(n);for(let i=0;i<n;i++)t[i]=i;let e=1;for(let i=n-1;i>0;i--){e=Math.imul(e,1664525)+1013904223>>>0;let s=Math.floor(e/4294967296*(i+1));[t[i],t[s]]=[t[s],t[i]]}return t}var xn=200,T0={"":"none",0:"side",1:"front",2:"level",points:"points"},vl=class{constructor(t,e){this.names=t;this.changed=e;this.across=p("select",{id:"section-across"},...we(["","0","1","2","points"],t=>x("studio_space.across",{across:T0[t]})));this.place=p("input",{type:"range",id:"section-place",min:0,max:xn,value:xn/2,"aria-label":x("studio_space.section_place")});this.thick=p("input",{type:"range",id:"section-thickness",min:1,max:xn,value:xn/10,"aria-label":x("studio_space.section_thickness")});this.words=p("output",{for:"section-place section-thickness"});this.data=null;this.normal=new F;this.range=[0,0];this.begin=0;this.across.addEventListener("change",()=>this.turn());for(let i of[this.place,this.thick])i.addEventListener("input",()=>this.changed());this.parts=[p("span",{class:"group"},p("label",{title:Fe("studio_space.section")},x("studio_space.section"),this.across),p("label",{title:x("studio_space.section_place")},"\u2194",this.place),p("label",{title:x("studio_space.section_thickness")},"\u2195",this.thick),this.words)],this.place.disabled=this.thick.disabled=!0}take(t){this.data=t,this.turn()}get planes(){if(!this.on)return[];let{middle:t,half:e}=this;return[new $e(this.normal.clone(),e-t),new $e(this.normal.clone().negate(),e+t)]}measured(){this.across.value==="points"&&!this.on&&this.turn()}holds(t,e,i){return this.on?Math.abs(this.normal.x*t+this.normal.y*e+this.normal.z*i-this.middle)<=this.half:!0}show(){let t=`\xB1 ${Te(Et(this.half),this.data?.head.unit??"")}`;this.words.textContent=this.across.value?this.on?t:x("studio_space.three_points_first"):""}get on(){return this.across.value!==""&&this.normal.lengthSq()>0}get middle(){let[t,e]=this.range;return t+(e-t)*Number(this.place.value)/xn}get half(){let[t,e]=this.range;return Math.max(e-t,1e-12)*Number(this.thick.value)/xn/2}turn(){let t=this.across.value;for(let e of[this.place,this.thick])e.disabled=!t;this.normal.set(0,0,0),this.data&&t==="points"?this.throughPoints(this.data):this.data&&t&&this.normal.set(...this.data.head.basis.slice(3*Number(t),3*Number(t)+3)),this.data&&this.on&&this.ranged(this.data),this.changed()}throughPoints(t){let e=this.names().slice(0,3).map(i=>t.rowOf(i)).filter(i=>i!==void 0).map(i=>new F(...t.at(i)));if(!(e.length<3)){if(this.normal.crossVectors(e[1].clone().sub(e[0]),e[2].clone().sub(e[0])),this.normal.length()<1e-9*t.head.extent**2)return void this.normal.set(0,0,0);this.normal.normalize(),this.begin=this.normal.dot(e[0])}}ranged(t){let e=Math.max(Math.floor(t.points/2e4),1),i=[];for(let a=0;a<t.points;a+=e){let[l,c,h]=t.at(a);i.push(this.normal.x*l+this.normal.y*c+this.normal.z*h)}if(i.sort((a,l)=>a-l),this.range=i.length?[i[Math.floor(.01*i.length)],i[Math.ceil(.99*i.length)-1]]:[0,0],this.across.value!=="points")return;let[s,r]=this.range,o=Math.max(r-this.begin,this.begin-s,1e-9*t.head.extent);this.range=[this.begin-o,this.begin+o],this.place.value=String(xn/2),this.thick.value=String(xn/40)}};var of=10,A0=33,R0=3e4,C0=15e5;function P0(){let n=document.createElement("canvas").getContext("webgl2"),t=n?.getExtension("WEBGL_debug_renderer_info"),e=n?String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)):"";return n?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(e)}var yl=class{constructor(t,e){this.model=t;this.open=e;this.box=ot("space");this.status=ot("space-status");this.tip=p("div",{class:"tip",hidden:!0});this.renderer=null;this.camera=new Ve(40,1,.01,1e3);this.drawn=null;this.stale=!0;this.frameSoon=Gi(()=>this.frame());this.share=1;this.software=!1;this.coarse=!1;this.turning=!1;this.timed=!1;this.rest=Oe(()=>this.still(),250);this.bar=new dl(()=>this.shown(),()=>this.home()),this.measure=new pl(t,()=>this.measured()),this.pairs=new ml(()=>this.shown()),this.section=new vl(()=>this.measure.names,()=>this.cut()),ot("space-bar").append(...this.bar.parts,...this.measure.parts,...this.pairs.parts,...this.section.parts),t.on("read",()=>{this.stale=!0,ot("stage-space").hidden||this.show()}),Qe.onchange(()=>this.far()),t.on(["current","prediction","state"],()=>this.current())}async show(){if(!(!this.renderer&&!this.begin())){if(this.stale){this.stale=!1;try{this.take(new fl(await Hr("/api/scene")))}catch(t){return this.stale=!0,this.model.fail(t)}}this.sized()}}begin(){this.software=P0();try{this.renderer=new ll({antialias:!this.software})}catch{return this.box.textContent=x("studio_space.no_graphics"),!1}this.renderer.localClippingEnabled=!0;let t=this.renderer.domElement;return t.tabIndex=0,t.setAttribute("role","application"),t.setAttribute("aria-label",x("studio_space.canvas")),this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.box.append(t,this.tip),this.controls=new ul(this.camera,t),this.controls.zoomToCursor=!0,this.controls.addEventListener("change",()=>this.moving()),new ResizeObserver(()=>this.sized()).observe(this.box),this.pointers(t),!0}take(t){let e=!this.drawn;this.drawn?.dispose(),this.drawn=new _l(t,this.pairs.lines),this.measure.take(t),this.pairs.take(t),this.section.take(t);let{extent:i}=t.head;this.camera.near=i/1e3,this.camera.far=i*200,this.bar.typical=this.drawn.typical,e&&(this.share=this.software?Math.min(R0/Math.max(t.points,1),1):1),e&&this.home(),this.shown(),this.current(),this.far(),this.status.textContent=t.points<t.head.total?x("studio_space.points_shown",{n:t.points,of:t.head.total}):x("studio_space.click")}axis(t){return new F(...this.drawn.data.head.basis.slice(3*t,3*t+3))}home(){if(!this.drawn)return;let{extent:t}=this.drawn.data.head;this.camera.up.copy(this.axis(2)),this.camera.position.set(0,0,0).addScaledVector(this.axis(1),1.35*t).addScaledVector(this.axis(2),.45*t).addScaledVector(this.axis(0),.4*t),this.controls.target.set(0,0,0),this.controls.update(),this.render()}sized(){let{clientWidth:t,clientHeight:e}=this.box;!this.renderer||!t||!e||(this.renderer.setSize(t,e),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.frame())}render(){this.share<1&&(this.drawn?.thin(this.share),this.rest()),this.frameSoon()}frame(){!this.renderer||!this.drawn||ot("stage-space").hidden||(this.renderer.render(this.drawn.scene,this.camera),this.turning&&this.timing())}moving(){let t=this.box.clientWidth*this.box.clientHeight>C0;this.software&&t&&!this.coarse&&this.fine(!1),this.turning=!0,this.render(),this.rest()}timing(){let t=this.renderer.getContext(),e=t.fenceSync(t.SYNC_GPU_COMMANDS_COMPLETE,0);if(!e)return;if(this.timed)return t.deleteSync(e);this.timed=!0;let i=performance.now();t.flush();let s=()=>{if(t.getSyncParameter(e,t.SYNC_STATUS)!==t.SIGNALED)return void setTimeout(s,4);t.deleteSync(e),this.timed=!1;let r=A0/Math.max(performance.now()-i,1);this.share=Math.min(Math.max(this.share*Math.min(Math.max(r,.25),1.25),.005),1)};setTimeout(s,4)}fine(t){this.coarse=!t,this.renderer.setPixelRatio(t?Math.min(devicePixelRatio,2):.5)}still(){this.turning=!1,this.drawn?.thin(1),this.coarse&&this.fine(!0),this.frameSoon()}shown(){let{drawn:t,bar:e}=this;if(!t)return;let i=t.colour(e.colouring);t.points.visible=e.shows("points"),t.stations.visible=e.shows("stations"),t.ellipsoids.visible=e.shows("ellipsoids"),t.bars.visible=e.shows("bars"),t.ellipsoids.visible&&t.enlarge(e.enlarged),i.push(...this.pairs.legend),Qe.points.size&&i.push(["#c2188f",x("studio_space.beyond",{n:Qe.points.size})]),ot("space-legend").replaceChildren(...i.map(([s,r])=>{let o=p("span",{class:"dot"});return o.style.background=s,p("li",{},o,r)})),this.render()}cut(){this.section.show(),this.drawn?.cut(this.section.planes),this.render()}current(){let{drawn:t,model:e}=this;if(!t)return;let i=t.data.rowOf(e.current),s=e.prediction?.point===e.current?e.prediction?.located.xyz:null,r=s?s.map((o,a)=>o-t.data.head.origin[a]):i===void 0?null:t.data.at(i);t.current(e.current?r:null,e.marksOf(e.current).map(o=>o.image)),this.render()}far(){this.drawn&&(this.drawn.far([...Qe.points].map(t=>this.drawn.data.rowOf(t)).filter(t=>t!==void 0)),this.shown())}measured(){if(!this.drawn)return;let t=this.measure.names.map(e=>this.drawn.data.rowOf(e)).filter(e=>e!==void 0);this.drawn.between(t,this.measure.closed),this.section.measured(),this.measure.words&&(this.status.textContent=this.measure.words),this.render()}pointers(t){let e=[0,0],i=!1,s=a=>{let l=t.getBoundingClientRect();return[a.clientX-l.left,a.clientY-l.top]};t.addEventListener("pointerdown",a=>{e=[a.clientX,a.clientY],i=!0,this.tip.hidden=!0}),t.addEventListener("pointerup",a=>{i=!1,Math.hypot(a.clientX-e[0],a.clientY-e[1])<4&&this.click(s(a))});let r=[0,0],o=Gi(()=>this.hover(r));t.addEventListener("pointermove",a=>{r=s(a),i||o()}),t.addEventListener("pointerleave",()=>this.tip.hidden=!0),t.addEventListener("keydown",a=>this.key(a))}find(t){let{drawn:e,box:i}=this;if(!e)return{};let s={width:i.clientWidth,height:i.clientHeight},r=(l,c,h)=>this.section.holds(l,c,h),o=e.stations.visible?ch(e.data.centre,3,this.camera,s,t,of):null;if(o!==null)return{image:e.data.head.image_ids[o]};let a=e.points.visible?ch(e.data.xyz,3,this.camera,s,t,of,r):null;return a===null?{}:{row:a}}hover(t){let{image:e,row:i}=this.find(t);this.tip.hidden=e===void 0&&i===void 0,!this.tip.hidden&&(this.tip.textContent=e??this.words(i),this.tip.style.left=`${Math.min(t[0]+16,this.box.clientWidth-230)}px`,this.tip.style.top=`${Math.min(t[1]+14,this.box.clientHeight-70)}px`)}words(t){let{data:e}=this.drawn,i=e.head.unit;return x("studio_space.point",{name:e.nameOf(t)||"none",n:e.rays[t],sigma:e.sigma[t]>0?Te(Et(e.sigma[t],2),i):"none",w:e.w[t]>=0?Et(e.w[t],2):"none"})}click(t){let{image:e,row:i}=this.find(t);if(e!==void 0&&!this.measure.on)return this.open(e);if(i===void 0)return;let s=this.drawn.data.nameOf(i);s&&(this.measure.on?this.measure.add(s):(this.model.choose(s),this.status.textContent=this.words(i)))}key(t){let i={ArrowLeft:[1,0],ArrowRight:[-1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[t.key];if(i)this.turn(.1*i[0],.1*i[1]);else if(t.key==="+"||t.key==="=")this.closer(.85);else if(t.key==="-")this.closer(1.18);else if(t.key==="0")this.home();else return;t.preventDefault(),t.stopPropagation()}turn(t,e){let{target:i}=this.controls,s=this.camera.position.clone().sub(i),r=this.camera.up.clone().normalize();s.applyAxisAngle(r,-t);let o=r.clone().cross(s).normalize(),a=s.clone().applyAxisAngle(o,-e);a.clone().cross(r).length()>.05*a.length()&&s.copy(a),this.camera.position.copy(i).add(s),this.controls.update()}closer(t){let{target:e}=this.controls;this.camera.position.sub(e).multiplyScalar(t).add(e),this.controls.update()}};var xl=class{constructor(t,e){this.model=t;this.goTo=e;t.on("overview",()=>this.show())}show(){let{standing:t}=this.model.overview,e=t.oriented<t.images||t.wrong.length>0||t.words.length>0,i=ot("standing");if(i.hidden=!e,!e)return;let s=new Set(t.wrong.map(a=>a.words)),r=new Set(t.lacking.filter(a=>a.kind==="marks"&&!a.have).map(a=>a.words)),o=t.words.filter(a=>!s.has(a)&&!r.has(a));i.replaceChildren(p("p",{id:"standing-line",class:t.oriented<t.images?"open":""},t.line.join("; ")),p("ul",{},...t.wrong.map(a=>p("li",{class:"wrong"},jt(a.words,x("studio_point.show",{point:a.point}),()=>this.goTo(a.point,a.images[0]),"link"))),...o.map(a=>p("li",{},a))))}};var bl=class{constructor(t,e){this.model=t;this.undo=ot("undo");this.redo=ot("redo");this.adjust=ot("adjust");this.outcome="";this.progress=ot("progress");this.undo.addEventListener("click",()=>void e.undo()),this.redo.addEventListener("click",()=>void e.redo()),this.adjust.addEventListener("click",()=>void this.begin()),ot("stop").addEventListener("click",()=>void Ue("/api/stop",{})),t.on("state",()=>this.buttons()),t.on("message",()=>this.message()),t.on("overview",()=>this.names()),t.actions.onwaiting=(i,s)=>this.waiting(i,s)}buttons(){this.undo.disabled=!this.model.state.can_undo,this.redo.disabled=!this.model.state.can_redo}message(){let{code:t,words:e,kind:i}=this.model.message,s=ot("message");s.dataset.code=t,s.textContent=s.title=e,s.className=i;let r=ot("command");r.textContent=this.model.command}names(){let t=this.model.overview;ot("title").textContent=document.title=`${t.title} \u2013 studio`,ot("title").textContent=t.title||"raybundle studio";let e=[t.headline,t.sigma0===null?"":x("studio_page.sigma0",{sigma0:t.sigma0}),t.free_scale?x("studio_page.free_scale"):""],i=ot("headline");i.textContent=i.title=e.filter(s=>s).join(" \xB7 ")||x("studio_page.contents",{kind:t.kind,images:t.images.length,points:t.points}),i.className=t.grade,ot("report").hidden=!t.report}async begin(){try{let{begun:t}=await Ue("/api/adjust",{});t?this.model.say("studio_page.adjusting"):this.model.say("studio_page.busy")}catch(t){this.model.fail(t)}}pointer(t){ot("pointer").textContent=t}connection(t){let e=ot("connection");e.textContent=t?x("studio_page.connected"):x("studio_page.connection_lost"),e.className=t?"":"bad"}waiting(t,e){e&&(t?this.model.say("studio_page.actions_wait",{n:t},"bad"):this.model.show(""))}receive(t){t.type==="state"?this.model.take(t.state):t.type==="oriented"?this.model.read().catch(()=>{}):t.type==="progress"?(ot("work").hidden=!1,this.adjust.disabled=!0,this.progress.value=t.share,ot("work-stage").textContent=Ns(t.stage)):t.type==="run"?this.showRun(t.run):t.type==="targets"?this.showTargets(t):this.adjusted(t)}showTargets({images:t,error:e,code:i}){ot("work").hidden=!0,this.adjust.disabled=!1,e?this.model.show(e,"bad",i):this.model.say("studio_target.found_in",{n:t.length,image:t[0]??""},"good"),Se.forget(),this.model.emit("targets")}showRun(t){let e=this.outcome;this.outcome=t.outcome,this.model.run=t;let i=t.outcome==="running";if(ot("work").hidden=!i,this.adjust.disabled=i,this.progress.value=t.share,ot("work-stage").textContent=`${t.name}: ${Ns(t.step)}`,this.model.emit("run"),i||e===t.outcome)return;let s=t.words.split(`
`);t.outcome==="done"?this.model.show(s[0].trim(),"good"):t.outcome==="failed"?this.model.show(s[s.length-1],"bad"):this.model.say("studio_run.stopped"),t.outcome==="done"&&this.model.read().catch(()=>{})}async adjusted(t){if(ot("work").hidden=!0,this.adjust.disabled=!1,t.error)return this.model.show(t.error,"bad",t.code);await this.model.read(),this.showResult(t.folder)}showResult(t){this.model.say("studio_page.adjusted",{sigma0:this.model.overview.sigma0,folder:t||"none"},"good")}};var Hi=26,Cs=200,Dr=8e6,af={points:"/api/points",observations:"/api/table/observations",pairs:"/api/table/pairs"},lf={points:[["point",x("label.point"),n=>n.point],["role",x("label.role"),n=>x("studio_point.role",{role:n.role})],...["X","Y","Z"].map((n,t)=>[n,n,e=>Ct(e.xyz[t],si(e.sigma[t]))]),...["X","Y","Z"].map((n,t)=>[`s${n}`,x("label.sigma_of",{symbol:n}),e=>Ct(e.sigma[t],si(e.sigma[t]))]),["rays",x("label.rays"),n=>String(n.rays)],["w",x("studio_table.largest_w"),n=>Ct(n.w,2)]],observations:[["image",x("label.image"),n=>n.image],["point",x("label.point"),n=>n.point],["x",x("studio_table.x"),n=>Ct(n.x,2)],["y",x("studio_table.y"),n=>Ct(n.y,2)],["vx",x("studio_table.vx"),n=>Ct(n.vx,3)],["vy",x("studio_table.vy"),n=>Ct(n.vy,3)],["w",x("studio_table.w"),n=>Ct(n.w,2)],["r",x("studio_table.redundancy"),n=>Ct(n.r,2)],["",x("label.rejected"),n=>n.rejected]],pairs:[["image",x("label.image"),n=>n.image],["other",x("studio_table.other_image"),n=>n.other],["common",x("label.common_points"),n=>Pi(n.common)],["base",x("studio_table.base"),n=>Et(n.base,4)]]},Ml=class{constructor(t,e,i){this.isOpen=e;this.opened=i;this.kind="points";this.sort="";this.down=!1;this.total=0;this.at=-1;this.pages=new Map;this.turn=0;this.search=p("input",{type:"search",id:"table-search","aria-label":x("studio_table.filter"),placeholder:x("studio_table.filter"),autocomplete:"off",spellcheck:"false"});this.status=p("span",{class:"note","aria-live":"polite"});this.head=p("div",{role:"row",class:"head"});this.rows=p("div",{class:"rows"});this.tall=p("div",{class:"tall"},this.rows);this.scroll=p("div",{class:"scroll",tabindex:0,role:"rowgroup","aria-label":x("studio_table.rows")},this.tall);this.grid=p("div",{role:"table",class:"grid","aria-label":x("studio_table.table")},this.head,this.scroll);this.drawSoon=Gi(()=>this.draw());let s=p("select",{id:"table-kind","aria-label":x("studio_table.table")},...we(Object.keys(af),r=>x("studio_table.kind",{kind:r})));s.addEventListener("change",()=>this.of(s.value)),ot("table-bar").append(s,this.search,this.status),ot("table").append(this.grid),this.search.addEventListener("input",Oe(()=>this.begin(),200)),this.scroll.addEventListener("scroll",this.drawSoon),this.scroll.addEventListener("keydown",r=>this.key(r)),this.rows.addEventListener("click",r=>{let o=r.target.closest("[data-row]");o&&this.open(Number(o.dataset.row))}),new ResizeObserver(this.drawSoon).observe(this.scroll),t.on("read",()=>this.isOpen()&&this.begin())}show(){this.of(this.kind)}of(t){t!==this.kind&&([this.sort,this.down]=["",!1]),this.kind=t,this.grid.className=`grid ${t}`,this.begin()}heads(){this.head.replaceChildren(...lf[this.kind].map(([t,e])=>{let i=t&&t===this.sort,s=()=>{this.down=i?!this.down:["w","common","base"].includes(t)||t.startsWith("s"),this.sort=t,this.begin()},r=p("div",{role:"columnheader","aria-sort":i?this.down?"descending":"ascending":"none"});return r.append(t?p("button",{type:"button",title:x("studio_table.sort",{name:e}),onclick:s},`${e}${i?this.down?" \u25BC":" \u25B2":""}`):e),r}))}begin(){this.heads(),this.turn++,this.pages.clear(),this.at=-1,this.scroll.scrollTop=0,this.rows.replaceChildren(),this.load(0)}async load(t){if(this.pages.has(t))return;let{turn:e}=this;this.pages.set(t,null);try{let i=await Ot(af[this.kind],{sort:this.sort,down:this.down?1:0,search:this.search.value.trim(),offset:t*Cs,limit:Cs});if(e!==this.turn)return;this.pages.set(t,i.rows),this.total=i.total,this.status.textContent=x("studio_table.count",{n:i.total}),this.grid.setAttribute("aria-rowcount",String(i.total+1)),this.tall.style.height=`${Math.min(i.total*Hi,Dr)}px`}catch{e===this.turn&&this.pages.delete(t)}this.drawSoon()}get first(){let{scrollTop:t,clientHeight:e}=this.scroll;return this.total*Hi<=Dr?t/Hi:t/Math.max(Dr-e,1)*Math.max(this.total-e/Hi,0)}draw(){if(!this.isOpen()||!this.total)return void(this.total||this.rows.replaceChildren());let{first:t}=this,e=Math.ceil(this.scroll.clientHeight/Hi)+1,i=Math.floor(t);this.rows.style.transform=`translateY(${this.scroll.scrollTop-(t-i)*Hi}px)`;let s=[];for(let r=i;r<Math.min(i+e,this.total);r++){let o=Math.floor(r/Cs),a=this.pages.get(o)?.[r%Cs];a||this.load(o),s.push(this.row(r,a))}this.rows.replaceChildren(...s)}row(t,e){let i=lf[this.kind].map(([,,s])=>p("div",{role:"cell"},e?s(e):"\u2026"));return p("div",{role:"row","data-row":t,"aria-rowindex":t+2,class:t===this.at?"at":""},...i)}open(t){this.at=t;let e=this.pages.get(Math.floor(t/Cs))?.[t%Cs];this.draw(),e&&this.opened(e)}key(t){let e=Math.max(Math.floor(this.scroll.clientHeight/Hi)-1,1),i={ArrowDown:1,ArrowUp:-1,PageDown:e,PageUp:-e,Home:-this.total,End:this.total};if(t.key==="Enter"&&this.at>=0)this.open(this.at);else if(t.key in i)this.at=Math.min(Math.max(this.at+i[t.key],0),this.total-1),this.reveal();else return;t.preventDefault(),t.stopPropagation()}reveal(){let t=this.scroll.clientHeight/Hi,{first:e}=this,i=this.at<e?this.at:this.at+1>e+t?this.at+1-t:e,s=this.total*Hi,r=i/Math.max(this.total-t,1);this.scroll.scrollTop=s<=Dr?i*Hi:r*(Dr-this.scroll.clientHeight),this.draw()}},cf=n=>"other"in n,hf=n=>"xyz"in n;var Ur=["images","space","tables","decide","journal"],wl=class{constructor(){this.opened=new Map;this.now="images";Ur.forEach((t,e)=>{let i=ot(`tab-${t}`);i.addEventListener("click",()=>this.show(t)),i.addEventListener("keydown",s=>{let r={ArrowRight:1,ArrowLeft:-1}[s.key];if(!r)return;s.preventDefault();let o=Ur[(e+r+Ur.length)%Ur.length];this.show(o),ot(`tab-${o}`).focus()})})}onopen(t,e){this.opened.set(t,e)}show(t){this.now=t;for(let e of Ur){let i=ot(`tab-${e}`);i.setAttribute("aria-selected",String(e===t)),i.tabIndex=e===t?0:-1,ot(`stage-${e}`).hidden=e!==t}this.opened.get(t)?.()}};async function I0(){Dh();let n=new fo,t=new Tn(n),e=new bl(n,t),i=new wl,s=new lo(n,t,d=>e.pointer(d)),r=(d,m,v)=>{i.show("images"),s.visit(d,m,v)};new ro(n,(d,m)=>{i.show("images"),s.open(d,m).body.focus()});let o=new po(n,t,{visit:r});new xl(n,(d,m)=>{n.choose(d),o.goTo(d,m)}),new Qr(n),new to(n),new eo(n),new io(n),new no(n),new so(n),new ho(n,d=>{i.show("images"),(d?s.open(d):s.activePane)?.body.focus()});let a=new yl(n,d=>{i.show("images"),s.open(d)}),l=new Ml(n,()=>i.now==="tables",d=>{if(cf(d))return i.show("images"),s.open(d.image).body.focus(),void s.open(d.other,!0);n.choose(d.point),hf(d)||o.goTo(d.point,d.image)}),c=new co(n,()=>i.now==="journal"),h=new Jr(n,()=>i.now==="decide",{images:d=>{i.show("images"),d&&s.open(d).body.focus()},space:()=>i.show("space"),visit:(d,m)=>{n.choose(d),o.goTo(d,m)}});i.onopen("decide",()=>h.show()),i.onopen("space",()=>void a.show()),i.onopen("tables",()=>l.show()),i.onopen("journal",()=>void c.show()),ot("help").addEventListener("click",Yl);let u=d=>()=>{i.show("images"),d(),s.activePane?.body.focus()};Jh({"?":Yl,n:u(()=>void t.newPoint()),w:()=>void o.worst(),v:()=>o.visitNext(),"ctrl z":()=>void t.undo(),"ctrl shift z":()=>void t.redo(),"ctrl y":()=>void t.redo(),s:()=>o.nextSnap(),c:u(()=>s.centre()),escape:()=>L0(n,s),g:u(()=>s.setCount({1:2,2:4}[n.panes.length]??1)),"[":()=>s.step(-1),"]":()=>s.step(1),f2:()=>o.typeName()},d=>s.toggleLoupe(d),()=>Xt.loupe),await D0(n,e),s.activePane?.body.focus()}function L0(n,t){if(Zt.on)return Zt.end();document.activeElement!==t.activePane?.body?t.activePane?.body.focus():n.choose("")}async function D0(n,t){try{await n.read()}catch(s){throw n.fail(s),s}let e=()=>{n.overview.sigma0!==null&&!n.message.words&&t.showResult("")};e();let i=Oe(()=>void n.read().then(e).catch(()=>{}),100);Qh(s=>t.receive(s),(s,r)=>{t.connection(s),s&&(r||n.overview.sigma0===null)&&i()})}I0();})();
/*! @fluent/bundle: Copyright Mozilla Foundation and others, SPDX-License-Identifier: Apache-2.0 */
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2025 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
