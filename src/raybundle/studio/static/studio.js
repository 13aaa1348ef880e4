"use strict";(()=>{var Pi=class{constructor(t){this.value=t}valueOf(){return this.value}},he=class extends Pi{constructor(t="???"){super(t)}toString(t){return`{${this.value}}`}},Le=class extends Pi{constructor(t,e={}){super(t),this.opts=e}toString(t){if(t)try{return t.memoizeIntlObject(Intl.NumberFormat,this.opts).format(this.value)}catch(e){t.reportError(e)}return this.value.toString(10)}},Ii=class n extends Pi{static supportsValue(t){if(typeof t=="number"||t instanceof Date)return!0;if(t instanceof Pi)return n.supportsValue(t.valueOf());if("Temporal"in globalThis){let e=globalThis.Temporal;if(t instanceof e.Instant||t instanceof e.PlainDateTime||t instanceof e.PlainDate||t instanceof e.PlainMonthDay||t instanceof e.PlainTime||t instanceof e.PlainYearMonth)return!0}return!1}constructor(t,e={}){t instanceof n?(e={...t.opts,...e},t=t.value):t instanceof Pi&&(t=t.valueOf()),typeof t=="object"&&"calendarId"in t&&e.calendar===void 0&&(e={...e,calendar:t.calendarId}),super(t),this.opts=e}[Symbol.toPrimitive](t){return t==="string"?this.toString():this.toNumber()}toNumber(){let t=this.value;if(typeof t=="number")return t;if(t instanceof Date)return t.getTime();if("epochMilliseconds"in t)return t.epochMilliseconds;if("toZonedDateTime"in t)return t.toZonedDateTime("UTC").epochMilliseconds;throw new TypeError("Unwrapping a non-number value as a number")}toString(t){if(t)try{return t.memoizeIntlObject(Intl.DateTimeFormat,this.opts).format(this.value)}catch(e){t.reportError(e)}return typeof this.value=="number"||this.value instanceof Date?new Date(this.value).toISOString():this.value.toString()}};var Th=100,Pf="\u2068",If="\u2069";function Lf(n,t,e){if(e===t||e instanceof Le&&t instanceof Le&&e.value===t.value)return!0;if(t instanceof Le&&typeof e=="string"){let i=n.memoizeIntlObject(Intl.PluralRules,t.opts).select(t.value);if(e===i)return!0}return!1}function Ah(n,t,e){return t[e]?Zn(n,t[e].value):(n.reportError(new RangeError("No default")),new he)}function Il(n,t){let e=[],i=Object.create(null);for(let s of t)s.type==="narg"?i[s.name]=Us(n,s.value):e.push(Us(n,s));return{positional:e,named:i}}function Us(n,t){switch(t.type){case"str":return t.value;case"num":return new Le(t.value,{minimumFractionDigits:t.precision});case"var":return Df(n,t);case"mesg":return Uf(n,t);case"term":return Nf(n,t);case"func":return Ff(n,t);case"select":return Of(n,t);default:return new he}}function Df(n,{name:t}){let e;if(n.params)if(Object.prototype.hasOwnProperty.call(n.params,t))e=n.params[t];else return new he(`$${t}`);else if(n.args&&Object.prototype.hasOwnProperty.call(n.args,t))e=n.args[t];else return n.reportError(new ReferenceError(`Unknown variable: $${t}`)),new he(`$${t}`);if(e instanceof Pi)return e;switch(typeof e){case"string":return e;case"number":return new Le(e);case"object":if(Ii.supportsValue(e))return new Ii(e);default:return n.reportError(new TypeError(`Variable type not supported: $${t}, ${typeof e}`)),new he(`$${t}`)}}function Uf(n,{name:t,attr:e}){let i=n.bundle._messages.get(t);if(!i)return n.reportError(new ReferenceError(`Unknown message: ${t}`)),new he(t);if(e){let s=i.attributes[e];return s?Zn(n,s):(n.reportError(new ReferenceError(`Unknown attribute: ${e}`)),new he(`${t}.${e}`))}return i.value?Zn(n,i.value):(n.reportError(new ReferenceError(`No value: ${t}`)),new he(t))}function Nf(n,{name:t,attr:e,args:i}){let s=`-${t}`,r=n.bundle._terms.get(s);if(!r)return n.reportError(new ReferenceError(`Unknown term: ${s}`)),new he(s);if(e){let a=r.attributes[e];if(a){n.params=Il(n,i).named;let l=Zn(n,a);return n.params=null,l}return n.reportError(new ReferenceError(`Unknown attribute: ${e}`)),new he(`${s}.${e}`)}n.params=Il(n,i).named;let o=Zn(n,r.value);return n.params=null,o}function Ff(n,{name:t,args:e}){let i=n.bundle._functions[t];if(!i)return n.reportError(new ReferenceError(`Unknown function: ${t}()`)),new he(`${t}()`);if(typeof i!="function")return n.reportError(new TypeError(`Function ${t}() is not callable`)),new he(`${t}()`);try{let s=Il(n,e);return i(s.positional,s.named)}catch(s){return n.reportError(s),new he(`${t}()`)}}function Of(n,{selector:t,variants:e,star:i}){let s=Us(n,t);if(s instanceof he)return Ah(n,e,i);for(let r of e){let o=Us(n,r.key);if(Lf(n,s,o))return Zn(n,r.value)}return Ah(n,e,i)}function Ll(n,t){if(n.dirty.has(t))return n.reportError(new RangeError("Cyclic reference")),new he;n.dirty.add(t);let e=[],i=n.bundle._useIsolating&&t.length>1;for(let s of t){if(typeof s=="string"){e.push(n.bundle._transform(s));continue}if(n.placeables++,n.placeables>Th)throw n.dirty.delete(t),new RangeError(`Too many placeables expanded: ${n.placeables}, max allowed is ${Th}`);i&&e.push(Pf),e.push(Us(n,s).toString(n)),i&&e.push(If)}return n.dirty.delete(t),e.join("")}function Zn(n,t){return typeof t=="string"?n.bundle._transform(t):Ll(n,t)}var Br=class{constructor(t,e,i){this.dirty=new WeakSet,this.params=null,this.placeables=0,this.bundle=t,this.errors=e,this.args=i}reportError(t){if(!this.errors||!(t instanceof Error))throw t;this.errors.push(t)}memoizeIntlObject(t,e){let i=this.bundle._intls.get(t);i||(i={},this.bundle._intls.set(t,i));let s=JSON.stringify(e);return i[s]||(i[s]=new t(this.bundle.locales,e)),i[s]}};function Dl(n,t){let e=Object.create(null);for(let[i,s]of Object.entries(n))t.includes(i)&&(e[i]=s.valueOf());return e}var Rh=["unitDisplay","currencyDisplay","useGrouping","minimumIntegerDigits","minimumFractionDigits","maximumFractionDigits","minimumSignificantDigits","maximumSignificantDigits"];function Ch(n,t){let e=n[0];if(e instanceof he)return new he(`NUMBER(${e.valueOf()})`);if(e instanceof Le)return new Le(e.valueOf(),{...e.opts,...Dl(t,Rh)});if(e instanceof Ii)return new Le(e.toNumber(),{...Dl(t,Rh)});throw new TypeError("Invalid argument to NUMBER")}var kf=["dateStyle","timeStyle","fractionalSecondDigits","dayPeriod","hour12","weekday","era","year","month","day","hour","minute","second","timeZoneName"];function Ph(n,t){let e=n[0];if(e instanceof he)return new he(`DATETIME(${e.valueOf()})`);if(e instanceof Ii||e instanceof Le)return new Ii(e,Dl(t,kf));throw new TypeError("Invalid argument to DATETIME")}var Ih=new Map;function Lh(n){let t=Array.isArray(n)?n.join(" "):n,e=Ih.get(t);return e===void 0&&(e=new Map,Ih.set(t,e)),e}var Ns=class{constructor(t,{functions:e,useIsolating:i=!0,transform:s=r=>r}={}){this._terms=new Map,this._messages=new Map,this.locales=Array.isArray(t)?t:[t],this._functions={NUMBER:Ch,DATETIME:Ph,...e},this._useIsolating=i,this._transform=s,this._intls=Lh(t)}hasMessage(t){return this._messages.has(t)}getMessage(t){return this._messages.get(t)}addResource(t,{allowOverrides:e=!1}={}){let i=[];for(let s=0;s<t.body.length;s++){let r=t.body[s];if(r.id.startsWith("-")){if(e===!1&&this._terms.has(r.id)){i.push(new Error(`Attempt to override an existing term: "${r.id}"`));continue}this._terms.set(r.id,r)}else{if(e===!1&&this._messages.has(r.id)){i.push(new Error(`Attempt to override an existing message: "${r.id}"`));continue}this._messages.set(r.id,r)}}return i}formatPattern(t,e=null,i=null){if(typeof t=="string")return this._transform(t);let s=new Br(this,i,e);try{return Ll(s,t).toString(s)}catch(r){if(s.errors&&r instanceof Error)return s.errors.push(r),new he().toString(s);throw r}}};var Ul=/^(-?[a-zA-Z][\w-]*) *= */gm,Dh=/\.([a-zA-Z][\w-]*) *= */y,Bf=/\*?\[/y,Nl=/(-?[0-9]+(?:\.([0-9]+))?)/y,zf=/([a-zA-Z][\w-]*)/y,Uh=/([$-])?([a-zA-Z][\w-]*)(?:\.([a-zA-Z][\w-]*))?/y,Hf=/^[A-Z][A-Z0-9_-]*$/,zr=/([^{}\n\r]+)/y,Vf=/([^\\"\n\r]*)/y,Nh=/\\([\\"])/y,Fh=/\\u([a-fA-F0-9]{4})|\\U([a-fA-F0-9]{6})/y,Gf=/^\n+/,Oh=/ +$/,Wf=/ *\r?\n/g,Xf=/( *)$/,qf=/{\s*/y,kh=/\s*}/y,Yf=/\[\s*/y,$f=/\s*] */y,Zf=/\s*\(\s*/y,Kf=/\s*->\s*/y,jf=/\s*:\s*/y,Jf=/\s*,?\s*/y,Qf=/\s+/y,Fs=class{constructor(t){this.body=[],Ul.lastIndex=0;let e=0;for(;;){let x=Ul.exec(t);if(x===null)break;e=Ul.lastIndex;try{this.body.push(l(x[1]))}catch(b){if(b instanceof SyntaxError)continue;throw b}}function i(x){return x.lastIndex=e,x.test(t)}function s(x,b){if(t[e]===x)return e++,!0;if(b)throw new b(`Expected ${x}`);return!1}function r(x,b){if(i(x))return e=x.lastIndex,!0;if(b)throw new b(`Expected ${x.toString()}`);return!1}function o(x){x.lastIndex=e;let b=x.exec(t);if(b===null)throw new SyntaxError(`Expected ${x.toString()}`);return e=x.lastIndex,b}function a(x){return o(x)[1]}function l(x){let b=h(),C=c();if(b===null&&Object.keys(C).length===0)throw new SyntaxError("Expected message value or attributes");return{id:x,value:b,attributes:C}}function c(){let x=Object.create(null);for(;i(Dh);){let b=a(Dh),C=h();if(C===null)throw new SyntaxError("Expected attribute value");x[b]=C}return x}function h(){let x;if(i(zr)&&(x=a(zr)),t[e]==="{"||t[e]==="}")return u(x?[x]:[],1/0);let b=P();return b?x?u([x,b],b.length):(b.value=D(b.value,Gf),u([b],b.length)):x?D(x,Oh):null}function u(x=[],b){for(;;){if(i(zr)){x.push(a(zr));continue}if(t[e]==="{"){x.push(f());continue}if(t[e]==="}")throw new SyntaxError("Unbalanced closing brace");let X=P();if(X){x.push(X),b=Math.min(b,X.length);continue}break}let C=x.length-1,B=x[C];typeof B=="string"&&(x[C]=D(B,Oh));let V=[];for(let X of x)X instanceof Hr&&(X=X.value.slice(0,X.value.length-b)),X&&V.push(X);return V}function f(){r(qf,SyntaxError);let x=m();if(r(kh))return x;if(r(Kf)){let b=g();return r(kh,SyntaxError),{type:"select",selector:x,...b}}throw new SyntaxError("Unclosed placeable")}function m(){if(t[e]==="{")return f();if(i(Uh)){let[,x,b,C=null]=o(Uh);if(x==="$")return{type:"var",name:b};if(r(Zf)){let B=v();if(x==="-")return{type:"term",name:b,attr:C,args:B};if(Hf.test(b))return{type:"func",name:b,args:B};throw new SyntaxError("Function names must be all upper-case")}return x==="-"?{type:"term",name:b,attr:C,args:[]}:{type:"mesg",name:b,attr:C}}return R()}function v(){let x=[];for(;;){switch(t[e]){case")":return e++,x;case void 0:throw new SyntaxError("Unclosed argument list")}x.push(M()),r(Jf)}}function M(){let x=m();return x.type!=="mesg"?x:r(jf)?{type:"narg",name:x.name,value:R()}:x}function g(){let x=[],b=0,C;for(;i(Bf);){s("*")&&(C=b);let B=d(),V=h();if(V===null)throw new SyntaxError("Expected variant value");x[b++]={key:B,value:V}}if(b===0)return null;if(C===void 0)throw new SyntaxError("Expected default variant");return{variants:x,star:C}}function d(){r(Yf,SyntaxError);let x;return i(Nl)?x=E():x={type:"str",value:a(zf)},r($f,SyntaxError),x}function R(){if(i(Nl))return E();if(t[e]==='"')return S();throw new SyntaxError("Invalid expression")}function E(){let[,x,b=""]=o(Nl),C=b.length;return{type:"num",value:parseFloat(x),precision:C}}function S(){s('"',SyntaxError);let x="";for(;;){if(x+=a(Vf),t[e]==="\\"){x+=I();continue}if(s('"'))return{type:"str",value:x};throw new SyntaxError("Unclosed string literal")}}function I(){if(i(Nh))return a(Nh);if(i(Fh)){let[,x,b]=o(Fh),C=parseInt(x||b,16);return C<=55295||57344<=C?String.fromCodePoint(C):"\uFFFD"}throw new SyntaxError("Unknown escape sequence")}function P(){let x=e;switch(r(Qf),t[e]){case".":case"[":case"*":case"}":case void 0:return!1;case"{":return k(t.slice(x,e))}return t[e-1]===" "?k(t.slice(x,e)):!1}function D(x,b){return x.replace(b,"")}function k(x){let b=x.replace(Wf,`
`),C=Xf.exec(x)[1].length;return new Hr(b,C)}}},Hr=class{constructor(t,e){this.value=t,this.length=e}};var tp=1.5.toLocaleString(document.documentElement.lang)[1],ri=n=>n.replace(".",tp),fi=n=>String(n).replace(/\B(?=(\d{3})+(?!\d))/g,"\u202F");function Fe(n,t=4){return n==null||!(n>0)||!Number.isFinite(n)?t:Math.min(Math.max(1-Math.floor(Math.log10(n)),0),9)}function Tt(n,t){return n==null||!Number.isFinite(n)?"\u2013":ri(n.toFixed(t))}function wt(n,t=3){if(n==null||!Number.isFinite(n))return"\u2013";let e=Math.abs(n);return e!==0&&(e>=1e7||e<1e-6)?ri(n.toExponential(t-1)):ri(e>=10**(t-1)?n.toFixed(0):String(Number(n.toPrecision(t))))}var ye=(n,t)=>t?`${n} ${t}`:n;var Vr=class extends Le{constructor(e,i){super(e);this.text=i}toString(){return this.text}},ep=([n],{digits:t,decimals:e})=>n instanceof Le?new Vr(n.value,e?Tt(n.value,Number(e.valueOf())):wt(n.value,t?Number(t.valueOf()):3)):n,ip=([n])=>`--${String(n)}`,Fl=new Ns(document.documentElement.lang,{useIsolating:!1,functions:{NUM:ep,OPTION:ip}});Fl.addResource(new Fs(JSON.parse(document.getElementById("words").textContent)));function Bh(n,t,e){let i=Fl.getMessage(n.replace(".","-")),s=t?i?.attributes[t]:i?.value,r=Object.entries(e).map(([o,a])=>[o,typeof a=="number"?new Vr(a,Number.isInteger(a)?fi(a):wt(a)):a??"\u2013"]);return s?Fl.formatPattern(s,Object.fromEntries(r),[]):void 0}var _=(n,t={})=>["","why","do"].map(e=>Bh(n,e,t)).filter(e=>e).join(" ")||n,Oe=(n,t={})=>Bh(n,"title",t)??"",En=n=>n.replace(/\W+/g,"_");function zh(){for(let n of document.querySelectorAll("[data-say], [data-label], [data-hint], [data-tip]")){let{say:t,label:e,hint:i,tip:s}=n.dataset;t&&(n.textContent=_(t)),t&&Oe(t)&&(n.title=Oe(t)),e&&n.setAttribute("aria-label",_(e)),i&&n.setAttribute("placeholder",_(i)),s&&(n.title=_(s))}}var rt=n=>document.getElementById(n);function p(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))typeof r=="function"?i.addEventListener(s.slice(2),r):r===!0?i.setAttribute(s,""):r!==!1&&i.setAttribute(s,String(r));return i.append(...e),i}var Zt=(n,t,e,i="")=>p("button",{type:"button",title:t,class:i,onclick:e},n),Ut=(n,t,e="",i={})=>Zt(_(n,i),Oe(n,i),t,e),De=(n,t=[])=>p("thead",{},p("tr",{},...n.map((e,i)=>p("th",{scope:"col",class:t.includes(i)?"l":"",title:Oe(e)},e&&_(e))))),xe=(n,t,e="")=>n.map(i=>p("option",{value:i,selected:i===e},t(i)));function Hh(n){return n instanceof HTMLInputElement?!["checkbox","range","radio","button","file"].includes(n.type):n instanceof HTMLTextAreaElement||n instanceof HTMLSelectElement}function vi(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function Kn(n){let t=!1;return()=>{if(!document.hidden)return n();t||(t=!0,document.addEventListener("visibilitychange",()=>{t=!1,n()},{once:!0}))}}function ke(n,t){let e=0;return()=>{clearTimeout(e),e=window.setTimeout(n,t)}}var yi=class extends Error{constructor(e,i,s=""){super(i);this.status=e;this.code=s}};function np(n,t){let e=new URLSearchParams;for(let[s,r]of Object.entries(t))for(let o of Array.isArray(r)?r:[r])e.append(s,String(o));let i=e.toString();return i?`${n}?${i}`:n}async function Ol(n){let{status:t}=n;try{let{error:e,code:i}=await n.json();return new yi(t,e,i)}catch{return new yi(t,_("studio_page.server_status",{status:t}),"studio_page.server_status")}}async function Ft(n,t={}){let e=await fetch(np(n,t));if(!e.ok)throw await Ol(e);return await e.json()}async function Gr(n){let t=await fetch(n);if(!t.ok)throw await Ol(t);return t.arrayBuffer()}async function Ue(n,t){let e=await fetch(n,{method:"POST",headers:{"content-type":"application/json"},body:JSON.stringify(t)});if(!e.ok)throw await Ol(e);return await e.json()}var sp=["auto","free","held"],rp=["label.parameter","studio_decide.next","studio_decide.last_status","label.value","studio_decide.sigma","label.unit","studio_decide.t","studio_decide.p","studio_decide.effect","studio_decide.effect_sigma","studio_decide.correlation"],Wr=class{constructor(t){this.model=t;this.root=p("section",{class:"leaf","aria-label":_("studio_decide.parameters")});this.box=p("div",{});this.root.append(p("p",{class:"note"},_("studio_decide.parameters_note")),this.box)}async show(){let t=await Ft("/api/parameters"),e=document.activeElement?.id??"",i=t.total>t.interiors.length?[p("p",{class:"note"},_("studio_decide.interiors_shown",{n:t.interiors.length,of:t.total}))]:[];this.box.replaceChildren(...t.interiors.map(s=>this.table(s,t)),...i),e.startsWith("choice-")&&document.getElementById(e)?.focus()}table(t,e){let i=t.image===null?_("studio_decide.camera",{camera:t.camera}):_("studio_decide.camera_image",{camera:t.camera,image:t.image}),s=t.tests.map(r=>p("li",{},_("studio_decide.joint_test",{group:r.group,F:wt(r.F),p:Vh(r.probability)})));return p("div",{class:"card"},p("h3",{},i),p("table",{class:"parameters","aria-label":_("studio_decide.parameters_of",{name:i})},De(rp),p("tbody",{},...t.parameters.map(r=>this.row(t,r,e)))),...s.length?[p("p",{class:"note"},_("studio_decide.joint_tests")),p("ul",{class:"tests"},...s)]:[])}row(t,e,{strong:i,significance:s}){let r=Fe(e.sigma,6),o=e.correlation,a=o?.with||_("studio_decide.exterior"),l=o?`${Tt(o.value,2)} ${a}`:"\u2013",c=e.probability!==null&&e.probability>s,h=o?.strong?p("span",{class:"flag",title:_("studio_decide.strong",{strong:i})},"\u26A0 "):"";return p("tr",{},p("th",{scope:"row",title:e.meaning},e.symbol),p("td",{class:"l"},this.choice(t,e)),p("td",{class:`l ${e.status==="not determinable"?"doubt":""}`,title:e.remark},_("studio_decide.status",{status:En(e.status)})),p("td",{},e.sigma===null?wt(e.value,6):zl(e.value,e.sigma,r)),p("td",{},kl(e.sigma)),p("td",{class:"l"},Bl(e.unit)),p("td",{},wt(e.t)),p("td",{class:c?"doubt":""},Vh(e.probability)),p("td",{},wt(e.effect_px)),p("td",{},wt(e.effect_sigma_px,2)),p("td",{class:"l",title:o?_("studio_decide.correlated",{other:a}):""},h,l))}choice(t,e){let i=`choice-${t.camera}-${t.image??""}-${e.symbol}`,s=p("select",{id:i,"aria-label":_("studio_decide.choice_of",{symbol:e.symbol,camera:t.camera}),class:e.choice==="auto"?"":"chosen"},...xe(sp,r=>_("studio_decide.choice",{choice:r}),e.choice));return s.addEventListener("change",()=>void this.model.act("parameter",{camera:t.camera,symbol:e.symbol,choice:s.value},"studio_decide.choice_stored",{symbol:e.symbol,camera:t.camera,choice:s.value})),s}},Gh=1e-4,kl=n=>n!==null&&n>0&&n<Gh?ri(n.toExponential(1)):wt(n,2),Bl=n=>n.replace(/\^(-?\d)/,(t,e)=>[...e].map(i=>i==="-"?"\u207B":"\u2070\xB9\xB2\xB3\u2074\u2075\u2076\u2077\u2078\u2079"[Number(i)]).join(""));function zl(n,t,e){return n===null?"\u2013":t>0&&t<Gh?ri(n.toExponential(Math.min(Math.max(Math.floor(Math.log10(Math.abs(n)/t))+1,1),8))):Tt(n,e)}var Vh=n=>n===null?"\u2013":n<1e-4?`< ${ri("0.0001")}`:Tt(n,n<.01?4:2);var op={good:"good",usable:"remarks"},Xr=class{constructor(t){this.model=t;this.root=p("section",{class:"leaf",tabindex:0,"aria-label":_("studio_decide.calibration")});this.status=p("p",{class:"note",role:"status"});this.box=p("div",{});this.turn=0;this.root.append(this.status,this.box)}async show(){let t=++this.turn;this.status.hidden=!1,this.status.textContent=_("studio_decide.judging");try{let{cameras:e,why:i}=await Ft("/api/calibration");if(t!==this.turn)return;this.status.hidden=!i,this.status.textContent=i,this.box.replaceChildren(...e.map(s=>this.camera(s)))}catch(e){if(t!==this.turn)return;this.status.textContent=e.message,this.box.replaceChildren()}}camera(t){let e=t.verdict;return p("div",{class:"camera"},p("h3",{},_("studio_decide.camera",{camera:t.camera})),p("p",{class:"note"},t.about),...e?this.verdict(t,e):[p("p",{class:"note"},_("studio_decide.no_verdict"))],p("div",{class:"halves"},this.parameters(t),...e?[ap(e)]:[]),p("div",{class:"figures"},...t.figures.map(i=>p("figure",{},p("img",{src:`/figure/calibration/${i.number}.svg?of=${this.model.overview.times}-${this.turn}`,alt:i.caption,loading:"lazy"}),p("figcaption",{},i.caption)))))}verdict(t,e){let i=[p("p",{class:`verdict ${op[e.grade]??"attention"}`},e.headline),p("p",{class:"note"},_("studio_decide.verdict_source",{source:t.verdict_is}))];e.reasons.length&&i.push(p("h4",{},_("studio_decide.weaknesses")),p("ul",{class:"reasons"},...e.reasons.map(o=>p("li",{},o))));let s=e.advice[e.advice.length-1],r=s?.ratio&&s.uncertainty_px?s.uncertainty_px/s.ratio:e.uncertainty_px;return e.advice.length?i.push(p("h4",{},_("studio_decide.next_photographs")),p("table",{class:"figures-of","aria-label":_("studio_decide.next_photographs_of",{camera:t.camera})},De(["label.photograph","studio_decide.uncertainty_then","studio_decide.smaller_by"]),p("tbody",{},...e.advice.map((o,a)=>p("tr",{},p("th",{scope:"row"},`${a+1}. ${o.photographs}`),p("td",{},wt(o.uncertainty_px,2)),p("td",{},o.ratio===null||!(o.ratio>0)?"\u2013":`${Math.round(100*(1-o.ratio))} %`))))),p("p",{class:"note"},_("studio_decide.next_photographs_note",{now_px:wt(r,2)}))):i.push(p("p",{class:"note"},_("studio_decide.no_next_photographs"))),i}parameters(t){return p("div",{class:"wide"},p("table",{class:"figures-of","aria-label":_("studio_decide.parameters_of",{name:t.camera})},De(["label.parameter","label.value","label.sigma","label.unit","studio_decide.determinability","label.status"],[3,5]),p("tbody",{},...t.parameters.map(e=>p("tr",{},p("th",{scope:"row"},e.symbol,p("small",{class:"note"},` ${e.meaning}`)),p("td",{},e.sigma===null?wt(e.value,6):zl(e.value,e.sigma,Fe(e.sigma,6))),p("td",{},kl(e.sigma)),p("td",{class:"l"},Bl(e.unit)),p("td",{},wt(e.determinability,2)),p("td",{class:`l ${e.status==="not determinable"?"doubt":""}`},_("studio_decide.status",{status:En(e.status)})))))))}};function ap(n){let t=i=>i===null?"\u2013":`${Math.round(100*i)} %`,e=[["studio_decide.largest_uncertainty",`${wt(n.uncertainty_px,2)} px`],["studio_decide.median_uncertainty",`${wt(n.typical_uncertainty_px,2)} px`],["studio_decide.image_sigma",`${wt(n.image_sigma_px,2)} px`],["studio_decide.coverage",t(n.coverage)],["studio_decide.reach",t(n.reach)],["label.photographs",String(n.photographs)],["studio_decide.quarter_turns",_("label.n_of",{n:n.rolls,of:4})],["studio_decide.convergence",`${wt(n.convergence_deg,2)}\xB0`],["label.cross_validation",n.cross_validation?_("studio_decide.cross_validation",{rms_px:wt(n.cross_validation.rms_px,2),fit_px:wt(n.cross_validation.fit_px,2)}):"\u2013"]];return p("dl",{class:"facts"},...e.map(([i,s])=>p("div",{},p("dt",{},_(i)),p("dd",{},s))))}function Hl(n){return p("iframe",{class:"page",sandbox:"allow-scripts",referrerpolicy:"no-referrer",title:n})}var Os=n=>`${n.number}: ${_("studio_decide.origin",{origin:n.origin})}`,qr=class{constructor(){this.root=p("section",{class:"leaf whole","aria-label":_("studio_page.report")});this.select=p("select",{id:"report-of"});this.status=p("p",{class:"note",role:"status"});this.links=p("span",{class:"links"});this.frame=Hl(_("studio_decide.report"));this.at="";this.select.addEventListener("change",()=>void this.show()),this.root.append(p("div",{class:"deeds"},p("label",{for:"report-of"},_("studio_decide.of_adjustment")),this.select,this.links),this.status,this.frame)}async show(){let{adjustments:t}=await Ft("/api/adjustments"),i=this.select.options.length===t.length?Number(this.select.value):t[t.length-1]?.number??-1;this.select.replaceChildren(...t.map(o=>p("option",{value:o.number,selected:o.number===i},Os(o))));let s=t.find(o=>o.number===i),r=s?.report?`/adjustment/${s.number}/report.html`:"";this.select.disabled=!t.length,this.frame.hidden=!r,this.status.textContent=s?r?"":_("studio_decide.no_report"):_("studio_decide.not_adjusted"),this.status.hidden=!this.status.textContent,this.links.replaceChildren(...r?[Wh(_("studio_decide.window"),r)]:[],...s?.network?[Wh(_("studio_decide.network"),`/adjustment/${s.number}/network.html`)]:[]),r&&r!==this.at&&(this.frame.src=r),this.at=r}},Wh=(n,t)=>p("a",{href:t,target:"_blank",rel:"noopener"},n);var Yr=class{constructor(t,e){this.model=t;this.ways=e;this.root=p("section",{class:"leaf whole","aria-label":_("studio_decide.compare")});this.body=p("tbody",{});this.worst=p("div",{class:"beside"});this.status=p("p",{class:"note",role:"status"});this.frame=Hl(_("studio_decide.comparison"));this.adjustments=[];this.pair=[-1,-1];this.at="";this.root.append(p("table",{class:"adjustments","aria-label":_("studio_decide.adjustments")},De(["studio_decide.first","studio_decide.second","studio_decide.adjustment","studio_decide.sigma0","label.redundancy","label.rejected","studio_decide.free","studio_decide.mean_sigma","studio_decide.rms_check"]),this.body),this.worst,this.status,this.frame)}async show(){let t=this.adjustments.length?this.adjustments[this.adjustments.length-1].number:-1;this.adjustments=(await Ft("/api/adjustments")).adjustments;let e=this.adjustments.map(i=>i.number);(e[e.length-1]!==t||!this.pair.every(i=>e.includes(i)))&&(this.pair=[e[e.length-2]??-1,e[e.length-1]??-1]),this.body.replaceChildren(...this.adjustments.map(i=>this.row(i))),this.compare()}row(t){let e=t.check.points?t.check.rms.map(s=>wt(s,2)).join(", "):"\u2013",i=t.parameters.filter(s=>s.sigma!==null).length;return p("tr",{},p("td",{},this.radio(0,t)),p("td",{},this.radio(1,t)),p("th",{scope:"row"},Os(t),p("small",{class:"note",title:t.options.join(" ")},t.options.join(" ")||_("studio_decide.defaults"))),p("td",{},Tt(t.sigma0,4)),p("td",{},t.redundancy===null?"\u2013":fi(t.redundancy)),p("td",{},t.rejected===null?"\u2013":fi(t.rejected)),p("td",{},String(i)),p("td",{},ye(wt(t.mean_std,2),t.unit)),p("td",{},t.check.points?ye(e,t.unit):e))}radio(t,e){let i=t?"second":"first",s=p("input",{type:"radio",name:`compare-${i}`,id:`compare-${i}-${e.number}`,checked:this.pair[t]===e.number,"aria-label":_("studio_decide.as_side",{name:Os(e),side:i})});return s.addEventListener("change",()=>{this.pair[t]=e.number,this.compare()}),s}compare(){let t=this.pair.map(o=>this.adjustments.find(a=>a.number===o)),[e,i]=t,s=e!==void 0&&i!==void 0&&e!==i;this.status.textContent=s?"":this.adjustments.length<2?_("studio_decide.adjust_again"):_("studio_decide.choose_two"),this.status.hidden=s,this.worst.replaceChildren(...t.filter(o=>o!==void 0).filter((o,a,l)=>l.indexOf(o)===a).map(o=>this.largest(o)));let r=s?`/comparison/${e.number}/${i.number}`:"";this.frame.hidden=!s,s&&r!==this.at&&(this.frame.src=r),this.at=r}largest(t){let e=_("studio_decide.largest_residuals",{name:Os(t)});return p("div",{},p("h3",{},e),p("table",{"aria-label":e},De(["studio_table.observation","studio_table.w","studio_decide.v"]),p("tbody",{},...t.worst.map(i=>p("tr",{},p("td",{class:"l"},Zt(_("studio_decide.point_in_image",{...i}),_("studio_decide.show_point",{...i}),()=>this.visit(i.point,i.image),"link")),p("td",{},Tt(i.w,2)),p("td",{},Tt(i.v_px,2)))))))}visit(t,e){this.model.images.has(e)&&this.ways.visit(t,e)}};var sn=class{constructor(t,e){this.prefix=t;this.root=p("form",{class:"options"});this.inputs=new Map;this.root.addEventListener("submit",i=>i.preventDefault()),this.root.addEventListener("change",()=>e(this.values()))}values(){let t={};for(let[e,[i,s]]of this.inputs)i.kind==="flag"?t[e]=s.checked:i.kind==="number"?t[e]=s.value.trim()?Number(s.value.replace(",",".")):i.default:t[e]=s.value;return t}fill(t){this.inputs.size||this.root.append(...t.map(e=>this.row(e)));for(let{name:e,value:i,default:s}of t){let[r,o]=this.inputs.get(e);r.kind==="flag"?o.checked=i===!0:(document.activeElement!==o||o instanceof HTMLSelectElement)&&(o.value=i===null?"":String(i)),o.closest(".option").classList.toggle("changed",i!==s)}}row(t){let e=`${this.prefix}-${t.name}`,i={id:e,name:t.name,"aria-describedby":`${e}-help`,title:t.help},s;return t.kind==="choice"?s=p("select",i,...xe(t.choices,r=>r.replace("_"," ")||"\u2013")):t.kind==="flag"?s=p("input",{...i,type:"checkbox"}):t.kind==="number"?s=p("input",{...i,type:"number",min:t.low??"",max:t.high??"",step:t.whole?1:"any",placeholder:t.metavar}):s=p("input",{...i,type:"text",placeholder:t.metavar,autocomplete:"off",spellcheck:"false"}),this.inputs.set(t.name,[t,s]),p("div",{class:"option"},p("label",{for:e},t.flag.replace(/^--/,"").replace(/-/g," ")),s,p("p",{class:"note",id:`${e}-help`},t.help))}};var $r=class{constructor(t){this.model=t;this.root=p("section",{class:"leaf","aria-label":_("studio_decide.options")});this.form=new sn("option",t=>void this.send(t));this.command=p("code",{class:"command"});let e=Ut("studio_decide.adjust",()=>rt("adjust").click(),"main");e.id="options-adjust";let i=Ut("studio_decide.reset",()=>void this.send({}));i.id="options-usual",this.root.append(p("p",{class:"note"},_("studio_decide.options_note")),this.form.root,p("div",{class:"deeds"},e,i),p("h3",{},_("studio_decide.command")),p("p",{},this.command))}async show(){this.fill(await Ft("/api/options"))}async send(t){try{this.fill(await Ue("/api/options",{values:t})),this.model.say("studio_decide.options_stored",{},"good")}catch(e){this.model.fail(e)}}fill({fields:t,command:e}){this.form.fill(t),this.command.textContent=e}};var Kr=class{constructor(t){this.model=t;this.root=p("section",{class:"leaf","aria-label":_("studio_run.title")});this.form=new sn("run",t=>void this.send(t));this.command=p("code",{class:"command"});this.why=p("p",{class:"note"});this.go=Ut("studio_run.begin",()=>void this.begin(),"main",{name:""});this.stop=Ut("studio_run.stop",()=>rt("stop").click());this.usual=Ut("studio_decide.reset",()=>void this.send({}));this.status=p("p",{class:"counts",role:"status","aria-live":"polite"});this.bar=p("progress",{max:1,value:0,"aria-label":_("studio_run.progress")});this.body=p("tbody",{});this.table=p("table",{class:"stages","aria-label":_("studio_run.stages")},De(["studio_run.stage","studio_run.state","label.time","label.result"]),this.body);this.words=p("pre",{class:"printed",tabindex:0,"aria-label":_("studio_run.output")});this.go.id="run-begin",this.stop.id="run-stop",this.usual.id="run-usual",this.settings=p("div",{},p("h3",{},_("studio_decide.command")),p("p",{},this.command),p("h3",{},_("studio_run.settings")),p("p",{class:"note"},_("studio_run.settings_note")),this.form.root),this.root.append(this.why,p("div",{class:"deeds first"},this.go,this.stop,this.usual),this.status,this.bar,this.table,this.words,this.settings),t.on("run",()=>this.run(t.run))}async show(){this.take(await Ft("/api/run"))}take({form:t,why:e,run:i}){this.why.textContent=e,this.why.hidden=!e,this.settings.hidden=this.usual.hidden=this.go.hidden=!t,t&&(this.form.fill(t.fields),this.command.textContent=t.command,this.go.textContent=_("studio_run.begin",{name:t.name})),this.model.run=i,this.run(i)}async send(t){try{this.take(await Ue("/api/run/settings",{values:t})),this.model.say("studio_run.settings_stored",{},"good")}catch(e){this.model.fail(e)}}async begin(){try{this.take(await Ue("/api/run",{})),this.model.say("studio_run.begun")}catch(t){this.model.fail(t)}}run(t){let e=t?.outcome==="running";this.go.disabled=e,this.stop.disabled=!e,this.bar.hidden=!e,this.status.hidden=this.table.hidden=!t,this.words.hidden=!t?.words,t&&(this.bar.value=t.share,this.status.textContent=lp(t),this.body.replaceChildren(...t.stages.map(cp)),this.words.textContent=t.words,this.words.classList.toggle("bad",t.outcome==="failed"))}};function lp(n){if(n.outcome!=="running")return _("studio_run.ended",{outcome:n.outcome,time:Zr(n.seconds)});let t=ks(n.step);if(n.stopping)return _("studio_run.stopping",{step:t});let e=n.left_s===null?"none":Zr(n.left_s);return _("studio_run.going",{step:t,percent:Math.round(100*n.share),rest:e,time:Zr(n.seconds)})}var ks=n=>_("studio_run.stage_name",{stage:En(n.split(":")[0]),name:n}),cp=n=>p("tr",{class:n.state.replace(" ","-")},p("th",{scope:"row"},ks(n.title)),p("td",{class:"l"},_("studio_run.stage_state",{state:En(n.state)})),p("td",{},n.seconds===null?"\u2013":Zr(n.seconds)),p("td",{class:"l"},n.summary));function Zr(n){return n<9.95?`${Tt(n,1)} s`:n<120?`${Math.round(n)} s`:n<7200?`${Math.round(n/60)} min`:`${Tt(n/3600,1)} h`}var Vl=class{constructor(){this.images=new Map;this.points=new Set;this.listeners=[]}onchange(t){this.listeners.push(t)}show(t){this.images=new Map,this.points=new Set;for(let[e,i]of t){this.points.add(i);let s=this.images.get(e);s?s.add(i):this.images.set(e,new Set([i]))}for(let e of this.listeners)e()}has(t,e){return this.images.get(t)?.has(e)??!1}get worstImage(){let t="";for(let[e,i]of this.images)i.size>(this.images.get(t)?.size??0)&&(t=e);return t}},ti=new Vl;var Gl=1e3,hp=60,jr=class{constructor(t,e){this.model=t;this.ways=e;this.root=p("section",{class:"leaf","aria-label":_("studio_decide.select")});this.kinds=p("fieldset",{class:"kinds"},p("legend",{},_("studio_decide.observations_by")));this.slider=p("input",{type:"range",id:"select-slider",min:0,max:Gl,value:0,"aria-label":_("studio_decide.limit")});this.limit=p("input",{type:"text",id:"select-limit",inputmode:"decimal",autocomplete:"off"});this.unit=p("span",{class:"note"});this.words=p("p",{class:"note"});this.counts=p("p",{class:"counts",role:"status","aria-live":"polite"});this.hand=p("p",{class:"note"});this.command=p("code",{class:"command"});this.list=p("div",{class:"found",tabindex:0,role:"region","aria-label":_("studio_decide.beyond")});this.draw=p("input",{type:"checkbox",id:"select-draw"});this.criteria=[];this.by="w";this.limits=new Map;this.turn=0;this.soon=ke(()=>void this.count(),50);this.reject=Ut("studio_decide.reject_all",()=>void this.rejectAll(),"main"),this.reject.id="select-reject",this.slider.disabled=this.limit.disabled=!0,this.shows=[Ut("studio_decide.show_in_images",()=>this.drawn(()=>e.images(ti.worstImage))),Ut("studio_decide.show_in_space",()=>this.drawn(()=>e.space()))],this.draw.addEventListener("change",()=>void this.count()),t.on(["read","state"],()=>this.draw.checked&&void this.count()),this.slider.addEventListener("input",()=>this.moved()),this.limit.addEventListener("change",()=>this.setLimit()),this.root.append(this.kinds,this.words,p("div",{class:"limit"},p("label",{for:"select-limit"},_("studio_decide.limit")),this.slider,this.limit,this.unit),this.counts,this.hand,p("div",{class:"deeds"},this.reject,...this.shows,p("label",{class:"row"},this.draw,_("studio_decide.draw"))),p("h3",{},_("studio_decide.command")),p("p",{},this.command),this.list)}async show(){this.criteria=(await Ft("/api/criteria")).criteria,this.kinds.childElementCount<2&&this.kinds.append(...this.criteria.map(t=>this.kind(t)));for(let t of this.criteria)this.limits.has(t.name)||this.limits.set(t.name,Number(t.begin.toPrecision(3)));this.slider.disabled=this.limit.disabled=!1,this.take()}kind(t){let e=p("input",{type:"radio",name:"select-by",id:`select-${t.name}`,value:t.name,checked:t.name===this.by});return e.addEventListener("change",()=>{this.by=t.name,this.take()}),p("label",{title:_("studio_decide.quantity_meaning",{quantity:t.name})},e,_("studio_decide.quantity",{quantity:t.name}))}get criterion(){return this.criteria.find(t=>t.name===this.by)}at(t){let e=this.criterion,i=t/Gl;if(e.whole)return Math.round(2+i*Math.max(e.high-2,1));if(e.name==="redundancy")return Number((i*Math.min(e.high,1)).toPrecision(3));let s=Math.max(e.middle,e.high/1e4)||1e-9;return Number((s*(Math.max(e.high,s)/s)**i).toPrecision(3))}step(t){let e=0;for(let i=0;i<=Gl;i+=5)Math.abs(this.at(i)-t)<Math.abs(this.at(e)-t)&&(e=i);return e}take(){let t=this.criterion,[e,i,s]=[t.low,t.high,t.middle].map(a=>ye(wt(a),t.unit)),r=t.above?"above":"below",o=t.known?_("studio_decide.range",{low:e,high:i,middle:s}):_("studio_decide.no_range");this.words.textContent=[_("studio_decide.quantity_meaning",{quantity:t.name}),o,_("studio_decide.selected",{side:r})].join(" "),this.limit.value=String(this.limits.get(this.by)),this.slider.value=String(this.step(this.limits.get(this.by))),this.slider.setAttribute("aria-valuetext",this.limit.value),this.unit.textContent=t.unit,this.count()}moved(){let t=this.at(Number(this.slider.value));this.limits.set(this.by,t),this.limit.value=String(t),this.slider.setAttribute("aria-valuetext",ye(String(t),this.criterion.unit)),this.soon()}setLimit(){let t=this.limit.value.trim()?Number(this.limit.value.replace(",",".")):NaN;if(!(t>=0))return this.model.say("studio_point.number_missing",{field:_("studio_decide.limit")},"bad");this.limits.set(this.by,t),this.slider.value=String(this.step(t)),this.count()}drawn(t){this.draw.checked=!0,this.count().then(t)}async count(){let t=++this.turn;this.reject.disabled=!0,this.counts.setAttribute("aria-busy","true");try{let e=await Ft("/api/selection",{by:this.by,limit:this.limits.get(this.by)});t===this.turn&&this.report(e)}catch(e){this.model.fail(e)}}report(t){ti.show(this.draw.checked?t.rows:[]);let e=t.used?100*t.observations/t.used:0;this.counts.setAttribute("aria-busy","false"),this.counts.textContent=_("studio_decide.counts",{n:t.observations,points:t.points,percent:wt(e,2),used:t.used}),this.hand.textContent=t.marks?_("studio_decide.marks_beyond",{n:t.marks}):"",this.command.textContent=t.command,this.reject.disabled=!t.observations,this.shows.forEach(r=>r.disabled=!t.observations);let i=t.rows.slice(0,hp).map(([r,o])=>p("li",{},Zt(_("studio_decide.point_in_image",{point:o,image:r}),_("studio_decide.show_point",{point:o,image:r}),()=>this.ways.visit(o,r),"link"))),s=t.observations-i.length;this.list.hidden=!i.length,this.list.replaceChildren(p("ul",{},...i),...s>0?[p("p",{class:"note"},_("studio_decide.more",{n:s,drawn:t.all_shown?"all":"some"}))]:[])}async rejectAll(){this.reject.disabled=!0;let t=this.limits.get(this.by);try{let e=await this.model.actions.reject(this.by,t);this.model.command=e.command,this.model.take(e.state),this.model.say("studio_decide.rejected",{limit:wt(t),quantity:this.by},"good")}catch(e){this.model.fail(e),await this.count()}}};var Xt={brightness:1,contrast:1,vectors:40,filter:"worst",loupe:!1,linked:!0,snap:"auto"},Bs=["auto","ellipse","corner","cross","patch","hand"],ie={used:"#56b4e9",weak:"#e69f00",rejected:"#d55e00",control:"#f0e442",check:"#2fc79a",mark:"#f5a3cf",current:"#ffffff",predicted:"#f0e442",beyond:"#ff5ad1",masked:"#ff7f2a",off:"#ff3b30"},Wl=()=>Xt.brightness===1&&Xt.contrast===1?"none":`brightness(${Xt.brightness}) contrast(${Xt.contrast})`;var up=20,Xl=2*Math.PI;function Jr(n,t,e){return n.rejected[t]||e.has(n.point[t])?"rejected":n.role[t]===1?"control":n.role[t]===2?"check":n.rays[t]<3?"weak":"used"}function ql(n,t,e){let i=[...n.x.keys()];if(t==="none")return[];if(t==="worst")return i.filter(r=>n.w[r]!==null).sort((r,o)=>n.w[o]-n.w[r]).slice(0,up);if(t==="all")return i;let s=t==="control"?["control","check"]:[t];return i.filter(r=>s.includes(Jr(n,r,e)))}function Xh(n,t,e,i,s,r=9){let o=-1,a=r;for(let l of t){let[c,h]=e.toScreen(n.x[l],n.y[l]),u=Math.hypot(c-i,h-s);u<a&&(a=u,o=l)}return o}function qh(n,t,e,i){n.setTransform(i,0,0,i,0,0);let{observations:s}=e;if(s){let r=ql(s,Xt.filter,e.rejectedHere);dp(n,t,s,r),pp(n,t,s,r,e),mp(n,t,s,e.image)}e.prediction&&vp(n,t,e.prediction,e.current);for(let r of e.marks)gp(n,t,r,r.mark.point===e.current,e.off);for(let r of e.fiducials)_p(n,t,r,r.name===e.fiducial);e.hair&&xp(n,t)}function dp(n,t,e,i){if(Xt.vectors<=0)return;let s=Xt.vectors/t.scale;for(let[r,o]of[["#00000099",2.8],[ie.used,1.3]]){n.strokeStyle=r,n.lineWidth=o,n.beginPath();for(let a of i){let l=e.vx[a],c=e.vy[a];l===null||c===null||(n.moveTo(...t.toScreen(e.x[a],e.y[a])),n.lineTo(...t.toScreen(e.x[a]+l*s,e.y[a]+c*s)))}n.stroke()}}function fp(n,t,e,i,s){let r=t==="control"||t==="check"?6:s;t==="rejected"?(n.moveTo(e-r,i-r),n.lineTo(e+r,i+r),n.moveTo(e+r,i-r),n.lineTo(e-r,i+r)):t==="control"?(n.moveTo(e,i-r),n.lineTo(e+r,i+.75*r),n.lineTo(e-r,i+.75*r),n.closePath()):t==="check"?(n.moveTo(e,i-r),n.lineTo(e+r,i),n.lineTo(e,i+r),n.lineTo(e-r,i),n.closePath()):t==="weak"?n.rect(e-r,i-r,2*r,2*r):(n.moveTo(e+r,i),n.arc(e,i,r,0,Xl))}function pp(n,t,e,i,s){let r=Math.min(Math.max(2.6*Math.sqrt(t.scale),1.6),4);for(let o of["used","weak","rejected","check","control"]){n.beginPath();for(let a of i){if(Jr(e,a,s.rejectedHere)!==o)continue;let[l,c]=t.toScreen(e.x[a],e.y[a]);l<-9||c<-9||l>t.width+9||c>t.height+9||fp(n,o,l,c,r)}n.lineWidth=r<2.5?2.2:3,n.strokeStyle="#000000a0",n.stroke(),n.lineWidth=r<2.5?1.2:1.6,n.strokeStyle=ie[o],n.stroke()}if(s.hover>=0&&s.hover<e.x.length){let[o,a]=t.toScreen(e.x[s.hover],e.y[s.hover]);zs(n,o,a,9,"#ffffff")}}function mp(n,t,e,i){if(ti.points.size)for(let[s,r]of e.point.entries()){if(!ti.has(i,r))continue;let[o,a]=t.toScreen(e.x[s],e.y[s]);o<-16||a<-16||o>t.width+16||a>t.height+16||zs(n,o,a,8,ie.beyond)}}function zs(n,t,e,i,s){n.beginPath(),n.arc(t,e,i,0,Xl),Wi(n,s,1.6)}function Wi(n,t,e){n.lineWidth=e+2,n.strokeStyle="#000000b0",n.stroke(),n.lineWidth=e,n.strokeStyle=t,n.stroke()}function gp(n,t,{mark:e,x:i,y:s},r,o){let[a,l]=t.toScreen(i,s),c=r?11:8,h=r&&o?ie.off:r?ie.current:ie.mark;n.beginPath();for(let[u,f]of[[1,0],[-1,0],[0,1],[0,-1]])n.moveTo(a+2.5*u,l+2.5*f),n.lineTo(a+c*u,l+c*f);Wi(n,h,r?2:1.6),r&&zs(n,a,l,14,o?ie.off:ie.mark),Hs(n,r&&o?`${e.point} !`:e.point,a+c+4,l-7,h)}function _p(n,t,e,i){let[s,r]=t.toScreen(e.x,e.y),o=i?ie.current:ie.control;n.beginPath(),n.rect(s-9,r-9,18,18);for(let[a,l]of[[1,0],[-1,0],[0,1],[0,-1]])n.moveTo(s+3*a,r+3*l),n.lineTo(s+9*a,r+9*l);Wi(n,o,1.6),Hs(n,e.name,s+14,r-7,o)}function Hs(n,t,e,i,s){n.font="600 12.5px system-ui, 'Noto Sans', 'Liberation Sans', sans-serif",n.textBaseline="middle",n.lineJoin="round",n.lineWidth=3.5,n.strokeStyle="#000000c8",n.strokeText(t,e,i),n.fillStyle=s,n.fillText(t,e,i)}function vp(n,t,e,i){if(e.segment&&yp(n,t,e),e.x===null||e.y===null)return;let[s,r]=t.toScreen(e.x,e.y),o=Math.atan2(t.sin,t.cos);if(e.ellipse){let a=e.ellipse.angle_deg*Math.PI/180+o;for(let l of[1,3])n.beginPath(),n.setLineDash(l===3?[5,4]:[]),n.ellipse(s,r,l*e.ellipse.a*t.scale,l*e.ellipse.b*t.scale,a,0,Xl),Wi(n,ie.predicted,1.4);n.setLineDash([])}zs(n,s,r,3,ie.predicted),(!e.ellipse||e.ellipse.a*t.scale<12)&&(n.setLineDash([3,4]),zs(n,s,r,20,ie.predicted),n.setLineDash([])),Hs(n,`${i} ?`,s+16,r+17,ie.predicted)}function yp(n,t,e){n.beginPath(),e.segment.forEach(([i,s],r)=>r?n.lineTo(...t.toScreen(i,s)):n.moveTo(...t.toScreen(i,s))),n.lineJoin="round",e.segment_sigma_px!==null&&(n.lineWidth=Math.max(6*e.segment_sigma_px*t.scale,2),n.strokeStyle="#f0e44238",n.stroke()),Wi(n,ie.predicted,1.2)}function xp(n,t){let[e,i]=[t.width/2,t.height/2];n.beginPath();for(let[s,r]of[[1,0],[-1,0],[0,1],[0,-1]])n.moveTo(e+5*s,i+5*r),n.lineTo(e+26*s,i+26*r);Wi(n,"#ffffff",1.2)}var bp=2*Math.PI,Mp=400,wp=5,jn=[["used",ie.used,"\u25EF"],["rejected",ie.rejected,"\u2297"],["apart",ie.check,"\u25CC"],["unidentified",ie.weak,"\u25CD"]],Sp={used:[],rejected:[],apart:[6,4],unidentified:[2,3]};function $h(n,t,e){let i=Math.atan2(t.sin,t.cos),s=e.rows.filter(o=>{let[a,l]=t.toScreen(o.x,o.y);return a>-40&&l>-40&&a<t.width+40&&l<t.height+40});for(let[o,a]of jn)for(let l of s.filter(c=>c.fate===o))Ep(n,t,l,a,i);let r=[];for(let[o,a]of jn)for(let l of s.filter(c=>c.fate===o)){let[c,h]=t.toScreen(l.x,l.y),u=t.scale>1.5&&l.s!==null?` \xB1 ${Tt(l.s,3)} px`:"",f=`${l.name}${u}`,m=Zh(l,t)+9;f&&r.length<Mp&&Tp(r,[c-5,h-m-7,7.6*f.length,14])&&Hs(n,f,c-5,h-m,a)}}var Zh=(n,t)=>Math.max((n.ellipse?.a??0)*t.scale,wp);function Ep(n,t,e,i,s){let[r,o]=t.toScreen(e.x,e.y),a=Zh(e,t);n.setLineDash(Sp[e.fate]),n.beginPath(),e.ellipse?n.ellipse(r,o,a,a*e.ellipse.b/e.ellipse.a,e.ellipse.angle_deg*Math.PI/180+s,0,bp):n.rect(r-a,o-a,2*a,2*a),Wi(n,i,1.8),n.setLineDash([]),e.fate==="rejected"?Yh(n,r,o,a+3,i):t.scale>1&&Yh(n,r,o,3,i)}function Tp(n,t){let[e,i,s,r]=t;return n.some(([o,a,l,c])=>e<o+l&&o<e+s&&i<a+c&&a<i+r)?!1:(n.push(t),!0)}function Yh(n,t,e,i,s){n.beginPath(),n.moveTo(t-i,e-i),n.lineTo(t+i,e+i),n.moveTo(t+i,e-i),n.lineTo(t-i,e+i),Wi(n,s,1.2)}var Yl=class{constructor(){this.on=!1;this.families=null;this.reason="";this.found=new Map;this.requested=new Set;this.sought=new Set;this.listeners=[]}onchange(t){this.listeners.push(t)}changed(){this.listeners.forEach(t=>t())}switch(t){this.on=t,this.changed()}choose(t){t!==this.families&&(this.families=t,this.forget())}get query(){return this.families===null?{}:{families:this.families}}forget(){this.found.clear(),this.requested.clear(),this.changed()}of(t){let e=this.found.get(t);return!e&&!this.requested.has(t)&&this.read(t),e??null}async read(t){this.requested.add(t);try{let e=await Ft("/api/targets/image",{image:t,...this.query});this.found.set(t,e),this.reason=e.why||(e.families?"":_("studio_target.name_family"));let i=`${t} ${e.families}`;!e.from&&!e.why&&e.families&&!this.sought.has(i)&&(this.sought.add(i),await Ue("/api/targets",{families:e.families,images:[t]}))}catch(e){this.reason=e.message}this.changed()}},Ee=new Yl;var Kh=["label.image","studio_target.found","studio_target.used","studio_target.rejected","studio_target.apart","studio_target.unidentified","studio_target.median_sigma","studio_target.source"],Qr=class{constructor(t,e){this.model=t;this.ways=e;this.root=p("section",{class:"leaf","aria-label":_("studio_decide.targets")});this.family=p("input",{type:"text",id:"targets-family",list:"targets-known",placeholder:_("studio_target.family"),autocomplete:"off",spellcheck:"false"});this.known=p("datalist",{id:"targets-known"});this.forms=p("p",{class:"note"});this.go=Ut("studio_target.find",()=>void this.begin(),"main");this.status=p("p",{class:"note",role:"status"});this.body=p("tbody",{});this.one=p("div",{});this.sheet=new sn("sheet",()=>{});this.command=p("code",{class:"command"});this.files=p("span",{class:"links"});this.go.id="targets-begin";let i=Ut("studio_target.make_sheet",()=>void this.print(),"main");i.id="sheet-make",this.family.addEventListener("change",()=>{Ee.choose(this.family.value.trim()),this.show()}),this.root.append(p("div",{class:"deeds first"},p("label",{for:"targets-family"},_("studio_target.family")),this.family,this.known,this.go),this.forms,this.status,p("table",{class:"figures-of","aria-label":_("studio_target.by_photograph"),id:"targets-by-photograph"},De(Kh,[Kh.length-1]),this.body),this.one,p("h3",{},_("studio_target.sheet")),p("p",{class:"note"},_("studio_target.sheet_note")),this.sheet.root,p("div",{class:"deeds"},i,this.files),p("p",{},this.command)),Ee.onchange(()=>this.root.offsetParent&&void this.details())}async show(){let[t,e]=await Promise.all([Ft("/api/targets",Ee.query),Ft("/api/sheet")]);document.activeElement!==this.family&&(this.family.value=t.families),this.known.replaceChildren(...t.known.map(s=>p("option",{value:s}))),this.forms.textContent=_("studio_target.families",{names:t.forms.join("; ")}),this.go.disabled=!t.families;let i=t.images.every(s=>s.found===null);this.status.textContent=t.families?i?_("studio_target.none_stored"):"":_("studio_target.family_missing"),this.status.hidden=!this.status.textContent,this.body.replaceChildren(...t.images.map(s=>this.row(s))),this.take(e),await this.details()}row(t){let e=t.why||t.remarks.join("; ");return p("tr",{},p("th",{scope:"row"},Zt(t.image,_("studio_target.show",{image:t.image}),()=>this.look(t.image),"link")),p("td",{},t.found===null?"\u2013":String(t.found)),...jn.map(([i])=>p("td",{},t.found===null?"\u2013":String(t.fates[i]??0))),p("td",{},Tt(t.median_s,3)),p("td",{class:`l ${t.why?"doubt":""}`},[t.from&&_("studio_target.origin",{origin:t.from}),e].filter(i=>i).join("; ")||_("studio_target.not_found")))}look(t){Ee.switch(!0),this.ways.images(t)}async details(){let t=this.model.panes[this.model.active];if(!t)return;let e=await Ft("/api/targets/image",{image:t,...Ee.query}),i=e.rows.slice(0,500).map(s=>p("tr",{},p("th",{scope:"row"},s.name||"\u2013"),p("td",{},Tt(s.x,2)),p("td",{},Tt(s.y,2)),p("td",{},Tt(s.s,3)),p("td",{},s.ellipse?Tt(s.ellipse.a,2):"\u2013"),p("td",{},s.ellipse?Tt(s.ellipse.b,2):"\u2013"),p("td",{class:"l"},_("studio_target.fate",{fate:s.fate}))));this.one.replaceChildren(...i.length?[p("details",{},p("summary",{},_("studio_target.of_image",{image:t,n:e.rows.length})),p("table",{class:"figures-of","aria-label":_("studio_target.of_image",{image:t,n:e.rows.length})},De(["label.name","studio_table.x","studio_table.y","studio_target.sigma","studio_target.semi_axis_a","studio_target.semi_axis_b","label.status"],[6]),p("tbody",{},...i)))]:[])}async begin(){try{await Ue("/api/targets",{families:this.family.value.trim(),images:[]}),this.model.say("studio_target.finding")}catch(t){this.model.fail(t)}}async print(){try{let t=Object.fromEntries(Object.entries(this.sheet.values()).filter(([,e])=>e!==null));this.take(await Ue("/api/sheet",{values:t})),this.model.say("studio_target.sheet_made",{},"good")}catch(t){this.model.fail(t)}}take(t){this.sheet.fill(t.fields),this.command.textContent=t.command,this.files.replaceChildren(...t.files.map(e=>p("a",{href:`/sheet/${e}`,download:e},e)))}};var to=class{constructor(t,e,i){this.model=t;this.isOpen=e;this.now=0;this.leaves=[["run","studio_decide.run",new Kr(t)],["options","studio_decide.options",new $r(t)],["parameters","studio_decide.parameters",new Wr(t)],["select","studio_decide.select",new jr(t,i)],["compare","studio_decide.compare",new Yr(t,i)],["calibration","studio_decide.calibration",new Xr(t)],["targets","studio_decide.targets",new Qr(t,i)],["report","studio_page.report",new qr]],this.heads=this.leaves.map(([s,r],o)=>{let a=Ut(r,()=>this.turn(o));return a.id=`decide-${s}`,a}),rt("decide-bar").append(p("span",{class:"group",role:"group","aria-label":_("studio_decide.parts")},...this.heads)),rt("decide").append(...this.leaves.map(([,,s])=>s.root)),this.turn(1),t.on(["read","state","targets"],()=>this.isOpen()&&this.show())}turn(t){this.now=t,this.heads.forEach((e,i)=>e.setAttribute("aria-pressed",String(i===t))),this.leaves.forEach(([,,e],i)=>e.root.hidden=i!==t),this.isOpen()&&this.show()}show(){this.leaves[this.now][2].show().catch(t=>this.model.fail(t))}};var Ap=9,$l=class{constructor(){this.on=!1;this.image="";this.corners=[];this.calls=[]}onchange(t){this.calls.push(t)}begin(t="",e=[]){this.on=!0,this.image=t,this.set(e)}end(){this.on=!1,this.image="",this.set([])}add(t,e){return this.image&&t!==this.image?!1:(this.image=t,this.set([...this.corners,e]),!0)}move(t,e){this.set(this.corners.map((i,s)=>s===t?e:i))}removeLast(){this.set(this.corners.slice(0,-1)),this.corners.length||(this.image="")}cornerAt(t,e,i,s){return!this.on||t!==this.image?-1:this.corners.findIndex(([r,o])=>{let[a,l]=e.toScreen(r,o);return Math.hypot(a-i,l-s)<Ap})}set(t){this.corners=t;for(let e of this.calls)e()}},Kt=new $l;var Rp="http://www.w3.org/2000/svg",[eo,io,Jn,Zl,jh,Cp]=[420,210,52,12,10,30],Pp=1.96;function Vs(n){let t=10**Math.floor(Math.log10(n));return[t*([5,2,1].find(i=>i*t<=n*1.0001)??1),n<1?{per:1e3,name:"mm"}:{per:1,name:"m"}]}var Xi=(n,t,e="")=>{let i=document.createElementNS(Rp,n);for(let[s,r]of Object.entries(t))i.setAttribute(s,String(r));return i.textContent=e,i};function Ip(n,t){let[e]=Vs((t-n)/3),i=[];for(let s=Math.ceil(n/e)*e;s<=t+e*1e-9;s+=e)i.push(Math.abs(s)<e*1e-9?0:s);return i}function Jh(n,t,e,i){let s=[n.first,...n.at].map(E=>Date.parse(t[E])/864e5),r=[0,...n.along.map(E=>E*e.per)],o=[0,...n.along_sigma.map(E=>Pp*E*e.per)],[a,l]=[Date.parse(t[0])/864e5,Date.parse(t[t.length-1])/864e5],c=Math.min(...r.map((E,S)=>E-o[S])),h=Math.max(...r.map((E,S)=>E+o[S])),u=.08*(h-c||1),f=E=>Jn+6+(eo-Jn-Zl-12)*((E-a)/(l-a||1)),m=E=>jh+(io-jh-Cp)*((h+u-E)/(h-c+2*u)),v=(E,S)=>`${f(E).toFixed(1)},${m(S).toFixed(1)}`,M=Xi("svg",{viewBox:`0 0 ${eo} ${io}`,role:"img","aria-label":_("studio_epochs.over_time",{name:n.name,n:n.points?.length??0})}),g=Ip(c-u,h+u),d=Math.max(0,-Math.floor(Math.log10(Math.abs((g[1]??1)-(g[0]??0))||1)+1e-9));for(let E of g)M.append(Xi("line",{class:E?"level":"zero",x1:Jn,x2:eo-Zl,y1:m(E),y2:m(E)}),Xi("text",{x:Jn-6,y:m(E)+4,"text-anchor":"end"},ri(E.toFixed(d))));M.append(Xi("polygon",{class:"band",points:[...s.map((E,S)=>v(E,r[S]+o[S])),...s.map((E,S)=>v(E,r[S]-o[S])).reverse()].join(" ")}),Xi("polyline",{class:"line",points:s.map((E,S)=>v(E,r[S])).join(" ")})),s.forEach((E,S)=>{let I=S?n.at[S-1]:n.first,P=S>0&&n.moved[S-1];M.append(Xi("line",{class:"bar",x1:f(E),x2:f(E),y1:m(r[S]-o[S]),y2:m(r[S]+o[S])}),Xi("circle",{class:`${P?"sure":"open"}${I===i?" now":""}`,cx:f(E),cy:m(r[S]),r:I===i?5:3.5}))});let R=-1e9;for(let E of t){let S=f(Date.parse(E)/864e5);if(S-R<72)continue;let I=S<Jn+30?"start":S>eo-Zl-30?"end":"middle";M.append(Xi("text",{x:S,y:io-12,"text-anchor":I},E)),R=S}return M.append(Xi("text",{x:Jn-12,y:io-12,"text-anchor":"end"},e.name)),M}var Lp=[1,0,-1,0],Dp=[0,1,0,-1],rn=class{constructor(t,e,i){this.columns=t;this.rows=e;this.turn=i;this.scale=1;this.width=1;this.height=1;this.fitted=!0;this.x=t/2,this.y=e/2}get cos(){return Lp[this.turn&3]}get sin(){return Dp[this.turn&3]}toScreen(t,e){let i=(t-this.x)*this.scale,s=(e-this.y)*this.scale;return[this.width/2+this.cos*i-this.sin*s,this.height/2+this.sin*i+this.cos*s]}toImage(t,e){let[i,s]=this.along((t-this.width/2)/this.scale,(e-this.height/2)/this.scale);return[this.x+i,this.y+s]}along(t,e){return[this.cos*t+this.sin*e,-this.sin*t+this.cos*e]}inside(t,e){return t>=0&&e>=0&&t<=this.columns&&e<=this.rows}get whole(){let t=this.turn&1;return Math.min(this.width/(t?this.rows:this.columns),this.height/(t?this.columns:this.rows))}fit(){this.x=this.columns/2,this.y=this.rows/2,this.scale=this.whole*.98,this.fitted=!0}resize(t,e){this.width=Math.max(t,1),this.height=Math.max(e,1),this.fitted&&this.fit()}zoomAt(t,e=this.width/2,i=this.height/2){let[s,r]=this.toImage(e,i);this.scale=Math.min(Math.max(this.scale*t,Math.min(this.whole/2,1)),64);let[o,a]=this.toImage(e,i);this.centre(this.x+s-o,this.y+r-a)}panBy(t,e){let[i,s]=this.along(t/this.scale,e/this.scale);this.centre(this.x-i,this.y-s)}centre(t,e){this.fitted=!1,this.x=Math.min(Math.max(t,0),this.columns),this.y=Math.min(Math.max(e,0),this.rows)}seen(){let[t,e]=this.toImage(0,0),[i,s]=this.toImage(this.width,this.height);return[Math.max(Math.min(t,i),0),Math.max(Math.min(e,s),0),Math.min(Math.max(t,i),this.columns),Math.min(Math.max(e,s),this.rows)]}apply(t,e,i=[0,0]){let s=this.scale*e,r=(this.width/2+i[0])*e,o=(this.height/2+i[1])*e,{cos:a,sin:l,x:c,y:h}=this;t.setTransform(s*a,s*l,-s*l,s*a,r-s*(a*c-l*h),o-s*(l*c+a*h))}};var Qh=400,Up=900,Np=["moved","untested","every"],[Fp,Op,tu,kp,eu]=["#d55e00","#0072b2","#7c8792","#009e73","#10151a"],no=class{constructor(t,e,i){this.isOpen=e;this.visit=i;this.found={dates:[],rows:[],picture:null,why:"",unit:"",of:0};this.view=new rn(1,1,0);this.pictures=[];this.at=0;this.against=0;this.chosen="";this.blinking=0;this.before=!1;this.kind="moved";this.usual=1;this.date=p("input",{type:"range",id:"epochs-date",min:0,max:0,step:1,"aria-label":_("studio_epochs.date")});this.dated=p("output",{id:"epochs-dated"});this.other=p("select",{id:"epochs-against","aria-label":_("studio_epochs.against")});this.blink=Ut("studio_epochs.blink",()=>this.toggle());this.larger=p("input",{type:"range",id:"epochs-larger",min:-3,max:3,step:1,value:0,"aria-label":_("studio_epochs.larger")});this.enlarged=p("output",{});this.stable=p("input",{type:"checkbox",id:"epochs-stable"});this.canvas=p("canvas",{tabindex:0,role:"img","aria-label":_("studio_epochs.picture")});this.status=p("p",{class:"note",role:"status"});this.box=p("div",{class:"picture"},this.canvas,this.status);this.table=p("div",{class:"wide",tabindex:0,"aria-label":_("studio_epochs.moved_when")});this.chart=p("div",{class:"chart"});this.shown=p("select",{id:"epochs-kind","aria-label":_("studio_epochs.rows")},...xe(Np,t=>_("studio_epochs.kind",{kind:t}),"moved"));this.count=p("span",{class:"note"});this.drawSoon=vi(()=>this.draw());rt("epochs-bar").append(p("label",{},_("studio_epochs.date"),this.date),this.dated,p("label",{},_("studio_epochs.against"),this.other),this.blink,p("label",{},_("studio_epochs.larger"),this.larger),this.enlarged,p("label",{},this.stable,_("studio_epochs.stable")),Ut("studio_epochs.whole",()=>this.fit())),rt("epochs-legend").append(...[["near","\u25CF"],["away","\u25CF"],["open","\u25CF"],["arrow","\u2192"]].map(([s,r])=>p("li",{},p("span",{class:`sign ${s}`},r),_("studio_epochs.legend",{part:s})))),rt("epochs").append(this.box,p("div",{class:"side"},p("div",{class:"deeds first"},this.shown,this.count),this.table,this.chart)),this.date.addEventListener("input",()=>this.turnTo(Number(this.date.value))),this.other.addEventListener("change",()=>this.against=Number(this.other.value)),this.larger.addEventListener("input",this.drawSoon),this.stable.addEventListener("change",this.drawSoon),this.shown.addEventListener("change",()=>{this.kind=this.shown.value,this.list()}),this.mouse(),new ResizeObserver(()=>this.drawSoon()).observe(this.box),t.on("read",()=>void this.read().catch(()=>{}))}async read(){let t=await Ft("/api/epochs");if(rt("tab-epochs").hidden=!t.dates.length,t.of===this.found.of&&t.dates.length===this.found.dates.length||(this.found=t,this.pictures=t.dates.map(()=>null),!t.dates.length))return;let{width:e,height:i}=t.picture??{width:1,height:1};this.view=new rn(e,i,0),this.date.max=String(t.dates.length-1),this.other.replaceChildren(...t.dates.map((r,o)=>p("option",{value:o},r))),this.usual=this.usualFactor();let s=this.rows("moved");this.chosen=s[0]?.name??"",this.turnTo(t.dates.length-1),this.isOpen()&&this.show()}show(){this.list(),this.fit()}fit(){this.view.fit(),this.drawSoon()}turnTo(t){this.at=t,this.date.value=String(t),this.date.setAttribute("aria-valuetext",this.found.dates[t]),this.dated.textContent=this.found.dates[t],this.list(),this.drawSoon()}toggle(){clearInterval(this.blinking),this.before=!1;let t=this.blink.getAttribute("aria-pressed")!=="true";this.blink.setAttribute("aria-pressed",String(t)),this.blinking=t?window.setInterval(()=>{this.isOpen()&&(this.before=!this.before,this.drawSoon())},Up):0,this.drawSoon()}usualFactor(){let{picture:t}=this.found,e=this.rows("moved").map(r=>Math.max(...r.length)).sort((r,o)=>r-o);if(!t||!e.length)return 1;let i=Math.max(t.width,t.height)*this.pixel/18/Math.max(e[Math.floor(.9*(e.length-1))],1e-12),s=10**Math.floor(Math.log10(i));return s*([5,2,1].find(r=>r*s<=i)??1)}get pixel(){return this.found.picture?.pixel??1}get factor(){return this.usual*2**Number(this.larger.value)}image(t){if(!this.found.picture)return null;let e=this.pictures[t];return e||(e=this.pictures[t]=p("img",{src:`/figure/date/${t}.jpg?of=${this.found.of}`,alt:""}),e.addEventListener("load",this.drawSoon),e.addEventListener("error",()=>{this.status.textContent=_("studio_epochs.no_picture",{date:this.found.dates[t]}),this.status.hidden=!1})),e}draw(){if(!this.isOpen()||!this.found.dates.length)return;let{view:t,canvas:e}=this,i=window.devicePixelRatio||1,{clientWidth:s,clientHeight:r}=this.box;t.resize(s,r),[e.width,e.height]=[Math.round(s*i),Math.round(r*i)];let o=e.getContext("2d");o.fillStyle="#2b2b2b",o.fillRect(0,0,e.width,e.height);let a=this.before?this.against:this.at,l=this.image(a),c=!!(l?.complete&&l.naturalWidth);this.status.hidden=c,this.status.textContent=l?_("studio_epochs.rectifying",{date:this.found.dates[a]}):this.found.why,l&&c&&(t.apply(o,i),o.drawImage(l,0,0,t.columns,t.rows)),o.setTransform(i,0,0,i,0,0),this.enlarged.textContent=`${fi(Math.round(this.factor*100)/100)} \xD7`;for(let h of this.found.rows)h.verdict==="stable"&&!h.area&&this.stable.checked&&this.dot(o,h,2);for(let h of this.found.rows)h.verdict!=="stable"&&this.vector(o,h);this.label(o,r)}label(t,e){t.font="600 15px system-ui, sans-serif",t.lineWidth=4,t.strokeStyle="rgba(0, 0, 0, .7)",t.fillStyle="#fff";let i=this.found.dates[this.before?this.against:this.at];t.strokeText(i,12,24),t.fillText(i,12,24);let[s,r]=Vs(60/this.view.scale*this.pixel/this.factor),o=s/this.pixel*this.factor*this.view.scale,a=ye(wt(s*r.per,2),this.found.unit?r.name:"");iu(t,14,e-18,14+o,e-18,eu,2),t.lineWidth=4,t.lineJoin="round",t.strokeStyle="rgba(0, 0, 0, .7)",t.font="13px system-ui, sans-serif",t.strokeText(a,22+o,e-14),t.fillText(a,22+o,e-14)}dot(t,e,i){if(!e.place)return;let[s,r]=this.view.toScreen(...e.place);t.fillStyle=kp,t.beginPath(),t.arc(s,r,i,0,7),t.fill()}vector(t,e){if(!e.place)return;let[i,s]=this.view.toScreen(...e.place),r=e.at.indexOf(this.at),o=e.name===this.chosen,a=r>=0&&e.moved[r],[l,c,h]=r>=0?e.seen[r]:[0,0,0],u=this.factor/this.pixel*this.view.scale,f=a?h<0?Op:Fp:tu;Math.hypot(l,c)*u>2&&iu(t,i,s,i+l*u,s-c*u,a?eu:tu,e.area||o?3:1.5),t.fillStyle=f,t.strokeStyle=o?"#fff":"rgba(255, 255, 255, .75)",t.lineWidth=o?3:1,t.beginPath(),t.arc(i,s,Math.min(Math.max(2.5,.12*Math.abs(h)*u),9)+(e.area||o?3:0),0,7),t.fill(),t.stroke()}mouse(){let{canvas:t}=this,e=null,i=0;t.addEventListener("pointerdown",s=>{e=[s.offsetX,s.offsetY],i=0,t.setPointerCapture(s.pointerId)}),t.addEventListener("pointermove",s=>{if(!e)return;let[r,o]=[s.offsetX-e[0],s.offsetY-e[1]];i+=Math.hypot(r,o),e=[s.offsetX,s.offsetY],this.view.panBy(r,o),this.drawSoon()}),t.addEventListener("pointerup",s=>{e&&i<4&&this.pick(s.offsetX,s.offsetY),e=null}),t.addEventListener("wheel",s=>{s.preventDefault(),this.view.zoomAt(Math.exp(-s.deltaY*.0016),s.offsetX,s.offsetY),this.drawSoon()},{passive:!1}),t.addEventListener("keydown",s=>{let r={ArrowRight:1,ArrowLeft:-1}[s.key];r&&(s.preventDefault(),this.turnTo(Math.min(Math.max(this.at+r,0),this.found.dates.length-1)))})}pick(t,e){let i=14,s="";for(let r of this.found.rows){if(!r.place||r.verdict==="stable")continue;let[o,a]=this.view.toScreen(...r.place),l=Math.hypot(o-t,a-e);l<i&&([i,s]=[l,r.name])}s&&this.choose(s)}rows(t){return this.found.rows.filter(i=>i.at&&i.verdict!=="stable"&&(t==="every"||(t==="untested"?i.verdict==="untested":i.verdict==="moved"||i.verdict==="moved_area"))).sort((i,s)=>Number(s.area)-Number(i.area)||Math.max(...s.length)-Math.max(...i.length))}choose(t){this.chosen=t,this.list(),this.drawSoon(),this.table.querySelector("tr.at")?.scrollIntoView({block:"nearest"})}list(){if(!this.isOpen())return;let{dates:t}=this.found,e=this.rows(this.kind),i=e.slice(0,Qh),s=Math.max(...e.flatMap(h=>h.length),.001),r=this.found.rows.find(h=>h.name===this.chosen&&h.at);r&&!i.includes(r)&&i.unshift(r),this.count.textContent=_("studio_epochs.count",{n:e.length,shown:Math.min(e.length,Qh),unit:this.found.unit?Vs(s)[1].name:""});let[,o]=Vs(s),a=this.found.unit?o:{per:1,name:""},l=p("thead",{},p("tr",{},p("th",{scope:"col"},_("studio_epochs.point")),p("th",{scope:"col"},_("studio_epochs.since")),...t.slice(1).map((h,u)=>p("th",{scope:"col",class:u+1===this.at?"now":""},h))));this.table.replaceChildren(p("table",{"aria-label":_("studio_epochs.moved_when")},l,p("tbody",{},...i.map(h=>this.row(h,a.per)))));let c=r&&!r.area?Ut("studio_epochs.visit",()=>this.visit(r.name)):"";this.chart.replaceChildren(...r?[p("h3",{},_("studio_epochs.over_time",{name:r.name,n:r.points?.length??0})),Jh(r,t,a,this.at),p("p",{class:"note"},this.axes(r,a)),c]:[p("p",{class:"note"},_("studio_epochs.nothing_chosen"))])}row(t,e){let i=t.at.find((o,a)=>t.moved[a]),s=this.found.dates.slice(1).map((o,a)=>{let l=t.at.indexOf(a+1);if(l<0)return p("td",{},"\u2013");let c=Fe(t.sigma[l]*e);return p("td",{class:t.moved[l]?"sure":""},`${Tt(t.length[l]*e,c)} \xB1 ${Tt(t.sigma[l]*e,c)}`)}),r=Zt(t.name,_("studio_epochs.choose",{name:t.name}),()=>this.choose(t.name),"link");return p("tr",{class:t.name===this.chosen?"at":"",onclick:()=>this.choose(t.name)},p("th",{scope:"row"},r),p("td",{class:"l"},i===void 0?_("studio_epochs.verdict",{verdict:t.verdict}):this.found.dates[i]),...s)}axes(t,e){let i=t.at.indexOf(this.at);if(i<0)return _("studio_epochs.no_place",{date:this.found.dates[this.at]});let s=["X","Y","Z"].map((r,o)=>{let a=Fe(t.s[i][o]*e.per);return`d${r} ${Tt(t.d[i][o]*e.per,a)} \xB1 ${Tt(t.s[i][o]*e.per,a)}`});return _("studio_epochs.at_date",{from:this.found.dates[t.first],to:this.found.dates[this.at],values:ye(s.join(", "),e.name)})}};function iu(n,t,e,i,s,r,o){let a=Math.atan2(s-e,i-t),l=Math.min(4+2*o,Math.hypot(i-t,s-e));for(let[c,h]of[["rgba(255, 255, 255, .75)",2.5],[r,0]]){n.strokeStyle=c,n.lineWidth=o+h,n.beginPath(),n.moveTo(t,e),n.lineTo(i,s);for(let u of[2.7,-2.7])n.moveTo(i,s),n.lineTo(i+l*Math.cos(a+u),s+l*Math.sin(a+u));n.stroke()}}var so=class{constructor(t){this.model=t;this.rows=p("table",{"aria-label":_("studio_point.fiducials")});this.head=p("summary",{},_("studio_point.fiducials"));this.about=p("p",{class:"note"});this.card=p("details",{class:"card",id:"fiducials",open:!0,hidden:!0},this.head,this.about,this.rows,Ut("studio_point.find_fiducials",()=>void this.find()));rt("right").prepend(this.card),t.on(["state","overview","panes","fiducial"],()=>this.show())}async find(){let{model:t}=this,e=t.panes[t.active];try{let i=await t.actions.fiducials(e);t.take(i.state);let s=Object.entries(i.left).map(([r,o])=>`${r}: ${o}`);t.show([_("studio_point.fiducials_found",{n:i.found.length}),...s].join("; "),s.length?"bad":"good","studio_point.fiducials_found"),t.chooseFiducial("")}catch(i){t.fail(i)}}show(){let{model:t}=this,e=t.overview.fiducials;this.card.hidden=!e.length;let i=t.panes[t.active];if(!e.length||!i)return;let s=new Map(t.fiducialsIn(i).map(r=>[r.name,r]));this.head.textContent=_("studio_point.fiducials_of",{image:i,n:s.size,of:e.length}),this.about.textContent=t.fiducial?_("studio_point.click_fiducial",{name:t.fiducial}):_("studio_point.fiducials_note"),this.rows.replaceChildren(...e.map(r=>{let o=s.get(r),a=Zt(r,_("studio_point.measure",{name:r}),()=>t.chooseFiducial(t.fiducial===r?"":r),"link");a.setAttribute("aria-pressed",String(t.fiducial===r));let l=()=>void t.act("fiducial",{image:i,name:r},"studio_point.removed",{name:r});return p("tr",{class:t.fiducial===r?"at":""},p("td",{},a),p("td",{},o?`${Tt(o.x,1)}; ${Tt(o.y,1)}`:"\u2013"),p("td",{},o?_("studio_point.how",{how:o.how}):""),p("td",{},...o?[Zt("\u2715",_("studio_point.remove",{name:r}),l,"small")]:[]))}))}};var oi=(n,t,e={})=>p("input",{id:n,"aria-label":t,placeholder:t,autocomplete:"off",spellcheck:"false",...e});function Qn(n){let t=n.value.trim().replace(",",".");return t?Number(t):null}function Gs(n,t,e){return e!==null&&Number.isFinite(e)?!0:(n.say("studio_point.number_missing",{field:t.getAttribute("aria-label")},"bad"),t.focus(),!1)}var ts=(n,t)=>t?`${n}: ${t}`:n,ro=class{constructor(t){this.model=t;this.start=oi("bar-start",_("studio_point.bar_start"),{list:"bar-names"});this.end=oi("bar-end",_("studio_point.bar_end"),{list:"bar-names"});this.length=oi("bar-length",_("label.length"),{inputmode:"decimal"});this.sigma=oi("bar-sigma",_("label.sigma"),{inputmode:"decimal"});this.names=p("datalist",{id:"bar-names"});this.rows=p("table",{"aria-label":_("studio_point.bars")});this.head=p("summary",{},_("studio_point.bars"));let e=p("form",{},p("div",{class:"row"},this.start,this.end,Zt("\u21E4",_("studio_point.last_two"),()=>this.latest())),p("div",{class:"row"},this.length,this.sigma,p("button",{type:"submit",id:"bar-add"},_("studio_point.give")),this.names));e.addEventListener("submit",i=>{i.preventDefault(),this.give()}),rt("right").append(p("details",{class:"card",open:!0},this.head,this.rows,e)),t.on(["state","overview"],()=>this.show()),t.on("current",()=>{!t.current||document.activeElement===this.start||document.activeElement===this.end||this.start.value||(this.start.placeholder=_("studio_point.bar_start_as",{point:t.current}))})}latest(){let t=[...new Set([...this.model.state.marks].reverse().map(e=>e.point))];[this.end.value,this.start.value]=[t[0]??"",t[1]??""],this.length.focus()}async give(){let[t,e]=[Qn(this.length),Qn(this.sigma)];if(!Gs(this.model,this.length,t)||!Gs(this.model,this.sigma,e))return;let[i,s]=[this.start.value.trim(),this.end.value.trim()];await this.model.act("bar",{start:i,end:s,length:t,sigma:e},"studio_point.bar_given",{start:i,end:s,length:String(t)})&&[this.start,this.end,this.length,this.sigma].forEach(o=>o.value="")}show(){let{state:t,overview:e}=this.model,i=e.unit;this.head.textContent=ts(_("studio_point.bars"),t.bars.length),this.length.placeholder=ye(_("label.length"),i||"m"),this.sigma.placeholder=ye(_("label.sigma"),i||"m"),this.names.replaceChildren(...t.points.slice(-200).map(s=>p("option",{value:s.point}))),this.rows.hidden=!t.bars.length,this.rows.replaceChildren(...t.bars.map(s=>p("tr",{},p("td",{},`${s.start} \u2013 ${s.end}`),p("td",{},String(s.length)),p("td",{},`\xB1 ${wt(s.sigma)}`),p("td",{},Zt("\u2715",_("studio_point.remove",{name:`${s.start} \u2013 ${s.end}`}),()=>void this.model.act("unbar",{start:s.start,end:s.end},"studio_point.removed",{name:`${s.start} \u2013 ${s.end}`}),"small")))))}},oo=class{constructor(t){this.model=t;this.role=p("select",{id:"control-role","aria-label":_("studio_point.role_of_current")},...xe(["tie","control","check"],t=>_("studio_point.role",{role:t})));this.xyz=["X","Y","Z"].map(t=>oi(`control-${t}`,t,{inputmode:"decimal"}));this.sigma=["X","Y","Z"].map(t=>oi(`control-s${t}`,_("label.sigma_of",{symbol:t}),{inputmode:"decimal"}));this.rows=p("table",{"aria-label":_("studio_point.control")});this.head=p("summary",{},_("studio_point.control"));this.about=p("p",{class:"note"});let e=p("input",{type:"file",id:"control-file",accept:".csv,.txt,text/csv","aria-label":_("studio_point.control_table")});e.addEventListener("change",()=>void(e.files?.[0]&&this.drop(e.files[0]).then(()=>e.value="")));let i=p("form",{},this.about,p("div",{class:"row"},this.role,p("button",{type:"submit",id:"control-give"},_("studio_point.give"))),p("div",{class:"row three"},...this.xyz),p("div",{class:"row three"},...this.sigma),p("p",{class:"note"},_("studio_point.control_note")),e);i.addEventListener("submit",s=>{s.preventDefault(),this.give()}),rt("right").append(p("details",{class:"card"},this.head,this.rows,i)),t.on(["state","overview"],()=>this.show()),t.on("current",()=>void this.fill()),document.body.dataset.drop=_("studio_point.drop"),this.dropping()}dropping(){addEventListener("dragover",t=>{t.dataTransfer?.types.includes("Files")&&(t.preventDefault(),document.body.classList.add("dropping"))}),addEventListener("dragleave",t=>t.relatedTarget===null&&document.body.classList.remove("dropping")),addEventListener("drop",t=>{t.preventDefault(),document.body.classList.remove("dropping");let e=t.dataTransfer?.files[0];e&&this.drop(e)})}async drop(t){if(t.size>4e6)return this.model.say("studio_point.table_too_large",{name:t.name},"bad");try{let e=await this.model.actions.control(t.name,await t.text());this.model.command=e.command,this.model.take(e.state),this.model.show([_("studio_point.control_added",{n:e.added.length,name:t.name}),...e.remarks].join("; "),"good","studio_point.control_added")}catch(e){this.model.fail(e)}}async give(){let{model:t}=this;if(!t.current)return t.say("studio_point.none_chosen",{},"bad");let[e,i]=[this.xyz.map(Qn),this.sigma.map(Qn)];for(let[r,o]of[...e,...i].entries()){let a=[...this.xyz,...this.sigma][r];if(o!==null&&!Gs(t,a,o))return}let s=this.role.value;await t.act("point",{point:t.current,role:s,xyz:e,sigma:i},"studio_point.role_given",{point:t.current,role:s})}fields(t,e,i){this.role.value=t,this.xyz.forEach((s,r)=>s.value=e[r]===null?"":String(e[r])),this.sigma.forEach((s,r)=>s.value=i[r]===null?"":String(i[r]))}async fill(){let{model:t}=this,e=t.current,i=t.state.points.find(o=>o.point===e);if(this.about.textContent=e?_("studio_point.of_point",{point:e}):_("studio_point.none_chosen"),this.fields(i?.role??"tie",i?.xyz??[null,null,null],i?.sigma??[null,null,null]),i||!e)return;let r=(await Ft("/api/points",{search:e,limit:200})).rows.find(o=>o.point===e);r&&t.current===e&&(this.role.value=r.role)}show(){let{state:t}=this.model,e=t.points.filter(i=>i.role!=="tie"||i.xyz.some(s=>s!==null));this.head.textContent=ts(_("studio_point.control"),e.length),this.rows.hidden=!e.length,this.rows.replaceChildren(...e.slice(0,300).map(i=>p("tr",{},p("td",{},Zt(i.point,_("studio_point.choose",{point:i.point}),()=>this.model.choose(i.point),"link")),p("td",{},_("studio_point.role",{role:i.role})),...i.xyz.map(s=>p("td",{},wt(s,7)))))),document.activeElement instanceof HTMLInputElement||this.fill()}};function su(n,t){let e=p("datalist",{id:`${n}-names`}),i=oi(n,t,{list:`${n}-names`,maxlength:"200"});return i.addEventListener("input",ke(()=>void Ft("/api/points",{search:i.value.trim(),limit:12}).then(s=>e.replaceChildren(...s.rows.map(r=>p("option",{value:r.point}))),()=>{}),150)),[i,e]}var ao=class{constructor(t){this.model=t;this.name=oi("line-name",_("studio_point.line_name"),{maxlength:"200"});this.kind=p("select",{id:"line-kind","aria-label":_("studio_point.line_kinds")},...xe(["straight","plumb","level","plane"],t=>_("studio_point.line_kind",{kind:t})));this.sigma=oi("line-sigma",_("label.sigma"),{inputmode:"decimal"});this.follow=p("input",{type:"checkbox",id:"line-follow"});this.picked=p("ol",{class:"picked",id:"line-points","aria-label":_("studio_point.line_points")});this.rows=p("table",{"aria-label":_("studio_point.lines")});this.head=p("summary",{},_("studio_point.lines"));this.points=[];let[e,i]=su("line-point",_("label.point"));this.point=e,e.addEventListener("keydown",r=>{r.key!=="Enter"||!e.value.trim()||(r.preventDefault(),this.add())});let s=p("form",{},p("div",{class:"row"},this.name),p("div",{class:"row"},this.kind,this.sigma),p("div",{class:"row"},e,i,Ut("studio_point.add",()=>this.add())),p("label",{class:"check",title:Oe("studio_point.add_chosen")},this.follow,_("studio_point.add_chosen")),this.picked,p("div",{class:"row"},p("button",{type:"submit",id:"line-give"},_("studio_point.give")),Ut("studio_point.clear",()=>this.pick([]))));s.addEventListener("submit",r=>{r.preventDefault(),this.give()}),rt("right").append(p("details",{class:"card"},this.head,this.rows,s)),t.on(["state","overview"],()=>this.show()),t.on("current",()=>this.follow.checked&&t.current&&this.pick([...this.points,t.current]))}add(){let t=this.point.value.trim()||this.model.current;if(!t)return this.model.say("studio_point.none_chosen",{},"bad");this.pick([...this.points,t]),this.point.value="",this.point.focus()}pick(t){this.points=[...new Set(t)],this.picked.hidden=!this.points.length,this.picked.replaceChildren(...this.points.map(e=>p("li",{},e," ",Zt("\u2715",_("studio_point.remove",{name:e}),()=>this.pick(this.points.filter(i=>i!==e)),"small"))))}async give(){let{model:t}=this,e=Qn(this.sigma);if(!Gs(t,this.sigma,e))return;let i=this.name.value.trim(),s=this.kind.value;await t.act("line",{line:i,points:this.points,kind:s,sigma:e},"studio_point.line_given",{kind:s,line:i,points:this.points.join(", ")})&&(this.name.value="",this.follow.checked=!1,this.pick([]))}show(){let{state:t,overview:e}=this.model;this.sigma.placeholder=ye(_("label.sigma"),e.unit),this.sigma.title=_("studio_point.line_sigma"),this.head.textContent=ts(_("studio_point.lines"),t.lines.length),this.rows.hidden=!t.lines.length,this.rows.replaceChildren(...t.lines.map(i=>p("tr",{},p("td",{},i.line),p("td",{},_("studio_point.line_kind",{kind:i.kind})),p("td",{class:"l"},i.points.join(", ")),p("td",{},`\xB1 ${wt(i.sigma)}`),p("td",{},Zt("\u2715",_("studio_point.remove",{name:i.line}),()=>void this.model.act("line",{line:i.line,points:[]},"studio_point.removed",{name:i.line}),"small"))))),this.picked.hidden=!this.points.length}},nu=[["origin","studio_point.origin"],["axis","studio_point.on_axis"],["plane","studio_point.in_plane"]],lo=class{constructor(t){this.model=t;this.about=p("p",{class:"note"});this.away=Ut("studio_point.remove_datum",()=>void this.model.act("datum",{},"studio_point.datum_removed"));let e=nu.map(([r,o])=>su(`datum-${r}`,_(o)));this.inputs=e.map(([r])=>r);let i=(r,o)=>Zt("\u21E4",_("studio_point.use_current",{role:_(o)}),()=>r.value=t.current),s=p("form",{},this.about,...e.map(([r,o],a)=>p("div",{class:"row"},r,o,i(r,nu[a][1]))),p("div",{class:"row"},p("button",{type:"submit",id:"datum-give"},_("studio_point.give")),this.away));s.addEventListener("submit",r=>{r.preventDefault(),this.give()}),rt("right").append(p("details",{class:"card"},p("summary",{},_("studio_point.datum")),s)),t.on("state",()=>this.show())}async give(){let[t,e,i]=this.inputs.map(r=>r.value.trim());await this.model.act("datum",{origin:t,axis:e,plane:i},"studio_point.datum_given",{points:[t,e,i].filter(r=>r).join(", ")})&&this.inputs.forEach(r=>r.value="")}show(){let{datum:t}=this.model.state;this.away.disabled=!t,this.about.textContent=t?_("studio_point.datum_is",{...t,plane:t.plane||"none"}):_("studio_point.datum_note")}},co=class{constructor(t){this.model=t;this.to=oi("rename-to",_("studio_point.new_name"),{maxlength:"200"});this.about=p("p",{class:"note"});let e=p("form",{},this.about,p("div",{class:"row"},this.to,p("button",{type:"submit",id:"rename-give"},_("studio_point.rename")),Ut("studio_point.forget",()=>this.forget())));e.addEventListener("submit",i=>{i.preventDefault(),this.rename()}),rt("right").append(p("details",{class:"card"},p("summary",{},_("studio_point.rename_or_forget")),e)),t.on("current",()=>this.show()),this.show()}show(){this.about.textContent=this.model.current?_("studio_point.of_point",{point:this.model.current}):_("studio_point.none_chosen")}async rename(){let{model:t}=this,e=t.current;if(!e)return t.say("studio_point.none_chosen",{},"bad");let i=this.to.value.trim();await t.act("rename",{point:e,to:i},"studio_point.renamed",{point:e,to:i})&&(this.to.value="",t.choose(i))}forget(){let{model:t}=this;if(!t.current)return t.say("studio_point.none_chosen",{},"bad");t.act("forget",{point:t.current},"studio_point.forgotten",{point:t.current})}};var Bp=0,Tn=class{constructor(t,e,i,s){this.keyOf=e;this.row=i;this.chosen=s;this.items=[];this.at=-1;this.id=`list${Bp++}`;this.root=p("div",{role:"listbox",tabindex:0,class:"choice","aria-label":t}),this.root.addEventListener("keydown",r=>this.key(r)),this.root.addEventListener("click",r=>{let o=r.target.closest("[role=option]"),a=o?[...this.root.children].indexOf(o):-1;a<0||(this.point(a),this.chosen(this.items[a],r))})}set(t,e=""){this.items=t,this.root.replaceChildren(...t.map((i,s)=>p("div",{role:"option",id:`${this.id}-${s}`,"aria-selected":"false"},...this.row(i)))),this.at=-1,this.select(e)}select(t){this.items.forEach((e,i)=>{let s=this.keyOf(e)===t;this.root.children[i].setAttribute("aria-selected",String(s)),s&&this.point(i)})}get length(){return this.items.length}point(t){this.root.children[this.at]?.classList.remove("at"),this.at=t;let e=this.root.children[t];if(!e)return;e.classList.add("at"),this.root.setAttribute("aria-activedescendant",e.id);let{offsetTop:i,offsetHeight:s}=e,{scrollTop:r,clientHeight:o}=this.root;i<r?this.root.scrollTop=i:i+s>r+o&&(this.root.scrollTop=i+s-o)}key(t){let e=this.items.length-1,i={ArrowDown:Math.min(this.at+1,e),ArrowUp:Math.max(this.at-1,0),Home:0,End:e,PageDown:Math.min(this.at+8,e),PageUp:Math.max(this.at-8,0)};if(t.key in i)this.point(i[t.key]);else if(t.key==="Enter"&&this.at>=0)this.chosen(this.items[this.at],t);else return;t.preventDefault(),t.stopPropagation()}};var Ws=512,zp=4,Hp=320,Vp=2500,An=(n,t,e,i)=>`${n}/${t}/${e}/${i}`;function Xs(n,t){let e=0;for(;Math.max(n,t)>Ws;)n=Math.ceil(n/2),t=Math.ceil(t/2),e++;return e}var Kl=class{constructor(){this.cache=new Map;this.loading=new Map;this.wanted=new Map;this.failed=new Map;this.listeners=new Set;this.arrived=vi(()=>this.listeners.forEach(t=>t()));this.timesRead=0;this.times=[]}onarrival(t){return this.listeners.add(t),()=>this.listeners.delete(t)}readAnew(t){t!==this.timesRead&&(this.timesRead=t,this.loading.forEach(e=>e.abort()),this.cache.forEach(e=>e.close()),this.cache.clear(),this.failed.clear())}get(t){let e=this.cache.get(t);return e&&(this.cache.delete(t),this.cache.set(t,e)),e}why(t){return this.failed.get(t)??""}want(t,e,i=!1){let s=e.filter(o=>!this.cache.has(o)&&!this.failed.has(o));s.length?this.wanted.set(t,{keys:s,late:i}):this.wanted.delete(t);let r=new Set([...this.wanted.values()].flatMap(o=>o.keys));for(let[o,a]of this.loading)r.has(o)||a.abort();this.pump()}pump(){for(;this.loading.size<zp;){let t=this.next();if(!t)return;this.load(t)}}next(){for(let t of[!1,!0]){if(t&&this.loading.size)return;let e=[...this.wanted.values()].filter(s=>s.late===t),i=Math.max(0,...e.map(s=>s.keys.length));for(let s=0;s<i;s++)for(let{keys:r}of e){let o=r[s];if(o&&!this.loading.has(o)&&!this.cache.has(o)&&!this.failed.has(o))return o}}}async load(t){let e=new AbortController;this.loading.set(t,e);let i=performance.now(),s=this.timesRead;try{let r=await fetch(`/api/tile/${t}?read=${s}`,{signal:e.signal});if(r.status===404)this.failed.set(t,(await r.json()).error);else if(r.ok){let o=await createImageBitmap(await r.blob());s===this.timesRead&&this.keep(t,o),this.times.push(performance.now()-i)}else throw new Error(String(r.status))}catch{e.signal.aborted||await new Promise(r=>setTimeout(r,Vp))}this.loading.delete(t),this.arrived(),this.pump()}keep(t,e){for(this.cache.set(t,e);this.cache.size>Hp;){let i=this.cache.keys().next().value;this.cache.get(i).close(),this.cache.delete(i)}}},Be=new Kl;var Gp=72,Wp=54,ho=class{constructor(t,e){this.model=t;this.filter=rt("image-filter");this.small=new Map;this.list=new Tn(_("studio_page.images"),s=>s.id,s=>this.row(s),(s,r)=>{e(s.id,r.shiftKey)}),rt("image-list").append(this.list.root),this.watch=new IntersectionObserver(s=>s.forEach(r=>this.seen(r)),{root:this.list.root}),Be.onarrival(()=>this.small.forEach((s,r)=>this.draw(r,s))),this.filter.addEventListener("input",()=>this.show()),t.on("overview",()=>this.show()),t.on("panes",()=>this.list.select(t.panes[t.active]??""))}show(){let t=this.filter.value.toLowerCase();this.watch.disconnect(),this.small.forEach((i,s)=>Be.want(s,[])),this.small.clear();let e=[...this.model.images.values()].filter(i=>i.id.toLowerCase().includes(t));this.list.set(e,this.model.panes[this.model.active]),rt("images-head").textContent=_("studio_photo.count",{n:e.length})}row(t){let e=p("canvas",{width:Gp*2,height:Wp*2,"aria-hidden":"true"});this.small.set(e,t),queueMicrotask(()=>this.watch.observe(e));let i=t.rms_px===null?"":`, ${wt(t.rms_px,2)}\xA0px`,s=t.oriented?_("studio_photo.rays",{n:t.rays})+i:_("studio_photo.not_oriented",{n:this.model.marksIn(t.id).length});return[e,p("span",{class:"about",title:t.id},p("b",{},t.id),p("small",{class:t.oriented?"":"open"},s))]}seen(t){let e=this.small.get(t.target);if(!e?.photo)return;let i=An(e.k,Xs(e.width,e.height),0,0);Be.want(t.target,t.isIntersecting?[i]:[],!0),this.draw(t.target,e)}draw(t,e){let i=Xs(e.width,e.height),s=t.dataset.drawn?void 0:Be.get(An(e.k,i,0,0));if(!s)return;t.dataset.drawn="yes";let r=t.getContext("2d"),[o,a]=e.turn&1?[s.height,s.width]:[s.width,s.height],l=Math.min(t.width/o,t.height/a);r.translate(t.width/2,t.height/2),r.rotate(e.turn*Math.PI/2),r.imageSmoothingQuality="high",r.drawImage(s,-s.width*l/2,-s.height*l/2,s.width*l,s.height*l)}};var ou=.36,jl=class{constructor(){this.areas=new Map;this.pictures=new Map}draw(t,e,i,s,r){let o=this.picture(i,s.id);o&&(e.apply(t,r),t.imageSmoothingEnabled=!1,t.globalAlpha=ou,t.drawImage(o,0,0,s.width,s.height),t.globalAlpha=1),t.setTransform(r,0,0,r,0,0);for(let a of this.drawn(i,s.id))ru(t,e,a.polygon,!0);if(!(!Kt.on||Kt.image!==s.id)){ru(t,e,Kt.corners,!1);for(let[a,l]of Kt.corners){let[c,h]=e.toScreen(a,l);t.beginPath(),t.rect(c-4,h-4,8,8),t.fillStyle=ie.current,t.fill(),t.lineWidth=1.5,t.strokeStyle="#000000",t.stroke()}}}drawn(t,e){let{masks:i}=t.state;if(!i.length)return[];let s=i.filter(a=>a.image===e);if(!i.some(a=>a.camera&&a.image!==e))return s;let r=JSON.stringify(i),o=this.areas.get(e);return o?.of===r?o.found:(this.areas.set(e,{of:r,found:s}),Ft("/api/masks",{image:e}).then(({areas:a})=>{this.areas.set(e,{of:r,found:a}),t.emit("looks")},()=>this.areas.delete(e)),s)}picture(t,e){if(!t.overview.masks_given)return null;let i=this.pictures.get(e);return i!==void 0?i:(this.pictures.set(e,null),Gr(`/api/mask?image=${encodeURIComponent(e)}`).then(async s=>{s.byteLength&&(this.pictures.set(e,await createImageBitmap(new Blob([s],{type:"image/png"}))),t.emit("looks"))}).catch(()=>this.pictures.delete(e)),null)}};function ru(n,t,e,i){n.beginPath(),e.forEach(([s,r],o)=>o?n.lineTo(...t.toScreen(s,r)):n.moveTo(...t.toScreen(s,r))),n.globalAlpha=ou,n.fillStyle=ie.masked,n.fill("evenodd"),n.globalAlpha=1,i&&n.closePath();for(let[s,r]of[["#000000b0",3.2],[ie.masked,1.4]])n.lineWidth=r,n.strokeStyle=s,n.stroke()}var au=new jl;var lu=.5,Xp=450,qs=(n,t,e)=>({x_px:n,y_px:t,covariance:[lu**2,lu**2,0],how:"hand",clicked:e,quality:null}),qp=2,Yp=6,[$p,Zp]=[2,12],Kp=n=>Math.min(Math.max(Yp/n,$p),Zp);function uo(n,t,e,i){let s=Math.sqrt(Math.max(e.covariance[0],e.covariance[1])),r=e.clicked?Math.hypot(e.x_px-e.clicked[0],e.y_px-e.clicked[1]):0;return[n,{point:t,how:e.how,sigma_px:wt(s,2),cause:i||"none",far_px:i||r<qp?0:r}]}var Rn=class n{constructor(t){this.model=t;this.moving=new Map;this.resting=0;this.worstOnes=[];this.worstAt=-1;t.on("read",()=>this.worstAt=-1)}static key(t,e){return`${t}
${e}`}async place(t,e,i,s){let{model:r}=this;if(r.fiducial)return this.placeFiducial(t,e,i,s);let o=r.current;if(!o)return r.say("studio_point.none_chosen",{},"bad");if(r.mark(t,o))return r.say("studio_point.marked_before",{point:o},"bad");let[a,l]=await this.snapped(t,o,e,i,s);await r.act("put",{image:t,point:o,...a},...uo("studio_point.marked",o,a,l))}async placeFiducial(t,e,i,s){let{model:r}=this,o=r.fiducial,[a,l]=await this.snapped(t,"",e,i,s);if(!await r.act("fiducial",{image:t,name:o,...a},...uo("studio_point.marked",o,a,l)))return;let h=new Set(r.fiducialsIn(t).map(m=>m.name)),u=r.overview.fiducials,f=[...u.slice(u.indexOf(o)),...u].find(m=>!h.has(m))??"";r.chooseFiducial(f)}async move(t,e,i,s,r){let[o,a]=await this.snapped(t,e,i,s,r);await this.model.act("move",{image:t,point:e,...o},...uo("studio_point.moved",e,o,a)),this.moving.delete(n.key(t,e)),this.model.emit("looks")}async snapped(t,e,i,s,r){if(Xt.snap==="hand")return[qs(i,s,[i,s]),""];try{let o=await Ue("/api/snap",{image:t,x:i,y:s,kind:Xt.snap,point:e,reach:Kp(r)});if("why"in o)return[qs(i,s,[i,s]),o.why];let{cov:a,how:l,quality:c}=o;return[{x_px:o.x,y_px:o.y,covariance:a,how:l,clicked:[i,s],quality:c},""]}catch(o){return[qs(i,s,[i,s]),o instanceof yi?o.message:_("studio_page.no_answer")]}}nudge(t,e,i){let{model:s}=this,r=s.mark(t,s.current);if(!r)return s.say("studio_point.not_marked",{},"bad");let o=n.key(t,r.point),[a,l]=this.moving.get(o)??[r.x,r.y];this.moving.set(o,[a+e,l+i]),s.emit("looks"),clearTimeout(this.resting),this.resting=window.setTimeout(()=>void this.rest(t,r.point,r.clicked),Xp)}async rest(t,e,i){let s=n.key(t,e),r=this.moving.get(s);r&&(await this.model.act("move",{image:t,point:e,...qs(r[0],r[1],i)},...uo("studio_point.moved",e,qs(r[0],r[1],null),"")),this.moving.delete(s),this.model.emit("looks"))}async remove(t){let e=this.model.current;if(!this.model.mark(t,e))return this.model.say("studio_point.not_marked",{},"bad");await this.model.act("remove",{image:t,point:e},"studio_point.mark_removed",{point:e})}async reject(t,e){(this.model.isRejected(t,e)?await this.model.act("accept",{image:t,point:e},"studio_point.accepted",{point:e}):await this.model.act("reject",{image:t,point:e},"studio_point.rejected",{point:e}))&&this.model.emit("looks")}async undo(){await this.model.act("undo",{},"studio_page.undone")}async redo(){await this.model.act("redo",{},"studio_page.redone")}async newPoint(){let t=new Set(this.model.state.points.map(e=>e.point));for(let e=1;;e++){let i=`M${e}`;if(!(t.has(i)||(await Ft("/api/points",{search:i,limit:500})).rows.some(r=>r.point===i))){this.model.choose(i),this.model.say("studio_point.new_point",{point:i});return}}}async worstNext(){if(this.worstAt<0&&(this.worstOnes=(await Ft("/api/worst")).worst),!this.worstOnes.length)return this.model.say("studio_point.no_worst"),null;this.worstAt=(this.worstAt+1)%this.worstOnes.length;let t=this.worstOnes[this.worstAt],{kind:e,point:i,value:s}=t;return this.model.say("studio_point.worst",{number:this.worstAt+1,of:this.worstOnes.length,point:i,kind:e,value:wt(s),n:Math.round(s),unit:this.model.overview.unit}),t}};var jp={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},Jp=40;function cu(n,t){let e=jp[t.key];if(e)return Qp(n,t,...e);if(t.ctrlKey||t.metaKey||t.altKey)return!1;switch(t.key){case"+":case"=":return n.zoom(1.25),!0;case"-":return n.zoom(.8),!0;case"0":return n.fit(),!0;case"1":return n.zoom(1/n.view.scale),!0;case"Enter":return n.enter(),!0;case"r":return n.turn(1),!0;case"Delete":case"Backspace":return Kt.on?Kt.removeLast():n.measuring.remove(n.picture.id),!0;case"p":return tm(n);case"x":return em(n);default:return!1}}function Qp(n,t,e,i){let{view:s}=n;if(t.shiftKey||t.altKey){let[o,a]=s.along(e,i),l=t.altKey?.01:.1;return n.measuring.nudge(n.picture.id,l*o,l*a),!0}let r=t.ctrlKey||t.metaKey?s.scale:Jp;return n.pan(-r*e,-r*i),!0}function tm(n){let t=n.pointHere();return t?n.model.choose(t):n.model.say("studio_photo.no_point_here"),!0}function em(n){let t=n.pointHere();return t?n.measuring.reject(n.picture.id,t):n.model.say("studio_photo.no_point_here"),!0}function Jl(n,t,e,i,s=[0,0]){let r=Xs(e.width,e.height),o=Math.min(Math.max(Math.floor(-Math.log2(t.scale*i)+.25),0),r);t.apply(n,i,s),n.imageSmoothingEnabled=t.scale*i<4,n.imageSmoothingQuality="high",n.save(),n.beginPath(),n.rect(0,0,e.width,e.height),n.clip();let a=An(e.k,r,0,0),l=Be.get(a);l&&n.drawImage(l,0,0,l.width*2**r,l.height*2**r);let c=[a];return o<r&&c.push(...im(n,t,e,o,r)),n.restore(),c}function im(n,t,e,i,s){let r=Ws*2**i,[o,a,l,c]=t.seen(),h=[];for(let u=Math.floor(a/r);u*r<c;u++)for(let f=Math.floor(o/r);f*r<l;f++){let m=An(e.k,i,f,u),v=Math.hypot((f+.5)*r-t.x,(u+.5)*r-t.y);h.push([v,m]);let M=Be.get(m);M?n.drawImage(M,f*r,u*r,M.width*2**i,M.height*2**i):nm(n,e.k,i,f,u,s)}return h.sort((u,f)=>u[0]-f[0]).map(([,u])=>u)}function nm(n,t,e,i,s,r){for(let o=1;e+o<r;o++){let a=Be.get(An(t,e+o,i>>o,s>>o));if(!a)continue;let l=Ws>>o,c=(i&(1<<o)-1)*l,h=(s&(1<<o)-1)*l,u=Math.min(l,a.width-c),f=Math.min(l,a.height-h),m=Ws*2**e,v=2**(e+o);u>0&&f>0&&n.drawImage(a,c,h,u,f,i*m,s*m,u*v,f*v);return}}var ze=190,fo=class{constructor(t,e,i,s){this.model=t;this.measuring=e;this.stage=i;this.picture=s;this.photo=p("canvas",{class:"photo"});this.over=p("canvas",{class:"over"});this.status=p("p",{class:"status"});this.tip=p("div",{class:"tip",hidden:!0});this.observations=null;this.hover=-1;this.at=null;this.keyboard=!1;this.draw=vi(()=>this.drawn());this.watch=new ResizeObserver(()=>this.sized());this.view=new rn(s.width,s.height,s.turn),this.body=p("div",{class:"canvas",tabindex:0,role:"application","aria-label":_("studio_photo.canvas",{image:s.id})},this.photo,this.over,this.status,this.tip),this.root=p("section",{class:"pane","aria-label":_("studio_photo.pane",{image:s.id})},this.head(),this.body),this.forget=Be.onarrival(()=>this.draw()),this.watch.observe(this.body),this.pointers(),this.body.addEventListener("keydown",r=>this.key(r)),this.body.addEventListener("focus",()=>this.stage.activate(this)),this.body.addEventListener("blur",()=>this.redraw()),this.read()}head(){let t=this.picture.id;return p("header",{},p("b",{class:"name"},t),Zt("\u27F2",_("studio_photo.turn_left",{image:t}),()=>this.turn(3)),Zt("\u27F3",_("studio_photo.turn_right",{image:t}),()=>this.turn(1)),Zt("1:1",_("studio_photo.pixels",{image:t}),()=>this.zoom(1/this.view.scale)),Ut("studio_photo.fit",()=>this.fit(),"",{image:t}),Zt("\u2715",_("studio_photo.close",{image:t}),()=>this.stage.close(this)))}async read(){try{this.observations=await this.model.observations(this.picture.id)}catch(t){this.model.fail(t)}this.redraw()}gone(){this.forget(),this.watch.disconnect(),Be.want(this,[]),this.root.remove()}redraw(){this.draw()}sized(){let{clientWidth:t,clientHeight:e}=this.body;for(let i of[this.photo,this.over])i.width=Math.round(t*devicePixelRatio),i.height=Math.round(e*devicePixelRatio);this.view.resize(t,e),this.drawn()}rejectedHere(){return new Set(this.model.state.rejected.filter(([t])=>t===this.picture.id).map(([,t])=>t))}placed(t){let e=this.measuring.moving.get(Rn.key(t.image,t.point));return{mark:t,x:e?.[0]??t.x,y:e?.[1]??t.y}}marks(){return this.model.marksIn(this.picture.id).map(t=>this.placed(t))}shown(){let{model:t,picture:e}=this,i=t.prediction?.predictions.find(s=>s.image===e.id)??null;return{observations:this.observations,rejectedHere:this.rejectedHere(),marks:this.marks(),prediction:i,off:t.prediction?.off.includes(e.id)??!1,image:e.id,fiducials:t.fiducialsIn(e.id),fiducial:t.fiducial,current:t.current,hover:this.hover,hair:this.keyboard&&document.activeElement===this.body}}drawn(){let{view:t,picture:e}=this,i=devicePixelRatio,s=this.photo.getContext("2d",{alpha:!1});s.setTransform(1,0,0,1,0,0),s.fillStyle="#2b2b2b",s.fillRect(0,0,this.photo.width,this.photo.height),this.photo.style.filter=Wl();let r=Jl(s,t,e,i),o=this.over.getContext("2d");o.setTransform(1,0,0,1,0,0),o.clearRect(0,0,this.over.width,this.over.height),au.draw(o,t,this.model,e,i),qh(o,t,this.shown(),i);let a=Ee.on?Ee.of(e.id):null;a&&$h(o,t,a),Xt.loupe&&(this.at||document.activeElement===this.body)&&r.push(...this.loupe(o,i)),Be.want(this,r),this.status.textContent=e.photo?Be.why(r[0]):_("studio_photo.unknown")}loupe(t,e){let[i,s]=this.at??[this.view.width/2,this.view.height/2],[r,o]=this.view.toImage(i,s),a=new rn(this.picture.width,this.picture.height,this.view.turn);Object.assign(a,{x:r,y:o,scale:Math.min(4*this.view.scale,Math.max(16,this.view.scale)),width:ze,height:ze,fitted:!1});let l=i+ze+30<this.view.width?i+24:i-ze-24,c=s+ze+30<this.view.height?s+24:s-ze-24;t.save(),t.setTransform(e,0,0,e,0,0),t.beginPath(),t.rect(l,c,ze,ze),t.fillStyle="#2b2b2b",t.fill(),t.clip(),t.filter=Wl();let h=Jl(t,a,this.picture,e,[l,c]);return t.restore(),t.setTransform(e,0,0,e,0,0),t.beginPath(),t.rect(l,c,ze,ze),t.moveTo(l+ze/2,c),t.lineTo(l+ze/2,c+ze),t.moveTo(l,c+ze/2),t.lineTo(l+ze,c+ze/2),t.lineWidth=1,t.strokeStyle=ie.current,t.stroke(),h}turn(t){this.view.turn=this.view.turn+t&3,this.view.fitted&&this.view.fit(),this.redraw()}fit(){this.view.fit(),this.redraw(),this.showPlace()}zoom(t,e,i){this.view.zoomAt(t,e,i),this.stage.moved(this,0,0,t),this.redraw(),this.showPlace()}pan(t,e){this.view.panBy(t,e),this.stage.moved(this,t,e,1),this.redraw(),this.showPlace()}show(t,e,i=1){this.view.scale=Math.max(this.view.scale,i),this.view.centre(t,e),this.redraw(),this.showPlace()}showPlace(){let[t,e]=this.keyboard||!this.at?[this.view.x,this.view.y]:this.view.toImage(...this.at);this.stage.pointer(`${this.picture.id}  x ${Tt(t,2)}  y ${Tt(e,2)} px  \xB7  ${wt(100*this.view.scale,3)} %`)}pointers(){let{body:t}=this,e=null,i=[0,0],s=null,r=-1,o=!1;t.addEventListener("pointerdown",a=>{a.button>1||(t.focus(),t.setPointerCapture(a.pointerId),e=i=this.place(a),r=a.button===0?Kt.cornerAt(this.picture.id,this.view,...e):-1,s=a.button===0&&!Kt.on?this.markAt(...e):null,o=!1)}),t.addEventListener("pointermove",a=>{let l=this.place(a);this.keyboard=!1,this.at=l,e?(o||=Math.hypot(l[0]-e[0],l[1]-e[1])>4,o&&r>=0?Kt.move(r,this.clamped(...l)):o&&s?this.measuring.moving.set(Rn.key(s.image,s.point),this.view.toImage(...l)):o&&this.pan(l[0]-i[0],l[1]-i[1]),i=l,this.redraw()):this.hovered(...l),this.showPlace()}),t.addEventListener("pointerup",a=>{let l=this.place(a);e&&o&&s?this.measuring.move(s.image,s.point,...this.view.toImage(...l),this.view.scale):e&&!o&&a.button===0&&this.click(a,...l),e=s=null}),t.addEventListener("pointercancel",()=>e=s=null),t.addEventListener("pointerleave",()=>this.left()),t.addEventListener("wheel",a=>{a.preventDefault(),this.zoom(Math.exp(-a.deltaY*(a.deltaMode?.05:.0016)),...this.place(a))},{passive:!1})}place(t){let e=this.body.getBoundingClientRect();return[t.clientX-e.left,t.clientY-e.top]}markAt(t,e){let i=null,s=10;for(let{mark:r,x:o,y:a}of this.marks()){let[l,c]=this.view.toScreen(o,a),h=Math.hypot(l-t,c-e)-(r.point===this.model.current?2:0);h<s&&(s=h,i=r)}return i}pointAt(t,e){let i=this.observations;return i?Xh(i,ql(i,Xt.filter,this.rejectedHere()),this.view,t,e):-1}click(t,e,i){let{model:s}=this;if(Kt.on){Kt.cornerAt(this.picture.id,this.view,e,i)<0&&this.enter(e,i);return}if(s.fiducial)return this.enter(e,i);let r=this.markAt(e,i);if(r)return s.choose(r.point);let o=this.pointAt(e,i),a=!s.current||s.mark(this.picture.id,s.current)!==void 0;if(o>=0&&(a||t.ctrlKey||t.metaKey))return s.choose(this.observations.point[o]);this.enter(e,i)}enter(t=this.view.width/2,e=this.view.height/2){if(Kt.on){Kt.add(this.picture.id,this.clamped(t,e))||this.model.say("studio_point.mask_elsewhere",{image:Kt.image},"bad");return}let[i,s]=this.view.toImage(t,e);if(!this.view.inside(i,s))return this.model.say("studio_photo.outside",{},"bad");this.measuring.place(this.picture.id,i,s,this.view.scale)}clamped(t,e){let i=(o,a)=>Math.round(100*Math.min(Math.max(o,0),a))/100,[s,r]=this.view.toImage(t,e);return[i(s,this.picture.width),i(r,this.picture.height)]}left(){this.at=null,this.hover=-1,this.tip.hidden=!0,this.redraw()}hovered(t,e){let i=this.pointAt(t,e);if((i!==this.hover||Xt.loupe)&&this.redraw(),this.hover=i,this.tip.hidden=i<0,i<0)return;this.tip.textContent=this.words(i);let s=t>this.view.width-240;this.tip.style.left=`${s?Math.max(t-230,4):t+16}px`,this.tip.style.top=`${Xt.loupe?Math.max(e-60,4):Math.min(e+14,this.view.height-70)}px`}words(t){let e=this.observations,i=Jr(e,t,this.rejectedHere()),s=_("studio_photo.legend",{name:i}),r=[`${e.point[t]} (${s})`,_("studio_photo.residual",{vx:wt(e.vx[t],2),vy:wt(e.vy[t],2),w:wt(e.w[t],2),n:e.rays[t]})];return i==="rejected"&&r.push(_("studio_photo.rejected",{cause:e.rejected[t]||_("studio_photo.by_hand")})),r.join(`
`)}pointHere(){let t=this.at&&!this.keyboard?this.hover:this.pointAt(this.view.width/2,this.view.height/2);return t>=0?this.observations.point[t]:null}key(t){cu(this,t)&&(t.preventDefault(),t.stopPropagation(),this.keyboard=!0,this.tip.hidden=!0,this.redraw(),this.showPlace())}};var sm={used:"\u25CB",weak:"\u25A1",rejected:"\u2715",control:"\u25B3",check:"\u25C7",mark:"\u271B",predicted:"\u25CC",beyond:"\u25EF",masked:"\u25A8"},rm=["all","rejected","weak","control","worst","none"],po=class{constructor(t,e,i){this.model=t;this.measuring=e;this.showPlace=i;this.panes=[];this.most=1;this.box=rt("panes");this.counts=[];this.targets=p("input",{type:"checkbox",id:"targets"});rt("looks").append(...this.bar()),rt("image-legend").append(...Object.entries(sm).map(([r,o])=>{let a=p("span",{class:"sign","aria-hidden":"true"},o);return a.style.color=ie[r],p("li",{id:`legend-${r}`,hidden:r==="beyond"||r==="masked"},a,_("studio_photo.legend",{name:r}))})),t.on(["looks","state","prediction","current","fiducial"],()=>this.panes.forEach(r=>r.redraw())),ti.onchange(()=>{rt("legend-beyond").hidden=!ti.points.size,this.panes.forEach(r=>r.redraw())}),this.targets.addEventListener("change",()=>Ee.switch(this.targets.checked));let s=jn.map(([r,o,a])=>{let l=p("span",{class:"sign","aria-hidden":"true"},a);return l.style.color=o,p("li",{hidden:!0,id:`legend-target-${r}`},l,_("studio_target.legend",{fate:r}))});rt("image-legend").append(...s),Ee.onchange(()=>{this.targets.checked=Ee.on,s.forEach(r=>r.hidden=!Ee.on),Ee.on&&Ee.reason&&t.show(Ee.reason,"bad"),this.panes.forEach(r=>r.redraw())}),t.on("read",()=>Ee.forget()),t.on("observations",()=>this.panes.forEach(r=>void r.read())),t.on("overview",()=>this.begin()),t.on(["overview","state"],()=>rt("legend-masked").hidden=!t.state.masks.length&&!t.overview.masks_given)}bar(){this.counts=[1,2,4].map(i=>{let s=_("studio_photo.panes",{n:i}),r=Zt(String(i),s,()=>this.setCount(i));return r.setAttribute("aria-label",s),r});let t=p("select",{id:"filter"},...xe(rm,i=>_("studio_photo.filter",{filter:i}),Xt.filter));t.addEventListener("change",()=>this.look(()=>Xt.filter=t.value)),this.loupe=p("input",{type:"checkbox",id:"loupe"}),this.loupe.addEventListener("change",()=>this.look(()=>Xt.loupe=this.loupe.checked));let e=p("input",{type:"checkbox",id:"linked",checked:!0});return e.addEventListener("change",()=>Xt.linked=e.checked),[p("span",{class:"group",role:"group","aria-label":_("studio_photo.pane_count")},...this.counts),p("label",{},e,_("studio_photo.linked")),p("label",{},this.loupe,_("studio_photo.loupe")),p("label",{title:Oe("studio_photo.targets")},this.targets,_("studio_photo.targets")),p("label",{},_("label.points"),t),this.slider("vectors","studio_photo.residuals",0,30,16,i=>Xt.vectors=i?Math.round(10**(i/10)):0,()=>String(Xt.vectors)),this.slider("brightness","studio_photo.brightness",2,30,10,i=>Xt.brightness=i/10,()=>Tt(Xt.brightness,1)),this.slider("contrast","studio_photo.contrast",2,30,10,i=>Xt.contrast=i/10,()=>Tt(Xt.contrast,1))]}slider(t,e,i,s,r,o,a){let l=p("input",{type:"range",id:t,min:i,max:s,value:r}),c=p("output",{for:t},a());return l.addEventListener("input",()=>this.look(()=>{o(Number(l.value)),c.textContent=a()})),l.addEventListener("dblclick",()=>{l.value=String(r),l.dispatchEvent(new Event("input"))}),p("label",{title:Oe(e)},_(e),l,c)}look(t){t(),this.model.emit("looks")}toggleLoupe(t=!Xt.loupe){this.loupe.checked=t,this.look(()=>Xt.loupe=t)}begin(){this.panes=this.panes.filter(e=>this.model.images.has(e.picture.id)||(e.gone(),!1));for(let{picture:e}of this.panes)Object.assign(e,this.model.images.get(e.id));let t=[...this.model.images.values()];!this.panes.length&&t.length&&this.open((t.find(e=>e.photo)??t[0]).id),this.arranged()}setCount(t){for(this.most=t;this.panes.length>t;)this.panes.pop().gone();let e=new Set(this.panes.map(r=>r.picture.id)),i=this.activePane?.picture.k??0,s=[...this.model.images.values()];for(let r=1;r<s.length&&this.panes.length<t;r++){let o=s[(i+r)%s.length];e.has(o.id)||this.add(o.id)}this.arranged()}open(t,e=!1){let i=this.panes.find(o=>o.picture.id===t);if(i)return this.activate(i),i;if(e&&this.panes.length<4){this.most=Math.max(this.most,this.panes.length+1>2?4:2);let o=this.add(t);return this.activate(o),o}let s=this.activePane,r=this.add(t,s);return s&&(this.panes.splice(this.panes.indexOf(s),1),s.gone()),this.model.active=this.panes.indexOf(r),this.arranged(),r}add(t,e){let i=new fo(this.model,this.measuring,this,this.model.images.get(t));return e?(e.root.before(i.root),this.panes.splice(this.panes.indexOf(e),0,i)):(this.box.append(i.root),this.panes.push(i)),i}arranged(){this.box.className=`panes${this.most>2?4:this.most}`,[1,2,4].forEach((e,i)=>this.counts[i].setAttribute("aria-pressed",String(e===this.most)));let t=Math.min(Math.max(this.model.active,0),this.panes.length-1);this.panes.forEach((e,i)=>e.root.classList.toggle("active",i===t)),this.model.setPanes(this.panes.map(e=>e.picture.id),t)}get activePane(){return this.panes[this.model.active]??this.panes[0]}activate(t){let e=this.panes.indexOf(t);e===this.model.active&&t.root.classList.contains("active")||(this.model.active=e,this.arranged())}close(t){if(this.panes.length<2)return this.model.say("studio_photo.last_open");this.panes.splice(this.panes.indexOf(t),1),t.gone(),this.most=this.panes.length>2?4:this.panes.length,this.arranged(),this.activePane?.body.focus()}moved(t,e,i,s){if(Xt.linked)for(let r of this.panes)r!==t&&(s!==1?r.view.zoomAt(s):r.view.panBy(e,i),r.redraw())}pointer(t){this.showPlace(t)}visit(t,e,i,s=1){let r=this.open(t);requestAnimationFrame(()=>{r.show(e,i,s),r.body.focus()})}step(t){let e=[...this.model.images.keys()],i=e.indexOf(this.activePane?.picture.id??"");this.open(e[(i+t+e.length)%e.length]).body.focus()}centre(){for(let t of this.panes){let e=this.model.mark(t.picture.id,this.model.current),i=this.model.prediction?.predictions.find(s=>s.image===t.picture.id);e?t.show(e.x,e.y):i&&i.x!==null&&i.y!==null&&i.inside&&t.show(i.x,i.y)}}};var hu=500,mo=class{constructor(t,e){this.model=t;this.isOpen=e;this.author=p("input",{id:"author",type:"text",autocomplete:"off",spellcheck:"false",maxlength:100});this.status=p("span",{class:"note"});this.entries=[];this.author.value=t.actions.author=localStorage.getItem("raybundle-author")??"",this.author.addEventListener("change",()=>{t.actions.author=this.author.value.trim(),localStorage.setItem("raybundle-author",t.actions.author)}),rt("journal-bar").append(p("label",{},_("studio_page.author"),this.author),Ut("studio_page.copy_all",()=>this.copy(this.entries.map(i=>i.command).filter(i=>i).join(`
`))),this.status),t.on("state",Kn(()=>this.isOpen()&&void this.show()))}async show(){this.entries=(await Ft("/api/journal")).actions;let t=this.entries.slice(-hu).reverse();this.status.textContent=_("studio_page.actions",{n:this.entries.length,shown:Math.min(this.entries.length,hu)}),rt("journal").replaceChildren(p("table",{"aria-label":_("studio_page.journal")},De(["studio_page.number","label.time","studio_page.by","studio_page.action","studio_page.command","studio_page.copy"]),p("tbody",{},...t.map(e=>this.row(e)))))}row(t){let e=Ut("studio_page.copy",()=>this.copy(t.command),"small",{n:t.seq}),{image:i,point:s,start:r,end:o,line:a}=t.arguments,l=[i,s,r,o,a].filter(c=>typeof c=="string").join(" \xB7 ");return p("tr",{},p("td",{},String(t.seq)),p("td",{class:"whole"},t.time.replace("T"," ").slice(0,19)),p("td",{},t.author),p("td",{class:"l"},p("b",{},_("studio_page.verb",{verb:t.verb})),` ${l}`),p("td",{class:"l"},p("code",{},t.command)),p("td",{},t.command?e:""))}copy(t){navigator.clipboard.writeText(t).then(()=>this.model.say("studio_page.copied",{},"good"),()=>this.model.say("studio_page.not_copied",{},"bad"))}};var om=[["studio_keys.anywhere",[["N","studio_keys.new_point"],["V","studio_keys.next_image"],["W","studio_keys.worst"],["studio_keys.ctrl_z","studio_keys.undo"],["studio_keys.ctrl_shift_z","studio_keys.redo"],["S","studio_keys.snap"],["L","studio_keys.loupe"],["C","studio_keys.centre"],["G","studio_keys.panes"],["[  ]","studio_keys.neighbour"],["Esc","studio_keys.no_point"],["F2","studio_keys.name"],["?","studio_keys.this_table"]]],["studio_keys.in_photograph",[["studio_keys.arrows","studio_keys.hair"],["Enter","studio_keys.mark"],["studio_keys.shift_arrows","studio_keys.move"],["studio_keys.delete","studio_keys.remove"],["P","studio_keys.choose"],["X","studio_keys.reject"],["studio_keys.of_mask","studio_keys.mask"],["+  -","studio_keys.zoom"],["0","studio_keys.whole"],["1","studio_keys.pixels"],["R","studio_keys.turn"]]],["studio_keys.by_mouse",[["studio_keys.click","studio_keys.click_deed"],["studio_keys.ctrl_click","studio_keys.choose"],["studio_keys.drag","studio_keys.drag_deed"],["studio_keys.wheel","studio_keys.zoom"],["studio_keys.shift_click","studio_keys.beside"]]]];function Ql(){let n=rt("keys");if(n.open)return n.close();n.replaceChildren(p("h2",{id:"keys-head"},_("studio_keys.title")),p("div",{class:"keys"},...om.map(([t,e])=>p("section",{},p("h3",{},_(t)),p("dl",{},...e.flatMap(([i,s])=>[p("dt",{},p("kbd",{},_(i))),p("dd",{},_(s))]))))),Ut("studio_keys.close",()=>n.close(),"main")),n.showModal()}function uu(n,t,e){let i=0,s=!1;addEventListener("keydown",r=>{if(rt("keys").open&&r.key!=="?")return;let o=r.ctrlKey||r.metaKey;if(Hh(r.target)&&r.key!=="Escape"&&r.key!=="F2")return;if(!o&&!r.altKey&&r.key.toLowerCase()==="l")return r.repeat||(i=performance.now(),s=e(),t(!0)),r.preventDefault();let a=`${o?"ctrl ":""}${o&&r.shiftKey?"shift ":""}${r.key.toLowerCase()}`,l=r.altKey?void 0:n[a];l&&(r.preventDefault(),l())}),addEventListener("keyup",r=>{r.key.toLowerCase()!=="l"||!i||(performance.now()-i>350?t(!1):t(!s),i=0)})}function du(n,t){let e=500,i=!1,s=()=>{let r=new WebSocket(`${location.protocol==="https:"?"wss":"ws"}://${location.host}/api/live`),o=setInterval(()=>r.readyState===WebSocket.OPEN&&r.send('{"type":"here"}'),2e4);r.addEventListener("open",()=>{e=500,t(!0,i),i=!0}),r.addEventListener("message",a=>n(JSON.parse(a.data))),r.addEventListener("close",()=>{clearInterval(o),t(!1,i),setTimeout(s,e),e=Math.min(2*e,8e3)})};s()}var go=class{constructor(t,e){this.model=t;this.toPhoto=e;this.name=oi("mask-name",_("studio_point.mask_name"),{maxlength:"200"});this.camera=p("input",{type:"checkbox",id:"mask-camera"});this.rows=p("table",{"aria-label":_("studio_point.masks")});this.head=p("summary",{},_("studio_point.masks"));this.about=p("p",{class:"note","aria-live":"polite"});this.begin=Ut("studio_point.draw_mask",()=>this.draw());this.give=p("button",{type:"submit",id:"mask-give",class:"main"},_("studio_point.exclude"));this.last=Ut("studio_point.last_corner",()=>Kt.removeLast());this.form=p("form",{hidden:!0},p("div",{class:"row"},this.name),p("label",{class:"check"},this.camera,_("studio_point.mask_of_camera")),p("div",{class:"row"},this.last,Ut("studio_point.cancel_mask",()=>Kt.end()),this.give)),this.form.addEventListener("submit",i=>{i.preventDefault(),this.exclude()}),this.begin.id="mask-draw",rt("right").append(p("details",{class:"card",id:"masks"},this.head,this.about,this.rows,this.begin,this.form)),t.on(["state","overview"],()=>this.show()),Kt.onchange(()=>{this.show(),t.emit("looks")})}draw(){let t=new Set(this.model.state.masks.map(i=>i.mask)),e=1;for(;t.has(_("studio_point.mask_default",{number:e}));)e++;this.name.value=_("studio_point.mask_default",{number:e}),this.camera.checked=!1,Kt.begin(),this.toPhoto(""),this.form.scrollIntoView({block:"nearest"})}edit(t){this.name.value=t.mask,this.camera.checked=t.camera,Kt.begin(t.image,t.polygon.map(([e,i])=>[e,i])),this.toPhoto(t.image),this.form.scrollIntoView({block:"nearest"})}async exclude(){let{corners:t,image:e}=Kt;if(!e)return this.model.say("studio_point.no_corner",{},"bad");let i=this.name.value.trim(),s={mask:i,image:e,polygon:t,camera:this.camera.checked};await this.model.act("mask",s,"studio_point.mask_given",{mask:i})&&Kt.end()}show(){let{state:t,overview:e}=this.model;this.head.textContent=ts(_("studio_point.masks"),t.masks.length),this.form.hidden=!Kt.on,this.begin.hidden=Kt.on,this.give.disabled=Kt.corners.length<3,this.last.disabled=!Kt.corners.length,this.about.textContent=Kt.on?_("studio_point.corners",{n:Kt.corners.length,image:Kt.image||"none"}):_("studio_point.masks_note",{folder:e.masks_given||"none"}),this.rows.hidden=!t.masks.length,this.rows.replaceChildren(...t.masks.map(i=>p("tr",{},p("td",{},Zt(i.mask,_("studio_point.edit_mask",{mask:i.mask}),()=>this.edit(i),"link")),p("td",{class:"l"},i.camera?_("studio_point.camera_of",{image:i.image}):i.image),p("td",{},Zt("\u2715",_("studio_point.remove",{name:i.mask}),()=>void this.model.act("unmask",{mask:i.mask},"studio_point.removed",{name:i.mask}),"small")))))}};var am=5e3,_o=class{constructor(){this.waiting=[];this.busy=!1;this.author="";this.onwaiting=()=>{};addEventListener("beforeunload",t=>{this.waiting.length&&t.preventDefault()})}send(t,e){return this.put("/api/action",{verb:t,arguments:e})}control(t,e){return this.put("/api/control",{file:t,text:e})}reject(t,e){return this.put("/api/reject",{by:t,limit:e})}fiducials(t){return this.put("/api/fiducials",{image:t})}put(t,e){let i={id:crypto.randomUUID(),author:this.author,...e};return new Promise((s,r)=>{this.waiting.push({path:t,body:i,done:s,refused:r}),this.work()})}async work(){if(this.busy)return;this.busy=!0;let t=250;for(;this.waiting.length;){let{path:e,body:i,done:s,refused:r}=this.waiting[0];this.onwaiting(this.waiting.length,t>250);try{let o=await Ue(e,i);this.waiting.shift(),t=250,s(o)}catch(o){if(o instanceof yi&&o.status<500){this.waiting.shift(),r(o);continue}t=Math.min(2*t,am),this.onwaiting(this.waiting.length,!0),await new Promise(a=>setTimeout(a,t))}}this.busy=!1,this.onwaiting(0,!1)}};var vo=class{constructor(){this.images=new Map;this.actions=new _o;this.current="";this.fiducial="";this.prediction=null;this.panes=[];this.active=0;this.run=null;this.message={code:"",words:"",kind:""};this.command="";this.marks=new Map;this.given=new Map;this.listeners=new Map;this.turn=0;this.predictSoon=ke(Kn(()=>void this.predict()),20)}on(t,e){for(let i of Array.isArray(t)?t:[t])this.listeners.set(i,[...this.listeners.get(i)??[],e])}emit(t){for(let e of this.listeners.get(t)??[])e()}async read(){this.overview=await Ft("/api/overview"),Be.readAnew(this.overview.times),this.images.clear(),this.overview.images.forEach((t,e)=>this.images.set(t.id,{...t,k:e})),this.given.clear(),this.take(this.overview.state),this.emit("overview"),this.emit("read"),this.emit("observations"),this.predictSoon()}take(t){if(!(this.state&&t.seq<this.state.seq)){this.state=t,this.marks.clear();for(let e of t.marks)this.marks.set(e.image,[...this.marks.get(e.image)??[],e]);this.emit("state"),this.predictSoon()}}async act(t,e,i,s={}){try{let r=await this.actions.send(t,e);this.command=r.command,this.take(r.state);let{test:o}=r;return this.show([_(i,s),o?.words??""].filter(a=>a).reverse().join(" "),o?.off?"bad":"good",i),!0}catch(r){return this.fail(r),!1}}say(t,e={},i=""){this.show(_(t,e),i,t)}show(t,e="",i=""){let s=e==="bad"&&i&&!i.startsWith("studio_");this.message={code:i,words:s?`${t} [${i}]`:t,kind:e},this.emit("message")}fail(t){this.show(t.message,"bad",t instanceof yi?t.code:"")}choose(t){this.fiducial&&this.chooseFiducial(""),t!==this.current&&(this.current=t,this.prediction=null,this.emit("current"),this.predictSoon())}chooseFiducial(t){this.fiducial=t,this.emit("fiducial")}fiducialsIn(t){return this.state.fiducials.filter(e=>e.image===t)}marksIn(t){return this.marks.get(t)??[]}mark(t,e){return this.marksIn(t).find(i=>i.point===e)}marksOf(t){return this.state.marks.filter(e=>e.point===t)}isRejected(t,e){return this.state.rejected.some(([i,s])=>i===t&&s===e)}roleOf(t){return this.state.points.find(e=>e.point===t)?.role??"tie"}observations(t){let e=this.given.get(t);return e||(e=Ft("/api/observations",{image:t}),e.catch(()=>this.given.delete(t)),this.given.set(t,e)),e}setPanes(t,e){this.panes=t,this.active=e,this.emit("panes"),this.predictSoon()}async predict(){let t=++this.turn,e=this.current;if(!e){this.prediction=null,this.emit("prediction");return}try{let i=await Ft("/api/predict",{point:e,images:[...new Set(this.panes)]});if(t!==this.turn)return;this.prediction=i,this.emit("prediction")}catch(i){i instanceof yi&&this.fail(i)}}};var yo=class{constructor(t,e,i){this.model=t;this.measuring=e;this.going=i;this.name=p("input",{id:"point-name",type:"text","aria-label":_("studio_point.current_name"),placeholder:_("studio_point.current_none"),autocomplete:"off",spellcheck:"false",list:"point-names",maxlength:200});this.names=p("datalist",{id:"point-names"});this.where=p("table",{class:"where","aria-label":_("studio_point.coordinates")});this.about=p("p",{class:"note","aria-live":"polite"});this.marks=p("table",{class:"marks","aria-label":_("studio_point.marks")});this.visibleHead=p("h3",{});this.search=p("input",{type:"search",id:"point-search","aria-label":_("studio_point.filter"),placeholder:_("studio_point.filter"),autocomplete:"off",spellcheck:"false"});this.pointsHead=p("summary",{},_("studio_point.points"));this.snap=p("select",{id:"snap"},...xe(Bs,t=>_("studio_point.how",{how:t})));this.visited=-1;this.visible=new Tn(_("studio_point.visible_images"),r=>r.image,r=>[p("b",{},r.image),p("small",{title:_("studio_point.angle")},`${r.angle_deg.toFixed(0)}\xB0`)],r=>i.visit(r.image,r.x,r.y)),this.points=new Tn(_("studio_point.points"),r=>r.point,r=>this.pointRow(r),r=>t.choose(r.point)),rt("right").append(this.current(),this.list()),this.name.addEventListener("change",()=>this.chooseNamed()),this.name.addEventListener("input",ke(()=>void this.suggest(),150)),this.search.addEventListener("input",ke(()=>void this.showPoints(),150)),this.snap.addEventListener("change",()=>Xt.snap=this.snap.value),t.on("current",()=>{this.visited=-1,this.name.value=t.current,this.points.select(t.current)}),t.on(["current","prediction","state"],()=>this.show());let s=ke(Kn(()=>void this.showPoints()),60);t.on(["state","read"],s)}current(){return p("section",{class:"card","aria-label":_("studio_point.current")},p("h2",{},_("studio_point.current")),p("div",{class:"row"},this.name,this.names,Ut("studio_point.new",()=>void this.measuring.newPoint(),"main")),p("div",{class:"row"},p("label",{},_("studio_point.snap"),this.snap),Ut("studio_point.worst_next",()=>void this.worst())),this.where,this.about,this.marks,this.visibleHead,this.visible.root)}list(){return p("details",{class:"card",open:!0},this.pointsHead,p("div",{class:"row"},this.search),this.points.root)}chooseNamed(){this.model.choose(this.name.value.trim()),this.name.blur()}async suggest(){let t=await Ft("/api/points",{search:this.name.value.trim(),limit:12});this.names.replaceChildren(...t.rows.map(e=>p("option",{value:e.point})))}typeName(){this.name.focus(),this.name.select()}nextSnap(){Xt.snap=Bs[(Bs.indexOf(Xt.snap)+1)%Bs.length],this.snap.value=Xt.snap,this.model.say("studio_point.snapping",{how:Xt.snap})}visitNext(){let t=this.model.prediction?.visible??[];if(!t.length)return this.model.say("studio_point.none_visible");this.visited=(this.visited+1)%t.length;let{image:e,x:i,y:s}=t[this.visited];this.visible.select(e),this.going.visit(e,i,s)}async worst(){let t=await this.measuring.worstNext();t&&(this.model.choose(t.point),await this.goTo(t.point,t.image))}async goTo(t,e=""){let i=this.model.marksOf(t).find(o=>!e||o.image===e);if(i)return this.going.visit(i.image,i.x,i.y);let s=e?[e]:[...this.model.images.keys()].slice(0,400);for(let o of s){let a=await this.model.observations(o),l=a.point.indexOf(t);if(l>=0)return this.going.visit(o,a.x[l],a.y[l])}let r=this.model.prediction?.visible[0];r&&this.going.visit(r.image,r.x,r.y)}show(){let{model:t}=this,e=t.prediction?.point===t.current?t.prediction:null,{unit:i}=t.overview;if(this.where.replaceChildren(),e?.located.xyz){let r=e.located.sigma,o=p("tr",{},p("td"),p("th",{scope:"col"},i||_("studio_point.no_unit")),p("th",{scope:"col"},_("label.sigma")));this.where.append(o,...["X","Y","Z"].map((a,l)=>p("tr",{},p("th",{scope:"row"},a),p("td",{},Tt(e.located.xyz[l],Fe(r?.[l]))),p("td",{class:"sigma"},r?Tt(r[l],Fe(r[l])):"\u2013"))))}this.about.textContent=this.words(e),this.showMarks(e);let s=e?.visible??[];this.visibleHead.hidden=this.visible.root.hidden=!s.length,this.visibleHead.textContent=_("studio_point.visible",{n:s.length}),this.visible.set(s)}words(t){let{model:e}=this;if(!e.current)return _("studio_point.choose_or_begin");if(!t)return"";let{source:i,rays:s,neglected:r}=t.located;return[_("studio_point.located",{source:i,n:s}),r].join(" ")}showMarks(t){let{model:e}=this,i=e.marksOf(e.current);this.marks.hidden=!i.length,this.marks.replaceChildren(De(["label.image","studio_point.by","studio_point.sigma_px","studio_point.vx","studio_point.vy",""]),...i.map(s=>{let r=t?.located.residuals[s.image],o=Zt(s.image,_("studio_point.show",{point:s.image}),()=>this.going.visit(s.image,s.x,s.y),"link"),a=Zt("\u2715",_("studio_point.remove",{name:s.image}),()=>void e.act("remove",{image:s.image,point:s.point},"studio_point.mark_removed",{point:s.point}),"small"),l=Math.sqrt(Math.max(s.cov[0],s.cov[1]));return p("tr",{},p("td",{},o),p("td",{},_("studio_point.how",{how:s.how})),p("td",{},wt(l,2)),...this.residual(s,r),p("td",{},a))}))}residual(t,e){let i=[0,1].map(s=>p("td",{},Tt(e?.[s],2)));return e||this.model.observations(t.image).then(s=>{let r=s.point.indexOf(t.point);r>=0&&Math.hypot(s.x[r]-t.x,s.y[r]-t.y)<.001&&([i[0].textContent,i[1].textContent]=[Tt(s.vx[r],2),Tt(s.vy[r],2)])},()=>{}),i}pointRow(t){let e=this.model.marksOf(t.point).length,i=Math.max(...t.sigma.map(r=>r??-1)),s=[t.role==="tie"?"":_("studio_point.role",{role:t.role}),e?_("studio_point.mark_count",{n:e}):"",t.rays?_("studio_photo.rays",{n:t.rays}):"",i>=0?`s ${wt(i,2)}`:""];return[p("b",{},t.point),p("small",{},s.filter(r=>r).join(" \xB7 "))]}async showPoints(){let{model:t}=this,e=this.search.value.trim(),i=await Ft("/api/points",{search:e,limit:60}),s=new Map(i.rows.map(a=>[a.point,a])),r=t.state.points.filter(a=>a.point.toLowerCase().includes(e.toLowerCase())).map(a=>({...s.get(a.point)??{rays:0,w:null,xyz:a.xyz,sigma:[null,null,null]},point:a.point,role:a.role})),o=new Set(r.map(a=>a.point));this.points.set([...r,...i.rows.filter(a=>!o.has(a.point))],t.current),this.pointsHead.textContent=_("studio_point.points_of",{n:t.state.points.length,of:t.overview.points})}};var vn={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},yn={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Bu=0,Cc=1,zu=2;var Pc=1,Hu=2,ki=3,Ji=0,Je=1,Bi=2,tn=0,Nn=1,Ic=2,Lc=3,Dc=4,Vu=5,pn=100,Gu=101,Wu=102,Xu=103,qu=104,Yu=200,$u=201,Zu=202,Ku=203,Wo=204,Xo=205,ju=206,Ju=207,Qu=208,td=209,ed=210,id=211,nd=212,sd=213,rd=214,_a=0,va=1,ya=2,Fn=3,xa=4,ba=5,Ma=6,wa=7,Sa=0,od=1,ad=2,en=0,ld=1,cd=2,hd=3,ud=4,dd=5,fd=6,pd=7;var Uc=300,Hn=301,Vn=302,Ea=303,Ta=304,Tr=306,qo=1e3,fn=1001,Yo=1002,ei=1003,md=1004;var Ar=1005;var Si=1006,Aa=1007;var xn=1008;var zi=1009,Nc=1010,Fc=1011,ws=1012,Ra=1013,bn=1014,Ri=1015,Ss=1016,Ca=1017,Pa=1018,Es=1020,Oc=35902,kc=35899,Bc=1021,zc=1022,gi=1023,gs=1026,Ts=1027,Ia=1028,La=1029,Hc=1030,Da=1031;var Ua=1033,Rr=33776,Cr=33777,Pr=33778,Ir=33779,Na=35840,Fa=35841,Oa=35842,ka=35843,Ba=36196,za=37492,Ha=37496,Va=37808,Ga=37809,Wa=37810,Xa=37811,qa=37812,Ya=37813,$a=37814,Za=37815,Ka=37816,ja=37817,Ja=37818,Qa=37819,tl=37820,el=37821,il=36492,nl=36494,sl=36495,rl=36283,ol=36284,al=36285,ll=36286;var ir=2300,$o=2301,Go=2302,Mc=2400,wc=2401,Sc=2402;var gd=3200,_d=3201;var Vc=0,vd=1,nn="",ci="srgb",On="srgb-linear",nr="linear",ne="srgb";var Dn=7680;var Ec=519,yd=512,xd=513,bd=514,Gc=515,Md=516,wd=517,Sd=518,Ed=519,Tc=35044;var Wc="300 es",wi=2e3,sr=2001;var Li=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},He=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],fu=1234567,tr=Math.PI/180,_s=180/Math.PI;function As(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(He[n&255]+He[n>>8&255]+He[n>>16&255]+He[n>>24&255]+"-"+He[t&255]+He[t>>8&255]+"-"+He[t>>16&15|64]+He[t>>24&255]+"-"+He[e&63|128]+He[e>>8&255]+"-"+He[e>>16&255]+He[e>>24&255]+He[i&255]+He[i>>8&255]+He[i>>16&255]+He[i>>24&255]).toLowerCase()}function qt(n,t,e){return Math.max(t,Math.min(e,n))}function Xc(n,t){return(n%t+t)%t}function lm(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function cm(n,t,e){return n!==t?(e-n)/(t-n):0}function er(n,t,e){return(1-e)*n+e*t}function hm(n,t,e,i){return er(n,t,1-Math.exp(-e*i))}function um(n,t=1){return t-Math.abs(Xc(n,t*2)-t)}function dm(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function fm(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function pm(n,t){return n+Math.floor(Math.random()*(t-n+1))}function mm(n,t){return n+Math.random()*(t-n)}function gm(n){return n*(.5-Math.random())}function _m(n){n!==void 0&&(fu=n);let t=fu+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function vm(n){return n*tr}function ym(n){return n*_s}function xm(n){return(n&n-1)===0&&n!==0}function bm(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Mm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function wm(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),h=o((t+i)/2),u=r((t-i)/2),f=o((t-i)/2),m=r((i-t)/2),v=o((i-t)/2);switch(s){case"XYX":n.set(a*h,l*u,l*f,a*c);break;case"YZY":n.set(l*f,a*h,l*u,a*c);break;case"ZXZ":n.set(l*u,l*f,a*h,a*c);break;case"XZX":n.set(a*h,l*v,l*m,a*c);break;case"YXY":n.set(l*m,a*h,l*v,a*c);break;case"ZYZ":n.set(l*v,l*m,a*h,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ps(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function $e(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}var qc={DEG2RAD:tr,RAD2DEG:_s,generateUUID:As,clamp:qt,euclideanModulo:Xc,mapLinear:lm,inverseLerp:cm,lerp:er,damp:hm,pingpong:um,smoothstep:dm,smootherstep:fm,randInt:pm,randFloat:mm,randFloatSpread:gm,seededRandom:_m,degToRad:vm,radToDeg:ym,isPowerOfTwo:xm,ceilPowerOfTwo:bm,floorPowerOfTwo:Mm,setQuaternionFromProperEuler:wm,normalize:$e,denormalize:ps},zt=class n{constructor(t=0,e=0){n.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=qt(this.x,t.x,e.x),this.y=qt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=qt(this.x,t,e),this.y=qt(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(qt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(qt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},mi=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],f=r[o+0],m=r[o+1],v=r[o+2],M=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u;return}if(a===1){t[e+0]=f,t[e+1]=m,t[e+2]=v,t[e+3]=M;return}if(u!==M||l!==f||c!==m||h!==v){let g=1-a,d=l*f+c*m+h*v+u*M,R=d>=0?1:-1,E=1-d*d;if(E>Number.EPSILON){let I=Math.sqrt(E),P=Math.atan2(I,d*R);g=Math.sin(g*P)/I,a=Math.sin(a*P)/I}let S=a*R;if(l=l*g+f*S,c=c*g+m*S,h=h*g+v*S,u=u*g+M*S,g===1-a){let I=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=I,c*=I,h*=I,u*=I}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[o],f=r[o+1],m=r[o+2],v=r[o+3];return t[e]=a*v+h*u+l*m-c*f,t[e+1]=l*v+h*f+c*u-a*m,t[e+2]=c*v+h*m+a*f-l*u,t[e+3]=h*v-a*u-l*f-c*m,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),u=a(r/2),f=l(i/2),m=l(s/2),v=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*m*v,this._y=c*m*u-f*h*v,this._z=c*h*v+f*m*u,this._w=c*h*u-f*m*v;break;case"YXZ":this._x=f*h*u+c*m*v,this._y=c*m*u-f*h*v,this._z=c*h*v-f*m*u,this._w=c*h*u+f*m*v;break;case"ZXY":this._x=f*h*u-c*m*v,this._y=c*m*u+f*h*v,this._z=c*h*v+f*m*u,this._w=c*h*u-f*m*v;break;case"ZYX":this._x=f*h*u-c*m*v,this._y=c*m*u+f*h*v,this._z=c*h*v-f*m*u,this._w=c*h*u+f*m*v;break;case"YZX":this._x=f*h*u+c*m*v,this._y=c*m*u+f*h*v,this._z=c*h*v-f*m*u,this._w=c*h*u-f*m*v;break;case"XZY":this._x=f*h*u-c*m*v,this._y=c*m*u-f*h*v,this._z=c*h*v+f*m*u,this._w=c*h*u+f*m*v;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],f=i+a+u;if(f>0){let m=.5/Math.sqrt(f+1);this._w=.25/m,this._x=(h-l)*m,this._y=(r-c)*m,this._z=(o-s)*m}else if(i>a&&i>u){let m=2*Math.sqrt(1+i-a-u);this._w=(h-l)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+c)/m}else if(a>u){let m=2*Math.sqrt(1+a-i-u);this._w=(r-c)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(l+h)/m}else{let m=2*Math.sqrt(1+u-i-a);this._w=(o-s)/m,this._x=(r+c)/m,this._y=(l+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(qt(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);let i=this._x,s=this._y,r=this._z,o=this._w,a=o*t._w+i*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=i,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let m=1-e;return this._w=m*o+e*this._w,this._x=m*i+e*this._x,this._y=m*s+e*this._y,this._z=m*r+e*this._z,this.normalize(),this}let c=Math.sqrt(l),h=Math.atan2(c,a),u=Math.sin((1-e)*h)/c,f=Math.sin(e*h)/c;return this._w=o*u+this._w*f,this._x=i*u+this._x*f,this._y=s*u+this._y*f,this._z=r*u+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},F=class n{constructor(t=0,e=0,i=0){n.prototype.isVector3=!0,this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(pu.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(pu.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),h=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+l*c+o*u-a*h,this.y=i+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=qt(this.x,t.x,e.x),this.y=qt(this.y,t.y,e.y),this.z=qt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=qt(this.x,t,e),this.y=qt(this.y,t,e),this.z=qt(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(qt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return tc.copy(this).projectOnVector(t),this.sub(tc)}reflect(t){return this.sub(tc.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(qt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},tc=new F,pu=new mi,Ht=class n{constructor(t,e,i,s,r,o,a,l,c){n.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],u=i[7],f=i[2],m=i[5],v=i[8],M=s[0],g=s[3],d=s[6],R=s[1],E=s[4],S=s[7],I=s[2],P=s[5],D=s[8];return r[0]=o*M+a*R+l*I,r[3]=o*g+a*E+l*P,r[6]=o*d+a*S+l*D,r[1]=c*M+h*R+u*I,r[4]=c*g+h*E+u*P,r[7]=c*d+h*S+u*D,r[2]=f*M+m*R+v*I,r[5]=f*g+m*E+v*P,r[8]=f*d+m*S+v*D,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,f=a*l-h*r,m=c*r-o*l,v=e*u+i*f+s*m;if(v===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/v;return t[0]=u*M,t[1]=(s*c-h*i)*M,t[2]=(a*i-s*o)*M,t[3]=f*M,t[4]=(h*e-s*l)*M,t[5]=(s*r-a*e)*M,t[6]=m*M,t[7]=(i*l-c*e)*M,t[8]=(o*e-i*r)*M,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(ec.makeScale(t,e)),this}rotate(t){return this.premultiply(ec.makeRotation(-t)),this}translate(t,e){return this.premultiply(ec.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ec=new Ht;function Yc(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function rr(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Td(){let n=rr("canvas");return n.style.display="block",n}var mu={};function vs(n){n in mu||(mu[n]=!0,console.warn(n))}function Ad(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var gu=new Ht().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),_u=new Ht().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Sm(){let n={enabled:!0,workingColorSpace:On,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===ne&&(s.r=ji(s.r),s.g=ji(s.g),s.b=ji(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===ne&&(s.r=ms(s.r),s.g=ms(s.g),s.b=ms(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===nn?nr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return vs("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),n.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return vs("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),n.colorSpaceToWorking(s,r)}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[On]:{primaries:t,whitePoint:i,transfer:nr,toXYZ:gu,fromXYZ:_u,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ci},outputColorSpaceConfig:{drawingBufferColorSpace:ci}},[ci]:{primaries:t,whitePoint:i,transfer:ne,toXYZ:gu,fromXYZ:_u,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ci}}}),n}var Jt=Sm();function ji(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ms(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var es,Zo=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{es===void 0&&(es=rr("canvas")),es.width=t.width,es.height=t.height;let s=es.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=es}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=rr("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ji(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ji(e[i]/255)*255):e[i]=ji(e[i]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Em=0,ys=class{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:Em++}),this.uuid=As(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):e instanceof VideoFrame?t.set(e.displayHeight,e.displayWidth,0):e!==null?t.set(e.width,e.height,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ic(s[o].image)):r.push(ic(s[o]))}else r=ic(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function ic(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Zo.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var Tm=0,nc=new F,je=class n extends Li{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=fn,s=fn,r=Si,o=xn,a=gi,l=zi,c=n.DEFAULT_ANISOTROPY,h=nn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Tm++}),this.uuid=As(),this.name="",this.source=new ys(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new zt(0,0),this.repeat=new zt(1,1),this.center=new zt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ht,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(nc).x}get height(){return this.source.getSize(nc).y}get depth(){return this.source.getSize(nc).z}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){console.warn(`THREE.Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Uc)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case qo:t.x=t.x-Math.floor(t.x);break;case fn:t.x=t.x<0?0:1;break;case Yo:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case qo:t.y=t.y-Math.floor(t.y);break;case fn:t.y=t.y<0?0:1;break;case Yo:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};je.DEFAULT_IMAGE=null;je.DEFAULT_MAPPING=Uc;je.DEFAULT_ANISOTROPY=1;var Me=class n{constructor(t=0,e=0,i=0,s=1){n.prototype.isVector4=!0,this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],f=l[1],m=l[5],v=l[9],M=l[2],g=l[6],d=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-M)<.01&&Math.abs(v-g)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+M)<.1&&Math.abs(v+g)<.1&&Math.abs(c+m+d-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let E=(c+1)/2,S=(m+1)/2,I=(d+1)/2,P=(h+f)/4,D=(u+M)/4,k=(v+g)/4;return E>S&&E>I?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=P/i,r=D/i):S>I?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=P/s,r=k/s):I<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),i=D/r,s=k/r),this.set(i,s,r,e),this}let R=Math.sqrt((g-v)*(g-v)+(u-M)*(u-M)+(f-h)*(f-h));return Math.abs(R)<.001&&(R=1),this.x=(g-v)/R,this.y=(u-M)/R,this.z=(f-h)/R,this.w=Math.acos((c+m+d-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=qt(this.x,t.x,e.x),this.y=qt(this.y,t.y,e.y),this.z=qt(this.z,t.z,e.z),this.w=qt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=qt(this.x,t,e),this.y=qt(this.y,t,e),this.z=qt(this.z,t,e),this.w=qt(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(qt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ko=class extends Li{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Si,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Me(0,0,t,e),this.scissorTest=!1,this.viewport=new Me(0,0,t,e);let s={width:t,height:e,depth:i.depth},r=new je(s);this.textures=[];let o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview}_setTextureOptions(t={}){let e={minFilter:Si,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),t!==null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new ys(s)}return this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Di=class extends Ko{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},or=class extends je{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ei,this.minFilter=ei,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var jo=class extends je{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ei,this.minFilter=ei,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ui=class{constructor(t=new F(1/0,1/0,1/0),e=new F(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(xi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(xi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=xi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,xi):xi.fromBufferAttribute(r,o),xi.applyMatrix4(t.matrixWorld),this.expandByPoint(xi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),xo.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),xo.copy(i.boundingBox)),xo.applyMatrix4(t.matrixWorld),this.union(xo)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,xi),xi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ys),bo.subVectors(this.max,Ys),is.subVectors(t.a,Ys),ns.subVectors(t.b,Ys),ss.subVectors(t.c,Ys),on.subVectors(ns,is),an.subVectors(ss,ns),Cn.subVectors(is,ss);let e=[0,-on.z,on.y,0,-an.z,an.y,0,-Cn.z,Cn.y,on.z,0,-on.x,an.z,0,-an.x,Cn.z,0,-Cn.x,-on.y,on.x,0,-an.y,an.x,0,-Cn.y,Cn.x,0];return!sc(e,is,ns,ss,bo)||(e=[1,0,0,0,1,0,0,0,1],!sc(e,is,ns,ss,bo))?!1:(Mo.crossVectors(on,an),e=[Mo.x,Mo.y,Mo.z],sc(e,is,ns,ss,bo))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,xi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(xi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(qi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),qi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),qi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),qi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),qi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),qi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),qi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),qi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(qi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},qi=[new F,new F,new F,new F,new F,new F,new F,new F],xi=new F,xo=new Ui,is=new F,ns=new F,ss=new F,on=new F,an=new F,Cn=new F,Ys=new F,bo=new F,Mo=new F,Pn=new F;function sc(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Pn.fromArray(n,r);let a=s.x*Math.abs(Pn.x)+s.y*Math.abs(Pn.y)+s.z*Math.abs(Pn.z),l=t.dot(Pn),c=e.dot(Pn),h=i.dot(Pn);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Am=new Ui,$s=new F,rc=new F,Ni=class{constructor(t=new F,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Am.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;$s.subVectors(t,this.center);let e=$s.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector($s,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(rc.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint($s.copy(t.center).add(rc)),this.expandByPoint($s.copy(t.center).sub(rc))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Yi=new F,oc=new F,wo=new F,ln=new F,ac=new F,So=new F,lc=new F,mn=class{constructor(t=new F,e=new F(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Yi)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Yi.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Yi.copy(this.origin).addScaledVector(this.direction,e),Yi.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){oc.copy(t).add(e).multiplyScalar(.5),wo.copy(e).sub(t).normalize(),ln.copy(this.origin).sub(oc);let r=t.distanceTo(e)*.5,o=-this.direction.dot(wo),a=ln.dot(this.direction),l=-ln.dot(wo),c=ln.lengthSq(),h=Math.abs(1-o*o),u,f,m,v;if(h>0)if(u=o*l-a,f=o*a-l,v=r*h,u>=0)if(f>=-v)if(f<=v){let M=1/h;u*=M,f*=M,m=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),m=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),m=-u*u+f*(f+2*l)+c;else f<=-v?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),m=-u*u+f*(f+2*l)+c):f<=v?(u=0,f=Math.min(Math.max(-r,-l),r),m=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),m=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),m=-u*u+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(oc).addScaledVector(wo,f),m}intersectSphere(t,e){Yi.subVectors(t.center,this.origin);let i=Yi.dot(this.direction),s=Yi.dot(Yi)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(i=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(i=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,l=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,l=(t.min.z-f.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Yi)!==null}intersectTriangle(t,e,i,s,r){ac.subVectors(e,t),So.subVectors(i,t),lc.crossVectors(ac,So);let o=this.direction.dot(lc),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;ln.subVectors(this.origin,t);let l=a*this.direction.dot(So.crossVectors(ln,So));if(l<0)return null;let c=a*this.direction.dot(ac.cross(ln));if(c<0||l+c>o)return null;let h=-a*ln.dot(lc);return h<0?null:this.at(h/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ae=class n{constructor(t,e,i,s,r,o,a,l,c,h,u,f,m,v,M,g){n.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,h,u,f,m,v,M,g)}set(t,e,i,s,r,o,a,l,c,h,u,f,m,v,M,g){let d=this.elements;return d[0]=t,d[4]=e,d[8]=i,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=h,d[10]=u,d[14]=f,d[3]=m,d[7]=v,d[11]=M,d[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){let e=this.elements,i=t.elements,s=1/rs.setFromMatrixColumn(t,0).length(),r=1/rs.setFromMatrixColumn(t,1).length(),o=1/rs.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let f=o*h,m=o*u,v=a*h,M=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=m+v*c,e[5]=f-M*c,e[9]=-a*l,e[2]=M-f*c,e[6]=v+m*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*h,m=l*u,v=c*h,M=c*u;e[0]=f+M*a,e[4]=v*a-m,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=m*a-v,e[6]=M+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*h,m=l*u,v=c*h,M=c*u;e[0]=f-M*a,e[4]=-o*u,e[8]=v+m*a,e[1]=m+v*a,e[5]=o*h,e[9]=M-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*h,m=o*u,v=a*h,M=a*u;e[0]=l*h,e[4]=v*c-m,e[8]=f*c+M,e[1]=l*u,e[5]=M*c+f,e[9]=m*c-v,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,m=o*c,v=a*l,M=a*c;e[0]=l*h,e[4]=M-f*u,e[8]=v*u+m,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=m*u+v,e[10]=f-M*u}else if(t.order==="XZY"){let f=o*l,m=o*c,v=a*l,M=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=f*u+M,e[5]=o*h,e[9]=m*u-v,e[2]=v*u-m,e[6]=a*h,e[10]=M*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Rm,t,Cm)}lookAt(t,e,i){let s=this.elements;return ai.subVectors(t,e),ai.lengthSq()===0&&(ai.z=1),ai.normalize(),cn.crossVectors(i,ai),cn.lengthSq()===0&&(Math.abs(i.z)===1?ai.x+=1e-4:ai.z+=1e-4,ai.normalize(),cn.crossVectors(i,ai)),cn.normalize(),Eo.crossVectors(ai,cn),s[0]=cn.x,s[4]=Eo.x,s[8]=ai.x,s[1]=cn.y,s[5]=Eo.y,s[9]=ai.y,s[2]=cn.z,s[6]=Eo.z,s[10]=ai.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],u=i[5],f=i[9],m=i[13],v=i[2],M=i[6],g=i[10],d=i[14],R=i[3],E=i[7],S=i[11],I=i[15],P=s[0],D=s[4],k=s[8],x=s[12],b=s[1],C=s[5],B=s[9],V=s[13],X=s[2],K=s[6],Y=s[10],nt=s[14],G=s[3],lt=s[7],dt=s[11],At=s[15];return r[0]=o*P+a*b+l*X+c*G,r[4]=o*D+a*C+l*K+c*lt,r[8]=o*k+a*B+l*Y+c*dt,r[12]=o*x+a*V+l*nt+c*At,r[1]=h*P+u*b+f*X+m*G,r[5]=h*D+u*C+f*K+m*lt,r[9]=h*k+u*B+f*Y+m*dt,r[13]=h*x+u*V+f*nt+m*At,r[2]=v*P+M*b+g*X+d*G,r[6]=v*D+M*C+g*K+d*lt,r[10]=v*k+M*B+g*Y+d*dt,r[14]=v*x+M*V+g*nt+d*At,r[3]=R*P+E*b+S*X+I*G,r[7]=R*D+E*C+S*K+I*lt,r[11]=R*k+E*B+S*Y+I*dt,r[15]=R*x+E*V+S*nt+I*At,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],f=t[10],m=t[14],v=t[3],M=t[7],g=t[11],d=t[15];return v*(+r*l*u-s*c*u-r*a*f+i*c*f+s*a*m-i*l*m)+M*(+e*l*m-e*c*f+r*o*f-s*o*m+s*c*h-r*l*h)+g*(+e*c*u-e*a*m-r*o*u+i*o*m+r*a*h-i*c*h)+d*(-s*a*h-e*l*u+e*a*f+s*o*u-i*o*f+i*l*h)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],f=t[10],m=t[11],v=t[12],M=t[13],g=t[14],d=t[15],R=u*g*c-M*f*c+M*l*m-a*g*m-u*l*d+a*f*d,E=v*f*c-h*g*c-v*l*m+o*g*m+h*l*d-o*f*d,S=h*M*c-v*u*c+v*a*m-o*M*m-h*a*d+o*u*d,I=v*u*l-h*M*l-v*a*f+o*M*f+h*a*g-o*u*g,P=e*R+i*E+s*S+r*I;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let D=1/P;return t[0]=R*D,t[1]=(M*f*r-u*g*r-M*s*m+i*g*m+u*s*d-i*f*d)*D,t[2]=(a*g*r-M*l*r+M*s*c-i*g*c-a*s*d+i*l*d)*D,t[3]=(u*l*r-a*f*r-u*s*c+i*f*c+a*s*m-i*l*m)*D,t[4]=E*D,t[5]=(h*g*r-v*f*r+v*s*m-e*g*m-h*s*d+e*f*d)*D,t[6]=(v*l*r-o*g*r-v*s*c+e*g*c+o*s*d-e*l*d)*D,t[7]=(o*f*r-h*l*r+h*s*c-e*f*c-o*s*m+e*l*m)*D,t[8]=S*D,t[9]=(v*u*r-h*M*r-v*i*m+e*M*m+h*i*d-e*u*d)*D,t[10]=(o*M*r-v*a*r+v*i*c-e*M*c-o*i*d+e*a*d)*D,t[11]=(h*a*r-o*u*r-h*i*c+e*u*c+o*i*m-e*a*m)*D,t[12]=I*D,t[13]=(h*M*s-v*u*s+v*i*f-e*M*f-h*i*g+e*u*g)*D,t[14]=(v*a*s-o*M*s-v*i*l+e*M*l+o*i*g-e*a*g)*D,t[15]=(o*u*s-h*a*s+h*i*l-e*u*l-o*i*f+e*a*f)*D,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,f=r*c,m=r*h,v=r*u,M=o*h,g=o*u,d=a*u,R=l*c,E=l*h,S=l*u,I=i.x,P=i.y,D=i.z;return s[0]=(1-(M+d))*I,s[1]=(m+S)*I,s[2]=(v-E)*I,s[3]=0,s[4]=(m-S)*P,s[5]=(1-(f+d))*P,s[6]=(g+R)*P,s[7]=0,s[8]=(v+E)*D,s[9]=(g-R)*D,s[10]=(1-(f+M))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements,r=rs.set(s[0],s[1],s[2]).length(),o=rs.set(s[4],s[5],s[6]).length(),a=rs.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],bi.copy(this);let c=1/r,h=1/o,u=1/a;return bi.elements[0]*=c,bi.elements[1]*=c,bi.elements[2]*=c,bi.elements[4]*=h,bi.elements[5]*=h,bi.elements[6]*=h,bi.elements[8]*=u,bi.elements[9]*=u,bi.elements[10]*=u,e.setFromRotationMatrix(bi),i.x=r,i.y=o,i.z=a,this}makePerspective(t,e,i,s,r,o,a=wi,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(i-s),f=(e+t)/(e-t),m=(i+s)/(i-s),v,M;if(l)v=r/(o-r),M=o*r/(o-r);else if(a===wi)v=-(o+r)/(o-r),M=-2*o*r/(o-r);else if(a===sr)v=-o/(o-r),M=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=m,c[13]=0,c[2]=0,c[6]=0,c[10]=v,c[14]=M,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=wi,l=!1){let c=this.elements,h=2/(e-t),u=2/(i-s),f=-(e+t)/(e-t),m=-(i+s)/(i-s),v,M;if(l)v=1/(o-r),M=o/(o-r);else if(a===wi)v=-2/(o-r),M=-(o+r)/(o-r);else if(a===sr)v=-1/(o-r),M=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=m,c[2]=0,c[6]=0,c[10]=v,c[14]=M,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},rs=new F,bi=new ae,Rm=new F(0,0,0),Cm=new F(1,1,1),cn=new F,Eo=new F,ai=new F,vu=new ae,yu=new mi,Ei=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],m=s[10];switch(e){case"XYZ":this._y=Math.asin(qt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-qt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(qt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-qt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(qt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-qt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return vu.makeRotationFromQuaternion(t),this.setFromRotationMatrix(vu,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return yu.setFromEuler(this),this.setFromQuaternion(yu,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ei.DEFAULT_ORDER="XYZ";var ar=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Pm=0,xu=new F,os=new mi,$i=new ae,To=new F,Zs=new F,Im=new F,Lm=new mi,bu=new F(1,0,0),Mu=new F(0,1,0),wu=new F(0,0,1),Su={type:"added"},Dm={type:"removed"},as={type:"childadded",child:null},cc={type:"childremoved",child:null},We=class n extends Li{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Pm++}),this.uuid=As(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new F,e=new Ei,i=new mi,s=new F(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ae},normalMatrix:{value:new Ht}}),this.matrix=new ae,this.matrixWorld=new ae,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ar,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return os.setFromAxisAngle(t,e),this.quaternion.multiply(os),this}rotateOnWorldAxis(t,e){return os.setFromAxisAngle(t,e),this.quaternion.premultiply(os),this}rotateX(t){return this.rotateOnAxis(bu,t)}rotateY(t){return this.rotateOnAxis(Mu,t)}rotateZ(t){return this.rotateOnAxis(wu,t)}translateOnAxis(t,e){return xu.copy(t).applyQuaternion(this.quaternion),this.position.add(xu.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(bu,t)}translateY(t){return this.translateOnAxis(Mu,t)}translateZ(t){return this.translateOnAxis(wu,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4($i.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?To.copy(t):To.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Zs.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?$i.lookAt(Zs,To,this.up):$i.lookAt(To,Zs,this.up),this.quaternion.setFromRotationMatrix($i),s&&($i.extractRotation(s.matrixWorld),os.setFromRotationMatrix($i),this.quaternion.premultiply(os.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Su),as.child=t,this.dispatchEvent(as),as.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Dm),cc.child=t,this.dispatchEvent(cc),cc.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),$i.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),$i.multiply(t.parent.matrixWorld)),t.applyMatrix4($i),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Su),as.child=t,this.dispatchEvent(as),as.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Zs,t,Im),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Zs,Lm,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e){let i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),f=o(t.skeletons),m=o(t.animations),v=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),f.length>0&&(i.skeletons=f),m.length>0&&(i.animations=m),v.length>0&&(i.nodes=v)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}};We.DEFAULT_UP=new F(0,1,0);We.DEFAULT_MATRIX_AUTO_UPDATE=!0;We.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Mi=new F,Zi=new F,hc=new F,Ki=new F,ls=new F,cs=new F,Eu=new F,uc=new F,dc=new F,fc=new F,pc=new Me,mc=new Me,gc=new Me,dn=class n{constructor(t=new F,e=new F,i=new F){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Mi.subVectors(t,e),s.cross(Mi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Mi.subVectors(s,e),Zi.subVectors(i,e),hc.subVectors(t,e);let o=Mi.dot(Mi),a=Mi.dot(Zi),l=Mi.dot(hc),c=Zi.dot(Zi),h=Zi.dot(hc),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,m=(c*l-a*h)*f,v=(o*h-a*l)*f;return r.set(1-m-v,v,m)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Ki)===null?!1:Ki.x>=0&&Ki.y>=0&&Ki.x+Ki.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Ki)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ki.x),l.addScaledVector(o,Ki.y),l.addScaledVector(a,Ki.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return pc.setScalar(0),mc.setScalar(0),gc.setScalar(0),pc.fromBufferAttribute(t,e),mc.fromBufferAttribute(t,i),gc.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(pc,r.x),o.addScaledVector(mc,r.y),o.addScaledVector(gc,r.z),o}static isFrontFacing(t,e,i,s){return Mi.subVectors(i,e),Zi.subVectors(t,e),Mi.cross(Zi).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Mi.subVectors(this.c,this.b),Zi.subVectors(this.a,this.b),Mi.cross(Zi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;ls.subVectors(s,i),cs.subVectors(r,i),uc.subVectors(t,i);let l=ls.dot(uc),c=cs.dot(uc);if(l<=0&&c<=0)return e.copy(i);dc.subVectors(t,s);let h=ls.dot(dc),u=cs.dot(dc);if(h>=0&&u<=h)return e.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0)return o=l/(l-h),e.copy(i).addScaledVector(ls,o);fc.subVectors(t,r);let m=ls.dot(fc),v=cs.dot(fc);if(v>=0&&m<=v)return e.copy(r);let M=m*c-l*v;if(M<=0&&c>=0&&v<=0)return a=c/(c-v),e.copy(i).addScaledVector(cs,a);let g=h*v-m*u;if(g<=0&&u-h>=0&&m-v>=0)return Eu.subVectors(r,s),a=(u-h)/(u-h+(m-v)),e.copy(s).addScaledVector(Eu,a);let d=1/(g+M+f);return o=M*d,a=f*d,e.copy(i).addScaledVector(ls,o).addScaledVector(cs,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Rd={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},hn={h:0,s:0,l:0},Ao={h:0,s:0,l:0};function _c(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Ot=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ci){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Jt.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Jt.workingColorSpace){return this.r=t,this.g=e,this.b=i,Jt.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Jt.workingColorSpace){if(t=Xc(t,1),e=qt(e,0,1),i=qt(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=_c(o,r,t+1/3),this.g=_c(o,r,t),this.b=_c(o,r,t-1/3)}return Jt.colorSpaceToWorking(this,s),this}setStyle(t,e=ci){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ci){let i=Rd[t.toLowerCase()];return i!==void 0?this.setHex(i,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ji(t.r),this.g=ji(t.g),this.b=ji(t.b),this}copyLinearToSRGB(t){return this.r=ms(t.r),this.g=ms(t.g),this.b=ms(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ci){return Jt.workingToColorSpace(Ve.copy(this),t),Math.round(qt(Ve.r*255,0,255))*65536+Math.round(qt(Ve.g*255,0,255))*256+Math.round(qt(Ve.b*255,0,255))}getHexString(t=ci){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Jt.workingColorSpace){Jt.workingToColorSpace(Ve.copy(this),e);let i=Ve.r,s=Ve.g,r=Ve.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Jt.workingColorSpace){return Jt.workingToColorSpace(Ve.copy(this),e),t.r=Ve.r,t.g=Ve.g,t.b=Ve.b,t}getStyle(t=ci){Jt.workingToColorSpace(Ve.copy(this),t);let e=Ve.r,i=Ve.g,s=Ve.b;return t!==ci?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(hn),this.setHSL(hn.h+t,hn.s+e,hn.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(hn),t.getHSL(Ao);let i=er(hn.h,Ao.h,e),s=er(hn.s,Ao.s,e),r=er(hn.l,Ao.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ve=new Ot;Ot.NAMES=Rd;var Um=0,Fi=class extends Li{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Um++}),this.uuid=As(),this.name="",this.type="Material",this.blending=Nn,this.side=Ji,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Wo,this.blendDst=Xo,this.blendEquation=pn,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ot(0,0,0),this.blendAlpha=0,this.depthFunc=Fn,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Ec,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Dn,this.stencilZFail=Dn,this.stencilZPass=Dn,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Nn&&(i.blending=this.blending),this.side!==Ji&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Wo&&(i.blendSrc=this.blendSrc),this.blendDst!==Xo&&(i.blendDst=this.blendDst),this.blendEquation!==pn&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==Fn&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Ec&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Dn&&(i.stencilFail=this.stencilFail),this.stencilZFail!==Dn&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==Dn&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},lr=class extends Fi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ot(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ei,this.combine=Sa,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}};var Te=new F,Ro=new zt,Nm=0,be=class{constructor(t,e,i=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Nm++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Tc,this.updateRanges=[],this.gpuType=Ri,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Ro.fromBufferAttribute(this,e),Ro.applyMatrix3(t),this.setXY(e,Ro.x,Ro.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Te.fromBufferAttribute(this,e),Te.applyMatrix3(t),this.setXYZ(e,Te.x,Te.y,Te.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Te.fromBufferAttribute(this,e),Te.applyMatrix4(t),this.setXYZ(e,Te.x,Te.y,Te.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Te.fromBufferAttribute(this,e),Te.applyNormalMatrix(t),this.setXYZ(e,Te.x,Te.y,Te.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Te.fromBufferAttribute(this,e),Te.transformDirection(t),this.setXYZ(e,Te.x,Te.y,Te.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=ps(i,this.array)),i}setComponent(t,e,i){return this.normalized&&(i=$e(i,this.array)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=ps(e,this.array)),e}setX(t,e){return this.normalized&&(e=$e(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=ps(e,this.array)),e}setY(t,e){return this.normalized&&(e=$e(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=ps(e,this.array)),e}setZ(t,e){return this.normalized&&(e=$e(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=ps(e,this.array)),e}setW(t,e){return this.normalized&&(e=$e(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=$e(e,this.array),i=$e(i,this.array)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=$e(e,this.array),i=$e(i,this.array),s=$e(s,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=$e(e,this.array),i=$e(i,this.array),s=$e(s,this.array),r=$e(r,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==Tc&&(t.usage=this.usage),t}};var cr=class extends be{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var hr=class extends be{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Ke=class extends be{constructor(t,e,i){super(new Float32Array(t),e,i)}},Fm=0,pi=new ae,vc=new We,hs=new F,li=new Ui,Ks=new Ui,Ie=new F,we=class n extends Li{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Fm++}),this.uuid=As(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Yc(t)?hr:cr)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Ht().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return pi.makeRotationFromQuaternion(t),this.applyMatrix4(pi),this}rotateX(t){return pi.makeRotationX(t),this.applyMatrix4(pi),this}rotateY(t){return pi.makeRotationY(t),this.applyMatrix4(pi),this}rotateZ(t){return pi.makeRotationZ(t),this.applyMatrix4(pi),this}translate(t,e,i){return pi.makeTranslation(t,e,i),this.applyMatrix4(pi),this}scale(t,e,i){return pi.makeScale(t,e,i),this.applyMatrix4(pi),this}lookAt(t){return vc.lookAt(t),vc.updateMatrix(),this.applyMatrix4(vc.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(hs).negate(),this.translate(hs.x,hs.y,hs.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ke(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ui);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new F(-1/0,-1/0,-1/0),new F(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];li.setFromBufferAttribute(r),this.morphTargetsRelative?(Ie.addVectors(this.boundingBox.min,li.min),this.boundingBox.expandByPoint(Ie),Ie.addVectors(this.boundingBox.max,li.max),this.boundingBox.expandByPoint(Ie)):(this.boundingBox.expandByPoint(li.min),this.boundingBox.expandByPoint(li.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ni);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new F,1/0);return}if(t){let i=this.boundingSphere.center;if(li.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Ks.setFromBufferAttribute(a),this.morphTargetsRelative?(Ie.addVectors(li.min,Ks.min),li.expandByPoint(Ie),Ie.addVectors(li.max,Ks.max),li.expandByPoint(Ie)):(li.expandByPoint(Ks.min),li.expandByPoint(Ks.max))}li.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Ie.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Ie));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Ie.fromBufferAttribute(a,c),l&&(hs.fromBufferAttribute(t,c),Ie.add(hs)),s=Math.max(s,i.distanceToSquared(Ie))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new be(new Float32Array(4*i.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let k=0;k<i.count;k++)a[k]=new F,l[k]=new F;let c=new F,h=new F,u=new F,f=new zt,m=new zt,v=new zt,M=new F,g=new F;function d(k,x,b){c.fromBufferAttribute(i,k),h.fromBufferAttribute(i,x),u.fromBufferAttribute(i,b),f.fromBufferAttribute(r,k),m.fromBufferAttribute(r,x),v.fromBufferAttribute(r,b),h.sub(c),u.sub(c),m.sub(f),v.sub(f);let C=1/(m.x*v.y-v.x*m.y);isFinite(C)&&(M.copy(h).multiplyScalar(v.y).addScaledVector(u,-m.y).multiplyScalar(C),g.copy(u).multiplyScalar(m.x).addScaledVector(h,-v.x).multiplyScalar(C),a[k].add(M),a[x].add(M),a[b].add(M),l[k].add(g),l[x].add(g),l[b].add(g))}let R=this.groups;R.length===0&&(R=[{start:0,count:t.count}]);for(let k=0,x=R.length;k<x;++k){let b=R[k],C=b.start,B=b.count;for(let V=C,X=C+B;V<X;V+=3)d(t.getX(V+0),t.getX(V+1),t.getX(V+2))}let E=new F,S=new F,I=new F,P=new F;function D(k){I.fromBufferAttribute(s,k),P.copy(I);let x=a[k];E.copy(x),E.sub(I.multiplyScalar(I.dot(x))).normalize(),S.crossVectors(P,x);let C=S.dot(l[k])<0?-1:1;o.setXYZW(k,E.x,E.y,E.z,C)}for(let k=0,x=R.length;k<x;++k){let b=R[k],C=b.start,B=b.count;for(let V=C,X=C+B;V<X;V+=3)D(t.getX(V+0)),D(t.getX(V+1)),D(t.getX(V+2))}}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new be(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let f=0,m=i.count;f<m;f++)i.setXYZ(f,0,0,0);let s=new F,r=new F,o=new F,a=new F,l=new F,c=new F,h=new F,u=new F;if(t)for(let f=0,m=t.count;f<m;f+=3){let v=t.getX(f+0),M=t.getX(f+1),g=t.getX(f+2);s.fromBufferAttribute(e,v),r.fromBufferAttribute(e,M),o.fromBufferAttribute(e,g),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,v),l.fromBufferAttribute(i,M),c.fromBufferAttribute(i,g),a.add(h),l.add(h),c.add(h),i.setXYZ(v,a.x,a.y,a.z),i.setXYZ(M,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,m=e.count;f<m;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(f+0,h.x,h.y,h.z),i.setXYZ(f+1,h.x,h.y,h.z),i.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Ie.fromBufferAttribute(t,e),Ie.normalize(),t.setXYZ(e,Ie.x,Ie.y,Ie.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),m=0,v=0;for(let M=0,g=l.length;M<g;M++){a.isInterleavedBufferAttribute?m=l[M]*a.data.stride+a.offset:m=l[M]*h;for(let d=0;d<h;d++)f[v++]=c[m++]}return new be(f,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],m=t(f,i);l.push(m)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let m=c[u];h.push(m.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,m=u.length;f<m;f++)h.push(u[f].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},Tu=new ae,In=new mn,Co=new Ni,Au=new F,Po=new F,Io=new F,Lo=new F,yc=new F,Do=new F,Ru=new F,Uo=new F,Xe=class extends We{constructor(t=new we,e=new lr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Do.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(yc.fromBufferAttribute(u,t),o?Do.addScaledVector(yc,h):Do.addScaledVector(yc.sub(e),h))}e.add(Do)}return e}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Co.copy(i.boundingSphere),Co.applyMatrix4(r),In.copy(t.ray).recast(t.near),!(Co.containsPoint(In.origin)===!1&&(In.intersectSphere(Co,Au)===null||In.origin.distanceToSquared(Au)>(t.far-t.near)**2))&&(Tu.copy(r).invert(),In.copy(t.ray).applyMatrix4(Tu),!(i.boundingBox!==null&&In.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,In)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let v=0,M=f.length;v<M;v++){let g=f[v],d=o[g.materialIndex],R=Math.max(g.start,m.start),E=Math.min(a.count,Math.min(g.start+g.count,m.start+m.count));for(let S=R,I=E;S<I;S+=3){let P=a.getX(S),D=a.getX(S+1),k=a.getX(S+2);s=No(this,d,t,i,c,h,u,P,D,k),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let v=Math.max(0,m.start),M=Math.min(a.count,m.start+m.count);for(let g=v,d=M;g<d;g+=3){let R=a.getX(g),E=a.getX(g+1),S=a.getX(g+2);s=No(this,o,t,i,c,h,u,R,E,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let v=0,M=f.length;v<M;v++){let g=f[v],d=o[g.materialIndex],R=Math.max(g.start,m.start),E=Math.min(l.count,Math.min(g.start+g.count,m.start+m.count));for(let S=R,I=E;S<I;S+=3){let P=S,D=S+1,k=S+2;s=No(this,d,t,i,c,h,u,P,D,k),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let v=Math.max(0,m.start),M=Math.min(l.count,m.start+m.count);for(let g=v,d=M;g<d;g+=3){let R=g,E=g+1,S=g+2;s=No(this,o,t,i,c,h,u,R,E,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function Om(n,t,e,i,s,r,o,a){let l;if(t.side===Je?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Ji,a),l===null)return null;Uo.copy(a),Uo.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Uo);return c<e.near||c>e.far?null:{distance:c,point:Uo.clone(),object:n}}function No(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Po),n.getVertexPosition(l,Io),n.getVertexPosition(c,Lo);let h=Om(n,t,e,i,Po,Io,Lo,Ru);if(h){let u=new F;dn.getBarycoord(Ru,Po,Io,Lo,u),s&&(h.uv=dn.getInterpolatedAttribute(s,a,l,c,u,new zt)),r&&(h.uv1=dn.getInterpolatedAttribute(r,a,l,c,u,new zt)),o&&(h.normal=dn.getInterpolatedAttribute(o,a,l,c,u,new F),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new F,materialIndex:0};dn.getNormal(Po,Io,Lo,f.normal),h.face=f,h.barycoord=u}return h}var xs=class n extends we{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,m=0;v("z","y","x",-1,-1,i,e,t,o,r,0),v("z","y","x",1,-1,i,e,-t,o,r,1),v("x","z","y",1,1,t,i,e,s,o,2),v("x","z","y",1,-1,t,i,-e,s,o,3),v("x","y","z",1,-1,t,e,i,s,r,4),v("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ke(c,3)),this.setAttribute("normal",new Ke(h,3)),this.setAttribute("uv",new Ke(u,2));function v(M,g,d,R,E,S,I,P,D,k,x){let b=S/D,C=I/k,B=S/2,V=I/2,X=P/2,K=D+1,Y=k+1,nt=0,G=0,lt=new F;for(let dt=0;dt<Y;dt++){let At=dt*C-V;for(let Yt=0;Yt<K;Yt++){let le=Yt*b-B;lt[M]=le*R,lt[g]=At*E,lt[d]=X,c.push(lt.x,lt.y,lt.z),lt[M]=0,lt[g]=0,lt[d]=P>0?1:-1,h.push(lt.x,lt.y,lt.z),u.push(Yt/D),u.push(1-dt/k),nt+=1}}for(let dt=0;dt<k;dt++)for(let At=0;At<D;At++){let Yt=f+At+K*dt,le=f+At+K*(dt+1),fe=f+(At+1)+K*(dt+1),te=f+(At+1)+K*dt;l.push(Yt,le,te),l.push(le,fe,te),G+=6}a.addGroup(m,G,x),m+=G,f+=nt}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};function Gn(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone():Array.isArray(s)?t[e][i]=s.slice():t[e][i]=s}}return t}function qe(n){let t={};for(let e=0;e<n.length;e++){let i=Gn(n[e]);for(let s in i)t[s]=i[s]}return t}function km(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function $c(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Jt.workingColorSpace}var Cd={clone:Gn,merge:qe},Bm=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,zm=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ti=class extends Fi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Bm,this.fragmentShader=zm,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Gn(t.uniforms),this.uniformsGroups=km(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}},ur=class extends We{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ae,this.projectionMatrix=new ae,this.projectionMatrixInverse=new ae,this.coordinateSystem=wi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},un=new F,Cu=new zt,Pu=new zt,Ge=class extends ur{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=_s*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(tr*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return _s*2*Math.atan(Math.tan(tr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){un.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(un.x,un.y).multiplyScalar(-t/un.z),un.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(un.x,un.y).multiplyScalar(-t/un.z)}getViewSize(t,e){return this.getViewBounds(t,Cu,Pu),e.subVectors(Pu,Cu)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(tr*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}},us=-90,ds=1,Jo=class extends We{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Ge(us,ds,t,e);s.layers=this.layers,this.add(s);let r=new Ge(us,ds,t,e);r.layers=this.layers,this.add(r);let o=new Ge(us,ds,t,e);o.layers=this.layers,this.add(o);let a=new Ge(us,ds,t,e);a.layers=this.layers,this.add(a);let l=new Ge(us,ds,t,e);l.layers=this.layers,this.add(l);let c=new Ge(us,ds,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===wi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===sr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),m=t.getActiveMipmapLevel(),v=t.xr.enabled;t.xr.enabled=!1;let M=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,t.setRenderTarget(i,0,s),t.render(e,r),t.setRenderTarget(i,1,s),t.render(e,o),t.setRenderTarget(i,2,s),t.render(e,a),t.setRenderTarget(i,3,s),t.render(e,l),t.setRenderTarget(i,4,s),t.render(e,c),i.texture.generateMipmaps=M,t.setRenderTarget(i,5,s),t.render(e,h),t.setRenderTarget(u,f,m),t.xr.enabled=v,i.texture.needsPMREMUpdate=!0}},dr=class extends je{constructor(t=[],e=Hn,i,s,r,o,a,l,c,h){super(t,e,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Qo=class extends Di{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new dr(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new xs(5,5,5),r=new Ti({name:"CubemapFromEquirect",uniforms:Gn(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Je,blending:tn});r.uniforms.tEquirect.value=e;let o=new Xe(s,r),a=e.minFilter;return e.minFilter===xn&&(e.minFilter=Si),new Jo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Un=class extends We{constructor(){super(),this.isGroup=!0,this.type="Group"}},Hm={type:"move"},bs=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Un,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Un,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new F,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new F),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Un,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new F,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new F),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let M of t.hand.values()){let g=e.getJointPose(M,i),d=this._getHandJoint(c,M);g!==null&&(d.matrix.fromArray(g.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=g.radius),d.visible=g!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),m=.02,v=.005;c.inputState.pinching&&f>m+v?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=m-v&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Hm)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Un;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}};var fr=class extends We{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ei,this.environmentIntensity=1,this.environmentRotation=new Ei,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};var ta=class extends je{constructor(t=null,e=1,i=1,s,r,o,a,l,c=ei,h=ei,u,f){super(null,o,a,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var pr=class extends be{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},fs=new ae,Iu=new ae,Fo=[],Lu=new Ui,Vm=new ae,js=new Xe,Js=new Ni,mr=class extends Xe{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new pr(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,Vm)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Ui),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,fs),Lu.copy(t.boundingBox).applyMatrix4(fs),this.boundingBox.union(Lu)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Ni),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,fs),Js.copy(t.boundingSphere).applyMatrix4(fs),this.boundingSphere.union(Js)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),t.morphTexture!==null&&(this.morphTexture=t.morphTexture.clone()),t.instanceColor!==null&&(this.instanceColor=t.instanceColor.clone()),this.count=t.count,t.boundingBox!==null&&(this.boundingBox=t.boundingBox.clone()),t.boundingSphere!==null&&(this.boundingSphere=t.boundingSphere.clone()),this}getColorAt(t,e){e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(js.geometry=this.geometry,js.material=this.material,js.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Js.copy(this.boundingSphere),Js.applyMatrix4(i),t.ray.intersectsSphere(Js)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,fs),Iu.multiplyMatrices(i,fs),js.matrixWorld=Iu,js.raycast(t,Fo);for(let o=0,a=Fo.length;o<a;o++){let l=Fo[o];l.instanceId=r,l.object=this,e.push(l)}Fo.length=0}}setColorAt(t,e){this.instanceColor===null&&(this.instanceColor=new pr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3)}setMatrixAt(t,e){e.toArray(this.instanceMatrix.array,t*16)}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new ta(new Float32Array(s*this.count),s,this.count,Ia,Ri));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;r[l]=a,r.set(i,l+1)}updateMorphTargets(){}dispose(){this.dispatchEvent({type:"dispose"}),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},xc=new F,Gm=new F,Wm=new Ht,Ze=class{constructor(t=new F(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=xc.subVectors(i,e).cross(Gm.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){let i=t.delta(xc),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(i,r)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||Wm.getNormalMatrix(t),s=this.coplanarPoint(xc).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}},Ln=new Ni,Xm=new zt(.5,.5),Oo=new F,gr=class{constructor(t=new Ze,e=new Ze,i=new Ze,s=new Ze,r=new Ze,o=new Ze){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=wi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],m=r[7],v=r[8],M=r[9],g=r[10],d=r[11],R=r[12],E=r[13],S=r[14],I=r[15];if(s[0].setComponents(c-o,m-h,d-v,I-R).normalize(),s[1].setComponents(c+o,m+h,d+v,I+R).normalize(),s[2].setComponents(c+a,m+u,d+M,I+E).normalize(),s[3].setComponents(c-a,m-u,d-M,I-E).normalize(),i)s[4].setComponents(l,f,g,S).normalize(),s[5].setComponents(c-l,m-f,d-g,I-S).normalize();else if(s[4].setComponents(c-l,m-f,d-g,I-S).normalize(),e===wi)s[5].setComponents(c+l,m+f,d+g,I+S).normalize();else if(e===sr)s[5].setComponents(l,f,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ln.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ln.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ln)}intersectsSprite(t){Ln.center.set(0,0,0);let e=Xm.distanceTo(t.center);return Ln.radius=.7071067811865476+e,Ln.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ln)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Oo.x=s.normal.x>0?t.max.x:t.min.x,Oo.y=s.normal.y>0?t.max.y:t.min.y,Oo.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Oo)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var Ai=class extends Fi{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ot(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},ea=new F,ia=new F,Du=new ae,Qs=new mn,ko=new Ni,bc=new F,Uu=new F,kn=class extends We{constructor(t=new we,e=new Ai){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)ea.fromBufferAttribute(e,s-1),ia.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=ea.distanceTo(ia);t.setAttribute("lineDistance",new Ke(i,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ko.copy(i.boundingSphere),ko.applyMatrix4(s),ko.radius+=r,t.ray.intersectsSphere(ko)===!1)return;Du.copy(s).invert(),Qs.copy(t.ray).applyMatrix4(Du);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,f=i.attributes.position;if(h!==null){let m=Math.max(0,o.start),v=Math.min(h.count,o.start+o.count);for(let M=m,g=v-1;M<g;M+=c){let d=h.getX(M),R=h.getX(M+1),E=Bo(this,t,Qs,l,d,R,M);E&&e.push(E)}if(this.isLineLoop){let M=h.getX(v-1),g=h.getX(m),d=Bo(this,t,Qs,l,M,g,v-1);d&&e.push(d)}}else{let m=Math.max(0,o.start),v=Math.min(f.count,o.start+o.count);for(let M=m,g=v-1;M<g;M+=c){let d=Bo(this,t,Qs,l,M,M+1,M);d&&e.push(d)}if(this.isLineLoop){let M=Bo(this,t,Qs,l,v-1,m,v-1);M&&e.push(M)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Bo(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(ea.fromBufferAttribute(a,s),ia.fromBufferAttribute(a,r),e.distanceSqToSegment(ea,ia,bc,Uu)>i)return;bc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(bc);if(!(c<t.near||c>t.far))return{distance:c,point:Uu.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Nu=new F,Fu=new F,Qi=class extends kn{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Nu.fromBufferAttribute(e,s),Fu.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Nu.distanceTo(Fu);t.setAttribute("lineDistance",new Ke(i,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Bn=class extends Fi{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Ot(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Ou=new ae,Ac=new mn,zo=new Ni,Ho=new F,Oi=class extends We{constructor(t=new we,e=new Bn){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),zo.copy(i.boundingSphere),zo.applyMatrix4(s),zo.radius+=r,t.ray.intersectsSphere(zo)===!1)return;Ou.copy(s).invert(),Ac.copy(t.ray).applyMatrix4(Ou);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,u=i.attributes.position;if(c!==null){let f=Math.max(0,o.start),m=Math.min(c.count,o.start+o.count);for(let v=f,M=m;v<M;v++){let g=c.getX(v);Ho.fromBufferAttribute(u,g),ku(Ho,g,l,s,t,e,this)}}else{let f=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let v=f,M=m;v<M;v++)Ho.fromBufferAttribute(u,v),ku(Ho,v,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ku(n,t,e,i,s,r,o){let a=Ac.distanceSqToPoint(n);if(a<e){let l=new F;Ac.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var _r=class extends je{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}},vr=class extends je{constructor(t,e,i=bn,s,r,o,a=ei,l=ei,c,h=gs,u=1){if(h!==gs&&h!==Ts)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:u};super(f,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ys(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}},yr=class extends je{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}};var xr=class n extends we{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,u=t/a,f=e/l,m=[],v=[],M=[],g=[];for(let d=0;d<h;d++){let R=d*f-o;for(let E=0;E<c;E++){let S=E*u-r;v.push(S,-R,0),M.push(0,0,1),g.push(E/a),g.push(1-d/l)}}for(let d=0;d<l;d++)for(let R=0;R<a;R++){let E=R+c*d,S=R+c*(d+1),I=R+1+c*(d+1),P=R+1+c*d;m.push(E,S,P),m.push(S,I,P)}this.setIndex(m),this.setAttribute("position",new Ke(v,3)),this.setAttribute("normal",new Ke(M,3)),this.setAttribute("uv",new Ke(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var br=class n extends we{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new F,f=new F,m=[],v=[],M=[],g=[];for(let d=0;d<=i;d++){let R=[],E=d/i,S=0;d===0&&o===0?S=.5/e:d===i&&l===Math.PI&&(S=-.5/e);for(let I=0;I<=e;I++){let P=I/e;u.x=-t*Math.cos(s+P*r)*Math.sin(o+E*a),u.y=t*Math.cos(o+E*a),u.z=t*Math.sin(s+P*r)*Math.sin(o+E*a),v.push(u.x,u.y,u.z),f.copy(u).normalize(),M.push(f.x,f.y,f.z),g.push(P+S,1-E),R.push(c++)}h.push(R)}for(let d=0;d<i;d++)for(let R=0;R<e;R++){let E=h[d][R+1],S=h[d][R],I=h[d+1][R],P=h[d+1][R+1];(d!==0||o>0)&&m.push(E,S,P),(d!==i-1||l<Math.PI)&&m.push(S,I,P)}this.setIndex(m),this.setAttribute("position",new Ke(v,3)),this.setAttribute("normal",new Ke(M,3)),this.setAttribute("uv",new Ke(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Mr=class extends Fi{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ot(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ot(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Vc,this.normalScale=new zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ei,this.combine=Sa,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},na=class extends Fi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=gd,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},sa=class extends Fi{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Vo(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function qm(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}var zn=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];i:{t:{let o;e:{n:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break n;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break i}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},ra=class extends zn{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Mc,endingEnd:Mc}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case wc:r=t,a=2*e-i;break;case Sc:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case wc:o=t,l=2*i-e;break;case Sc:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,m=this._weightNext,v=(i-e)/(s-e),M=v*v,g=M*v,d=-f*g+2*f*M-f*v,R=(1+f)*g+(-1.5-2*f)*M+(-.5+f)*v+1,E=(-1-m)*g+(1.5+m)*M+.5*v,S=m*g-m*M;for(let I=0;I!==a;++I)r[I]=d*o[h+I]+R*o[c+I]+E*o[l+I]+S*o[u+I];return r}},oa=class extends zn{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(i-e)/(s-e),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},aa=class extends zn{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},hi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Vo(e,this.TimeBufferType),this.values=Vo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Vo(t.times,Array),values:Vo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s)}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new aa(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new oa(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new ra(this.times,this.values,this.getValueSize(),t)}setInterpolation(t){let e;switch(t){case ir:e=this.InterpolantFactoryMethodDiscrete;break;case $o:e=this.InterpolantFactoryMethodLinear;break;case Go:e=this.InterpolantFactoryMethodSmooth;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return console.warn("THREE.KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ir;case this.InterpolantFactoryMethodLinear:return $o;case this.InterpolantFactoryMethodSmooth:return Go}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&qm(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Go,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*i,f=u-i,m=u+i;for(let v=0;v!==i;++v){let M=e[u+v];if(M!==e[f+v]||M!==e[m+v]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*i,f=o*i;for(let m=0;m!==i;++m)e[f+m]=e[u+m]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,s}};hi.prototype.ValueTypeName="";hi.prototype.TimeBufferType=Float32Array;hi.prototype.ValueBufferType=Float32Array;hi.prototype.DefaultInterpolation=$o;var gn=class extends hi{constructor(t,e,i){super(t,e,i)}};gn.prototype.ValueTypeName="bool";gn.prototype.ValueBufferType=Array;gn.prototype.DefaultInterpolation=ir;gn.prototype.InterpolantFactoryMethodLinear=void 0;gn.prototype.InterpolantFactoryMethodSmooth=void 0;var la=class extends hi{constructor(t,e,i,s){super(t,e,i,s)}};la.prototype.ValueTypeName="color";var ca=class extends hi{constructor(t,e,i,s){super(t,e,i,s)}};ca.prototype.ValueTypeName="number";var ha=class extends zn{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)mi.slerpFlat(r,0,o,c-a,o,c,l);return r}},wr=class extends hi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new ha(this.times,this.values,this.getValueSize(),t)}};wr.prototype.ValueTypeName="quaternion";wr.prototype.InterpolantFactoryMethodSmooth=void 0;var _n=class extends hi{constructor(t,e,i){super(t,e,i)}};_n.prototype.ValueTypeName="string";_n.prototype.ValueBufferType=Array;_n.prototype.DefaultInterpolation=ir;_n.prototype.InterpolantFactoryMethodLinear=void 0;_n.prototype.InterpolantFactoryMethodSmooth=void 0;var ua=class extends hi{constructor(t,e,i,s){super(t,e,i,s)}};ua.prototype.ValueTypeName="vector";var da=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this.abortController=new AbortController,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let m=c[u],v=c[u+1];if(m.global&&(m.lastIndex=0),m.test(h))return v}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},Pd=new da,fa=class{constructor(t){this.manager=t!==void 0?t:Pd,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}abort(){return this}};fa.DEFAULT_MATERIAL_NAME="__DEFAULT";var pa=class extends We{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Ot(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}},Sr=class extends pa{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(We.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ot(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}};var ma=class extends ur{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var ga=class extends Ge{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t}};var Zc="\\[\\]\\.:\\/",Ym=new RegExp("["+Zc+"]","g"),Kc="[^"+Zc+"]",$m="[^"+Zc.replace("\\.","")+"]",Zm=/((?:WC+[\/:])*)/.source.replace("WC",Kc),Km=/(WCOD+)?/.source.replace("WCOD",$m),jm=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Kc),Jm=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Kc),Qm=new RegExp("^"+Zm+Km+jm+Jm+"$"),tg=["material","materials","bones","map"],Rc=class{constructor(t,e,i){let s=i||de.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},de=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Ym,"")}static parseTrackName(t){let e=Qm.exec(t);if(e===null)throw new Error("PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);tg.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};de.Composite=Rc;de.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};de.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};de.prototype.GetterByBindingType=[de.prototype._getValue_direct,de.prototype._getValue_array,de.prototype._getValue_arrayElement,de.prototype._getValue_toArray];de.prototype.SetterByBindingTypeAndVersioning=[[de.prototype._setValue_direct,de.prototype._setValue_direct_setNeedsUpdate,de.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[de.prototype._setValue_array,de.prototype._setValue_array_setNeedsUpdate,de.prototype._setValue_array_setMatrixWorldNeedsUpdate],[de.prototype._setValue_arrayElement,de.prototype._setValue_arrayElement_setNeedsUpdate,de.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[de.prototype._setValue_fromArray,de.prototype._setValue_fromArray_setNeedsUpdate,de.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Jw=new Float32Array(1);var Ms=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=qt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(qt(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Er=class extends Li{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){if(t===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function jc(n,t,e,i){let s=eg(i);switch(e){case Bc:return n*t;case Ia:return n*t/s.components*s.byteLength;case La:return n*t/s.components*s.byteLength;case Hc:return n*t*2/s.components*s.byteLength;case Da:return n*t*2/s.components*s.byteLength;case zc:return n*t*3/s.components*s.byteLength;case gi:return n*t*4/s.components*s.byteLength;case Ua:return n*t*4/s.components*s.byteLength;case Rr:case Cr:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Pr:case Ir:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Fa:case ka:return Math.max(n,16)*Math.max(t,8)/4;case Na:case Oa:return Math.max(n,8)*Math.max(t,8)/2;case Ba:case za:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ha:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Va:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ga:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Wa:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Xa:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case qa:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Ya:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case $a:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Za:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Ka:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case ja:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Ja:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Qa:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case tl:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case el:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case il:case nl:case sl:return Math.ceil(n/4)*Math.ceil(t/4)*16;case rl:case ol:return Math.ceil(n/4)*Math.ceil(t/4)*8;case al:case ll:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function eg(n){switch(n){case zi:case Nc:return{byteLength:1,components:1};case ws:case Fc:case Ss:return{byteLength:2,components:1};case Ca:case Pa:return{byteLength:2,components:4};case bn:case Ra:case Ri:return{byteLength:4,components:1};case Oc:case kc:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");function tf(){let n=null,t=!1,e=null,i=null;function s(r,o){e(r,o),i=n.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function ng(n){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,h),a.onUploadCallback();let m;if(c instanceof Float32Array)m=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)m=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=n.HALF_FLOAT:m=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=n.SHORT;else if(c instanceof Uint32Array)m=n.UNSIGNED_INT;else if(c instanceof Int32Array)m=n.INT;else if(c instanceof Int8Array)m=n.BYTE;else if(c instanceof Uint8Array)m=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,h);else{u.sort((m,v)=>m.start-v.start);let f=0;for(let m=1;m<u.length;m++){let v=u[f],M=u[m];M.start<=v.start+v.count+1?v.count=Math.max(v.count,M.start+M.count-v.start):(++f,u[f]=M)}u.length=f+1;for(let m=0,v=u.length;m<v;m++){let M=u[m];n.bufferSubData(c,M.start*h.BYTES_PER_ELEMENT,h,M.start,M.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var sg=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,rg=`#ifdef USE_ALPHAHASH
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
#endif`,og=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,ag=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,lg=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,cg=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,hg=`#ifdef USE_AOMAP
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
#endif`,ug=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,dg=`#ifdef USE_BATCHING
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
#endif`,fg=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,pg=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,mg=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,gg=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,_g=`#ifdef USE_IRIDESCENCE
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
#endif`,vg=`#ifdef USE_BUMPMAP
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
#endif`,yg=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,xg=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,bg=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Mg=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,wg=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Sg=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Eg=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,Tg=`#if defined( USE_COLOR_ALPHA )
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
#endif`,Ag=`#define PI 3.141592653589793
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
} // validated`,Rg=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,Cg=`vec3 transformedNormal = objectNormal;
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
#endif`,Pg=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ig=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Lg=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Dg=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Ug="gl_FragColor = linearToOutputTexel( gl_FragColor );",Ng=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Fg=`#ifdef USE_ENVMAP
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
#endif`,Og=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,kg=`#ifdef USE_ENVMAP
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
#endif`,Bg=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,zg=`#ifdef USE_ENVMAP
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
#endif`,Hg=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Vg=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Gg=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Wg=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Xg=`#ifdef USE_GRADIENTMAP
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
}`,qg=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Yg=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,$g=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Zg=`uniform bool receiveShadow;
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
#endif`,Kg=`#ifdef USE_ENVMAP
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
#endif`,jg=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Jg=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Qg=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,t_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,e_=`PhysicalMaterial material;
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
#endif`,i_=`struct PhysicalMaterial {
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
}`,n_=`
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
#endif`,s_=`#if defined( RE_IndirectDiffuse )
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
#endif`,r_=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,o_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,a_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,l_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,c_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,h_=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,u_=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,d_=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,f_=`#if defined( USE_POINTS_UV )
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
#endif`,p_=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,m_=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,g_=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,__=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,v_=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,y_=`#ifdef USE_MORPHTARGETS
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
#endif`,x_=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,b_=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,M_=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,w_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,S_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,E_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,T_=`#ifdef USE_NORMALMAP
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
#endif`,A_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,R_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,C_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,P_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,I_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,L_=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,D_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,U_=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,N_=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,F_=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,O_=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,k_=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,B_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,z_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,H_=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,V_=`float getShadowMask() {
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
}`,G_=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,W_=`#ifdef USE_SKINNING
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
#endif`,X_=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,q_=`#ifdef USE_SKINNING
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
#endif`,Y_=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,$_=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Z_=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,K_=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,j_=`#ifdef USE_TRANSMISSION
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
#endif`,J_=`#ifdef USE_TRANSMISSION
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
#endif`,Q_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,tv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,ev=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,iv=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,nv=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,sv=`uniform sampler2D t2D;
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
}`,rv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ov=`#ifdef ENVMAP_TYPE_CUBE
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
}`,av=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,lv=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cv=`#include <common>
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
}`,hv=`#if DEPTH_PACKING == 3200
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
}`,uv=`#define DISTANCE
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
}`,dv=`#define DISTANCE
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
}`,fv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,pv=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,mv=`uniform float scale;
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
}`,gv=`uniform vec3 diffuse;
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
}`,_v=`#include <common>
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
}`,vv=`uniform vec3 diffuse;
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
}`,yv=`#define LAMBERT
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
}`,xv=`#define LAMBERT
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
}`,bv=`#define MATCAP
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
}`,Mv=`#define MATCAP
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
}`,wv=`#define NORMAL
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
}`,Sv=`#define NORMAL
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
}`,Ev=`#define PHONG
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
}`,Tv=`#define PHONG
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
}`,Av=`#define STANDARD
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
}`,Rv=`#define STANDARD
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
}`,Cv=`#define TOON
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
}`,Pv=`#define TOON
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
}`,Iv=`uniform float size;
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
}`,Lv=`uniform vec3 diffuse;
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
}`,Dv=`#include <common>
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
}`,Uv=`uniform vec3 color;
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
}`,Nv=`uniform float rotation;
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
}`,Fv=`uniform vec3 diffuse;
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
}`,Wt={alphahash_fragment:sg,alphahash_pars_fragment:rg,alphamap_fragment:og,alphamap_pars_fragment:ag,alphatest_fragment:lg,alphatest_pars_fragment:cg,aomap_fragment:hg,aomap_pars_fragment:ug,batching_pars_vertex:dg,batching_vertex:fg,begin_vertex:pg,beginnormal_vertex:mg,bsdfs:gg,iridescence_fragment:_g,bumpmap_pars_fragment:vg,clipping_planes_fragment:yg,clipping_planes_pars_fragment:xg,clipping_planes_pars_vertex:bg,clipping_planes_vertex:Mg,color_fragment:wg,color_pars_fragment:Sg,color_pars_vertex:Eg,color_vertex:Tg,common:Ag,cube_uv_reflection_fragment:Rg,defaultnormal_vertex:Cg,displacementmap_pars_vertex:Pg,displacementmap_vertex:Ig,emissivemap_fragment:Lg,emissivemap_pars_fragment:Dg,colorspace_fragment:Ug,colorspace_pars_fragment:Ng,envmap_fragment:Fg,envmap_common_pars_fragment:Og,envmap_pars_fragment:kg,envmap_pars_vertex:Bg,envmap_physical_pars_fragment:Kg,envmap_vertex:zg,fog_vertex:Hg,fog_pars_vertex:Vg,fog_fragment:Gg,fog_pars_fragment:Wg,gradientmap_pars_fragment:Xg,lightmap_pars_fragment:qg,lights_lambert_fragment:Yg,lights_lambert_pars_fragment:$g,lights_pars_begin:Zg,lights_toon_fragment:jg,lights_toon_pars_fragment:Jg,lights_phong_fragment:Qg,lights_phong_pars_fragment:t_,lights_physical_fragment:e_,lights_physical_pars_fragment:i_,lights_fragment_begin:n_,lights_fragment_maps:s_,lights_fragment_end:r_,logdepthbuf_fragment:o_,logdepthbuf_pars_fragment:a_,logdepthbuf_pars_vertex:l_,logdepthbuf_vertex:c_,map_fragment:h_,map_pars_fragment:u_,map_particle_fragment:d_,map_particle_pars_fragment:f_,metalnessmap_fragment:p_,metalnessmap_pars_fragment:m_,morphinstance_vertex:g_,morphcolor_vertex:__,morphnormal_vertex:v_,morphtarget_pars_vertex:y_,morphtarget_vertex:x_,normal_fragment_begin:b_,normal_fragment_maps:M_,normal_pars_fragment:w_,normal_pars_vertex:S_,normal_vertex:E_,normalmap_pars_fragment:T_,clearcoat_normal_fragment_begin:A_,clearcoat_normal_fragment_maps:R_,clearcoat_pars_fragment:C_,iridescence_pars_fragment:P_,opaque_fragment:I_,packing:L_,premultiplied_alpha_fragment:D_,project_vertex:U_,dithering_fragment:N_,dithering_pars_fragment:F_,roughnessmap_fragment:O_,roughnessmap_pars_fragment:k_,shadowmap_pars_fragment:B_,shadowmap_pars_vertex:z_,shadowmap_vertex:H_,shadowmask_pars_fragment:V_,skinbase_vertex:G_,skinning_pars_vertex:W_,skinning_vertex:X_,skinnormal_vertex:q_,specularmap_fragment:Y_,specularmap_pars_fragment:$_,tonemapping_fragment:Z_,tonemapping_pars_fragment:K_,transmission_fragment:j_,transmission_pars_fragment:J_,uv_pars_fragment:Q_,uv_pars_vertex:tv,uv_vertex:ev,worldpos_vertex:iv,background_vert:nv,background_frag:sv,backgroundCube_vert:rv,backgroundCube_frag:ov,cube_vert:av,cube_frag:lv,depth_vert:cv,depth_frag:hv,distanceRGBA_vert:uv,distanceRGBA_frag:dv,equirect_vert:fv,equirect_frag:pv,linedashed_vert:mv,linedashed_frag:gv,meshbasic_vert:_v,meshbasic_frag:vv,meshlambert_vert:yv,meshlambert_frag:xv,meshmatcap_vert:bv,meshmatcap_frag:Mv,meshnormal_vert:wv,meshnormal_frag:Sv,meshphong_vert:Ev,meshphong_frag:Tv,meshphysical_vert:Av,meshphysical_frag:Rv,meshtoon_vert:Cv,meshtoon_frag:Pv,points_vert:Iv,points_frag:Lv,shadow_vert:Dv,shadow_frag:Uv,sprite_vert:Nv,sprite_frag:Fv},at={common:{diffuse:{value:new Ot(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ht},alphaMap:{value:null},alphaMapTransform:{value:new Ht},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ht}},envmap:{envMap:{value:null},envMapRotation:{value:new Ht},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ht}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ht}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ht},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ht},normalScale:{value:new zt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ht},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ht}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ht}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ht}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ot(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new Ot(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ht},alphaTest:{value:0},uvTransform:{value:new Ht}},sprite:{diffuse:{value:new Ot(16777215)},opacity:{value:1},center:{value:new zt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ht},alphaMap:{value:null},alphaMapTransform:{value:new Ht},alphaTest:{value:0}}},Hi={basic:{uniforms:qe([at.common,at.specularmap,at.envmap,at.aomap,at.lightmap,at.fog]),vertexShader:Wt.meshbasic_vert,fragmentShader:Wt.meshbasic_frag},lambert:{uniforms:qe([at.common,at.specularmap,at.envmap,at.aomap,at.lightmap,at.emissivemap,at.bumpmap,at.normalmap,at.displacementmap,at.fog,at.lights,{emissive:{value:new Ot(0)}}]),vertexShader:Wt.meshlambert_vert,fragmentShader:Wt.meshlambert_frag},phong:{uniforms:qe([at.common,at.specularmap,at.envmap,at.aomap,at.lightmap,at.emissivemap,at.bumpmap,at.normalmap,at.displacementmap,at.fog,at.lights,{emissive:{value:new Ot(0)},specular:{value:new Ot(1118481)},shininess:{value:30}}]),vertexShader:Wt.meshphong_vert,fragmentShader:Wt.meshphong_frag},standard:{uniforms:qe([at.common,at.envmap,at.aomap,at.lightmap,at.emissivemap,at.bumpmap,at.normalmap,at.displacementmap,at.roughnessmap,at.metalnessmap,at.fog,at.lights,{emissive:{value:new Ot(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Wt.meshphysical_vert,fragmentShader:Wt.meshphysical_frag},toon:{uniforms:qe([at.common,at.aomap,at.lightmap,at.emissivemap,at.bumpmap,at.normalmap,at.displacementmap,at.gradientmap,at.fog,at.lights,{emissive:{value:new Ot(0)}}]),vertexShader:Wt.meshtoon_vert,fragmentShader:Wt.meshtoon_frag},matcap:{uniforms:qe([at.common,at.bumpmap,at.normalmap,at.displacementmap,at.fog,{matcap:{value:null}}]),vertexShader:Wt.meshmatcap_vert,fragmentShader:Wt.meshmatcap_frag},points:{uniforms:qe([at.points,at.fog]),vertexShader:Wt.points_vert,fragmentShader:Wt.points_frag},dashed:{uniforms:qe([at.common,at.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Wt.linedashed_vert,fragmentShader:Wt.linedashed_frag},depth:{uniforms:qe([at.common,at.displacementmap]),vertexShader:Wt.depth_vert,fragmentShader:Wt.depth_frag},normal:{uniforms:qe([at.common,at.bumpmap,at.normalmap,at.displacementmap,{opacity:{value:1}}]),vertexShader:Wt.meshnormal_vert,fragmentShader:Wt.meshnormal_frag},sprite:{uniforms:qe([at.sprite,at.fog]),vertexShader:Wt.sprite_vert,fragmentShader:Wt.sprite_frag},background:{uniforms:{uvTransform:{value:new Ht},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Wt.background_vert,fragmentShader:Wt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ht}},vertexShader:Wt.backgroundCube_vert,fragmentShader:Wt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Wt.cube_vert,fragmentShader:Wt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Wt.equirect_vert,fragmentShader:Wt.equirect_frag},distanceRGBA:{uniforms:qe([at.common,at.displacementmap,{referencePosition:{value:new F},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Wt.distanceRGBA_vert,fragmentShader:Wt.distanceRGBA_frag},shadow:{uniforms:qe([at.lights,at.fog,{color:{value:new Ot(0)},opacity:{value:1}}]),vertexShader:Wt.shadow_vert,fragmentShader:Wt.shadow_frag}};Hi.physical={uniforms:qe([Hi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ht},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ht},clearcoatNormalScale:{value:new zt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ht},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ht},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ht},sheen:{value:0},sheenColor:{value:new Ot(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ht},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ht},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ht},transmissionSamplerSize:{value:new zt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ht},attenuationDistance:{value:0},attenuationColor:{value:new Ot(0)},specularColor:{value:new Ot(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ht},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ht},anisotropyVector:{value:new zt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ht}}]),vertexShader:Wt.meshphysical_vert,fragmentShader:Wt.meshphysical_frag};var cl={r:0,b:0,g:0},Wn=new Ei,Ov=new ae;function kv(n,t,e,i,s,r,o){let a=new Ot(0),l=r===!0?0:1,c,h,u=null,f=0,m=null;function v(E){let S=E.isScene===!0?E.background:null;return S&&S.isTexture&&(S=(E.backgroundBlurriness>0?e:t).get(S)),S}function M(E){let S=!1,I=v(E);I===null?d(a,l):I&&I.isColor&&(d(I,1),S=!0);let P=n.xr.getEnvironmentBlendMode();P==="additive"?i.buffers.color.setClear(0,0,0,1,o):P==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(n.autoClear||S)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function g(E,S){let I=v(S);I&&(I.isCubeTexture||I.mapping===Tr)?(h===void 0&&(h=new Xe(new xs(1,1,1),new Ti({name:"BackgroundCubeMaterial",uniforms:Gn(Hi.backgroundCube.uniforms),vertexShader:Hi.backgroundCube.vertexShader,fragmentShader:Hi.backgroundCube.fragmentShader,side:Je,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(P,D,k){this.matrixWorld.copyPosition(k.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),Wn.copy(S.backgroundRotation),Wn.x*=-1,Wn.y*=-1,Wn.z*=-1,I.isCubeTexture&&I.isRenderTargetTexture===!1&&(Wn.y*=-1,Wn.z*=-1),h.material.uniforms.envMap.value=I,h.material.uniforms.flipEnvMap.value=I.isCubeTexture&&I.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(Ov.makeRotationFromEuler(Wn)),h.material.toneMapped=Jt.getTransfer(I.colorSpace)!==ne,(u!==I||f!==I.version||m!==n.toneMapping)&&(h.material.needsUpdate=!0,u=I,f=I.version,m=n.toneMapping),h.layers.enableAll(),E.unshift(h,h.geometry,h.material,0,0,null)):I&&I.isTexture&&(c===void 0&&(c=new Xe(new xr(2,2),new Ti({name:"BackgroundMaterial",uniforms:Gn(Hi.background.uniforms),vertexShader:Hi.background.vertexShader,fragmentShader:Hi.background.fragmentShader,side:Ji,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=I,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.toneMapped=Jt.getTransfer(I.colorSpace)!==ne,I.matrixAutoUpdate===!0&&I.updateMatrix(),c.material.uniforms.uvTransform.value.copy(I.matrix),(u!==I||f!==I.version||m!==n.toneMapping)&&(c.material.needsUpdate=!0,u=I,f=I.version,m=n.toneMapping),c.layers.enableAll(),E.unshift(c,c.geometry,c.material,0,0,null))}function d(E,S){E.getRGB(cl,$c(n)),i.buffers.color.setClear(cl.r,cl.g,cl.b,S,o)}function R(){h!==void 0&&(h.geometry.dispose(),h.material.dispose(),h=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(E,S=1){a.set(E),l=S,d(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(E){l=E,d(a,l)},render:M,addToRenderList:g,dispose:R}}function Bv(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(b,C,B,V,X){let K=!1,Y=u(V,B,C);r!==Y&&(r=Y,c(r.object)),K=m(b,V,B,X),K&&v(b,V,B,X),X!==null&&t.update(X,n.ELEMENT_ARRAY_BUFFER),(K||o)&&(o=!1,S(b,C,B,V),X!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(X).buffer))}function l(){return n.createVertexArray()}function c(b){return n.bindVertexArray(b)}function h(b){return n.deleteVertexArray(b)}function u(b,C,B){let V=B.wireframe===!0,X=i[b.id];X===void 0&&(X={},i[b.id]=X);let K=X[C.id];K===void 0&&(K={},X[C.id]=K);let Y=K[V];return Y===void 0&&(Y=f(l()),K[V]=Y),Y}function f(b){let C=[],B=[],V=[];for(let X=0;X<e;X++)C[X]=0,B[X]=0,V[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:B,attributeDivisors:V,object:b,attributes:{},index:null}}function m(b,C,B,V){let X=r.attributes,K=C.attributes,Y=0,nt=B.getAttributes();for(let G in nt)if(nt[G].location>=0){let dt=X[G],At=K[G];if(At===void 0&&(G==="instanceMatrix"&&b.instanceMatrix&&(At=b.instanceMatrix),G==="instanceColor"&&b.instanceColor&&(At=b.instanceColor)),dt===void 0||dt.attribute!==At||At&&dt.data!==At.data)return!0;Y++}return r.attributesNum!==Y||r.index!==V}function v(b,C,B,V){let X={},K=C.attributes,Y=0,nt=B.getAttributes();for(let G in nt)if(nt[G].location>=0){let dt=K[G];dt===void 0&&(G==="instanceMatrix"&&b.instanceMatrix&&(dt=b.instanceMatrix),G==="instanceColor"&&b.instanceColor&&(dt=b.instanceColor));let At={};At.attribute=dt,dt&&dt.data&&(At.data=dt.data),X[G]=At,Y++}r.attributes=X,r.attributesNum=Y,r.index=V}function M(){let b=r.newAttributes;for(let C=0,B=b.length;C<B;C++)b[C]=0}function g(b){d(b,0)}function d(b,C){let B=r.newAttributes,V=r.enabledAttributes,X=r.attributeDivisors;B[b]=1,V[b]===0&&(n.enableVertexAttribArray(b),V[b]=1),X[b]!==C&&(n.vertexAttribDivisor(b,C),X[b]=C)}function R(){let b=r.newAttributes,C=r.enabledAttributes;for(let B=0,V=C.length;B<V;B++)C[B]!==b[B]&&(n.disableVertexAttribArray(B),C[B]=0)}function E(b,C,B,V,X,K,Y){Y===!0?n.vertexAttribIPointer(b,C,B,X,K):n.vertexAttribPointer(b,C,B,V,X,K)}function S(b,C,B,V){M();let X=V.attributes,K=B.getAttributes(),Y=C.defaultAttributeValues;for(let nt in K){let G=K[nt];if(G.location>=0){let lt=X[nt];if(lt===void 0&&(nt==="instanceMatrix"&&b.instanceMatrix&&(lt=b.instanceMatrix),nt==="instanceColor"&&b.instanceColor&&(lt=b.instanceColor)),lt!==void 0){let dt=lt.normalized,At=lt.itemSize,Yt=t.get(lt);if(Yt===void 0)continue;let le=Yt.buffer,fe=Yt.type,te=Yt.bytesPerElement,$=fe===n.INT||fe===n.UNSIGNED_INT||lt.gpuType===Ra;if(lt.isInterleavedBufferAttribute){let J=lt.data,mt=J.stride,Nt=lt.offset;if(J.isInstancedInterleavedBuffer){for(let Et=0;Et<G.locationSize;Et++)d(G.location+Et,J.meshPerAttribute);b.isInstancedMesh!==!0&&V._maxInstanceCount===void 0&&(V._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let Et=0;Et<G.locationSize;Et++)g(G.location+Et);n.bindBuffer(n.ARRAY_BUFFER,le);for(let Et=0;Et<G.locationSize;Et++)E(G.location+Et,At/G.locationSize,fe,dt,mt*te,(Nt+At/G.locationSize*Et)*te,$)}else{if(lt.isInstancedBufferAttribute){for(let J=0;J<G.locationSize;J++)d(G.location+J,lt.meshPerAttribute);b.isInstancedMesh!==!0&&V._maxInstanceCount===void 0&&(V._maxInstanceCount=lt.meshPerAttribute*lt.count)}else for(let J=0;J<G.locationSize;J++)g(G.location+J);n.bindBuffer(n.ARRAY_BUFFER,le);for(let J=0;J<G.locationSize;J++)E(G.location+J,At/G.locationSize,fe,dt,At*te,At/G.locationSize*J*te,$)}}else if(Y!==void 0){let dt=Y[nt];if(dt!==void 0)switch(dt.length){case 2:n.vertexAttrib2fv(G.location,dt);break;case 3:n.vertexAttrib3fv(G.location,dt);break;case 4:n.vertexAttrib4fv(G.location,dt);break;default:n.vertexAttrib1fv(G.location,dt)}}}}R()}function I(){k();for(let b in i){let C=i[b];for(let B in C){let V=C[B];for(let X in V)h(V[X].object),delete V[X];delete C[B]}delete i[b]}}function P(b){if(i[b.id]===void 0)return;let C=i[b.id];for(let B in C){let V=C[B];for(let X in V)h(V[X].object),delete V[X];delete C[B]}delete i[b.id]}function D(b){for(let C in i){let B=i[C];if(B[b.id]===void 0)continue;let V=B[b.id];for(let X in V)h(V[X].object),delete V[X];delete B[b.id]}}function k(){x(),o=!0,r!==s&&(r=s,c(r.object))}function x(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:x,dispose:I,releaseStatesOfGeometry:P,releaseStatesOfProgram:D,initAttributes:M,enableAttribute:g,disableUnusedAttributes:R}}function zv(n,t,e){let i;function s(c){i=c}function r(c,h){n.drawArrays(i,c,h),e.update(h,i,1)}function o(c,h,u){u!==0&&(n.drawArraysInstanced(i,c,h,u),e.update(h,i,u))}function a(c,h,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,h,0,u);let m=0;for(let v=0;v<u;v++)m+=h[v];e.update(m,i,1)}function l(c,h,u,f){if(u===0)return;let m=t.get("WEBGL_multi_draw");if(m===null)for(let v=0;v<c.length;v++)o(c[v],h[v],f[v]);else{m.multiDrawArraysInstancedWEBGL(i,c,0,h,0,f,0,u);let v=0;for(let M=0;M<u;M++)v+=h[M]*f[M];e.update(v,i,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function Hv(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let D=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==gi&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){let k=D===Ss&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==zi&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Ri&&!k)}function l(D){if(D==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.logarithmicDepthBuffer===!0,f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),m=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),d=n.getParameter(n.MAX_VERTEX_ATTRIBS),R=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),I=v>0,P=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:f,maxTextures:m,maxVertexTextures:v,maxTextureSize:M,maxCubemapSize:g,maxAttributes:d,maxVertexUniforms:R,maxVaryings:E,maxFragmentUniforms:S,vertexTextures:I,maxSamples:P}}function Vv(n){let t=this,e=null,i=0,s=!1,r=!1,o=new Ze,a=new Ht,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let m=u.length!==0||f||i!==0||s;return s=f,i=u.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,m){let v=u.clippingPlanes,M=u.clipIntersection,g=u.clipShadows,d=n.get(u);if(!s||v===null||v.length===0||r&&!g)r?h(null):c();else{let R=r?0:i,E=R*4,S=d.clippingState||null;l.value=S,S=h(v,f,E,m);for(let I=0;I!==E;++I)S[I]=e[I];d.clippingState=S,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=R}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,f,m,v){let M=u!==null?u.length:0,g=null;if(M!==0){if(g=l.value,v!==!0||g===null){let d=m+M*4,R=f.matrixWorldInverse;a.getNormalMatrix(R),(g===null||g.length<d)&&(g=new Float32Array(d));for(let E=0,S=m;E!==M;++E,S+=4)o.copy(u[E]).applyMatrix4(R,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=M,t.numIntersection=0,g}}function Gv(n){let t=new WeakMap;function e(o,a){return a===Ea?o.mapping=Hn:a===Ta&&(o.mapping=Vn),o}function i(o){if(o&&o.isTexture){let a=o.mapping;if(a===Ea||a===Ta)if(t.has(o)){let l=t.get(o).texture;return e(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new Qo(l.height);return c.fromEquirectangularTexture(n,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:i,dispose:r}}var Cs=4,Id=[.125,.215,.35,.446,.526,.582],Yn=20,Jc=new ma,Ld=new Ot,Qc=null,th=0,eh=0,ih=!1,qn=(1+Math.sqrt(5))/2,Rs=1/qn,Dd=[new F(-qn,Rs,0),new F(qn,Rs,0),new F(-Rs,0,qn),new F(Rs,0,qn),new F(0,qn,-Rs),new F(0,qn,Rs),new F(-1,1,-1),new F(1,1,-1),new F(-1,1,1),new F(1,1,1)],Wv=new F,dl=class{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=Wv}=r;Qc=this._renderer.getRenderTarget(),th=this._renderer.getActiveCubeFace(),eh=this._renderer.getActiveMipmapLevel(),ih=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(t,i,s,l,a),e>0&&this._blur(l,0,0,e),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Fd(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Nd(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(Qc,th,eh),this._renderer.xr.enabled=ih,t.scissorTest=!1,hl(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===Hn||t.mapping===Vn?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),Qc=this._renderer.getRenderTarget(),th=this._renderer.getActiveCubeFace(),eh=this._renderer.getActiveMipmapLevel(),ih=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let i=e||this._allocateTargets();return this._textureToCubeUV(t,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){let t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,i={magFilter:Si,minFilter:Si,generateMipmaps:!1,type:Ss,format:gi,colorSpace:On,depthBuffer:!1},s=Ud(t,e,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Ud(t,e,i);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=Xv(r)),this._blurMaterial=qv(r,t,e)}return s}_compileMaterial(t){let e=new Xe(this._lodPlanes[0],t);this._renderer.compile(e,Jc)}_sceneToCubeUV(t,e,i,s,r){let l=new Ge(90,1,e,i),c=[1,-1,1,1,1,1],h=[1,1,1,-1,-1,-1],u=this._renderer,f=u.autoClear,m=u.toneMapping;u.getClearColor(Ld),u.toneMapping=en,u.autoClear=!1,u.state.buffers.depth.getReversed()&&(u.setRenderTarget(s),u.clearDepth(),u.setRenderTarget(null));let M=new lr({name:"PMREM.Background",side:Je,depthWrite:!1,depthTest:!1}),g=new Xe(new xs,M),d=!1,R=t.background;R?R.isColor&&(M.color.copy(R),t.background=null,d=!0):(M.color.copy(Ld),d=!0);for(let E=0;E<6;E++){let S=E%3;S===0?(l.up.set(0,c[E],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+h[E],r.y,r.z)):S===1?(l.up.set(0,0,c[E]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+h[E],r.z)):(l.up.set(0,c[E],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+h[E]));let I=this._cubeSize;hl(s,S*I,E>2?I:0,I,I),u.setRenderTarget(s),d&&u.render(g,l),u.render(t,l)}g.geometry.dispose(),g.material.dispose(),u.toneMapping=m,u.autoClear=f,t.background=R}_textureToCubeUV(t,e){let i=this._renderer,s=t.mapping===Hn||t.mapping===Vn;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Fd()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Nd());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new Xe(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;let l=this._cubeSize;hl(e,0,0,3*l,2*l),i.setRenderTarget(e),i.render(o,Jc)}_applyPMREM(t){let e=this._renderer,i=e.autoClear;e.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=Dd[(s-r-1)%Dd.length];this._blur(t,r-1,r,o,a)}e.autoClear=i}_blur(t,e,i,s,r){let o=this._pingPongRenderTarget;this._halfBlur(t,o,e,i,s,"latitudinal",r),this._halfBlur(o,t,i,i,s,"longitudinal",r)}_halfBlur(t,e,i,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let h=3,u=new Xe(this._lodPlanes[s],c),f=c.uniforms,m=this._sizeLods[i]-1,v=isFinite(r)?Math.PI/(2*m):2*Math.PI/(2*Yn-1),M=r/v,g=isFinite(r)?1+Math.floor(h*M):Yn;g>Yn&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${g} samples when the maximum is set to ${Yn}`);let d=[],R=0;for(let D=0;D<Yn;++D){let k=D/M,x=Math.exp(-k*k/2);d.push(x),D===0?R+=x:D<g&&(R+=2*x)}for(let D=0;D<d.length;D++)d[D]=d[D]/R;f.envMap.value=t.texture,f.samples.value=g,f.weights.value=d,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:E}=this;f.dTheta.value=v,f.mipInt.value=E-i;let S=this._sizeLods[s],I=3*S*(s>E-Cs?s-E+Cs:0),P=4*(this._cubeSize-S);hl(e,I,P,3*S,2*S),l.setRenderTarget(e),l.render(u,Jc)}};function Xv(n){let t=[],e=[],i=[],s=n,r=n-Cs+1+Id.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>n-Cs?l=Id[o-n+Cs-1]:o===0&&(l=0),i.push(l);let c=1/(a-2),h=-c,u=1+c,f=[h,h,u,h,u,u,h,h,u,u,h,u],m=6,v=6,M=3,g=2,d=1,R=new Float32Array(M*v*m),E=new Float32Array(g*v*m),S=new Float32Array(d*v*m);for(let P=0;P<m;P++){let D=P%3*2/3-1,k=P>2?0:-1,x=[D,k,0,D+2/3,k,0,D+2/3,k+1,0,D,k,0,D+2/3,k+1,0,D,k+1,0];R.set(x,M*v*P),E.set(f,g*v*P);let b=[P,P,P,P,P,P];S.set(b,d*v*P)}let I=new we;I.setAttribute("position",new be(R,M)),I.setAttribute("uv",new be(E,g)),I.setAttribute("faceIndex",new be(S,d)),t.push(I),s>Cs&&s--}return{lodPlanes:t,sizeLods:e,sigmas:i}}function Ud(n,t,e){let i=new Di(n,t,e);return i.texture.mapping=Tr,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function hl(n,t,e,i,s){n.viewport.set(t,e,i,s),n.scissor.set(t,e,i,s)}function qv(n,t,e){let i=new Float32Array(Yn),s=new F(0,1,0);return new Ti({name:"SphericalGaussianBlur",defines:{n:Yn,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:dh(),fragmentShader:`

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
		`,blending:tn,depthTest:!1,depthWrite:!1})}function Nd(){return new Ti({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:dh(),fragmentShader:`

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
		`,blending:tn,depthTest:!1,depthWrite:!1})}function Fd(){return new Ti({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:dh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:tn,depthTest:!1,depthWrite:!1})}function dh(){return`

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
	`}function Yv(n){let t=new WeakMap,e=null;function i(a){if(a&&a.isTexture){let l=a.mapping,c=l===Ea||l===Ta,h=l===Hn||l===Vn;if(c||h){let u=t.get(a),f=u!==void 0?u.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new dl(n)),u=c?e.fromEquirectangular(a,u):e.fromCubemap(a,u),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),u.texture;if(u!==void 0)return u.texture;{let m=a.image;return c&&m&&m.height>0||h&&m&&s(m)?(e===null&&(e=new dl(n)),u=c?e.fromEquirectangular(a):e.fromCubemap(a),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),a.addEventListener("dispose",r),u.texture):null}}}return a}function s(a){let l=0,c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:i,dispose:o}}function $v(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&vs("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function Zv(n,t,e,i){let s={},r=new WeakMap;function o(u){let f=u.target;f.index!==null&&t.remove(f.index);for(let v in f.attributes)t.remove(f.attributes[v]);f.removeEventListener("dispose",o),delete s[f.id];let m=r.get(f);m&&(t.remove(m),r.delete(f)),i.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(u,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(u){let f=u.attributes;for(let m in f)t.update(f[m],n.ARRAY_BUFFER)}function c(u){let f=[],m=u.index,v=u.attributes.position,M=0;if(m!==null){let R=m.array;M=m.version;for(let E=0,S=R.length;E<S;E+=3){let I=R[E+0],P=R[E+1],D=R[E+2];f.push(I,P,P,D,D,I)}}else if(v!==void 0){let R=v.array;M=v.version;for(let E=0,S=R.length/3-1;E<S;E+=3){let I=E+0,P=E+1,D=E+2;f.push(I,P,P,D,D,I)}}else return;let g=new(Yc(f)?hr:cr)(f,1);g.version=M;let d=r.get(u);d&&t.remove(d),r.set(u,g)}function h(u){let f=r.get(u);if(f){let m=u.index;m!==null&&f.version<m.version&&c(u)}else c(u);return r.get(u)}return{get:a,update:l,getWireframeAttribute:h}}function Kv(n,t,e){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,m){n.drawElements(i,m,r,f*o),e.update(m,i,1)}function c(f,m,v){v!==0&&(n.drawElementsInstanced(i,m,r,f*o,v),e.update(m,i,v))}function h(f,m,v){if(v===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,m,0,r,f,0,v);let g=0;for(let d=0;d<v;d++)g+=m[d];e.update(g,i,1)}function u(f,m,v,M){if(v===0)return;let g=t.get("WEBGL_multi_draw");if(g===null)for(let d=0;d<f.length;d++)c(f[d]/o,m[d],M[d]);else{g.multiDrawElementsInstancedWEBGL(i,m,0,r,f,0,M,0,v);let d=0;for(let R=0;R<v;R++)d+=m[R]*M[R];e.update(d,i,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function jv(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function Jv(n,t,e){let i=new WeakMap,s=new Me;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=i.get(a);if(f===void 0||f.count!==u){let x=function(){D.dispose(),i.delete(a),a.removeEventListener("dispose",x)};f!==void 0&&f.texture.dispose();let m=a.morphAttributes.position!==void 0,v=a.morphAttributes.normal!==void 0,M=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],R=a.morphAttributes.color||[],E=0;m===!0&&(E=1),v===!0&&(E=2),M===!0&&(E=3);let S=a.attributes.position.count*E,I=1;S>t.maxTextureSize&&(I=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let P=new Float32Array(S*I*4*u),D=new or(P,S,I,u);D.type=Ri,D.needsUpdate=!0;let k=E*4;for(let b=0;b<u;b++){let C=g[b],B=d[b],V=R[b],X=S*I*4*b;for(let K=0;K<C.count;K++){let Y=K*k;m===!0&&(s.fromBufferAttribute(C,K),P[X+Y+0]=s.x,P[X+Y+1]=s.y,P[X+Y+2]=s.z,P[X+Y+3]=0),v===!0&&(s.fromBufferAttribute(B,K),P[X+Y+4]=s.x,P[X+Y+5]=s.y,P[X+Y+6]=s.z,P[X+Y+7]=0),M===!0&&(s.fromBufferAttribute(V,K),P[X+Y+8]=s.x,P[X+Y+9]=s.y,P[X+Y+10]=s.z,P[X+Y+11]=V.itemSize===4?s.w:1)}}f={count:u,texture:D,size:new zt(S,I)},i.set(a,f),a.addEventListener("dispose",x)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let m=0;for(let M=0;M<c.length;M++)m+=c[M];let v=a.morphTargetsRelative?1:1-m;l.getUniforms().setValue(n,"morphTargetBaseInfluence",v),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function Qv(n,t,e,i){let s=new WeakMap;function r(l){let c=i.render.frame,h=l.geometry,u=t.get(l,h);if(s.get(u)!==c&&(t.update(u),s.set(u,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return u}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}var ef=new je,Od=new vr(1,1),nf=new or,sf=new jo,rf=new dr,kd=[],Bd=[],zd=new Float32Array(16),Hd=new Float32Array(9),Vd=new Float32Array(4);function Is(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=kd[s];if(r===void 0&&(r=new Float32Array(s),kd[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Ae(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Re(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function pl(n,t){let e=Bd[t];e===void 0&&(e=new Int32Array(t),Bd[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function ty(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function ey(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ae(e,t))return;n.uniform2fv(this.addr,t),Re(e,t)}}function iy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Ae(e,t))return;n.uniform3fv(this.addr,t),Re(e,t)}}function ny(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ae(e,t))return;n.uniform4fv(this.addr,t),Re(e,t)}}function sy(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ae(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Re(e,t)}else{if(Ae(e,i))return;Vd.set(i),n.uniformMatrix2fv(this.addr,!1,Vd),Re(e,i)}}function ry(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ae(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Re(e,t)}else{if(Ae(e,i))return;Hd.set(i),n.uniformMatrix3fv(this.addr,!1,Hd),Re(e,i)}}function oy(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ae(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Re(e,t)}else{if(Ae(e,i))return;zd.set(i),n.uniformMatrix4fv(this.addr,!1,zd),Re(e,i)}}function ay(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function ly(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ae(e,t))return;n.uniform2iv(this.addr,t),Re(e,t)}}function cy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ae(e,t))return;n.uniform3iv(this.addr,t),Re(e,t)}}function hy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ae(e,t))return;n.uniform4iv(this.addr,t),Re(e,t)}}function uy(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function dy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ae(e,t))return;n.uniform2uiv(this.addr,t),Re(e,t)}}function fy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ae(e,t))return;n.uniform3uiv(this.addr,t),Re(e,t)}}function py(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ae(e,t))return;n.uniform4uiv(this.addr,t),Re(e,t)}}function my(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(Od.compareFunction=Gc,r=Od):r=ef,e.setTexture2D(t||r,s)}function gy(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||sf,s)}function _y(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTextureCube(t||rf,s)}function vy(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||nf,s)}function yy(n){switch(n){case 5126:return ty;case 35664:return ey;case 35665:return iy;case 35666:return ny;case 35674:return sy;case 35675:return ry;case 35676:return oy;case 5124:case 35670:return ay;case 35667:case 35671:return ly;case 35668:case 35672:return cy;case 35669:case 35673:return hy;case 5125:return uy;case 36294:return dy;case 36295:return fy;case 36296:return py;case 35678:case 36198:case 36298:case 36306:case 35682:return my;case 35679:case 36299:case 36307:return gy;case 35680:case 36300:case 36308:case 36293:return _y;case 36289:case 36303:case 36311:case 36292:return vy}}function xy(n,t){n.uniform1fv(this.addr,t)}function by(n,t){let e=Is(t,this.size,2);n.uniform2fv(this.addr,e)}function My(n,t){let e=Is(t,this.size,3);n.uniform3fv(this.addr,e)}function wy(n,t){let e=Is(t,this.size,4);n.uniform4fv(this.addr,e)}function Sy(n,t){let e=Is(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function Ey(n,t){let e=Is(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function Ty(n,t){let e=Is(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function Ay(n,t){n.uniform1iv(this.addr,t)}function Ry(n,t){n.uniform2iv(this.addr,t)}function Cy(n,t){n.uniform3iv(this.addr,t)}function Py(n,t){n.uniform4iv(this.addr,t)}function Iy(n,t){n.uniform1uiv(this.addr,t)}function Ly(n,t){n.uniform2uiv(this.addr,t)}function Dy(n,t){n.uniform3uiv(this.addr,t)}function Uy(n,t){n.uniform4uiv(this.addr,t)}function Ny(n,t,e){let i=this.cache,s=t.length,r=pl(e,s);Ae(i,r)||(n.uniform1iv(this.addr,r),Re(i,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||ef,r[o])}function Fy(n,t,e){let i=this.cache,s=t.length,r=pl(e,s);Ae(i,r)||(n.uniform1iv(this.addr,r),Re(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||sf,r[o])}function Oy(n,t,e){let i=this.cache,s=t.length,r=pl(e,s);Ae(i,r)||(n.uniform1iv(this.addr,r),Re(i,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||rf,r[o])}function ky(n,t,e){let i=this.cache,s=t.length,r=pl(e,s);Ae(i,r)||(n.uniform1iv(this.addr,r),Re(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||nf,r[o])}function By(n){switch(n){case 5126:return xy;case 35664:return by;case 35665:return My;case 35666:return wy;case 35674:return Sy;case 35675:return Ey;case 35676:return Ty;case 5124:case 35670:return Ay;case 35667:case 35671:return Ry;case 35668:case 35672:return Cy;case 35669:case 35673:return Py;case 5125:return Iy;case 36294:return Ly;case 36295:return Dy;case 36296:return Uy;case 35678:case 36198:case 36298:case 36306:case 35682:return Ny;case 35679:case 36299:case 36307:return Fy;case 35680:case 36300:case 36308:case 36293:return Oy;case 36289:case 36303:case 36311:case 36292:return ky}}var sh=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=yy(e.type)}},rh=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=By(e.type)}},oh=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},nh=/(\w+)(\])?(\[|\.)?/g;function Gd(n,t){n.seq.push(t),n.map[t.id]=t}function zy(n,t,e){let i=n.name,s=i.length;for(nh.lastIndex=0;;){let r=nh.exec(i),o=nh.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Gd(e,c===void 0?new sh(a,n,t):new rh(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new oh(a),Gd(e,u)),e=u}}}var Ps=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){let r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);zy(r,o,this)}}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Wd(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var Hy=37297,Vy=0;function Gy(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Xd=new Ht;function Wy(n){Jt._getMatrix(Xd,Jt.workingColorSpace,n);let t=`mat3( ${Xd.elements.map(e=>e.toFixed(4))} )`;switch(Jt.getTransfer(n)){case nr:return[t,"LinearTransferOETF"];case ne:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function qd(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Gy(n.getShaderSource(t),a)}else return r}function Xy(n,t){let e=Wy(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function qy(n,t){let e;switch(t){case ld:e="Linear";break;case cd:e="Reinhard";break;case hd:e="Cineon";break;case ud:e="ACESFilmic";break;case fd:e="AgX";break;case pd:e="Neutral";break;case dd:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ul=new F;function Yy(){Jt.getLuminanceCoefficients(ul);let n=ul.x.toFixed(4),t=ul.y.toFixed(4),e=ul.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function $y(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Lr).join(`
`)}function Zy(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function Ky(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Lr(n){return n!==""}function Yd(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function $d(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var jy=/^[ \t]*#include +<([\w\d./]+)>/gm;function ah(n){return n.replace(jy,Qy)}var Jy=new Map;function Qy(n,t){let e=Wt[t];if(e===void 0){let i=Jy.get(t);if(i!==void 0)e=Wt[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,i);else throw new Error("Can not resolve #include <"+t+">")}return ah(e)}var t0=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Zd(n){return n.replace(t0,e0)}function e0(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Kd(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}function i0(n){let t="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===Pc?t="SHADOWMAP_TYPE_PCF":n.shadowMapType===Hu?t="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===ki&&(t="SHADOWMAP_TYPE_VSM"),t}function n0(n){let t="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case Hn:case Vn:t="ENVMAP_TYPE_CUBE";break;case Tr:t="ENVMAP_TYPE_CUBE_UV";break}return t}function s0(n){let t="ENVMAP_MODE_REFLECTION";if(n.envMap)switch(n.envMapMode){case Vn:t="ENVMAP_MODE_REFRACTION";break}return t}function r0(n){let t="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case Sa:t="ENVMAP_BLENDING_MULTIPLY";break;case od:t="ENVMAP_BLENDING_MIX";break;case ad:t="ENVMAP_BLENDING_ADD";break}return t}function o0(n){let t=n.envMapCubeUVHeight;if(t===null)return null;let e=Math.log2(t)-2,i=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:i,maxMip:e}}function a0(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=i0(e),c=n0(e),h=s0(e),u=r0(e),f=o0(e),m=$y(e),v=Zy(r),M=s.createProgram(),g,d,R=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,v].filter(Lr).join(`
`),g.length>0&&(g+=`
`),d=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,v].filter(Lr).join(`
`),d.length>0&&(d+=`
`)):(g=[Kd(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,v,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Lr).join(`
`),d=[Kd(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,v,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==en?"#define TONE_MAPPING":"",e.toneMapping!==en?Wt.tonemapping_pars_fragment:"",e.toneMapping!==en?qy("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Wt.colorspace_pars_fragment,Xy("linearToOutputTexel",e.outputColorSpace),Yy(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Lr).join(`
`)),o=ah(o),o=Yd(o,e),o=$d(o,e),a=ah(a),a=Yd(a,e),a=$d(a,e),o=Zd(o),a=Zd(a),e.isRawShaderMaterial!==!0&&(R=`#version 300 es
`,g=[m,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+g,d=["#define varying in",e.glslVersion===Wc?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Wc?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let E=R+g+o,S=R+d+a,I=Wd(s,s.VERTEX_SHADER,E),P=Wd(s,s.FRAGMENT_SHADER,S);s.attachShader(M,I),s.attachShader(M,P),e.index0AttributeName!==void 0?s.bindAttribLocation(M,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(M,0,"position"),s.linkProgram(M);function D(C){if(n.debug.checkShaderErrors){let B=s.getProgramInfoLog(M)||"",V=s.getShaderInfoLog(I)||"",X=s.getShaderInfoLog(P)||"",K=B.trim(),Y=V.trim(),nt=X.trim(),G=!0,lt=!0;if(s.getProgramParameter(M,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,M,I,P);else{let dt=qd(s,I,"vertex"),At=qd(s,P,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(M,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+K+`
`+dt+`
`+At)}else K!==""?console.warn("THREE.WebGLProgram: Program Info Log:",K):(Y===""||nt==="")&&(lt=!1);lt&&(C.diagnostics={runnable:G,programLog:K,vertexShader:{log:Y,prefix:g},fragmentShader:{log:nt,prefix:d}})}s.deleteShader(I),s.deleteShader(P),k=new Ps(s,M),x=Ky(s,M)}let k;this.getUniforms=function(){return k===void 0&&D(this),k};let x;this.getAttributes=function(){return x===void 0&&D(this),x};let b=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return b===!1&&(b=s.getProgramParameter(M,Hy)),b},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(M),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Vy++,this.cacheKey=t,this.usedTimes=1,this.program=M,this.vertexShader=I,this.fragmentShader=P,this}var l0=0,lh=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){let e=t.vertexShader,i=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(i),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new ch(t),e.set(t,i)),i}},ch=class{constructor(t){this.id=l0++,this.code=t,this.usedTimes=0}};function c0(n,t,e,i,s,r,o){let a=new ar,l=new lh,c=new Set,h=[],u=s.logarithmicDepthBuffer,f=s.vertexTextures,m=s.precision,v={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function M(x){return c.add(x),x===0?"uv":`uv${x}`}function g(x,b,C,B,V){let X=B.fog,K=V.geometry,Y=x.isMeshStandardMaterial?B.environment:null,nt=(x.isMeshStandardMaterial?e:t).get(x.envMap||Y),G=nt&&nt.mapping===Tr?nt.image.height:null,lt=v[x.type];x.precision!==null&&(m=s.getMaxPrecision(x.precision),m!==x.precision&&console.warn("THREE.WebGLProgram.getParameters:",x.precision,"not supported, using",m,"instead."));let dt=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,At=dt!==void 0?dt.length:0,Yt=0;K.morphAttributes.position!==void 0&&(Yt=1),K.morphAttributes.normal!==void 0&&(Yt=2),K.morphAttributes.color!==void 0&&(Yt=3);let le,fe,te,$;if(lt){let ee=Hi[lt];le=ee.vertexShader,fe=ee.fragmentShader}else le=x.vertexShader,fe=x.fragmentShader,l.update(x),te=l.getVertexShaderID(x),$=l.getFragmentShaderID(x);let J=n.getRenderTarget(),mt=n.state.buffers.depth.getReversed(),Nt=V.isInstancedMesh===!0,Et=V.isBatchedMesh===!0,jt=!!x.map,Ne=!!x.matcap,A=!!nt,pe=!!x.aoMap,Bt=!!x.lightMap,Lt=!!x.bumpMap,vt=!!x.normalMap,me=!!x.displacementMap,yt=!!x.emissiveMap,Gt=!!x.metalnessMap,Pe=!!x.roughnessMap,Se=x.anisotropy>0,T=x.clearcoat>0,y=x.dispersion>0,O=x.iridescence>0,q=x.sheen>0,j=x.transmission>0,W=Se&&!!x.anisotropyMap,St=T&&!!x.clearcoatMap,st=T&&!!x.clearcoatNormalMap,xt=T&&!!x.clearcoatRoughnessMap,bt=O&&!!x.iridescenceMap,et=O&&!!x.iridescenceThicknessMap,ut=q&&!!x.sheenColorMap,It=q&&!!x.sheenRoughnessMap,Mt=!!x.specularMap,ct=!!x.specularColorMap,Vt=!!x.specularIntensityMap,L=j&&!!x.transmissionMap,it=j&&!!x.thicknessMap,ot=!!x.gradientMap,pt=!!x.alphaMap,Q=x.alphaTest>0,Z=!!x.alphaHash,_t=!!x.extensions,kt=en;x.toneMapped&&(J===null||J.isXRRenderTarget===!0)&&(kt=n.toneMapping);let ce={shaderID:lt,shaderType:x.type,shaderName:x.name,vertexShader:le,fragmentShader:fe,defines:x.defines,customVertexShaderID:te,customFragmentShaderID:$,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:m,batching:Et,batchingColor:Et&&V._colorsTexture!==null,instancing:Nt,instancingColor:Nt&&V.instanceColor!==null,instancingMorph:Nt&&V.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:J===null?n.outputColorSpace:J.isXRRenderTarget===!0?J.texture.colorSpace:On,alphaToCoverage:!!x.alphaToCoverage,map:jt,matcap:Ne,envMap:A,envMapMode:A&&nt.mapping,envMapCubeUVHeight:G,aoMap:pe,lightMap:Bt,bumpMap:Lt,normalMap:vt,displacementMap:f&&me,emissiveMap:yt,normalMapObjectSpace:vt&&x.normalMapType===vd,normalMapTangentSpace:vt&&x.normalMapType===Vc,metalnessMap:Gt,roughnessMap:Pe,anisotropy:Se,anisotropyMap:W,clearcoat:T,clearcoatMap:St,clearcoatNormalMap:st,clearcoatRoughnessMap:xt,dispersion:y,iridescence:O,iridescenceMap:bt,iridescenceThicknessMap:et,sheen:q,sheenColorMap:ut,sheenRoughnessMap:It,specularMap:Mt,specularColorMap:ct,specularIntensityMap:Vt,transmission:j,transmissionMap:L,thicknessMap:it,gradientMap:ot,opaque:x.transparent===!1&&x.blending===Nn&&x.alphaToCoverage===!1,alphaMap:pt,alphaTest:Q,alphaHash:Z,combine:x.combine,mapUv:jt&&M(x.map.channel),aoMapUv:pe&&M(x.aoMap.channel),lightMapUv:Bt&&M(x.lightMap.channel),bumpMapUv:Lt&&M(x.bumpMap.channel),normalMapUv:vt&&M(x.normalMap.channel),displacementMapUv:me&&M(x.displacementMap.channel),emissiveMapUv:yt&&M(x.emissiveMap.channel),metalnessMapUv:Gt&&M(x.metalnessMap.channel),roughnessMapUv:Pe&&M(x.roughnessMap.channel),anisotropyMapUv:W&&M(x.anisotropyMap.channel),clearcoatMapUv:St&&M(x.clearcoatMap.channel),clearcoatNormalMapUv:st&&M(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:xt&&M(x.clearcoatRoughnessMap.channel),iridescenceMapUv:bt&&M(x.iridescenceMap.channel),iridescenceThicknessMapUv:et&&M(x.iridescenceThicknessMap.channel),sheenColorMapUv:ut&&M(x.sheenColorMap.channel),sheenRoughnessMapUv:It&&M(x.sheenRoughnessMap.channel),specularMapUv:Mt&&M(x.specularMap.channel),specularColorMapUv:ct&&M(x.specularColorMap.channel),specularIntensityMapUv:Vt&&M(x.specularIntensityMap.channel),transmissionMapUv:L&&M(x.transmissionMap.channel),thicknessMapUv:it&&M(x.thicknessMap.channel),alphaMapUv:pt&&M(x.alphaMap.channel),vertexTangents:!!K.attributes.tangent&&(vt||Se),vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,pointsUvs:V.isPoints===!0&&!!K.attributes.uv&&(jt||pt),fog:!!X,useFog:x.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:x.flatShading===!0&&x.wireframe===!1,sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:mt,skinning:V.isSkinnedMesh===!0,morphTargets:K.morphAttributes.position!==void 0,morphNormals:K.morphAttributes.normal!==void 0,morphColors:K.morphAttributes.color!==void 0,morphTargetsCount:At,morphTextureStride:Yt,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:kt,decodeVideoTexture:jt&&x.map.isVideoTexture===!0&&Jt.getTransfer(x.map.colorSpace)===ne,decodeVideoTextureEmissive:yt&&x.emissiveMap.isVideoTexture===!0&&Jt.getTransfer(x.emissiveMap.colorSpace)===ne,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Bi,flipSided:x.side===Je,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:_t&&x.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(_t&&x.extensions.multiDraw===!0||Et)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return ce.vertexUv1s=c.has(1),ce.vertexUv2s=c.has(2),ce.vertexUv3s=c.has(3),c.clear(),ce}function d(x){let b=[];if(x.shaderID?b.push(x.shaderID):(b.push(x.customVertexShaderID),b.push(x.customFragmentShaderID)),x.defines!==void 0)for(let C in x.defines)b.push(C),b.push(x.defines[C]);return x.isRawShaderMaterial===!1&&(R(b,x),E(b,x),b.push(n.outputColorSpace)),b.push(x.customProgramCacheKey),b.join()}function R(x,b){x.push(b.precision),x.push(b.outputColorSpace),x.push(b.envMapMode),x.push(b.envMapCubeUVHeight),x.push(b.mapUv),x.push(b.alphaMapUv),x.push(b.lightMapUv),x.push(b.aoMapUv),x.push(b.bumpMapUv),x.push(b.normalMapUv),x.push(b.displacementMapUv),x.push(b.emissiveMapUv),x.push(b.metalnessMapUv),x.push(b.roughnessMapUv),x.push(b.anisotropyMapUv),x.push(b.clearcoatMapUv),x.push(b.clearcoatNormalMapUv),x.push(b.clearcoatRoughnessMapUv),x.push(b.iridescenceMapUv),x.push(b.iridescenceThicknessMapUv),x.push(b.sheenColorMapUv),x.push(b.sheenRoughnessMapUv),x.push(b.specularMapUv),x.push(b.specularColorMapUv),x.push(b.specularIntensityMapUv),x.push(b.transmissionMapUv),x.push(b.thicknessMapUv),x.push(b.combine),x.push(b.fogExp2),x.push(b.sizeAttenuation),x.push(b.morphTargetsCount),x.push(b.morphAttributeCount),x.push(b.numDirLights),x.push(b.numPointLights),x.push(b.numSpotLights),x.push(b.numSpotLightMaps),x.push(b.numHemiLights),x.push(b.numRectAreaLights),x.push(b.numDirLightShadows),x.push(b.numPointLightShadows),x.push(b.numSpotLightShadows),x.push(b.numSpotLightShadowsWithMaps),x.push(b.numLightProbes),x.push(b.shadowMapType),x.push(b.toneMapping),x.push(b.numClippingPlanes),x.push(b.numClipIntersection),x.push(b.depthPacking)}function E(x,b){a.disableAll(),b.supportsVertexTextures&&a.enable(0),b.instancing&&a.enable(1),b.instancingColor&&a.enable(2),b.instancingMorph&&a.enable(3),b.matcap&&a.enable(4),b.envMap&&a.enable(5),b.normalMapObjectSpace&&a.enable(6),b.normalMapTangentSpace&&a.enable(7),b.clearcoat&&a.enable(8),b.iridescence&&a.enable(9),b.alphaTest&&a.enable(10),b.vertexColors&&a.enable(11),b.vertexAlphas&&a.enable(12),b.vertexUv1s&&a.enable(13),b.vertexUv2s&&a.enable(14),b.vertexUv3s&&a.enable(15),b.vertexTangents&&a.enable(16),b.anisotropy&&a.enable(17),b.alphaHash&&a.enable(18),b.batching&&a.enable(19),b.dispersion&&a.enable(20),b.batchingColor&&a.enable(21),b.gradientMap&&a.enable(22),x.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reversedDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),x.push(a.mask)}function S(x){let b=v[x.type],C;if(b){let B=Hi[b];C=Cd.clone(B.uniforms)}else C=x.uniforms;return C}function I(x,b){let C;for(let B=0,V=h.length;B<V;B++){let X=h[B];if(X.cacheKey===b){C=X,++C.usedTimes;break}}return C===void 0&&(C=new a0(n,b,x,r),h.push(C)),C}function P(x){if(--x.usedTimes===0){let b=h.indexOf(x);h[b]=h[h.length-1],h.pop(),x.destroy()}}function D(x){l.remove(x)}function k(){l.dispose()}return{getParameters:g,getProgramCacheKey:d,getUniforms:S,acquireProgram:I,releaseProgram:P,releaseShaderCache:D,programs:h,dispose:k}}function h0(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function u0(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.z!==t.z?n.z-t.z:n.id-t.id}function jd(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Jd(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(u,f,m,v,M,g){let d=n[t];return d===void 0?(d={id:u.id,object:u,geometry:f,material:m,groupOrder:v,renderOrder:u.renderOrder,z:M,group:g},n[t]=d):(d.id=u.id,d.object=u,d.geometry=f,d.material=m,d.groupOrder=v,d.renderOrder=u.renderOrder,d.z=M,d.group=g),t++,d}function a(u,f,m,v,M,g){let d=o(u,f,m,v,M,g);m.transmission>0?i.push(d):m.transparent===!0?s.push(d):e.push(d)}function l(u,f,m,v,M,g){let d=o(u,f,m,v,M,g);m.transmission>0?i.unshift(d):m.transparent===!0?s.unshift(d):e.unshift(d)}function c(u,f){e.length>1&&e.sort(u||u0),i.length>1&&i.sort(f||jd),s.length>1&&s.sort(f||jd)}function h(){for(let u=t,f=n.length;u<f;u++){let m=n[u];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:a,unshift:l,finish:h,sort:c}}function d0(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Jd,n.set(i,[o])):s>=r.length?(o=new Jd,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function f0(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new F,color:new Ot};break;case"SpotLight":e={position:new F,direction:new F,color:new Ot,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new F,color:new Ot,distance:0,decay:0};break;case"HemisphereLight":e={direction:new F,skyColor:new Ot,groundColor:new Ot};break;case"RectAreaLight":e={color:new Ot,position:new F,halfWidth:new F,halfHeight:new F};break}return n[t.id]=e,e}}}function p0(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new zt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new zt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new zt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var m0=0;function g0(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function _0(n){let t=new f0,e=p0(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new F);let s=new F,r=new ae,o=new ae;function a(c){let h=0,u=0,f=0;for(let x=0;x<9;x++)i.probe[x].set(0,0,0);let m=0,v=0,M=0,g=0,d=0,R=0,E=0,S=0,I=0,P=0,D=0;c.sort(g0);for(let x=0,b=c.length;x<b;x++){let C=c[x],B=C.color,V=C.intensity,X=C.distance,K=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)h+=B.r*V,u+=B.g*V,f+=B.b*V;else if(C.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(C.sh.coefficients[Y],V);D++}else if(C.isDirectionalLight){let Y=t.get(C);if(Y.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let nt=C.shadow,G=e.get(C);G.shadowIntensity=nt.intensity,G.shadowBias=nt.bias,G.shadowNormalBias=nt.normalBias,G.shadowRadius=nt.radius,G.shadowMapSize=nt.mapSize,i.directionalShadow[m]=G,i.directionalShadowMap[m]=K,i.directionalShadowMatrix[m]=C.shadow.matrix,R++}i.directional[m]=Y,m++}else if(C.isSpotLight){let Y=t.get(C);Y.position.setFromMatrixPosition(C.matrixWorld),Y.color.copy(B).multiplyScalar(V),Y.distance=X,Y.coneCos=Math.cos(C.angle),Y.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),Y.decay=C.decay,i.spot[M]=Y;let nt=C.shadow;if(C.map&&(i.spotLightMap[I]=C.map,I++,nt.updateMatrices(C),C.castShadow&&P++),i.spotLightMatrix[M]=nt.matrix,C.castShadow){let G=e.get(C);G.shadowIntensity=nt.intensity,G.shadowBias=nt.bias,G.shadowNormalBias=nt.normalBias,G.shadowRadius=nt.radius,G.shadowMapSize=nt.mapSize,i.spotShadow[M]=G,i.spotShadowMap[M]=K,S++}M++}else if(C.isRectAreaLight){let Y=t.get(C);Y.color.copy(B).multiplyScalar(V),Y.halfWidth.set(C.width*.5,0,0),Y.halfHeight.set(0,C.height*.5,0),i.rectArea[g]=Y,g++}else if(C.isPointLight){let Y=t.get(C);if(Y.color.copy(C.color).multiplyScalar(C.intensity),Y.distance=C.distance,Y.decay=C.decay,C.castShadow){let nt=C.shadow,G=e.get(C);G.shadowIntensity=nt.intensity,G.shadowBias=nt.bias,G.shadowNormalBias=nt.normalBias,G.shadowRadius=nt.radius,G.shadowMapSize=nt.mapSize,G.shadowCameraNear=nt.camera.near,G.shadowCameraFar=nt.camera.far,i.pointShadow[v]=G,i.pointShadowMap[v]=K,i.pointShadowMatrix[v]=C.shadow.matrix,E++}i.point[v]=Y,v++}else if(C.isHemisphereLight){let Y=t.get(C);Y.skyColor.copy(C.color).multiplyScalar(V),Y.groundColor.copy(C.groundColor).multiplyScalar(V),i.hemi[d]=Y,d++}}g>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=at.LTC_FLOAT_1,i.rectAreaLTC2=at.LTC_FLOAT_2):(i.rectAreaLTC1=at.LTC_HALF_1,i.rectAreaLTC2=at.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=f;let k=i.hash;(k.directionalLength!==m||k.pointLength!==v||k.spotLength!==M||k.rectAreaLength!==g||k.hemiLength!==d||k.numDirectionalShadows!==R||k.numPointShadows!==E||k.numSpotShadows!==S||k.numSpotMaps!==I||k.numLightProbes!==D)&&(i.directional.length=m,i.spot.length=M,i.rectArea.length=g,i.point.length=v,i.hemi.length=d,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.pointShadow.length=E,i.pointShadowMap.length=E,i.spotShadow.length=S,i.spotShadowMap.length=S,i.directionalShadowMatrix.length=R,i.pointShadowMatrix.length=E,i.spotLightMatrix.length=S+I-P,i.spotLightMap.length=I,i.numSpotLightShadowsWithMaps=P,i.numLightProbes=D,k.directionalLength=m,k.pointLength=v,k.spotLength=M,k.rectAreaLength=g,k.hemiLength=d,k.numDirectionalShadows=R,k.numPointShadows=E,k.numSpotShadows=S,k.numSpotMaps=I,k.numLightProbes=D,i.version=m0++)}function l(c,h){let u=0,f=0,m=0,v=0,M=0,g=h.matrixWorldInverse;for(let d=0,R=c.length;d<R;d++){let E=c[d];if(E.isDirectionalLight){let S=i.directional[u];S.direction.setFromMatrixPosition(E.matrixWorld),s.setFromMatrixPosition(E.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(g),u++}else if(E.isSpotLight){let S=i.spot[m];S.position.setFromMatrixPosition(E.matrixWorld),S.position.applyMatrix4(g),S.direction.setFromMatrixPosition(E.matrixWorld),s.setFromMatrixPosition(E.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(g),m++}else if(E.isRectAreaLight){let S=i.rectArea[v];S.position.setFromMatrixPosition(E.matrixWorld),S.position.applyMatrix4(g),o.identity(),r.copy(E.matrixWorld),r.premultiply(g),o.extractRotation(r),S.halfWidth.set(E.width*.5,0,0),S.halfHeight.set(0,E.height*.5,0),S.halfWidth.applyMatrix4(o),S.halfHeight.applyMatrix4(o),v++}else if(E.isPointLight){let S=i.point[f];S.position.setFromMatrixPosition(E.matrixWorld),S.position.applyMatrix4(g),f++}else if(E.isHemisphereLight){let S=i.hemi[M];S.direction.setFromMatrixPosition(E.matrixWorld),S.direction.transformDirection(g),M++}}}return{setup:a,setupView:l,state:i}}function Qd(n){let t=new _0(n),e=[],i=[];function s(h){c.camera=h,e.length=0,i.length=0}function r(h){e.push(h)}function o(h){i.push(h)}function a(){t.setup(e)}function l(h){t.setupView(e,h)}let c={lightsArray:e,shadowsArray:i,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function v0(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Qd(n),t.set(s,[a])):r>=o.length?(a=new Qd(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var y0=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,x0=`uniform sampler2D shadow_pass;
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
}`;function b0(n,t,e){let i=new gr,s=new zt,r=new zt,o=new Me,a=new na({depthPacking:_d}),l=new sa,c={},h=e.maxTextureSize,u={[Ji]:Je,[Je]:Ji,[Bi]:Bi},f=new Ti({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new zt},radius:{value:4}},vertexShader:y0,fragmentShader:x0}),m=f.clone();m.defines.HORIZONTAL_PASS=1;let v=new we;v.setAttribute("position",new be(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new Xe(v,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Pc;let d=this.type;this.render=function(P,D,k){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||P.length===0)return;let x=n.getRenderTarget(),b=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),B=n.state;B.setBlending(tn),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let V=d!==ki&&this.type===ki,X=d===ki&&this.type!==ki;for(let K=0,Y=P.length;K<Y;K++){let nt=P[K],G=nt.shadow;if(G===void 0){console.warn("THREE.WebGLShadowMap:",nt,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let lt=G.getFrameExtents();if(s.multiply(lt),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/lt.x),s.x=r.x*lt.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/lt.y),s.y=r.y*lt.y,G.mapSize.y=r.y)),G.map===null||V===!0||X===!0){let At=this.type!==ki?{minFilter:ei,magFilter:ei}:{};G.map!==null&&G.map.dispose(),G.map=new Di(s.x,s.y,At),G.map.texture.name=nt.name+".shadowMap",G.camera.updateProjectionMatrix()}n.setRenderTarget(G.map),n.clear();let dt=G.getViewportCount();for(let At=0;At<dt;At++){let Yt=G.getViewport(At);o.set(r.x*Yt.x,r.y*Yt.y,r.x*Yt.z,r.y*Yt.w),B.viewport(o),G.updateMatrices(nt,At),i=G.getFrustum(),S(D,k,G.camera,nt,this.type)}G.isPointLightShadow!==!0&&this.type===ki&&R(G,k),G.needsUpdate=!1}d=this.type,g.needsUpdate=!1,n.setRenderTarget(x,b,C)};function R(P,D){let k=t.update(M);f.defines.VSM_SAMPLES!==P.blurSamples&&(f.defines.VSM_SAMPLES=P.blurSamples,m.defines.VSM_SAMPLES=P.blurSamples,f.needsUpdate=!0,m.needsUpdate=!0),P.mapPass===null&&(P.mapPass=new Di(s.x,s.y)),f.uniforms.shadow_pass.value=P.map.texture,f.uniforms.resolution.value=P.mapSize,f.uniforms.radius.value=P.radius,n.setRenderTarget(P.mapPass),n.clear(),n.renderBufferDirect(D,null,k,f,M,null),m.uniforms.shadow_pass.value=P.mapPass.texture,m.uniforms.resolution.value=P.mapSize,m.uniforms.radius.value=P.radius,n.setRenderTarget(P.map),n.clear(),n.renderBufferDirect(D,null,k,m,M,null)}function E(P,D,k,x){let b=null,C=k.isPointLight===!0?P.customDistanceMaterial:P.customDepthMaterial;if(C!==void 0)b=C;else if(b=k.isPointLight===!0?l:a,n.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0||D.alphaToCoverage===!0){let B=b.uuid,V=D.uuid,X=c[B];X===void 0&&(X={},c[B]=X);let K=X[V];K===void 0&&(K=b.clone(),X[V]=K,D.addEventListener("dispose",I)),b=K}if(b.visible=D.visible,b.wireframe=D.wireframe,x===ki?b.side=D.shadowSide!==null?D.shadowSide:D.side:b.side=D.shadowSide!==null?D.shadowSide:u[D.side],b.alphaMap=D.alphaMap,b.alphaTest=D.alphaToCoverage===!0?.5:D.alphaTest,b.map=D.map,b.clipShadows=D.clipShadows,b.clippingPlanes=D.clippingPlanes,b.clipIntersection=D.clipIntersection,b.displacementMap=D.displacementMap,b.displacementScale=D.displacementScale,b.displacementBias=D.displacementBias,b.wireframeLinewidth=D.wireframeLinewidth,b.linewidth=D.linewidth,k.isPointLight===!0&&b.isMeshDistanceMaterial===!0){let B=n.properties.get(b);B.light=k}return b}function S(P,D,k,x,b){if(P.visible===!1)return;if(P.layers.test(D.layers)&&(P.isMesh||P.isLine||P.isPoints)&&(P.castShadow||P.receiveShadow&&b===ki)&&(!P.frustumCulled||i.intersectsObject(P))){P.modelViewMatrix.multiplyMatrices(k.matrixWorldInverse,P.matrixWorld);let V=t.update(P),X=P.material;if(Array.isArray(X)){let K=V.groups;for(let Y=0,nt=K.length;Y<nt;Y++){let G=K[Y],lt=X[G.materialIndex];if(lt&&lt.visible){let dt=E(P,lt,x,b);P.onBeforeShadow(n,P,D,k,V,dt,G),n.renderBufferDirect(k,null,V,dt,P,G),P.onAfterShadow(n,P,D,k,V,dt,G)}}}else if(X.visible){let K=E(P,X,x,b);P.onBeforeShadow(n,P,D,k,V,K,null),n.renderBufferDirect(k,null,V,K,P,null),P.onAfterShadow(n,P,D,k,V,K,null)}}let B=P.children;for(let V=0,X=B.length;V<X;V++)S(B[V],D,k,x,b)}function I(P){P.target.removeEventListener("dispose",I);for(let k in c){let x=c[k],b=P.target.uuid;b in x&&(x[b].dispose(),delete x[b])}}}var M0={[_a]:va,[ya]:Ma,[xa]:wa,[Fn]:ba,[va]:_a,[Ma]:ya,[wa]:xa,[ba]:Fn};function w0(n,t){function e(){let L=!1,it=new Me,ot=null,pt=new Me(0,0,0,0);return{setMask:function(Q){ot!==Q&&!L&&(n.colorMask(Q,Q,Q,Q),ot=Q)},setLocked:function(Q){L=Q},setClear:function(Q,Z,_t,kt,ce){ce===!0&&(Q*=kt,Z*=kt,_t*=kt),it.set(Q,Z,_t,kt),pt.equals(it)===!1&&(n.clearColor(Q,Z,_t,kt),pt.copy(it))},reset:function(){L=!1,ot=null,pt.set(-1,0,0,0)}}}function i(){let L=!1,it=!1,ot=null,pt=null,Q=null;return{setReversed:function(Z){if(it!==Z){let _t=t.get("EXT_clip_control");Z?_t.clipControlEXT(_t.LOWER_LEFT_EXT,_t.ZERO_TO_ONE_EXT):_t.clipControlEXT(_t.LOWER_LEFT_EXT,_t.NEGATIVE_ONE_TO_ONE_EXT),it=Z;let kt=Q;Q=null,this.setClear(kt)}},getReversed:function(){return it},setTest:function(Z){Z?J(n.DEPTH_TEST):mt(n.DEPTH_TEST)},setMask:function(Z){ot!==Z&&!L&&(n.depthMask(Z),ot=Z)},setFunc:function(Z){if(it&&(Z=M0[Z]),pt!==Z){switch(Z){case _a:n.depthFunc(n.NEVER);break;case va:n.depthFunc(n.ALWAYS);break;case ya:n.depthFunc(n.LESS);break;case Fn:n.depthFunc(n.LEQUAL);break;case xa:n.depthFunc(n.EQUAL);break;case ba:n.depthFunc(n.GEQUAL);break;case Ma:n.depthFunc(n.GREATER);break;case wa:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}pt=Z}},setLocked:function(Z){L=Z},setClear:function(Z){Q!==Z&&(it&&(Z=1-Z),n.clearDepth(Z),Q=Z)},reset:function(){L=!1,ot=null,pt=null,Q=null,it=!1}}}function s(){let L=!1,it=null,ot=null,pt=null,Q=null,Z=null,_t=null,kt=null,ce=null;return{setTest:function(ee){L||(ee?J(n.STENCIL_TEST):mt(n.STENCIL_TEST))},setMask:function(ee){it!==ee&&!L&&(n.stencilMask(ee),it=ee)},setFunc:function(ee,Gi,Ci){(ot!==ee||pt!==Gi||Q!==Ci)&&(n.stencilFunc(ee,Gi,Ci),ot=ee,pt=Gi,Q=Ci)},setOp:function(ee,Gi,Ci){(Z!==ee||_t!==Gi||kt!==Ci)&&(n.stencilOp(ee,Gi,Ci),Z=ee,_t=Gi,kt=Ci)},setLocked:function(ee){L=ee},setClear:function(ee){ce!==ee&&(n.clearStencil(ee),ce=ee)},reset:function(){L=!1,it=null,ot=null,pt=null,Q=null,Z=null,_t=null,kt=null,ce=null}}}let r=new e,o=new i,a=new s,l=new WeakMap,c=new WeakMap,h={},u={},f=new WeakMap,m=[],v=null,M=!1,g=null,d=null,R=null,E=null,S=null,I=null,P=null,D=new Ot(0,0,0),k=0,x=!1,b=null,C=null,B=null,V=null,X=null,K=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),Y=!1,nt=0,G=n.getParameter(n.VERSION);G.indexOf("WebGL")!==-1?(nt=parseFloat(/^WebGL (\d)/.exec(G)[1]),Y=nt>=1):G.indexOf("OpenGL ES")!==-1&&(nt=parseFloat(/^OpenGL ES (\d)/.exec(G)[1]),Y=nt>=2);let lt=null,dt={},At=n.getParameter(n.SCISSOR_BOX),Yt=n.getParameter(n.VIEWPORT),le=new Me().fromArray(At),fe=new Me().fromArray(Yt);function te(L,it,ot,pt){let Q=new Uint8Array(4),Z=n.createTexture();n.bindTexture(L,Z),n.texParameteri(L,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(L,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let _t=0;_t<ot;_t++)L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY?n.texImage3D(it,0,n.RGBA,1,1,pt,0,n.RGBA,n.UNSIGNED_BYTE,Q):n.texImage2D(it+_t,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Q);return Z}let $={};$[n.TEXTURE_2D]=te(n.TEXTURE_2D,n.TEXTURE_2D,1),$[n.TEXTURE_CUBE_MAP]=te(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),$[n.TEXTURE_2D_ARRAY]=te(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),$[n.TEXTURE_3D]=te(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),J(n.DEPTH_TEST),o.setFunc(Fn),Lt(!1),vt(Cc),J(n.CULL_FACE),pe(tn);function J(L){h[L]!==!0&&(n.enable(L),h[L]=!0)}function mt(L){h[L]!==!1&&(n.disable(L),h[L]=!1)}function Nt(L,it){return u[L]!==it?(n.bindFramebuffer(L,it),u[L]=it,L===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=it),L===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=it),!0):!1}function Et(L,it){let ot=m,pt=!1;if(L){ot=f.get(it),ot===void 0&&(ot=[],f.set(it,ot));let Q=L.textures;if(ot.length!==Q.length||ot[0]!==n.COLOR_ATTACHMENT0){for(let Z=0,_t=Q.length;Z<_t;Z++)ot[Z]=n.COLOR_ATTACHMENT0+Z;ot.length=Q.length,pt=!0}}else ot[0]!==n.BACK&&(ot[0]=n.BACK,pt=!0);pt&&n.drawBuffers(ot)}function jt(L){return v!==L?(n.useProgram(L),v=L,!0):!1}let Ne={[pn]:n.FUNC_ADD,[Gu]:n.FUNC_SUBTRACT,[Wu]:n.FUNC_REVERSE_SUBTRACT};Ne[Xu]=n.MIN,Ne[qu]=n.MAX;let A={[Yu]:n.ZERO,[$u]:n.ONE,[Zu]:n.SRC_COLOR,[Wo]:n.SRC_ALPHA,[ed]:n.SRC_ALPHA_SATURATE,[Qu]:n.DST_COLOR,[ju]:n.DST_ALPHA,[Ku]:n.ONE_MINUS_SRC_COLOR,[Xo]:n.ONE_MINUS_SRC_ALPHA,[td]:n.ONE_MINUS_DST_COLOR,[Ju]:n.ONE_MINUS_DST_ALPHA,[id]:n.CONSTANT_COLOR,[nd]:n.ONE_MINUS_CONSTANT_COLOR,[sd]:n.CONSTANT_ALPHA,[rd]:n.ONE_MINUS_CONSTANT_ALPHA};function pe(L,it,ot,pt,Q,Z,_t,kt,ce,ee){if(L===tn){M===!0&&(mt(n.BLEND),M=!1);return}if(M===!1&&(J(n.BLEND),M=!0),L!==Vu){if(L!==g||ee!==x){if((d!==pn||S!==pn)&&(n.blendEquation(n.FUNC_ADD),d=pn,S=pn),ee)switch(L){case Nn:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ic:n.blendFunc(n.ONE,n.ONE);break;case Lc:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Dc:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",L);break}else switch(L){case Nn:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ic:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Lc:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Dc:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",L);break}R=null,E=null,I=null,P=null,D.set(0,0,0),k=0,g=L,x=ee}return}Q=Q||it,Z=Z||ot,_t=_t||pt,(it!==d||Q!==S)&&(n.blendEquationSeparate(Ne[it],Ne[Q]),d=it,S=Q),(ot!==R||pt!==E||Z!==I||_t!==P)&&(n.blendFuncSeparate(A[ot],A[pt],A[Z],A[_t]),R=ot,E=pt,I=Z,P=_t),(kt.equals(D)===!1||ce!==k)&&(n.blendColor(kt.r,kt.g,kt.b,ce),D.copy(kt),k=ce),g=L,x=!1}function Bt(L,it){L.side===Bi?mt(n.CULL_FACE):J(n.CULL_FACE);let ot=L.side===Je;it&&(ot=!ot),Lt(ot),L.blending===Nn&&L.transparent===!1?pe(tn):pe(L.blending,L.blendEquation,L.blendSrc,L.blendDst,L.blendEquationAlpha,L.blendSrcAlpha,L.blendDstAlpha,L.blendColor,L.blendAlpha,L.premultipliedAlpha),o.setFunc(L.depthFunc),o.setTest(L.depthTest),o.setMask(L.depthWrite),r.setMask(L.colorWrite);let pt=L.stencilWrite;a.setTest(pt),pt&&(a.setMask(L.stencilWriteMask),a.setFunc(L.stencilFunc,L.stencilRef,L.stencilFuncMask),a.setOp(L.stencilFail,L.stencilZFail,L.stencilZPass)),yt(L.polygonOffset,L.polygonOffsetFactor,L.polygonOffsetUnits),L.alphaToCoverage===!0?J(n.SAMPLE_ALPHA_TO_COVERAGE):mt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Lt(L){b!==L&&(L?n.frontFace(n.CW):n.frontFace(n.CCW),b=L)}function vt(L){L!==Bu?(J(n.CULL_FACE),L!==C&&(L===Cc?n.cullFace(n.BACK):L===zu?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):mt(n.CULL_FACE),C=L}function me(L){L!==B&&(Y&&n.lineWidth(L),B=L)}function yt(L,it,ot){L?(J(n.POLYGON_OFFSET_FILL),(V!==it||X!==ot)&&(n.polygonOffset(it,ot),V=it,X=ot)):mt(n.POLYGON_OFFSET_FILL)}function Gt(L){L?J(n.SCISSOR_TEST):mt(n.SCISSOR_TEST)}function Pe(L){L===void 0&&(L=n.TEXTURE0+K-1),lt!==L&&(n.activeTexture(L),lt=L)}function Se(L,it,ot){ot===void 0&&(lt===null?ot=n.TEXTURE0+K-1:ot=lt);let pt=dt[ot];pt===void 0&&(pt={type:void 0,texture:void 0},dt[ot]=pt),(pt.type!==L||pt.texture!==it)&&(lt!==ot&&(n.activeTexture(ot),lt=ot),n.bindTexture(L,it||$[L]),pt.type=L,pt.texture=it)}function T(){let L=dt[lt];L!==void 0&&L.type!==void 0&&(n.bindTexture(L.type,null),L.type=void 0,L.texture=void 0)}function y(){try{n.compressedTexImage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function O(){try{n.compressedTexImage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function q(){try{n.texSubImage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function j(){try{n.texSubImage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function W(){try{n.compressedTexSubImage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function St(){try{n.compressedTexSubImage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function st(){try{n.texStorage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function xt(){try{n.texStorage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function bt(){try{n.texImage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function et(){try{n.texImage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function ut(L){le.equals(L)===!1&&(n.scissor(L.x,L.y,L.z,L.w),le.copy(L))}function It(L){fe.equals(L)===!1&&(n.viewport(L.x,L.y,L.z,L.w),fe.copy(L))}function Mt(L,it){let ot=c.get(it);ot===void 0&&(ot=new WeakMap,c.set(it,ot));let pt=ot.get(L);pt===void 0&&(pt=n.getUniformBlockIndex(it,L.name),ot.set(L,pt))}function ct(L,it){let pt=c.get(it).get(L);l.get(it)!==pt&&(n.uniformBlockBinding(it,pt,L.__bindingPointIndex),l.set(it,pt))}function Vt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),h={},lt=null,dt={},u={},f=new WeakMap,m=[],v=null,M=!1,g=null,d=null,R=null,E=null,S=null,I=null,P=null,D=new Ot(0,0,0),k=0,x=!1,b=null,C=null,B=null,V=null,X=null,le.set(0,0,n.canvas.width,n.canvas.height),fe.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:J,disable:mt,bindFramebuffer:Nt,drawBuffers:Et,useProgram:jt,setBlending:pe,setMaterial:Bt,setFlipSided:Lt,setCullFace:vt,setLineWidth:me,setPolygonOffset:yt,setScissorTest:Gt,activeTexture:Pe,bindTexture:Se,unbindTexture:T,compressedTexImage2D:y,compressedTexImage3D:O,texImage2D:bt,texImage3D:et,updateUBOMapping:Mt,uniformBlockBinding:ct,texStorage2D:st,texStorage3D:xt,texSubImage2D:q,texSubImage3D:j,compressedTexSubImage2D:W,compressedTexSubImage3D:St,scissor:ut,viewport:It,reset:Vt}}function S0(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new zt,h=new WeakMap,u,f=new WeakMap,m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function v(T,y){return m?new OffscreenCanvas(T,y):rr("canvas")}function M(T,y,O){let q=1,j=Se(T);if((j.width>O||j.height>O)&&(q=O/Math.max(j.width,j.height)),q<1)if(typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&T instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&T instanceof ImageBitmap||typeof VideoFrame<"u"&&T instanceof VideoFrame){let W=Math.floor(q*j.width),St=Math.floor(q*j.height);u===void 0&&(u=v(W,St));let st=y?v(W,St):u;return st.width=W,st.height=St,st.getContext("2d").drawImage(T,0,0,W,St),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+W+"x"+St+")."),st}else return"data"in T&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),T;return T}function g(T){return T.generateMipmaps}function d(T){n.generateMipmap(T)}function R(T){return T.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:T.isWebGL3DRenderTarget?n.TEXTURE_3D:T.isWebGLArrayRenderTarget||T.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(T,y,O,q,j=!1){if(T!==null){if(n[T]!==void 0)return n[T];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+T+"'")}let W=y;if(y===n.RED&&(O===n.FLOAT&&(W=n.R32F),O===n.HALF_FLOAT&&(W=n.R16F),O===n.UNSIGNED_BYTE&&(W=n.R8)),y===n.RED_INTEGER&&(O===n.UNSIGNED_BYTE&&(W=n.R8UI),O===n.UNSIGNED_SHORT&&(W=n.R16UI),O===n.UNSIGNED_INT&&(W=n.R32UI),O===n.BYTE&&(W=n.R8I),O===n.SHORT&&(W=n.R16I),O===n.INT&&(W=n.R32I)),y===n.RG&&(O===n.FLOAT&&(W=n.RG32F),O===n.HALF_FLOAT&&(W=n.RG16F),O===n.UNSIGNED_BYTE&&(W=n.RG8)),y===n.RG_INTEGER&&(O===n.UNSIGNED_BYTE&&(W=n.RG8UI),O===n.UNSIGNED_SHORT&&(W=n.RG16UI),O===n.UNSIGNED_INT&&(W=n.RG32UI),O===n.BYTE&&(W=n.RG8I),O===n.SHORT&&(W=n.RG16I),O===n.INT&&(W=n.RG32I)),y===n.RGB_INTEGER&&(O===n.UNSIGNED_BYTE&&(W=n.RGB8UI),O===n.UNSIGNED_SHORT&&(W=n.RGB16UI),O===n.UNSIGNED_INT&&(W=n.RGB32UI),O===n.BYTE&&(W=n.RGB8I),O===n.SHORT&&(W=n.RGB16I),O===n.INT&&(W=n.RGB32I)),y===n.RGBA_INTEGER&&(O===n.UNSIGNED_BYTE&&(W=n.RGBA8UI),O===n.UNSIGNED_SHORT&&(W=n.RGBA16UI),O===n.UNSIGNED_INT&&(W=n.RGBA32UI),O===n.BYTE&&(W=n.RGBA8I),O===n.SHORT&&(W=n.RGBA16I),O===n.INT&&(W=n.RGBA32I)),y===n.RGB&&(O===n.UNSIGNED_INT_5_9_9_9_REV&&(W=n.RGB9_E5),O===n.UNSIGNED_INT_10F_11F_11F_REV&&(W=n.R11F_G11F_B10F)),y===n.RGBA){let St=j?nr:Jt.getTransfer(q);O===n.FLOAT&&(W=n.RGBA32F),O===n.HALF_FLOAT&&(W=n.RGBA16F),O===n.UNSIGNED_BYTE&&(W=St===ne?n.SRGB8_ALPHA8:n.RGBA8),O===n.UNSIGNED_SHORT_4_4_4_4&&(W=n.RGBA4),O===n.UNSIGNED_SHORT_5_5_5_1&&(W=n.RGB5_A1)}return(W===n.R16F||W===n.R32F||W===n.RG16F||W===n.RG32F||W===n.RGBA16F||W===n.RGBA32F)&&t.get("EXT_color_buffer_float"),W}function S(T,y){let O;return T?y===null||y===bn||y===Es?O=n.DEPTH24_STENCIL8:y===Ri?O=n.DEPTH32F_STENCIL8:y===ws&&(O=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===bn||y===Es?O=n.DEPTH_COMPONENT24:y===Ri?O=n.DEPTH_COMPONENT32F:y===ws&&(O=n.DEPTH_COMPONENT16),O}function I(T,y){return g(T)===!0||T.isFramebufferTexture&&T.minFilter!==ei&&T.minFilter!==Si?Math.log2(Math.max(y.width,y.height))+1:T.mipmaps!==void 0&&T.mipmaps.length>0?T.mipmaps.length:T.isCompressedTexture&&Array.isArray(T.image)?y.mipmaps.length:1}function P(T){let y=T.target;y.removeEventListener("dispose",P),k(y),y.isVideoTexture&&h.delete(y)}function D(T){let y=T.target;y.removeEventListener("dispose",D),b(y)}function k(T){let y=i.get(T);if(y.__webglInit===void 0)return;let O=T.source,q=f.get(O);if(q){let j=q[y.__cacheKey];j.usedTimes--,j.usedTimes===0&&x(T),Object.keys(q).length===0&&f.delete(O)}i.remove(T)}function x(T){let y=i.get(T);n.deleteTexture(y.__webglTexture);let O=T.source,q=f.get(O);delete q[y.__cacheKey],o.memory.textures--}function b(T){let y=i.get(T);if(T.depthTexture&&(T.depthTexture.dispose(),i.remove(T.depthTexture)),T.isWebGLCubeRenderTarget)for(let q=0;q<6;q++){if(Array.isArray(y.__webglFramebuffer[q]))for(let j=0;j<y.__webglFramebuffer[q].length;j++)n.deleteFramebuffer(y.__webglFramebuffer[q][j]);else n.deleteFramebuffer(y.__webglFramebuffer[q]);y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer[q])}else{if(Array.isArray(y.__webglFramebuffer))for(let q=0;q<y.__webglFramebuffer.length;q++)n.deleteFramebuffer(y.__webglFramebuffer[q]);else n.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&n.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let q=0;q<y.__webglColorRenderbuffer.length;q++)y.__webglColorRenderbuffer[q]&&n.deleteRenderbuffer(y.__webglColorRenderbuffer[q]);y.__webglDepthRenderbuffer&&n.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let O=T.textures;for(let q=0,j=O.length;q<j;q++){let W=i.get(O[q]);W.__webglTexture&&(n.deleteTexture(W.__webglTexture),o.memory.textures--),i.remove(O[q])}i.remove(T)}let C=0;function B(){C=0}function V(){let T=C;return T>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+T+" texture units while this GPU supports only "+s.maxTextures),C+=1,T}function X(T){let y=[];return y.push(T.wrapS),y.push(T.wrapT),y.push(T.wrapR||0),y.push(T.magFilter),y.push(T.minFilter),y.push(T.anisotropy),y.push(T.internalFormat),y.push(T.format),y.push(T.type),y.push(T.generateMipmaps),y.push(T.premultiplyAlpha),y.push(T.flipY),y.push(T.unpackAlignment),y.push(T.colorSpace),y.join()}function K(T,y){let O=i.get(T);if(T.isVideoTexture&&Gt(T),T.isRenderTargetTexture===!1&&T.isExternalTexture!==!0&&T.version>0&&O.__version!==T.version){let q=T.image;if(q===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(q.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{$(O,T,y);return}}else T.isExternalTexture&&(O.__webglTexture=T.sourceTexture?T.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,O.__webglTexture,n.TEXTURE0+y)}function Y(T,y){let O=i.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&O.__version!==T.version){$(O,T,y);return}e.bindTexture(n.TEXTURE_2D_ARRAY,O.__webglTexture,n.TEXTURE0+y)}function nt(T,y){let O=i.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&O.__version!==T.version){$(O,T,y);return}e.bindTexture(n.TEXTURE_3D,O.__webglTexture,n.TEXTURE0+y)}function G(T,y){let O=i.get(T);if(T.version>0&&O.__version!==T.version){J(O,T,y);return}e.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+y)}let lt={[qo]:n.REPEAT,[fn]:n.CLAMP_TO_EDGE,[Yo]:n.MIRRORED_REPEAT},dt={[ei]:n.NEAREST,[md]:n.NEAREST_MIPMAP_NEAREST,[Ar]:n.NEAREST_MIPMAP_LINEAR,[Si]:n.LINEAR,[Aa]:n.LINEAR_MIPMAP_NEAREST,[xn]:n.LINEAR_MIPMAP_LINEAR},At={[yd]:n.NEVER,[Ed]:n.ALWAYS,[xd]:n.LESS,[Gc]:n.LEQUAL,[bd]:n.EQUAL,[Sd]:n.GEQUAL,[Md]:n.GREATER,[wd]:n.NOTEQUAL};function Yt(T,y){if(y.type===Ri&&t.has("OES_texture_float_linear")===!1&&(y.magFilter===Si||y.magFilter===Aa||y.magFilter===Ar||y.magFilter===xn||y.minFilter===Si||y.minFilter===Aa||y.minFilter===Ar||y.minFilter===xn)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(T,n.TEXTURE_WRAP_S,lt[y.wrapS]),n.texParameteri(T,n.TEXTURE_WRAP_T,lt[y.wrapT]),(T===n.TEXTURE_3D||T===n.TEXTURE_2D_ARRAY)&&n.texParameteri(T,n.TEXTURE_WRAP_R,lt[y.wrapR]),n.texParameteri(T,n.TEXTURE_MAG_FILTER,dt[y.magFilter]),n.texParameteri(T,n.TEXTURE_MIN_FILTER,dt[y.minFilter]),y.compareFunction&&(n.texParameteri(T,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(T,n.TEXTURE_COMPARE_FUNC,At[y.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===ei||y.minFilter!==Ar&&y.minFilter!==xn||y.type===Ri&&t.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||i.get(y).__currentAnisotropy){let O=t.get("EXT_texture_filter_anisotropic");n.texParameterf(T,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),i.get(y).__currentAnisotropy=y.anisotropy}}}function le(T,y){let O=!1;T.__webglInit===void 0&&(T.__webglInit=!0,y.addEventListener("dispose",P));let q=y.source,j=f.get(q);j===void 0&&(j={},f.set(q,j));let W=X(y);if(W!==T.__cacheKey){j[W]===void 0&&(j[W]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,O=!0),j[W].usedTimes++;let St=j[T.__cacheKey];St!==void 0&&(j[T.__cacheKey].usedTimes--,St.usedTimes===0&&x(y)),T.__cacheKey=W,T.__webglTexture=j[W].texture}return O}function fe(T,y,O){return Math.floor(Math.floor(T/O)/y)}function te(T,y,O,q){let W=T.updateRanges;if(W.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,y.width,y.height,O,q,y.data);else{W.sort((et,ut)=>et.start-ut.start);let St=0;for(let et=1;et<W.length;et++){let ut=W[St],It=W[et],Mt=ut.start+ut.count,ct=fe(It.start,y.width,4),Vt=fe(ut.start,y.width,4);It.start<=Mt+1&&ct===Vt&&fe(It.start+It.count-1,y.width,4)===ct?ut.count=Math.max(ut.count,It.start+It.count-ut.start):(++St,W[St]=It)}W.length=St+1;let st=n.getParameter(n.UNPACK_ROW_LENGTH),xt=n.getParameter(n.UNPACK_SKIP_PIXELS),bt=n.getParameter(n.UNPACK_SKIP_ROWS);n.pixelStorei(n.UNPACK_ROW_LENGTH,y.width);for(let et=0,ut=W.length;et<ut;et++){let It=W[et],Mt=Math.floor(It.start/4),ct=Math.ceil(It.count/4),Vt=Mt%y.width,L=Math.floor(Mt/y.width),it=ct,ot=1;n.pixelStorei(n.UNPACK_SKIP_PIXELS,Vt),n.pixelStorei(n.UNPACK_SKIP_ROWS,L),e.texSubImage2D(n.TEXTURE_2D,0,Vt,L,it,ot,O,q,y.data)}T.clearUpdateRanges(),n.pixelStorei(n.UNPACK_ROW_LENGTH,st),n.pixelStorei(n.UNPACK_SKIP_PIXELS,xt),n.pixelStorei(n.UNPACK_SKIP_ROWS,bt)}}function $(T,y,O){let q=n.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(q=n.TEXTURE_2D_ARRAY),y.isData3DTexture&&(q=n.TEXTURE_3D);let j=le(T,y),W=y.source;e.bindTexture(q,T.__webglTexture,n.TEXTURE0+O);let St=i.get(W);if(W.version!==St.__version||j===!0){e.activeTexture(n.TEXTURE0+O);let st=Jt.getPrimaries(Jt.workingColorSpace),xt=y.colorSpace===nn?null:Jt.getPrimaries(y.colorSpace),bt=y.colorSpace===nn||st===xt?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,bt);let et=M(y.image,!1,s.maxTextureSize);et=Pe(y,et);let ut=r.convert(y.format,y.colorSpace),It=r.convert(y.type),Mt=E(y.internalFormat,ut,It,y.colorSpace,y.isVideoTexture);Yt(q,y);let ct,Vt=y.mipmaps,L=y.isVideoTexture!==!0,it=St.__version===void 0||j===!0,ot=W.dataReady,pt=I(y,et);if(y.isDepthTexture)Mt=S(y.format===Ts,y.type),it&&(L?e.texStorage2D(n.TEXTURE_2D,1,Mt,et.width,et.height):e.texImage2D(n.TEXTURE_2D,0,Mt,et.width,et.height,0,ut,It,null));else if(y.isDataTexture)if(Vt.length>0){L&&it&&e.texStorage2D(n.TEXTURE_2D,pt,Mt,Vt[0].width,Vt[0].height);for(let Q=0,Z=Vt.length;Q<Z;Q++)ct=Vt[Q],L?ot&&e.texSubImage2D(n.TEXTURE_2D,Q,0,0,ct.width,ct.height,ut,It,ct.data):e.texImage2D(n.TEXTURE_2D,Q,Mt,ct.width,ct.height,0,ut,It,ct.data);y.generateMipmaps=!1}else L?(it&&e.texStorage2D(n.TEXTURE_2D,pt,Mt,et.width,et.height),ot&&te(y,et,ut,It)):e.texImage2D(n.TEXTURE_2D,0,Mt,et.width,et.height,0,ut,It,et.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){L&&it&&e.texStorage3D(n.TEXTURE_2D_ARRAY,pt,Mt,Vt[0].width,Vt[0].height,et.depth);for(let Q=0,Z=Vt.length;Q<Z;Q++)if(ct=Vt[Q],y.format!==gi)if(ut!==null)if(L){if(ot)if(y.layerUpdates.size>0){let _t=jc(ct.width,ct.height,y.format,y.type);for(let kt of y.layerUpdates){let ce=ct.data.subarray(kt*_t/ct.data.BYTES_PER_ELEMENT,(kt+1)*_t/ct.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,Q,0,0,kt,ct.width,ct.height,1,ut,ce)}y.clearLayerUpdates()}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,Q,0,0,0,ct.width,ct.height,et.depth,ut,ct.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,Q,Mt,ct.width,ct.height,et.depth,0,ct.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else L?ot&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,Q,0,0,0,ct.width,ct.height,et.depth,ut,It,ct.data):e.texImage3D(n.TEXTURE_2D_ARRAY,Q,Mt,ct.width,ct.height,et.depth,0,ut,It,ct.data)}else{L&&it&&e.texStorage2D(n.TEXTURE_2D,pt,Mt,Vt[0].width,Vt[0].height);for(let Q=0,Z=Vt.length;Q<Z;Q++)ct=Vt[Q],y.format!==gi?ut!==null?L?ot&&e.compressedTexSubImage2D(n.TEXTURE_2D,Q,0,0,ct.width,ct.height,ut,ct.data):e.compressedTexImage2D(n.TEXTURE_2D,Q,Mt,ct.width,ct.height,0,ct.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):L?ot&&e.texSubImage2D(n.TEXTURE_2D,Q,0,0,ct.width,ct.height,ut,It,ct.data):e.texImage2D(n.TEXTURE_2D,Q,Mt,ct.width,ct.height,0,ut,It,ct.data)}else if(y.isDataArrayTexture)if(L){if(it&&e.texStorage3D(n.TEXTURE_2D_ARRAY,pt,Mt,et.width,et.height,et.depth),ot)if(y.layerUpdates.size>0){let Q=jc(et.width,et.height,y.format,y.type);for(let Z of y.layerUpdates){let _t=et.data.subarray(Z*Q/et.data.BYTES_PER_ELEMENT,(Z+1)*Q/et.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Z,et.width,et.height,1,ut,It,_t)}y.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,et.width,et.height,et.depth,ut,It,et.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,Mt,et.width,et.height,et.depth,0,ut,It,et.data);else if(y.isData3DTexture)L?(it&&e.texStorage3D(n.TEXTURE_3D,pt,Mt,et.width,et.height,et.depth),ot&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,et.width,et.height,et.depth,ut,It,et.data)):e.texImage3D(n.TEXTURE_3D,0,Mt,et.width,et.height,et.depth,0,ut,It,et.data);else if(y.isFramebufferTexture){if(it)if(L)e.texStorage2D(n.TEXTURE_2D,pt,Mt,et.width,et.height);else{let Q=et.width,Z=et.height;for(let _t=0;_t<pt;_t++)e.texImage2D(n.TEXTURE_2D,_t,Mt,Q,Z,0,ut,It,null),Q>>=1,Z>>=1}}else if(Vt.length>0){if(L&&it){let Q=Se(Vt[0]);e.texStorage2D(n.TEXTURE_2D,pt,Mt,Q.width,Q.height)}for(let Q=0,Z=Vt.length;Q<Z;Q++)ct=Vt[Q],L?ot&&e.texSubImage2D(n.TEXTURE_2D,Q,0,0,ut,It,ct):e.texImage2D(n.TEXTURE_2D,Q,Mt,ut,It,ct);y.generateMipmaps=!1}else if(L){if(it){let Q=Se(et);e.texStorage2D(n.TEXTURE_2D,pt,Mt,Q.width,Q.height)}ot&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,ut,It,et)}else e.texImage2D(n.TEXTURE_2D,0,Mt,ut,It,et);g(y)&&d(q),St.__version=W.version,y.onUpdate&&y.onUpdate(y)}T.__version=y.version}function J(T,y,O){if(y.image.length!==6)return;let q=le(T,y),j=y.source;e.bindTexture(n.TEXTURE_CUBE_MAP,T.__webglTexture,n.TEXTURE0+O);let W=i.get(j);if(j.version!==W.__version||q===!0){e.activeTexture(n.TEXTURE0+O);let St=Jt.getPrimaries(Jt.workingColorSpace),st=y.colorSpace===nn?null:Jt.getPrimaries(y.colorSpace),xt=y.colorSpace===nn||St===st?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,xt);let bt=y.isCompressedTexture||y.image[0].isCompressedTexture,et=y.image[0]&&y.image[0].isDataTexture,ut=[];for(let Z=0;Z<6;Z++)!bt&&!et?ut[Z]=M(y.image[Z],!0,s.maxCubemapSize):ut[Z]=et?y.image[Z].image:y.image[Z],ut[Z]=Pe(y,ut[Z]);let It=ut[0],Mt=r.convert(y.format,y.colorSpace),ct=r.convert(y.type),Vt=E(y.internalFormat,Mt,ct,y.colorSpace),L=y.isVideoTexture!==!0,it=W.__version===void 0||q===!0,ot=j.dataReady,pt=I(y,It);Yt(n.TEXTURE_CUBE_MAP,y);let Q;if(bt){L&&it&&e.texStorage2D(n.TEXTURE_CUBE_MAP,pt,Vt,It.width,It.height);for(let Z=0;Z<6;Z++){Q=ut[Z].mipmaps;for(let _t=0;_t<Q.length;_t++){let kt=Q[_t];y.format!==gi?Mt!==null?L?ot&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t,0,0,kt.width,kt.height,Mt,kt.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t,Vt,kt.width,kt.height,0,kt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):L?ot&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t,0,0,kt.width,kt.height,Mt,ct,kt.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t,Vt,kt.width,kt.height,0,Mt,ct,kt.data)}}}else{if(Q=y.mipmaps,L&&it){Q.length>0&&pt++;let Z=Se(ut[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,pt,Vt,Z.width,Z.height)}for(let Z=0;Z<6;Z++)if(et){L?ot&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0,0,0,ut[Z].width,ut[Z].height,Mt,ct,ut[Z].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0,Vt,ut[Z].width,ut[Z].height,0,Mt,ct,ut[Z].data);for(let _t=0;_t<Q.length;_t++){let ce=Q[_t].image[Z].image;L?ot&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t+1,0,0,ce.width,ce.height,Mt,ct,ce.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t+1,Vt,ce.width,ce.height,0,Mt,ct,ce.data)}}else{L?ot&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0,0,0,Mt,ct,ut[Z]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0,Vt,Mt,ct,ut[Z]);for(let _t=0;_t<Q.length;_t++){let kt=Q[_t];L?ot&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t+1,0,0,Mt,ct,kt.image[Z]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,_t+1,Vt,Mt,ct,kt.image[Z])}}}g(y)&&d(n.TEXTURE_CUBE_MAP),W.__version=j.version,y.onUpdate&&y.onUpdate(y)}T.__version=y.version}function mt(T,y,O,q,j,W){let St=r.convert(O.format,O.colorSpace),st=r.convert(O.type),xt=E(O.internalFormat,St,st,O.colorSpace),bt=i.get(y),et=i.get(O);if(et.__renderTarget=y,!bt.__hasExternalTextures){let ut=Math.max(1,y.width>>W),It=Math.max(1,y.height>>W);j===n.TEXTURE_3D||j===n.TEXTURE_2D_ARRAY?e.texImage3D(j,W,xt,ut,It,y.depth,0,St,st,null):e.texImage2D(j,W,xt,ut,It,0,St,st,null)}e.bindFramebuffer(n.FRAMEBUFFER,T),yt(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,q,j,et.__webglTexture,0,me(y)):(j===n.TEXTURE_2D||j>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,q,j,et.__webglTexture,W),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Nt(T,y,O){if(n.bindRenderbuffer(n.RENDERBUFFER,T),y.depthBuffer){let q=y.depthTexture,j=q&&q.isDepthTexture?q.type:null,W=S(y.stencilBuffer,j),St=y.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,st=me(y);yt(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,st,W,y.width,y.height):O?n.renderbufferStorageMultisample(n.RENDERBUFFER,st,W,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,W,y.width,y.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,St,n.RENDERBUFFER,T)}else{let q=y.textures;for(let j=0;j<q.length;j++){let W=q[j],St=r.convert(W.format,W.colorSpace),st=r.convert(W.type),xt=E(W.internalFormat,St,st,W.colorSpace),bt=me(y);O&&yt(y)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,bt,xt,y.width,y.height):yt(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,bt,xt,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,xt,y.width,y.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Et(T,y){if(y&&y.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(n.FRAMEBUFFER,T),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let q=i.get(y.depthTexture);q.__renderTarget=y,(!q.__webglTexture||y.depthTexture.image.width!==y.width||y.depthTexture.image.height!==y.height)&&(y.depthTexture.image.width=y.width,y.depthTexture.image.height=y.height,y.depthTexture.needsUpdate=!0),K(y.depthTexture,0);let j=q.__webglTexture,W=me(y);if(y.depthTexture.format===gs)yt(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,j,0,W):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,j,0);else if(y.depthTexture.format===Ts)yt(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,j,0,W):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,j,0);else throw new Error("Unknown depthTexture format")}function jt(T){let y=i.get(T),O=T.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==T.depthTexture){let q=T.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),q){let j=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,q.removeEventListener("dispose",j)};q.addEventListener("dispose",j),y.__depthDisposeCallback=j}y.__boundDepthTexture=q}if(T.depthTexture&&!y.__autoAllocateDepthBuffer){if(O)throw new Error("target.depthTexture not supported in Cube render targets");let q=T.texture.mipmaps;q&&q.length>0?Et(y.__webglFramebuffer[0],T):Et(y.__webglFramebuffer,T)}else if(O){y.__webglDepthbuffer=[];for(let q=0;q<6;q++)if(e.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[q]),y.__webglDepthbuffer[q]===void 0)y.__webglDepthbuffer[q]=n.createRenderbuffer(),Nt(y.__webglDepthbuffer[q],T,!1);else{let j=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,W=y.__webglDepthbuffer[q];n.bindRenderbuffer(n.RENDERBUFFER,W),n.framebufferRenderbuffer(n.FRAMEBUFFER,j,n.RENDERBUFFER,W)}}else{let q=T.texture.mipmaps;if(q&&q.length>0?e.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=n.createRenderbuffer(),Nt(y.__webglDepthbuffer,T,!1);else{let j=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,W=y.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,W),n.framebufferRenderbuffer(n.FRAMEBUFFER,j,n.RENDERBUFFER,W)}}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ne(T,y,O){let q=i.get(T);y!==void 0&&mt(q.__webglFramebuffer,T,T.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),O!==void 0&&jt(T)}function A(T){let y=T.texture,O=i.get(T),q=i.get(y);T.addEventListener("dispose",D);let j=T.textures,W=T.isWebGLCubeRenderTarget===!0,St=j.length>1;if(St||(q.__webglTexture===void 0&&(q.__webglTexture=n.createTexture()),q.__version=y.version,o.memory.textures++),W){O.__webglFramebuffer=[];for(let st=0;st<6;st++)if(y.mipmaps&&y.mipmaps.length>0){O.__webglFramebuffer[st]=[];for(let xt=0;xt<y.mipmaps.length;xt++)O.__webglFramebuffer[st][xt]=n.createFramebuffer()}else O.__webglFramebuffer[st]=n.createFramebuffer()}else{if(y.mipmaps&&y.mipmaps.length>0){O.__webglFramebuffer=[];for(let st=0;st<y.mipmaps.length;st++)O.__webglFramebuffer[st]=n.createFramebuffer()}else O.__webglFramebuffer=n.createFramebuffer();if(St)for(let st=0,xt=j.length;st<xt;st++){let bt=i.get(j[st]);bt.__webglTexture===void 0&&(bt.__webglTexture=n.createTexture(),o.memory.textures++)}if(T.samples>0&&yt(T)===!1){O.__webglMultisampledFramebuffer=n.createFramebuffer(),O.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let st=0;st<j.length;st++){let xt=j[st];O.__webglColorRenderbuffer[st]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,O.__webglColorRenderbuffer[st]);let bt=r.convert(xt.format,xt.colorSpace),et=r.convert(xt.type),ut=E(xt.internalFormat,bt,et,xt.colorSpace,T.isXRRenderTarget===!0),It=me(T);n.renderbufferStorageMultisample(n.RENDERBUFFER,It,ut,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+st,n.RENDERBUFFER,O.__webglColorRenderbuffer[st])}n.bindRenderbuffer(n.RENDERBUFFER,null),T.depthBuffer&&(O.__webglDepthRenderbuffer=n.createRenderbuffer(),Nt(O.__webglDepthRenderbuffer,T,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(W){e.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture),Yt(n.TEXTURE_CUBE_MAP,y);for(let st=0;st<6;st++)if(y.mipmaps&&y.mipmaps.length>0)for(let xt=0;xt<y.mipmaps.length;xt++)mt(O.__webglFramebuffer[st][xt],T,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+st,xt);else mt(O.__webglFramebuffer[st],T,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+st,0);g(y)&&d(n.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(St){for(let st=0,xt=j.length;st<xt;st++){let bt=j[st],et=i.get(bt),ut=n.TEXTURE_2D;(T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(ut=T.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ut,et.__webglTexture),Yt(ut,bt),mt(O.__webglFramebuffer,T,bt,n.COLOR_ATTACHMENT0+st,ut,0),g(bt)&&d(ut)}e.unbindTexture()}else{let st=n.TEXTURE_2D;if((T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(st=T.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(st,q.__webglTexture),Yt(st,y),y.mipmaps&&y.mipmaps.length>0)for(let xt=0;xt<y.mipmaps.length;xt++)mt(O.__webglFramebuffer[xt],T,y,n.COLOR_ATTACHMENT0,st,xt);else mt(O.__webglFramebuffer,T,y,n.COLOR_ATTACHMENT0,st,0);g(y)&&d(st),e.unbindTexture()}T.depthBuffer&&jt(T)}function pe(T){let y=T.textures;for(let O=0,q=y.length;O<q;O++){let j=y[O];if(g(j)){let W=R(T),St=i.get(j).__webglTexture;e.bindTexture(W,St),d(W),e.unbindTexture()}}}let Bt=[],Lt=[];function vt(T){if(T.samples>0){if(yt(T)===!1){let y=T.textures,O=T.width,q=T.height,j=n.COLOR_BUFFER_BIT,W=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=i.get(T),st=y.length>1;if(st)for(let bt=0;bt<y.length;bt++)e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer);let xt=T.texture.mipmaps;xt&&xt.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let bt=0;bt<y.length;bt++){if(T.resolveDepthBuffer&&(T.depthBuffer&&(j|=n.DEPTH_BUFFER_BIT),T.stencilBuffer&&T.resolveStencilBuffer&&(j|=n.STENCIL_BUFFER_BIT)),st){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,St.__webglColorRenderbuffer[bt]);let et=i.get(y[bt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,et,0)}n.blitFramebuffer(0,0,O,q,0,0,O,q,j,n.NEAREST),l===!0&&(Bt.length=0,Lt.length=0,Bt.push(n.COLOR_ATTACHMENT0+bt),T.depthBuffer&&T.resolveDepthBuffer===!1&&(Bt.push(W),Lt.push(W),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,Lt)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Bt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),st)for(let bt=0;bt<y.length;bt++){e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.RENDERBUFFER,St.__webglColorRenderbuffer[bt]);let et=i.get(y[bt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.TEXTURE_2D,et,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(T.depthBuffer&&T.resolveDepthBuffer===!1&&l){let y=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[y])}}}function me(T){return Math.min(s.maxSamples,T.samples)}function yt(T){let y=i.get(T);return T.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Gt(T){let y=o.render.frame;h.get(T)!==y&&(h.set(T,y),T.update())}function Pe(T,y){let O=T.colorSpace,q=T.format,j=T.type;return T.isCompressedTexture===!0||T.isVideoTexture===!0||O!==On&&O!==nn&&(Jt.getTransfer(O)===ne?(q!==gi||j!==zi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",O)),y}function Se(T){return typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement?(c.width=T.naturalWidth||T.width,c.height=T.naturalHeight||T.height):typeof VideoFrame<"u"&&T instanceof VideoFrame?(c.width=T.displayWidth,c.height=T.displayHeight):(c.width=T.width,c.height=T.height),c}this.allocateTextureUnit=V,this.resetTextureUnits=B,this.setTexture2D=K,this.setTexture2DArray=Y,this.setTexture3D=nt,this.setTextureCube=G,this.rebindTextures=Ne,this.setupRenderTarget=A,this.updateRenderTargetMipmap=pe,this.updateMultisampleRenderTarget=vt,this.setupDepthRenderbuffer=jt,this.setupFrameBufferTexture=mt,this.useMultisampledRTT=yt}function E0(n,t){function e(i,s=nn){let r,o=Jt.getTransfer(s);if(i===zi)return n.UNSIGNED_BYTE;if(i===Ca)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Pa)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Oc)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===kc)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Nc)return n.BYTE;if(i===Fc)return n.SHORT;if(i===ws)return n.UNSIGNED_SHORT;if(i===Ra)return n.INT;if(i===bn)return n.UNSIGNED_INT;if(i===Ri)return n.FLOAT;if(i===Ss)return n.HALF_FLOAT;if(i===Bc)return n.ALPHA;if(i===zc)return n.RGB;if(i===gi)return n.RGBA;if(i===gs)return n.DEPTH_COMPONENT;if(i===Ts)return n.DEPTH_STENCIL;if(i===Ia)return n.RED;if(i===La)return n.RED_INTEGER;if(i===Hc)return n.RG;if(i===Da)return n.RG_INTEGER;if(i===Ua)return n.RGBA_INTEGER;if(i===Rr||i===Cr||i===Pr||i===Ir)if(o===ne)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Rr)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Cr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Pr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ir)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Rr)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Cr)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Pr)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ir)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Na||i===Fa||i===Oa||i===ka)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Na)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Fa)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Oa)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ka)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Ba||i===za||i===Ha)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Ba||i===za)return o===ne?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ha)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===Va||i===Ga||i===Wa||i===Xa||i===qa||i===Ya||i===$a||i===Za||i===Ka||i===ja||i===Ja||i===Qa||i===tl||i===el)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Va)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ga)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Wa)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Xa)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===qa)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ya)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===$a)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Za)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Ka)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===ja)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ja)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Qa)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===tl)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===el)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===il||i===nl||i===sl)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===il)return o===ne?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===nl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===sl)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===rl||i===ol||i===al||i===ll)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===rl)return r.COMPRESSED_RED_RGTC1_EXT;if(i===ol)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===al)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===ll)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Es?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var T0=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,A0=`
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

}`,hh=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new yr(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Ti({vertexShader:T0,fragmentShader:A0,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Xe(new xr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},uh=class extends Li{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,m=null,v=null,M=typeof XRWebGLBinding<"u",g=new hh,d={},R=e.getContextAttributes(),E=null,S=null,I=[],P=[],D=new zt,k=null,x=new Ge;x.viewport=new Me;let b=new Ge;b.viewport=new Me;let C=[x,b],B=new ga,V=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function($){let J=I[$];return J===void 0&&(J=new bs,I[$]=J),J.getTargetRaySpace()},this.getControllerGrip=function($){let J=I[$];return J===void 0&&(J=new bs,I[$]=J),J.getGripSpace()},this.getHand=function($){let J=I[$];return J===void 0&&(J=new bs,I[$]=J),J.getHandSpace()};function K($){let J=P.indexOf($.inputSource);if(J===-1)return;let mt=I[J];mt!==void 0&&(mt.update($.inputSource,$.frame,c||o),mt.dispatchEvent({type:$.type,data:$.inputSource}))}function Y(){s.removeEventListener("select",K),s.removeEventListener("selectstart",K),s.removeEventListener("selectend",K),s.removeEventListener("squeeze",K),s.removeEventListener("squeezestart",K),s.removeEventListener("squeezeend",K),s.removeEventListener("end",Y),s.removeEventListener("inputsourceschange",nt);for(let $=0;$<I.length;$++){let J=P[$];J!==null&&(P[$]=null,I[$].disconnect(J))}V=null,X=null,g.reset();for(let $ in d)delete d[$];t.setRenderTarget(E),m=null,f=null,u=null,s=null,S=null,te.stop(),i.isPresenting=!1,t.setPixelRatio(k),t.setSize(D.width,D.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function($){r=$,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function($){a=$,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function($){c=$},this.getBaseLayer=function(){return f!==null?f:m},this.getBinding=function(){return u===null&&M&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return v},this.getSession=function(){return s},this.setSession=async function($){if(s=$,s!==null){if(E=t.getRenderTarget(),s.addEventListener("select",K),s.addEventListener("selectstart",K),s.addEventListener("selectend",K),s.addEventListener("squeeze",K),s.addEventListener("squeezestart",K),s.addEventListener("squeezeend",K),s.addEventListener("end",Y),s.addEventListener("inputsourceschange",nt),R.xrCompatible!==!0&&await e.makeXRCompatible(),k=t.getPixelRatio(),t.getSize(D),M&&"createProjectionLayer"in XRWebGLBinding.prototype){let mt=null,Nt=null,Et=null;R.depth&&(Et=R.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,mt=R.stencil?Ts:gs,Nt=R.stencil?Es:bn);let jt={colorFormat:e.RGBA8,depthFormat:Et,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(jt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),S=new Di(f.textureWidth,f.textureHeight,{format:gi,type:zi,depthTexture:new vr(f.textureWidth,f.textureHeight,Nt,void 0,void 0,void 0,void 0,void 0,void 0,mt),stencilBuffer:R.stencil,colorSpace:t.outputColorSpace,samples:R.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{let mt={antialias:R.antialias,alpha:!0,depth:R.depth,stencil:R.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,e,mt),s.updateRenderState({baseLayer:m}),t.setPixelRatio(1),t.setSize(m.framebufferWidth,m.framebufferHeight,!1),S=new Di(m.framebufferWidth,m.framebufferHeight,{format:gi,type:zi,colorSpace:t.outputColorSpace,stencilBuffer:R.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),te.setContext(s),te.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function nt($){for(let J=0;J<$.removed.length;J++){let mt=$.removed[J],Nt=P.indexOf(mt);Nt>=0&&(P[Nt]=null,I[Nt].disconnect(mt))}for(let J=0;J<$.added.length;J++){let mt=$.added[J],Nt=P.indexOf(mt);if(Nt===-1){for(let jt=0;jt<I.length;jt++)if(jt>=P.length){P.push(mt),Nt=jt;break}else if(P[jt]===null){P[jt]=mt,Nt=jt;break}if(Nt===-1)break}let Et=I[Nt];Et&&Et.connect(mt)}}let G=new F,lt=new F;function dt($,J,mt){G.setFromMatrixPosition(J.matrixWorld),lt.setFromMatrixPosition(mt.matrixWorld);let Nt=G.distanceTo(lt),Et=J.projectionMatrix.elements,jt=mt.projectionMatrix.elements,Ne=Et[14]/(Et[10]-1),A=Et[14]/(Et[10]+1),pe=(Et[9]+1)/Et[5],Bt=(Et[9]-1)/Et[5],Lt=(Et[8]-1)/Et[0],vt=(jt[8]+1)/jt[0],me=Ne*Lt,yt=Ne*vt,Gt=Nt/(-Lt+vt),Pe=Gt*-Lt;if(J.matrixWorld.decompose($.position,$.quaternion,$.scale),$.translateX(Pe),$.translateZ(Gt),$.matrixWorld.compose($.position,$.quaternion,$.scale),$.matrixWorldInverse.copy($.matrixWorld).invert(),Et[10]===-1)$.projectionMatrix.copy(J.projectionMatrix),$.projectionMatrixInverse.copy(J.projectionMatrixInverse);else{let Se=Ne+Gt,T=A+Gt,y=me-Pe,O=yt+(Nt-Pe),q=pe*A/T*Se,j=Bt*A/T*Se;$.projectionMatrix.makePerspective(y,O,q,j,Se,T),$.projectionMatrixInverse.copy($.projectionMatrix).invert()}}function At($,J){J===null?$.matrixWorld.copy($.matrix):$.matrixWorld.multiplyMatrices(J.matrixWorld,$.matrix),$.matrixWorldInverse.copy($.matrixWorld).invert()}this.updateCamera=function($){if(s===null)return;let J=$.near,mt=$.far;g.texture!==null&&(g.depthNear>0&&(J=g.depthNear),g.depthFar>0&&(mt=g.depthFar)),B.near=b.near=x.near=J,B.far=b.far=x.far=mt,(V!==B.near||X!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),V=B.near,X=B.far),B.layers.mask=$.layers.mask|6,x.layers.mask=B.layers.mask&3,b.layers.mask=B.layers.mask&5;let Nt=$.parent,Et=B.cameras;At(B,Nt);for(let jt=0;jt<Et.length;jt++)At(Et[jt],Nt);Et.length===2?dt(B,x,b):B.projectionMatrix.copy(x.projectionMatrix),Yt($,B,Nt)};function Yt($,J,mt){mt===null?$.matrix.copy(J.matrixWorld):($.matrix.copy(mt.matrixWorld),$.matrix.invert(),$.matrix.multiply(J.matrixWorld)),$.matrix.decompose($.position,$.quaternion,$.scale),$.updateMatrixWorld(!0),$.projectionMatrix.copy(J.projectionMatrix),$.projectionMatrixInverse.copy(J.projectionMatrixInverse),$.isPerspectiveCamera&&($.fov=_s*2*Math.atan(1/$.projectionMatrix.elements[5]),$.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(f===null&&m===null))return l},this.setFoveation=function($){l=$,f!==null&&(f.fixedFoveation=$),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=$)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(B)},this.getCameraTexture=function($){return d[$]};let le=null;function fe($,J){if(h=J.getViewerPose(c||o),v=J,h!==null){let mt=h.views;m!==null&&(t.setRenderTargetFramebuffer(S,m.framebuffer),t.setRenderTarget(S));let Nt=!1;mt.length!==B.cameras.length&&(B.cameras.length=0,Nt=!0);for(let A=0;A<mt.length;A++){let pe=mt[A],Bt=null;if(m!==null)Bt=m.getViewport(pe);else{let vt=u.getViewSubImage(f,pe);Bt=vt.viewport,A===0&&(t.setRenderTargetTextures(S,vt.colorTexture,vt.depthStencilTexture),t.setRenderTarget(S))}let Lt=C[A];Lt===void 0&&(Lt=new Ge,Lt.layers.enable(A),Lt.viewport=new Me,C[A]=Lt),Lt.matrix.fromArray(pe.transform.matrix),Lt.matrix.decompose(Lt.position,Lt.quaternion,Lt.scale),Lt.projectionMatrix.fromArray(pe.projectionMatrix),Lt.projectionMatrixInverse.copy(Lt.projectionMatrix).invert(),Lt.viewport.set(Bt.x,Bt.y,Bt.width,Bt.height),A===0&&(B.matrix.copy(Lt.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),Nt===!0&&B.cameras.push(Lt)}let Et=s.enabledFeatures;if(Et&&Et.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&M){u=i.getBinding();let A=u.getDepthInformation(mt[0]);A&&A.isValid&&A.texture&&g.init(A,s.renderState)}if(Et&&Et.includes("camera-access")&&M){t.state.unbindTexture(),u=i.getBinding();for(let A=0;A<mt.length;A++){let pe=mt[A].camera;if(pe){let Bt=d[pe];Bt||(Bt=new yr,d[pe]=Bt);let Lt=u.getCameraImage(pe);Bt.sourceTexture=Lt}}}}for(let mt=0;mt<I.length;mt++){let Nt=P[mt],Et=I[mt];Nt!==null&&Et!==void 0&&Et.update(Nt,J,c||o)}le&&le($,J),J.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:J}),v=null}let te=new tf;te.setAnimationLoop(fe),this.setAnimationLoop=function($){le=$},this.dispose=function(){}}},Xn=new Ei,R0=new ae;function C0(n,t){function e(g,d){g.matrixAutoUpdate===!0&&g.updateMatrix(),d.value.copy(g.matrix)}function i(g,d){d.color.getRGB(g.fogColor.value,$c(n)),d.isFog?(g.fogNear.value=d.near,g.fogFar.value=d.far):d.isFogExp2&&(g.fogDensity.value=d.density)}function s(g,d,R,E,S){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(g,d):d.isMeshToonMaterial?(r(g,d),u(g,d)):d.isMeshPhongMaterial?(r(g,d),h(g,d)):d.isMeshStandardMaterial?(r(g,d),f(g,d),d.isMeshPhysicalMaterial&&m(g,d,S)):d.isMeshMatcapMaterial?(r(g,d),v(g,d)):d.isMeshDepthMaterial?r(g,d):d.isMeshDistanceMaterial?(r(g,d),M(g,d)):d.isMeshNormalMaterial?r(g,d):d.isLineBasicMaterial?(o(g,d),d.isLineDashedMaterial&&a(g,d)):d.isPointsMaterial?l(g,d,R,E):d.isSpriteMaterial?c(g,d):d.isShadowMaterial?(g.color.value.copy(d.color),g.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(g,d){g.opacity.value=d.opacity,d.color&&g.diffuse.value.copy(d.color),d.emissive&&g.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(g.map.value=d.map,e(d.map,g.mapTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,e(d.alphaMap,g.alphaMapTransform)),d.bumpMap&&(g.bumpMap.value=d.bumpMap,e(d.bumpMap,g.bumpMapTransform),g.bumpScale.value=d.bumpScale,d.side===Je&&(g.bumpScale.value*=-1)),d.normalMap&&(g.normalMap.value=d.normalMap,e(d.normalMap,g.normalMapTransform),g.normalScale.value.copy(d.normalScale),d.side===Je&&g.normalScale.value.negate()),d.displacementMap&&(g.displacementMap.value=d.displacementMap,e(d.displacementMap,g.displacementMapTransform),g.displacementScale.value=d.displacementScale,g.displacementBias.value=d.displacementBias),d.emissiveMap&&(g.emissiveMap.value=d.emissiveMap,e(d.emissiveMap,g.emissiveMapTransform)),d.specularMap&&(g.specularMap.value=d.specularMap,e(d.specularMap,g.specularMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest);let R=t.get(d),E=R.envMap,S=R.envMapRotation;E&&(g.envMap.value=E,Xn.copy(S),Xn.x*=-1,Xn.y*=-1,Xn.z*=-1,E.isCubeTexture&&E.isRenderTargetTexture===!1&&(Xn.y*=-1,Xn.z*=-1),g.envMapRotation.value.setFromMatrix4(R0.makeRotationFromEuler(Xn)),g.flipEnvMap.value=E.isCubeTexture&&E.isRenderTargetTexture===!1?-1:1,g.reflectivity.value=d.reflectivity,g.ior.value=d.ior,g.refractionRatio.value=d.refractionRatio),d.lightMap&&(g.lightMap.value=d.lightMap,g.lightMapIntensity.value=d.lightMapIntensity,e(d.lightMap,g.lightMapTransform)),d.aoMap&&(g.aoMap.value=d.aoMap,g.aoMapIntensity.value=d.aoMapIntensity,e(d.aoMap,g.aoMapTransform))}function o(g,d){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,d.map&&(g.map.value=d.map,e(d.map,g.mapTransform))}function a(g,d){g.dashSize.value=d.dashSize,g.totalSize.value=d.dashSize+d.gapSize,g.scale.value=d.scale}function l(g,d,R,E){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,g.size.value=d.size*R,g.scale.value=E*.5,d.map&&(g.map.value=d.map,e(d.map,g.uvTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,e(d.alphaMap,g.alphaMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest)}function c(g,d){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,g.rotation.value=d.rotation,d.map&&(g.map.value=d.map,e(d.map,g.mapTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,e(d.alphaMap,g.alphaMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest)}function h(g,d){g.specular.value.copy(d.specular),g.shininess.value=Math.max(d.shininess,1e-4)}function u(g,d){d.gradientMap&&(g.gradientMap.value=d.gradientMap)}function f(g,d){g.metalness.value=d.metalness,d.metalnessMap&&(g.metalnessMap.value=d.metalnessMap,e(d.metalnessMap,g.metalnessMapTransform)),g.roughness.value=d.roughness,d.roughnessMap&&(g.roughnessMap.value=d.roughnessMap,e(d.roughnessMap,g.roughnessMapTransform)),d.envMap&&(g.envMapIntensity.value=d.envMapIntensity)}function m(g,d,R){g.ior.value=d.ior,d.sheen>0&&(g.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),g.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(g.sheenColorMap.value=d.sheenColorMap,e(d.sheenColorMap,g.sheenColorMapTransform)),d.sheenRoughnessMap&&(g.sheenRoughnessMap.value=d.sheenRoughnessMap,e(d.sheenRoughnessMap,g.sheenRoughnessMapTransform))),d.clearcoat>0&&(g.clearcoat.value=d.clearcoat,g.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(g.clearcoatMap.value=d.clearcoatMap,e(d.clearcoatMap,g.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,e(d.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(g.clearcoatNormalMap.value=d.clearcoatNormalMap,e(d.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===Je&&g.clearcoatNormalScale.value.negate())),d.dispersion>0&&(g.dispersion.value=d.dispersion),d.iridescence>0&&(g.iridescence.value=d.iridescence,g.iridescenceIOR.value=d.iridescenceIOR,g.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],g.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(g.iridescenceMap.value=d.iridescenceMap,e(d.iridescenceMap,g.iridescenceMapTransform)),d.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=d.iridescenceThicknessMap,e(d.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),d.transmission>0&&(g.transmission.value=d.transmission,g.transmissionSamplerMap.value=R.texture,g.transmissionSamplerSize.value.set(R.width,R.height),d.transmissionMap&&(g.transmissionMap.value=d.transmissionMap,e(d.transmissionMap,g.transmissionMapTransform)),g.thickness.value=d.thickness,d.thicknessMap&&(g.thicknessMap.value=d.thicknessMap,e(d.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=d.attenuationDistance,g.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(g.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(g.anisotropyMap.value=d.anisotropyMap,e(d.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=d.specularIntensity,g.specularColor.value.copy(d.specularColor),d.specularColorMap&&(g.specularColorMap.value=d.specularColorMap,e(d.specularColorMap,g.specularColorMapTransform)),d.specularIntensityMap&&(g.specularIntensityMap.value=d.specularIntensityMap,e(d.specularIntensityMap,g.specularIntensityMapTransform))}function v(g,d){d.matcap&&(g.matcap.value=d.matcap)}function M(g,d){let R=t.get(d).light;g.referencePosition.value.setFromMatrixPosition(R.matrixWorld),g.nearDistance.value=R.shadow.camera.near,g.farDistance.value=R.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function P0(n,t,e,i){let s={},r={},o=[],a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(R,E){let S=E.program;i.uniformBlockBinding(R,S)}function c(R,E){let S=s[R.id];S===void 0&&(v(R),S=h(R),s[R.id]=S,R.addEventListener("dispose",g));let I=E.program;i.updateUBOMapping(R,I);let P=t.render.frame;r[R.id]!==P&&(f(R),r[R.id]=P)}function h(R){let E=u();R.__bindingPointIndex=E;let S=n.createBuffer(),I=R.__size,P=R.usage;return n.bindBuffer(n.UNIFORM_BUFFER,S),n.bufferData(n.UNIFORM_BUFFER,I,P),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,E,S),S}function u(){for(let R=0;R<a;R++)if(o.indexOf(R)===-1)return o.push(R),R;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(R){let E=s[R.id],S=R.uniforms,I=R.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let P=0,D=S.length;P<D;P++){let k=Array.isArray(S[P])?S[P]:[S[P]];for(let x=0,b=k.length;x<b;x++){let C=k[x];if(m(C,P,x,I)===!0){let B=C.__offset,V=Array.isArray(C.value)?C.value:[C.value],X=0;for(let K=0;K<V.length;K++){let Y=V[K],nt=M(Y);typeof Y=="number"||typeof Y=="boolean"?(C.__data[0]=Y,n.bufferSubData(n.UNIFORM_BUFFER,B+X,C.__data)):Y.isMatrix3?(C.__data[0]=Y.elements[0],C.__data[1]=Y.elements[1],C.__data[2]=Y.elements[2],C.__data[3]=0,C.__data[4]=Y.elements[3],C.__data[5]=Y.elements[4],C.__data[6]=Y.elements[5],C.__data[7]=0,C.__data[8]=Y.elements[6],C.__data[9]=Y.elements[7],C.__data[10]=Y.elements[8],C.__data[11]=0):(Y.toArray(C.__data,X),X+=nt.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,B,C.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function m(R,E,S,I){let P=R.value,D=E+"_"+S;if(I[D]===void 0)return typeof P=="number"||typeof P=="boolean"?I[D]=P:I[D]=P.clone(),!0;{let k=I[D];if(typeof P=="number"||typeof P=="boolean"){if(k!==P)return I[D]=P,!0}else if(k.equals(P)===!1)return k.copy(P),!0}return!1}function v(R){let E=R.uniforms,S=0,I=16;for(let D=0,k=E.length;D<k;D++){let x=Array.isArray(E[D])?E[D]:[E[D]];for(let b=0,C=x.length;b<C;b++){let B=x[b],V=Array.isArray(B.value)?B.value:[B.value];for(let X=0,K=V.length;X<K;X++){let Y=V[X],nt=M(Y),G=S%I,lt=G%nt.boundary,dt=G+lt;S+=lt,dt!==0&&I-dt<nt.storage&&(S+=I-dt),B.__data=new Float32Array(nt.storage/Float32Array.BYTES_PER_ELEMENT),B.__offset=S,S+=nt.storage}}}let P=S%I;return P>0&&(S+=I-P),R.__size=S,R.__cache={},this}function M(R){let E={boundary:0,storage:0};return typeof R=="number"||typeof R=="boolean"?(E.boundary=4,E.storage=4):R.isVector2?(E.boundary=8,E.storage=8):R.isVector3||R.isColor?(E.boundary=16,E.storage=12):R.isVector4?(E.boundary=16,E.storage=16):R.isMatrix3?(E.boundary=48,E.storage=48):R.isMatrix4?(E.boundary=64,E.storage=64):R.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",R),E}function g(R){let E=R.target;E.removeEventListener("dispose",g);let S=o.indexOf(E.__bindingPointIndex);o.splice(S,1),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function d(){for(let R in s)n.deleteBuffer(s[R]);o=[],s={},r={}}return{bind:l,update:c,dispose:d}}var fl=class{constructor(t={}){let{canvas:e=Td(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let v=new Uint32Array(4),M=new Int32Array(4),g=null,d=null,R=[],E=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=en,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let S=this,I=!1;this._outputColorSpace=ci;let P=0,D=0,k=null,x=-1,b=null,C=new Me,B=new Me,V=null,X=new Ot(0),K=0,Y=e.width,nt=e.height,G=1,lt=null,dt=null,At=new Me(0,0,Y,nt),Yt=new Me(0,0,Y,nt),le=!1,fe=new gr,te=!1,$=!1,J=new ae,mt=new F,Nt=new Me,Et={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},jt=!1;function Ne(){return k===null?G:1}let A=i;function pe(w,U){return e.getContext(w,U)}try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"180"}`),e.addEventListener("webglcontextlost",ot,!1),e.addEventListener("webglcontextrestored",pt,!1),e.addEventListener("webglcontextcreationerror",Q,!1),A===null){let U="webgl2";if(A=pe(U,w),A===null)throw pe(U)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(w){throw console.error("THREE.WebGLRenderer: "+w.message),w}let Bt,Lt,vt,me,yt,Gt,Pe,Se,T,y,O,q,j,W,St,st,xt,bt,et,ut,It,Mt,ct,Vt;function L(){Bt=new $v(A),Bt.init(),Mt=new E0(A,Bt),Lt=new Hv(A,Bt,t,Mt),vt=new w0(A,Bt),Lt.reversedDepthBuffer&&f&&vt.buffers.depth.setReversed(!0),me=new jv(A),yt=new h0,Gt=new S0(A,Bt,vt,yt,Lt,Mt,me),Pe=new Gv(S),Se=new Yv(S),T=new ng(A),ct=new Bv(A,T),y=new Zv(A,T,me,ct),O=new Qv(A,y,T,me),et=new Jv(A,Lt,Gt),st=new Vv(yt),q=new c0(S,Pe,Se,Bt,Lt,ct,st),j=new C0(S,yt),W=new d0,St=new v0(Bt),bt=new kv(S,Pe,Se,vt,O,m,l),xt=new b0(S,O,Lt),Vt=new P0(A,me,Lt,vt),ut=new zv(A,Bt,me),It=new Kv(A,Bt,me),me.programs=q.programs,S.capabilities=Lt,S.extensions=Bt,S.properties=yt,S.renderLists=W,S.shadowMap=xt,S.state=vt,S.info=me}L();let it=new uh(S,A);this.xr=it,this.getContext=function(){return A},this.getContextAttributes=function(){return A.getContextAttributes()},this.forceContextLoss=function(){let w=Bt.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=Bt.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return G},this.setPixelRatio=function(w){w!==void 0&&(G=w,this.setSize(Y,nt,!1))},this.getSize=function(w){return w.set(Y,nt)},this.setSize=function(w,U,z=!0){if(it.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}Y=w,nt=U,e.width=Math.floor(w*G),e.height=Math.floor(U*G),z===!0&&(e.style.width=w+"px",e.style.height=U+"px"),this.setViewport(0,0,w,U)},this.getDrawingBufferSize=function(w){return w.set(Y*G,nt*G).floor()},this.setDrawingBufferSize=function(w,U,z){Y=w,nt=U,G=z,e.width=Math.floor(w*z),e.height=Math.floor(U*z),this.setViewport(0,0,w,U)},this.getCurrentViewport=function(w){return w.copy(C)},this.getViewport=function(w){return w.copy(At)},this.setViewport=function(w,U,z,H){w.isVector4?At.set(w.x,w.y,w.z,w.w):At.set(w,U,z,H),vt.viewport(C.copy(At).multiplyScalar(G).round())},this.getScissor=function(w){return w.copy(Yt)},this.setScissor=function(w,U,z,H){w.isVector4?Yt.set(w.x,w.y,w.z,w.w):Yt.set(w,U,z,H),vt.scissor(B.copy(Yt).multiplyScalar(G).round())},this.getScissorTest=function(){return le},this.setScissorTest=function(w){vt.setScissorTest(le=w)},this.setOpaqueSort=function(w){lt=w},this.setTransparentSort=function(w){dt=w},this.getClearColor=function(w){return w.copy(bt.getClearColor())},this.setClearColor=function(){bt.setClearColor(...arguments)},this.getClearAlpha=function(){return bt.getClearAlpha()},this.setClearAlpha=function(){bt.setClearAlpha(...arguments)},this.clear=function(w=!0,U=!0,z=!0){let H=0;if(w){let N=!1;if(k!==null){let tt=k.texture.format;N=tt===Ua||tt===Da||tt===La}if(N){let tt=k.texture.type,ht=tt===zi||tt===bn||tt===ws||tt===Es||tt===Ca||tt===Pa,gt=bt.getClearColor(),ft=bt.getClearAlpha(),Pt=gt.r,Dt=gt.g,Rt=gt.b;ht?(v[0]=Pt,v[1]=Dt,v[2]=Rt,v[3]=ft,A.clearBufferuiv(A.COLOR,0,v)):(M[0]=Pt,M[1]=Dt,M[2]=Rt,M[3]=ft,A.clearBufferiv(A.COLOR,0,M))}else H|=A.COLOR_BUFFER_BIT}U&&(H|=A.DEPTH_BUFFER_BIT),z&&(H|=A.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),A.clear(H)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",ot,!1),e.removeEventListener("webglcontextrestored",pt,!1),e.removeEventListener("webglcontextcreationerror",Q,!1),bt.dispose(),W.dispose(),St.dispose(),yt.dispose(),Pe.dispose(),Se.dispose(),O.dispose(),ct.dispose(),Vt.dispose(),q.dispose(),it.dispose(),it.removeEventListener("sessionstart",Ci),it.removeEventListener("sessionend",xh),wn.stop()};function ot(w){w.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),I=!0}function pt(){console.log("THREE.WebGLRenderer: Context Restored."),I=!1;let w=me.autoReset,U=xt.enabled,z=xt.autoUpdate,H=xt.needsUpdate,N=xt.type;L(),me.autoReset=w,xt.enabled=U,xt.autoUpdate=z,xt.needsUpdate=H,xt.type=N}function Q(w){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function Z(w){let U=w.target;U.removeEventListener("dispose",Z),_t(U)}function _t(w){kt(w),yt.remove(w)}function kt(w){let U=yt.get(w).programs;U!==void 0&&(U.forEach(function(z){q.releaseProgram(z)}),w.isShaderMaterial&&q.releaseShaderCache(w))}this.renderBufferDirect=function(w,U,z,H,N,tt){U===null&&(U=Et);let ht=N.isMesh&&N.matrixWorld.determinant()<0,gt=Sf(w,U,z,H,N);vt.setMaterial(H,ht);let ft=z.index,Pt=1;if(H.wireframe===!0){if(ft=y.getWireframeAttribute(z),ft===void 0)return;Pt=2}let Dt=z.drawRange,Rt=z.attributes.position,$t=Dt.start*Pt,se=(Dt.start+Dt.count)*Pt;tt!==null&&($t=Math.max($t,tt.start*Pt),se=Math.min(se,(tt.start+tt.count)*Pt)),ft!==null?($t=Math.max($t,0),se=Math.min(se,ft.count)):Rt!=null&&($t=Math.max($t,0),se=Math.min(se,Rt.count));let ve=se-$t;if(ve<0||ve===1/0)return;ct.setup(N,H,gt,z,ft);let ue,oe=ut;if(ft!==null&&(ue=T.get(ft),oe=It,oe.setIndex(ue)),N.isMesh)H.wireframe===!0?(vt.setLineWidth(H.wireframeLinewidth*Ne()),oe.setMode(A.LINES)):oe.setMode(A.TRIANGLES);else if(N.isLine){let Ct=H.linewidth;Ct===void 0&&(Ct=1),vt.setLineWidth(Ct*Ne()),N.isLineSegments?oe.setMode(A.LINES):N.isLineLoop?oe.setMode(A.LINE_LOOP):oe.setMode(A.LINE_STRIP)}else N.isPoints?oe.setMode(A.POINTS):N.isSprite&&oe.setMode(A.TRIANGLES);if(N.isBatchedMesh)if(N._multiDrawInstances!==null)vs("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),oe.renderMultiDrawInstances(N._multiDrawStarts,N._multiDrawCounts,N._multiDrawCount,N._multiDrawInstances);else if(Bt.get("WEBGL_multi_draw"))oe.renderMultiDraw(N._multiDrawStarts,N._multiDrawCounts,N._multiDrawCount);else{let Ct=N._multiDrawStarts,ge=N._multiDrawCounts,Qt=N._multiDrawCount,ni=ft?T.get(ft).bytesPerElement:1,$n=yt.get(H).currentProgram.getUniforms();for(let si=0;si<Qt;si++)$n.setValue(A,"_gl_DrawID",si),oe.render(Ct[si]/ni,ge[si])}else if(N.isInstancedMesh)oe.renderInstances($t,ve,N.count);else if(z.isInstancedBufferGeometry){let Ct=z._maxInstanceCount!==void 0?z._maxInstanceCount:1/0,ge=Math.min(z.instanceCount,Ct);oe.renderInstances($t,ve,ge)}else oe.render($t,ve)};function ce(w,U,z){w.transparent===!0&&w.side===Bi&&w.forceSinglePass===!1?(w.side=Je,w.needsUpdate=!0,kr(w,U,z),w.side=Ji,w.needsUpdate=!0,kr(w,U,z),w.side=Bi):kr(w,U,z)}this.compile=function(w,U,z=null){z===null&&(z=w),d=St.get(z),d.init(U),E.push(d),z.traverseVisible(function(N){N.isLight&&N.layers.test(U.layers)&&(d.pushLight(N),N.castShadow&&d.pushShadow(N))}),w!==z&&w.traverseVisible(function(N){N.isLight&&N.layers.test(U.layers)&&(d.pushLight(N),N.castShadow&&d.pushShadow(N))}),d.setupLights();let H=new Set;return w.traverse(function(N){if(!(N.isMesh||N.isPoints||N.isLine||N.isSprite))return;let tt=N.material;if(tt)if(Array.isArray(tt))for(let ht=0;ht<tt.length;ht++){let gt=tt[ht];ce(gt,z,N),H.add(gt)}else ce(tt,z,N),H.add(tt)}),d=E.pop(),H},this.compileAsync=function(w,U,z=null){let H=this.compile(w,U,z);return new Promise(N=>{function tt(){if(H.forEach(function(ht){yt.get(ht).currentProgram.isReady()&&H.delete(ht)}),H.size===0){N(w);return}setTimeout(tt,10)}Bt.get("KHR_parallel_shader_compile")!==null?tt():setTimeout(tt,10)})};let ee=null;function Gi(w){ee&&ee(w)}function Ci(){wn.stop()}function xh(){wn.start()}let wn=new tf;wn.setAnimationLoop(Gi),typeof self<"u"&&wn.setContext(self),this.setAnimationLoop=function(w){ee=w,it.setAnimationLoop(w),w===null?wn.stop():wn.start()},it.addEventListener("sessionstart",Ci),it.addEventListener("sessionend",xh),this.render=function(w,U){if(U!==void 0&&U.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),U.parent===null&&U.matrixWorldAutoUpdate===!0&&U.updateMatrixWorld(),it.enabled===!0&&it.isPresenting===!0&&(it.cameraAutoUpdate===!0&&it.updateCamera(U),U=it.getCamera()),w.isScene===!0&&w.onBeforeRender(S,w,U,k),d=St.get(w,E.length),d.init(U),E.push(d),J.multiplyMatrices(U.projectionMatrix,U.matrixWorldInverse),fe.setFromProjectionMatrix(J,wi,U.reversedDepth),$=this.localClippingEnabled,te=st.init(this.clippingPlanes,$),g=W.get(w,R.length),g.init(),R.push(g),it.enabled===!0&&it.isPresenting===!0){let tt=S.xr.getDepthSensingMesh();tt!==null&&Cl(tt,U,-1/0,S.sortObjects)}Cl(w,U,0,S.sortObjects),g.finish(),S.sortObjects===!0&&g.sort(lt,dt),jt=it.enabled===!1||it.isPresenting===!1||it.hasDepthSensing()===!1,jt&&bt.addToRenderList(g,w),this.info.render.frame++,te===!0&&st.beginShadows();let z=d.state.shadowsArray;xt.render(z,w,U),te===!0&&st.endShadows(),this.info.autoReset===!0&&this.info.reset();let H=g.opaque,N=g.transmissive;if(d.setupLights(),U.isArrayCamera){let tt=U.cameras;if(N.length>0)for(let ht=0,gt=tt.length;ht<gt;ht++){let ft=tt[ht];Mh(H,N,w,ft)}jt&&bt.render(w);for(let ht=0,gt=tt.length;ht<gt;ht++){let ft=tt[ht];bh(g,w,ft,ft.viewport)}}else N.length>0&&Mh(H,N,w,U),jt&&bt.render(w),bh(g,w,U);k!==null&&D===0&&(Gt.updateMultisampleRenderTarget(k),Gt.updateRenderTargetMipmap(k)),w.isScene===!0&&w.onAfterRender(S,w,U),ct.resetDefaultState(),x=-1,b=null,E.pop(),E.length>0?(d=E[E.length-1],te===!0&&st.setGlobalState(S.clippingPlanes,d.state.camera)):d=null,R.pop(),R.length>0?g=R[R.length-1]:g=null};function Cl(w,U,z,H){if(w.visible===!1)return;if(w.layers.test(U.layers)){if(w.isGroup)z=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(U);else if(w.isLight)d.pushLight(w),w.castShadow&&d.pushShadow(w);else if(w.isSprite){if(!w.frustumCulled||fe.intersectsSprite(w)){H&&Nt.setFromMatrixPosition(w.matrixWorld).applyMatrix4(J);let ht=O.update(w),gt=w.material;gt.visible&&g.push(w,ht,gt,z,Nt.z,null)}}else if((w.isMesh||w.isLine||w.isPoints)&&(!w.frustumCulled||fe.intersectsObject(w))){let ht=O.update(w),gt=w.material;if(H&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),Nt.copy(w.boundingSphere.center)):(ht.boundingSphere===null&&ht.computeBoundingSphere(),Nt.copy(ht.boundingSphere.center)),Nt.applyMatrix4(w.matrixWorld).applyMatrix4(J)),Array.isArray(gt)){let ft=ht.groups;for(let Pt=0,Dt=ft.length;Pt<Dt;Pt++){let Rt=ft[Pt],$t=gt[Rt.materialIndex];$t&&$t.visible&&g.push(w,ht,$t,z,Nt.z,Rt)}}else gt.visible&&g.push(w,ht,gt,z,Nt.z,null)}}let tt=w.children;for(let ht=0,gt=tt.length;ht<gt;ht++)Cl(tt[ht],U,z,H)}function bh(w,U,z,H){let N=w.opaque,tt=w.transmissive,ht=w.transparent;d.setupLightsView(z),te===!0&&st.setGlobalState(S.clippingPlanes,z),H&&vt.viewport(C.copy(H)),N.length>0&&Or(N,U,z),tt.length>0&&Or(tt,U,z),ht.length>0&&Or(ht,U,z),vt.buffers.depth.setTest(!0),vt.buffers.depth.setMask(!0),vt.buffers.color.setMask(!0),vt.setPolygonOffset(!1)}function Mh(w,U,z,H){if((z.isScene===!0?z.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[H.id]===void 0&&(d.state.transmissionRenderTarget[H.id]=new Di(1,1,{generateMipmaps:!0,type:Bt.has("EXT_color_buffer_half_float")||Bt.has("EXT_color_buffer_float")?Ss:zi,minFilter:xn,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:Jt.workingColorSpace}));let tt=d.state.transmissionRenderTarget[H.id],ht=H.viewport||C;tt.setSize(ht.z*S.transmissionResolutionScale,ht.w*S.transmissionResolutionScale);let gt=S.getRenderTarget(),ft=S.getActiveCubeFace(),Pt=S.getActiveMipmapLevel();S.setRenderTarget(tt),S.getClearColor(X),K=S.getClearAlpha(),K<1&&S.setClearColor(16777215,.5),S.clear(),jt&&bt.render(z);let Dt=S.toneMapping;S.toneMapping=en;let Rt=H.viewport;if(H.viewport!==void 0&&(H.viewport=void 0),d.setupLightsView(H),te===!0&&st.setGlobalState(S.clippingPlanes,H),Or(w,z,H),Gt.updateMultisampleRenderTarget(tt),Gt.updateRenderTargetMipmap(tt),Bt.has("WEBGL_multisampled_render_to_texture")===!1){let $t=!1;for(let se=0,ve=U.length;se<ve;se++){let ue=U[se],oe=ue.object,Ct=ue.geometry,ge=ue.material,Qt=ue.group;if(ge.side===Bi&&oe.layers.test(H.layers)){let ni=ge.side;ge.side=Je,ge.needsUpdate=!0,wh(oe,z,H,Ct,ge,Qt),ge.side=ni,ge.needsUpdate=!0,$t=!0}}$t===!0&&(Gt.updateMultisampleRenderTarget(tt),Gt.updateRenderTargetMipmap(tt))}S.setRenderTarget(gt,ft,Pt),S.setClearColor(X,K),Rt!==void 0&&(H.viewport=Rt),S.toneMapping=Dt}function Or(w,U,z){let H=U.isScene===!0?U.overrideMaterial:null;for(let N=0,tt=w.length;N<tt;N++){let ht=w[N],gt=ht.object,ft=ht.geometry,Pt=ht.group,Dt=ht.material;Dt.allowOverride===!0&&H!==null&&(Dt=H),gt.layers.test(z.layers)&&wh(gt,U,z,ft,Dt,Pt)}}function wh(w,U,z,H,N,tt){w.onBeforeRender(S,U,z,H,N,tt),w.modelViewMatrix.multiplyMatrices(z.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),N.onBeforeRender(S,U,z,H,w,tt),N.transparent===!0&&N.side===Bi&&N.forceSinglePass===!1?(N.side=Je,N.needsUpdate=!0,S.renderBufferDirect(z,U,H,N,w,tt),N.side=Ji,N.needsUpdate=!0,S.renderBufferDirect(z,U,H,N,w,tt),N.side=Bi):S.renderBufferDirect(z,U,H,N,w,tt),w.onAfterRender(S,U,z,H,N,tt)}function kr(w,U,z){U.isScene!==!0&&(U=Et);let H=yt.get(w),N=d.state.lights,tt=d.state.shadowsArray,ht=N.state.version,gt=q.getParameters(w,N.state,tt,U,z),ft=q.getProgramCacheKey(gt),Pt=H.programs;H.environment=w.isMeshStandardMaterial?U.environment:null,H.fog=U.fog,H.envMap=(w.isMeshStandardMaterial?Se:Pe).get(w.envMap||H.environment),H.envMapRotation=H.environment!==null&&w.envMap===null?U.environmentRotation:w.envMapRotation,Pt===void 0&&(w.addEventListener("dispose",Z),Pt=new Map,H.programs=Pt);let Dt=Pt.get(ft);if(Dt!==void 0){if(H.currentProgram===Dt&&H.lightsStateVersion===ht)return Eh(w,gt),Dt}else gt.uniforms=q.getUniforms(w),w.onBeforeCompile(gt,S),Dt=q.acquireProgram(gt,ft),Pt.set(ft,Dt),H.uniforms=gt.uniforms;let Rt=H.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Rt.clippingPlanes=st.uniform),Eh(w,gt),H.needsLights=Tf(w),H.lightsStateVersion=ht,H.needsLights&&(Rt.ambientLightColor.value=N.state.ambient,Rt.lightProbe.value=N.state.probe,Rt.directionalLights.value=N.state.directional,Rt.directionalLightShadows.value=N.state.directionalShadow,Rt.spotLights.value=N.state.spot,Rt.spotLightShadows.value=N.state.spotShadow,Rt.rectAreaLights.value=N.state.rectArea,Rt.ltc_1.value=N.state.rectAreaLTC1,Rt.ltc_2.value=N.state.rectAreaLTC2,Rt.pointLights.value=N.state.point,Rt.pointLightShadows.value=N.state.pointShadow,Rt.hemisphereLights.value=N.state.hemi,Rt.directionalShadowMap.value=N.state.directionalShadowMap,Rt.directionalShadowMatrix.value=N.state.directionalShadowMatrix,Rt.spotShadowMap.value=N.state.spotShadowMap,Rt.spotLightMatrix.value=N.state.spotLightMatrix,Rt.spotLightMap.value=N.state.spotLightMap,Rt.pointShadowMap.value=N.state.pointShadowMap,Rt.pointShadowMatrix.value=N.state.pointShadowMatrix),H.currentProgram=Dt,H.uniformsList=null,Dt}function Sh(w){if(w.uniformsList===null){let U=w.currentProgram.getUniforms();w.uniformsList=Ps.seqWithValue(U.seq,w.uniforms)}return w.uniformsList}function Eh(w,U){let z=yt.get(w);z.outputColorSpace=U.outputColorSpace,z.batching=U.batching,z.batchingColor=U.batchingColor,z.instancing=U.instancing,z.instancingColor=U.instancingColor,z.instancingMorph=U.instancingMorph,z.skinning=U.skinning,z.morphTargets=U.morphTargets,z.morphNormals=U.morphNormals,z.morphColors=U.morphColors,z.morphTargetsCount=U.morphTargetsCount,z.numClippingPlanes=U.numClippingPlanes,z.numIntersection=U.numClipIntersection,z.vertexAlphas=U.vertexAlphas,z.vertexTangents=U.vertexTangents,z.toneMapping=U.toneMapping}function Sf(w,U,z,H,N){U.isScene!==!0&&(U=Et),Gt.resetTextureUnits();let tt=U.fog,ht=H.isMeshStandardMaterial?U.environment:null,gt=k===null?S.outputColorSpace:k.isXRRenderTarget===!0?k.texture.colorSpace:On,ft=(H.isMeshStandardMaterial?Se:Pe).get(H.envMap||ht),Pt=H.vertexColors===!0&&!!z.attributes.color&&z.attributes.color.itemSize===4,Dt=!!z.attributes.tangent&&(!!H.normalMap||H.anisotropy>0),Rt=!!z.morphAttributes.position,$t=!!z.morphAttributes.normal,se=!!z.morphAttributes.color,ve=en;H.toneMapped&&(k===null||k.isXRRenderTarget===!0)&&(ve=S.toneMapping);let ue=z.morphAttributes.position||z.morphAttributes.normal||z.morphAttributes.color,oe=ue!==void 0?ue.length:0,Ct=yt.get(H),ge=d.state.lights;if(te===!0&&($===!0||w!==b)){let Ye=w===b&&H.id===x;st.setState(H,w,Ye)}let Qt=!1;H.version===Ct.__version?(Ct.needsLights&&Ct.lightsStateVersion!==ge.state.version||Ct.outputColorSpace!==gt||N.isBatchedMesh&&Ct.batching===!1||!N.isBatchedMesh&&Ct.batching===!0||N.isBatchedMesh&&Ct.batchingColor===!0&&N.colorTexture===null||N.isBatchedMesh&&Ct.batchingColor===!1&&N.colorTexture!==null||N.isInstancedMesh&&Ct.instancing===!1||!N.isInstancedMesh&&Ct.instancing===!0||N.isSkinnedMesh&&Ct.skinning===!1||!N.isSkinnedMesh&&Ct.skinning===!0||N.isInstancedMesh&&Ct.instancingColor===!0&&N.instanceColor===null||N.isInstancedMesh&&Ct.instancingColor===!1&&N.instanceColor!==null||N.isInstancedMesh&&Ct.instancingMorph===!0&&N.morphTexture===null||N.isInstancedMesh&&Ct.instancingMorph===!1&&N.morphTexture!==null||Ct.envMap!==ft||H.fog===!0&&Ct.fog!==tt||Ct.numClippingPlanes!==void 0&&(Ct.numClippingPlanes!==st.numPlanes||Ct.numIntersection!==st.numIntersection)||Ct.vertexAlphas!==Pt||Ct.vertexTangents!==Dt||Ct.morphTargets!==Rt||Ct.morphNormals!==$t||Ct.morphColors!==se||Ct.toneMapping!==ve||Ct.morphTargetsCount!==oe)&&(Qt=!0):(Qt=!0,Ct.__version=H.version);let ni=Ct.currentProgram;Qt===!0&&(ni=kr(H,U,N));let $n=!1,si=!1,Ds=!1,_e=ni.getUniforms(),ui=Ct.uniforms;if(vt.useProgram(ni.program)&&($n=!0,si=!0,Ds=!0),H.id!==x&&(x=H.id,si=!0),$n||b!==w){vt.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),_e.setValue(A,"projectionMatrix",w.projectionMatrix),_e.setValue(A,"viewMatrix",w.matrixWorldInverse);let Qe=_e.map.cameraPosition;Qe!==void 0&&Qe.setValue(A,mt.setFromMatrixPosition(w.matrixWorld)),Lt.logarithmicDepthBuffer&&_e.setValue(A,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(H.isMeshPhongMaterial||H.isMeshToonMaterial||H.isMeshLambertMaterial||H.isMeshBasicMaterial||H.isMeshStandardMaterial||H.isShaderMaterial)&&_e.setValue(A,"isOrthographic",w.isOrthographicCamera===!0),b!==w&&(b=w,si=!0,Ds=!0)}if(N.isSkinnedMesh){_e.setOptional(A,N,"bindMatrix"),_e.setOptional(A,N,"bindMatrixInverse");let Ye=N.skeleton;Ye&&(Ye.boneTexture===null&&Ye.computeBoneTexture(),_e.setValue(A,"boneTexture",Ye.boneTexture,Gt))}N.isBatchedMesh&&(_e.setOptional(A,N,"batchingTexture"),_e.setValue(A,"batchingTexture",N._matricesTexture,Gt),_e.setOptional(A,N,"batchingIdTexture"),_e.setValue(A,"batchingIdTexture",N._indirectTexture,Gt),_e.setOptional(A,N,"batchingColorTexture"),N._colorsTexture!==null&&_e.setValue(A,"batchingColorTexture",N._colorsTexture,Gt));let di=z.morphAttributes;if((di.position!==void 0||di.normal!==void 0||di.color!==void 0)&&et.update(N,z,ni),(si||Ct.receiveShadow!==N.receiveShadow)&&(Ct.receiveShadow=N.receiveShadow,_e.setValue(A,"receiveShadow",N.receiveShadow)),H.isMeshGouraudMaterial&&H.envMap!==null&&(ui.envMap.value=ft,ui.flipEnvMap.value=ft.isCubeTexture&&ft.isRenderTargetTexture===!1?-1:1),H.isMeshStandardMaterial&&H.envMap===null&&U.environment!==null&&(ui.envMapIntensity.value=U.environmentIntensity),si&&(_e.setValue(A,"toneMappingExposure",S.toneMappingExposure),Ct.needsLights&&Ef(ui,Ds),tt&&H.fog===!0&&j.refreshFogUniforms(ui,tt),j.refreshMaterialUniforms(ui,H,G,nt,d.state.transmissionRenderTarget[w.id]),Ps.upload(A,Sh(Ct),ui,Gt)),H.isShaderMaterial&&H.uniformsNeedUpdate===!0&&(Ps.upload(A,Sh(Ct),ui,Gt),H.uniformsNeedUpdate=!1),H.isSpriteMaterial&&_e.setValue(A,"center",N.center),_e.setValue(A,"modelViewMatrix",N.modelViewMatrix),_e.setValue(A,"normalMatrix",N.normalMatrix),_e.setValue(A,"modelMatrix",N.matrixWorld),H.isShaderMaterial||H.isRawShaderMaterial){let Ye=H.uniformsGroups;for(let Qe=0,Pl=Ye.length;Qe<Pl;Qe++){let Sn=Ye[Qe];Vt.update(Sn,ni),Vt.bind(Sn,ni)}}return ni}function Ef(w,U){w.ambientLightColor.needsUpdate=U,w.lightProbe.needsUpdate=U,w.directionalLights.needsUpdate=U,w.directionalLightShadows.needsUpdate=U,w.pointLights.needsUpdate=U,w.pointLightShadows.needsUpdate=U,w.spotLights.needsUpdate=U,w.spotLightShadows.needsUpdate=U,w.rectAreaLights.needsUpdate=U,w.hemisphereLights.needsUpdate=U}function Tf(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return P},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return k},this.setRenderTargetTextures=function(w,U,z){let H=yt.get(w);H.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,H.__autoAllocateDepthBuffer===!1&&(H.__useRenderToTexture=!1),yt.get(w.texture).__webglTexture=U,yt.get(w.depthTexture).__webglTexture=H.__autoAllocateDepthBuffer?void 0:z,H.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,U){let z=yt.get(w);z.__webglFramebuffer=U,z.__useDefaultFramebuffer=U===void 0};let Af=A.createFramebuffer();this.setRenderTarget=function(w,U=0,z=0){k=w,P=U,D=z;let H=!0,N=null,tt=!1,ht=!1;if(w){let ft=yt.get(w);if(ft.__useDefaultFramebuffer!==void 0)vt.bindFramebuffer(A.FRAMEBUFFER,null),H=!1;else if(ft.__webglFramebuffer===void 0)Gt.setupRenderTarget(w);else if(ft.__hasExternalTextures)Gt.rebindTextures(w,yt.get(w.texture).__webglTexture,yt.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let Rt=w.depthTexture;if(ft.__boundDepthTexture!==Rt){if(Rt!==null&&yt.has(Rt)&&(w.width!==Rt.image.width||w.height!==Rt.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");Gt.setupDepthRenderbuffer(w)}}let Pt=w.texture;(Pt.isData3DTexture||Pt.isDataArrayTexture||Pt.isCompressedArrayTexture)&&(ht=!0);let Dt=yt.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Dt[U])?N=Dt[U][z]:N=Dt[U],tt=!0):w.samples>0&&Gt.useMultisampledRTT(w)===!1?N=yt.get(w).__webglMultisampledFramebuffer:Array.isArray(Dt)?N=Dt[z]:N=Dt,C.copy(w.viewport),B.copy(w.scissor),V=w.scissorTest}else C.copy(At).multiplyScalar(G).floor(),B.copy(Yt).multiplyScalar(G).floor(),V=le;if(z!==0&&(N=Af),vt.bindFramebuffer(A.FRAMEBUFFER,N)&&H&&vt.drawBuffers(w,N),vt.viewport(C),vt.scissor(B),vt.setScissorTest(V),tt){let ft=yt.get(w.texture);A.framebufferTexture2D(A.FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.TEXTURE_CUBE_MAP_POSITIVE_X+U,ft.__webglTexture,z)}else if(ht){let ft=U;for(let Pt=0;Pt<w.textures.length;Pt++){let Dt=yt.get(w.textures[Pt]);A.framebufferTextureLayer(A.FRAMEBUFFER,A.COLOR_ATTACHMENT0+Pt,Dt.__webglTexture,z,ft)}}else if(w!==null&&z!==0){let ft=yt.get(w.texture);A.framebufferTexture2D(A.FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.TEXTURE_2D,ft.__webglTexture,z)}x=-1},this.readRenderTargetPixels=function(w,U,z,H,N,tt,ht,gt=0){if(!(w&&w.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ft=yt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&ht!==void 0&&(ft=ft[ht]),ft){vt.bindFramebuffer(A.FRAMEBUFFER,ft);try{let Pt=w.textures[gt],Dt=Pt.format,Rt=Pt.type;if(!Lt.textureFormatReadable(Dt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Lt.textureTypeReadable(Rt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}U>=0&&U<=w.width-H&&z>=0&&z<=w.height-N&&(w.textures.length>1&&A.readBuffer(A.COLOR_ATTACHMENT0+gt),A.readPixels(U,z,H,N,Mt.convert(Dt),Mt.convert(Rt),tt))}finally{let Pt=k!==null?yt.get(k).__webglFramebuffer:null;vt.bindFramebuffer(A.FRAMEBUFFER,Pt)}}},this.readRenderTargetPixelsAsync=async function(w,U,z,H,N,tt,ht,gt=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ft=yt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&ht!==void 0&&(ft=ft[ht]),ft)if(U>=0&&U<=w.width-H&&z>=0&&z<=w.height-N){vt.bindFramebuffer(A.FRAMEBUFFER,ft);let Pt=w.textures[gt],Dt=Pt.format,Rt=Pt.type;if(!Lt.textureFormatReadable(Dt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Lt.textureTypeReadable(Rt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let $t=A.createBuffer();A.bindBuffer(A.PIXEL_PACK_BUFFER,$t),A.bufferData(A.PIXEL_PACK_BUFFER,tt.byteLength,A.STREAM_READ),w.textures.length>1&&A.readBuffer(A.COLOR_ATTACHMENT0+gt),A.readPixels(U,z,H,N,Mt.convert(Dt),Mt.convert(Rt),0);let se=k!==null?yt.get(k).__webglFramebuffer:null;vt.bindFramebuffer(A.FRAMEBUFFER,se);let ve=A.fenceSync(A.SYNC_GPU_COMMANDS_COMPLETE,0);return A.flush(),await Ad(A,ve,4),A.bindBuffer(A.PIXEL_PACK_BUFFER,$t),A.getBufferSubData(A.PIXEL_PACK_BUFFER,0,tt),A.deleteBuffer($t),A.deleteSync(ve),tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,U=null,z=0){let H=Math.pow(2,-z),N=Math.floor(w.image.width*H),tt=Math.floor(w.image.height*H),ht=U!==null?U.x:0,gt=U!==null?U.y:0;Gt.setTexture2D(w,0),A.copyTexSubImage2D(A.TEXTURE_2D,z,0,0,ht,gt,N,tt),vt.unbindTexture()};let Rf=A.createFramebuffer(),Cf=A.createFramebuffer();this.copyTextureToTexture=function(w,U,z=null,H=null,N=0,tt=null){tt===null&&(N!==0?(vs("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),tt=N,N=0):tt=0);let ht,gt,ft,Pt,Dt,Rt,$t,se,ve,ue=w.isCompressedTexture?w.mipmaps[tt]:w.image;if(z!==null)ht=z.max.x-z.min.x,gt=z.max.y-z.min.y,ft=z.isBox3?z.max.z-z.min.z:1,Pt=z.min.x,Dt=z.min.y,Rt=z.isBox3?z.min.z:0;else{let di=Math.pow(2,-N);ht=Math.floor(ue.width*di),gt=Math.floor(ue.height*di),w.isDataArrayTexture?ft=ue.depth:w.isData3DTexture?ft=Math.floor(ue.depth*di):ft=1,Pt=0,Dt=0,Rt=0}H!==null?($t=H.x,se=H.y,ve=H.z):($t=0,se=0,ve=0);let oe=Mt.convert(U.format),Ct=Mt.convert(U.type),ge;U.isData3DTexture?(Gt.setTexture3D(U,0),ge=A.TEXTURE_3D):U.isDataArrayTexture||U.isCompressedArrayTexture?(Gt.setTexture2DArray(U,0),ge=A.TEXTURE_2D_ARRAY):(Gt.setTexture2D(U,0),ge=A.TEXTURE_2D),A.pixelStorei(A.UNPACK_FLIP_Y_WEBGL,U.flipY),A.pixelStorei(A.UNPACK_PREMULTIPLY_ALPHA_WEBGL,U.premultiplyAlpha),A.pixelStorei(A.UNPACK_ALIGNMENT,U.unpackAlignment);let Qt=A.getParameter(A.UNPACK_ROW_LENGTH),ni=A.getParameter(A.UNPACK_IMAGE_HEIGHT),$n=A.getParameter(A.UNPACK_SKIP_PIXELS),si=A.getParameter(A.UNPACK_SKIP_ROWS),Ds=A.getParameter(A.UNPACK_SKIP_IMAGES);A.pixelStorei(A.UNPACK_ROW_LENGTH,ue.width),A.pixelStorei(A.UNPACK_IMAGE_HEIGHT,ue.height),A.pixelStorei(A.UNPACK_SKIP_PIXELS,Pt),A.pixelStorei(A.UNPACK_SKIP_ROWS,Dt),A.pixelStorei(A.UNPACK_SKIP_IMAGES,Rt);let _e=w.isDataArrayTexture||w.isData3DTexture,ui=U.isDataArrayTexture||U.isData3DTexture;if(w.isDepthTexture){let di=yt.get(w),Ye=yt.get(U),Qe=yt.get(di.__renderTarget),Pl=yt.get(Ye.__renderTarget);vt.bindFramebuffer(A.READ_FRAMEBUFFER,Qe.__webglFramebuffer),vt.bindFramebuffer(A.DRAW_FRAMEBUFFER,Pl.__webglFramebuffer);for(let Sn=0;Sn<ft;Sn++)_e&&(A.framebufferTextureLayer(A.READ_FRAMEBUFFER,A.COLOR_ATTACHMENT0,yt.get(w).__webglTexture,N,Rt+Sn),A.framebufferTextureLayer(A.DRAW_FRAMEBUFFER,A.COLOR_ATTACHMENT0,yt.get(U).__webglTexture,tt,ve+Sn)),A.blitFramebuffer(Pt,Dt,ht,gt,$t,se,ht,gt,A.DEPTH_BUFFER_BIT,A.NEAREST);vt.bindFramebuffer(A.READ_FRAMEBUFFER,null),vt.bindFramebuffer(A.DRAW_FRAMEBUFFER,null)}else if(N!==0||w.isRenderTargetTexture||yt.has(w)){let di=yt.get(w),Ye=yt.get(U);vt.bindFramebuffer(A.READ_FRAMEBUFFER,Rf),vt.bindFramebuffer(A.DRAW_FRAMEBUFFER,Cf);for(let Qe=0;Qe<ft;Qe++)_e?A.framebufferTextureLayer(A.READ_FRAMEBUFFER,A.COLOR_ATTACHMENT0,di.__webglTexture,N,Rt+Qe):A.framebufferTexture2D(A.READ_FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.TEXTURE_2D,di.__webglTexture,N),ui?A.framebufferTextureLayer(A.DRAW_FRAMEBUFFER,A.COLOR_ATTACHMENT0,Ye.__webglTexture,tt,ve+Qe):A.framebufferTexture2D(A.DRAW_FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.TEXTURE_2D,Ye.__webglTexture,tt),N!==0?A.blitFramebuffer(Pt,Dt,ht,gt,$t,se,ht,gt,A.COLOR_BUFFER_BIT,A.NEAREST):ui?A.copyTexSubImage3D(ge,tt,$t,se,ve+Qe,Pt,Dt,ht,gt):A.copyTexSubImage2D(ge,tt,$t,se,Pt,Dt,ht,gt);vt.bindFramebuffer(A.READ_FRAMEBUFFER,null),vt.bindFramebuffer(A.DRAW_FRAMEBUFFER,null)}else ui?w.isDataTexture||w.isData3DTexture?A.texSubImage3D(ge,tt,$t,se,ve,ht,gt,ft,oe,Ct,ue.data):U.isCompressedArrayTexture?A.compressedTexSubImage3D(ge,tt,$t,se,ve,ht,gt,ft,oe,ue.data):A.texSubImage3D(ge,tt,$t,se,ve,ht,gt,ft,oe,Ct,ue):w.isDataTexture?A.texSubImage2D(A.TEXTURE_2D,tt,$t,se,ht,gt,oe,Ct,ue.data):w.isCompressedTexture?A.compressedTexSubImage2D(A.TEXTURE_2D,tt,$t,se,ue.width,ue.height,oe,ue.data):A.texSubImage2D(A.TEXTURE_2D,tt,$t,se,ht,gt,oe,Ct,ue);A.pixelStorei(A.UNPACK_ROW_LENGTH,Qt),A.pixelStorei(A.UNPACK_IMAGE_HEIGHT,ni),A.pixelStorei(A.UNPACK_SKIP_PIXELS,$n),A.pixelStorei(A.UNPACK_SKIP_ROWS,si),A.pixelStorei(A.UNPACK_SKIP_IMAGES,Ds),tt===0&&U.generateMipmaps&&A.generateMipmap(ge),vt.unbindTexture()},this.initRenderTarget=function(w){yt.get(w).__webglFramebuffer===void 0&&Gt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Gt.setTextureCube(w,0):w.isData3DTexture?Gt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Gt.setTexture2DArray(w,0):Gt.setTexture2D(w,0),vt.unbindTexture()},this.resetState=function(){P=0,D=0,k=null,vt.reset(),ct.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return wi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Jt._getDrawingBufferColorSpace(t),e.unpackColorSpace=Jt._getUnpackColorSpace()}};var of={type:"change"},ph={type:"start"},lf={type:"end"},ml=new mn,af=new Ze,I0=Math.cos(70*qc.DEG2RAD),Ce=new F,ii=2*Math.PI,re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},fh=1e-6,gl=class extends Er{constructor(t,e=null){super(t,e),this.state=re.NONE,this.target=new F,this.cursor=new F,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:vn.ROTATE,MIDDLE:vn.DOLLY,RIGHT:vn.PAN},this.touches={ONE:yn.ROTATE,TWO:yn.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new F,this._lastQuaternion=new mi,this._lastTargetPosition=new F,this._quat=new mi().setFromUnitVectors(t.up,new F(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ms,this._sphericalDelta=new Ms,this._scale=1,this._panOffset=new F,this._rotateStart=new zt,this._rotateEnd=new zt,this._rotateDelta=new zt,this._panStart=new zt,this._panEnd=new zt,this._panDelta=new zt,this._dollyStart=new zt,this._dollyEnd=new zt,this._dollyDelta=new zt,this._dollyDirection=new F,this._mouse=new zt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=D0.bind(this),this._onPointerDown=L0.bind(this),this._onPointerUp=U0.bind(this),this._onContextMenu=H0.bind(this),this._onMouseWheel=O0.bind(this),this._onKeyDown=k0.bind(this),this._onTouchStart=B0.bind(this),this._onTouchMove=z0.bind(this),this._onMouseDown=N0.bind(this),this._onMouseMove=F0.bind(this),this._interceptControlDown=V0.bind(this),this._interceptControlUp=G0.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(of),this.update(),this.state=re.NONE}update(t=null){let e=this.object.position;Ce.copy(e).sub(this.target),Ce.applyQuaternion(this._quat),this._spherical.setFromVector3(Ce),this.autoRotate&&this.state===re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ii:i>Math.PI&&(i-=ii),s<-Math.PI?s+=ii:s>Math.PI&&(s-=ii),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Ce.setFromSpherical(this._spherical),Ce.applyQuaternion(this._quatInverse),e.copy(this.target).add(Ce),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Ce.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new F(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new F(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Ce.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(ml.origin.copy(this.object.position),ml.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(ml.direction))<I0?this.object.lookAt(this.target):(af.setFromNormalAndCoplanarPoint(this.object.up,this.target),ml.intersectPlane(af,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>fh||8*(1-this._lastQuaternion.dot(this.object.quaternion))>fh||this._lastTargetPosition.distanceToSquared(this.target)>fh?(this.dispatchEvent(of),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ii/60*this.autoRotateSpeed*t:ii/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Ce.setFromMatrixColumn(e,0),Ce.multiplyScalar(-t),this._panOffset.add(Ce)}_panUp(t,e){this.screenSpacePanning===!0?Ce.setFromMatrixColumn(e,1):(Ce.setFromMatrixColumn(e,0),Ce.crossVectors(this.object.up,Ce)),Ce.multiplyScalar(t),this._panOffset.add(Ce)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Ce.copy(s).sub(this.target);let r=Ce.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientX),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ii*this._rotateDelta.x/e.clientHeight),this._rotateUp(ii*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ii*this._rotateDelta.x/e.clientHeight),this._rotateUp(ii*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new zt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function L0(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n)))}function D0(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function U0(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(lf),this.state=re.NONE;break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function N0(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case vn.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=re.DOLLY;break;case vn.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=re.ROTATE}break;case vn.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=re.PAN}break;default:this.state=re.NONE}this.state!==re.NONE&&this.dispatchEvent(ph)}function F0(n){switch(this.state){case re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function O0(n){this.enabled===!1||this.enableZoom===!1||this.state!==re.NONE||(n.preventDefault(),this.dispatchEvent(ph),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(lf))}function k0(n){this.enabled!==!1&&this._handleKeyDown(n)}function B0(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case yn.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(n),this.state=re.TOUCH_ROTATE;break;case yn.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(n),this.state=re.TOUCH_PAN;break;default:this.state=re.NONE}break;case 2:switch(this.touches.TWO){case yn.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=re.TOUCH_DOLLY_PAN;break;case yn.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=re.TOUCH_DOLLY_ROTATE;break;default:this.state=re.NONE}break;default:this.state=re.NONE}this.state!==re.NONE&&this.dispatchEvent(ph)}function z0(n){switch(this._trackPointer(n),this.state){case re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=re.NONE}}function H0(n){this.enabled!==!1&&n.preventDefault()}function V0(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function G0(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function cf(){let n=document.createElement("canvas");n.width=n.height=64;let t=n.getContext("2d");return t.fillStyle="#fff",t.beginPath(),t.arc(32,32,30,0,7),t.fill(),new _r(n)}function _i(n){return new we().setAttribute("position",new be(n,3))}function hf(n){let t=[0,1,0,2,0,3,0,4,1,2,2,3,3,4,4,1],e=n.length/15,i=new Float32Array(e*t.length*3);for(let s=0;s<e;s++)t.forEach((r,o)=>{let a=15*s+3*r;i.set(n.subarray(a,a+3),3*(s*t.length+o))});return i}function uf(n){let t=new mr(new br(1,16,12),new Mr({color:11883306,transparent:!0,opacity:.45,depthWrite:!1}),n);return t.frustumCulled=!1,t}function df(n,t,e,i,s){let r=new ae;for(let o=0;o<e.length;o++){let a=i.subarray(9*o,9*o+9),l=3*e[o];r.set(a[0]*s,a[3]*s,a[6]*s,t[l],a[1]*s,a[4]*s,a[7]*s,t[l+1],a[2]*s,a[5]*s,a[8]*s,t[l+2],0,0,0,1),n.setMatrixAt(o,r)}n.instanceMatrix.needsUpdate=!0}function mh(n,t,e,i,s,r=9,o=()=>!0){let a=new ae().multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse).elements,l=null,c=r*r;for(let h=0;h<n.length;h+=t){let u=n[h],f=n[h+1],m=n[h+2],v=a[3]*u+a[7]*f+a[11]*m+a[15];if(v<=0)continue;let M=((a[0]*u+a[4]*f+a[8]*m+a[12])/v+1)/2*i.width-s[0],g=(1-(a[1]*u+a[5]*f+a[9]*m+a[13])/v)/2*i.height-s[1],d=M*M+g*g;d<c&&o(u,f,m)&&(c=d,l=h/t)}return l}var _l=class{constructor(t,e){this.boxes=new Map;this.select=p("select",{id:"space-colour"},...xe(["role","rays","sigma","w","redundancy","residual"],t=>_("studio_space.colouring",{by:t})));this.scale=p("input",{type:"range",id:"ellipsoid-scale",min:-20,max:20,value:0});this.scaleWords=p("output",{for:"ellipsoid-scale"});this.typicalSize=1;let i=(s,r)=>{let o=p("input",{type:"checkbox",id:`show-${s}`,checked:r});return o.addEventListener("change",t),this.boxes.set(s,o),p("label",{},o,_("studio_space.shown",{name:s}))};this.select.addEventListener("change",t),this.scale.addEventListener("input",()=>{this.showScale(),t()}),this.parts=[p("label",{},_("studio_space.colour"),this.select),i("points",!0),i("stations",!0),i("bars",!0),i("ellipsoids",!1),p("label",{title:_("studio_space.enlargement")},"\xD7",this.scale,this.scaleWords),Ut("studio_space.all",e)]}shows(t){return this.boxes.get(t).checked}get colouring(){return this.select.value}set typical(t){this.typicalSize=t,this.showScale()}get enlarged(){return this.typicalSize*10**(Number(this.scale.value)/10)}showScale(){this.scaleWords.textContent=ri(String(Number(this.enlarged.toPrecision(2))))}};var W0={f4:Float32Array,u1:Uint8Array,u2:Uint16Array,u4:Uint32Array},vl=class{constructor(t){this.rows=null;let e=new DataView(t).getUint32(0,!0);this.head=JSON.parse(new TextDecoder().decode(new Uint8Array(t,4,e)));let i=new Map,s=4+e;for(let{name:o,kind:a,shape:l}of this.head.arrays){let c=W0[a],h=l.reduce((u,f)=>u*f,1);i.set(o,new c(t,s,h)),s+=Math.ceil(h*c.BYTES_PER_ELEMENT/4)*4}let r=(o,a)=>i.get(o)??a;this.xyz=r("xyz",new Float32Array(0)),this.role=r("role",new Uint8Array(0)),this.rays=r("rays",new Uint16Array(0)),this.sigma=r("sigma",new Float32Array(0)),this.w=r("w",new Float32Array(0)),this.r=r("r",new Float32Array(0)),this.v=r("v",new Float32Array(0)),this.centre=r("centre",new Float32Array(0)),this.ellipsoid=r("ellipsoid_of",new Uint32Array(0)),this.axes=r("ellipsoid",new Float32Array(0)),this.bars=r("bars",new Uint32Array(0)),this.pairs=r("pair",new Uint32Array(0)),this.common=r("common",new Uint32Array(0)),this.frusta=this.pyramids(r("frustum",new Float32Array(0)))}pyramids(t){let e=new Float32Array(5*this.centre.length);for(let i=0;i<this.centre.length/3;i++)e.set(this.centre.subarray(3*i,3*i+3),15*i),e.set(t.subarray(12*i,12*i+12),15*i+3);return e}get points(){return this.role.length}nameOf(t){return this.head.names[t]??""}rowOf(t){return this.rows??=new Map(this.head.names.map((e,i)=>[e,i])),this.rows.get(t)}centreOf(t){let e=this.head.image_ids.indexOf(t);return e<0?null:this.centre.subarray(3*e,3*e+3)}at(t){return this.xyz.subarray(3*t,3*t+3)}};var X0=["","coordinates","distance","angle","area","length","plane","line","to_plane","to_line"],gh=6,ff=n=>_("studio_space.quantity",{kind:n||"any"}),yl=class{constructor(t,e){this.changed=e;this.names=[];this.words="";this.box=p("input",{type:"checkbox",id:"space-measure"});this.kind=p("select",{id:"space-kind","aria-label":_("studio_space.measured")},...xe(X0,ff));this.turn=0;this.box.addEventListener("change",()=>this.clear()),this.kind.addEventListener("change",()=>void this.answer()),this.parts=[p("span",{class:"group"},p("label",{title:Oe("studio_space.measure")},this.box,_("studio_space.measure")),this.kind,Ut("studio_space.add_current",()=>t.current&&this.add(t.current)),Ut("studio_space.clear",()=>this.clear()))]}get on(){return this.box.checked}get closed(){return this.what==="area"}get what(){let t=this.names.length;return this.kind.value||(t===1?"coordinates":t===2?"distance":t===3?"angle":"area")}take(t){this.names.some(e=>t.rowOf(e)===void 0)&&this.clear()}add(t){this.names=this.names.includes(t)?this.names.filter(e=>e!==t):[...this.names,t],this.answer()}clear(){this.names=[],this.words=this.on?_("studio_space.click_points"):_("studio_space.click"),this.changed()}async answer(){let t=++this.turn;if(this.words=this.names.join(", "),this.changed(),!!this.names.length){try{let e=await Ft("/api/query",{kind:this.what,points:this.names});if(t!==this.turn)return;let i=e.values.map(({name:r,value:o,sigma:a,unit:l})=>{let c=`${Tt(o,Fe(a))} \xB1 ${Tt(a,Fe(a))}`;return`${e.values.length>1?`${r} `:""}${ye(c,l.replace("^2","\xB2").replace("deg","\xB0"))}`}),s=i.length>gh?` (+${i.length-gh})`:"";this.words=`${ff(this.what)} ${this.names.join(", ")}: ${i.slice(0,gh).join("; ")}${s}${e.remark?`
${e.remark}`:""}`}catch(e){if(t!==this.turn)return;this.words=`${this.names.join(", ")}: ${e.message}`}this.changed()}}};var pf=100,mf=["#882255","#ddaa33","#0072b2"],xl=class{constructor(t){this.changed=t;this.lines=new Qi(new we,new Ai({vertexColors:!0}));this.box=p("input",{type:"checkbox",id:"show-pairs"});this.least=p("input",{type:"range",id:"pairs-least",min:0,max:pf,value:0,"aria-label":_("studio_space.fewest")});this.words=p("output",{for:"pairs-least"});this.data=null;for(let e of[this.box,this.least])e.addEventListener("input",()=>this.show());this.parts=[p("span",{class:"group"},p("label",{title:Oe("studio_space.pairs")},this.box,_("studio_space.pairs")),this.least,this.words)],this.lines.frustumCulled=!1,this.showFewest()}take(t){this.data=t;let{pairs:e,common:i,centre:s,head:r}=t,o=new Float32Array(3*e.length),a=new Float32Array(3*e.length),l=mf.map(c=>new Ot(c));e.forEach((c,h)=>{let u=i[h>>1];o.set(s.subarray(3*c,3*c+3),3*h),l[u<r.few?0:u<r.strong?1:2].toArray(a,3*h)}),this.lines.geometry.dispose(),this.lines.geometry=_i(o).setAttribute("color",new be(a,3)),this.show()}get legend(){if(!this.box.checked||!this.data)return[];let{few:t,strong:e}=this.data.head,i=[0,0,0];for(let r=0;r<this.drawn;r++)i[this.data.common[r]<t?0:this.data.common[r]<e?1:2]++;let s=[_("studio_space.weak_pairs",{limit:t}),`${t}\u2013${e-1}`,`\u2265 ${e}`];return mf.map((r,o)=>[r,`${s[o]}: ${fi(i[o])}`])}get fewest(){return Math.round(Math.max(this.data?.common[0]??1,1)**(Number(this.least.value)/pf))}get drawn(){let{common:t}=this.data,[e,i]=[0,t.length];for(;e<i;){let s=e+i>>1;t[s]>=this.fewest?e=s+1:i=s}return e}show(){this.lines.visible=this.box.checked,this.data&&this.lines.geometry.setDrawRange(0,2*this.drawn),this.showFewest(),this.changed()}showFewest(){this.words.textContent=`\u2265 ${fi(this.fewest)}`,this.least.setAttribute("aria-valuetext",String(this.fewest))}};var bl=["#4f7896","#d55e00","#007f5f"],Ur=["#20406e","#2f86b0","#7fb79a","#e69f00","#c2410c"],gf="#9aa3ab";function vf(n,t){return t==="role"?q0(n):t==="rays"?Nr(n.rays,[2,3,5,9],[...Ur].reverse(),[_("studio_space.few_rays"),"3","4\u20135","6\u20139","\u2265 10"]):t==="w"?Nr(n.w,[1,2,2.6,3.3],Ur,_h(t,"",["1","2","2.6","3.3"])):t==="redundancy"?Nr(n.r,[.1,.3,.5,.7],[...Ur].reverse(),_h(t,"",["0.1","0.3","0.5","0.7"])):t==="residual"?_f(n.v,t,"px"):_f(n.sigma,t,n.head.unit)}function q0(n){let t=vh(bl),e=new Uint32Array(n.points);for(let s=0;s<n.points;s++)e[s]=t[Math.min(n.role[s],2)];let i=["tie","control","check"];return{rgb:new Uint8Array(e.buffer),legend:i.map((s,r)=>[bl[r],_("studio_space.role",{role:s})]).filter((s,r)=>n.role.includes(r))}}function _f(n,t,e){let i=n.filter(r=>r>0).sort();if(!i.length)return Nr(n,[0,0,0,0],Ur,[]);let s=[.2,.4,.6,.8].map(r=>i[Math.floor(r*(i.length-1))]);return Nr(n,s,Ur,_h(t,e,s.map(r=>wt(r,2))))}function _h(n,t,e){let i=e.map(s=>ye(ri(s),t));return[_("studio_space.up_to",{by:n,limit:i[0]}),...i.slice(1).map(s=>`\u2264 ${s}`),`> ${i[3]}`]}function Nr(n,t,e,i){let s=vh(e),[r]=vh([gf]),o=new Uint32Array(n.length),a=!1;for(let c=0;c<n.length;c++){let h=n[c];h>=0||(a=!0);let u=0;for(;u<t.length&&h>t[u];)u++;o[c]=h>=0?s[u]:r}let l=i.map((c,h)=>[e[h],c]);return{rgb:new Uint8Array(o.buffer),legend:a?[...l,[gf,_("studio_space.unknown")]]:l}}function vh(n){let t=new Uint8Array(4*n.length).fill(255);return n.forEach((e,i)=>{let{r:s,g:r,b:o}=new Ot(e);t.set([s,r,o].map(a=>Math.round(255*a)),4*i)}),new Uint32Array(t.buffer)}var Ml=class{constructor(t,e){this.data=t;this.scene=new fr;this.specialRows=[];let i=cf(),s=(l,c={vertexColors:!0})=>new Bn({size:l*Math.min(devicePixelRatio,2),map:i,alphaTest:.4,sizeAttenuation:!1,...c});for(let l=0;l<t.points;l++)t.role[l]>0&&this.specialRows.push(l);let r=t.points>6e4,o=new Bn({size:2*Math.min(devicePixelRatio,2),sizeAttenuation:!1,vertexColors:!0});this.points=new Oi(_i(t.xyz),r?o:s(4)),this.points.geometry.setIndex(new be(Y0(t.points),1)),this.special=new Oi(_i(this.picked(t.xyz)),s(11)),this.stations=new Qi(_i(hf(t.frusta)),new Ai({color:2767433})),this.ellipsoids=uf(t.ellipsoid.length),this.bars=new Qi(_i(this.rowsOf(t.bars)),new Ai({color:32607,linewidth:2})),this.rays=new Qi(new we,new Ai({color:5974662})),this.mark=new Oi(new we,s(14,{color:13385103,depthTest:!1})),this.measured=new kn(new we,new Ai({color:1118481,depthTest:!1})),this.ends=new Oi(new we,s(10,{color:1118481,depthTest:!1})),this.beyond=new Oi(new we,s(8,{color:12720271,depthTest:!1}));for(let l of[this.rays,this.mark,this.measured,this.ends,this.beyond])l.frustumCulled=!1;this.scene.background=new Ot(16250352),this.scene.add(new Sr(16777215,10129280,3),this.points,this.special,this.stations,this.ellipsoids,this.bars,this.rays,this.mark,this.measured,this.ends,this.beyond,e);let a=t.sigma.filter(l=>l>0).sort();this.typical=a.length?.012*t.head.extent/a[Math.floor(a.length/2)]:1,this.enlarge(this.typical)}picked(t){let e=new Float32Array(3*this.specialRows.length);return this.specialRows.forEach((i,s)=>e.set(t.subarray(3*i,3*i+3),3*s)),e}rowsOf(t){let e=new Float32Array(3*t.length);return t.forEach((i,s)=>e.set(this.data.at(i),3*s)),e}thin(t){this.points.geometry.setDrawRange(0,t<1?Math.ceil(t*this.data.points):1/0),this.ellipsoids.count=Math.ceil(t*this.data.ellipsoid.length)}colour(t){let{rgb:e,legend:i}=vf(this.data,t);this.points.geometry.setAttribute("color",new be(e,4,!0));let s=new Float32Array(3*this.specialRows.length),r=bl.map(o=>new Ot(o));return this.specialRows.forEach((o,a)=>r[Math.min(this.data.role[o],2)].toArray(s,3*a)),this.special.geometry.setAttribute("color",new be(s,3)),i}enlarge(t){df(this.ellipsoids,this.data.xyz,this.data.ellipsoid,this.data.axes,t)}current(t,e){this.mark.geometry.dispose(),this.rays.geometry.dispose(),this.mark.geometry=t?_i(new Float32Array(t)):new we;let i=t?e.map(r=>this.data.centreOf(r)).filter(r=>r!==null):[],s=new Float32Array(6*i.length);i.forEach((r,o)=>{s.set(Array.from(t),6*o),s.set(r,6*o+3)}),this.rays.geometry=_i(s)}cut(t){for(let e of[this.points,this.special,this.ellipsoids,this.bars])e.material.clippingPlanes=t}far(t){this.beyond.geometry.dispose(),this.beyond.geometry=_i(this.rowsOf(Uint32Array.from(t)))}between(t,e){let i=e&&t.length>2?[...t,t[0]]:t;this.measured.geometry.dispose(),this.ends.geometry.dispose(),this.measured.geometry=_i(this.rowsOf(Uint32Array.from(i))),this.ends.geometry=_i(this.rowsOf(Uint32Array.from(t)))}dispose(){this.scene.traverse(t=>{(t instanceof Oi||t instanceof kn||t instanceof Xe)&&(t.geometry.dispose(),t.material.dispose())})}};function Y0(n){let t=new Uint32Array(n);for(let i=0;i<n;i++)t[i]=i;let e=1;for(let i=n-1;i>0;i--){e=Math.imul(e,1664525)+1013904223>>>0;let s=Math.floor(e/4294967296*(i+1));[t[i],t[s]]=[t[s],t[i]]}return t}var Mn=200,$0={"":"none",0:"side",1:"front",2:"level",points:"points"},wl=class{constructor(t,e){this.names=t;this.changed=e;this.across=p("select",{id:"section-across"},...xe(["","0","1","2","points"],t=>_("studio_space.across",{across:$0[t]})));this.place=p("input",{type:"range",id:"section-place",min:0,max:Mn,value:Mn/2,"aria-label":_("studio_space.section_place")});this.thick=p("input",{type:"range",id:"section-thickness",min:1,max:Mn,value:Mn/10,"aria-label":_("studio_space.section_thickness")});this.words=p("output",{for:"section-place section-thickness"});this.data=null;this.normal=new F;this.range=[0,0];this.begin=0;this.across.addEventListener("change",()=>this.turn());for(let i of[this.place,this.thick])i.addEventListener("input",()=>this.changed());this.parts=[p("span",{class:"group"},p("label",{title:Oe("studio_space.section")},_("studio_space.section"),this.across),p("label",{title:_("studio_space.section_place")},"\u2194",this.place),p("label",{title:_("studio_space.section_thickness")},"\u2195",this.thick),this.words)],this.place.disabled=this.thick.disabled=!0}take(t){this.data=t,this.turn()}get planes(){if(!this.on)return[];let{middle:t,half:e}=this;return[new Ze(this.normal.clone(),e-t),new Ze(this.normal.clone().negate(),e+t)]}measured(){this.across.value==="points"&&!this.on&&this.turn()}holds(t,e,i){return this.on?Math.abs(this.normal.x*t+this.normal.y*e+this.normal.z*i-this.middle)<=this.half:!0}show(){let t=`\xB1 ${ye(wt(this.half),this.data?.head.unit??"")}`;this.words.textContent=this.across.value?this.on?t:_("studio_space.three_points_first"):""}get on(){return this.across.value!==""&&this.normal.lengthSq()>0}get middle(){let[t,e]=this.range;return t+(e-t)*Number(this.place.value)/Mn}get half(){let[t,e]=this.range;return Math.max(e-t,1e-12)*Number(this.thick.value)/Mn/2}turn(){let t=this.across.value;for(let e of[this.place,this.thick])e.disabled=!t;this.normal.set(0,0,0),this.data&&t==="points"?this.throughPoints(this.data):this.data&&t&&this.normal.set(...this.data.head.basis.slice(3*Number(t),3*Number(t)+3)),this.data&&this.on&&this.ranged(this.data),this.changed()}throughPoints(t){let e=this.names().slice(0,3).map(i=>t.rowOf(i)).filter(i=>i!==void 0).map(i=>new F(...t.at(i)));if(!(e.length<3)){if(this.normal.crossVectors(e[1].clone().sub(e[0]),e[2].clone().sub(e[0])),this.normal.length()<1e-9*t.head.extent**2)return void this.normal.set(0,0,0);this.normal.normalize(),this.begin=this.normal.dot(e[0])}}ranged(t){let e=Math.max(Math.floor(t.points/2e4),1),i=[];for(let a=0;a<t.points;a+=e){let[l,c,h]=t.at(a);i.push(this.normal.x*l+this.normal.y*c+this.normal.z*h)}if(i.sort((a,l)=>a-l),this.range=i.length?[i[Math.floor(.01*i.length)],i[Math.ceil(.99*i.length)-1]]:[0,0],this.across.value!=="points")return;let[s,r]=this.range,o=Math.max(r-this.begin,this.begin-s,1e-9*t.head.extent);this.range=[this.begin-o,this.begin+o],this.place.value=String(Mn/2),this.thick.value=String(Mn/40)}};var yf=10,Z0=33,K0=3e4,j0=15e5;function J0(){let n=document.createElement("canvas").getContext("webgl2"),t=n?.getExtension("WEBGL_debug_renderer_info"),e=n?String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)):"";return n?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(e)}var Sl=class{constructor(t,e){this.model=t;this.open=e;this.box=rt("space");this.status=rt("space-status");this.tip=p("div",{class:"tip",hidden:!0});this.renderer=null;this.camera=new Ge(40,1,.01,1e3);this.drawn=null;this.stale=!0;this.frameSoon=vi(()=>this.frame());this.share=1;this.software=!1;this.coarse=!1;this.turning=!1;this.timed=!1;this.rest=ke(()=>this.still(),250);this.bar=new _l(()=>this.shown(),()=>this.home()),this.measure=new yl(t,()=>this.measured()),this.pairs=new xl(()=>this.shown()),this.section=new wl(()=>this.measure.names,()=>this.cut()),rt("space-bar").append(...this.bar.parts,...this.measure.parts,...this.pairs.parts,...this.section.parts),t.on("read",()=>{this.stale=!0,rt("stage-space").hidden||this.show()}),ti.onchange(()=>this.far()),t.on(["current","prediction","state"],()=>this.current())}async show(){if(!(!this.renderer&&!this.begin())){if(this.stale){this.stale=!1;try{this.take(new vl(await Gr("/api/scene")))}catch(t){return this.stale=!0,this.model.fail(t)}}this.sized()}}begin(){this.software=J0();try{this.renderer=new fl({antialias:!this.software})}catch{return this.box.textContent=_("studio_space.no_graphics"),!1}this.renderer.localClippingEnabled=!0;let t=this.renderer.domElement;return t.tabIndex=0,t.setAttribute("role","application"),t.setAttribute("aria-label",_("studio_space.canvas")),this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.box.append(t,this.tip),this.controls=new gl(this.camera,t),this.controls.zoomToCursor=!0,this.controls.addEventListener("change",()=>this.moving()),new ResizeObserver(()=>this.sized()).observe(this.box),this.pointers(t),!0}take(t){let e=!this.drawn;this.drawn?.dispose(),this.drawn=new Ml(t,this.pairs.lines),this.measure.take(t),this.pairs.take(t),this.section.take(t);let{extent:i}=t.head;this.camera.near=i/1e3,this.camera.far=i*200,this.bar.typical=this.drawn.typical,e&&(this.share=this.software?Math.min(K0/Math.max(t.points,1),1):1),e&&this.home(),this.shown(),this.current(),this.far(),this.status.textContent=t.points<t.head.total?_("studio_space.points_shown",{n:t.points,of:t.head.total}):_("studio_space.click")}axis(t){return new F(...this.drawn.data.head.basis.slice(3*t,3*t+3))}home(){if(!this.drawn)return;let{extent:t}=this.drawn.data.head;this.camera.up.copy(this.axis(2)),this.camera.position.set(0,0,0).addScaledVector(this.axis(1),1.35*t).addScaledVector(this.axis(2),.45*t).addScaledVector(this.axis(0),.4*t),this.controls.target.set(0,0,0),this.controls.update(),this.render()}sized(){let{clientWidth:t,clientHeight:e}=this.box;!this.renderer||!t||!e||(this.renderer.setSize(t,e),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.frame())}render(){this.share<1&&(this.drawn?.thin(this.share),this.rest()),this.frameSoon()}frame(){!this.renderer||!this.drawn||rt("stage-space").hidden||(this.renderer.render(this.drawn.scene,this.camera),this.turning&&this.timing())}moving(){let t=this.box.clientWidth*this.box.clientHeight>j0;this.software&&t&&!this.coarse&&this.fine(!1),this.turning=!0,this.render(),this.rest()}timing(){let t=this.renderer.getContext(),e=t.fenceSync(t.SYNC_GPU_COMMANDS_COMPLETE,0);if(!e)return;if(this.timed)return t.deleteSync(e);this.timed=!0;let i=performance.now();t.flush();let s=()=>{if(t.getSyncParameter(e,t.SYNC_STATUS)!==t.SIGNALED)return void setTimeout(s,4);t.deleteSync(e),this.timed=!1;let r=Z0/Math.max(performance.now()-i,1);this.share=Math.min(Math.max(this.share*Math.min(Math.max(r,.25),1.25),.005),1)};setTimeout(s,4)}fine(t){this.coarse=!t,this.renderer.setPixelRatio(t?Math.min(devicePixelRatio,2):.5)}still(){this.turning=!1,this.drawn?.thin(1),this.coarse&&this.fine(!0),this.frameSoon()}shown(){let{drawn:t,bar:e}=this;if(!t)return;let i=t.colour(e.colouring);t.points.visible=e.shows("points"),t.stations.visible=e.shows("stations"),t.ellipsoids.visible=e.shows("ellipsoids"),t.bars.visible=e.shows("bars"),t.ellipsoids.visible&&t.enlarge(e.enlarged),i.push(...this.pairs.legend),ti.points.size&&i.push(["#c2188f",_("studio_space.beyond",{n:ti.points.size})]),rt("space-legend").replaceChildren(...i.map(([s,r])=>{let o=p("span",{class:"dot"});return o.style.background=s,p("li",{},o,r)})),this.render()}cut(){this.section.show(),this.drawn?.cut(this.section.planes),this.render()}current(){let{drawn:t,model:e}=this;if(!t)return;let i=t.data.rowOf(e.current),s=e.prediction?.point===e.current?e.prediction?.located.xyz:null,r=s?s.map((o,a)=>o-t.data.head.origin[a]):i===void 0?null:t.data.at(i);t.current(e.current?r:null,e.marksOf(e.current).map(o=>o.image)),this.render()}far(){this.drawn&&(this.drawn.far([...ti.points].map(t=>this.drawn.data.rowOf(t)).filter(t=>t!==void 0)),this.shown())}measured(){if(!this.drawn)return;let t=this.measure.names.map(e=>this.drawn.data.rowOf(e)).filter(e=>e!==void 0);this.drawn.between(t,this.measure.closed),this.section.measured(),this.measure.words&&(this.status.textContent=this.measure.words),this.render()}pointers(t){let e=[0,0],i=!1,s=a=>{let l=t.getBoundingClientRect();return[a.clientX-l.left,a.clientY-l.top]};t.addEventListener("pointerdown",a=>{e=[a.clientX,a.clientY],i=!0,this.tip.hidden=!0}),t.addEventListener("pointerup",a=>{i=!1,Math.hypot(a.clientX-e[0],a.clientY-e[1])<4&&this.click(s(a))});let r=[0,0],o=vi(()=>this.hover(r));t.addEventListener("pointermove",a=>{r=s(a),i||o()}),t.addEventListener("pointerleave",()=>this.tip.hidden=!0),t.addEventListener("keydown",a=>this.key(a))}find(t){let{drawn:e,box:i}=this;if(!e)return{};let s={width:i.clientWidth,height:i.clientHeight},r=(l,c,h)=>this.section.holds(l,c,h),o=e.stations.visible?mh(e.data.centre,3,this.camera,s,t,yf):null;if(o!==null)return{image:e.data.head.image_ids[o]};let a=e.points.visible?mh(e.data.xyz,3,this.camera,s,t,yf,r):null;return a===null?{}:{row:a}}hover(t){let{image:e,row:i}=this.find(t);this.tip.hidden=e===void 0&&i===void 0,!this.tip.hidden&&(this.tip.textContent=e??this.words(i),this.tip.style.left=`${Math.min(t[0]+16,this.box.clientWidth-230)}px`,this.tip.style.top=`${Math.min(t[1]+14,this.box.clientHeight-70)}px`)}words(t){let{data:e}=this.drawn,i=e.head.unit;return _("studio_space.point",{name:e.nameOf(t)||"none",n:e.rays[t],sigma:e.sigma[t]>0?ye(wt(e.sigma[t],2),i):"none",w:e.w[t]>=0?wt(e.w[t],2):"none"})}click(t){let{image:e,row:i}=this.find(t);if(e!==void 0&&!this.measure.on)return this.open(e);if(i===void 0)return;let s=this.drawn.data.nameOf(i);s&&(this.measure.on?this.measure.add(s):(this.model.choose(s),this.status.textContent=this.words(i)))}key(t){let i={ArrowLeft:[1,0],ArrowRight:[-1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[t.key];if(i)this.turn(.1*i[0],.1*i[1]);else if(t.key==="+"||t.key==="=")this.closer(.85);else if(t.key==="-")this.closer(1.18);else if(t.key==="0")this.home();else return;t.preventDefault(),t.stopPropagation()}turn(t,e){let{target:i}=this.controls,s=this.camera.position.clone().sub(i),r=this.camera.up.clone().normalize();s.applyAxisAngle(r,-t);let o=r.clone().cross(s).normalize(),a=s.clone().applyAxisAngle(o,-e);a.clone().cross(r).length()>.05*a.length()&&s.copy(a),this.camera.position.copy(i).add(s),this.controls.update()}closer(t){let{target:e}=this.controls;this.camera.position.sub(e).multiplyScalar(t).add(e),this.controls.update()}};var El=class{constructor(t,e){this.model=t;this.goTo=e;t.on("overview",()=>this.show())}show(){let{standing:t}=this.model.overview,e=t.oriented<t.images||t.wrong.length>0||t.words.length>0,i=rt("standing");if(i.hidden=!e,!e)return;let s=new Set(t.wrong.map(a=>a.words)),r=new Set(t.lacking.filter(a=>a.kind==="marks"&&!a.have).map(a=>a.words)),o=t.words.filter(a=>!s.has(a)&&!r.has(a));i.replaceChildren(p("p",{id:"standing-line",class:t.oriented<t.images?"open":""},t.line.join("; ")),p("ul",{},...t.wrong.map(a=>p("li",{class:"wrong"},Zt(a.words,_("studio_point.show",{point:a.point}),()=>this.goTo(a.point,a.images[0]),"link"))),...o.map(a=>p("li",{},a))))}};var Tl=class{constructor(t,e){this.model=t;this.undo=rt("undo");this.redo=rt("redo");this.adjust=rt("adjust");this.outcome="";this.progress=rt("progress");this.undo.addEventListener("click",()=>void e.undo()),this.redo.addEventListener("click",()=>void e.redo()),this.adjust.addEventListener("click",()=>void this.begin()),rt("stop").addEventListener("click",()=>void Ue("/api/stop",{})),t.on("state",()=>this.buttons()),t.on("message",()=>this.message()),t.on("overview",()=>this.names()),t.actions.onwaiting=(i,s)=>this.waiting(i,s)}buttons(){this.undo.disabled=!this.model.state.can_undo,this.redo.disabled=!this.model.state.can_redo}message(){let{code:t,words:e,kind:i}=this.model.message,s=rt("message");s.dataset.code=t,s.textContent=s.title=e,s.className=i;let r=rt("command");r.textContent=this.model.command}names(){let t=this.model.overview;rt("title").textContent=document.title=`${t.title} \u2013 studio`,rt("title").textContent=t.title||"raybundle studio";let e=[t.headline,t.sigma0===null?"":_("studio_page.sigma0",{sigma0:t.sigma0}),t.free_scale?_("studio_page.free_scale"):""],i=rt("headline");i.textContent=i.title=e.filter(s=>s).join(" \xB7 ")||_("studio_page.contents",{kind:t.kind,images:t.images.length,points:t.points}),i.className=t.grade,rt("report").hidden=!t.report}async begin(){try{let{begun:t}=await Ue("/api/adjust",{});t?this.model.say("studio_page.adjusting"):this.model.say("studio_page.busy")}catch(t){this.model.fail(t)}}pointer(t){rt("pointer").textContent=t}connection(t){let e=rt("connection");e.textContent=t?_("studio_page.connected"):_("studio_page.connection_lost"),e.className=t?"":"bad"}waiting(t,e){e&&(t?this.model.say("studio_page.actions_wait",{n:t},"bad"):this.model.show(""))}receive(t){t.type==="state"?this.model.take(t.state):t.type==="oriented"?this.model.read().catch(()=>{}):t.type==="progress"?(rt("work").hidden=!1,this.adjust.disabled=!0,this.progress.value=t.share,rt("work-stage").textContent=ks(t.stage)):t.type==="run"?this.showRun(t.run):t.type==="targets"?this.showTargets(t):this.adjusted(t)}showTargets({images:t,error:e,code:i}){rt("work").hidden=!0,this.adjust.disabled=!1,e?this.model.show(e,"bad",i):this.model.say("studio_target.found_in",{n:t.length,image:t[0]??""},"good"),Ee.forget(),this.model.emit("targets")}showRun(t){let e=this.outcome;this.outcome=t.outcome,this.model.run=t;let i=t.outcome==="running";if(rt("work").hidden=!i,this.adjust.disabled=i,this.progress.value=t.share,rt("work-stage").textContent=`${t.name}: ${ks(t.step)}`,this.model.emit("run"),i||e===t.outcome)return;let s=t.words.split(`
`);t.outcome==="done"?this.model.show(s[0].trim(),"good"):t.outcome==="failed"?this.model.show(s[s.length-1],"bad"):this.model.say("studio_run.stopped"),t.outcome==="done"&&this.model.read().catch(()=>{})}async adjusted(t){if(rt("work").hidden=!0,this.adjust.disabled=!1,t.error)return this.model.show(t.error,"bad",t.code);await this.model.read(),this.showResult(t.folder)}showResult(t){this.model.say("studio_page.adjusted",{sigma0:this.model.overview.sigma0,folder:t||"none"},"good")}};var Vi=26,Ls=200,Fr=8e6,xf={points:"/api/points",observations:"/api/table/observations",pairs:"/api/table/pairs"},bf={points:[["point",_("label.point"),n=>n.point],["role",_("label.role"),n=>_("studio_point.role",{role:n.role})],...["X","Y","Z"].map((n,t)=>[n,n,e=>Tt(e.xyz[t],Fe(e.sigma[t]))]),...["X","Y","Z"].map((n,t)=>[`s${n}`,_("label.sigma_of",{symbol:n}),e=>Tt(e.sigma[t],Fe(e.sigma[t]))]),["rays",_("label.rays"),n=>String(n.rays)],["w",_("studio_table.largest_w"),n=>Tt(n.w,2)]],observations:[["image",_("label.image"),n=>n.image],["point",_("label.point"),n=>n.point],["x",_("studio_table.x"),n=>Tt(n.x,2)],["y",_("studio_table.y"),n=>Tt(n.y,2)],["vx",_("studio_table.vx"),n=>Tt(n.vx,3)],["vy",_("studio_table.vy"),n=>Tt(n.vy,3)],["w",_("studio_table.w"),n=>Tt(n.w,2)],["r",_("studio_table.redundancy"),n=>Tt(n.r,2)],["",_("label.rejected"),n=>n.rejected]],pairs:[["image",_("label.image"),n=>n.image],["other",_("studio_table.other_image"),n=>n.other],["common",_("label.common_points"),n=>fi(n.common)],["base",_("studio_table.base"),n=>wt(n.base,4)]]},Al=class{constructor(t,e,i){this.isOpen=e;this.opened=i;this.kind="points";this.sort="";this.down=!1;this.total=0;this.at=-1;this.pages=new Map;this.turn=0;this.search=p("input",{type:"search",id:"table-search","aria-label":_("studio_table.filter"),placeholder:_("studio_table.filter"),autocomplete:"off",spellcheck:"false"});this.status=p("span",{class:"note","aria-live":"polite"});this.head=p("div",{role:"row",class:"head"});this.rows=p("div",{class:"rows"});this.tall=p("div",{class:"tall"},this.rows);this.scroll=p("div",{class:"scroll",tabindex:0,role:"rowgroup","aria-label":_("studio_table.rows")},this.tall);this.grid=p("div",{role:"table",class:"grid","aria-label":_("studio_table.table")},this.head,this.scroll);this.drawSoon=vi(()=>this.draw());let s=p("select",{id:"table-kind","aria-label":_("studio_table.table")},...xe(Object.keys(xf),r=>_("studio_table.kind",{kind:r})));s.addEventListener("change",()=>this.of(s.value)),rt("table-bar").append(s,this.search,this.status),rt("table").append(this.grid),this.search.addEventListener("input",ke(()=>this.begin(),200)),this.scroll.addEventListener("scroll",this.drawSoon),this.scroll.addEventListener("keydown",r=>this.key(r)),this.rows.addEventListener("click",r=>{let o=r.target.closest("[data-row]");o&&this.open(Number(o.dataset.row))}),new ResizeObserver(this.drawSoon).observe(this.scroll),t.on("read",()=>this.isOpen()&&this.begin())}show(){this.of(this.kind)}of(t){t!==this.kind&&([this.sort,this.down]=["",!1]),this.kind=t,this.grid.className=`grid ${t}`,this.begin()}heads(){this.head.replaceChildren(...bf[this.kind].map(([t,e])=>{let i=t&&t===this.sort,s=()=>{this.down=i?!this.down:["w","common","base"].includes(t)||t.startsWith("s"),this.sort=t,this.begin()},r=p("div",{role:"columnheader","aria-sort":i?this.down?"descending":"ascending":"none"});return r.append(t?p("button",{type:"button",title:_("studio_table.sort",{name:e}),onclick:s},`${e}${i?this.down?" \u25BC":" \u25B2":""}`):e),r}))}begin(){this.heads(),this.turn++,this.pages.clear(),this.at=-1,this.scroll.scrollTop=0,this.rows.replaceChildren(),this.load(0)}async load(t){if(this.pages.has(t))return;let{turn:e}=this;this.pages.set(t,null);try{let i=await Ft(xf[this.kind],{sort:this.sort,down:this.down?1:0,search:this.search.value.trim(),offset:t*Ls,limit:Ls});if(e!==this.turn)return;this.pages.set(t,i.rows),this.total=i.total,this.status.textContent=_("studio_table.count",{n:i.total}),this.grid.setAttribute("aria-rowcount",String(i.total+1)),this.tall.style.height=`${Math.min(i.total*Vi,Fr)}px`}catch{e===this.turn&&this.pages.delete(t)}this.drawSoon()}get first(){let{scrollTop:t,clientHeight:e}=this.scroll;return this.total*Vi<=Fr?t/Vi:t/Math.max(Fr-e,1)*Math.max(this.total-e/Vi,0)}draw(){if(!this.isOpen()||!this.total)return void(this.total||this.rows.replaceChildren());let{first:t}=this,e=Math.ceil(this.scroll.clientHeight/Vi)+1,i=Math.floor(t);this.rows.style.transform=`translateY(${this.scroll.scrollTop-(t-i)*Vi}px)`;let s=[];for(let r=i;r<Math.min(i+e,this.total);r++){let o=Math.floor(r/Ls),a=this.pages.get(o)?.[r%Ls];a||this.load(o),s.push(this.row(r,a))}this.rows.replaceChildren(...s)}row(t,e){let i=bf[this.kind].map(([,,s])=>p("div",{role:"cell"},e?s(e):"\u2026"));return p("div",{role:"row","data-row":t,"aria-rowindex":t+2,class:t===this.at?"at":""},...i)}open(t){this.at=t;let e=this.pages.get(Math.floor(t/Ls))?.[t%Ls];this.draw(),e&&this.opened(e)}key(t){let e=Math.max(Math.floor(this.scroll.clientHeight/Vi)-1,1),i={ArrowDown:1,ArrowUp:-1,PageDown:e,PageUp:-e,Home:-this.total,End:this.total};if(t.key==="Enter"&&this.at>=0)this.open(this.at);else if(t.key in i)this.at=Math.min(Math.max(this.at+i[t.key],0),this.total-1),this.reveal();else return;t.preventDefault(),t.stopPropagation()}reveal(){let t=this.scroll.clientHeight/Vi,{first:e}=this,i=this.at<e?this.at:this.at+1>e+t?this.at+1-t:e,s=this.total*Vi,r=i/Math.max(this.total-t,1);this.scroll.scrollTop=s<=Fr?i*Vi:r*(Fr-this.scroll.clientHeight),this.draw()}},Mf=n=>"other"in n,wf=n=>"xyz"in n;var yh=["images","space","tables","epochs","decide","journal"],Rl=class{constructor(){this.opened=new Map;this.now="images";yh.forEach(t=>{let e=rt(`tab-${t}`);e.addEventListener("click",()=>this.show(t)),e.addEventListener("keydown",i=>{let s={ArrowRight:1,ArrowLeft:-1}[i.key];if(!s)return;i.preventDefault();let r=yh.filter(a=>!rt(`tab-${a}`).hidden),o=r[(r.indexOf(t)+s+r.length)%r.length];this.show(o),rt(`tab-${o}`).focus()})})}onopen(t,e){this.opened.set(t,e)}show(t){this.now=t;for(let e of yh){let i=rt(`tab-${e}`);i.setAttribute("aria-selected",String(e===t)),i.tabIndex=e===t?0:-1,rt(`stage-${e}`).hidden=e!==t}this.opened.get(t)?.()}};async function Q0(){zh();let n=new vo,t=new Rn(n),e=new Tl(n,t),i=new Rl,s=new po(n,t,m=>e.pointer(m)),r=(m,v,M)=>{i.show("images"),s.visit(m,v,M)};new ho(n,(m,v)=>{i.show("images"),s.open(m,v).body.focus()});let o=new yo(n,t,{visit:r});new El(n,(m,v)=>{n.choose(m),o.goTo(m,v)}),new so(n),new ro(n),new oo(n),new ao(n),new lo(n),new co(n),new go(n,m=>{i.show("images"),(m?s.open(m):s.activePane)?.body.focus()});let a=new Sl(n,m=>{i.show("images"),s.open(m)}),l=new Al(n,()=>i.now==="tables",m=>{if(Mf(m))return i.show("images"),s.open(m.image).body.focus(),void s.open(m.other,!0);n.choose(m.point),wf(m)||o.goTo(m.point,m.image)}),c=new mo(n,()=>i.now==="journal"),h=new to(n,()=>i.now==="decide",{images:m=>{i.show("images"),m&&s.open(m).body.focus()},space:()=>i.show("space"),visit:(m,v)=>{n.choose(m),o.goTo(m,v)}}),u=new no(n,()=>i.now==="epochs",m=>{n.choose(m),o.goTo(m)});i.onopen("epochs",()=>u.show()),i.onopen("decide",()=>h.show()),i.onopen("space",()=>void a.show()),i.onopen("tables",()=>l.show()),i.onopen("journal",()=>void c.show()),rt("help").addEventListener("click",Ql);let f=m=>()=>{i.show("images"),m(),s.activePane?.body.focus()};uu({"?":Ql,n:f(()=>void t.newPoint()),w:()=>void o.worst(),v:()=>o.visitNext(),"ctrl z":()=>void t.undo(),"ctrl shift z":()=>void t.redo(),"ctrl y":()=>void t.redo(),s:()=>o.nextSnap(),c:f(()=>s.centre()),escape:()=>tx(n,s),g:f(()=>s.setCount({1:2,2:4}[n.panes.length]??1)),"[":()=>s.step(-1),"]":()=>s.step(1),f2:()=>o.typeName()},m=>s.toggleLoupe(m),()=>Xt.loupe),await ex(n,e),s.activePane?.body.focus()}function tx(n,t){if(Kt.on)return Kt.end();document.activeElement!==t.activePane?.body?t.activePane?.body.focus():n.choose("")}async function ex(n,t){try{await n.read()}catch(s){throw n.fail(s),s}let e=()=>{n.overview.sigma0!==null&&!n.message.words&&t.showResult("")};e();let i=ke(()=>void n.read().then(e).catch(()=>{}),100);du(s=>t.receive(s),(s,r)=>{t.connection(s),s&&(r||n.overview.sigma0===null)&&i()})}Q0();})();
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
