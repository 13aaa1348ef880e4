"use strict";(()=>{var Pi=class{constructor(t){this.value=t}valueOf(){return this.value}},he=class extends Pi{constructor(t="???"){super(t)}toString(t){return`{${this.value}}`}},Ue=class extends Pi{constructor(t,e={}){super(t),this.opts=e}toString(t){if(t)try{return t.memoizeIntlObject(Intl.NumberFormat,this.opts).format(this.value)}catch(e){t.reportError(e)}return this.value.toString(10)}},Ii=class n extends Pi{static supportsValue(t){if(typeof t=="number"||t instanceof Date)return!0;if(t instanceof Pi)return n.supportsValue(t.valueOf());if("Temporal"in globalThis){let e=globalThis.Temporal;if(t instanceof e.Instant||t instanceof e.PlainDateTime||t instanceof e.PlainDate||t instanceof e.PlainMonthDay||t instanceof e.PlainTime||t instanceof e.PlainYearMonth)return!0}return!1}constructor(t,e={}){t instanceof n?(e={...t.opts,...e},t=t.value):t instanceof Pi&&(t=t.valueOf()),typeof t=="object"&&"calendarId"in t&&e.calendar===void 0&&(e={...e,calendar:t.calendarId}),super(t),this.opts=e}[Symbol.toPrimitive](t){return t==="string"?this.toString():this.toNumber()}toNumber(){let t=this.value;if(typeof t=="number")return t;if(t instanceof Date)return t.getTime();if("epochMilliseconds"in t)return t.epochMilliseconds;if("toZonedDateTime"in t)return t.toZonedDateTime("UTC").epochMilliseconds;throw new TypeError("Unwrapping a non-number value as a number")}toString(t){if(t)try{return t.memoizeIntlObject(Intl.DateTimeFormat,this.opts).format(this.value)}catch(e){t.reportError(e)}return typeof this.value=="number"||this.value instanceof Date?new Date(this.value).toISOString():this.value.toString()}};var Nh=100,Gf="\u2068",Wf="\u2069";function Xf(n,t,e){if(e===t||e instanceof Ue&&t instanceof Ue&&e.value===t.value)return!0;if(t instanceof Ue&&typeof e=="string"){let i=n.memoizeIntlObject(Intl.PluralRules,t.opts).select(t.value);if(e===i)return!0}return!1}function Fh(n,t,e){return t[e]?Zn(n,t[e].value):(n.reportError(new RangeError("No default")),new he)}function kl(n,t){let e=[],i=Object.create(null);for(let s of t)s.type==="narg"?i[s.name]=Us(n,s.value):e.push(Us(n,s));return{positional:e,named:i}}function Us(n,t){switch(t.type){case"str":return t.value;case"num":return new Ue(t.value,{minimumFractionDigits:t.precision});case"var":return qf(n,t);case"mesg":return Yf(n,t);case"term":return $f(n,t);case"func":return Zf(n,t);case"select":return Kf(n,t);default:return new he}}function qf(n,{name:t}){let e;if(n.params)if(Object.prototype.hasOwnProperty.call(n.params,t))e=n.params[t];else return new he(`$${t}`);else if(n.args&&Object.prototype.hasOwnProperty.call(n.args,t))e=n.args[t];else return n.reportError(new ReferenceError(`Unknown variable: $${t}`)),new he(`$${t}`);if(e instanceof Pi)return e;switch(typeof e){case"string":return e;case"number":return new Ue(e);case"object":if(Ii.supportsValue(e))return new Ii(e);default:return n.reportError(new TypeError(`Variable type not supported: $${t}, ${typeof e}`)),new he(`$${t}`)}}function Yf(n,{name:t,attr:e}){let i=n.bundle._messages.get(t);if(!i)return n.reportError(new ReferenceError(`Unknown message: ${t}`)),new he(t);if(e){let s=i.attributes[e];return s?Zn(n,s):(n.reportError(new ReferenceError(`Unknown attribute: ${e}`)),new he(`${t}.${e}`))}return i.value?Zn(n,i.value):(n.reportError(new ReferenceError(`No value: ${t}`)),new he(t))}function $f(n,{name:t,attr:e,args:i}){let s=`-${t}`,r=n.bundle._terms.get(s);if(!r)return n.reportError(new ReferenceError(`Unknown term: ${s}`)),new he(s);if(e){let a=r.attributes[e];if(a){n.params=kl(n,i).named;let l=Zn(n,a);return n.params=null,l}return n.reportError(new ReferenceError(`Unknown attribute: ${e}`)),new he(`${s}.${e}`)}n.params=kl(n,i).named;let o=Zn(n,r.value);return n.params=null,o}function Zf(n,{name:t,args:e}){let i=n.bundle._functions[t];if(!i)return n.reportError(new ReferenceError(`Unknown function: ${t}()`)),new he(`${t}()`);if(typeof i!="function")return n.reportError(new TypeError(`Function ${t}() is not callable`)),new he(`${t}()`);try{let s=kl(n,e);return i(s.positional,s.named)}catch(s){return n.reportError(s),new he(`${t}()`)}}function Kf(n,{selector:t,variants:e,star:i}){let s=Us(n,t);if(s instanceof he)return Fh(n,e,i);for(let r of e){let o=Us(n,r.key);if(Xf(n,s,o))return Zn(n,r.value)}return Fh(n,e,i)}function Bl(n,t){if(n.dirty.has(t))return n.reportError(new RangeError("Cyclic reference")),new he;n.dirty.add(t);let e=[],i=n.bundle._useIsolating&&t.length>1;for(let s of t){if(typeof s=="string"){e.push(n.bundle._transform(s));continue}if(n.placeables++,n.placeables>Nh)throw n.dirty.delete(t),new RangeError(`Too many placeables expanded: ${n.placeables}, max allowed is ${Nh}`);i&&e.push(Gf),e.push(Us(n,s).toString(n)),i&&e.push(Wf)}return n.dirty.delete(t),e.join("")}function Zn(n,t){return typeof t=="string"?n.bundle._transform(t):Bl(n,t)}var zr=class{constructor(t,e,i){this.dirty=new WeakSet,this.params=null,this.placeables=0,this.bundle=t,this.errors=e,this.args=i}reportError(t){if(!this.errors||!(t instanceof Error))throw t;this.errors.push(t)}memoizeIntlObject(t,e){let i=this.bundle._intls.get(t);i||(i={},this.bundle._intls.set(t,i));let s=JSON.stringify(e);return i[s]||(i[s]=new t(this.bundle.locales,e)),i[s]}};function zl(n,t){let e=Object.create(null);for(let[i,s]of Object.entries(n))t.includes(i)&&(e[i]=s.valueOf());return e}var Oh=["unitDisplay","currencyDisplay","useGrouping","minimumIntegerDigits","minimumFractionDigits","maximumFractionDigits","minimumSignificantDigits","maximumSignificantDigits"];function kh(n,t){let e=n[0];if(e instanceof he)return new he(`NUMBER(${e.valueOf()})`);if(e instanceof Ue)return new Ue(e.valueOf(),{...e.opts,...zl(t,Oh)});if(e instanceof Ii)return new Ue(e.toNumber(),{...zl(t,Oh)});throw new TypeError("Invalid argument to NUMBER")}var jf=["dateStyle","timeStyle","fractionalSecondDigits","dayPeriod","hour12","weekday","era","year","month","day","hour","minute","second","timeZoneName"];function Bh(n,t){let e=n[0];if(e instanceof he)return new he(`DATETIME(${e.valueOf()})`);if(e instanceof Ii||e instanceof Ue)return new Ii(e,zl(t,jf));throw new TypeError("Invalid argument to DATETIME")}var zh=new Map;function Hh(n){let t=Array.isArray(n)?n.join(" "):n,e=zh.get(t);return e===void 0&&(e=new Map,zh.set(t,e)),e}var Ns=class{constructor(t,{functions:e,useIsolating:i=!0,transform:s=r=>r}={}){this._terms=new Map,this._messages=new Map,this.locales=Array.isArray(t)?t:[t],this._functions={NUMBER:kh,DATETIME:Bh,...e},this._useIsolating=i,this._transform=s,this._intls=Hh(t)}hasMessage(t){return this._messages.has(t)}getMessage(t){return this._messages.get(t)}addResource(t,{allowOverrides:e=!1}={}){let i=[];for(let s=0;s<t.body.length;s++){let r=t.body[s];if(r.id.startsWith("-")){if(e===!1&&this._terms.has(r.id)){i.push(new Error(`Attempt to override an existing term: "${r.id}"`));continue}this._terms.set(r.id,r)}else{if(e===!1&&this._messages.has(r.id)){i.push(new Error(`Attempt to override an existing message: "${r.id}"`));continue}this._messages.set(r.id,r)}}return i}formatPattern(t,e=null,i=null){if(typeof t=="string")return this._transform(t);let s=new zr(this,i,e);try{return Bl(s,t).toString(s)}catch(r){if(s.errors&&r instanceof Error)return s.errors.push(r),new he().toString(s);throw r}}};var Hl=/^(-?[a-zA-Z][\w-]*) *= */gm,Vh=/\.([a-zA-Z][\w-]*) *= */y,Jf=/\*?\[/y,Vl=/(-?[0-9]+(?:\.([0-9]+))?)/y,Qf=/([a-zA-Z][\w-]*)/y,Gh=/([$-])?([a-zA-Z][\w-]*)(?:\.([a-zA-Z][\w-]*))?/y,tp=/^[A-Z][A-Z0-9_-]*$/,Hr=/([^{}\n\r]+)/y,ep=/([^\\"\n\r]*)/y,Wh=/\\([\\"])/y,Xh=/\\u([a-fA-F0-9]{4})|\\U([a-fA-F0-9]{6})/y,ip=/^\n+/,qh=/ +$/,np=/ *\r?\n/g,sp=/( *)$/,rp=/{\s*/y,Yh=/\s*}/y,op=/\[\s*/y,ap=/\s*] */y,lp=/\s*\(\s*/y,cp=/\s*->\s*/y,hp=/\s*:\s*/y,up=/\s*,?\s*/y,dp=/\s+/y,Fs=class{constructor(t){this.body=[],Hl.lastIndex=0;let e=0;for(;;){let x=Hl.exec(t);if(x===null)break;e=Hl.lastIndex;try{this.body.push(l(x[1]))}catch(w){if(w instanceof SyntaxError)continue;throw w}}function i(x){return x.lastIndex=e,x.test(t)}function s(x,w){if(t[e]===x)return e++,!0;if(w)throw new w(`Expected ${x}`);return!1}function r(x,w){if(i(x))return e=x.lastIndex,!0;if(w)throw new w(`Expected ${x.toString()}`);return!1}function o(x){x.lastIndex=e;let w=x.exec(t);if(w===null)throw new SyntaxError(`Expected ${x.toString()}`);return e=x.lastIndex,w}function a(x){return o(x)[1]}function l(x){let w=h(),C=c();if(w===null&&Object.keys(C).length===0)throw new SyntaxError("Expected message value or attributes");return{id:x,value:w,attributes:C}}function c(){let x=Object.create(null);for(;i(Vh);){let w=a(Vh),C=h();if(C===null)throw new SyntaxError("Expected attribute value");x[w]=C}return x}function h(){let x;if(i(Hr)&&(x=a(Hr)),t[e]==="{"||t[e]==="}")return d(x?[x]:[],1/0);let w=P();return w?x?d([x,w],w.length):(w.value=D(w.value,ip),d([w],w.length)):x?D(x,qh):null}function d(x=[],w){for(;;){if(i(Hr)){x.push(a(Hr));continue}if(t[e]==="{"){x.push(p());continue}if(t[e]==="}")throw new SyntaxError("Unbalanced closing brace");let X=P();if(X){x.push(X),w=Math.min(w,X.length);continue}break}let C=x.length-1,B=x[C];typeof B=="string"&&(x[C]=D(B,qh));let V=[];for(let X of x)X instanceof Vr&&(X=X.value.slice(0,X.value.length-w)),X&&V.push(X);return V}function p(){r(rp,SyntaxError);let x=m();if(r(Yh))return x;if(r(cp)){let w=g();return r(Yh,SyntaxError),{type:"select",selector:x,...w}}throw new SyntaxError("Unclosed placeable")}function m(){if(t[e]==="{")return p();if(i(Gh)){let[,x,w,C=null]=o(Gh);if(x==="$")return{type:"var",name:w};if(r(lp)){let B=v();if(x==="-")return{type:"term",name:w,attr:C,args:B};if(tp.test(w))return{type:"func",name:w,args:B};throw new SyntaxError("Function names must be all upper-case")}return x==="-"?{type:"term",name:w,attr:C,args:[]}:{type:"mesg",name:w,attr:C}}return R()}function v(){let x=[];for(;;){switch(t[e]){case")":return e++,x;case void 0:throw new SyntaxError("Unclosed argument list")}x.push(b()),r(up)}}function b(){let x=m();return x.type!=="mesg"?x:r(hp)?{type:"narg",name:x.name,value:R()}:x}function g(){let x=[],w=0,C;for(;i(Jf);){s("*")&&(C=w);let B=f(),V=h();if(V===null)throw new SyntaxError("Expected variant value");x[w++]={key:B,value:V}}if(w===0)return null;if(C===void 0)throw new SyntaxError("Expected default variant");return{variants:x,star:C}}function f(){r(op,SyntaxError);let x;return i(Vl)?x=E():x={type:"str",value:a(Qf)},r(ap,SyntaxError),x}function R(){if(i(Vl))return E();if(t[e]==='"')return S();throw new SyntaxError("Invalid expression")}function E(){let[,x,w=""]=o(Vl),C=w.length;return{type:"num",value:parseFloat(x),precision:C}}function S(){s('"',SyntaxError);let x="";for(;;){if(x+=a(ep),t[e]==="\\"){x+=I();continue}if(s('"'))return{type:"str",value:x};throw new SyntaxError("Unclosed string literal")}}function I(){if(i(Wh))return a(Wh);if(i(Xh)){let[,x,w]=o(Xh),C=parseInt(x||w,16);return C<=55295||57344<=C?String.fromCodePoint(C):"\uFFFD"}throw new SyntaxError("Unknown escape sequence")}function P(){let x=e;switch(r(dp),t[e]){case".":case"[":case"*":case"}":case void 0:return!1;case"{":return k(t.slice(x,e))}return t[e-1]===" "?k(t.slice(x,e)):!1}function D(x,w){return x.replace(w,"")}function k(x){let w=x.replace(np,`
`),C=sp.exec(x)[1].length;return new Vr(w,C)}}},Vr=class{constructor(t,e){this.value=t,this.length=e}};var fp=1.5.toLocaleString(document.documentElement.lang)[1],oi=n=>n.replace(".",fp),fi=n=>String(n).replace(/\B(?=(\d{3})+(?!\d))/g,"\u202F");function ke(n,t=4){return n==null||!(n>0)||!Number.isFinite(n)?t:Math.min(Math.max(1-Math.floor(Math.log10(n)),0),9)}function pt(n,t){return n==null||!Number.isFinite(n)?"\u2013":oi(n.toFixed(t))}function Mt(n,t=3){if(n==null||!Number.isFinite(n))return"\u2013";let e=Math.abs(n);return e!==0&&(e>=1e7||e<1e-6)?oi(n.toExponential(t-1)):oi(e>=10**(t-1)?n.toFixed(0):String(Number(n.toPrecision(t))))}var ye=(n,t)=>t?`${n} ${t}`:n;var Gr=class extends Ue{constructor(e,i){super(e);this.text=i}toString(){return this.text}},pp=([n],{digits:t,decimals:e})=>n instanceof Ue?new Gr(n.value,e?pt(n.value,Number(e.valueOf())):Mt(n.value,t?Number(t.valueOf()):3)):n,mp=([n])=>`--${String(n)}`,Gl=new Ns(document.documentElement.lang,{useIsolating:!1,functions:{NUM:pp,OPTION:mp}});Gl.addResource(new Fs(JSON.parse(document.getElementById("words").textContent)));function $h(n,t,e){let i=Gl.getMessage(n.replace(".","-")),s=t?i?.attributes[t]:i?.value,r=Object.entries(e).map(([o,a])=>[o,typeof a=="number"?new Gr(a,Number.isInteger(a)?fi(a):Mt(a)):a??"\u2013"]);return s?Gl.formatPattern(s,Object.fromEntries(r),[]):void 0}var _=(n,t={})=>["","why","do"].map(e=>$h(n,e,t)).filter(e=>e).join(" ")||n,Be=(n,t={})=>$h(n,"title",t)??"",En=n=>n.replace(/\W+/g,"_");function Zh(){for(let n of document.querySelectorAll("[data-say], [data-label], [data-hint], [data-tip]")){let{say:t,label:e,hint:i,tip:s}=n.dataset;t&&(n.textContent=_(t)),t&&Be(t)&&(n.title=Be(t)),e&&n.setAttribute("aria-label",_(e)),i&&n.setAttribute("placeholder",_(i)),s&&(n.title=_(s))}}var nt=n=>document.getElementById(n);function u(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))typeof r=="function"?i.addEventListener(s.slice(2),r):r===!0?i.setAttribute(s,""):r!==!1&&i.setAttribute(s,String(r));return i.append(...e),i}var Xt=(n,t,e,i="")=>u("button",{type:"button",title:t,class:i,onclick:e},n),yt=(n,t,e="",i={})=>Xt(_(n,i),Be(n,i),t,e),Ne=(n,t=[])=>u("thead",{},u("tr",{},...n.map((e,i)=>u("th",{scope:"col",class:t.includes(i)?"l":"",title:Be(e)},e&&_(e))))),xe=(n,t,e="")=>n.map(i=>u("option",{value:i,selected:i===e},t(i)));function Kh(n){return n instanceof HTMLInputElement?!["checkbox","range","radio","button","file"].includes(n.type):n instanceof HTMLTextAreaElement||n instanceof HTMLSelectElement}function vi(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function Kn(n){let t=!1;return()=>{if(!document.hidden)return n();t||(t=!0,document.addEventListener("visibilitychange",()=>{t=!1,n()},{once:!0}))}}function Re(n,t){let e=0;return()=>{clearTimeout(e),e=window.setTimeout(n,t)}}var yi=class extends Error{constructor(e,i,s=""){super(i);this.status=e;this.code=s}};function gp(n,t){let e=new URLSearchParams;for(let[s,r]of Object.entries(t))for(let o of Array.isArray(r)?r:[r])e.append(s,String(o));let i=e.toString();return i?`${n}?${i}`:n}async function Wl(n){let{status:t}=n;try{let{error:e,code:i}=await n.json();return new yi(t,e,i)}catch{return new yi(t,_("studio_page.server_status",{status:t}),"studio_page.server_status")}}async function Pt(n,t={}){let e=await fetch(gp(n,t));if(!e.ok)throw await Wl(e);return await e.json()}async function Wr(n){let t=await fetch(n);if(!t.ok)throw await Wl(t);return t.arrayBuffer()}async function Ee(n,t){let e=await fetch(n,{method:"POST",headers:{"content-type":"application/json"},body:JSON.stringify(t)});if(!e.ok)throw await Wl(e);return await e.json()}var _p=["auto","free","held"],vp=["label.parameter","studio_decide.next","studio_decide.last_status","label.value","studio_decide.sigma","label.unit","studio_decide.t","studio_decide.p","studio_decide.effect","studio_decide.effect_sigma","studio_decide.correlation"],Xr=class{constructor(t){this.model=t;this.root=u("section",{class:"leaf","aria-label":_("studio_decide.parameters")});this.box=u("div",{});this.root.append(u("p",{class:"note"},_("studio_decide.parameters_note")),this.box)}async show(){let t=await Pt("/api/parameters"),e=document.activeElement?.id??"",i=t.total>t.interiors.length?[u("p",{class:"note"},_("studio_decide.interiors_shown",{n:t.interiors.length,of:t.total}))]:[];this.box.replaceChildren(...t.interiors.map(s=>this.table(s,t)),...i),e.startsWith("choice-")&&document.getElementById(e)?.focus()}table(t,e){let i=t.image===null?_("studio_decide.camera",{camera:t.camera}):_("studio_decide.camera_image",{camera:t.camera,image:t.image}),s=t.tests.map(r=>u("li",{},_("studio_decide.joint_test",{group:r.group,F:Mt(r.F),p:jh(r.probability)})));return u("div",{class:"card"},u("h3",{},i),u("table",{class:"parameters","aria-label":_("studio_decide.parameters_of",{name:i})},Ne(vp),u("tbody",{},...t.parameters.map(r=>this.row(t,r,e)))),...s.length?[u("p",{class:"note"},_("studio_decide.joint_tests")),u("ul",{class:"tests"},...s)]:[])}row(t,e,{strong:i,significance:s}){let r=ke(e.sigma,6),o=e.correlation,a=o?.with||_("studio_decide.exterior"),l=o?`${pt(o.value,2)} ${a}`:"\u2013",c=e.probability!==null&&e.probability>s,h=o?.strong?u("span",{class:"flag",title:_("studio_decide.strong",{strong:i})},"\u26A0 "):"";return u("tr",{},u("th",{scope:"row",title:e.meaning},e.symbol),u("td",{class:"l"},this.choice(t,e)),u("td",{class:`l ${e.status==="not determinable"?"doubt":""}`,title:e.remark},_("studio_decide.status",{status:En(e.status)})),u("td",{},e.sigma===null?Mt(e.value,6):Yl(e.value,e.sigma,r)),u("td",{},Xl(e.sigma)),u("td",{class:"l"},ql(e.unit)),u("td",{},Mt(e.t)),u("td",{class:c?"doubt":""},jh(e.probability)),u("td",{},Mt(e.effect_px)),u("td",{},Mt(e.effect_sigma_px,2)),u("td",{class:"l",title:o?_("studio_decide.correlated",{other:a}):""},h,l))}choice(t,e){let i=`choice-${t.camera}-${t.image??""}-${e.symbol}`,s=u("select",{id:i,"aria-label":_("studio_decide.choice_of",{symbol:e.symbol,camera:t.camera}),class:e.choice==="auto"?"":"chosen"},...xe(_p,r=>_("studio_decide.choice",{choice:r}),e.choice));return s.addEventListener("change",()=>void this.model.act("parameter",{camera:t.camera,symbol:e.symbol,choice:s.value},"studio_decide.choice_stored",{symbol:e.symbol,camera:t.camera,choice:s.value})),s}},Jh=1e-4,Xl=n=>n!==null&&n>0&&n<Jh?oi(n.toExponential(1)):Mt(n,2),ql=n=>n.replace(/\^(-?\d)/,(t,e)=>[...e].map(i=>i==="-"?"\u207B":"\u2070\xB9\xB2\xB3\u2074\u2075\u2076\u2077\u2078\u2079"[Number(i)]).join(""));function Yl(n,t,e){return n===null?"\u2013":t>0&&t<Jh?oi(n.toExponential(Math.min(Math.max(Math.floor(Math.log10(Math.abs(n)/t))+1,1),8))):pt(n,e)}var jh=n=>n===null?"\u2013":n<1e-4?`< ${oi("0.0001")}`:pt(n,n<.01?4:2);var yp={good:"good",usable:"remarks"},qr=class{constructor(t){this.model=t;this.root=u("section",{class:"leaf",tabindex:0,"aria-label":_("studio_decide.calibration")});this.status=u("p",{class:"note",role:"status"});this.box=u("div",{});this.turn=0;this.root.append(this.status,this.box)}async show(){let t=++this.turn;this.status.hidden=!1,this.status.textContent=_("studio_decide.judging");try{let{cameras:e,why:i}=await Pt("/api/calibration");if(t!==this.turn)return;this.status.hidden=!i,this.status.textContent=i,this.box.replaceChildren(...e.map(s=>this.camera(s)))}catch(e){if(t!==this.turn)return;this.status.textContent=e.message,this.box.replaceChildren()}}camera(t){let e=t.verdict;return u("div",{class:"camera"},u("h3",{},_("studio_decide.camera",{camera:t.camera})),u("p",{class:"note"},t.about),...e?this.verdict(t,e):[u("p",{class:"note"},_("studio_decide.no_verdict"))],u("div",{class:"halves"},this.parameters(t),...e?[xp(e)]:[]),u("div",{class:"figures"},...t.figures.map(i=>u("figure",{},u("img",{src:`/figure/calibration/${i.number}.svg?of=${this.model.overview.times}-${this.turn}`,alt:i.caption,loading:"lazy"}),u("figcaption",{},i.caption)))))}verdict(t,e){let i=[u("p",{class:`verdict ${yp[e.grade]??"attention"}`},e.headline),u("p",{class:"note"},_("studio_decide.verdict_source",{source:t.verdict_is}))];e.reasons.length&&i.push(u("h4",{},_("studio_decide.weaknesses")),u("ul",{class:"reasons"},...e.reasons.map(o=>u("li",{},o))));let s=e.advice[e.advice.length-1],r=s?.ratio&&s.uncertainty_px?s.uncertainty_px/s.ratio:e.uncertainty_px;return e.advice.length?i.push(u("h4",{},_("studio_decide.next_photographs")),u("table",{class:"figures-of","aria-label":_("studio_decide.next_photographs_of",{camera:t.camera})},Ne(["label.photograph","studio_decide.uncertainty_then","studio_decide.smaller_by"]),u("tbody",{},...e.advice.map((o,a)=>u("tr",{},u("th",{scope:"row"},`${a+1}. ${o.photographs}`),u("td",{},Mt(o.uncertainty_px,2)),u("td",{},o.ratio===null||!(o.ratio>0)?"\u2013":`${Math.round(100*(1-o.ratio))} %`))))),u("p",{class:"note"},_("studio_decide.next_photographs_note",{now_px:Mt(r,2)}))):i.push(u("p",{class:"note"},_("studio_decide.no_next_photographs"))),i}parameters(t){return u("div",{class:"wide"},u("table",{class:"figures-of","aria-label":_("studio_decide.parameters_of",{name:t.camera})},Ne(["label.parameter","label.value","label.sigma","label.unit","studio_decide.determinability","label.status"],[3,5]),u("tbody",{},...t.parameters.map(e=>u("tr",{},u("th",{scope:"row"},e.symbol,u("small",{class:"note"},` ${e.meaning}`)),u("td",{},e.sigma===null?Mt(e.value,6):Yl(e.value,e.sigma,ke(e.sigma,6))),u("td",{},Xl(e.sigma)),u("td",{class:"l"},ql(e.unit)),u("td",{},Mt(e.determinability,2)),u("td",{class:`l ${e.status==="not determinable"?"doubt":""}`},_("studio_decide.status",{status:En(e.status)})))))))}};function xp(n){let t=i=>i===null?"\u2013":`${Math.round(100*i)} %`,e=[["studio_decide.largest_uncertainty",`${Mt(n.uncertainty_px,2)} px`],["studio_decide.median_uncertainty",`${Mt(n.typical_uncertainty_px,2)} px`],["studio_decide.image_sigma",`${Mt(n.image_sigma_px,2)} px`],["studio_decide.coverage",t(n.coverage)],["studio_decide.reach",t(n.reach)],["label.photographs",String(n.photographs)],["studio_decide.quarter_turns",_("label.n_of",{n:n.rolls,of:4})],["studio_decide.convergence",`${Mt(n.convergence_deg,2)}\xB0`],["label.cross_validation",n.cross_validation?_("studio_decide.cross_validation",{rms_px:Mt(n.cross_validation.rms_px,2),fit_px:Mt(n.cross_validation.fit_px,2)}):"\u2013"]];return u("dl",{class:"facts"},...e.map(([i,s])=>u("div",{},u("dt",{},_(i)),u("dd",{},s))))}function Os(n){return u("iframe",{class:"page",sandbox:"allow-scripts",referrerpolicy:"no-referrer",title:n})}var ks=n=>`${n.number}: ${_("studio_decide.origin",{origin:n.origin})}`,Yr=class{constructor(){this.root=u("section",{class:"leaf whole","aria-label":_("studio_page.report")});this.select=u("select",{id:"report-of"});this.status=u("p",{class:"note",role:"status"});this.links=u("span",{class:"links"});this.frame=Os(_("studio_decide.report"));this.at="";this.select.addEventListener("change",()=>void this.show()),this.root.append(u("div",{class:"deeds"},u("label",{for:"report-of"},_("studio_decide.of_adjustment")),this.select,this.links),this.status,this.frame)}async show(){let{adjustments:t}=await Pt("/api/adjustments"),i=this.select.options.length===t.length?Number(this.select.value):t[t.length-1]?.number??-1;this.select.replaceChildren(...t.map(o=>u("option",{value:o.number,selected:o.number===i},ks(o))));let s=t.find(o=>o.number===i),r=s?.report?`/adjustment/${s.number}/report.html`:"";this.select.disabled=!t.length,this.frame.hidden=!r,this.status.textContent=s?r?"":_("studio_decide.no_report"):_("studio_decide.not_adjusted"),this.status.hidden=!this.status.textContent,this.links.replaceChildren(...r?[Qh(_("studio_decide.window"),r)]:[],...s?.network?[Qh(_("studio_decide.network"),`/adjustment/${s.number}/network.html`)]:[]),r&&r!==this.at&&(this.frame.src=r),this.at=r}},Qh=(n,t)=>u("a",{href:t,target:"_blank",rel:"noopener"},n);var $r=class{constructor(t,e){this.model=t;this.ways=e;this.root=u("section",{class:"leaf whole","aria-label":_("studio_decide.compare")});this.body=u("tbody",{});this.worst=u("div",{class:"beside"});this.status=u("p",{class:"note",role:"status"});this.frame=Os(_("studio_decide.comparison"));this.adjustments=[];this.pair=[-1,-1];this.at="";this.root.append(u("table",{class:"adjustments","aria-label":_("studio_decide.adjustments")},Ne(["studio_decide.first","studio_decide.second","studio_decide.adjustment","studio_decide.sigma0","label.redundancy","label.rejected","studio_decide.free","studio_decide.mean_sigma","studio_decide.rms_check"]),this.body),this.worst,this.status,this.frame)}async show(){let t=this.adjustments.length?this.adjustments[this.adjustments.length-1].number:-1;this.adjustments=(await Pt("/api/adjustments")).adjustments;let e=this.adjustments.map(i=>i.number);(e[e.length-1]!==t||!this.pair.every(i=>e.includes(i)))&&(this.pair=[e[e.length-2]??-1,e[e.length-1]??-1]),this.body.replaceChildren(...this.adjustments.map(i=>this.row(i))),this.compare()}row(t){let e=t.check.points?t.check.rms.map(s=>Mt(s,2)).join(", "):"\u2013",i=t.parameters.filter(s=>s.sigma!==null).length;return u("tr",{},u("td",{},this.radio(0,t)),u("td",{},this.radio(1,t)),u("th",{scope:"row"},ks(t),u("small",{class:"note",title:t.options.join(" ")},t.options.join(" ")||_("studio_decide.defaults"))),u("td",{},pt(t.sigma0,4)),u("td",{},t.redundancy===null?"\u2013":fi(t.redundancy)),u("td",{},t.rejected===null?"\u2013":fi(t.rejected)),u("td",{},String(i)),u("td",{},ye(Mt(t.mean_std,2),t.unit)),u("td",{},t.check.points?ye(e,t.unit):e))}radio(t,e){let i=t?"second":"first",s=u("input",{type:"radio",name:`compare-${i}`,id:`compare-${i}-${e.number}`,checked:this.pair[t]===e.number,"aria-label":_("studio_decide.as_side",{name:ks(e),side:i})});return s.addEventListener("change",()=>{this.pair[t]=e.number,this.compare()}),s}compare(){let t=this.pair.map(o=>this.adjustments.find(a=>a.number===o)),[e,i]=t,s=e!==void 0&&i!==void 0&&e!==i;this.status.textContent=s?"":this.adjustments.length<2?_("studio_decide.adjust_again"):_("studio_decide.choose_two"),this.status.hidden=s,this.worst.replaceChildren(...t.filter(o=>o!==void 0).filter((o,a,l)=>l.indexOf(o)===a).map(o=>this.largest(o)));let r=s?`/comparison/${e.number}/${i.number}`:"";this.frame.hidden=!s,s&&r!==this.at&&(this.frame.src=r),this.at=r}largest(t){let e=_("studio_decide.largest_residuals",{name:ks(t)});return u("div",{},u("h3",{},e),u("table",{"aria-label":e},Ne(["studio_table.observation","studio_table.w","studio_decide.v"]),u("tbody",{},...t.worst.map(i=>u("tr",{},u("td",{class:"l"},Xt(_("studio_decide.point_in_image",{...i}),_("studio_decide.show_point",{...i}),()=>this.visit(i.point,i.image),"link")),u("td",{},pt(i.w,2)),u("td",{},pt(i.v_px,2)))))))}visit(t,e){this.model.images.has(e)&&this.ways.visit(t,e)}};var Li=class{constructor(t,e){this.prefix=t;this.root=u("form",{class:"options"});this.inputs=new Map;this.root.addEventListener("submit",i=>i.preventDefault()),this.root.addEventListener("change",()=>e(this.values()))}values(){let t={};for(let[e,[i,s]]of this.inputs)i.kind==="flag"?t[e]=s.checked:i.kind==="number"?t[e]=s.value.trim()?Number(s.value.replace(",",".")):i.default:t[e]=s.value;return t}fill(t){this.inputs.size||this.root.append(...t.map(e=>this.row(e)));for(let{name:e,value:i,default:s}of t){let[r,o]=this.inputs.get(e);r.kind==="flag"?o.checked=i===!0:(document.activeElement!==o||o instanceof HTMLSelectElement)&&(o.value=i===null?"":String(i)),o.closest(".option").classList.toggle("changed",i!==s)}}row(t){let e=`${this.prefix}-${t.name}`,i={id:e,name:t.name,"aria-describedby":`${e}-help`,title:t.help},s;return t.kind==="choice"?s=u("select",i,...xe(t.choices,r=>r.replace("_"," ")||"\u2013")):t.kind==="flag"?s=u("input",{...i,type:"checkbox"}):t.kind==="number"?s=u("input",{...i,type:"number",min:t.low??"",max:t.high??"",step:t.whole?1:"any",placeholder:t.metavar}):s=u("input",{...i,type:"text",placeholder:t.metavar,autocomplete:"off",spellcheck:"false"}),this.inputs.set(t.name,[t,s]),u("div",{class:"option"},u("label",{for:e},t.flag.replace(/^--/,"").replace(/-/g," ")),s,u("p",{class:"note",id:`${e}-help`},t.help))}};var Zr=class{constructor(t){this.model=t;this.root=u("section",{class:"leaf","aria-label":_("studio_decide.options")});this.form=new Li("option",t=>void this.send(t));this.command=u("code",{class:"command"});let e=yt("studio_decide.adjust",()=>nt("adjust").click(),"main");e.id="options-adjust";let i=yt("studio_decide.reset",()=>void this.send({}));i.id="options-usual",this.root.append(u("p",{class:"note"},_("studio_decide.options_note")),this.form.root,u("div",{class:"deeds"},e,i),u("h3",{},_("studio_decide.command")),u("p",{},this.command))}async show(){this.fill(await Pt("/api/options"))}async send(t){try{this.fill(await Ee("/api/options",{values:t})),this.model.say("studio_decide.options_stored",{},"good")}catch(e){this.model.fail(e)}}fill({fields:t,command:e}){this.form.fill(t),this.command.textContent=e}};var jr=class{constructor(t){this.model=t;this.root=u("section",{class:"leaf","aria-label":_("studio_run.title")});this.form=new Li("run",t=>void this.send(t));this.command=u("code",{class:"command"});this.why=u("p",{class:"note"});this.go=yt("studio_run.begin",()=>void this.begin(),"main",{name:""});this.stop=yt("studio_run.stop",()=>nt("stop").click());this.usual=yt("studio_decide.reset",()=>void this.send({}));this.status=u("p",{class:"counts",role:"status","aria-live":"polite"});this.bar=u("progress",{max:1,value:0,"aria-label":_("studio_run.progress")});this.body=u("tbody",{});this.table=u("table",{class:"stages","aria-label":_("studio_run.stages")},Ne(["studio_run.stage","studio_run.state","label.time","label.result"]),this.body);this.words=u("pre",{class:"printed",tabindex:0,"aria-label":_("studio_run.output")});this.go.id="run-begin",this.stop.id="run-stop",this.usual.id="run-usual",this.settings=u("div",{},u("h3",{},_("studio_decide.command")),u("p",{},this.command),u("h3",{},_("studio_run.settings")),u("p",{class:"note"},_("studio_run.settings_note")),this.form.root),this.root.append(this.why,u("div",{class:"deeds first"},this.go,this.stop,this.usual),this.status,this.bar,this.table,this.words,this.settings),t.on("run",()=>t.run?.stages.length!==0&&this.run(t.run))}async show(){this.take(await Pt("/api/run"))}take({form:t,why:e,run:i}){this.why.textContent=e,this.why.hidden=!e,this.settings.hidden=this.usual.hidden=this.go.hidden=!t,t&&(this.form.fill(t.fields),this.command.textContent=t.command,this.go.textContent=_("studio_run.begin",{name:t.name})),this.model.run=i,this.run(i)}async send(t){try{this.take(await Ee("/api/run/settings",{values:t})),this.model.say("studio_run.settings_stored",{},"good")}catch(e){this.model.fail(e)}}async begin(){try{this.take(await Ee("/api/run",{})),this.model.say("studio_run.begun")}catch(t){this.model.fail(t)}}run(t){let e=t?.outcome==="running";this.go.disabled=e,this.stop.disabled=!e,this.bar.hidden=!e,this.status.hidden=this.table.hidden=!t,this.words.hidden=!t?.words,t&&(this.bar.value=t.share,this.status.textContent=$l(t),this.body.replaceChildren(...t.stages.map(bp)),this.words.textContent=t.words,this.words.classList.toggle("bad",t.outcome==="failed"))}};function $l(n){if(n.outcome!=="running")return _("studio_run.ended",{outcome:n.outcome,time:Kr(n.seconds)});let t=Bs(n.step);if(n.stopping)return _("studio_run.stopping",{step:t});let e=n.left_s===null?"none":Kr(n.left_s);return _("studio_run.going",{step:t,percent:Math.round(100*n.share),rest:e,time:Kr(n.seconds)})}var Bs=n=>_("studio_run.stage_name",{stage:En(n.split(":")[0]),name:n}),bp=n=>u("tr",{class:n.state.replace(" ","-")},u("th",{scope:"row"},Bs(n.title)),u("td",{class:"l"},_("studio_run.stage_state",{state:En(n.state)})),u("td",{},n.seconds===null?"\u2013":Kr(n.seconds)),u("td",{class:"l"},n.summary));function Kr(n){return n<9.95?`${pt(n,1)} s`:n<120?`${Math.round(n)} s`:n<7200?`${Math.round(n/60)} min`:`${pt(n/3600,1)} h`}var Zl=class{constructor(){this.images=new Map;this.points=new Set;this.listeners=[]}onchange(t){this.listeners.push(t)}show(t){this.images=new Map,this.points=new Set;for(let[e,i]of t){this.points.add(i);let s=this.images.get(e);s?s.add(i):this.images.set(e,new Set([i]))}for(let e of this.listeners)e()}has(t,e){return this.images.get(t)?.has(e)??!1}get worstImage(){let t="";for(let[e,i]of this.images)i.size>(this.images.get(t)?.size??0)&&(t=e);return t}},ei=new Zl;var Kl=1e3,wp=60,Jr=class{constructor(t,e){this.model=t;this.ways=e;this.root=u("section",{class:"leaf","aria-label":_("studio_decide.select")});this.kinds=u("fieldset",{class:"kinds"},u("legend",{},_("studio_decide.observations_by")));this.slider=u("input",{type:"range",id:"select-slider",min:0,max:Kl,value:0,"aria-label":_("studio_decide.limit")});this.limit=u("input",{type:"text",id:"select-limit",inputmode:"decimal",autocomplete:"off"});this.unit=u("span",{class:"note"});this.words=u("p",{class:"note"});this.counts=u("p",{class:"counts",role:"status","aria-live":"polite"});this.hand=u("p",{class:"note"});this.command=u("code",{class:"command"});this.list=u("div",{class:"found",tabindex:0,role:"region","aria-label":_("studio_decide.beyond")});this.draw=u("input",{type:"checkbox",id:"select-draw"});this.criteria=[];this.by="w";this.limits=new Map;this.turn=0;this.soon=Re(()=>void this.count(),50);this.reject=yt("studio_decide.reject_all",()=>void this.rejectAll(),"main"),this.reject.id="select-reject",this.slider.disabled=this.limit.disabled=!0,this.shows=[yt("studio_decide.show_in_images",()=>this.drawn(()=>e.images(ei.worstImage))),yt("studio_decide.show_in_space",()=>this.drawn(()=>e.space()))],this.draw.addEventListener("change",()=>void this.count()),t.on(["read","state"],()=>this.draw.checked&&void this.count()),this.slider.addEventListener("input",()=>this.moved()),this.limit.addEventListener("change",()=>this.setLimit()),this.root.append(this.kinds,this.words,u("div",{class:"limit"},u("label",{for:"select-limit"},_("studio_decide.limit")),this.slider,this.limit,this.unit),this.counts,this.hand,u("div",{class:"deeds"},this.reject,...this.shows,u("label",{class:"row"},this.draw,_("studio_decide.draw"))),u("h3",{},_("studio_decide.command")),u("p",{},this.command),this.list)}async show(){this.criteria=(await Pt("/api/criteria")).criteria,this.kinds.childElementCount<2&&this.kinds.append(...this.criteria.map(t=>this.kind(t)));for(let t of this.criteria)this.limits.has(t.name)||this.limits.set(t.name,Number(t.begin.toPrecision(3)));this.slider.disabled=this.limit.disabled=!1,this.take()}kind(t){let e=u("input",{type:"radio",name:"select-by",id:`select-${t.name}`,value:t.name,checked:t.name===this.by});return e.addEventListener("change",()=>{this.by=t.name,this.take()}),u("label",{title:_("studio_decide.quantity_meaning",{quantity:t.name})},e,_("studio_decide.quantity",{quantity:t.name}))}get criterion(){return this.criteria.find(t=>t.name===this.by)}at(t){let e=this.criterion,i=t/Kl;if(e.whole)return Math.round(2+i*Math.max(e.high-2,1));if(e.name==="redundancy")return Number((i*Math.min(e.high,1)).toPrecision(3));let s=Math.max(e.middle,e.high/1e4)||1e-9;return Number((s*(Math.max(e.high,s)/s)**i).toPrecision(3))}step(t){let e=0;for(let i=0;i<=Kl;i+=5)Math.abs(this.at(i)-t)<Math.abs(this.at(e)-t)&&(e=i);return e}take(){let t=this.criterion,[e,i,s]=[t.low,t.high,t.middle].map(a=>ye(Mt(a),t.unit)),r=t.above?"above":"below",o=t.known?_("studio_decide.range",{low:e,high:i,middle:s}):_("studio_decide.no_range");this.words.textContent=[_("studio_decide.quantity_meaning",{quantity:t.name}),o,_("studio_decide.selected",{side:r})].join(" "),this.limit.value=String(this.limits.get(this.by)),this.slider.value=String(this.step(this.limits.get(this.by))),this.slider.setAttribute("aria-valuetext",this.limit.value),this.unit.textContent=t.unit,this.count()}moved(){let t=this.at(Number(this.slider.value));this.limits.set(this.by,t),this.limit.value=String(t),this.slider.setAttribute("aria-valuetext",ye(String(t),this.criterion.unit)),this.soon()}setLimit(){let t=this.limit.value.trim()?Number(this.limit.value.replace(",",".")):NaN;if(!(t>=0))return this.model.say("studio_point.number_missing",{field:_("studio_decide.limit")},"bad");this.limits.set(this.by,t),this.slider.value=String(this.step(t)),this.count()}drawn(t){this.draw.checked=!0,this.count().then(t)}async count(){let t=++this.turn;this.reject.disabled=!0,this.counts.setAttribute("aria-busy","true");try{let e=await Pt("/api/selection",{by:this.by,limit:this.limits.get(this.by)});t===this.turn&&this.report(e)}catch(e){this.model.fail(e)}}report(t){ei.show(this.draw.checked?t.rows:[]);let e=t.used?100*t.observations/t.used:0;this.counts.setAttribute("aria-busy","false"),this.counts.textContent=_("studio_decide.counts",{n:t.observations,points:t.points,percent:Mt(e,2),used:t.used}),this.hand.textContent=t.marks?_("studio_decide.marks_beyond",{n:t.marks}):"",this.command.textContent=t.command,this.reject.disabled=!t.observations,this.shows.forEach(r=>r.disabled=!t.observations);let i=t.rows.slice(0,wp).map(([r,o])=>u("li",{},Xt(_("studio_decide.point_in_image",{point:o,image:r}),_("studio_decide.show_point",{point:o,image:r}),()=>this.ways.visit(o,r),"link"))),s=t.observations-i.length;this.list.hidden=!i.length,this.list.replaceChildren(u("ul",{},...i),...s>0?[u("p",{class:"note"},_("studio_decide.more",{n:s,drawn:t.all_shown?"all":"some"}))]:[])}async rejectAll(){this.reject.disabled=!0;let t=this.limits.get(this.by);try{let e=await this.model.actions.reject(this.by,t);this.model.command=e.command,this.model.take(e.state),this.model.say("studio_decide.rejected",{limit:Mt(t),quantity:this.by},"good")}catch(e){this.model.fail(e),await this.count()}}};var qt={brightness:1,contrast:1,vectors:40,filter:"worst",loupe:!1,linked:!0,snap:"auto"},zs=["auto","ellipse","corner","cross","patch","hand"],ie={used:"#56b4e9",weak:"#e69f00",rejected:"#d55e00",control:"#f0e442",check:"#2fc79a",mark:"#f5a3cf",current:"#ffffff",predicted:"#f0e442",beyond:"#ff5ad1",masked:"#ff7f2a",off:"#ff3b30"},jl=()=>qt.brightness===1&&qt.contrast===1?"none":`brightness(${qt.brightness}) contrast(${qt.contrast})`;var Mp=20,Jl=2*Math.PI;function Qr(n,t,e){return n.rejected[t]||e.has(n.point[t])?"rejected":n.role[t]===1?"control":n.role[t]===2?"check":n.rays[t]<3?"weak":"used"}function Ql(n,t,e){let i=[...n.x.keys()];if(t==="none")return[];if(t==="worst")return i.filter(r=>n.w[r]!==null).sort((r,o)=>n.w[o]-n.w[r]).slice(0,Mp);if(t==="all")return i;let s=t==="control"?["control","check"]:[t];return i.filter(r=>s.includes(Qr(n,r,e)))}function tu(n,t,e,i,s,r=9){let o=-1,a=r;for(let l of t){let[c,h]=e.toScreen(n.x[l],n.y[l]),d=Math.hypot(c-i,h-s);d<a&&(a=d,o=l)}return o}function eu(n,t,e,i){n.setTransform(i,0,0,i,0,0);let{observations:s}=e;if(s){let r=Ql(s,qt.filter,e.rejectedHere);Sp(n,t,s,r),Tp(n,t,s,r,e),Ap(n,t,s,e.image)}e.prediction&&Pp(n,t,e.prediction,e.current);for(let r of e.marks)Rp(n,t,r,r.mark.point===e.current,e.off);for(let r of e.fiducials)Cp(n,t,r,r.name===e.fiducial);e.hair&&Lp(n,t)}function Sp(n,t,e,i){if(qt.vectors<=0)return;let s=qt.vectors/t.scale;for(let[r,o]of[["#00000099",2.8],[ie.used,1.3]]){n.strokeStyle=r,n.lineWidth=o,n.beginPath();for(let a of i){let l=e.vx[a],c=e.vy[a];l===null||c===null||(n.moveTo(...t.toScreen(e.x[a],e.y[a])),n.lineTo(...t.toScreen(e.x[a]+l*s,e.y[a]+c*s)))}n.stroke()}}function Ep(n,t,e,i,s){let r=t==="control"||t==="check"?6:s;t==="rejected"?(n.moveTo(e-r,i-r),n.lineTo(e+r,i+r),n.moveTo(e+r,i-r),n.lineTo(e-r,i+r)):t==="control"?(n.moveTo(e,i-r),n.lineTo(e+r,i+.75*r),n.lineTo(e-r,i+.75*r),n.closePath()):t==="check"?(n.moveTo(e,i-r),n.lineTo(e+r,i),n.lineTo(e,i+r),n.lineTo(e-r,i),n.closePath()):t==="weak"?n.rect(e-r,i-r,2*r,2*r):(n.moveTo(e+r,i),n.arc(e,i,r,0,Jl))}function Tp(n,t,e,i,s){let r=Math.min(Math.max(2.6*Math.sqrt(t.scale),1.6),4);for(let o of["used","weak","rejected","check","control"]){n.beginPath();for(let a of i){if(Qr(e,a,s.rejectedHere)!==o)continue;let[l,c]=t.toScreen(e.x[a],e.y[a]);l<-9||c<-9||l>t.width+9||c>t.height+9||Ep(n,o,l,c,r)}n.lineWidth=r<2.5?2.2:3,n.strokeStyle="#000000a0",n.stroke(),n.lineWidth=r<2.5?1.2:1.6,n.strokeStyle=ie[o],n.stroke()}if(s.hover>=0&&s.hover<e.x.length){let[o,a]=t.toScreen(e.x[s.hover],e.y[s.hover]);Hs(n,o,a,9,"#ffffff")}}function Ap(n,t,e,i){if(ei.points.size)for(let[s,r]of e.point.entries()){if(!ei.has(i,r))continue;let[o,a]=t.toScreen(e.x[s],e.y[s]);o<-16||a<-16||o>t.width+16||a>t.height+16||Hs(n,o,a,8,ie.beyond)}}function Hs(n,t,e,i,s){n.beginPath(),n.arc(t,e,i,0,Jl),Xi(n,s,1.6)}function Xi(n,t,e){n.lineWidth=e+2,n.strokeStyle="#000000b0",n.stroke(),n.lineWidth=e,n.strokeStyle=t,n.stroke()}function Rp(n,t,{mark:e,x:i,y:s},r,o){let[a,l]=t.toScreen(i,s),c=r?11:8,h=r&&o?ie.off:r?ie.current:ie.mark;n.beginPath();for(let[d,p]of[[1,0],[-1,0],[0,1],[0,-1]])n.moveTo(a+2.5*d,l+2.5*p),n.lineTo(a+c*d,l+c*p);Xi(n,h,r?2:1.6),r&&Hs(n,a,l,14,o?ie.off:ie.mark),Vs(n,r&&o?`${e.point} !`:e.point,a+c+4,l-7,h)}function Cp(n,t,e,i){let[s,r]=t.toScreen(e.x,e.y),o=i?ie.current:ie.control;n.beginPath(),n.rect(s-9,r-9,18,18);for(let[a,l]of[[1,0],[-1,0],[0,1],[0,-1]])n.moveTo(s+3*a,r+3*l),n.lineTo(s+9*a,r+9*l);Xi(n,o,1.6),Vs(n,e.name,s+14,r-7,o)}function Vs(n,t,e,i,s){n.font="600 12.5px system-ui, 'Noto Sans', 'Liberation Sans', sans-serif",n.textBaseline="middle",n.lineJoin="round",n.lineWidth=3.5,n.strokeStyle="#000000c8",n.strokeText(t,e,i),n.fillStyle=s,n.fillText(t,e,i)}function Pp(n,t,e,i){if(e.segment&&Ip(n,t,e),e.x===null||e.y===null)return;let[s,r]=t.toScreen(e.x,e.y),o=Math.atan2(t.sin,t.cos);if(e.ellipse){let a=e.ellipse.angle_deg*Math.PI/180+o;for(let l of[1,3])n.beginPath(),n.setLineDash(l===3?[5,4]:[]),n.ellipse(s,r,l*e.ellipse.a*t.scale,l*e.ellipse.b*t.scale,a,0,Jl),Xi(n,ie.predicted,1.4);n.setLineDash([])}Hs(n,s,r,3,ie.predicted),(!e.ellipse||e.ellipse.a*t.scale<12)&&(n.setLineDash([3,4]),Hs(n,s,r,20,ie.predicted),n.setLineDash([])),Vs(n,`${i} ?`,s+16,r+17,ie.predicted)}function Ip(n,t,e){n.beginPath(),e.segment.forEach(([i,s],r)=>r?n.lineTo(...t.toScreen(i,s)):n.moveTo(...t.toScreen(i,s))),n.lineJoin="round",e.segment_sigma_px!==null&&(n.lineWidth=Math.max(6*e.segment_sigma_px*t.scale,2),n.strokeStyle="#f0e44238",n.stroke()),Xi(n,ie.predicted,1.2)}function Lp(n,t){let[e,i]=[t.width/2,t.height/2];n.beginPath();for(let[s,r]of[[1,0],[-1,0],[0,1],[0,-1]])n.moveTo(e+5*s,i+5*r),n.lineTo(e+26*s,i+26*r);Xi(n,"#ffffff",1.2)}var Dp=2*Math.PI,Up=400,Np=5,jn=[["used",ie.used,"\u25EF"],["rejected",ie.rejected,"\u2297"],["apart",ie.check,"\u25CC"],["unidentified",ie.weak,"\u25CD"]],Fp={used:[],rejected:[],apart:[6,4],unidentified:[2,3]};function nu(n,t,e){let i=Math.atan2(t.sin,t.cos),s=e.rows.filter(o=>{let[a,l]=t.toScreen(o.x,o.y);return a>-40&&l>-40&&a<t.width+40&&l<t.height+40});for(let[o,a]of jn)for(let l of s.filter(c=>c.fate===o))Op(n,t,l,a,i);let r=[];for(let[o,a]of jn)for(let l of s.filter(c=>c.fate===o)){let[c,h]=t.toScreen(l.x,l.y),d=t.scale>1.5&&l.s!==null?` \xB1 ${pt(l.s,3)} px`:"",p=`${l.name}${d}`,m=su(l,t)+9;p&&r.length<Up&&kp(r,[c-5,h-m-7,7.6*p.length,14])&&Vs(n,p,c-5,h-m,a)}}var su=(n,t)=>Math.max((n.ellipse?.a??0)*t.scale,Np);function Op(n,t,e,i,s){let[r,o]=t.toScreen(e.x,e.y),a=su(e,t);n.setLineDash(Fp[e.fate]),n.beginPath(),e.ellipse?n.ellipse(r,o,a,a*e.ellipse.b/e.ellipse.a,e.ellipse.angle_deg*Math.PI/180+s,0,Dp):n.rect(r-a,o-a,2*a,2*a),Xi(n,i,1.8),n.setLineDash([]),e.fate==="rejected"?iu(n,r,o,a+3,i):t.scale>1&&iu(n,r,o,3,i)}function kp(n,t){let[e,i,s,r]=t;return n.some(([o,a,l,c])=>e<o+l&&o<e+s&&i<a+c&&a<i+r)?!1:(n.push(t),!0)}function iu(n,t,e,i,s){n.beginPath(),n.moveTo(t-i,e-i),n.lineTo(t+i,e+i),n.moveTo(t+i,e-i),n.lineTo(t-i,e+i),Xi(n,s,1.2)}var tc=class{constructor(){this.on=!1;this.families=null;this.reason="";this.found=new Map;this.requested=new Set;this.sought=new Set;this.listeners=[]}onchange(t){this.listeners.push(t)}changed(){this.listeners.forEach(t=>t())}switch(t){this.on=t,this.changed()}choose(t){t!==this.families&&(this.families=t,this.forget())}get query(){return this.families===null?{}:{families:this.families}}forget(){this.found.clear(),this.requested.clear(),this.changed()}of(t){let e=this.found.get(t);return!e&&!this.requested.has(t)&&this.read(t),e??null}async read(t){this.requested.add(t);try{let e=await Pt("/api/targets/image",{image:t,...this.query});this.found.set(t,e),this.reason=e.why||(e.families?"":_("studio_target.name_family"));let i=`${t} ${e.families}`;!e.from&&!e.why&&e.families&&!this.sought.has(i)&&(this.sought.add(i),await Ee("/api/targets",{families:e.families,images:[t]}))}catch(e){this.reason=e.message}this.changed()}},Te=new tc;var ru=["label.image","studio_target.found","studio_target.used","studio_target.rejected","studio_target.apart","studio_target.unidentified","studio_target.median_sigma","studio_target.source"],to=class{constructor(t,e){this.model=t;this.ways=e;this.root=u("section",{class:"leaf","aria-label":_("studio_decide.targets")});this.family=u("input",{type:"text",id:"targets-family",list:"targets-known",placeholder:_("studio_target.family"),autocomplete:"off",spellcheck:"false"});this.known=u("datalist",{id:"targets-known"});this.forms=u("p",{class:"note"});this.go=yt("studio_target.find",()=>void this.begin(),"main");this.status=u("p",{class:"note",role:"status"});this.body=u("tbody",{});this.one=u("div",{});this.sheet=new Li("sheet",()=>{});this.command=u("code",{class:"command"});this.files=u("span",{class:"links"});this.go.id="targets-begin";let i=yt("studio_target.make_sheet",()=>void this.print(),"main");i.id="sheet-make",this.family.addEventListener("change",()=>{Te.choose(this.family.value.trim()),this.show()}),this.root.append(u("div",{class:"deeds first"},u("label",{for:"targets-family"},_("studio_target.family")),this.family,this.known,this.go),this.forms,this.status,u("table",{class:"figures-of","aria-label":_("studio_target.by_photograph"),id:"targets-by-photograph"},Ne(ru,[ru.length-1]),this.body),this.one,u("h3",{},_("studio_target.sheet")),u("p",{class:"note"},_("studio_target.sheet_note")),this.sheet.root,u("div",{class:"deeds"},i,this.files),u("p",{},this.command)),Te.onchange(()=>this.root.offsetParent&&void this.details())}async show(){let[t,e]=await Promise.all([Pt("/api/targets",Te.query),Pt("/api/sheet")]);document.activeElement!==this.family&&(this.family.value=t.families),this.known.replaceChildren(...t.known.map(s=>u("option",{value:s}))),this.forms.textContent=_("studio_target.families",{names:t.forms.join("; ")}),this.go.disabled=!t.families;let i=t.images.every(s=>s.found===null);this.status.textContent=t.families?i?_("studio_target.none_stored"):"":_("studio_target.family_missing"),this.status.hidden=!this.status.textContent,this.body.replaceChildren(...t.images.map(s=>this.row(s))),this.take(e),await this.details()}row(t){let e=t.why||t.remarks.join("; ");return u("tr",{},u("th",{scope:"row"},Xt(t.image,_("studio_target.show",{image:t.image}),()=>this.look(t.image),"link")),u("td",{},t.found===null?"\u2013":String(t.found)),...jn.map(([i])=>u("td",{},t.found===null?"\u2013":String(t.fates[i]??0))),u("td",{},pt(t.median_s,3)),u("td",{class:`l ${t.why?"doubt":""}`},[t.from&&_("studio_target.origin",{origin:t.from}),e].filter(i=>i).join("; ")||_("studio_target.not_found")))}look(t){Te.switch(!0),this.ways.images(t)}async details(){let t=this.model.panes[this.model.active];if(!t)return;let e=await Pt("/api/targets/image",{image:t,...Te.query}),i=e.rows.slice(0,500).map(s=>u("tr",{},u("th",{scope:"row"},s.name||"\u2013"),u("td",{},pt(s.x,2)),u("td",{},pt(s.y,2)),u("td",{},pt(s.s,3)),u("td",{},s.ellipse?pt(s.ellipse.a,2):"\u2013"),u("td",{},s.ellipse?pt(s.ellipse.b,2):"\u2013"),u("td",{class:"l"},_("studio_target.fate",{fate:s.fate}))));this.one.replaceChildren(...i.length?[u("details",{},u("summary",{},_("studio_target.of_image",{image:t,n:e.rows.length})),u("table",{class:"figures-of","aria-label":_("studio_target.of_image",{image:t,n:e.rows.length})},Ne(["label.name","studio_table.x","studio_table.y","studio_target.sigma","studio_target.semi_axis_a","studio_target.semi_axis_b","label.status"],[6]),u("tbody",{},...i)))]:[])}async begin(){try{await Ee("/api/targets",{families:this.family.value.trim(),images:[]}),this.model.say("studio_target.finding")}catch(t){this.model.fail(t)}}async print(){try{let t=Object.fromEntries(Object.entries(this.sheet.values()).filter(([,e])=>e!==null));this.take(await Ee("/api/sheet",{values:t})),this.model.say("studio_target.sheet_made",{},"good")}catch(t){this.model.fail(t)}}take(t){this.sheet.fill(t.fields),this.command.textContent=t.command,this.files.replaceChildren(...t.files.map(e=>u("a",{href:`/sheet/${e}`,download:e},e)))}};var eo=class{constructor(t,e,i){this.model=t;this.isOpen=e;this.now=0;this.leaves=[["run","studio_decide.run",new jr(t)],["options","studio_decide.options",new Zr(t)],["parameters","studio_decide.parameters",new Xr(t)],["select","studio_decide.select",new Jr(t,i)],["compare","studio_decide.compare",new $r(t,i)],["calibration","studio_decide.calibration",new qr(t)],["targets","studio_decide.targets",new to(t,i)],["report","studio_page.report",new Yr]],this.heads=this.leaves.map(([s,r],o)=>{let a=yt(r,()=>this.turn(o));return a.id=`decide-${s}`,a}),nt("decide-bar").append(u("span",{class:"group",role:"group","aria-label":_("studio_decide.parts")},...this.heads)),nt("decide").append(...this.leaves.map(([,,s])=>s.root)),this.turn(1),t.on(["read","state","targets"],()=>this.isOpen()&&this.show())}turn(t){this.now=t,this.heads.forEach((e,i)=>e.setAttribute("aria-pressed",String(i===t))),this.leaves.forEach(([,,e],i)=>e.root.hidden=i!==t),this.isOpen()&&this.show()}show(){this.leaves[this.now][2].show().catch(t=>this.model.fail(t))}};var Bp=9,ec=class{constructor(){this.on=!1;this.image="";this.corners=[];this.calls=[]}onchange(t){this.calls.push(t)}begin(t="",e=[]){this.on=!0,this.image=t,this.set(e)}end(){this.on=!1,this.image="",this.set([])}add(t,e){return this.image&&t!==this.image?!1:(this.image=t,this.set([...this.corners,e]),!0)}move(t,e){this.set(this.corners.map((i,s)=>s===t?e:i))}removeLast(){this.set(this.corners.slice(0,-1)),this.corners.length||(this.image="")}cornerAt(t,e,i,s){return!this.on||t!==this.image?-1:this.corners.findIndex(([r,o])=>{let[a,l]=e.toScreen(r,o);return Math.hypot(a-i,l-s)<Bp})}set(t){this.corners=t;for(let e of this.calls)e()}},Kt=new ec;var zp="http://www.w3.org/2000/svg",[io,no,Jn,ic,ou,Hp]=[420,210,52,12,10,30],Vp=1.96;function Gs(n){let t=10**Math.floor(Math.log10(n));return[t*([5,2,1].find(i=>i*t<=n*1.0001)??1),n<1?{per:1e3,name:"mm"}:{per:1,name:"m"}]}var qi=(n,t,e="")=>{let i=document.createElementNS(zp,n);for(let[s,r]of Object.entries(t))i.setAttribute(s,String(r));return i.textContent=e,i};function Gp(n,t){let[e]=Gs((t-n)/3),i=[];for(let s=Math.ceil(n/e)*e;s<=t+e*1e-9;s+=e)i.push(Math.abs(s)<e*1e-9?0:s);return i}function au(n,t,e,i){let s=[n.first,...n.at].map(E=>Date.parse(t[E])/864e5),r=[0,...n.along.map(E=>E*e.per)],o=[0,...n.along_sigma.map(E=>Vp*E*e.per)],[a,l]=[Date.parse(t[0])/864e5,Date.parse(t[t.length-1])/864e5],c=Math.min(...r.map((E,S)=>E-o[S])),h=Math.max(...r.map((E,S)=>E+o[S])),d=.08*(h-c||1),p=E=>Jn+6+(io-Jn-ic-12)*((E-a)/(l-a||1)),m=E=>ou+(no-ou-Hp)*((h+d-E)/(h-c+2*d)),v=(E,S)=>`${p(E).toFixed(1)},${m(S).toFixed(1)}`,b=qi("svg",{viewBox:`0 0 ${io} ${no}`,role:"img","aria-label":_("studio_epochs.over_time",{name:n.name,n:n.points?.length??0})}),g=Gp(c-d,h+d),f=Math.max(0,-Math.floor(Math.log10(Math.abs((g[1]??1)-(g[0]??0))||1)+1e-9));for(let E of g)b.append(qi("line",{class:E?"level":"zero",x1:Jn,x2:io-ic,y1:m(E),y2:m(E)}),qi("text",{x:Jn-6,y:m(E)+4,"text-anchor":"end"},oi(E.toFixed(f))));b.append(qi("polygon",{class:"band",points:[...s.map((E,S)=>v(E,r[S]+o[S])),...s.map((E,S)=>v(E,r[S]-o[S])).reverse()].join(" ")}),qi("polyline",{class:"line",points:s.map((E,S)=>v(E,r[S])).join(" ")})),s.forEach((E,S)=>{let I=S?n.at[S-1]:n.first,P=S>0&&n.moved[S-1];b.append(qi("line",{class:"bar",x1:p(E),x2:p(E),y1:m(r[S]-o[S]),y2:m(r[S]+o[S])}),qi("circle",{class:`${P?"sure":"open"}${I===i?" now":""}`,cx:p(E),cy:m(r[S]),r:I===i?5:3.5}))});let R=-1e9;for(let E of t){let S=p(Date.parse(E)/864e5);if(S-R<72)continue;let I=S<Jn+30?"start":S>io-ic-30?"end":"middle";b.append(qi("text",{x:S,y:no-12,"text-anchor":I},E)),R=S}return b.append(qi("text",{x:Jn-12,y:no-12,"text-anchor":"end"},e.name)),b}var Wp=[1,0,-1,0],Xp=[0,1,0,-1],rn=class{constructor(t,e,i){this.columns=t;this.rows=e;this.turn=i;this.scale=1;this.width=1;this.height=1;this.fitted=!0;this.x=t/2,this.y=e/2}get cos(){return Wp[this.turn&3]}get sin(){return Xp[this.turn&3]}toScreen(t,e){let i=(t-this.x)*this.scale,s=(e-this.y)*this.scale;return[this.width/2+this.cos*i-this.sin*s,this.height/2+this.sin*i+this.cos*s]}toImage(t,e){let[i,s]=this.along((t-this.width/2)/this.scale,(e-this.height/2)/this.scale);return[this.x+i,this.y+s]}along(t,e){return[this.cos*t+this.sin*e,-this.sin*t+this.cos*e]}inside(t,e){return t>=0&&e>=0&&t<=this.columns&&e<=this.rows}get whole(){let t=this.turn&1;return Math.min(this.width/(t?this.rows:this.columns),this.height/(t?this.columns:this.rows))}fit(){this.x=this.columns/2,this.y=this.rows/2,this.scale=this.whole*.98,this.fitted=!0}resize(t,e){this.width=Math.max(t,1),this.height=Math.max(e,1),this.fitted&&this.fit()}zoomAt(t,e=this.width/2,i=this.height/2){let[s,r]=this.toImage(e,i);this.scale=Math.min(Math.max(this.scale*t,Math.min(this.whole/2,1)),64);let[o,a]=this.toImage(e,i);this.centre(this.x+s-o,this.y+r-a)}panBy(t,e){let[i,s]=this.along(t/this.scale,e/this.scale);this.centre(this.x-i,this.y-s)}centre(t,e){this.fitted=!1,this.x=Math.min(Math.max(t,0),this.columns),this.y=Math.min(Math.max(e,0),this.rows)}seen(){let[t,e]=this.toImage(0,0),[i,s]=this.toImage(this.width,this.height);return[Math.max(Math.min(t,i),0),Math.max(Math.min(e,s),0),Math.min(Math.max(t,i),this.columns),Math.min(Math.max(e,s),this.rows)]}apply(t,e,i=[0,0]){let s=this.scale*e,r=(this.width/2+i[0])*e,o=(this.height/2+i[1])*e,{cos:a,sin:l,x:c,y:h}=this;t.setTransform(s*a,s*l,-s*l,s*a,r-s*(a*c-l*h),o-s*(l*c+a*h))}};var lu=400,qp=900,Yp=["moved","untested","every"],[$p,Zp,cu,Kp,hu]=["#d55e00","#0072b2","#7c8792","#009e73","#10151a"],so=class{constructor(t,e,i){this.isOpen=e;this.visit=i;this.found={dates:[],rows:[],picture:null,why:"",unit:"",of:0};this.view=new rn(1,1,0);this.pictures=[];this.at=0;this.against=0;this.chosen="";this.blinking=0;this.before=!1;this.kind="moved";this.usual=1;this.date=u("input",{type:"range",id:"epochs-date",min:0,max:0,step:1,"aria-label":_("studio_epochs.date")});this.dated=u("output",{id:"epochs-dated"});this.other=u("select",{id:"epochs-against","aria-label":_("studio_epochs.against")});this.blink=yt("studio_epochs.blink",()=>this.toggle());this.larger=u("input",{type:"range",id:"epochs-larger",min:-3,max:3,step:1,value:0,"aria-label":_("studio_epochs.larger")});this.enlarged=u("output",{});this.stable=u("input",{type:"checkbox",id:"epochs-stable"});this.canvas=u("canvas",{tabindex:0,role:"img","aria-label":_("studio_epochs.picture")});this.status=u("p",{class:"note",role:"status"});this.box=u("div",{class:"picture"},this.canvas,this.status);this.table=u("div",{class:"wide",tabindex:0,"aria-label":_("studio_epochs.moved_when")});this.chart=u("div",{class:"chart"});this.shown=u("select",{id:"epochs-kind","aria-label":_("studio_epochs.rows")},...xe(Yp,t=>_("studio_epochs.kind",{kind:t}),"moved"));this.count=u("span",{class:"note"});this.drawSoon=vi(()=>this.draw());nt("epochs-bar").append(u("label",{},_("studio_epochs.date"),this.date),this.dated,u("label",{},_("studio_epochs.against"),this.other),this.blink,u("label",{},_("studio_epochs.larger"),this.larger),this.enlarged,u("label",{},this.stable,_("studio_epochs.stable")),yt("studio_epochs.whole",()=>this.fit())),nt("epochs-legend").append(...[["near","\u25CF"],["away","\u25CF"],["open","\u25CF"],["arrow","\u2192"]].map(([s,r])=>u("li",{},u("span",{class:`sign ${s}`},r),_("studio_epochs.legend",{part:s})))),nt("epochs").append(this.box,u("div",{class:"side"},u("div",{class:"deeds first"},this.shown,this.count),this.table,this.chart)),this.date.addEventListener("input",()=>this.turnTo(Number(this.date.value))),this.other.addEventListener("change",()=>this.against=Number(this.other.value)),this.larger.addEventListener("input",this.drawSoon),this.stable.addEventListener("change",this.drawSoon),this.shown.addEventListener("change",()=>{this.kind=this.shown.value,this.list()}),this.mouse(),new ResizeObserver(()=>this.drawSoon()).observe(this.box),t.on("read",()=>void this.read().catch(()=>{}))}async read(){let t=await Pt("/api/epochs");if(nt("tab-epochs").hidden=!t.dates.length,t.of===this.found.of&&t.dates.length===this.found.dates.length||(this.found=t,this.pictures=t.dates.map(()=>null),!t.dates.length))return;let{width:e,height:i}=t.picture??{width:1,height:1};this.view=new rn(e,i,0),this.date.max=String(t.dates.length-1),this.other.replaceChildren(...t.dates.map((r,o)=>u("option",{value:o},r))),this.usual=this.usualFactor();let s=this.rows("moved");this.chosen=s[0]?.name??"",this.turnTo(t.dates.length-1),this.isOpen()&&this.show()}show(){this.list(),this.fit()}fit(){this.view.fit(),this.drawSoon()}turnTo(t){this.at=t,this.date.value=String(t),this.date.setAttribute("aria-valuetext",this.found.dates[t]),this.dated.textContent=this.found.dates[t],this.list(),this.drawSoon()}toggle(){clearInterval(this.blinking),this.before=!1;let t=this.blink.getAttribute("aria-pressed")!=="true";this.blink.setAttribute("aria-pressed",String(t)),this.blinking=t?window.setInterval(()=>{this.isOpen()&&(this.before=!this.before,this.drawSoon())},qp):0,this.drawSoon()}usualFactor(){let{picture:t}=this.found,e=this.rows("moved").map(r=>Math.max(...r.length)).sort((r,o)=>r-o);if(!t||!e.length)return 1;let i=Math.max(t.width,t.height)*this.pixel/18/Math.max(e[Math.floor(.9*(e.length-1))],1e-12),s=10**Math.floor(Math.log10(i));return s*([5,2,1].find(r=>r*s<=i)??1)}get pixel(){return this.found.picture?.pixel??1}get factor(){return this.usual*2**Number(this.larger.value)}image(t){if(!this.found.picture)return null;let e=this.pictures[t];return e||(e=this.pictures[t]=u("img",{src:`/figure/date/${t}.jpg?of=${this.found.of}`,alt:""}),e.addEventListener("load",this.drawSoon),e.addEventListener("error",()=>{this.status.textContent=_("studio_epochs.no_picture",{date:this.found.dates[t]}),this.status.hidden=!1})),e}draw(){if(!this.isOpen()||!this.found.dates.length)return;let{view:t,canvas:e}=this,i=window.devicePixelRatio||1,{clientWidth:s,clientHeight:r}=this.box;t.resize(s,r),[e.width,e.height]=[Math.round(s*i),Math.round(r*i)];let o=e.getContext("2d");o.fillStyle="#2b2b2b",o.fillRect(0,0,e.width,e.height);let a=this.before?this.against:this.at,l=this.image(a),c=!!(l?.complete&&l.naturalWidth);this.status.hidden=c,this.status.textContent=l?_("studio_epochs.rectifying",{date:this.found.dates[a]}):this.found.why,l&&c&&(t.apply(o,i),o.drawImage(l,0,0,t.columns,t.rows)),o.setTransform(i,0,0,i,0,0),this.enlarged.textContent=`${fi(Math.round(this.factor*100)/100)} \xD7`;for(let h of this.found.rows)h.verdict==="stable"&&!h.area&&this.stable.checked&&this.dot(o,h,2);for(let h of this.found.rows)h.verdict!=="stable"&&this.vector(o,h);this.label(o,r)}label(t,e){t.font="600 15px system-ui, sans-serif",t.lineWidth=4,t.strokeStyle="rgba(0, 0, 0, .7)",t.fillStyle="#fff";let i=this.found.dates[this.before?this.against:this.at];t.strokeText(i,12,24),t.fillText(i,12,24);let[s,r]=Gs(60/this.view.scale*this.pixel/this.factor),o=s/this.pixel*this.factor*this.view.scale,a=this.found.unit?ye(Mt(s*r.per,2),r.name):Mt(s,2);uu(t,14,e-18,14+o,e-18,hu,2),t.lineWidth=4,t.lineJoin="round",t.strokeStyle="rgba(0, 0, 0, .7)",t.font="13px system-ui, sans-serif",t.strokeText(a,22+o,e-14),t.fillText(a,22+o,e-14)}dot(t,e,i){if(!e.place)return;let[s,r]=this.view.toScreen(...e.place);t.fillStyle=Kp,t.beginPath(),t.arc(s,r,i,0,7),t.fill()}vector(t,e){if(!e.place||e.between)return;let[i,s]=this.view.toScreen(...e.place),r=e.at.indexOf(this.at),o=e.name===this.chosen,a=r>=0&&e.moved[r],[l,c,h]=r>=0?e.seen[r]:[0,0,0],d=this.factor/this.pixel*this.view.scale,p=a?h<0?Zp:$p:cu;Math.hypot(l,c)*d>2&&uu(t,i,s,i+l*d,s-c*d,a?hu:cu,e.area||o?3:1.5),t.fillStyle=p,t.strokeStyle=o?"#fff":"rgba(255, 255, 255, .75)",t.lineWidth=o?3:1,t.beginPath(),t.arc(i,s,Math.min(Math.max(2.5,.12*Math.abs(h)*d),9)+(e.area||o?3:0),0,7),t.fill(),t.stroke()}mouse(){let{canvas:t}=this,e=null,i=0;t.addEventListener("pointerdown",s=>{e=[s.offsetX,s.offsetY],i=0,t.setPointerCapture(s.pointerId)}),t.addEventListener("pointermove",s=>{if(!e)return;let[r,o]=[s.offsetX-e[0],s.offsetY-e[1]];i+=Math.hypot(r,o),e=[s.offsetX,s.offsetY],this.view.panBy(r,o),this.drawSoon()}),t.addEventListener("pointerup",s=>{e&&i<4&&this.pick(s.offsetX,s.offsetY),e=null}),t.addEventListener("wheel",s=>{s.preventDefault(),this.view.zoomAt(Math.exp(-s.deltaY*.0016),s.offsetX,s.offsetY),this.drawSoon()},{passive:!1}),t.addEventListener("keydown",s=>{let r={ArrowRight:1,ArrowLeft:-1}[s.key];r&&(s.preventDefault(),this.turnTo(Math.min(Math.max(this.at+r,0),this.found.dates.length-1)))})}pick(t,e){let i=14,s="";for(let r of this.found.rows){if(!r.place||r.between||r.verdict==="stable")continue;let[o,a]=this.view.toScreen(...r.place),l=Math.hypot(o-t,a-e);l<i&&([i,s]=[l,r.name])}s&&this.choose(s)}rows(t){let e=this.found.rows.filter(s=>s.at&&s.verdict!=="stable"&&(t==="every"||(t==="untested"?s.verdict==="untested":s.verdict==="moved"||s.verdict==="moved_area"))),i=s=>Number(s.area&&!s.between);return e.sort((s,r)=>i(r)-i(s)||Number(r.area)-Number(s.area)||Math.max(...r.length)-Math.max(...s.length))}choose(t){this.chosen=t,this.list(),this.drawSoon(),this.table.querySelector("tr.at")?.scrollIntoView({block:"nearest"})}list(){if(!this.isOpen())return;let{dates:t}=this.found,e=this.rows(this.kind),i=e.slice(0,lu),s=Math.max(...e.flatMap(h=>h.length),.001),r=this.found.rows.find(h=>h.name===this.chosen&&h.at);r&&!i.includes(r)&&i.unshift(r),this.count.textContent=_("studio_epochs.count",{n:e.length,shown:Math.min(e.length,lu),unit:this.found.unit?Gs(s)[1].name:"\u2013"});let[,o]=Gs(s),a=this.found.unit?o:{per:1,name:""},l=u("thead",{},u("tr",{},u("th",{scope:"col"},_("studio_epochs.point")),u("th",{scope:"col"},_("studio_epochs.since")),...t.slice(1).map((h,d)=>u("th",{scope:"col",class:d+1===this.at?"now":""},h))));this.table.replaceChildren(u("table",{"aria-label":_("studio_epochs.moved_when")},l,u("tbody",{},...i.map(h=>this.row(h,a.per)))));let c=r&&!r.area?yt("studio_epochs.visit",()=>this.visit(r.name)):"";this.chart.replaceChildren(...r?[u("h3",{},_("studio_epochs.over_time",{name:r.name,n:r.points?.length??0})),au(r,t,a,this.at),r.between?u("p",{class:"note"},_("studio_epochs.mean_of_uneven")):"",u("p",{class:"note"},this.axes(r,a)),c]:[u("p",{class:"note"},_("studio_epochs.nothing_chosen"))])}row(t,e){let i=t.at.find((o,a)=>t.moved[a]),s=this.found.dates.slice(1).map((o,a)=>{let l=t.at.indexOf(a+1);if(l<0)return u("td",{},"\u2013");let c=ke(t.sigma[l]*e);return t.between?u("td",{class:t.moved[l]?"sure":""},_("studio_epochs.uneven",{least:pt(t.between[l][0]*e,c),largest:pt(t.between[l][1]*e,c)})):u("td",{class:t.moved[l]?"sure":""},`${pt(t.length[l]*e,c)} \xB1 ${pt(t.sigma[l]*e,c)}`)}),r=Xt(t.name,_("studio_epochs.choose",{name:t.name}),()=>this.choose(t.name),"link");return u("tr",{class:t.name===this.chosen?"at":"",onclick:()=>this.choose(t.name)},u("th",{scope:"row"},r),u("td",{class:"l"},i===void 0?_("studio_epochs.verdict",{verdict:t.verdict}):this.found.dates[i]),...s)}axes(t,e){let i=t.at.indexOf(this.at);if(i<0)return _("studio_epochs.no_place",{date:this.found.dates[this.at]});let s=["X","Y","Z"].map((r,o)=>{let a=ke(t.s[i][o]*e.per);return`d${r} ${pt(t.d[i][o]*e.per,a)} \xB1 ${pt(t.s[i][o]*e.per,a)}`});return _("studio_epochs.at_date",{from:this.found.dates[t.first],to:this.found.dates[this.at],values:ye(s.join(", "),e.name)})}};function uu(n,t,e,i,s,r,o){let a=Math.atan2(s-e,i-t),l=Math.min(4+2*o,Math.hypot(i-t,s-e));for(let[c,h]of[["rgba(255, 255, 255, .75)",2.5],[r,0]]){n.strokeStyle=c,n.lineWidth=o+h,n.beginPath(),n.moveTo(t,e),n.lineTo(i,s);for(let d of[2.7,-2.7])n.moveTo(i,s),n.lineTo(i+l*Math.cos(a+d),s+l*Math.sin(a+d));n.stroke()}}var ro=class{constructor(t){this.model=t;this.rows=u("table",{"aria-label":_("studio_point.fiducials")});this.head=u("summary",{},_("studio_point.fiducials"));this.about=u("p",{class:"note"});this.card=u("details",{class:"card",id:"fiducials",open:!0,hidden:!0},this.head,this.about,this.rows,yt("studio_point.find_fiducials",()=>void this.find()));nt("right").prepend(this.card),t.on(["state","overview","panes","fiducial"],()=>this.show())}async find(){let{model:t}=this,e=t.panes[t.active];try{let i=await t.actions.fiducials(e);t.take(i.state);let s=Object.entries(i.left).map(([r,o])=>`${r}: ${o}`);t.show([_("studio_point.fiducials_found",{n:i.found.length}),...s].join("; "),s.length?"bad":"good","studio_point.fiducials_found"),t.chooseFiducial("")}catch(i){t.fail(i)}}show(){let{model:t}=this,e=t.overview.fiducials;this.card.hidden=!e.length;let i=t.panes[t.active];if(!e.length||!i)return;let s=new Map(t.fiducialsIn(i).map(r=>[r.name,r]));this.head.textContent=_("studio_point.fiducials_of",{image:i,n:s.size,of:e.length}),this.about.textContent=t.fiducial?_("studio_point.click_fiducial",{name:t.fiducial}):_("studio_point.fiducials_note"),this.rows.replaceChildren(...e.map(r=>{let o=s.get(r),a=Xt(r,_("studio_point.measure",{name:r}),()=>t.chooseFiducial(t.fiducial===r?"":r),"link");a.setAttribute("aria-pressed",String(t.fiducial===r));let l=()=>void t.act("fiducial",{image:i,name:r},"studio_point.removed",{name:r});return u("tr",{class:t.fiducial===r?"at":""},u("td",{},a),u("td",{},o?`${pt(o.x,1)}; ${pt(o.y,1)}`:"\u2013"),u("td",{},o?_("studio_point.how",{how:o.how}):""),u("td",{},...o?[Xt("\u2715",_("studio_point.remove",{name:r}),l,"small")]:[]))}))}};var Fe=(n,t,e={})=>u("input",{id:n,"aria-label":t,placeholder:t,autocomplete:"off",spellcheck:"false",...e});function Qn(n){let t=n.value.trim().replace(",",".");return t?Number(t):null}function Ws(n,t,e){return e!==null&&Number.isFinite(e)?!0:(n.say("studio_point.number_missing",{field:t.getAttribute("aria-label")},"bad"),t.focus(),!1)}var ts=(n,t)=>t?`${n}: ${t}`:n,oo=class{constructor(t){this.model=t;this.start=Fe("bar-start",_("studio_point.bar_start"),{list:"bar-names"});this.end=Fe("bar-end",_("studio_point.bar_end"),{list:"bar-names"});this.length=Fe("bar-length",_("label.length"),{inputmode:"decimal"});this.sigma=Fe("bar-sigma",_("label.sigma"),{inputmode:"decimal"});this.names=u("datalist",{id:"bar-names"});this.rows=u("table",{"aria-label":_("studio_point.bars")});this.head=u("summary",{},_("studio_point.bars"));let e=u("form",{},u("div",{class:"row"},this.start,this.end,Xt("\u21E4",_("studio_point.last_two"),()=>this.latest())),u("div",{class:"row"},this.length,this.sigma,u("button",{type:"submit",id:"bar-add"},_("studio_point.give")),this.names));e.addEventListener("submit",i=>{i.preventDefault(),this.give()}),nt("right").append(u("details",{class:"card",open:!0},this.head,this.rows,e)),t.on(["state","overview"],()=>this.show()),t.on("current",()=>{!t.current||document.activeElement===this.start||document.activeElement===this.end||this.start.value||(this.start.placeholder=_("studio_point.bar_start_as",{point:t.current}))})}latest(){let t=[...new Set([...this.model.state.marks].reverse().map(e=>e.point))];[this.end.value,this.start.value]=[t[0]??"",t[1]??""],this.length.focus()}async give(){let[t,e]=[Qn(this.length),Qn(this.sigma)];if(!Ws(this.model,this.length,t)||!Ws(this.model,this.sigma,e))return;let[i,s]=[this.start.value.trim(),this.end.value.trim()];await this.model.act("bar",{start:i,end:s,length:t,sigma:e},"studio_point.bar_given",{start:i,end:s,length:String(t)})&&[this.start,this.end,this.length,this.sigma].forEach(o=>o.value="")}show(){let{state:t,overview:e}=this.model,i=e.unit;this.head.textContent=ts(_("studio_point.bars"),t.bars.length),this.length.placeholder=ye(_("label.length"),i||"m"),this.sigma.placeholder=ye(_("label.sigma"),i||"m"),this.names.replaceChildren(...t.points.slice(-200).map(s=>u("option",{value:s.point}))),this.rows.hidden=!t.bars.length,this.rows.replaceChildren(...t.bars.map(s=>u("tr",{},u("td",{},`${s.start} \u2013 ${s.end}`),u("td",{},String(s.length)),u("td",{},`\xB1 ${Mt(s.sigma)}`),u("td",{},Xt("\u2715",_("studio_point.remove",{name:`${s.start} \u2013 ${s.end}`}),()=>void this.model.act("unbar",{start:s.start,end:s.end},"studio_point.removed",{name:`${s.start} \u2013 ${s.end}`}),"small")))))}},ao=class{constructor(t){this.model=t;this.role=u("select",{id:"control-role","aria-label":_("studio_point.role_of_current")},...xe(["tie","control","check"],t=>_("studio_point.role",{role:t})));this.xyz=["X","Y","Z"].map(t=>Fe(`control-${t}`,t,{inputmode:"decimal"}));this.sigma=["X","Y","Z"].map(t=>Fe(`control-s${t}`,_("label.sigma_of",{symbol:t}),{inputmode:"decimal"}));this.rows=u("table",{"aria-label":_("studio_point.control")});this.head=u("summary",{},_("studio_point.control"));this.about=u("p",{class:"note"});let e=u("input",{type:"file",id:"control-file",accept:".csv,.txt,text/csv","aria-label":_("studio_point.control_table")});e.addEventListener("change",()=>void(e.files?.[0]&&this.drop(e.files[0]).then(()=>e.value="")));let i=u("form",{},this.about,u("div",{class:"row"},this.role,u("button",{type:"submit",id:"control-give"},_("studio_point.give"))),u("div",{class:"row three"},...this.xyz),u("div",{class:"row three"},...this.sigma),u("p",{class:"note"},_("studio_point.control_note")),e);i.addEventListener("submit",s=>{s.preventDefault(),this.give()}),nt("right").append(u("details",{class:"card"},this.head,this.rows,i)),t.on(["state","overview"],()=>this.show()),t.on("current",()=>void this.fill()),document.body.dataset.drop=_("studio_point.drop"),this.dropping()}dropping(){addEventListener("dragover",t=>{t.dataTransfer?.types.includes("Files")&&(t.preventDefault(),document.body.classList.add("dropping"))}),addEventListener("dragleave",t=>t.relatedTarget===null&&document.body.classList.remove("dropping")),addEventListener("drop",t=>{t.preventDefault(),document.body.classList.remove("dropping");let e=t.dataTransfer?.files[0];e&&this.drop(e)})}async drop(t){if(t.size>4e6)return this.model.say("studio_point.table_too_large",{name:t.name},"bad");try{let e=await this.model.actions.control(t.name,await t.text());this.model.command=e.command,this.model.take(e.state),this.model.show([_("studio_point.control_added",{n:e.added.length,name:t.name}),...e.remarks].join("; "),"good","studio_point.control_added")}catch(e){this.model.fail(e)}}async give(){let{model:t}=this;if(!t.current)return t.say("studio_point.none_chosen",{},"bad");let[e,i]=[this.xyz.map(Qn),this.sigma.map(Qn)];for(let[r,o]of[...e,...i].entries()){let a=[...this.xyz,...this.sigma][r];if(o!==null&&!Ws(t,a,o))return}let s=this.role.value;await t.act("point",{point:t.current,role:s,xyz:e,sigma:i},"studio_point.role_given",{point:t.current,role:s})}fields(t,e,i){this.role.value=t,this.xyz.forEach((s,r)=>s.value=e[r]===null?"":String(e[r])),this.sigma.forEach((s,r)=>s.value=i[r]===null?"":String(i[r]))}async fill(){let{model:t}=this,e=t.current,i=t.state.points.find(o=>o.point===e);if(this.about.textContent=e?_("studio_point.of_point",{point:e}):_("studio_point.none_chosen"),this.fields(i?.role??"tie",i?.xyz??[null,null,null],i?.sigma??[null,null,null]),i||!e)return;let r=(await Pt("/api/points",{search:e,limit:200})).rows.find(o=>o.point===e);r&&t.current===e&&(this.role.value=r.role)}show(){let{state:t}=this.model,e=t.points.filter(i=>i.role!=="tie"||i.xyz.some(s=>s!==null));this.head.textContent=ts(_("studio_point.control"),e.length),this.rows.hidden=!e.length,this.rows.replaceChildren(...e.slice(0,300).map(i=>u("tr",{},u("td",{},Xt(i.point,_("studio_point.choose",{point:i.point}),()=>this.model.choose(i.point),"link")),u("td",{},_("studio_point.role",{role:i.role})),...i.xyz.map(s=>u("td",{},Mt(s,7)))))),document.activeElement instanceof HTMLInputElement||this.fill()}};function fu(n,t){let e=u("datalist",{id:`${n}-names`}),i=Fe(n,t,{list:`${n}-names`,maxlength:"200"});return i.addEventListener("input",Re(()=>void Pt("/api/points",{search:i.value.trim(),limit:12}).then(s=>e.replaceChildren(...s.rows.map(r=>u("option",{value:r.point}))),()=>{}),150)),[i,e]}var lo=class{constructor(t){this.model=t;this.name=Fe("line-name",_("studio_point.line_name"),{maxlength:"200"});this.kind=u("select",{id:"line-kind","aria-label":_("studio_point.line_kinds")},...xe(["straight","plumb","level","plane"],t=>_("studio_point.line_kind",{kind:t})));this.sigma=Fe("line-sigma",_("label.sigma"),{inputmode:"decimal"});this.follow=u("input",{type:"checkbox",id:"line-follow"});this.picked=u("ol",{class:"picked",id:"line-points","aria-label":_("studio_point.line_points")});this.rows=u("table",{"aria-label":_("studio_point.lines")});this.head=u("summary",{},_("studio_point.lines"));this.points=[];let[e,i]=fu("line-point",_("label.point"));this.point=e,e.addEventListener("keydown",r=>{r.key!=="Enter"||!e.value.trim()||(r.preventDefault(),this.add())});let s=u("form",{},u("div",{class:"row"},this.name),u("div",{class:"row"},this.kind,this.sigma),u("div",{class:"row"},e,i,yt("studio_point.add",()=>this.add())),u("label",{class:"check",title:Be("studio_point.add_chosen")},this.follow,_("studio_point.add_chosen")),this.picked,u("div",{class:"row"},u("button",{type:"submit",id:"line-give"},_("studio_point.give")),yt("studio_point.clear",()=>this.pick([]))));s.addEventListener("submit",r=>{r.preventDefault(),this.give()}),nt("right").append(u("details",{class:"card"},this.head,this.rows,s)),t.on(["state","overview"],()=>this.show()),t.on("current",()=>this.follow.checked&&t.current&&this.pick([...this.points,t.current]))}add(){let t=this.point.value.trim()||this.model.current;if(!t)return this.model.say("studio_point.none_chosen",{},"bad");this.pick([...this.points,t]),this.point.value="",this.point.focus()}pick(t){this.points=[...new Set(t)],this.picked.hidden=!this.points.length,this.picked.replaceChildren(...this.points.map(e=>u("li",{},e," ",Xt("\u2715",_("studio_point.remove",{name:e}),()=>this.pick(this.points.filter(i=>i!==e)),"small"))))}async give(){let{model:t}=this,e=Qn(this.sigma);if(!Ws(t,this.sigma,e))return;let i=this.name.value.trim(),s=this.kind.value;await t.act("line",{line:i,points:this.points,kind:s,sigma:e},"studio_point.line_given",{kind:s,line:i,points:this.points.join(", ")})&&(this.name.value="",this.follow.checked=!1,this.pick([]))}show(){let{state:t,overview:e}=this.model;this.sigma.placeholder=ye(_("label.sigma"),e.unit),this.sigma.title=_("studio_point.line_sigma"),this.head.textContent=ts(_("studio_point.lines"),t.lines.length),this.rows.hidden=!t.lines.length,this.rows.replaceChildren(...t.lines.map(i=>u("tr",{},u("td",{},i.line),u("td",{},_("studio_point.line_kind",{kind:i.kind})),u("td",{class:"l"},i.points.join(", ")),u("td",{},`\xB1 ${Mt(i.sigma)}`),u("td",{},Xt("\u2715",_("studio_point.remove",{name:i.line}),()=>void this.model.act("line",{line:i.line,points:[]},"studio_point.removed",{name:i.line}),"small"))))),this.picked.hidden=!this.points.length}},du=[["origin","studio_point.origin"],["axis","studio_point.on_axis"],["plane","studio_point.in_plane"]],co=class{constructor(t){this.model=t;this.about=u("p",{class:"note"});this.away=yt("studio_point.remove_datum",()=>void this.model.act("datum",{},"studio_point.datum_removed"));let e=du.map(([r,o])=>fu(`datum-${r}`,_(o)));this.inputs=e.map(([r])=>r);let i=(r,o)=>Xt("\u21E4",_("studio_point.use_current",{role:_(o)}),()=>r.value=t.current),s=u("form",{},this.about,...e.map(([r,o],a)=>u("div",{class:"row"},r,o,i(r,du[a][1]))),u("div",{class:"row"},u("button",{type:"submit",id:"datum-give"},_("studio_point.give")),this.away));s.addEventListener("submit",r=>{r.preventDefault(),this.give()}),nt("right").append(u("details",{class:"card"},u("summary",{},_("studio_point.datum")),s)),t.on("state",()=>this.show())}async give(){let[t,e,i]=this.inputs.map(r=>r.value.trim());await this.model.act("datum",{origin:t,axis:e,plane:i},"studio_point.datum_given",{points:[t,e,i].filter(r=>r).join(", ")})&&this.inputs.forEach(r=>r.value="")}show(){let{datum:t}=this.model.state;this.away.disabled=!t,this.about.textContent=t?_("studio_point.datum_is",{...t,plane:t.plane||"none"}):_("studio_point.datum_note")}},ho=class{constructor(t){this.model=t;this.to=Fe("rename-to",_("studio_point.new_name"),{maxlength:"200"});this.about=u("p",{class:"note"});let e=u("form",{},this.about,u("div",{class:"row"},this.to,u("button",{type:"submit",id:"rename-give"},_("studio_point.rename")),yt("studio_point.forget",()=>this.forget())));e.addEventListener("submit",i=>{i.preventDefault(),this.rename()}),nt("right").append(u("details",{class:"card"},u("summary",{},_("studio_point.rename_or_forget")),e)),t.on("current",()=>this.show()),this.show()}show(){this.about.textContent=this.model.current?_("studio_point.of_point",{point:this.model.current}):_("studio_point.none_chosen")}async rename(){let{model:t}=this,e=t.current;if(!e)return t.say("studio_point.none_chosen",{},"bad");let i=this.to.value.trim();await t.act("rename",{point:e,to:i},"studio_point.renamed",{point:e,to:i})&&(this.to.value="",t.choose(i))}forget(){let{model:t}=this;if(!t.current)return t.say("studio_point.none_chosen",{},"bad");t.act("forget",{point:t.current},"studio_point.forgotten",{point:t.current})}};var jp=0,Tn=class{constructor(t,e,i,s){this.keyOf=e;this.row=i;this.chosen=s;this.items=[];this.at=-1;this.id=`list${jp++}`;this.root=u("div",{role:"listbox",tabindex:0,class:"choice","aria-label":t}),this.root.addEventListener("keydown",r=>this.key(r)),this.root.addEventListener("click",r=>{let o=r.target.closest("[role=option]"),a=o?[...this.root.children].indexOf(o):-1;a<0||(this.point(a),this.chosen(this.items[a],r))})}set(t,e=""){this.items=t,this.root.replaceChildren(...t.map((i,s)=>u("div",{role:"option",id:`${this.id}-${s}`,"aria-selected":"false"},...this.row(i)))),this.at=-1,this.select(e)}select(t){this.items.forEach((e,i)=>{let s=this.keyOf(e)===t;this.root.children[i].setAttribute("aria-selected",String(s)),s&&this.point(i)})}get length(){return this.items.length}point(t){this.root.children[this.at]?.classList.remove("at"),this.at=t;let e=this.root.children[t];if(!e)return;e.classList.add("at"),this.root.setAttribute("aria-activedescendant",e.id);let{offsetTop:i,offsetHeight:s}=e,{scrollTop:r,clientHeight:o}=this.root;i<r?this.root.scrollTop=i:i+s>r+o&&(this.root.scrollTop=i+s-o)}key(t){let e=this.items.length-1,i={ArrowDown:Math.min(this.at+1,e),ArrowUp:Math.max(this.at-1,0),Home:0,End:e,PageDown:Math.min(this.at+8,e),PageUp:Math.max(this.at-8,0)};if(t.key in i)this.point(i[t.key]);else if(t.key==="Enter"&&this.at>=0)this.chosen(this.items[this.at],t);else return;t.preventDefault(),t.stopPropagation()}};var Xs=512,Jp=4,Qp=320,tm=2500,An=(n,t,e,i)=>`${n}/${t}/${e}/${i}`;function qs(n,t){let e=0;for(;Math.max(n,t)>Xs;)n=Math.ceil(n/2),t=Math.ceil(t/2),e++;return e}var nc=class{constructor(){this.cache=new Map;this.loading=new Map;this.wanted=new Map;this.failed=new Map;this.listeners=new Set;this.arrived=vi(()=>this.listeners.forEach(t=>t()));this.timesRead=0;this.times=[]}onarrival(t){return this.listeners.add(t),()=>this.listeners.delete(t)}readAnew(t){t!==this.timesRead&&(this.timesRead=t,this.loading.forEach(e=>e.abort()),this.cache.forEach(e=>e.close()),this.cache.clear(),this.failed.clear())}get(t){let e=this.cache.get(t);return e&&(this.cache.delete(t),this.cache.set(t,e)),e}why(t){return this.failed.get(t)??""}want(t,e,i=!1){let s=e.filter(o=>!this.cache.has(o)&&!this.failed.has(o));s.length?this.wanted.set(t,{keys:s,late:i}):this.wanted.delete(t);let r=new Set([...this.wanted.values()].flatMap(o=>o.keys));for(let[o,a]of this.loading)r.has(o)||a.abort();this.pump()}pump(){for(;this.loading.size<Jp;){let t=this.next();if(!t)return;this.load(t)}}next(){for(let t of[!1,!0]){if(t&&this.loading.size)return;let e=[...this.wanted.values()].filter(s=>s.late===t),i=Math.max(0,...e.map(s=>s.keys.length));for(let s=0;s<i;s++)for(let{keys:r}of e){let o=r[s];if(o&&!this.loading.has(o)&&!this.cache.has(o)&&!this.failed.has(o))return o}}}async load(t){let e=new AbortController;this.loading.set(t,e);let i=performance.now(),s=this.timesRead;try{let r=await fetch(`/api/tile/${t}?read=${s}`,{signal:e.signal});if(r.status===404)this.failed.set(t,(await r.json()).error);else if(r.ok){let o=await createImageBitmap(await r.blob());s===this.timesRead&&this.keep(t,o),this.times.push(performance.now()-i)}else throw new Error(String(r.status))}catch{e.signal.aborted||await new Promise(r=>setTimeout(r,tm))}this.loading.delete(t),this.arrived(),this.pump()}keep(t,e){for(this.cache.set(t,e);this.cache.size>Qp;){let i=this.cache.keys().next().value;this.cache.get(i).close(),this.cache.delete(i)}}},ze=new nc;var em=72,im=54,uo=class{constructor(t,e){this.model=t;this.filter=nt("image-filter");this.small=new Map;this.list=new Tn(_("studio_page.images"),s=>s.id,s=>this.row(s),(s,r)=>{e(s.id,r.shiftKey)}),nt("image-list").append(this.list.root),this.watch=new IntersectionObserver(s=>s.forEach(r=>this.seen(r)),{root:this.list.root}),ze.onarrival(()=>this.small.forEach((s,r)=>this.draw(r,s))),this.filter.addEventListener("input",()=>this.show()),t.on("overview",()=>this.show()),t.on("panes",()=>this.list.select(t.panes[t.active]??""))}show(){let t=this.filter.value.toLowerCase();this.watch.disconnect(),this.small.forEach((i,s)=>ze.want(s,[])),this.small.clear();let e=[...this.model.images.values()].filter(i=>i.id.toLowerCase().includes(t));this.list.set(e,this.model.panes[this.model.active]),nt("images-head").textContent=_("studio_photo.count",{n:e.length})}row(t){let e=u("canvas",{width:em*2,height:im*2,"aria-hidden":"true"});this.small.set(e,t),queueMicrotask(()=>this.watch.observe(e));let i=t.rms_px===null?"":`, ${Mt(t.rms_px,2)}\xA0px`,s=t.oriented?_("studio_photo.rays",{n:t.rays})+i:_("studio_photo.not_oriented",{n:this.model.marksIn(t.id).length}),r=t.p_wrong===null?"":`
${_("studio_photo.p_wrong",{percent:100*t.p_wrong})}`;return[e,u("span",{class:"about",title:t.id+r},u("b",{},t.id),u("small",{class:t.oriented?"":"open"},s))]}seen(t){let e=this.small.get(t.target);if(!e?.photo)return;let i=An(e.k,qs(e.width,e.height),0,0);ze.want(t.target,t.isIntersecting?[i]:[],!0),this.draw(t.target,e)}draw(t,e){let i=qs(e.width,e.height),s=t.dataset.drawn?void 0:ze.get(An(e.k,i,0,0));if(!s)return;t.dataset.drawn="yes";let r=t.getContext("2d"),[o,a]=e.turn&1?[s.height,s.width]:[s.width,s.height],l=Math.min(t.width/o,t.height/a);r.translate(t.width/2,t.height/2),r.rotate(e.turn*Math.PI/2),r.imageSmoothingQuality="high",r.drawImage(s,-s.width*l/2,-s.height*l/2,s.width*l,s.height*l)}};var mu=.36,sc=class{constructor(){this.areas=new Map;this.pictures=new Map}draw(t,e,i,s,r){let o=this.picture(i,s.id);o&&(e.apply(t,r),t.imageSmoothingEnabled=!1,t.globalAlpha=mu,t.drawImage(o,0,0,s.width,s.height),t.globalAlpha=1),t.setTransform(r,0,0,r,0,0);for(let a of this.drawn(i,s.id))pu(t,e,a.polygon,!0);if(!(!Kt.on||Kt.image!==s.id)){pu(t,e,Kt.corners,!1);for(let[a,l]of Kt.corners){let[c,h]=e.toScreen(a,l);t.beginPath(),t.rect(c-4,h-4,8,8),t.fillStyle=ie.current,t.fill(),t.lineWidth=1.5,t.strokeStyle="#000000",t.stroke()}}}drawn(t,e){let{masks:i}=t.state;if(!i.length)return[];let s=i.filter(a=>a.image===e);if(!i.some(a=>a.camera&&a.image!==e))return s;let r=JSON.stringify(i),o=this.areas.get(e);return o?.of===r?o.found:(this.areas.set(e,{of:r,found:s}),Pt("/api/masks",{image:e}).then(({areas:a})=>{this.areas.set(e,{of:r,found:a}),t.emit("looks")},()=>this.areas.delete(e)),s)}picture(t,e){if(!t.overview.masks_given)return null;let i=this.pictures.get(e);return i!==void 0?i:(this.pictures.set(e,null),Wr(`/api/mask?image=${encodeURIComponent(e)}`).then(async s=>{s.byteLength&&(this.pictures.set(e,await createImageBitmap(new Blob([s],{type:"image/png"}))),t.emit("looks"))}).catch(()=>this.pictures.delete(e)),null)}};function pu(n,t,e,i){n.beginPath(),e.forEach(([s,r],o)=>o?n.lineTo(...t.toScreen(s,r)):n.moveTo(...t.toScreen(s,r))),n.globalAlpha=mu,n.fillStyle=ie.masked,n.fill("evenodd"),n.globalAlpha=1,i&&n.closePath();for(let[s,r]of[["#000000b0",3.2],[ie.masked,1.4]])n.lineWidth=r,n.strokeStyle=s,n.stroke()}var gu=new sc;var _u=.5,nm=450,Ys=(n,t,e)=>({x_px:n,y_px:t,covariance:[_u**2,_u**2,0],how:"hand",clicked:e,quality:null}),sm=2,rm=6,[om,am]=[2,12],lm=n=>Math.min(Math.max(rm/n,om),am);function fo(n,t,e,i){let s=Math.sqrt(Math.max(e.covariance[0],e.covariance[1])),r=e.clicked?Math.hypot(e.x_px-e.clicked[0],e.y_px-e.clicked[1]):0;return[n,{point:t,how:e.how,sigma_px:Mt(s,2),cause:i||"none",far_px:i||r<sm?0:r}]}var Rn=class n{constructor(t){this.model=t;this.moving=new Map;this.resting=0;this.worstOnes=[];this.worstAt=-1;t.on("read",()=>this.worstAt=-1)}static key(t,e){return`${t}
${e}`}async place(t,e,i,s){let{model:r}=this;if(r.fiducial)return this.placeFiducial(t,e,i,s);let o=r.current;if(!o)return r.say("studio_point.none_chosen",{},"bad");if(r.mark(t,o))return r.say("studio_point.marked_before",{point:o},"bad");let[a,l]=await this.snapped(t,o,e,i,s);await r.act("put",{image:t,point:o,...a},...fo("studio_point.marked",o,a,l))}async placeFiducial(t,e,i,s){let{model:r}=this,o=r.fiducial,[a,l]=await this.snapped(t,"",e,i,s);if(!await r.act("fiducial",{image:t,name:o,...a},...fo("studio_point.marked",o,a,l)))return;let h=new Set(r.fiducialsIn(t).map(m=>m.name)),d=r.overview.fiducials,p=[...d.slice(d.indexOf(o)),...d].find(m=>!h.has(m))??"";r.chooseFiducial(p)}async move(t,e,i,s,r){let[o,a]=await this.snapped(t,e,i,s,r);await this.model.act("move",{image:t,point:e,...o},...fo("studio_point.moved",e,o,a)),this.moving.delete(n.key(t,e)),this.model.emit("looks")}async snapped(t,e,i,s,r){if(qt.snap==="hand")return[Ys(i,s,[i,s]),""];try{let o=await Ee("/api/snap",{image:t,x:i,y:s,kind:qt.snap,point:e,reach:lm(r)});if("why"in o)return[Ys(i,s,[i,s]),o.why];let{cov:a,how:l,quality:c}=o;return[{x_px:o.x,y_px:o.y,covariance:a,how:l,clicked:[i,s],quality:c},""]}catch(o){return[Ys(i,s,[i,s]),o instanceof yi?o.message:_("studio_page.no_answer")]}}nudge(t,e,i){let{model:s}=this,r=s.mark(t,s.current);if(!r)return s.say("studio_point.not_marked",{},"bad");let o=n.key(t,r.point),[a,l]=this.moving.get(o)??[r.x,r.y];this.moving.set(o,[a+e,l+i]),s.emit("looks"),clearTimeout(this.resting),this.resting=window.setTimeout(()=>void this.rest(t,r.point,r.clicked),nm)}async rest(t,e,i){let s=n.key(t,e),r=this.moving.get(s);r&&(await this.model.act("move",{image:t,point:e,...Ys(r[0],r[1],i)},...fo("studio_point.moved",e,Ys(r[0],r[1],null),"")),this.moving.delete(s),this.model.emit("looks"))}async remove(t){let e=this.model.current;if(!this.model.mark(t,e))return this.model.say("studio_point.not_marked",{},"bad");await this.model.act("remove",{image:t,point:e},"studio_point.mark_removed",{point:e})}async reject(t,e){(this.model.isRejected(t,e)?await this.model.act("accept",{image:t,point:e},"studio_point.accepted",{point:e}):await this.model.act("reject",{image:t,point:e},"studio_point.rejected",{point:e}))&&this.model.emit("looks")}async undo(){await this.model.act("undo",{},"studio_page.undone")}async redo(){await this.model.act("redo",{},"studio_page.redone")}async newPoint(){let t=new Set(this.model.state.points.map(e=>e.point));for(let e=1;;e++){let i=`M${e}`;if(!(t.has(i)||(await Pt("/api/points",{search:i,limit:500})).rows.some(r=>r.point===i))){this.model.choose(i),this.model.say("studio_point.new_point",{point:i});return}}}async worstNext(){if(this.worstAt<0&&(this.worstOnes=(await Pt("/api/worst")).worst),!this.worstOnes.length)return this.model.say("studio_point.no_worst"),null;this.worstAt=(this.worstAt+1)%this.worstOnes.length;let t=this.worstOnes[this.worstAt],{kind:e,point:i,value:s}=t;return this.model.say("studio_point.worst",{number:this.worstAt+1,of:this.worstOnes.length,point:i,kind:e,value:Mt(s),n:Math.round(s),unit:this.model.overview.unit}),t}};var cm={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},hm=40;function vu(n,t){let e=cm[t.key];if(e)return um(n,t,...e);if(t.ctrlKey||t.metaKey||t.altKey)return!1;switch(t.key){case"+":case"=":return n.zoom(1.25),!0;case"-":return n.zoom(.8),!0;case"0":return n.fit(),!0;case"1":return n.zoom(1/n.view.scale),!0;case"Enter":return n.enter(),!0;case"r":return n.turn(1),!0;case"Delete":case"Backspace":return Kt.on?Kt.removeLast():n.measuring.remove(n.picture.id),!0;case"p":return dm(n);case"x":return fm(n);default:return!1}}function um(n,t,e,i){let{view:s}=n;if(t.shiftKey||t.altKey){let[o,a]=s.along(e,i),l=t.altKey?.01:.1;return n.measuring.nudge(n.picture.id,l*o,l*a),!0}let r=t.ctrlKey||t.metaKey?s.scale:hm;return n.pan(-r*e,-r*i),!0}function dm(n){let t=n.pointHere();return t?n.model.choose(t):n.model.say("studio_photo.no_point_here"),!0}function fm(n){let t=n.pointHere();return t?n.measuring.reject(n.picture.id,t):n.model.say("studio_photo.no_point_here"),!0}function rc(n,t,e,i,s=[0,0]){let r=qs(e.width,e.height),o=Math.min(Math.max(Math.floor(-Math.log2(t.scale*i)+.25),0),r);t.apply(n,i,s),n.imageSmoothingEnabled=t.scale*i<4,n.imageSmoothingQuality="high",n.save(),n.beginPath(),n.rect(0,0,e.width,e.height),n.clip();let a=An(e.k,r,0,0),l=ze.get(a);l&&n.drawImage(l,0,0,l.width*2**r,l.height*2**r);let c=[a];return o<r&&c.push(...pm(n,t,e,o,r)),n.restore(),c}function pm(n,t,e,i,s){let r=Xs*2**i,[o,a,l,c]=t.seen(),h=[];for(let d=Math.floor(a/r);d*r<c;d++)for(let p=Math.floor(o/r);p*r<l;p++){let m=An(e.k,i,p,d),v=Math.hypot((p+.5)*r-t.x,(d+.5)*r-t.y);h.push([v,m]);let b=ze.get(m);b?n.drawImage(b,p*r,d*r,b.width*2**i,b.height*2**i):mm(n,e.k,i,p,d,s)}return h.sort((d,p)=>d[0]-p[0]).map(([,d])=>d)}function mm(n,t,e,i,s,r){for(let o=1;e+o<r;o++){let a=ze.get(An(t,e+o,i>>o,s>>o));if(!a)continue;let l=Xs>>o,c=(i&(1<<o)-1)*l,h=(s&(1<<o)-1)*l,d=Math.min(l,a.width-c),p=Math.min(l,a.height-h),m=Xs*2**e,v=2**(e+o);d>0&&p>0&&n.drawImage(a,c,h,d,p,i*m,s*m,d*v,p*v);return}}var He=190,po=class{constructor(t,e,i,s){this.model=t;this.measuring=e;this.stage=i;this.picture=s;this.photo=u("canvas",{class:"photo"});this.over=u("canvas",{class:"over"});this.status=u("p",{class:"status"});this.tip=u("div",{class:"tip",hidden:!0});this.observations=null;this.hover=-1;this.at=null;this.keyboard=!1;this.draw=vi(()=>this.drawn());this.watch=new ResizeObserver(()=>this.sized());this.view=new rn(s.width,s.height,s.turn),this.body=u("div",{class:"canvas",tabindex:0,role:"application","aria-label":_("studio_photo.canvas",{image:s.id})},this.photo,this.over,this.status,this.tip),this.root=u("section",{class:"pane","aria-label":_("studio_photo.pane",{image:s.id})},this.head(),this.body),this.forget=ze.onarrival(()=>this.draw()),this.watch.observe(this.body),this.pointers(),this.body.addEventListener("keydown",r=>this.key(r)),this.body.addEventListener("focus",()=>this.stage.activate(this)),this.body.addEventListener("blur",()=>this.redraw()),this.read()}head(){let t=this.picture.id;return u("header",{},u("b",{class:"name"},t),Xt("\u27F2",_("studio_photo.turn_left",{image:t}),()=>this.turn(3)),Xt("\u27F3",_("studio_photo.turn_right",{image:t}),()=>this.turn(1)),Xt("1:1",_("studio_photo.pixels",{image:t}),()=>this.zoom(1/this.view.scale)),yt("studio_photo.fit",()=>this.fit(),"",{image:t}),Xt("\u2715",_("studio_photo.close",{image:t}),()=>this.stage.close(this)))}async read(){try{this.observations=await this.model.observations(this.picture.id)}catch(t){this.model.fail(t)}this.redraw()}gone(){this.forget(),this.watch.disconnect(),ze.want(this,[]),this.root.remove()}redraw(){this.draw()}sized(){let{clientWidth:t,clientHeight:e}=this.body;for(let i of[this.photo,this.over])i.width=Math.round(t*devicePixelRatio),i.height=Math.round(e*devicePixelRatio);this.view.resize(t,e),this.drawn()}rejectedHere(){return new Set(this.model.state.rejected.filter(([t])=>t===this.picture.id).map(([,t])=>t))}placed(t){let e=this.measuring.moving.get(Rn.key(t.image,t.point));return{mark:t,x:e?.[0]??t.x,y:e?.[1]??t.y}}marks(){return this.model.marksIn(this.picture.id).map(t=>this.placed(t))}shown(){let{model:t,picture:e}=this,i=t.prediction?.predictions.find(s=>s.image===e.id)??null;return{observations:this.observations,rejectedHere:this.rejectedHere(),marks:this.marks(),prediction:i,off:t.prediction?.off.includes(e.id)??!1,image:e.id,fiducials:t.fiducialsIn(e.id),fiducial:t.fiducial,current:t.current,hover:this.hover,hair:this.keyboard&&document.activeElement===this.body}}drawn(){let{view:t,picture:e}=this,i=devicePixelRatio,s=this.photo.getContext("2d",{alpha:!1});s.setTransform(1,0,0,1,0,0),s.fillStyle="#2b2b2b",s.fillRect(0,0,this.photo.width,this.photo.height),this.photo.style.filter=jl();let r=rc(s,t,e,i),o=this.over.getContext("2d");o.setTransform(1,0,0,1,0,0),o.clearRect(0,0,this.over.width,this.over.height),gu.draw(o,t,this.model,e,i),eu(o,t,this.shown(),i);let a=Te.on?Te.of(e.id):null;a&&nu(o,t,a),qt.loupe&&(this.at||document.activeElement===this.body)&&r.push(...this.loupe(o,i)),ze.want(this,r),this.status.textContent=e.photo?ze.why(r[0]):_("studio_photo.unknown")}loupe(t,e){let[i,s]=this.at??[this.view.width/2,this.view.height/2],[r,o]=this.view.toImage(i,s),a=new rn(this.picture.width,this.picture.height,this.view.turn);Object.assign(a,{x:r,y:o,scale:Math.min(4*this.view.scale,Math.max(16,this.view.scale)),width:He,height:He,fitted:!1});let l=i+He+30<this.view.width?i+24:i-He-24,c=s+He+30<this.view.height?s+24:s-He-24;t.save(),t.setTransform(e,0,0,e,0,0),t.beginPath(),t.rect(l,c,He,He),t.fillStyle="#2b2b2b",t.fill(),t.clip(),t.filter=jl();let h=rc(t,a,this.picture,e,[l,c]);return t.restore(),t.setTransform(e,0,0,e,0,0),t.beginPath(),t.rect(l,c,He,He),t.moveTo(l+He/2,c),t.lineTo(l+He/2,c+He),t.moveTo(l,c+He/2),t.lineTo(l+He,c+He/2),t.lineWidth=1,t.strokeStyle=ie.current,t.stroke(),h}turn(t){this.view.turn=this.view.turn+t&3,this.view.fitted&&this.view.fit(),this.redraw()}fit(){this.view.fit(),this.redraw(),this.showPlace()}zoom(t,e,i){this.view.zoomAt(t,e,i),this.stage.moved(this,0,0,t),this.redraw(),this.showPlace()}pan(t,e){this.view.panBy(t,e),this.stage.moved(this,t,e,1),this.redraw(),this.showPlace()}show(t,e,i=1){this.view.scale=Math.max(this.view.scale,i),this.view.centre(t,e),this.redraw(),this.showPlace()}showPlace(){let[t,e]=this.keyboard||!this.at?[this.view.x,this.view.y]:this.view.toImage(...this.at);this.stage.pointer(`${this.picture.id}  x ${pt(t,2)}  y ${pt(e,2)} px  \xB7  ${Mt(100*this.view.scale,3)} %`)}pointers(){let{body:t}=this,e=null,i=[0,0],s=null,r=-1,o=!1;t.addEventListener("pointerdown",a=>{a.button>1||(t.focus(),t.setPointerCapture(a.pointerId),e=i=this.place(a),r=a.button===0?Kt.cornerAt(this.picture.id,this.view,...e):-1,s=a.button===0&&!Kt.on?this.markAt(...e):null,o=!1)}),t.addEventListener("pointermove",a=>{let l=this.place(a);this.keyboard=!1,this.at=l,e?(o||=Math.hypot(l[0]-e[0],l[1]-e[1])>4,o&&r>=0?Kt.move(r,this.clamped(...l)):o&&s?this.measuring.moving.set(Rn.key(s.image,s.point),this.view.toImage(...l)):o&&this.pan(l[0]-i[0],l[1]-i[1]),i=l,this.redraw()):this.hovered(...l),this.showPlace()}),t.addEventListener("pointerup",a=>{let l=this.place(a);e&&o&&s?this.measuring.move(s.image,s.point,...this.view.toImage(...l),this.view.scale):e&&!o&&a.button===0&&this.click(a,...l),e=s=null}),t.addEventListener("pointercancel",()=>e=s=null),t.addEventListener("pointerleave",()=>this.left()),t.addEventListener("wheel",a=>{a.preventDefault(),this.zoom(Math.exp(-a.deltaY*(a.deltaMode?.05:.0016)),...this.place(a))},{passive:!1})}place(t){let e=this.body.getBoundingClientRect();return[t.clientX-e.left,t.clientY-e.top]}markAt(t,e){let i=null,s=10;for(let{mark:r,x:o,y:a}of this.marks()){let[l,c]=this.view.toScreen(o,a),h=Math.hypot(l-t,c-e)-(r.point===this.model.current?2:0);h<s&&(s=h,i=r)}return i}pointAt(t,e){let i=this.observations;return i?tu(i,Ql(i,qt.filter,this.rejectedHere()),this.view,t,e):-1}click(t,e,i){let{model:s}=this;if(Kt.on){Kt.cornerAt(this.picture.id,this.view,e,i)<0&&this.enter(e,i);return}if(s.fiducial)return this.enter(e,i);let r=this.markAt(e,i);if(r)return s.choose(r.point);let o=this.pointAt(e,i),a=!s.current||s.mark(this.picture.id,s.current)!==void 0;if(o>=0&&(a||t.ctrlKey||t.metaKey))return s.choose(this.observations.point[o]);this.enter(e,i)}enter(t=this.view.width/2,e=this.view.height/2){if(Kt.on){Kt.add(this.picture.id,this.clamped(t,e))||this.model.say("studio_point.mask_elsewhere",{image:Kt.image},"bad");return}let[i,s]=this.view.toImage(t,e);if(!this.view.inside(i,s))return this.model.say("studio_photo.outside",{},"bad");this.measuring.place(this.picture.id,i,s,this.view.scale)}clamped(t,e){let i=(o,a)=>Math.round(100*Math.min(Math.max(o,0),a))/100,[s,r]=this.view.toImage(t,e);return[i(s,this.picture.width),i(r,this.picture.height)]}left(){this.at=null,this.hover=-1,this.tip.hidden=!0,this.redraw()}hovered(t,e){let i=this.pointAt(t,e);if((i!==this.hover||qt.loupe)&&this.redraw(),this.hover=i,this.tip.hidden=i<0,i<0)return;this.tip.textContent=this.words(i);let s=t>this.view.width-240;this.tip.style.left=`${s?Math.max(t-230,4):t+16}px`,this.tip.style.top=`${qt.loupe?Math.max(e-60,4):Math.min(e+14,this.view.height-70)}px`}words(t){let e=this.observations,i=Qr(e,t,this.rejectedHere()),s=_("studio_photo.legend",{name:i}),r=[`${e.point[t]} (${s})`,_("studio_photo.residual",{vx:Mt(e.vx[t],2),vy:Mt(e.vy[t],2),w:Mt(e.w[t],2),n:e.rays[t]})];return i==="rejected"&&r.push(_("studio_photo.rejected",{cause:e.rejected[t]||_("studio_photo.by_hand")})),r.join(`
`)}pointHere(){let t=this.at&&!this.keyboard?this.hover:this.pointAt(this.view.width/2,this.view.height/2);return t>=0?this.observations.point[t]:null}key(t){vu(this,t)&&(t.preventDefault(),t.stopPropagation(),this.keyboard=!0,this.tip.hidden=!0,this.redraw(),this.showPlace())}};var gm={used:"\u25CB",weak:"\u25A1",rejected:"\u2715",control:"\u25B3",check:"\u25C7",mark:"\u271B",predicted:"\u25CC",beyond:"\u25EF",masked:"\u25A8"},_m=["all","rejected","weak","control","worst","none"],mo=class{constructor(t,e,i){this.model=t;this.measuring=e;this.showPlace=i;this.panes=[];this.most=1;this.box=nt("panes");this.counts=[];this.targets=u("input",{type:"checkbox",id:"targets"});nt("looks").append(...this.bar()),nt("image-legend").append(...Object.entries(gm).map(([r,o])=>{let a=u("span",{class:"sign","aria-hidden":"true"},o);return a.style.color=ie[r],u("li",{id:`legend-${r}`,hidden:r==="beyond"||r==="masked"},a,_("studio_photo.legend",{name:r}))})),t.on(["looks","state","prediction","current","fiducial"],()=>this.panes.forEach(r=>r.redraw())),ei.onchange(()=>{nt("legend-beyond").hidden=!ei.points.size,this.panes.forEach(r=>r.redraw())}),this.targets.addEventListener("change",()=>Te.switch(this.targets.checked));let s=jn.map(([r,o,a])=>{let l=u("span",{class:"sign","aria-hidden":"true"},a);return l.style.color=o,u("li",{hidden:!0,id:`legend-target-${r}`},l,_("studio_target.legend",{fate:r}))});nt("image-legend").append(...s),Te.onchange(()=>{this.targets.checked=Te.on,s.forEach(r=>r.hidden=!Te.on),Te.on&&Te.reason&&t.show(Te.reason,"bad"),this.panes.forEach(r=>r.redraw())}),t.on("read",()=>Te.forget()),t.on("observations",()=>this.panes.forEach(r=>void r.read())),t.on("overview",()=>this.begin()),t.on(["overview","state"],()=>nt("legend-masked").hidden=!t.state.masks.length&&!t.overview.masks_given)}bar(){this.counts=[1,2,4].map(i=>{let s=_("studio_photo.panes",{n:i}),r=Xt(String(i),s,()=>this.setCount(i));return r.setAttribute("aria-label",s),r});let t=u("select",{id:"filter"},...xe(_m,i=>_("studio_photo.filter",{filter:i}),qt.filter));t.addEventListener("change",()=>this.look(()=>qt.filter=t.value)),this.loupe=u("input",{type:"checkbox",id:"loupe"}),this.loupe.addEventListener("change",()=>this.look(()=>qt.loupe=this.loupe.checked));let e=u("input",{type:"checkbox",id:"linked",checked:!0});return e.addEventListener("change",()=>qt.linked=e.checked),[u("span",{class:"group",role:"group","aria-label":_("studio_photo.pane_count")},...this.counts),u("label",{},e,_("studio_photo.linked")),u("label",{},this.loupe,_("studio_photo.loupe")),u("label",{title:Be("studio_photo.targets")},this.targets,_("studio_photo.targets")),u("label",{},_("label.points"),t),this.slider("vectors","studio_photo.residuals",0,30,16,i=>qt.vectors=i?Math.round(10**(i/10)):0,()=>String(qt.vectors)),this.slider("brightness","studio_photo.brightness",2,30,10,i=>qt.brightness=i/10,()=>pt(qt.brightness,1)),this.slider("contrast","studio_photo.contrast",2,30,10,i=>qt.contrast=i/10,()=>pt(qt.contrast,1))]}slider(t,e,i,s,r,o,a){let l=u("input",{type:"range",id:t,min:i,max:s,value:r}),c=u("output",{for:t},a());return l.addEventListener("input",()=>this.look(()=>{o(Number(l.value)),c.textContent=a()})),l.addEventListener("dblclick",()=>{l.value=String(r),l.dispatchEvent(new Event("input"))}),u("label",{title:Be(e)},_(e),l,c)}look(t){t(),this.model.emit("looks")}toggleLoupe(t=!qt.loupe){this.loupe.checked=t,this.look(()=>qt.loupe=t)}begin(){this.panes=this.panes.filter(e=>this.model.images.has(e.picture.id)||(e.gone(),!1));for(let{picture:e}of this.panes)Object.assign(e,this.model.images.get(e.id));let t=[...this.model.images.values()];!this.panes.length&&t.length&&this.open((t.find(e=>e.photo)??t[0]).id),this.arranged()}setCount(t){for(this.most=t;this.panes.length>t;)this.panes.pop().gone();let e=new Set(this.panes.map(r=>r.picture.id)),i=this.activePane?.picture.k??0,s=[...this.model.images.values()];for(let r=1;r<s.length&&this.panes.length<t;r++){let o=s[(i+r)%s.length];e.has(o.id)||this.add(o.id)}this.arranged()}open(t,e=!1){let i=this.panes.find(o=>o.picture.id===t);if(i)return this.activate(i),i;if(e&&this.panes.length<4){this.most=Math.max(this.most,this.panes.length+1>2?4:2);let o=this.add(t);return this.activate(o),o}let s=this.activePane,r=this.add(t,s);return s&&(this.panes.splice(this.panes.indexOf(s),1),s.gone()),this.model.active=this.panes.indexOf(r),this.arranged(),r}add(t,e){let i=new po(this.model,this.measuring,this,this.model.images.get(t));return e?(e.root.before(i.root),this.panes.splice(this.panes.indexOf(e),0,i)):(this.box.append(i.root),this.panes.push(i)),i}arranged(){this.box.className=`panes${this.most>2?4:this.most}`,[1,2,4].forEach((e,i)=>this.counts[i].setAttribute("aria-pressed",String(e===this.most)));let t=Math.min(Math.max(this.model.active,0),this.panes.length-1);this.panes.forEach((e,i)=>e.root.classList.toggle("active",i===t)),this.model.setPanes(this.panes.map(e=>e.picture.id),t)}get activePane(){return this.panes[this.model.active]??this.panes[0]}activate(t){let e=this.panes.indexOf(t);e===this.model.active&&t.root.classList.contains("active")||(this.model.active=e,this.arranged())}close(t){if(this.panes.length<2)return this.model.say("studio_photo.last_open");this.panes.splice(this.panes.indexOf(t),1),t.gone(),this.most=this.panes.length>2?4:this.panes.length,this.arranged(),this.activePane?.body.focus()}moved(t,e,i,s){if(qt.linked)for(let r of this.panes)r!==t&&(s!==1?r.view.zoomAt(s):r.view.panBy(e,i),r.redraw())}pointer(t){this.showPlace(t)}visit(t,e,i,s=1){let r=this.open(t);requestAnimationFrame(()=>{r.show(e,i,s),r.body.focus()})}step(t){let e=[...this.model.images.keys()],i=e.indexOf(this.activePane?.picture.id??"");this.open(e[(i+t+e.length)%e.length]).body.focus()}centre(){for(let t of this.panes){let e=this.model.mark(t.picture.id,this.model.current),i=this.model.prediction?.predictions.find(s=>s.image===t.picture.id);e?t.show(e.x,e.y):i&&i.x!==null&&i.y!==null&&i.inside&&t.show(i.x,i.y)}}};var yu=500,go=class{constructor(t,e){this.model=t;this.isOpen=e;this.author=u("input",{id:"author",type:"text",autocomplete:"off",spellcheck:"false",maxlength:100});this.status=u("span",{class:"note"});this.entries=[];this.author.value=t.actions.author=localStorage.getItem("raybundle-author")??"",this.author.addEventListener("change",()=>{t.actions.author=this.author.value.trim(),localStorage.setItem("raybundle-author",t.actions.author)}),nt("journal-bar").append(u("label",{},_("studio_page.author"),this.author),yt("studio_page.copy_all",()=>this.copy(this.entries.map(i=>i.command).filter(i=>i).join(`
`))),this.status),t.on("state",Kn(()=>this.isOpen()&&void this.show()))}async show(){this.entries=(await Pt("/api/journal")).actions;let t=this.entries.slice(-yu).reverse();this.status.textContent=_("studio_page.actions",{n:this.entries.length,shown:Math.min(this.entries.length,yu)}),nt("journal").replaceChildren(u("table",{"aria-label":_("studio_page.journal")},Ne(["studio_page.number","label.time","studio_page.by","studio_page.action","studio_page.command","studio_page.copy"]),u("tbody",{},...t.map(e=>this.row(e)))))}row(t){let e=yt("studio_page.copy",()=>this.copy(t.command),"small",{n:t.seq}),{image:i,point:s,start:r,end:o,line:a}=t.arguments,l=[i,s,r,o,a].filter(c=>typeof c=="string").join(" \xB7 ");return u("tr",{},u("td",{},String(t.seq)),u("td",{class:"whole"},t.time.replace("T"," ").slice(0,19)),u("td",{},t.author),u("td",{class:"l"},u("b",{},_("studio_page.verb",{verb:t.verb})),` ${l}`),u("td",{class:"l"},u("code",{},t.command)),u("td",{},t.command?e:""))}copy(t){navigator.clipboard.writeText(t).then(()=>this.model.say("studio_page.copied",{},"good"),()=>this.model.say("studio_page.not_copied",{},"bad"))}};var vm=[["studio_keys.anywhere",[["N","studio_keys.new_point"],["V","studio_keys.next_image"],["W","studio_keys.worst"],["studio_keys.ctrl_z","studio_keys.undo"],["studio_keys.ctrl_shift_z","studio_keys.redo"],["S","studio_keys.snap"],["L","studio_keys.loupe"],["C","studio_keys.centre"],["G","studio_keys.panes"],["[  ]","studio_keys.neighbour"],["Esc","studio_keys.no_point"],["F2","studio_keys.name"],["?","studio_keys.this_table"]]],["studio_keys.in_photograph",[["studio_keys.arrows","studio_keys.hair"],["Enter","studio_keys.mark"],["studio_keys.shift_arrows","studio_keys.move"],["studio_keys.delete","studio_keys.remove"],["P","studio_keys.choose"],["X","studio_keys.reject"],["studio_keys.of_mask","studio_keys.mask"],["+  -","studio_keys.zoom"],["0","studio_keys.whole"],["1","studio_keys.pixels"],["R","studio_keys.turn"]]],["studio_keys.by_mouse",[["studio_keys.click","studio_keys.click_deed"],["studio_keys.ctrl_click","studio_keys.choose"],["studio_keys.drag","studio_keys.drag_deed"],["studio_keys.wheel","studio_keys.zoom"],["studio_keys.shift_click","studio_keys.beside"]]]];function oc(){let n=nt("keys");if(n.open)return n.close();n.replaceChildren(u("h2",{id:"keys-head"},_("studio_keys.title")),u("div",{class:"keys"},...vm.map(([t,e])=>u("section",{},u("h3",{},_(t)),u("dl",{},...e.flatMap(([i,s])=>[u("dt",{},u("kbd",{},_(i))),u("dd",{},_(s))]))))),yt("studio_keys.close",()=>n.close(),"main")),n.showModal()}function xu(n,t,e){let i=0,s=!1;addEventListener("keydown",r=>{if(nt("keys").open&&r.key!=="?")return;let o=r.ctrlKey||r.metaKey;if(Kh(r.target)&&r.key!=="Escape"&&r.key!=="F2")return;if(!o&&!r.altKey&&r.key.toLowerCase()==="l")return r.repeat||(i=performance.now(),s=e(),t(!0)),r.preventDefault();let a=`${o?"ctrl ":""}${o&&r.shiftKey?"shift ":""}${r.key.toLowerCase()}`,l=r.altKey?void 0:n[a];l&&(r.preventDefault(),l())}),addEventListener("keyup",r=>{r.key.toLowerCase()!=="l"||!i||(performance.now()-i>350?t(!1):t(!s),i=0)})}function bu(n,t){let e=500,i=!1,s=()=>{let r=new WebSocket(`${location.protocol==="https:"?"wss":"ws"}://${location.host}/api/live`),o=setInterval(()=>r.readyState===WebSocket.OPEN&&r.send('{"type":"here"}'),2e4);r.addEventListener("open",()=>{e=500,t(!0,i),i=!0}),r.addEventListener("message",a=>n(JSON.parse(a.data))),r.addEventListener("close",()=>{clearInterval(o),t(!1,i),setTimeout(s,e),e=Math.min(2*e,8e3)})};s()}var _o=class{constructor(t,e){this.model=t;this.toPhoto=e;this.name=Fe("mask-name",_("studio_point.mask_name"),{maxlength:"200"});this.camera=u("input",{type:"checkbox",id:"mask-camera"});this.rows=u("table",{"aria-label":_("studio_point.masks")});this.head=u("summary",{},_("studio_point.masks"));this.about=u("p",{class:"note","aria-live":"polite"});this.begin=yt("studio_point.draw_mask",()=>this.draw());this.give=u("button",{type:"submit",id:"mask-give",class:"main"},_("studio_point.exclude"));this.last=yt("studio_point.last_corner",()=>Kt.removeLast());this.form=u("form",{hidden:!0},u("div",{class:"row"},this.name),u("label",{class:"check"},this.camera,_("studio_point.mask_of_camera")),u("div",{class:"row"},this.last,yt("studio_point.cancel_mask",()=>Kt.end()),this.give)),this.form.addEventListener("submit",i=>{i.preventDefault(),this.exclude()}),this.begin.id="mask-draw",nt("right").append(u("details",{class:"card",id:"masks"},this.head,this.about,this.rows,this.begin,this.form)),t.on(["state","overview"],()=>this.show()),Kt.onchange(()=>{this.show(),t.emit("looks")})}draw(){let t=new Set(this.model.state.masks.map(i=>i.mask)),e=1;for(;t.has(_("studio_point.mask_default",{number:e}));)e++;this.name.value=_("studio_point.mask_default",{number:e}),this.camera.checked=!1,Kt.begin(),this.toPhoto(""),this.form.scrollIntoView({block:"nearest"})}edit(t){this.name.value=t.mask,this.camera.checked=t.camera,Kt.begin(t.image,t.polygon.map(([e,i])=>[e,i])),this.toPhoto(t.image),this.form.scrollIntoView({block:"nearest"})}async exclude(){let{corners:t,image:e}=Kt;if(!e)return this.model.say("studio_point.no_corner",{},"bad");let i=this.name.value.trim(),s={mask:i,image:e,polygon:t,camera:this.camera.checked};await this.model.act("mask",s,"studio_point.mask_given",{mask:i})&&Kt.end()}show(){let{state:t,overview:e}=this.model;this.head.textContent=ts(_("studio_point.masks"),t.masks.length),this.form.hidden=!Kt.on,this.begin.hidden=Kt.on,this.give.disabled=Kt.corners.length<3,this.last.disabled=!Kt.corners.length,this.about.textContent=Kt.on?_("studio_point.corners",{n:Kt.corners.length,image:Kt.image||"none"}):_("studio_point.masks_note",{folder:e.masks_given||"none"}),this.rows.hidden=!t.masks.length,this.rows.replaceChildren(...t.masks.map(i=>u("tr",{},u("td",{},Xt(i.mask,_("studio_point.edit_mask",{mask:i.mask}),()=>this.edit(i),"link")),u("td",{class:"l"},i.camera?_("studio_point.camera_of",{image:i.image}):i.image),u("td",{},Xt("\u2715",_("studio_point.remove",{name:i.mask}),()=>void this.model.act("unmask",{mask:i.mask},"studio_point.removed",{name:i.mask}),"small")))))}};var ym=5e3,vo=class{constructor(){this.waiting=[];this.busy=!1;this.author="";this.onwaiting=()=>{};addEventListener("beforeunload",t=>{this.waiting.length&&t.preventDefault()})}send(t,e){return this.put("/api/action",{verb:t,arguments:e})}control(t,e){return this.put("/api/control",{file:t,text:e})}reject(t,e){return this.put("/api/reject",{by:t,limit:e})}fiducials(t){return this.put("/api/fiducials",{image:t})}put(t,e){let i={id:crypto.randomUUID(),author:this.author,...e};return new Promise((s,r)=>{this.waiting.push({path:t,body:i,done:s,refused:r}),this.work()})}async work(){if(this.busy)return;this.busy=!0;let t=250;for(;this.waiting.length;){let{path:e,body:i,done:s,refused:r}=this.waiting[0];this.onwaiting(this.waiting.length,t>250);try{let o=await Ee(e,i);this.waiting.shift(),t=250,s(o)}catch(o){if(o instanceof yi&&o.status<500){this.waiting.shift(),r(o);continue}t=Math.min(2*t,ym),this.onwaiting(this.waiting.length,!0),await new Promise(a=>setTimeout(a,t))}}this.busy=!1,this.onwaiting(0,!1)}};var yo=class{constructor(){this.images=new Map;this.actions=new vo;this.current="";this.fiducial="";this.prediction=null;this.panes=[];this.active=0;this.run=null;this.message={code:"",words:"",kind:""};this.command="";this.marks=new Map;this.given=new Map;this.listeners=new Map;this.turn=0;this.predictSoon=Re(Kn(()=>void this.predict()),20)}on(t,e){for(let i of Array.isArray(t)?t:[t])this.listeners.set(i,[...this.listeners.get(i)??[],e])}emit(t){for(let e of this.listeners.get(t)??[])e()}async read(){this.overview=await Pt("/api/overview"),ze.readAnew(this.overview.times),this.images.clear(),this.overview.images.forEach((t,e)=>this.images.set(t.id,{...t,k:e})),this.given.clear(),this.take(this.overview.state),this.emit("overview"),this.emit("read"),this.emit("observations"),this.predictSoon()}take(t){if(!(this.state&&t.seq<this.state.seq)){this.state=t,this.marks.clear();for(let e of t.marks)this.marks.set(e.image,[...this.marks.get(e.image)??[],e]);this.emit("state"),this.predictSoon()}}async act(t,e,i,s={}){try{let r=await this.actions.send(t,e);this.command=r.command,this.take(r.state);let{test:o}=r;return this.show([_(i,s),o?.words??""].filter(a=>a).reverse().join(" "),o?.off?"bad":"good",i),!0}catch(r){return this.fail(r),!1}}say(t,e={},i=""){this.show(_(t,e),i,t)}show(t,e="",i=""){let s=e==="bad"&&i&&!i.startsWith("studio_");this.message={code:i,words:s?`${t} [${i}]`:t,kind:e},this.emit("message")}fail(t){this.show(t.message,"bad",t instanceof yi?t.code:"")}choose(t){this.fiducial&&this.chooseFiducial(""),t!==this.current&&(this.current=t,this.prediction=null,this.emit("current"),this.predictSoon())}chooseFiducial(t){this.fiducial=t,this.emit("fiducial")}fiducialsIn(t){return this.state.fiducials.filter(e=>e.image===t)}marksIn(t){return this.marks.get(t)??[]}mark(t,e){return this.marksIn(t).find(i=>i.point===e)}marksOf(t){return this.state.marks.filter(e=>e.point===t)}isRejected(t,e){return this.state.rejected.some(([i,s])=>i===t&&s===e)}roleOf(t){return this.state.points.find(e=>e.point===t)?.role??"tie"}observations(t){let e=this.given.get(t);return e||(e=Pt("/api/observations",{image:t}),e.catch(()=>this.given.delete(t)),this.given.set(t,e)),e}setPanes(t,e){this.panes=t,this.active=e,this.emit("panes"),this.predictSoon()}async predict(){let t=++this.turn,e=this.current;if(!e){this.prediction=null,this.emit("prediction");return}try{let i=await Pt("/api/predict",{point:e,images:[...new Set(this.panes)]});if(t!==this.turn)return;this.prediction=i,this.emit("prediction")}catch(i){i instanceof yi&&this.fail(i)}}};var xo=class{constructor(t,e,i){this.model=t;this.measuring=e;this.going=i;this.name=u("input",{id:"point-name",type:"text","aria-label":_("studio_point.current_name"),placeholder:_("studio_point.current_none"),autocomplete:"off",spellcheck:"false",list:"point-names",maxlength:200});this.names=u("datalist",{id:"point-names"});this.where=u("table",{class:"where","aria-label":_("studio_point.coordinates")});this.about=u("p",{class:"note","aria-live":"polite"});this.marks=u("table",{class:"marks","aria-label":_("studio_point.marks")});this.visibleHead=u("h3",{});this.search=u("input",{type:"search",id:"point-search","aria-label":_("studio_point.filter"),placeholder:_("studio_point.filter"),autocomplete:"off",spellcheck:"false"});this.pointsHead=u("summary",{},_("studio_point.points"));this.snap=u("select",{id:"snap"},...xe(zs,t=>_("studio_point.how",{how:t})));this.visited=-1;this.visible=new Tn(_("studio_point.visible_images"),r=>r.image,r=>[u("b",{},r.image),u("small",{title:_("studio_point.angle")},`${r.angle_deg.toFixed(0)}\xB0`)],r=>i.visit(r.image,r.x,r.y)),this.points=new Tn(_("studio_point.points"),r=>r.point,r=>this.pointRow(r),r=>t.choose(r.point)),nt("right").append(this.current(),this.list()),this.name.addEventListener("change",()=>this.chooseNamed()),this.name.addEventListener("input",Re(()=>void this.suggest(),150)),this.search.addEventListener("input",Re(()=>void this.showPoints(),150)),this.snap.addEventListener("change",()=>qt.snap=this.snap.value),t.on("current",()=>{this.visited=-1,this.name.value=t.current,this.points.select(t.current)}),t.on(["current","prediction","state"],()=>this.show());let s=Re(Kn(()=>void this.showPoints()),60);t.on(["state","read"],s)}current(){return u("section",{class:"card","aria-label":_("studio_point.current")},u("h2",{},_("studio_point.current")),u("div",{class:"row"},this.name,this.names,yt("studio_point.new",()=>void this.measuring.newPoint(),"main")),u("div",{class:"row"},u("label",{},_("studio_point.snap"),this.snap),yt("studio_point.worst_next",()=>void this.worst())),this.where,this.about,this.marks,this.visibleHead,this.visible.root)}list(){return u("details",{class:"card",open:!0},this.pointsHead,u("div",{class:"row"},this.search),this.points.root)}chooseNamed(){this.model.choose(this.name.value.trim()),this.name.blur()}async suggest(){let t=await Pt("/api/points",{search:this.name.value.trim(),limit:12});this.names.replaceChildren(...t.rows.map(e=>u("option",{value:e.point})))}typeName(){this.name.focus(),this.name.select()}nextSnap(){qt.snap=zs[(zs.indexOf(qt.snap)+1)%zs.length],this.snap.value=qt.snap,this.model.say("studio_point.snapping",{how:qt.snap})}visitNext(){let t=this.model.prediction?.visible??[];if(!t.length)return this.model.say("studio_point.none_visible");this.visited=(this.visited+1)%t.length;let{image:e,x:i,y:s}=t[this.visited];this.visible.select(e),this.going.visit(e,i,s)}async worst(){let t=await this.measuring.worstNext();t&&(this.model.choose(t.point),await this.goTo(t.point,t.image))}async goTo(t,e=""){let i=this.model.marksOf(t).find(o=>!e||o.image===e);if(i)return this.going.visit(i.image,i.x,i.y);let s=e?[e]:[...this.model.images.keys()].slice(0,400);for(let o of s){let a=await this.model.observations(o),l=a.point.indexOf(t);if(l>=0)return this.going.visit(o,a.x[l],a.y[l])}let r=this.model.prediction?.visible[0];r&&this.going.visit(r.image,r.x,r.y)}show(){let{model:t}=this,e=t.prediction?.point===t.current?t.prediction:null,{unit:i}=t.overview;if(this.where.replaceChildren(),e?.located.xyz){let r=e.located.sigma,o=u("tr",{},u("td"),u("th",{scope:"col"},i||_("studio_point.no_unit")),u("th",{scope:"col"},_("label.sigma")));this.where.append(o,...["X","Y","Z"].map((a,l)=>u("tr",{},u("th",{scope:"row"},a),u("td",{},pt(e.located.xyz[l],ke(r?.[l]))),u("td",{class:"sigma"},r?pt(r[l],ke(r[l])):"\u2013"))))}this.about.textContent=this.words(e),this.showMarks(e);let s=e?.visible??[];this.visibleHead.hidden=this.visible.root.hidden=!s.length,this.visibleHead.textContent=_("studio_point.visible",{n:s.length}),this.visible.set(s)}words(t){let{model:e}=this;if(!e.current)return _("studio_point.choose_or_begin");if(!t)return"";let{source:i,rays:s,neglected:r}=t.located;return[_("studio_point.located",{source:i,n:s}),r].join(" ")}showMarks(t){let{model:e}=this,i=e.marksOf(e.current);this.marks.hidden=!i.length,this.marks.replaceChildren(Ne(["label.image","studio_point.by","studio_point.sigma_px","studio_point.vx","studio_point.vy",""]),...i.map(s=>{let r=t?.located.residuals[s.image],o=Xt(s.image,_("studio_point.show",{point:s.image}),()=>this.going.visit(s.image,s.x,s.y),"link"),a=Xt("\u2715",_("studio_point.remove",{name:s.image}),()=>void e.act("remove",{image:s.image,point:s.point},"studio_point.mark_removed",{point:s.point}),"small"),l=Math.sqrt(Math.max(s.cov[0],s.cov[1]));return u("tr",{},u("td",{},o),u("td",{},_("studio_point.how",{how:s.how})),u("td",{},Mt(l,2)),...this.residual(s,r),u("td",{},a))}))}residual(t,e){let i=[0,1].map(s=>u("td",{},pt(e?.[s],2)));return e||this.model.observations(t.image).then(s=>{let r=s.point.indexOf(t.point);r>=0&&Math.hypot(s.x[r]-t.x,s.y[r]-t.y)<.001&&([i[0].textContent,i[1].textContent]=[pt(s.vx[r],2),pt(s.vy[r],2)])},()=>{}),i}pointRow(t){let e=this.model.marksOf(t.point).length,i=Math.max(...t.sigma.map(r=>r??-1)),s=[t.role==="tie"?"":_("studio_point.role",{role:t.role}),e?_("studio_point.mark_count",{n:e}):"",t.rays?_("studio_photo.rays",{n:t.rays}):"",i>=0?`s ${Mt(i,2)}`:""];return[u("b",{},t.point),u("small",{},s.filter(r=>r).join(" \xB7 "))]}async showPoints(){let{model:t}=this,e=this.search.value.trim(),i=await Pt("/api/points",{search:e,limit:60}),s=new Map(i.rows.map(a=>[a.point,a])),r=t.state.points.filter(a=>a.point.toLowerCase().includes(e.toLowerCase())).map(a=>({...s.get(a.point)??{rays:0,w:null,xyz:a.xyz,sigma:[null,null,null]},point:a.point,role:a.role})),o=new Set(r.map(a=>a.point));this.points.set([...r,...i.rows.filter(a=>!o.has(a.point))],t.current),this.pointsHead.textContent=_("studio_point.points_of",{n:t.state.points.length,of:t.overview.points})}};var vn={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},yn={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},$u=0,Fc=1,Zu=2;var Oc=1,Ku=2,Bi=3,Qi=0,Qe=1,zi=2,en=0,Nn=1,kc=2,Bc=3,zc=4,ju=5,pn=100,Ju=101,Qu=102,td=103,ed=104,id=200,nd=201,sd=202,rd=203,Xo=204,qo=205,od=206,ad=207,ld=208,cd=209,hd=210,ud=211,dd=212,fd=213,pd=214,va=0,ya=1,xa=2,Fn=3,ba=4,wa=5,Ma=6,Sa=7,Ea=0,md=1,gd=2,nn=0,_d=1,vd=2,yd=3,xd=4,bd=5,wd=6,Md=7;var Hc=300,Hn=301,Vn=302,Ta=303,Aa=304,Ar=306,Yo=1e3,fn=1001,$o=1002,ii=1003,Sd=1004;var Rr=1005;var Si=1006,Ra=1007;var xn=1008;var Hi=1009,Vc=1010,Gc=1011,Ms=1012,Ca=1013,bn=1014,Ri=1015,Ss=1016,Pa=1017,Ia=1018,Es=1020,Wc=35902,Xc=35899,qc=1021,Yc=1022,gi=1023,gs=1026,Ts=1027,La=1028,Da=1029,$c=1030,Ua=1031;var Na=1033,Cr=33776,Pr=33777,Ir=33778,Lr=33779,Fa=35840,Oa=35841,ka=35842,Ba=35843,za=36196,Ha=37492,Va=37496,Ga=37808,Wa=37809,Xa=37810,qa=37811,Ya=37812,$a=37813,Za=37814,Ka=37815,ja=37816,Ja=37817,Qa=37818,tl=37819,el=37820,il=37821,nl=36492,sl=36494,rl=36495,ol=36283,al=36284,ll=36285,cl=36286;var nr=2300,Zo=2301,Wo=2302,Cc=2400,Pc=2401,Ic=2402;var Ed=3200,Td=3201;var Zc=0,Ad=1,sn="",ci="srgb",On="srgb-linear",sr="linear",ne="srgb";var Dn=7680;var Lc=519,Rd=512,Cd=513,Pd=514,Kc=515,Id=516,Ld=517,Dd=518,Ud=519,Dc=35044;var jc="300 es",Mi=2e3,rr=2001;var Di=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Ve=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],wu=1234567,er=Math.PI/180,_s=180/Math.PI;function As(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Ve[n&255]+Ve[n>>8&255]+Ve[n>>16&255]+Ve[n>>24&255]+"-"+Ve[t&255]+Ve[t>>8&255]+"-"+Ve[t>>16&15|64]+Ve[t>>24&255]+"-"+Ve[e&63|128]+Ve[e>>8&255]+"-"+Ve[e>>16&255]+Ve[e>>24&255]+Ve[i&255]+Ve[i>>8&255]+Ve[i>>16&255]+Ve[i>>24&255]).toLowerCase()}function Yt(n,t,e){return Math.max(t,Math.min(e,n))}function Jc(n,t){return(n%t+t)%t}function xm(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function bm(n,t,e){return n!==t?(e-n)/(t-n):0}function ir(n,t,e){return(1-e)*n+e*t}function wm(n,t,e,i){return ir(n,t,1-Math.exp(-e*i))}function Mm(n,t=1){return t-Math.abs(Jc(n,t*2)-t)}function Sm(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Em(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Tm(n,t){return n+Math.floor(Math.random()*(t-n+1))}function Am(n,t){return n+Math.random()*(t-n)}function Rm(n){return n*(.5-Math.random())}function Cm(n){n!==void 0&&(wu=n);let t=wu+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Pm(n){return n*er}function Im(n){return n*_s}function Lm(n){return(n&n-1)===0&&n!==0}function Dm(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Um(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Nm(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),h=o((t+i)/2),d=r((t-i)/2),p=o((t-i)/2),m=r((i-t)/2),v=o((i-t)/2);switch(s){case"XYX":n.set(a*h,l*d,l*p,a*c);break;case"YZY":n.set(l*p,a*h,l*d,a*c);break;case"ZXZ":n.set(l*d,l*p,a*h,a*c);break;case"XZX":n.set(a*h,l*v,l*m,a*c);break;case"YXY":n.set(l*m,a*h,l*v,a*c);break;case"ZYZ":n.set(l*v,l*m,a*h,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ps(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function Ze(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}var Qc={DEG2RAD:er,RAD2DEG:_s,generateUUID:As,clamp:Yt,euclideanModulo:Jc,mapLinear:xm,inverseLerp:bm,lerp:ir,damp:wm,pingpong:Mm,smoothstep:Sm,smootherstep:Em,randInt:Tm,randFloat:Am,randFloatSpread:Rm,seededRandom:Cm,degToRad:Pm,radToDeg:Im,isPowerOfTwo:Lm,ceilPowerOfTwo:Dm,floorPowerOfTwo:Um,setQuaternionFromProperEuler:Nm,normalize:Ze,denormalize:ps},zt=class n{constructor(t=0,e=0){n.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Yt(this.x,t.x,e.x),this.y=Yt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Yt(this.x,t,e),this.y=Yt(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Yt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Yt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},mi=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],d=i[s+3],p=r[o+0],m=r[o+1],v=r[o+2],b=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=h,t[e+3]=d;return}if(a===1){t[e+0]=p,t[e+1]=m,t[e+2]=v,t[e+3]=b;return}if(d!==b||l!==p||c!==m||h!==v){let g=1-a,f=l*p+c*m+h*v+d*b,R=f>=0?1:-1,E=1-f*f;if(E>Number.EPSILON){let I=Math.sqrt(E),P=Math.atan2(I,f*R);g=Math.sin(g*P)/I,a=Math.sin(a*P)/I}let S=a*R;if(l=l*g+p*S,c=c*g+m*S,h=h*g+v*S,d=d*g+b*S,g===1-a){let I=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=I,c*=I,h*=I,d*=I}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],d=r[o],p=r[o+1],m=r[o+2],v=r[o+3];return t[e]=a*v+h*d+l*m-c*p,t[e+1]=l*v+h*p+c*d-a*m,t[e+2]=c*v+h*m+a*p-l*d,t[e+3]=h*v-a*d-l*p-c*m,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),d=a(r/2),p=l(i/2),m=l(s/2),v=l(r/2);switch(o){case"XYZ":this._x=p*h*d+c*m*v,this._y=c*m*d-p*h*v,this._z=c*h*v+p*m*d,this._w=c*h*d-p*m*v;break;case"YXZ":this._x=p*h*d+c*m*v,this._y=c*m*d-p*h*v,this._z=c*h*v-p*m*d,this._w=c*h*d+p*m*v;break;case"ZXY":this._x=p*h*d-c*m*v,this._y=c*m*d+p*h*v,this._z=c*h*v+p*m*d,this._w=c*h*d-p*m*v;break;case"ZYX":this._x=p*h*d-c*m*v,this._y=c*m*d+p*h*v,this._z=c*h*v-p*m*d,this._w=c*h*d+p*m*v;break;case"YZX":this._x=p*h*d+c*m*v,this._y=c*m*d+p*h*v,this._z=c*h*v-p*m*d,this._w=c*h*d-p*m*v;break;case"XZY":this._x=p*h*d-c*m*v,this._y=c*m*d-p*h*v,this._z=c*h*v+p*m*d,this._w=c*h*d+p*m*v;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],d=e[10],p=i+a+d;if(p>0){let m=.5/Math.sqrt(p+1);this._w=.25/m,this._x=(h-l)*m,this._y=(r-c)*m,this._z=(o-s)*m}else if(i>a&&i>d){let m=2*Math.sqrt(1+i-a-d);this._w=(h-l)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+c)/m}else if(a>d){let m=2*Math.sqrt(1+a-i-d);this._w=(r-c)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(l+h)/m}else{let m=2*Math.sqrt(1+d-i-a);this._w=(o-s)/m,this._x=(r+c)/m,this._y=(l+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Yt(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);let i=this._x,s=this._y,r=this._z,o=this._w,a=o*t._w+i*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=i,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let m=1-e;return this._w=m*o+e*this._w,this._x=m*i+e*this._x,this._y=m*s+e*this._y,this._z=m*r+e*this._z,this.normalize(),this}let c=Math.sqrt(l),h=Math.atan2(c,a),d=Math.sin((1-e)*h)/c,p=Math.sin(e*h)/c;return this._w=o*d+this._w*p,this._x=i*d+this._x*p,this._y=s*d+this._y*p,this._z=r*d+this._z*p,this._onChangeCallback(),this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},F=class n{constructor(t=0,e=0,i=0){n.prototype.isVector3=!0,this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Mu.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Mu.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),h=2*(a*e-r*s),d=2*(r*i-o*e);return this.x=e+l*c+o*d-a*h,this.y=i+l*h+a*c-r*d,this.z=s+l*d+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Yt(this.x,t.x,e.x),this.y=Yt(this.y,t.y,e.y),this.z=Yt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Yt(this.x,t,e),this.y=Yt(this.y,t,e),this.z=Yt(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Yt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return ac.copy(this).projectOnVector(t),this.sub(ac)}reflect(t){return this.sub(ac.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Yt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ac=new F,Mu=new mi,Ht=class n{constructor(t,e,i,s,r,o,a,l,c){n.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],d=i[7],p=i[2],m=i[5],v=i[8],b=s[0],g=s[3],f=s[6],R=s[1],E=s[4],S=s[7],I=s[2],P=s[5],D=s[8];return r[0]=o*b+a*R+l*I,r[3]=o*g+a*E+l*P,r[6]=o*f+a*S+l*D,r[1]=c*b+h*R+d*I,r[4]=c*g+h*E+d*P,r[7]=c*f+h*S+d*D,r[2]=p*b+m*R+v*I,r[5]=p*g+m*E+v*P,r[8]=p*f+m*S+v*D,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=h*o-a*c,p=a*l-h*r,m=c*r-o*l,v=e*d+i*p+s*m;if(v===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/v;return t[0]=d*b,t[1]=(s*c-h*i)*b,t[2]=(a*i-s*o)*b,t[3]=p*b,t[4]=(h*e-s*l)*b,t[5]=(s*r-a*e)*b,t[6]=m*b,t[7]=(i*l-c*e)*b,t[8]=(o*e-i*r)*b,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(lc.makeScale(t,e)),this}rotate(t){return this.premultiply(lc.makeRotation(-t)),this}translate(t,e){return this.premultiply(lc.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},lc=new Ht;function th(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function or(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Nd(){let n=or("canvas");return n.style.display="block",n}var Su={};function vs(n){n in Su||(Su[n]=!0,console.warn(n))}function Fd(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Eu=new Ht().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Tu=new Ht().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Fm(){let n={enabled:!0,workingColorSpace:On,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===ne&&(s.r=Ji(s.r),s.g=Ji(s.g),s.b=Ji(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===ne&&(s.r=ms(s.r),s.g=ms(s.g),s.b=ms(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===sn?sr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return vs("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),n.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return vs("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),n.colorSpaceToWorking(s,r)}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[On]:{primaries:t,whitePoint:i,transfer:sr,toXYZ:Eu,fromXYZ:Tu,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ci},outputColorSpaceConfig:{drawingBufferColorSpace:ci}},[ci]:{primaries:t,whitePoint:i,transfer:ne,toXYZ:Eu,fromXYZ:Tu,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ci}}}),n}var Jt=Fm();function Ji(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ms(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var es,Ko=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{es===void 0&&(es=or("canvas")),es.width=t.width,es.height=t.height;let s=es.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=es}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=or("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ji(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Ji(e[i]/255)*255):e[i]=Ji(e[i]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Om=0,ys=class{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:Om++}),this.uuid=As(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):e instanceof VideoFrame?t.set(e.displayHeight,e.displayWidth,0):e!==null?t.set(e.width,e.height,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(cc(s[o].image)):r.push(cc(s[o]))}else r=cc(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function cc(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Ko.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var km=0,hc=new F,Je=class n extends Di{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=fn,s=fn,r=Si,o=xn,a=gi,l=Hi,c=n.DEFAULT_ANISOTROPY,h=sn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:km++}),this.uuid=As(),this.name="",this.source=new ys(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new zt(0,0),this.repeat=new zt(1,1),this.center=new zt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ht,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(hc).x}get height(){return this.source.getSize(hc).y}get depth(){return this.source.getSize(hc).z}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){console.warn(`THREE.Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Hc)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Yo:t.x=t.x-Math.floor(t.x);break;case fn:t.x=t.x<0?0:1;break;case $o:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Yo:t.y=t.y-Math.floor(t.y);break;case fn:t.y=t.y<0?0:1;break;case $o:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Je.DEFAULT_IMAGE=null;Je.DEFAULT_MAPPING=Hc;Je.DEFAULT_ANISOTROPY=1;var we=class n{constructor(t=0,e=0,i=0,s=1){n.prototype.isVector4=!0,this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],d=l[8],p=l[1],m=l[5],v=l[9],b=l[2],g=l[6],f=l[10];if(Math.abs(h-p)<.01&&Math.abs(d-b)<.01&&Math.abs(v-g)<.01){if(Math.abs(h+p)<.1&&Math.abs(d+b)<.1&&Math.abs(v+g)<.1&&Math.abs(c+m+f-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let E=(c+1)/2,S=(m+1)/2,I=(f+1)/2,P=(h+p)/4,D=(d+b)/4,k=(v+g)/4;return E>S&&E>I?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=P/i,r=D/i):S>I?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=P/s,r=k/s):I<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),i=D/r,s=k/r),this.set(i,s,r,e),this}let R=Math.sqrt((g-v)*(g-v)+(d-b)*(d-b)+(p-h)*(p-h));return Math.abs(R)<.001&&(R=1),this.x=(g-v)/R,this.y=(d-b)/R,this.z=(p-h)/R,this.w=Math.acos((c+m+f-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Yt(this.x,t.x,e.x),this.y=Yt(this.y,t.y,e.y),this.z=Yt(this.z,t.z,e.z),this.w=Yt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Yt(this.x,t,e),this.y=Yt(this.y,t,e),this.z=Yt(this.z,t,e),this.w=Yt(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Yt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},jo=class extends Di{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Si,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new we(0,0,t,e),this.scissorTest=!1,this.viewport=new we(0,0,t,e);let s={width:t,height:e,depth:i.depth},r=new Je(s);this.textures=[];let o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview}_setTextureOptions(t={}){let e={minFilter:Si,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),t!==null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new ys(s)}return this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ui=class extends jo{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},ar=class extends Je{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ii,this.minFilter=ii,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Jo=class extends Je{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ii,this.minFilter=ii,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ni=class{constructor(t=new F(1/0,1/0,1/0),e=new F(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(xi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(xi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=xi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,xi):xi.fromBufferAttribute(r,o),xi.applyMatrix4(t.matrixWorld),this.expandByPoint(xi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),bo.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),bo.copy(i.boundingBox)),bo.applyMatrix4(t.matrixWorld),this.union(bo)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,xi),xi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter($s),wo.subVectors(this.max,$s),is.subVectors(t.a,$s),ns.subVectors(t.b,$s),ss.subVectors(t.c,$s),on.subVectors(ns,is),an.subVectors(ss,ns),Cn.subVectors(is,ss);let e=[0,-on.z,on.y,0,-an.z,an.y,0,-Cn.z,Cn.y,on.z,0,-on.x,an.z,0,-an.x,Cn.z,0,-Cn.x,-on.y,on.x,0,-an.y,an.x,0,-Cn.y,Cn.x,0];return!uc(e,is,ns,ss,wo)||(e=[1,0,0,0,1,0,0,0,1],!uc(e,is,ns,ss,wo))?!1:(Mo.crossVectors(on,an),e=[Mo.x,Mo.y,Mo.z],uc(e,is,ns,ss,wo))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,xi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(xi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Yi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Yi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Yi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Yi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Yi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Yi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Yi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Yi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Yi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Yi=[new F,new F,new F,new F,new F,new F,new F,new F],xi=new F,bo=new Ni,is=new F,ns=new F,ss=new F,on=new F,an=new F,Cn=new F,$s=new F,wo=new F,Mo=new F,Pn=new F;function uc(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Pn.fromArray(n,r);let a=s.x*Math.abs(Pn.x)+s.y*Math.abs(Pn.y)+s.z*Math.abs(Pn.z),l=t.dot(Pn),c=e.dot(Pn),h=i.dot(Pn);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Bm=new Ni,Zs=new F,dc=new F,Fi=class{constructor(t=new F,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Bm.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Zs.subVectors(t,this.center);let e=Zs.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Zs,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(dc.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Zs.copy(t.center).add(dc)),this.expandByPoint(Zs.copy(t.center).sub(dc))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},$i=new F,fc=new F,So=new F,ln=new F,pc=new F,Eo=new F,mc=new F,mn=class{constructor(t=new F,e=new F(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,$i)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=$i.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):($i.copy(this.origin).addScaledVector(this.direction,e),$i.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){fc.copy(t).add(e).multiplyScalar(.5),So.copy(e).sub(t).normalize(),ln.copy(this.origin).sub(fc);let r=t.distanceTo(e)*.5,o=-this.direction.dot(So),a=ln.dot(this.direction),l=-ln.dot(So),c=ln.lengthSq(),h=Math.abs(1-o*o),d,p,m,v;if(h>0)if(d=o*l-a,p=o*a-l,v=r*h,d>=0)if(p>=-v)if(p<=v){let b=1/h;d*=b,p*=b,m=d*(d+o*p+2*a)+p*(o*d+p+2*l)+c}else p=r,d=Math.max(0,-(o*p+a)),m=-d*d+p*(p+2*l)+c;else p=-r,d=Math.max(0,-(o*p+a)),m=-d*d+p*(p+2*l)+c;else p<=-v?(d=Math.max(0,-(-o*r+a)),p=d>0?-r:Math.min(Math.max(-r,-l),r),m=-d*d+p*(p+2*l)+c):p<=v?(d=0,p=Math.min(Math.max(-r,-l),r),m=p*(p+2*l)+c):(d=Math.max(0,-(o*r+a)),p=d>0?r:Math.min(Math.max(-r,-l),r),m=-d*d+p*(p+2*l)+c);else p=o>0?-r:r,d=Math.max(0,-(o*p+a)),m=-d*d+p*(p+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(fc).addScaledVector(So,p),m}intersectSphere(t,e){$i.subVectors(t.center,this.origin);let i=$i.dot(this.direction),s=$i.dot($i)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,p=this.origin;return c>=0?(i=(t.min.x-p.x)*c,s=(t.max.x-p.x)*c):(i=(t.max.x-p.x)*c,s=(t.min.x-p.x)*c),h>=0?(r=(t.min.y-p.y)*h,o=(t.max.y-p.y)*h):(r=(t.max.y-p.y)*h,o=(t.min.y-p.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-p.z)*d,l=(t.max.z-p.z)*d):(a=(t.max.z-p.z)*d,l=(t.min.z-p.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,$i)!==null}intersectTriangle(t,e,i,s,r){pc.subVectors(e,t),Eo.subVectors(i,t),mc.crossVectors(pc,Eo);let o=this.direction.dot(mc),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;ln.subVectors(this.origin,t);let l=a*this.direction.dot(Eo.crossVectors(ln,Eo));if(l<0)return null;let c=a*this.direction.dot(pc.cross(ln));if(c<0||l+c>o)return null;let h=-a*ln.dot(mc);return h<0?null:this.at(h/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ae=class n{constructor(t,e,i,s,r,o,a,l,c,h,d,p,m,v,b,g){n.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,h,d,p,m,v,b,g)}set(t,e,i,s,r,o,a,l,c,h,d,p,m,v,b,g){let f=this.elements;return f[0]=t,f[4]=e,f[8]=i,f[12]=s,f[1]=r,f[5]=o,f[9]=a,f[13]=l,f[2]=c,f[6]=h,f[10]=d,f[14]=p,f[3]=m,f[7]=v,f[11]=b,f[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){let e=this.elements,i=t.elements,s=1/rs.setFromMatrixColumn(t,0).length(),r=1/rs.setFromMatrixColumn(t,1).length(),o=1/rs.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let p=o*h,m=o*d,v=a*h,b=a*d;e[0]=l*h,e[4]=-l*d,e[8]=c,e[1]=m+v*c,e[5]=p-b*c,e[9]=-a*l,e[2]=b-p*c,e[6]=v+m*c,e[10]=o*l}else if(t.order==="YXZ"){let p=l*h,m=l*d,v=c*h,b=c*d;e[0]=p+b*a,e[4]=v*a-m,e[8]=o*c,e[1]=o*d,e[5]=o*h,e[9]=-a,e[2]=m*a-v,e[6]=b+p*a,e[10]=o*l}else if(t.order==="ZXY"){let p=l*h,m=l*d,v=c*h,b=c*d;e[0]=p-b*a,e[4]=-o*d,e[8]=v+m*a,e[1]=m+v*a,e[5]=o*h,e[9]=b-p*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let p=o*h,m=o*d,v=a*h,b=a*d;e[0]=l*h,e[4]=v*c-m,e[8]=p*c+b,e[1]=l*d,e[5]=b*c+p,e[9]=m*c-v,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let p=o*l,m=o*c,v=a*l,b=a*c;e[0]=l*h,e[4]=b-p*d,e[8]=v*d+m,e[1]=d,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=m*d+v,e[10]=p-b*d}else if(t.order==="XZY"){let p=o*l,m=o*c,v=a*l,b=a*c;e[0]=l*h,e[4]=-d,e[8]=c*h,e[1]=p*d+b,e[5]=o*h,e[9]=m*d-v,e[2]=v*d-m,e[6]=a*h,e[10]=b*d+p}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(zm,t,Hm)}lookAt(t,e,i){let s=this.elements;return ai.subVectors(t,e),ai.lengthSq()===0&&(ai.z=1),ai.normalize(),cn.crossVectors(i,ai),cn.lengthSq()===0&&(Math.abs(i.z)===1?ai.x+=1e-4:ai.z+=1e-4,ai.normalize(),cn.crossVectors(i,ai)),cn.normalize(),To.crossVectors(ai,cn),s[0]=cn.x,s[4]=To.x,s[8]=ai.x,s[1]=cn.y,s[5]=To.y,s[9]=ai.y,s[2]=cn.z,s[6]=To.z,s[10]=ai.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],d=i[5],p=i[9],m=i[13],v=i[2],b=i[6],g=i[10],f=i[14],R=i[3],E=i[7],S=i[11],I=i[15],P=s[0],D=s[4],k=s[8],x=s[12],w=s[1],C=s[5],B=s[9],V=s[13],X=s[2],K=s[6],Y=s[10],st=s[14],G=s[3],lt=s[7],dt=s[11],Rt=s[15];return r[0]=o*P+a*w+l*X+c*G,r[4]=o*D+a*C+l*K+c*lt,r[8]=o*k+a*B+l*Y+c*dt,r[12]=o*x+a*V+l*st+c*Rt,r[1]=h*P+d*w+p*X+m*G,r[5]=h*D+d*C+p*K+m*lt,r[9]=h*k+d*B+p*Y+m*dt,r[13]=h*x+d*V+p*st+m*Rt,r[2]=v*P+b*w+g*X+f*G,r[6]=v*D+b*C+g*K+f*lt,r[10]=v*k+b*B+g*Y+f*dt,r[14]=v*x+b*V+g*st+f*Rt,r[3]=R*P+E*w+S*X+I*G,r[7]=R*D+E*C+S*K+I*lt,r[11]=R*k+E*B+S*Y+I*dt,r[15]=R*x+E*V+S*st+I*Rt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],d=t[6],p=t[10],m=t[14],v=t[3],b=t[7],g=t[11],f=t[15];return v*(+r*l*d-s*c*d-r*a*p+i*c*p+s*a*m-i*l*m)+b*(+e*l*m-e*c*p+r*o*p-s*o*m+s*c*h-r*l*h)+g*(+e*c*d-e*a*m-r*o*d+i*o*m+r*a*h-i*c*h)+f*(-s*a*h-e*l*d+e*a*p+s*o*d-i*o*p+i*l*h)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=t[9],p=t[10],m=t[11],v=t[12],b=t[13],g=t[14],f=t[15],R=d*g*c-b*p*c+b*l*m-a*g*m-d*l*f+a*p*f,E=v*p*c-h*g*c-v*l*m+o*g*m+h*l*f-o*p*f,S=h*b*c-v*d*c+v*a*m-o*b*m-h*a*f+o*d*f,I=v*d*l-h*b*l-v*a*p+o*b*p+h*a*g-o*d*g,P=e*R+i*E+s*S+r*I;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let D=1/P;return t[0]=R*D,t[1]=(b*p*r-d*g*r-b*s*m+i*g*m+d*s*f-i*p*f)*D,t[2]=(a*g*r-b*l*r+b*s*c-i*g*c-a*s*f+i*l*f)*D,t[3]=(d*l*r-a*p*r-d*s*c+i*p*c+a*s*m-i*l*m)*D,t[4]=E*D,t[5]=(h*g*r-v*p*r+v*s*m-e*g*m-h*s*f+e*p*f)*D,t[6]=(v*l*r-o*g*r-v*s*c+e*g*c+o*s*f-e*l*f)*D,t[7]=(o*p*r-h*l*r+h*s*c-e*p*c-o*s*m+e*l*m)*D,t[8]=S*D,t[9]=(v*d*r-h*b*r-v*i*m+e*b*m+h*i*f-e*d*f)*D,t[10]=(o*b*r-v*a*r+v*i*c-e*b*c-o*i*f+e*a*f)*D,t[11]=(h*a*r-o*d*r-h*i*c+e*d*c+o*i*m-e*a*m)*D,t[12]=I*D,t[13]=(h*b*s-v*d*s+v*i*p-e*b*p-h*i*g+e*d*g)*D,t[14]=(v*a*s-o*b*s-v*i*l+e*b*l+o*i*g-e*a*g)*D,t[15]=(o*d*s-h*a*s+h*i*l-e*d*l-o*i*p+e*a*p)*D,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,d=a+a,p=r*c,m=r*h,v=r*d,b=o*h,g=o*d,f=a*d,R=l*c,E=l*h,S=l*d,I=i.x,P=i.y,D=i.z;return s[0]=(1-(b+f))*I,s[1]=(m+S)*I,s[2]=(v-E)*I,s[3]=0,s[4]=(m-S)*P,s[5]=(1-(p+f))*P,s[6]=(g+R)*P,s[7]=0,s[8]=(v+E)*D,s[9]=(g-R)*D,s[10]=(1-(p+b))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements,r=rs.set(s[0],s[1],s[2]).length(),o=rs.set(s[4],s[5],s[6]).length(),a=rs.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],bi.copy(this);let c=1/r,h=1/o,d=1/a;return bi.elements[0]*=c,bi.elements[1]*=c,bi.elements[2]*=c,bi.elements[4]*=h,bi.elements[5]*=h,bi.elements[6]*=h,bi.elements[8]*=d,bi.elements[9]*=d,bi.elements[10]*=d,e.setFromRotationMatrix(bi),i.x=r,i.y=o,i.z=a,this}makePerspective(t,e,i,s,r,o,a=Mi,l=!1){let c=this.elements,h=2*r/(e-t),d=2*r/(i-s),p=(e+t)/(e-t),m=(i+s)/(i-s),v,b;if(l)v=r/(o-r),b=o*r/(o-r);else if(a===Mi)v=-(o+r)/(o-r),b=-2*o*r/(o-r);else if(a===rr)v=-o/(o-r),b=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=p,c[12]=0,c[1]=0,c[5]=d,c[9]=m,c[13]=0,c[2]=0,c[6]=0,c[10]=v,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Mi,l=!1){let c=this.elements,h=2/(e-t),d=2/(i-s),p=-(e+t)/(e-t),m=-(i+s)/(i-s),v,b;if(l)v=1/(o-r),b=o/(o-r);else if(a===Mi)v=-2/(o-r),b=-(o+r)/(o-r);else if(a===rr)v=-1/(o-r),b=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=p,c[1]=0,c[5]=d,c[9]=0,c[13]=m,c[2]=0,c[6]=0,c[10]=v,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},rs=new F,bi=new ae,zm=new F(0,0,0),Hm=new F(1,1,1),cn=new F,To=new F,ai=new F,Au=new ae,Ru=new mi,Ei=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],d=s[2],p=s[6],m=s[10];switch(e){case"XYZ":this._y=Math.asin(Yt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(p,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Yt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(Yt(p,-1,1)),Math.abs(p)<.9999999?(this._y=Math.atan2(-d,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Yt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(p,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Yt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-Yt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(p,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Au.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Au,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Ru.setFromEuler(this),this.setFromQuaternion(Ru,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ei.DEFAULT_ORDER="XYZ";var lr=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Vm=0,Cu=new F,os=new mi,Zi=new ae,Ao=new F,Ks=new F,Gm=new F,Wm=new mi,Pu=new F(1,0,0),Iu=new F(0,1,0),Lu=new F(0,0,1),Du={type:"added"},Xm={type:"removed"},as={type:"childadded",child:null},gc={type:"childremoved",child:null},Xe=class n extends Di{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Vm++}),this.uuid=As(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new F,e=new Ei,i=new mi,s=new F(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ae},normalMatrix:{value:new Ht}}),this.matrix=new ae,this.matrixWorld=new ae,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new lr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return os.setFromAxisAngle(t,e),this.quaternion.multiply(os),this}rotateOnWorldAxis(t,e){return os.setFromAxisAngle(t,e),this.quaternion.premultiply(os),this}rotateX(t){return this.rotateOnAxis(Pu,t)}rotateY(t){return this.rotateOnAxis(Iu,t)}rotateZ(t){return this.rotateOnAxis(Lu,t)}translateOnAxis(t,e){return Cu.copy(t).applyQuaternion(this.quaternion),this.position.add(Cu.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Pu,t)}translateY(t){return this.translateOnAxis(Iu,t)}translateZ(t){return this.translateOnAxis(Lu,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Zi.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Ao.copy(t):Ao.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ks.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Zi.lookAt(Ks,Ao,this.up):Zi.lookAt(Ao,Ks,this.up),this.quaternion.setFromRotationMatrix(Zi),s&&(Zi.extractRotation(s.matrixWorld),os.setFromRotationMatrix(Zi),this.quaternion.premultiply(os.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Du),as.child=t,this.dispatchEvent(as),as.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Xm),gc.child=t,this.dispatchEvent(gc),gc.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Zi.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Zi.multiply(t.parent.matrixWorld)),t.applyMatrix4(Zi),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Du),as.child=t,this.dispatchEvent(as),as.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ks,t,Gm),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ks,Wm,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e){let i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),d=o(t.shapes),p=o(t.skeletons),m=o(t.animations),v=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),d.length>0&&(i.shapes=d),p.length>0&&(i.skeletons=p),m.length>0&&(i.animations=m),v.length>0&&(i.nodes=v)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}};Xe.DEFAULT_UP=new F(0,1,0);Xe.DEFAULT_MATRIX_AUTO_UPDATE=!0;Xe.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var wi=new F,Ki=new F,_c=new F,ji=new F,ls=new F,cs=new F,Uu=new F,vc=new F,yc=new F,xc=new F,bc=new we,wc=new we,Mc=new we,dn=class n{constructor(t=new F,e=new F,i=new F){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),wi.subVectors(t,e),s.cross(wi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){wi.subVectors(s,e),Ki.subVectors(i,e),_c.subVectors(t,e);let o=wi.dot(wi),a=wi.dot(Ki),l=wi.dot(_c),c=Ki.dot(Ki),h=Ki.dot(_c),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let p=1/d,m=(c*l-a*h)*p,v=(o*h-a*l)*p;return r.set(1-m-v,v,m)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,ji)===null?!1:ji.x>=0&&ji.y>=0&&ji.x+ji.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,ji)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ji.x),l.addScaledVector(o,ji.y),l.addScaledVector(a,ji.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return bc.setScalar(0),wc.setScalar(0),Mc.setScalar(0),bc.fromBufferAttribute(t,e),wc.fromBufferAttribute(t,i),Mc.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(bc,r.x),o.addScaledVector(wc,r.y),o.addScaledVector(Mc,r.z),o}static isFrontFacing(t,e,i,s){return wi.subVectors(i,e),Ki.subVectors(t,e),wi.cross(Ki).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return wi.subVectors(this.c,this.b),Ki.subVectors(this.a,this.b),wi.cross(Ki).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;ls.subVectors(s,i),cs.subVectors(r,i),vc.subVectors(t,i);let l=ls.dot(vc),c=cs.dot(vc);if(l<=0&&c<=0)return e.copy(i);yc.subVectors(t,s);let h=ls.dot(yc),d=cs.dot(yc);if(h>=0&&d<=h)return e.copy(s);let p=l*d-h*c;if(p<=0&&l>=0&&h<=0)return o=l/(l-h),e.copy(i).addScaledVector(ls,o);xc.subVectors(t,r);let m=ls.dot(xc),v=cs.dot(xc);if(v>=0&&m<=v)return e.copy(r);let b=m*c-l*v;if(b<=0&&c>=0&&v<=0)return a=c/(c-v),e.copy(i).addScaledVector(cs,a);let g=h*v-m*d;if(g<=0&&d-h>=0&&m-v>=0)return Uu.subVectors(r,s),a=(d-h)/(d-h+(m-v)),e.copy(s).addScaledVector(Uu,a);let f=1/(g+b+p);return o=b*f,a=p*f,e.copy(i).addScaledVector(ls,o).addScaledVector(cs,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Od={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},hn={h:0,s:0,l:0},Ro={h:0,s:0,l:0};function Sc(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Ot=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ci){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Jt.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Jt.workingColorSpace){return this.r=t,this.g=e,this.b=i,Jt.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Jt.workingColorSpace){if(t=Jc(t,1),e=Yt(e,0,1),i=Yt(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Sc(o,r,t+1/3),this.g=Sc(o,r,t),this.b=Sc(o,r,t-1/3)}return Jt.colorSpaceToWorking(this,s),this}setStyle(t,e=ci){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ci){let i=Od[t.toLowerCase()];return i!==void 0?this.setHex(i,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Ji(t.r),this.g=Ji(t.g),this.b=Ji(t.b),this}copyLinearToSRGB(t){return this.r=ms(t.r),this.g=ms(t.g),this.b=ms(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ci){return Jt.workingToColorSpace(Ge.copy(this),t),Math.round(Yt(Ge.r*255,0,255))*65536+Math.round(Yt(Ge.g*255,0,255))*256+Math.round(Yt(Ge.b*255,0,255))}getHexString(t=ci){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Jt.workingColorSpace){Jt.workingToColorSpace(Ge.copy(this),e);let i=Ge.r,s=Ge.g,r=Ge.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Jt.workingColorSpace){return Jt.workingToColorSpace(Ge.copy(this),e),t.r=Ge.r,t.g=Ge.g,t.b=Ge.b,t}getStyle(t=ci){Jt.workingToColorSpace(Ge.copy(this),t);let e=Ge.r,i=Ge.g,s=Ge.b;return t!==ci?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(hn),this.setHSL(hn.h+t,hn.s+e,hn.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(hn),t.getHSL(Ro);let i=ir(hn.h,Ro.h,e),s=ir(hn.s,Ro.s,e),r=ir(hn.l,Ro.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ge=new Ot;Ot.NAMES=Od;var qm=0,Oi=class extends Di{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:qm++}),this.uuid=As(),this.name="",this.type="Material",this.blending=Nn,this.side=Qi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Xo,this.blendDst=qo,this.blendEquation=pn,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ot(0,0,0),this.blendAlpha=0,this.depthFunc=Fn,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Lc,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Dn,this.stencilZFail=Dn,this.stencilZPass=Dn,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Nn&&(i.blending=this.blending),this.side!==Qi&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Xo&&(i.blendSrc=this.blendSrc),this.blendDst!==qo&&(i.blendDst=this.blendDst),this.blendEquation!==pn&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==Fn&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Lc&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Dn&&(i.stencilFail=this.stencilFail),this.stencilZFail!==Dn&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==Dn&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},cr=class extends Oi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ot(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ei,this.combine=Ea,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}};var Ae=new F,Co=new zt,Ym=0,be=class{constructor(t,e,i=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ym++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Dc,this.updateRanges=[],this.gpuType=Ri,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Co.fromBufferAttribute(this,e),Co.applyMatrix3(t),this.setXY(e,Co.x,Co.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Ae.fromBufferAttribute(this,e),Ae.applyMatrix3(t),this.setXYZ(e,Ae.x,Ae.y,Ae.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Ae.fromBufferAttribute(this,e),Ae.applyMatrix4(t),this.setXYZ(e,Ae.x,Ae.y,Ae.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Ae.fromBufferAttribute(this,e),Ae.applyNormalMatrix(t),this.setXYZ(e,Ae.x,Ae.y,Ae.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Ae.fromBufferAttribute(this,e),Ae.transformDirection(t),this.setXYZ(e,Ae.x,Ae.y,Ae.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=ps(i,this.array)),i}setComponent(t,e,i){return this.normalized&&(i=Ze(i,this.array)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=ps(e,this.array)),e}setX(t,e){return this.normalized&&(e=Ze(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=ps(e,this.array)),e}setY(t,e){return this.normalized&&(e=Ze(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=ps(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Ze(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=ps(e,this.array)),e}setW(t,e){return this.normalized&&(e=Ze(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=Ze(e,this.array),i=Ze(i,this.array)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=Ze(e,this.array),i=Ze(i,this.array),s=Ze(s,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=Ze(e,this.array),i=Ze(i,this.array),s=Ze(s,this.array),r=Ze(r,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==Dc&&(t.usage=this.usage),t}};var hr=class extends be{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var ur=class extends be{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var je=class extends be{constructor(t,e,i){super(new Float32Array(t),e,i)}},$m=0,pi=new ae,Ec=new Xe,hs=new F,li=new Ni,js=new Ni,De=new F,Me=class n extends Di{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:$m++}),this.uuid=As(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(th(t)?ur:hr)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Ht().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return pi.makeRotationFromQuaternion(t),this.applyMatrix4(pi),this}rotateX(t){return pi.makeRotationX(t),this.applyMatrix4(pi),this}rotateY(t){return pi.makeRotationY(t),this.applyMatrix4(pi),this}rotateZ(t){return pi.makeRotationZ(t),this.applyMatrix4(pi),this}translate(t,e,i){return pi.makeTranslation(t,e,i),this.applyMatrix4(pi),this}scale(t,e,i){return pi.makeScale(t,e,i),this.applyMatrix4(pi),this}lookAt(t){return Ec.lookAt(t),Ec.updateMatrix(),this.applyMatrix4(Ec.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(hs).negate(),this.translate(hs.x,hs.y,hs.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new je(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ni);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new F(-1/0,-1/0,-1/0),new F(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];li.setFromBufferAttribute(r),this.morphTargetsRelative?(De.addVectors(this.boundingBox.min,li.min),this.boundingBox.expandByPoint(De),De.addVectors(this.boundingBox.max,li.max),this.boundingBox.expandByPoint(De)):(this.boundingBox.expandByPoint(li.min),this.boundingBox.expandByPoint(li.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Fi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new F,1/0);return}if(t){let i=this.boundingSphere.center;if(li.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];js.setFromBufferAttribute(a),this.morphTargetsRelative?(De.addVectors(li.min,js.min),li.expandByPoint(De),De.addVectors(li.max,js.max),li.expandByPoint(De)):(li.expandByPoint(js.min),li.expandByPoint(js.max))}li.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)De.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(De));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)De.fromBufferAttribute(a,c),l&&(hs.fromBufferAttribute(t,c),De.add(hs)),s=Math.max(s,i.distanceToSquared(De))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new be(new Float32Array(4*i.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let k=0;k<i.count;k++)a[k]=new F,l[k]=new F;let c=new F,h=new F,d=new F,p=new zt,m=new zt,v=new zt,b=new F,g=new F;function f(k,x,w){c.fromBufferAttribute(i,k),h.fromBufferAttribute(i,x),d.fromBufferAttribute(i,w),p.fromBufferAttribute(r,k),m.fromBufferAttribute(r,x),v.fromBufferAttribute(r,w),h.sub(c),d.sub(c),m.sub(p),v.sub(p);let C=1/(m.x*v.y-v.x*m.y);isFinite(C)&&(b.copy(h).multiplyScalar(v.y).addScaledVector(d,-m.y).multiplyScalar(C),g.copy(d).multiplyScalar(m.x).addScaledVector(h,-v.x).multiplyScalar(C),a[k].add(b),a[x].add(b),a[w].add(b),l[k].add(g),l[x].add(g),l[w].add(g))}let R=this.groups;R.length===0&&(R=[{start:0,count:t.count}]);for(let k=0,x=R.length;k<x;++k){let w=R[k],C=w.start,B=w.count;for(let V=C,X=C+B;V<X;V+=3)f(t.getX(V+0),t.getX(V+1),t.getX(V+2))}let E=new F,S=new F,I=new F,P=new F;function D(k){I.fromBufferAttribute(s,k),P.copy(I);let x=a[k];E.copy(x),E.sub(I.multiplyScalar(I.dot(x))).normalize(),S.crossVectors(P,x);let C=S.dot(l[k])<0?-1:1;o.setXYZW(k,E.x,E.y,E.z,C)}for(let k=0,x=R.length;k<x;++k){let w=R[k],C=w.start,B=w.count;for(let V=C,X=C+B;V<X;V+=3)D(t.getX(V+0)),D(t.getX(V+1)),D(t.getX(V+2))}}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new be(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let p=0,m=i.count;p<m;p++)i.setXYZ(p,0,0,0);let s=new F,r=new F,o=new F,a=new F,l=new F,c=new F,h=new F,d=new F;if(t)for(let p=0,m=t.count;p<m;p+=3){let v=t.getX(p+0),b=t.getX(p+1),g=t.getX(p+2);s.fromBufferAttribute(e,v),r.fromBufferAttribute(e,b),o.fromBufferAttribute(e,g),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(i,v),l.fromBufferAttribute(i,b),c.fromBufferAttribute(i,g),a.add(h),l.add(h),c.add(h),i.setXYZ(v,a.x,a.y,a.z),i.setXYZ(b,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let p=0,m=e.count;p<m;p+=3)s.fromBufferAttribute(e,p+0),r.fromBufferAttribute(e,p+1),o.fromBufferAttribute(e,p+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),i.setXYZ(p+0,h.x,h.y,h.z),i.setXYZ(p+1,h.x,h.y,h.z),i.setXYZ(p+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)De.fromBufferAttribute(t,e),De.normalize(),t.setXYZ(e,De.x,De.y,De.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,d=a.normalized,p=new c.constructor(l.length*h),m=0,v=0;for(let b=0,g=l.length;b<g;b++){a.isInterleavedBufferAttribute?m=l[b]*a.data.stride+a.offset:m=l[b]*h;for(let f=0;f<h;f++)p[v++]=c[m++]}return new be(p,h,d)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){let p=c[h],m=t(p,i);l.push(m)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,p=c.length;d<p;d++){let m=c[d];h.push(m.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],d=r[c];for(let p=0,m=d.length;p<m;p++)h.push(d[p].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},Nu=new ae,In=new mn,Po=new Fi,Fu=new F,Io=new F,Lo=new F,Do=new F,Tc=new F,Uo=new F,Ou=new F,No=new F,qe=class extends Xe{constructor(t=new Me,e=new cr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Uo.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],d=r[l];h!==0&&(Tc.fromBufferAttribute(d,t),o?Uo.addScaledVector(Tc,h):Uo.addScaledVector(Tc.sub(e),h))}e.add(Uo)}return e}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Po.copy(i.boundingSphere),Po.applyMatrix4(r),In.copy(t.ray).recast(t.near),!(Po.containsPoint(In.origin)===!1&&(In.intersectSphere(Po,Fu)===null||In.origin.distanceToSquared(Fu)>(t.far-t.near)**2))&&(Nu.copy(r).invert(),In.copy(t.ray).applyMatrix4(Nu),!(i.boundingBox!==null&&In.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,In)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,p=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let v=0,b=p.length;v<b;v++){let g=p[v],f=o[g.materialIndex],R=Math.max(g.start,m.start),E=Math.min(a.count,Math.min(g.start+g.count,m.start+m.count));for(let S=R,I=E;S<I;S+=3){let P=a.getX(S),D=a.getX(S+1),k=a.getX(S+2);s=Fo(this,f,t,i,c,h,d,P,D,k),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let v=Math.max(0,m.start),b=Math.min(a.count,m.start+m.count);for(let g=v,f=b;g<f;g+=3){let R=a.getX(g),E=a.getX(g+1),S=a.getX(g+2);s=Fo(this,o,t,i,c,h,d,R,E,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let v=0,b=p.length;v<b;v++){let g=p[v],f=o[g.materialIndex],R=Math.max(g.start,m.start),E=Math.min(l.count,Math.min(g.start+g.count,m.start+m.count));for(let S=R,I=E;S<I;S+=3){let P=S,D=S+1,k=S+2;s=Fo(this,f,t,i,c,h,d,P,D,k),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let v=Math.max(0,m.start),b=Math.min(l.count,m.start+m.count);for(let g=v,f=b;g<f;g+=3){let R=g,E=g+1,S=g+2;s=Fo(this,o,t,i,c,h,d,R,E,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function Zm(n,t,e,i,s,r,o,a){let l;if(t.side===Qe?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Qi,a),l===null)return null;No.copy(a),No.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(No);return c<e.near||c>e.far?null:{distance:c,point:No.clone(),object:n}}function Fo(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Io),n.getVertexPosition(l,Lo),n.getVertexPosition(c,Do);let h=Zm(n,t,e,i,Io,Lo,Do,Ou);if(h){let d=new F;dn.getBarycoord(Ou,Io,Lo,Do,d),s&&(h.uv=dn.getInterpolatedAttribute(s,a,l,c,d,new zt)),r&&(h.uv1=dn.getInterpolatedAttribute(r,a,l,c,d,new zt)),o&&(h.normal=dn.getInterpolatedAttribute(o,a,l,c,d,new F),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let p={a,b:l,c,normal:new F,materialIndex:0};dn.getNormal(Io,Lo,Do,p.normal),h.face=p,h.barycoord=d}return h}var xs=class n extends Me{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],d=[],p=0,m=0;v("z","y","x",-1,-1,i,e,t,o,r,0),v("z","y","x",1,-1,i,e,-t,o,r,1),v("x","z","y",1,1,t,i,e,s,o,2),v("x","z","y",1,-1,t,i,-e,s,o,3),v("x","y","z",1,-1,t,e,i,s,r,4),v("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new je(c,3)),this.setAttribute("normal",new je(h,3)),this.setAttribute("uv",new je(d,2));function v(b,g,f,R,E,S,I,P,D,k,x){let w=S/D,C=I/k,B=S/2,V=I/2,X=P/2,K=D+1,Y=k+1,st=0,G=0,lt=new F;for(let dt=0;dt<Y;dt++){let Rt=dt*C-V;for(let $t=0;$t<K;$t++){let le=$t*w-B;lt[b]=le*R,lt[g]=Rt*E,lt[f]=X,c.push(lt.x,lt.y,lt.z),lt[b]=0,lt[g]=0,lt[f]=P>0?1:-1,h.push(lt.x,lt.y,lt.z),d.push($t/D),d.push(1-dt/k),st+=1}}for(let dt=0;dt<k;dt++)for(let Rt=0;Rt<D;Rt++){let $t=p+Rt+K*dt,le=p+Rt+K*(dt+1),fe=p+(Rt+1)+K*(dt+1),te=p+(Rt+1)+K*dt;l.push($t,le,te),l.push(le,fe,te),G+=6}a.addGroup(m,G,x),m+=G,p+=st}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};function Gn(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone():Array.isArray(s)?t[e][i]=s.slice():t[e][i]=s}}return t}function Ye(n){let t={};for(let e=0;e<n.length;e++){let i=Gn(n[e]);for(let s in i)t[s]=i[s]}return t}function Km(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function eh(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Jt.workingColorSpace}var kd={clone:Gn,merge:Ye},jm=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Jm=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ti=class extends Oi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=jm,this.fragmentShader=Jm,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Gn(t.uniforms),this.uniformsGroups=Km(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}},dr=class extends Xe{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ae,this.projectionMatrix=new ae,this.projectionMatrixInverse=new ae,this.coordinateSystem=Mi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},un=new F,ku=new zt,Bu=new zt,We=class extends dr{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=_s*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(er*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return _s*2*Math.atan(Math.tan(er*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){un.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(un.x,un.y).multiplyScalar(-t/un.z),un.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(un.x,un.y).multiplyScalar(-t/un.z)}getViewSize(t,e){return this.getViewBounds(t,ku,Bu),e.subVectors(Bu,ku)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(er*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}},us=-90,ds=1,Qo=class extends Xe{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new We(us,ds,t,e);s.layers=this.layers,this.add(s);let r=new We(us,ds,t,e);r.layers=this.layers,this.add(r);let o=new We(us,ds,t,e);o.layers=this.layers,this.add(o);let a=new We(us,ds,t,e);a.layers=this.layers,this.add(a);let l=new We(us,ds,t,e);l.layers=this.layers,this.add(l);let c=new We(us,ds,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Mi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===rr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,d=t.getRenderTarget(),p=t.getActiveCubeFace(),m=t.getActiveMipmapLevel(),v=t.xr.enabled;t.xr.enabled=!1;let b=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,t.setRenderTarget(i,0,s),t.render(e,r),t.setRenderTarget(i,1,s),t.render(e,o),t.setRenderTarget(i,2,s),t.render(e,a),t.setRenderTarget(i,3,s),t.render(e,l),t.setRenderTarget(i,4,s),t.render(e,c),i.texture.generateMipmaps=b,t.setRenderTarget(i,5,s),t.render(e,h),t.setRenderTarget(d,p,m),t.xr.enabled=v,i.texture.needsPMREMUpdate=!0}},fr=class extends Je{constructor(t=[],e=Hn,i,s,r,o,a,l,c,h){super(t,e,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},ta=class extends Ui{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new fr(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new xs(5,5,5),r=new Ti({name:"CubemapFromEquirect",uniforms:Gn(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Qe,blending:en});r.uniforms.tEquirect.value=e;let o=new qe(s,r),a=e.minFilter;return e.minFilter===xn&&(e.minFilter=Si),new Qo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Un=class extends Xe{constructor(){super(),this.isGroup=!0,this.type="Group"}},Qm={type:"move"},bs=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Un,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Un,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new F,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new F),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Un,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new F,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new F),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let b of t.hand.values()){let g=e.getJointPose(b,i),f=this._getHandJoint(c,b);g!==null&&(f.matrix.fromArray(g.transform.matrix),f.matrix.decompose(f.position,f.rotation,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=g.radius),f.visible=g!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],p=h.position.distanceTo(d.position),m=.02,v=.005;c.inputState.pinching&&p>m+v?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&p<=m-v&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Qm)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Un;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}};var pr=class extends Xe{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ei,this.environmentIntensity=1,this.environmentRotation=new Ei,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};var ea=class extends Je{constructor(t=null,e=1,i=1,s,r,o,a,l,c=ii,h=ii,d,p){super(null,o,a,l,c,h,s,r,d,p),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var mr=class extends be{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},fs=new ae,zu=new ae,Oo=[],Hu=new Ni,tg=new ae,Js=new qe,Qs=new Fi,gr=class extends qe{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new mr(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,tg)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Ni),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,fs),Hu.copy(t.boundingBox).applyMatrix4(fs),this.boundingBox.union(Hu)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Fi),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,fs),Qs.copy(t.boundingSphere).applyMatrix4(fs),this.boundingSphere.union(Qs)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),t.morphTexture!==null&&(this.morphTexture=t.morphTexture.clone()),t.instanceColor!==null&&(this.instanceColor=t.instanceColor.clone()),this.count=t.count,t.boundingBox!==null&&(this.boundingBox=t.boundingBox.clone()),t.boundingSphere!==null&&(this.boundingSphere=t.boundingSphere.clone()),this}getColorAt(t,e){e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(Js.geometry=this.geometry,Js.material=this.material,Js.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Qs.copy(this.boundingSphere),Qs.applyMatrix4(i),t.ray.intersectsSphere(Qs)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,fs),zu.multiplyMatrices(i,fs),Js.matrixWorld=zu,Js.raycast(t,Oo);for(let o=0,a=Oo.length;o<a;o++){let l=Oo[o];l.instanceId=r,l.object=this,e.push(l)}Oo.length=0}}setColorAt(t,e){this.instanceColor===null&&(this.instanceColor=new mr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3)}setMatrixAt(t,e){e.toArray(this.instanceMatrix.array,t*16)}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new ea(new Float32Array(s*this.count),s,this.count,La,Ri));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;r[l]=a,r.set(i,l+1)}updateMorphTargets(){}dispose(){this.dispatchEvent({type:"dispose"}),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Ac=new F,eg=new F,ig=new Ht,Ke=class{constructor(t=new F(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Ac.subVectors(i,e).cross(eg.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){let i=t.delta(Ac),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(i,r)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||ig.getNormalMatrix(t),s=this.coplanarPoint(Ac).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}},Ln=new Fi,ng=new zt(.5,.5),ko=new F,_r=class{constructor(t=new Ke,e=new Ke,i=new Ke,s=new Ke,r=new Ke,o=new Ke){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Mi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],d=r[5],p=r[6],m=r[7],v=r[8],b=r[9],g=r[10],f=r[11],R=r[12],E=r[13],S=r[14],I=r[15];if(s[0].setComponents(c-o,m-h,f-v,I-R).normalize(),s[1].setComponents(c+o,m+h,f+v,I+R).normalize(),s[2].setComponents(c+a,m+d,f+b,I+E).normalize(),s[3].setComponents(c-a,m-d,f-b,I-E).normalize(),i)s[4].setComponents(l,p,g,S).normalize(),s[5].setComponents(c-l,m-p,f-g,I-S).normalize();else if(s[4].setComponents(c-l,m-p,f-g,I-S).normalize(),e===Mi)s[5].setComponents(c+l,m+p,f+g,I+S).normalize();else if(e===rr)s[5].setComponents(l,p,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ln.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ln.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ln)}intersectsSprite(t){Ln.center.set(0,0,0);let e=ng.distanceTo(t.center);return Ln.radius=.7071067811865476+e,Ln.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ln)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(ko.x=s.normal.x>0?t.max.x:t.min.x,ko.y=s.normal.y>0?t.max.y:t.min.y,ko.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ko)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var Ai=class extends Oi{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ot(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},ia=new F,na=new F,Vu=new ae,tr=new mn,Bo=new Fi,Rc=new F,Gu=new F,kn=class extends Xe{constructor(t=new Me,e=new Ai){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)ia.fromBufferAttribute(e,s-1),na.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=ia.distanceTo(na);t.setAttribute("lineDistance",new je(i,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Bo.copy(i.boundingSphere),Bo.applyMatrix4(s),Bo.radius+=r,t.ray.intersectsSphere(Bo)===!1)return;Vu.copy(s).invert(),tr.copy(t.ray).applyMatrix4(Vu);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,p=i.attributes.position;if(h!==null){let m=Math.max(0,o.start),v=Math.min(h.count,o.start+o.count);for(let b=m,g=v-1;b<g;b+=c){let f=h.getX(b),R=h.getX(b+1),E=zo(this,t,tr,l,f,R,b);E&&e.push(E)}if(this.isLineLoop){let b=h.getX(v-1),g=h.getX(m),f=zo(this,t,tr,l,b,g,v-1);f&&e.push(f)}}else{let m=Math.max(0,o.start),v=Math.min(p.count,o.start+o.count);for(let b=m,g=v-1;b<g;b+=c){let f=zo(this,t,tr,l,b,b+1,b);f&&e.push(f)}if(this.isLineLoop){let b=zo(this,t,tr,l,v-1,m,v-1);b&&e.push(b)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function zo(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(ia.fromBufferAttribute(a,s),na.fromBufferAttribute(a,r),e.distanceSqToSegment(ia,na,Rc,Gu)>i)return;Rc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Rc);if(!(c<t.near||c>t.far))return{distance:c,point:Gu.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Wu=new F,Xu=new F,tn=class extends kn{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Wu.fromBufferAttribute(e,s),Xu.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Wu.distanceTo(Xu);t.setAttribute("lineDistance",new je(i,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Bn=class extends Oi{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Ot(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},qu=new ae,Uc=new mn,Ho=new Fi,Vo=new F,ki=class extends Xe{constructor(t=new Me,e=new Bn){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ho.copy(i.boundingSphere),Ho.applyMatrix4(s),Ho.radius+=r,t.ray.intersectsSphere(Ho)===!1)return;qu.copy(s).invert(),Uc.copy(t.ray).applyMatrix4(qu);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,d=i.attributes.position;if(c!==null){let p=Math.max(0,o.start),m=Math.min(c.count,o.start+o.count);for(let v=p,b=m;v<b;v++){let g=c.getX(v);Vo.fromBufferAttribute(d,g),Yu(Vo,g,l,s,t,e,this)}}else{let p=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let v=p,b=m;v<b;v++)Vo.fromBufferAttribute(d,v),Yu(Vo,v,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Yu(n,t,e,i,s,r,o){let a=Uc.distanceSqToPoint(n);if(a<e){let l=new F;Uc.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var vr=class extends Je{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}},yr=class extends Je{constructor(t,e,i=bn,s,r,o,a=ii,l=ii,c,h=gs,d=1){if(h!==gs&&h!==Ts)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let p={width:t,height:e,depth:d};super(p,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ys(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}},xr=class extends Je{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}};var br=class n extends Me{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,d=t/a,p=e/l,m=[],v=[],b=[],g=[];for(let f=0;f<h;f++){let R=f*p-o;for(let E=0;E<c;E++){let S=E*d-r;v.push(S,-R,0),b.push(0,0,1),g.push(E/a),g.push(1-f/l)}}for(let f=0;f<l;f++)for(let R=0;R<a;R++){let E=R+c*f,S=R+c*(f+1),I=R+1+c*(f+1),P=R+1+c*f;m.push(E,S,P),m.push(S,I,P)}this.setIndex(m),this.setAttribute("position",new je(v,3)),this.setAttribute("normal",new je(b,3)),this.setAttribute("uv",new je(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var wr=class n extends Me{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],d=new F,p=new F,m=[],v=[],b=[],g=[];for(let f=0;f<=i;f++){let R=[],E=f/i,S=0;f===0&&o===0?S=.5/e:f===i&&l===Math.PI&&(S=-.5/e);for(let I=0;I<=e;I++){let P=I/e;d.x=-t*Math.cos(s+P*r)*Math.sin(o+E*a),d.y=t*Math.cos(o+E*a),d.z=t*Math.sin(s+P*r)*Math.sin(o+E*a),v.push(d.x,d.y,d.z),p.copy(d).normalize(),b.push(p.x,p.y,p.z),g.push(P+S,1-E),R.push(c++)}h.push(R)}for(let f=0;f<i;f++)for(let R=0;R<e;R++){let E=h[f][R+1],S=h[f][R],I=h[f+1][R],P=h[f+1][R+1];(f!==0||o>0)&&m.push(E,S,P),(f!==i-1||l<Math.PI)&&m.push(S,I,P)}this.setIndex(m),this.setAttribute("position",new je(v,3)),this.setAttribute("normal",new je(b,3)),this.setAttribute("uv",new je(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Mr=class extends Oi{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ot(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ot(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Zc,this.normalScale=new zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ei,this.combine=Ea,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},sa=class extends Oi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Ed,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},ra=class extends Oi{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Go(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function sg(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}var zn=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];i:{t:{let o;e:{n:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break n;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break i}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},oa=class extends zn{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Cc,endingEnd:Cc}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Pc:r=t,a=2*e-i;break;case Ic:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Pc:o=t,l=2*i-e;break;case Ic:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,p=this._weightPrev,m=this._weightNext,v=(i-e)/(s-e),b=v*v,g=b*v,f=-p*g+2*p*b-p*v,R=(1+p)*g+(-1.5-2*p)*b+(-.5+p)*v+1,E=(-1-m)*g+(1.5+m)*b+.5*v,S=m*g-m*b;for(let I=0;I!==a;++I)r[I]=f*o[h+I]+R*o[c+I]+E*o[l+I]+S*o[d+I];return r}},aa=class extends zn{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(i-e)/(s-e),d=1-h;for(let p=0;p!==a;++p)r[p]=o[c+p]*d+o[l+p]*h;return r}},la=class extends zn{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},hi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Go(e,this.TimeBufferType),this.values=Go(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Go(t.times,Array),values:Go(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s)}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new la(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new aa(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new oa(this.times,this.values,this.getValueSize(),t)}setInterpolation(t){let e;switch(t){case nr:e=this.InterpolantFactoryMethodDiscrete;break;case Zo:e=this.InterpolantFactoryMethodLinear;break;case Wo:e=this.InterpolantFactoryMethodSmooth;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return console.warn("THREE.KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return nr;case this.InterpolantFactoryMethodLinear:return Zo;case this.InterpolantFactoryMethodSmooth:return Wo}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&sg(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Wo,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let d=a*i,p=d-i,m=d+i;for(let v=0;v!==i;++v){let b=e[d+v];if(b!==e[p+v]||b!==e[m+v]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*i,p=o*i;for(let m=0;m!==i;++m)e[p+m]=e[d+m]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,s}};hi.prototype.ValueTypeName="";hi.prototype.TimeBufferType=Float32Array;hi.prototype.ValueBufferType=Float32Array;hi.prototype.DefaultInterpolation=Zo;var gn=class extends hi{constructor(t,e,i){super(t,e,i)}};gn.prototype.ValueTypeName="bool";gn.prototype.ValueBufferType=Array;gn.prototype.DefaultInterpolation=nr;gn.prototype.InterpolantFactoryMethodLinear=void 0;gn.prototype.InterpolantFactoryMethodSmooth=void 0;var ca=class extends hi{constructor(t,e,i,s){super(t,e,i,s)}};ca.prototype.ValueTypeName="color";var ha=class extends hi{constructor(t,e,i,s){super(t,e,i,s)}};ha.prototype.ValueTypeName="number";var ua=class extends zn{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)mi.slerpFlat(r,0,o,c-a,o,c,l);return r}},Sr=class extends hi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new ua(this.times,this.values,this.getValueSize(),t)}};Sr.prototype.ValueTypeName="quaternion";Sr.prototype.InterpolantFactoryMethodSmooth=void 0;var _n=class extends hi{constructor(t,e,i){super(t,e,i)}};_n.prototype.ValueTypeName="string";_n.prototype.ValueBufferType=Array;_n.prototype.DefaultInterpolation=nr;_n.prototype.InterpolantFactoryMethodLinear=void 0;_n.prototype.InterpolantFactoryMethodSmooth=void 0;var da=class extends hi{constructor(t,e,i,s){super(t,e,i,s)}};da.prototype.ValueTypeName="vector";var fa=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this.abortController=new AbortController,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,p=c.length;d<p;d+=2){let m=c[d],v=c[d+1];if(m.global&&(m.lastIndex=0),m.test(h))return v}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},Bd=new fa,pa=class{constructor(t){this.manager=t!==void 0?t:Bd,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}abort(){return this}};pa.DEFAULT_MATERIAL_NAME="__DEFAULT";var ma=class extends Xe{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Ot(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}},Er=class extends ma{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Xe.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ot(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}};var ga=class extends dr{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var _a=class extends We{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t}};var ih="\\[\\]\\.:\\/",rg=new RegExp("["+ih+"]","g"),nh="[^"+ih+"]",og="[^"+ih.replace("\\.","")+"]",ag=/((?:WC+[\/:])*)/.source.replace("WC",nh),lg=/(WCOD+)?/.source.replace("WCOD",og),cg=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",nh),hg=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",nh),ug=new RegExp("^"+ag+lg+cg+hg+"$"),dg=["material","materials","bones","map"],Nc=class{constructor(t,e,i){let s=i||de.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},de=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(rg,"")}static parseTrackName(t){let e=ug.exec(t);if(e===null)throw new Error("PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);dg.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};de.Composite=Nc;de.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};de.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};de.prototype.GetterByBindingType=[de.prototype._getValue_direct,de.prototype._getValue_array,de.prototype._getValue_arrayElement,de.prototype._getValue_toArray];de.prototype.SetterByBindingTypeAndVersioning=[[de.prototype._setValue_direct,de.prototype._setValue_direct_setNeedsUpdate,de.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[de.prototype._setValue_array,de.prototype._setValue_array_setNeedsUpdate,de.prototype._setValue_array_setMatrixWorldNeedsUpdate],[de.prototype._setValue_arrayElement,de.prototype._setValue_arrayElement_setNeedsUpdate,de.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[de.prototype._setValue_fromArray,de.prototype._setValue_fromArray_setNeedsUpdate,de.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var pS=new Float32Array(1);var ws=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Yt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Yt(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Tr=class extends Di{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){if(t===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function sh(n,t,e,i){let s=fg(i);switch(e){case qc:return n*t;case La:return n*t/s.components*s.byteLength;case Da:return n*t/s.components*s.byteLength;case $c:return n*t*2/s.components*s.byteLength;case Ua:return n*t*2/s.components*s.byteLength;case Yc:return n*t*3/s.components*s.byteLength;case gi:return n*t*4/s.components*s.byteLength;case Na:return n*t*4/s.components*s.byteLength;case Cr:case Pr:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ir:case Lr:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Oa:case Ba:return Math.max(n,16)*Math.max(t,8)/4;case Fa:case ka:return Math.max(n,8)*Math.max(t,8)/2;case za:case Ha:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Va:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ga:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Wa:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Xa:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case qa:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Ya:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case $a:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Za:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Ka:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case ja:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Ja:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Qa:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case tl:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case el:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case il:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case nl:case sl:case rl:return Math.ceil(n/4)*Math.ceil(t/4)*16;case ol:case al:return Math.ceil(n/4)*Math.ceil(t/4)*8;case ll:case cl:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function fg(n){switch(n){case Hi:case Vc:return{byteLength:1,components:1};case Ms:case Gc:case Ss:return{byteLength:2,components:1};case Pa:case Ia:return{byteLength:2,components:4};case bn:case Ca:case Ri:return{byteLength:4,components:1};case Wc:case Xc:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");function hf(){let n=null,t=!1,e=null,i=null;function s(r,o){e(r,o),i=n.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function mg(n){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,d=c.byteLength,p=n.createBuffer();n.bindBuffer(l,p),n.bufferData(l,c,h),a.onUploadCallback();let m;if(c instanceof Float32Array)m=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)m=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=n.HALF_FLOAT:m=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=n.SHORT;else if(c instanceof Uint32Array)m=n.UNSIGNED_INT;else if(c instanceof Int32Array)m=n.INT;else if(c instanceof Int8Array)m=n.BYTE;else if(c instanceof Uint8Array)m=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:p,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let h=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,h);else{d.sort((m,v)=>m.start-v.start);let p=0;for(let m=1;m<d.length;m++){let v=d[p],b=d[m];b.start<=v.start+v.count+1?v.count=Math.max(v.count,b.start+b.count-v.start):(++p,d[p]=b)}d.length=p+1;for(let m=0,v=d.length;m<v;m++){let b=d[m];n.bufferSubData(c,b.start*h.BYTES_PER_ELEMENT,h,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var gg=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,_g=`#ifdef USE_ALPHAHASH
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
#endif`,vg=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,yg=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,xg=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,bg=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,wg=`#ifdef USE_AOMAP
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
#endif`,Mg=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Sg=`#ifdef USE_BATCHING
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
#endif`,Eg=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Tg=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Ag=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Rg=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Cg=`#ifdef USE_IRIDESCENCE
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
#endif`,Pg=`#ifdef USE_BUMPMAP
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
#endif`,Ig=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Lg=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Dg=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Ug=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Ng=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Fg=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Og=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,kg=`#if defined( USE_COLOR_ALPHA )
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
#endif`,Bg=`#define PI 3.141592653589793
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
} // validated`,zg=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,Hg=`vec3 transformedNormal = objectNormal;
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
#endif`,Vg=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Gg=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Wg=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Xg=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,qg="gl_FragColor = linearToOutputTexel( gl_FragColor );",Yg=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,$g=`#ifdef USE_ENVMAP
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
#endif`,Zg=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,Kg=`#ifdef USE_ENVMAP
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
#endif`,jg=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Jg=`#ifdef USE_ENVMAP
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
#endif`,Qg=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,t_=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,e_=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,i_=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,n_=`#ifdef USE_GRADIENTMAP
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
}`,s_=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,r_=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,o_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,a_=`uniform bool receiveShadow;
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
#endif`,l_=`#ifdef USE_ENVMAP
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
#endif`,c_=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,h_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,u_=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,d_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,f_=`PhysicalMaterial material;
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
#endif`,p_=`struct PhysicalMaterial {
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
}`,m_=`
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
#endif`,g_=`#if defined( RE_IndirectDiffuse )
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
#endif`,__=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,v_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,y_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,x_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,b_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,w_=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,M_=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,S_=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,E_=`#if defined( USE_POINTS_UV )
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
#endif`,T_=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,A_=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,R_=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,C_=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,P_=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,I_=`#ifdef USE_MORPHTARGETS
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
#endif`,L_=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,D_=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,U_=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,N_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,F_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,O_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,k_=`#ifdef USE_NORMALMAP
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
#endif`,B_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,z_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,H_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,V_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,G_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,W_=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,X_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,q_=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Y_=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,$_=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Z_=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,K_=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,j_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,J_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Q_=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,tv=`float getShadowMask() {
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
}`,ev=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,iv=`#ifdef USE_SKINNING
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
#endif`,nv=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,sv=`#ifdef USE_SKINNING
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
#endif`,rv=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ov=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,av=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,lv=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,cv=`#ifdef USE_TRANSMISSION
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
#endif`,hv=`#ifdef USE_TRANSMISSION
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
#endif`,uv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,dv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,fv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,pv=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,mv=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,gv=`uniform sampler2D t2D;
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
}`,_v=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vv=`#ifdef ENVMAP_TYPE_CUBE
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
}`,yv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,xv=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bv=`#include <common>
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
}`,wv=`#if DEPTH_PACKING == 3200
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
}`,Mv=`#define DISTANCE
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
}`,Sv=`#define DISTANCE
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
}`,Ev=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Tv=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Av=`uniform float scale;
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
}`,Rv=`uniform vec3 diffuse;
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
}`,Cv=`#include <common>
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
}`,Pv=`uniform vec3 diffuse;
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
}`,Iv=`#define LAMBERT
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
}`,Lv=`#define LAMBERT
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
}`,Dv=`#define MATCAP
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
}`,Uv=`#define MATCAP
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
}`,Nv=`#define NORMAL
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
}`,Fv=`#define NORMAL
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
}`,Ov=`#define PHONG
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
}`,kv=`#define PHONG
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
}`,Bv=`#define STANDARD
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
}`,zv=`#define STANDARD
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
}`,Hv=`#define TOON
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
}`,Vv=`#define TOON
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
}`,Gv=`uniform float size;
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
}`,Wv=`uniform vec3 diffuse;
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
}`,Xv=`#include <common>
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
}`,qv=`uniform vec3 color;
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
}`,Yv=`uniform float rotation;
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
}`,$v=`uniform vec3 diffuse;
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
}`,Wt={alphahash_fragment:gg,alphahash_pars_fragment:_g,alphamap_fragment:vg,alphamap_pars_fragment:yg,alphatest_fragment:xg,alphatest_pars_fragment:bg,aomap_fragment:wg,aomap_pars_fragment:Mg,batching_pars_vertex:Sg,batching_vertex:Eg,begin_vertex:Tg,beginnormal_vertex:Ag,bsdfs:Rg,iridescence_fragment:Cg,bumpmap_pars_fragment:Pg,clipping_planes_fragment:Ig,clipping_planes_pars_fragment:Lg,clipping_planes_pars_vertex:Dg,clipping_planes_vertex:Ug,color_fragment:Ng,color_pars_fragment:Fg,color_pars_vertex:Og,color_vertex:kg,common:Bg,cube_uv_reflection_fragment:zg,defaultnormal_vertex:Hg,displacementmap_pars_vertex:Vg,displacementmap_vertex:Gg,emissivemap_fragment:Wg,emissivemap_pars_fragment:Xg,colorspace_fragment:qg,colorspace_pars_fragment:Yg,envmap_fragment:$g,envmap_common_pars_fragment:Zg,envmap_pars_fragment:Kg,envmap_pars_vertex:jg,envmap_physical_pars_fragment:l_,envmap_vertex:Jg,fog_vertex:Qg,fog_pars_vertex:t_,fog_fragment:e_,fog_pars_fragment:i_,gradientmap_pars_fragment:n_,lightmap_pars_fragment:s_,lights_lambert_fragment:r_,lights_lambert_pars_fragment:o_,lights_pars_begin:a_,lights_toon_fragment:c_,lights_toon_pars_fragment:h_,lights_phong_fragment:u_,lights_phong_pars_fragment:d_,lights_physical_fragment:f_,lights_physical_pars_fragment:p_,lights_fragment_begin:m_,lights_fragment_maps:g_,lights_fragment_end:__,logdepthbuf_fragment:v_,logdepthbuf_pars_fragment:y_,logdepthbuf_pars_vertex:x_,logdepthbuf_vertex:b_,map_fragment:w_,map_pars_fragment:M_,map_particle_fragment:S_,map_particle_pars_fragment:E_,metalnessmap_fragment:T_,metalnessmap_pars_fragment:A_,morphinstance_vertex:R_,morphcolor_vertex:C_,morphnormal_vertex:P_,morphtarget_pars_vertex:I_,morphtarget_vertex:L_,normal_fragment_begin:D_,normal_fragment_maps:U_,normal_pars_fragment:N_,normal_pars_vertex:F_,normal_vertex:O_,normalmap_pars_fragment:k_,clearcoat_normal_fragment_begin:B_,clearcoat_normal_fragment_maps:z_,clearcoat_pars_fragment:H_,iridescence_pars_fragment:V_,opaque_fragment:G_,packing:W_,premultiplied_alpha_fragment:X_,project_vertex:q_,dithering_fragment:Y_,dithering_pars_fragment:$_,roughnessmap_fragment:Z_,roughnessmap_pars_fragment:K_,shadowmap_pars_fragment:j_,shadowmap_pars_vertex:J_,shadowmap_vertex:Q_,shadowmask_pars_fragment:tv,skinbase_vertex:ev,skinning_pars_vertex:iv,skinning_vertex:nv,skinnormal_vertex:sv,specularmap_fragment:rv,specularmap_pars_fragment:ov,tonemapping_fragment:av,tonemapping_pars_fragment:lv,transmission_fragment:cv,transmission_pars_fragment:hv,uv_pars_fragment:uv,uv_pars_vertex:dv,uv_vertex:fv,worldpos_vertex:pv,background_vert:mv,background_frag:gv,backgroundCube_vert:_v,backgroundCube_frag:vv,cube_vert:yv,cube_frag:xv,depth_vert:bv,depth_frag:wv,distanceRGBA_vert:Mv,distanceRGBA_frag:Sv,equirect_vert:Ev,equirect_frag:Tv,linedashed_vert:Av,linedashed_frag:Rv,meshbasic_vert:Cv,meshbasic_frag:Pv,meshlambert_vert:Iv,meshlambert_frag:Lv,meshmatcap_vert:Dv,meshmatcap_frag:Uv,meshnormal_vert:Nv,meshnormal_frag:Fv,meshphong_vert:Ov,meshphong_frag:kv,meshphysical_vert:Bv,meshphysical_frag:zv,meshtoon_vert:Hv,meshtoon_frag:Vv,points_vert:Gv,points_frag:Wv,shadow_vert:Xv,shadow_frag:qv,sprite_vert:Yv,sprite_frag:$v},at={common:{diffuse:{value:new Ot(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ht},alphaMap:{value:null},alphaMapTransform:{value:new Ht},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ht}},envmap:{envMap:{value:null},envMapRotation:{value:new Ht},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ht}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ht}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ht},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ht},normalScale:{value:new zt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ht},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ht}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ht}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ht}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ot(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new Ot(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ht},alphaTest:{value:0},uvTransform:{value:new Ht}},sprite:{diffuse:{value:new Ot(16777215)},opacity:{value:1},center:{value:new zt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ht},alphaMap:{value:null},alphaMapTransform:{value:new Ht},alphaTest:{value:0}}},Vi={basic:{uniforms:Ye([at.common,at.specularmap,at.envmap,at.aomap,at.lightmap,at.fog]),vertexShader:Wt.meshbasic_vert,fragmentShader:Wt.meshbasic_frag},lambert:{uniforms:Ye([at.common,at.specularmap,at.envmap,at.aomap,at.lightmap,at.emissivemap,at.bumpmap,at.normalmap,at.displacementmap,at.fog,at.lights,{emissive:{value:new Ot(0)}}]),vertexShader:Wt.meshlambert_vert,fragmentShader:Wt.meshlambert_frag},phong:{uniforms:Ye([at.common,at.specularmap,at.envmap,at.aomap,at.lightmap,at.emissivemap,at.bumpmap,at.normalmap,at.displacementmap,at.fog,at.lights,{emissive:{value:new Ot(0)},specular:{value:new Ot(1118481)},shininess:{value:30}}]),vertexShader:Wt.meshphong_vert,fragmentShader:Wt.meshphong_frag},standard:{uniforms:Ye([at.common,at.envmap,at.aomap,at.lightmap,at.emissivemap,at.bumpmap,at.normalmap,at.displacementmap,at.roughnessmap,at.metalnessmap,at.fog,at.lights,{emissive:{value:new Ot(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Wt.meshphysical_vert,fragmentShader:Wt.meshphysical_frag},toon:{uniforms:Ye([at.common,at.aomap,at.lightmap,at.emissivemap,at.bumpmap,at.normalmap,at.displacementmap,at.gradientmap,at.fog,at.lights,{emissive:{value:new Ot(0)}}]),vertexShader:Wt.meshtoon_vert,fragmentShader:Wt.meshtoon_frag},matcap:{uniforms:Ye([at.common,at.bumpmap,at.normalmap,at.displacementmap,at.fog,{matcap:{value:null}}]),vertexShader:Wt.meshmatcap_vert,fragmentShader:Wt.meshmatcap_frag},points:{uniforms:Ye([at.points,at.fog]),vertexShader:Wt.points_vert,fragmentShader:Wt.points_frag},dashed:{uniforms:Ye([at.common,at.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Wt.linedashed_vert,fragmentShader:Wt.linedashed_frag},depth:{uniforms:Ye([at.common,at.displacementmap]),vertexShader:Wt.depth_vert,fragmentShader:Wt.depth_frag},normal:{uniforms:Ye([at.common,at.bumpmap,at.normalmap,at.displacementmap,{opacity:{value:1}}]),vertexShader:Wt.meshnormal_vert,fragmentShader:Wt.meshnormal_frag},sprite:{uniforms:Ye([at.sprite,at.fog]),vertexShader:Wt.sprite_vert,fragmentShader:Wt.sprite_frag},background:{uniforms:{uvTransform:{value:new Ht},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Wt.background_vert,fragmentShader:Wt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ht}},vertexShader:Wt.backgroundCube_vert,fragmentShader:Wt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Wt.cube_vert,fragmentShader:Wt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Wt.equirect_vert,fragmentShader:Wt.equirect_frag},distanceRGBA:{uniforms:Ye([at.common,at.displacementmap,{referencePosition:{value:new F},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Wt.distanceRGBA_vert,fragmentShader:Wt.distanceRGBA_frag},shadow:{uniforms:Ye([at.lights,at.fog,{color:{value:new Ot(0)},opacity:{value:1}}]),vertexShader:Wt.shadow_vert,fragmentShader:Wt.shadow_frag}};Vi.physical={uniforms:Ye([Vi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ht},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ht},clearcoatNormalScale:{value:new zt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ht},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ht},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ht},sheen:{value:0},sheenColor:{value:new Ot(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ht},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ht},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ht},transmissionSamplerSize:{value:new zt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ht},attenuationDistance:{value:0},attenuationColor:{value:new Ot(0)},specularColor:{value:new Ot(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ht},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ht},anisotropyVector:{value:new zt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ht}}]),vertexShader:Wt.meshphysical_vert,fragmentShader:Wt.meshphysical_frag};var hl={r:0,b:0,g:0},Wn=new Ei,Zv=new ae;function Kv(n,t,e,i,s,r,o){let a=new Ot(0),l=r===!0?0:1,c,h,d=null,p=0,m=null;function v(E){let S=E.isScene===!0?E.background:null;return S&&S.isTexture&&(S=(E.backgroundBlurriness>0?e:t).get(S)),S}function b(E){let S=!1,I=v(E);I===null?f(a,l):I&&I.isColor&&(f(I,1),S=!0);let P=n.xr.getEnvironmentBlendMode();P==="additive"?i.buffers.color.setClear(0,0,0,1,o):P==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(n.autoClear||S)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function g(E,S){let I=v(S);I&&(I.isCubeTexture||I.mapping===Ar)?(h===void 0&&(h=new qe(new xs(1,1,1),new Ti({name:"BackgroundCubeMaterial",uniforms:Gn(Vi.backgroundCube.uniforms),vertexShader:Vi.backgroundCube.vertexShader,fragmentShader:Vi.backgroundCube.fragmentShader,side:Qe,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(P,D,k){this.matrixWorld.copyPosition(k.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),Wn.copy(S.backgroundRotation),Wn.x*=-1,Wn.y*=-1,Wn.z*=-1,I.isCubeTexture&&I.isRenderTargetTexture===!1&&(Wn.y*=-1,Wn.z*=-1),h.material.uniforms.envMap.value=I,h.material.uniforms.flipEnvMap.value=I.isCubeTexture&&I.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(Zv.makeRotationFromEuler(Wn)),h.material.toneMapped=Jt.getTransfer(I.colorSpace)!==ne,(d!==I||p!==I.version||m!==n.toneMapping)&&(h.material.needsUpdate=!0,d=I,p=I.version,m=n.toneMapping),h.layers.enableAll(),E.unshift(h,h.geometry,h.material,0,0,null)):I&&I.isTexture&&(c===void 0&&(c=new qe(new br(2,2),new Ti({name:"BackgroundMaterial",uniforms:Gn(Vi.background.uniforms),vertexShader:Vi.background.vertexShader,fragmentShader:Vi.background.fragmentShader,side:Qi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=I,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.toneMapped=Jt.getTransfer(I.colorSpace)!==ne,I.matrixAutoUpdate===!0&&I.updateMatrix(),c.material.uniforms.uvTransform.value.copy(I.matrix),(d!==I||p!==I.version||m!==n.toneMapping)&&(c.material.needsUpdate=!0,d=I,p=I.version,m=n.toneMapping),c.layers.enableAll(),E.unshift(c,c.geometry,c.material,0,0,null))}function f(E,S){E.getRGB(hl,eh(n)),i.buffers.color.setClear(hl.r,hl.g,hl.b,S,o)}function R(){h!==void 0&&(h.geometry.dispose(),h.material.dispose(),h=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(E,S=1){a.set(E),l=S,f(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(E){l=E,f(a,l)},render:b,addToRenderList:g,dispose:R}}function jv(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=p(null),r=s,o=!1;function a(w,C,B,V,X){let K=!1,Y=d(V,B,C);r!==Y&&(r=Y,c(r.object)),K=m(w,V,B,X),K&&v(w,V,B,X),X!==null&&t.update(X,n.ELEMENT_ARRAY_BUFFER),(K||o)&&(o=!1,S(w,C,B,V),X!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(X).buffer))}function l(){return n.createVertexArray()}function c(w){return n.bindVertexArray(w)}function h(w){return n.deleteVertexArray(w)}function d(w,C,B){let V=B.wireframe===!0,X=i[w.id];X===void 0&&(X={},i[w.id]=X);let K=X[C.id];K===void 0&&(K={},X[C.id]=K);let Y=K[V];return Y===void 0&&(Y=p(l()),K[V]=Y),Y}function p(w){let C=[],B=[],V=[];for(let X=0;X<e;X++)C[X]=0,B[X]=0,V[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:B,attributeDivisors:V,object:w,attributes:{},index:null}}function m(w,C,B,V){let X=r.attributes,K=C.attributes,Y=0,st=B.getAttributes();for(let G in st)if(st[G].location>=0){let dt=X[G],Rt=K[G];if(Rt===void 0&&(G==="instanceMatrix"&&w.instanceMatrix&&(Rt=w.instanceMatrix),G==="instanceColor"&&w.instanceColor&&(Rt=w.instanceColor)),dt===void 0||dt.attribute!==Rt||Rt&&dt.data!==Rt.data)return!0;Y++}return r.attributesNum!==Y||r.index!==V}function v(w,C,B,V){let X={},K=C.attributes,Y=0,st=B.getAttributes();for(let G in st)if(st[G].location>=0){let dt=K[G];dt===void 0&&(G==="instanceMatrix"&&w.instanceMatrix&&(dt=w.instanceMatrix),G==="instanceColor"&&w.instanceColor&&(dt=w.instanceColor));let Rt={};Rt.attribute=dt,dt&&dt.data&&(Rt.data=dt.data),X[G]=Rt,Y++}r.attributes=X,r.attributesNum=Y,r.index=V}function b(){let w=r.newAttributes;for(let C=0,B=w.length;C<B;C++)w[C]=0}function g(w){f(w,0)}function f(w,C){let B=r.newAttributes,V=r.enabledAttributes,X=r.attributeDivisors;B[w]=1,V[w]===0&&(n.enableVertexAttribArray(w),V[w]=1),X[w]!==C&&(n.vertexAttribDivisor(w,C),X[w]=C)}function R(){let w=r.newAttributes,C=r.enabledAttributes;for(let B=0,V=C.length;B<V;B++)C[B]!==w[B]&&(n.disableVertexAttribArray(B),C[B]=0)}function E(w,C,B,V,X,K,Y){Y===!0?n.vertexAttribIPointer(w,C,B,X,K):n.vertexAttribPointer(w,C,B,V,X,K)}function S(w,C,B,V){b();let X=V.attributes,K=B.getAttributes(),Y=C.defaultAttributeValues;for(let st in K){let G=K[st];if(G.location>=0){let lt=X[st];if(lt===void 0&&(st==="instanceMatrix"&&w.instanceMatrix&&(lt=w.instanceMatrix),st==="instanceColor"&&w.instanceColor&&(lt=w.instanceColor)),lt!==void 0){let dt=lt.normalized,Rt=lt.itemSize,$t=t.get(lt);if($t===void 0)continue;let le=$t.buffer,fe=$t.type,te=$t.bytesPerElement,$=fe===n.INT||fe===n.UNSIGNED_INT||lt.gpuType===Ca;if(lt.isInterleavedBufferAttribute){let J=lt.data,gt=J.stride,Ft=lt.offset;if(J.isInstancedInterleavedBuffer){for(let At=0;At<G.locationSize;At++)f(G.location+At,J.meshPerAttribute);w.isInstancedMesh!==!0&&V._maxInstanceCount===void 0&&(V._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let At=0;At<G.locationSize;At++)g(G.location+At);n.bindBuffer(n.ARRAY_BUFFER,le);for(let At=0;At<G.locationSize;At++)E(G.location+At,Rt/G.locationSize,fe,dt,gt*te,(Ft+Rt/G.locationSize*At)*te,$)}else{if(lt.isInstancedBufferAttribute){for(let J=0;J<G.locationSize;J++)f(G.location+J,lt.meshPerAttribute);w.isInstancedMesh!==!0&&V._maxInstanceCount===void 0&&(V._maxInstanceCount=lt.meshPerAttribute*lt.count)}else for(let J=0;J<G.locationSize;J++)g(G.location+J);n.bindBuffer(n.ARRAY_BUFFER,le);for(let J=0;J<G.locationSize;J++)E(G.location+J,Rt/G.locationSize,fe,dt,Rt*te,Rt/G.locationSize*J*te,$)}}else if(Y!==void 0){let dt=Y[st];if(dt!==void 0)switch(dt.length){case 2:n.vertexAttrib2fv(G.location,dt);break;case 3:n.vertexAttrib3fv(G.location,dt);break;case 4:n.vertexAttrib4fv(G.location,dt);break;default:n.vertexAttrib1fv(G.location,dt)}}}}R()}function I(){k();for(let w in i){let C=i[w];for(let B in C){let V=C[B];for(let X in V)h(V[X].object),delete V[X];delete C[B]}delete i[w]}}function P(w){if(i[w.id]===void 0)return;let C=i[w.id];for(let B in C){let V=C[B];for(let X in V)h(V[X].object),delete V[X];delete C[B]}delete i[w.id]}function D(w){for(let C in i){let B=i[C];if(B[w.id]===void 0)continue;let V=B[w.id];for(let X in V)h(V[X].object),delete V[X];delete B[w.id]}}function k(){x(),o=!0,r!==s&&(r=s,c(r.object))}function x(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:x,dispose:I,releaseStatesOfGeometry:P,releaseStatesOfProgram:D,initAttributes:b,enableAttribute:g,disableUnusedAttributes:R}}function Jv(n,t,e){let i;function s(c){i=c}function r(c,h){n.drawArrays(i,c,h),e.update(h,i,1)}function o(c,h,d){d!==0&&(n.drawArraysInstanced(i,c,h,d),e.update(h,i,d))}function a(c,h,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,h,0,d);let m=0;for(let v=0;v<d;v++)m+=h[v];e.update(m,i,1)}function l(c,h,d,p){if(d===0)return;let m=t.get("WEBGL_multi_draw");if(m===null)for(let v=0;v<c.length;v++)o(c[v],h[v],p[v]);else{m.multiDrawArraysInstancedWEBGL(i,c,0,h,0,p,0,d);let v=0;for(let b=0;b<d;b++)v+=h[b]*p[b];e.update(v,i,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function Qv(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let D=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==gi&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){let k=D===Ss&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==Hi&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Ri&&!k)}function l(D){if(D==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=e.logarithmicDepthBuffer===!0,p=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),m=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),f=n.getParameter(n.MAX_VERTEX_ATTRIBS),R=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),I=v>0,P=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:p,maxTextures:m,maxVertexTextures:v,maxTextureSize:b,maxCubemapSize:g,maxAttributes:f,maxVertexUniforms:R,maxVaryings:E,maxFragmentUniforms:S,vertexTextures:I,maxSamples:P}}function ty(n){let t=this,e=null,i=0,s=!1,r=!1,o=new Ke,a=new Ht,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,p){let m=d.length!==0||p||i!==0||s;return s=p,i=d.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,p){e=h(d,p,0)},this.setState=function(d,p,m){let v=d.clippingPlanes,b=d.clipIntersection,g=d.clipShadows,f=n.get(d);if(!s||v===null||v.length===0||r&&!g)r?h(null):c();else{let R=r?0:i,E=R*4,S=f.clippingState||null;l.value=S,S=h(v,p,E,m);for(let I=0;I!==E;++I)S[I]=e[I];f.clippingState=S,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=R}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(d,p,m,v){let b=d!==null?d.length:0,g=null;if(b!==0){if(g=l.value,v!==!0||g===null){let f=m+b*4,R=p.matrixWorldInverse;a.getNormalMatrix(R),(g===null||g.length<f)&&(g=new Float32Array(f));for(let E=0,S=m;E!==b;++E,S+=4)o.copy(d[E]).applyMatrix4(R,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=b,t.numIntersection=0,g}}function ey(n){let t=new WeakMap;function e(o,a){return a===Ta?o.mapping=Hn:a===Aa&&(o.mapping=Vn),o}function i(o){if(o&&o.isTexture){let a=o.mapping;if(a===Ta||a===Aa)if(t.has(o)){let l=t.get(o).texture;return e(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new ta(l.height);return c.fromEquirectangularTexture(n,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:i,dispose:r}}var Cs=4,zd=[.125,.215,.35,.446,.526,.582],Yn=20,rh=new ga,Hd=new Ot,oh=null,ah=0,lh=0,ch=!1,qn=(1+Math.sqrt(5))/2,Rs=1/qn,Vd=[new F(-qn,Rs,0),new F(qn,Rs,0),new F(-Rs,0,qn),new F(Rs,0,qn),new F(0,qn,-Rs),new F(0,qn,Rs),new F(-1,1,-1),new F(1,1,-1),new F(-1,1,1),new F(1,1,1)],iy=new F,fl=class{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=iy}=r;oh=this._renderer.getRenderTarget(),ah=this._renderer.getActiveCubeFace(),lh=this._renderer.getActiveMipmapLevel(),ch=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(t,i,s,l,a),e>0&&this._blur(l,0,0,e),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Xd(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Wd(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(oh,ah,lh),this._renderer.xr.enabled=ch,t.scissorTest=!1,ul(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===Hn||t.mapping===Vn?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),oh=this._renderer.getRenderTarget(),ah=this._renderer.getActiveCubeFace(),lh=this._renderer.getActiveMipmapLevel(),ch=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let i=e||this._allocateTargets();return this._textureToCubeUV(t,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){let t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,i={magFilter:Si,minFilter:Si,generateMipmaps:!1,type:Ss,format:gi,colorSpace:On,depthBuffer:!1},s=Gd(t,e,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Gd(t,e,i);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=ny(r)),this._blurMaterial=sy(r,t,e)}return s}_compileMaterial(t){let e=new qe(this._lodPlanes[0],t);this._renderer.compile(e,rh)}_sceneToCubeUV(t,e,i,s,r){let l=new We(90,1,e,i),c=[1,-1,1,1,1,1],h=[1,1,1,-1,-1,-1],d=this._renderer,p=d.autoClear,m=d.toneMapping;d.getClearColor(Hd),d.toneMapping=nn,d.autoClear=!1,d.state.buffers.depth.getReversed()&&(d.setRenderTarget(s),d.clearDepth(),d.setRenderTarget(null));let b=new cr({name:"PMREM.Background",side:Qe,depthWrite:!1,depthTest:!1}),g=new qe(new xs,b),f=!1,R=t.background;R?R.isColor&&(b.color.copy(R),t.background=null,f=!0):(b.color.copy(Hd),f=!0);for(let E=0;E<6;E++){let S=E%3;S===0?(l.up.set(0,c[E],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+h[E],r.y,r.z)):S===1?(l.up.set(0,0,c[E]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+h[E],r.z)):(l.up.set(0,c[E],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+h[E]));let I=this._cubeSize;ul(s,S*I,E>2?I:0,I,I),d.setRenderTarget(s),f&&d.render(g,l),d.render(t,l)}g.geometry.dispose(),g.material.dispose(),d.toneMapping=m,d.autoClear=p,t.background=R}_textureToCubeUV(t,e){let i=this._renderer,s=t.mapping===Hn||t.mapping===Vn;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Xd()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Wd());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new qe(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;let l=this._cubeSize;ul(e,0,0,3*l,2*l),i.setRenderTarget(e),i.render(o,rh)}_applyPMREM(t){let e=this._renderer,i=e.autoClear;e.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=Vd[(s-r-1)%Vd.length];this._blur(t,r-1,r,o,a)}e.autoClear=i}_blur(t,e,i,s,r){let o=this._pingPongRenderTarget;this._halfBlur(t,o,e,i,s,"latitudinal",r),this._halfBlur(o,t,i,i,s,"longitudinal",r)}_halfBlur(t,e,i,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let h=3,d=new qe(this._lodPlanes[s],c),p=c.uniforms,m=this._sizeLods[i]-1,v=isFinite(r)?Math.PI/(2*m):2*Math.PI/(2*Yn-1),b=r/v,g=isFinite(r)?1+Math.floor(h*b):Yn;g>Yn&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${g} samples when the maximum is set to ${Yn}`);let f=[],R=0;for(let D=0;D<Yn;++D){let k=D/b,x=Math.exp(-k*k/2);f.push(x),D===0?R+=x:D<g&&(R+=2*x)}for(let D=0;D<f.length;D++)f[D]=f[D]/R;p.envMap.value=t.texture,p.samples.value=g,p.weights.value=f,p.latitudinal.value=o==="latitudinal",a&&(p.poleAxis.value=a);let{_lodMax:E}=this;p.dTheta.value=v,p.mipInt.value=E-i;let S=this._sizeLods[s],I=3*S*(s>E-Cs?s-E+Cs:0),P=4*(this._cubeSize-S);ul(e,I,P,3*S,2*S),l.setRenderTarget(e),l.render(d,rh)}};function ny(n){let t=[],e=[],i=[],s=n,r=n-Cs+1+zd.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>n-Cs?l=zd[o-n+Cs-1]:o===0&&(l=0),i.push(l);let c=1/(a-2),h=-c,d=1+c,p=[h,h,d,h,d,d,h,h,d,d,h,d],m=6,v=6,b=3,g=2,f=1,R=new Float32Array(b*v*m),E=new Float32Array(g*v*m),S=new Float32Array(f*v*m);for(let P=0;P<m;P++){let D=P%3*2/3-1,k=P>2?0:-1,x=[D,k,0,D+2/3,k,0,D+2/3,k+1,0,D,k,0,D+2/3,k+1,0,D,k+1,0];R.set(x,b*v*P),E.set(p,g*v*P);let w=[P,P,P,P,P,P];S.set(w,f*v*P)}let I=new Me;I.setAttribute("position",new be(R,b)),I.setAttribute("uv",new be(E,g)),I.setAttribute("faceIndex",new be(S,f)),t.push(I),s>Cs&&s--}return{lodPlanes:t,sizeLods:e,sigmas:i}}function Gd(n,t,e){let i=new Ui(n,t,e);return i.texture.mapping=Ar,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function ul(n,t,e,i,s){n.viewport.set(t,e,i,s),n.scissor.set(t,e,i,s)}function sy(n,t,e){let i=new Float32Array(Yn),s=new F(0,1,0);return new Ti({name:"SphericalGaussianBlur",defines:{n:Yn,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:yh(),fragmentShader:`

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
		`,blending:en,depthTest:!1,depthWrite:!1})}function Wd(){return new Ti({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:yh(),fragmentShader:`

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
		`,blending:en,depthTest:!1,depthWrite:!1})}function Xd(){return new Ti({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:yh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:en,depthTest:!1,depthWrite:!1})}function yh(){return`

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
	`}function ry(n){let t=new WeakMap,e=null;function i(a){if(a&&a.isTexture){let l=a.mapping,c=l===Ta||l===Aa,h=l===Hn||l===Vn;if(c||h){let d=t.get(a),p=d!==void 0?d.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==p)return e===null&&(e=new fl(n)),d=c?e.fromEquirectangular(a,d):e.fromCubemap(a,d),d.texture.pmremVersion=a.pmremVersion,t.set(a,d),d.texture;if(d!==void 0)return d.texture;{let m=a.image;return c&&m&&m.height>0||h&&m&&s(m)?(e===null&&(e=new fl(n)),d=c?e.fromEquirectangular(a):e.fromCubemap(a),d.texture.pmremVersion=a.pmremVersion,t.set(a,d),a.addEventListener("dispose",r),d.texture):null}}}return a}function s(a){let l=0,c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:i,dispose:o}}function oy(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&vs("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function ay(n,t,e,i){let s={},r=new WeakMap;function o(d){let p=d.target;p.index!==null&&t.remove(p.index);for(let v in p.attributes)t.remove(p.attributes[v]);p.removeEventListener("dispose",o),delete s[p.id];let m=r.get(p);m&&(t.remove(m),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function a(d,p){return s[p.id]===!0||(p.addEventListener("dispose",o),s[p.id]=!0,e.memory.geometries++),p}function l(d){let p=d.attributes;for(let m in p)t.update(p[m],n.ARRAY_BUFFER)}function c(d){let p=[],m=d.index,v=d.attributes.position,b=0;if(m!==null){let R=m.array;b=m.version;for(let E=0,S=R.length;E<S;E+=3){let I=R[E+0],P=R[E+1],D=R[E+2];p.push(I,P,P,D,D,I)}}else if(v!==void 0){let R=v.array;b=v.version;for(let E=0,S=R.length/3-1;E<S;E+=3){let I=E+0,P=E+1,D=E+2;p.push(I,P,P,D,D,I)}}else return;let g=new(th(p)?ur:hr)(p,1);g.version=b;let f=r.get(d);f&&t.remove(f),r.set(d,g)}function h(d){let p=r.get(d);if(p){let m=d.index;m!==null&&p.version<m.version&&c(d)}else c(d);return r.get(d)}return{get:a,update:l,getWireframeAttribute:h}}function ly(n,t,e){let i;function s(p){i=p}let r,o;function a(p){r=p.type,o=p.bytesPerElement}function l(p,m){n.drawElements(i,m,r,p*o),e.update(m,i,1)}function c(p,m,v){v!==0&&(n.drawElementsInstanced(i,m,r,p*o,v),e.update(m,i,v))}function h(p,m,v){if(v===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,m,0,r,p,0,v);let g=0;for(let f=0;f<v;f++)g+=m[f];e.update(g,i,1)}function d(p,m,v,b){if(v===0)return;let g=t.get("WEBGL_multi_draw");if(g===null)for(let f=0;f<p.length;f++)c(p[f]/o,m[f],b[f]);else{g.multiDrawElementsInstancedWEBGL(i,m,0,r,p,0,b,0,v);let f=0;for(let R=0;R<v;R++)f+=m[R]*b[R];e.update(f,i,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=d}function cy(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function hy(n,t,e){let i=new WeakMap,s=new we;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,p=i.get(a);if(p===void 0||p.count!==d){let x=function(){D.dispose(),i.delete(a),a.removeEventListener("dispose",x)};p!==void 0&&p.texture.dispose();let m=a.morphAttributes.position!==void 0,v=a.morphAttributes.normal!==void 0,b=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],f=a.morphAttributes.normal||[],R=a.morphAttributes.color||[],E=0;m===!0&&(E=1),v===!0&&(E=2),b===!0&&(E=3);let S=a.attributes.position.count*E,I=1;S>t.maxTextureSize&&(I=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let P=new Float32Array(S*I*4*d),D=new ar(P,S,I,d);D.type=Ri,D.needsUpdate=!0;let k=E*4;for(let w=0;w<d;w++){let C=g[w],B=f[w],V=R[w],X=S*I*4*w;for(let K=0;K<C.count;K++){let Y=K*k;m===!0&&(s.fromBufferAttribute(C,K),P[X+Y+0]=s.x,P[X+Y+1]=s.y,P[X+Y+2]=s.z,P[X+Y+3]=0),v===!0&&(s.fromBufferAttribute(B,K),P[X+Y+4]=s.x,P[X+Y+5]=s.y,P[X+Y+6]=s.z,P[X+Y+7]=0),b===!0&&(s.fromBufferAttribute(V,K),P[X+Y+8]=s.x,P[X+Y+9]=s.y,P[X+Y+10]=s.z,P[X+Y+11]=V.itemSize===4?s.w:1)}}p={count:d,texture:D,size:new zt(S,I)},i.set(a,p),a.addEventListener("dispose",x)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let m=0;for(let b=0;b<c.length;b++)m+=c[b];let v=a.morphTargetsRelative?1:1-m;l.getUniforms().setValue(n,"morphTargetBaseInfluence",v),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",p.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",p.size)}return{update:r}}function uy(n,t,e,i){let s=new WeakMap;function r(l){let c=i.render.frame,h=l.geometry,d=t.get(l,h);if(s.get(d)!==c&&(t.update(d),s.set(d,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let p=l.skeleton;s.get(p)!==c&&(p.update(),s.set(p,c))}return d}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}var uf=new Je,qd=new yr(1,1),df=new ar,ff=new Jo,pf=new fr,Yd=[],$d=[],Zd=new Float32Array(16),Kd=new Float32Array(9),jd=new Float32Array(4);function Is(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Yd[s];if(r===void 0&&(r=new Float32Array(s),Yd[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Ce(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Pe(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function ml(n,t){let e=$d[t];e===void 0&&(e=new Int32Array(t),$d[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function dy(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function fy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ce(e,t))return;n.uniform2fv(this.addr,t),Pe(e,t)}}function py(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Ce(e,t))return;n.uniform3fv(this.addr,t),Pe(e,t)}}function my(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ce(e,t))return;n.uniform4fv(this.addr,t),Pe(e,t)}}function gy(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ce(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Pe(e,t)}else{if(Ce(e,i))return;jd.set(i),n.uniformMatrix2fv(this.addr,!1,jd),Pe(e,i)}}function _y(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ce(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Pe(e,t)}else{if(Ce(e,i))return;Kd.set(i),n.uniformMatrix3fv(this.addr,!1,Kd),Pe(e,i)}}function vy(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ce(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Pe(e,t)}else{if(Ce(e,i))return;Zd.set(i),n.uniformMatrix4fv(this.addr,!1,Zd),Pe(e,i)}}function yy(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function xy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ce(e,t))return;n.uniform2iv(this.addr,t),Pe(e,t)}}function by(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ce(e,t))return;n.uniform3iv(this.addr,t),Pe(e,t)}}function wy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ce(e,t))return;n.uniform4iv(this.addr,t),Pe(e,t)}}function My(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function Sy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ce(e,t))return;n.uniform2uiv(this.addr,t),Pe(e,t)}}function Ey(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ce(e,t))return;n.uniform3uiv(this.addr,t),Pe(e,t)}}function Ty(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ce(e,t))return;n.uniform4uiv(this.addr,t),Pe(e,t)}}function Ay(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(qd.compareFunction=Kc,r=qd):r=uf,e.setTexture2D(t||r,s)}function Ry(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||ff,s)}function Cy(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTextureCube(t||pf,s)}function Py(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||df,s)}function Iy(n){switch(n){case 5126:return dy;case 35664:return fy;case 35665:return py;case 35666:return my;case 35674:return gy;case 35675:return _y;case 35676:return vy;case 5124:case 35670:return yy;case 35667:case 35671:return xy;case 35668:case 35672:return by;case 35669:case 35673:return wy;case 5125:return My;case 36294:return Sy;case 36295:return Ey;case 36296:return Ty;case 35678:case 36198:case 36298:case 36306:case 35682:return Ay;case 35679:case 36299:case 36307:return Ry;case 35680:case 36300:case 36308:case 36293:return Cy;case 36289:case 36303:case 36311:case 36292:return Py}}function Ly(n,t){n.uniform1fv(this.addr,t)}function Dy(n,t){let e=Is(t,this.size,2);n.uniform2fv(this.addr,e)}function Uy(n,t){let e=Is(t,this.size,3);n.uniform3fv(this.addr,e)}function Ny(n,t){let e=Is(t,this.size,4);n.uniform4fv(this.addr,e)}function Fy(n,t){let e=Is(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function Oy(n,t){let e=Is(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function ky(n,t){let e=Is(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function By(n,t){n.uniform1iv(this.addr,t)}function zy(n,t){n.uniform2iv(this.addr,t)}function Hy(n,t){n.uniform3iv(this.addr,t)}function Vy(n,t){n.uniform4iv(this.addr,t)}function Gy(n,t){n.uniform1uiv(this.addr,t)}function Wy(n,t){n.uniform2uiv(this.addr,t)}function Xy(n,t){n.uniform3uiv(this.addr,t)}function qy(n,t){n.uniform4uiv(this.addr,t)}function Yy(n,t,e){let i=this.cache,s=t.length,r=ml(e,s);Ce(i,r)||(n.uniform1iv(this.addr,r),Pe(i,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||uf,r[o])}function $y(n,t,e){let i=this.cache,s=t.length,r=ml(e,s);Ce(i,r)||(n.uniform1iv(this.addr,r),Pe(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||ff,r[o])}function Zy(n,t,e){let i=this.cache,s=t.length,r=ml(e,s);Ce(i,r)||(n.uniform1iv(this.addr,r),Pe(i,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||pf,r[o])}function Ky(n,t,e){let i=this.cache,s=t.length,r=ml(e,s);Ce(i,r)||(n.uniform1iv(this.addr,r),Pe(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||df,r[o])}function jy(n){switch(n){case 5126:return Ly;case 35664:return Dy;case 35665:return Uy;case 35666:return Ny;case 35674:return Fy;case 35675:return Oy;case 35676:return ky;case 5124:case 35670:return By;case 35667:case 35671:return zy;case 35668:case 35672:return Hy;case 35669:case 35673:return Vy;case 5125:return Gy;case 36294:return Wy;case 36295:return Xy;case 36296:return qy;case 35678:case 36198:case 36298:case 36306:case 35682:return Yy;case 35679:case 36299:case 36307:return $y;case 35680:case 36300:case 36308:case 36293:return Zy;case 36289:case 36303:case 36311:case 36292:return Ky}}var uh=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=Iy(e.type)}},dh=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=jy(e.type)}},fh=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},hh=/(\w+)(\])?(\[|\.)?/g;function Jd(n,t){n.seq.push(t),n.map[t.id]=t}function Jy(n,t,e){let i=n.name,s=i.length;for(hh.lastIndex=0;;){let r=hh.exec(i),o=hh.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Jd(e,c===void 0?new uh(a,n,t):new dh(a,n,t));break}else{let d=e.map[a];d===void 0&&(d=new fh(a),Jd(e,d)),e=d}}}var Ps=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){let r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);Jy(r,o,this)}}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Qd(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var Qy=37297,t0=0;function e0(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var tf=new Ht;function i0(n){Jt._getMatrix(tf,Jt.workingColorSpace,n);let t=`mat3( ${tf.elements.map(e=>e.toFixed(4))} )`;switch(Jt.getTransfer(n)){case sr:return[t,"LinearTransferOETF"];case ne:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function ef(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+e0(n.getShaderSource(t),a)}else return r}function n0(n,t){let e=i0(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function s0(n,t){let e;switch(t){case _d:e="Linear";break;case vd:e="Reinhard";break;case yd:e="Cineon";break;case xd:e="ACESFilmic";break;case wd:e="AgX";break;case Md:e="Neutral";break;case bd:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var dl=new F;function r0(){Jt.getLuminanceCoefficients(dl);let n=dl.x.toFixed(4),t=dl.y.toFixed(4),e=dl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function o0(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Dr).join(`
`)}function a0(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function l0(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Dr(n){return n!==""}function nf(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function sf(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var c0=/^[ \t]*#include +<([\w\d./]+)>/gm;function ph(n){return n.replace(c0,u0)}var h0=new Map;function u0(n,t){let e=Wt[t];if(e===void 0){let i=h0.get(t);if(i!==void 0)e=Wt[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,i);else throw new Error("Can not resolve #include <"+t+">")}return ph(e)}var d0=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function rf(n){return n.replace(d0,f0)}function f0(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function of(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}function p0(n){let t="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===Oc?t="SHADOWMAP_TYPE_PCF":n.shadowMapType===Ku?t="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===Bi&&(t="SHADOWMAP_TYPE_VSM"),t}function m0(n){let t="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case Hn:case Vn:t="ENVMAP_TYPE_CUBE";break;case Ar:t="ENVMAP_TYPE_CUBE_UV";break}return t}function g0(n){let t="ENVMAP_MODE_REFLECTION";if(n.envMap)switch(n.envMapMode){case Vn:t="ENVMAP_MODE_REFRACTION";break}return t}function _0(n){let t="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case Ea:t="ENVMAP_BLENDING_MULTIPLY";break;case md:t="ENVMAP_BLENDING_MIX";break;case gd:t="ENVMAP_BLENDING_ADD";break}return t}function v0(n){let t=n.envMapCubeUVHeight;if(t===null)return null;let e=Math.log2(t)-2,i=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:i,maxMip:e}}function y0(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=p0(e),c=m0(e),h=g0(e),d=_0(e),p=v0(e),m=o0(e),v=a0(r),b=s.createProgram(),g,f,R=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,v].filter(Dr).join(`
`),g.length>0&&(g+=`
`),f=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,v].filter(Dr).join(`
`),f.length>0&&(f+=`
`)):(g=[of(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,v,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Dr).join(`
`),f=[of(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,v,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",p?"#define CUBEUV_TEXEL_WIDTH "+p.texelWidth:"",p?"#define CUBEUV_TEXEL_HEIGHT "+p.texelHeight:"",p?"#define CUBEUV_MAX_MIP "+p.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==nn?"#define TONE_MAPPING":"",e.toneMapping!==nn?Wt.tonemapping_pars_fragment:"",e.toneMapping!==nn?s0("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Wt.colorspace_pars_fragment,n0("linearToOutputTexel",e.outputColorSpace),r0(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Dr).join(`
`)),o=ph(o),o=nf(o,e),o=sf(o,e),a=ph(a),a=nf(a,e),a=sf(a,e),o=rf(o),a=rf(a),e.isRawShaderMaterial!==!0&&(R=`#version 300 es
`,g=[m,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+g,f=["#define varying in",e.glslVersion===jc?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===jc?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);let E=R+g+o,S=R+f+a,I=Qd(s,s.VERTEX_SHADER,E),P=Qd(s,s.FRAGMENT_SHADER,S);s.attachShader(b,I),s.attachShader(b,P),e.index0AttributeName!==void 0?s.bindAttribLocation(b,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(b,0,"position"),s.linkProgram(b);function D(C){if(n.debug.checkShaderErrors){let B=s.getProgramInfoLog(b)||"",V=s.getShaderInfoLog(I)||"",X=s.getShaderInfoLog(P)||"",K=B.trim(),Y=V.trim(),st=X.trim(),G=!0,lt=!0;if(s.getProgramParameter(b,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,b,I,P);else{let dt=ef(s,I,"vertex"),Rt=ef(s,P,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(b,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+K+`
`+dt+`
`+Rt)}else K!==""?console.warn("THREE.WebGLProgram: Program Info Log:",K):(Y===""||st==="")&&(lt=!1);lt&&(C.diagnostics={runnable:G,programLog:K,vertexShader:{log:Y,prefix:g},fragmentShader:{log:st,prefix:f}})}s.deleteShader(I),s.deleteShader(P),k=new Ps(s,b),x=l0(s,b)}let k;this.getUniforms=function(){return k===void 0&&D(this),k};let x;this.getAttributes=function(){return x===void 0&&D(this),x};let w=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return w===!1&&(w=s.getProgramParameter(b,Qy)),w},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(b),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=t0++,this.cacheKey=t,this.usedTimes=1,this.program=b,this.vertexShader=I,this.fragmentShader=P,this}var x0=0,mh=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){let e=t.vertexShader,i=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(i),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new gh(t),e.set(t,i)),i}},gh=class{constructor(t){this.id=x0++,this.code=t,this.usedTimes=0}};function b0(n,t,e,i,s,r,o){let a=new lr,l=new mh,c=new Set,h=[],d=s.logarithmicDepthBuffer,p=s.vertexTextures,m=s.precision,v={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function b(x){return c.add(x),x===0?"uv":`uv${x}`}function g(x,w,C,B,V){let X=B.fog,K=V.geometry,Y=x.isMeshStandardMaterial?B.environment:null,st=(x.isMeshStandardMaterial?e:t).get(x.envMap||Y),G=st&&st.mapping===Ar?st.image.height:null,lt=v[x.type];x.precision!==null&&(m=s.getMaxPrecision(x.precision),m!==x.precision&&console.warn("THREE.WebGLProgram.getParameters:",x.precision,"not supported, using",m,"instead."));let dt=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,Rt=dt!==void 0?dt.length:0,$t=0;K.morphAttributes.position!==void 0&&($t=1),K.morphAttributes.normal!==void 0&&($t=2),K.morphAttributes.color!==void 0&&($t=3);let le,fe,te,$;if(lt){let ee=Vi[lt];le=ee.vertexShader,fe=ee.fragmentShader}else le=x.vertexShader,fe=x.fragmentShader,l.update(x),te=l.getVertexShaderID(x),$=l.getFragmentShaderID(x);let J=n.getRenderTarget(),gt=n.state.buffers.depth.getReversed(),Ft=V.isInstancedMesh===!0,At=V.isBatchedMesh===!0,jt=!!x.map,Oe=!!x.matcap,A=!!st,pe=!!x.aoMap,Bt=!!x.lightMap,Ut=!!x.bumpMap,xt=!!x.normalMap,me=!!x.displacementMap,bt=!!x.emissiveMap,Gt=!!x.metalnessMap,Le=!!x.roughnessMap,Se=x.anisotropy>0,T=x.clearcoat>0,y=x.dispersion>0,O=x.iridescence>0,q=x.sheen>0,j=x.transmission>0,W=Se&&!!x.anisotropyMap,Tt=T&&!!x.clearcoatMap,rt=T&&!!x.clearcoatNormalMap,wt=T&&!!x.clearcoatRoughnessMap,St=O&&!!x.iridescenceMap,et=O&&!!x.iridescenceThicknessMap,ut=q&&!!x.sheenColorMap,Dt=q&&!!x.sheenRoughnessMap,Et=!!x.specularMap,ct=!!x.specularColorMap,Vt=!!x.specularIntensityMap,L=j&&!!x.transmissionMap,it=j&&!!x.thicknessMap,ot=!!x.gradientMap,mt=!!x.alphaMap,Q=x.alphaTest>0,Z=!!x.alphaHash,vt=!!x.extensions,kt=nn;x.toneMapped&&(J===null||J.isXRRenderTarget===!0)&&(kt=n.toneMapping);let ce={shaderID:lt,shaderType:x.type,shaderName:x.name,vertexShader:le,fragmentShader:fe,defines:x.defines,customVertexShaderID:te,customFragmentShaderID:$,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:m,batching:At,batchingColor:At&&V._colorsTexture!==null,instancing:Ft,instancingColor:Ft&&V.instanceColor!==null,instancingMorph:Ft&&V.morphTexture!==null,supportsVertexTextures:p,outputColorSpace:J===null?n.outputColorSpace:J.isXRRenderTarget===!0?J.texture.colorSpace:On,alphaToCoverage:!!x.alphaToCoverage,map:jt,matcap:Oe,envMap:A,envMapMode:A&&st.mapping,envMapCubeUVHeight:G,aoMap:pe,lightMap:Bt,bumpMap:Ut,normalMap:xt,displacementMap:p&&me,emissiveMap:bt,normalMapObjectSpace:xt&&x.normalMapType===Ad,normalMapTangentSpace:xt&&x.normalMapType===Zc,metalnessMap:Gt,roughnessMap:Le,anisotropy:Se,anisotropyMap:W,clearcoat:T,clearcoatMap:Tt,clearcoatNormalMap:rt,clearcoatRoughnessMap:wt,dispersion:y,iridescence:O,iridescenceMap:St,iridescenceThicknessMap:et,sheen:q,sheenColorMap:ut,sheenRoughnessMap:Dt,specularMap:Et,specularColorMap:ct,specularIntensityMap:Vt,transmission:j,transmissionMap:L,thicknessMap:it,gradientMap:ot,opaque:x.transparent===!1&&x.blending===Nn&&x.alphaToCoverage===!1,alphaMap:mt,alphaTest:Q,alphaHash:Z,combine:x.combine,mapUv:jt&&b(x.map.channel),aoMapUv:pe&&b(x.aoMap.channel),lightMapUv:Bt&&b(x.lightMap.channel),bumpMapUv:Ut&&b(x.bumpMap.channel),normalMapUv:xt&&b(x.normalMap.channel),displacementMapUv:me&&b(x.displacementMap.channel),emissiveMapUv:bt&&b(x.emissiveMap.channel),metalnessMapUv:Gt&&b(x.metalnessMap.channel),roughnessMapUv:Le&&b(x.roughnessMap.channel),anisotropyMapUv:W&&b(x.anisotropyMap.channel),clearcoatMapUv:Tt&&b(x.clearcoatMap.channel),clearcoatNormalMapUv:rt&&b(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:wt&&b(x.clearcoatRoughnessMap.channel),iridescenceMapUv:St&&b(x.iridescenceMap.channel),iridescenceThicknessMapUv:et&&b(x.iridescenceThicknessMap.channel),sheenColorMapUv:ut&&b(x.sheenColorMap.channel),sheenRoughnessMapUv:Dt&&b(x.sheenRoughnessMap.channel),specularMapUv:Et&&b(x.specularMap.channel),specularColorMapUv:ct&&b(x.specularColorMap.channel),specularIntensityMapUv:Vt&&b(x.specularIntensityMap.channel),transmissionMapUv:L&&b(x.transmissionMap.channel),thicknessMapUv:it&&b(x.thicknessMap.channel),alphaMapUv:mt&&b(x.alphaMap.channel),vertexTangents:!!K.attributes.tangent&&(xt||Se),vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,pointsUvs:V.isPoints===!0&&!!K.attributes.uv&&(jt||mt),fog:!!X,useFog:x.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:x.flatShading===!0&&x.wireframe===!1,sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:gt,skinning:V.isSkinnedMesh===!0,morphTargets:K.morphAttributes.position!==void 0,morphNormals:K.morphAttributes.normal!==void 0,morphColors:K.morphAttributes.color!==void 0,morphTargetsCount:Rt,morphTextureStride:$t,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:kt,decodeVideoTexture:jt&&x.map.isVideoTexture===!0&&Jt.getTransfer(x.map.colorSpace)===ne,decodeVideoTextureEmissive:bt&&x.emissiveMap.isVideoTexture===!0&&Jt.getTransfer(x.emissiveMap.colorSpace)===ne,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===zi,flipSided:x.side===Qe,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:vt&&x.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(vt&&x.extensions.multiDraw===!0||At)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return ce.vertexUv1s=c.has(1),ce.vertexUv2s=c.has(2),ce.vertexUv3s=c.has(3),c.clear(),ce}function f(x){let w=[];if(x.shaderID?w.push(x.shaderID):(w.push(x.customVertexShaderID),w.push(x.customFragmentShaderID)),x.defines!==void 0)for(let C in x.defines)w.push(C),w.push(x.defines[C]);return x.isRawShaderMaterial===!1&&(R(w,x),E(w,x),w.push(n.outputColorSpace)),w.push(x.customProgramCacheKey),w.join()}function R(x,w){x.push(w.precision),x.push(w.outputColorSpace),x.push(w.envMapMode),x.push(w.envMapCubeUVHeight),x.push(w.mapUv),x.push(w.alphaMapUv),x.push(w.lightMapUv),x.push(w.aoMapUv),x.push(w.bumpMapUv),x.push(w.normalMapUv),x.push(w.displacementMapUv),x.push(w.emissiveMapUv),x.push(w.metalnessMapUv),x.push(w.roughnessMapUv),x.push(w.anisotropyMapUv),x.push(w.clearcoatMapUv),x.push(w.clearcoatNormalMapUv),x.push(w.clearcoatRoughnessMapUv),x.push(w.iridescenceMapUv),x.push(w.iridescenceThicknessMapUv),x.push(w.sheenColorMapUv),x.push(w.sheenRoughnessMapUv),x.push(w.specularMapUv),x.push(w.specularColorMapUv),x.push(w.specularIntensityMapUv),x.push(w.transmissionMapUv),x.push(w.thicknessMapUv),x.push(w.combine),x.push(w.fogExp2),x.push(w.sizeAttenuation),x.push(w.morphTargetsCount),x.push(w.morphAttributeCount),x.push(w.numDirLights),x.push(w.numPointLights),x.push(w.numSpotLights),x.push(w.numSpotLightMaps),x.push(w.numHemiLights),x.push(w.numRectAreaLights),x.push(w.numDirLightShadows),x.push(w.numPointLightShadows),x.push(w.numSpotLightShadows),x.push(w.numSpotLightShadowsWithMaps),x.push(w.numLightProbes),x.push(w.shadowMapType),x.push(w.toneMapping),x.push(w.numClippingPlanes),x.push(w.numClipIntersection),x.push(w.depthPacking)}function E(x,w){a.disableAll(),w.supportsVertexTextures&&a.enable(0),w.instancing&&a.enable(1),w.instancingColor&&a.enable(2),w.instancingMorph&&a.enable(3),w.matcap&&a.enable(4),w.envMap&&a.enable(5),w.normalMapObjectSpace&&a.enable(6),w.normalMapTangentSpace&&a.enable(7),w.clearcoat&&a.enable(8),w.iridescence&&a.enable(9),w.alphaTest&&a.enable(10),w.vertexColors&&a.enable(11),w.vertexAlphas&&a.enable(12),w.vertexUv1s&&a.enable(13),w.vertexUv2s&&a.enable(14),w.vertexUv3s&&a.enable(15),w.vertexTangents&&a.enable(16),w.anisotropy&&a.enable(17),w.alphaHash&&a.enable(18),w.batching&&a.enable(19),w.dispersion&&a.enable(20),w.batchingColor&&a.enable(21),w.gradientMap&&a.enable(22),x.push(a.mask),a.disableAll(),w.fog&&a.enable(0),w.useFog&&a.enable(1),w.flatShading&&a.enable(2),w.logarithmicDepthBuffer&&a.enable(3),w.reversedDepthBuffer&&a.enable(4),w.skinning&&a.enable(5),w.morphTargets&&a.enable(6),w.morphNormals&&a.enable(7),w.morphColors&&a.enable(8),w.premultipliedAlpha&&a.enable(9),w.shadowMapEnabled&&a.enable(10),w.doubleSided&&a.enable(11),w.flipSided&&a.enable(12),w.useDepthPacking&&a.enable(13),w.dithering&&a.enable(14),w.transmission&&a.enable(15),w.sheen&&a.enable(16),w.opaque&&a.enable(17),w.pointsUvs&&a.enable(18),w.decodeVideoTexture&&a.enable(19),w.decodeVideoTextureEmissive&&a.enable(20),w.alphaToCoverage&&a.enable(21),x.push(a.mask)}function S(x){let w=v[x.type],C;if(w){let B=Vi[w];C=kd.clone(B.uniforms)}else C=x.uniforms;return C}function I(x,w){let C;for(let B=0,V=h.length;B<V;B++){let X=h[B];if(X.cacheKey===w){C=X,++C.usedTimes;break}}return C===void 0&&(C=new y0(n,w,x,r),h.push(C)),C}function P(x){if(--x.usedTimes===0){let w=h.indexOf(x);h[w]=h[h.length-1],h.pop(),x.destroy()}}function D(x){l.remove(x)}function k(){l.dispose()}return{getParameters:g,getProgramCacheKey:f,getUniforms:S,acquireProgram:I,releaseProgram:P,releaseShaderCache:D,programs:h,dispose:k}}function w0(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function M0(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.z!==t.z?n.z-t.z:n.id-t.id}function af(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function lf(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d,p,m,v,b,g){let f=n[t];return f===void 0?(f={id:d.id,object:d,geometry:p,material:m,groupOrder:v,renderOrder:d.renderOrder,z:b,group:g},n[t]=f):(f.id=d.id,f.object=d,f.geometry=p,f.material=m,f.groupOrder=v,f.renderOrder=d.renderOrder,f.z=b,f.group=g),t++,f}function a(d,p,m,v,b,g){let f=o(d,p,m,v,b,g);m.transmission>0?i.push(f):m.transparent===!0?s.push(f):e.push(f)}function l(d,p,m,v,b,g){let f=o(d,p,m,v,b,g);m.transmission>0?i.unshift(f):m.transparent===!0?s.unshift(f):e.unshift(f)}function c(d,p){e.length>1&&e.sort(d||M0),i.length>1&&i.sort(p||af),s.length>1&&s.sort(p||af)}function h(){for(let d=t,p=n.length;d<p;d++){let m=n[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:a,unshift:l,finish:h,sort:c}}function S0(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new lf,n.set(i,[o])):s>=r.length?(o=new lf,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function E0(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new F,color:new Ot};break;case"SpotLight":e={position:new F,direction:new F,color:new Ot,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new F,color:new Ot,distance:0,decay:0};break;case"HemisphereLight":e={direction:new F,skyColor:new Ot,groundColor:new Ot};break;case"RectAreaLight":e={color:new Ot,position:new F,halfWidth:new F,halfHeight:new F};break}return n[t.id]=e,e}}}function T0(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new zt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new zt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new zt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var A0=0;function R0(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function C0(n){let t=new E0,e=T0(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new F);let s=new F,r=new ae,o=new ae;function a(c){let h=0,d=0,p=0;for(let x=0;x<9;x++)i.probe[x].set(0,0,0);let m=0,v=0,b=0,g=0,f=0,R=0,E=0,S=0,I=0,P=0,D=0;c.sort(R0);for(let x=0,w=c.length;x<w;x++){let C=c[x],B=C.color,V=C.intensity,X=C.distance,K=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)h+=B.r*V,d+=B.g*V,p+=B.b*V;else if(C.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(C.sh.coefficients[Y],V);D++}else if(C.isDirectionalLight){let Y=t.get(C);if(Y.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let st=C.shadow,G=e.get(C);G.shadowIntensity=st.intensity,G.shadowBias=st.bias,G.shadowNormalBias=st.normalBias,G.shadowRadius=st.radius,G.shadowMapSize=st.mapSize,i.directionalShadow[m]=G,i.directionalShadowMap[m]=K,i.directionalShadowMatrix[m]=C.shadow.matrix,R++}i.directional[m]=Y,m++}else if(C.isSpotLight){let Y=t.get(C);Y.position.setFromMatrixPosition(C.matrixWorld),Y.color.copy(B).multiplyScalar(V),Y.distance=X,Y.coneCos=Math.cos(C.angle),Y.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),Y.decay=C.decay,i.spot[b]=Y;let st=C.shadow;if(C.map&&(i.spotLightMap[I]=C.map,I++,st.updateMatrices(C),C.castShadow&&P++),i.spotLightMatrix[b]=st.matrix,C.castShadow){let G=e.get(C);G.shadowIntensity=st.intensity,G.shadowBias=st.bias,G.shadowNormalBias=st.normalBias,G.shadowRadius=st.radius,G.shadowMapSize=st.mapSize,i.spotShadow[b]=G,i.spotShadowMap[b]=K,S++}b++}else if(C.isRectAreaLight){let Y=t.get(C);Y.color.copy(B).multiplyScalar(V),Y.halfWidth.set(C.width*.5,0,0),Y.halfHeight.set(0,C.height*.5,0),i.rectArea[g]=Y,g++}else if(C.isPointLight){let Y=t.get(C);if(Y.color.copy(C.color).multiplyScalar(C.intensity),Y.distance=C.distance,Y.decay=C.decay,C.castShadow){let st=C.shadow,G=e.get(C);G.shadowIntensity=st.intensity,G.shadowBias=st.bias,G.shadowNormalBias=st.normalBias,G.shadowRadius=st.radius,G.shadowMapSize=st.mapSize,G.shadowCameraNear=st.camera.near,G.shadowCameraFar=st.camera.far,i.pointShadow[v]=G,i.pointShadowMap[v]=K,i.pointShadowMatrix[v]=C.shadow.matrix,E++}i.point[v]=Y,v++}else if(C.isHemisphereLight){let Y=t.get(C);Y.skyColor.copy(C.color).multiplyScalar(V),Y.groundColor.copy(C.groundColor).multiplyScalar(V),i.hemi[f]=Y,f++}}g>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=at.LTC_FLOAT_1,i.rectAreaLTC2=at.LTC_FLOAT_2):(i.rectAreaLTC1=at.LTC_HALF_1,i.rectAreaLTC2=at.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=d,i.ambient[2]=p;let k=i.hash;(k.directionalLength!==m||k.pointLength!==v||k.spotLength!==b||k.rectAreaLength!==g||k.hemiLength!==f||k.numDirectionalShadows!==R||k.numPointShadows!==E||k.numSpotShadows!==S||k.numSpotMaps!==I||k.numLightProbes!==D)&&(i.directional.length=m,i.spot.length=b,i.rectArea.length=g,i.point.length=v,i.hemi.length=f,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.pointShadow.length=E,i.pointShadowMap.length=E,i.spotShadow.length=S,i.spotShadowMap.length=S,i.directionalShadowMatrix.length=R,i.pointShadowMatrix.length=E,i.spotLightMatrix.length=S+I-P,i.spotLightMap.length=I,i.numSpotLightShadowsWithMaps=P,i.numLightProbes=D,k.directionalLength=m,k.pointLength=v,k.spotLength=b,k.rectAreaLength=g,k.hemiLength=f,k.numDirectionalShadows=R,k.numPointShadows=E,k.numSpotShadows=S,k.numSpotMaps=I,k.numLightProbes=D,i.version=A0++)}function l(c,h){let d=0,p=0,m=0,v=0,b=0,g=h.matrixWorldInverse;for(let f=0,R=c.length;f<R;f++){let E=c[f];if(E.isDirectionalLight){let S=i.directional[d];S.direction.setFromMatrixPosition(E.matrixWorld),s.setFromMatrixPosition(E.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(g),d++}else if(E.isSpotLight){let S=i.spot[m];S.position.setFromMatrixPosition(E.matrixWorld),S.position.applyMatrix4(g),S.direction.setFromMatrixPosition(E.matrixWorld),s.setFromMatrixPosition(E.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(g),m++}else if(E.isRectAreaLight){let S=i.rectArea[v];S.position.setFromMatrixPosition(E.matrixWorld),S.position.applyMatrix4(g),o.identity(),r.copy(E.matrixWorld),r.premultiply(g),o.extractRotation(r),S.halfWidth.set(E.width*.5,0,0),S.halfHeight.set(0,E.height*.5,0),S.halfWidth.applyMatrix4(o),S.halfHeight.applyMatrix4(o),v++}else if(E.isPointLight){let S=i.point[p];S.position.setFromMatrixPosition(E.matrixWorld),S.position.applyMatrix4(g),p++}else if(E.isHemisphereLight){let S=i.hemi[b];S.direction.setFromMatrixPosition(E.matrixWorld),S.direction.transformDirection(g),b++}}}return{setup:a,setupView:l,state:i}}function cf(n){let t=new C0(n),e=[],i=[];function s(h){c.camera=h,e.length=0,i.length=0}function r(h){e.push(h)}function o(h){i.push(h)}function a(){t.setup(e)}function l(h){t.setupView(e,h)}let c={lightsArray:e,shadowsArray:i,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function P0(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new cf(n),t.set(s,[a])):r>=o.length?(a=new cf(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var I0=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,L0=`uniform sampler2D shadow_pass;
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
}`;function D0(n,t,e){let i=new _r,s=new zt,r=new zt,o=new we,a=new sa({depthPacking:Td}),l=new ra,c={},h=e.maxTextureSize,d={[Qi]:Qe,[Qe]:Qi,[zi]:zi},p=new Ti({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new zt},radius:{value:4}},vertexShader:I0,fragmentShader:L0}),m=p.clone();m.defines.HORIZONTAL_PASS=1;let v=new Me;v.setAttribute("position",new be(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new qe(v,p),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Oc;let f=this.type;this.render=function(P,D,k){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||P.length===0)return;let x=n.getRenderTarget(),w=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),B=n.state;B.setBlending(en),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let V=f!==Bi&&this.type===Bi,X=f===Bi&&this.type!==Bi;for(let K=0,Y=P.length;K<Y;K++){let st=P[K],G=st.shadow;if(G===void 0){console.warn("THREE.WebGLShadowMap:",st,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let lt=G.getFrameExtents();if(s.multiply(lt),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/lt.x),s.x=r.x*lt.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/lt.y),s.y=r.y*lt.y,G.mapSize.y=r.y)),G.map===null||V===!0||X===!0){let Rt=this.type!==Bi?{minFilter:ii,magFilter:ii}:{};G.map!==null&&G.map.dispose(),G.map=new Ui(s.x,s.y,Rt),G.map.texture.name=st.name+".shadowMap",G.camera.updateProjectionMatrix()}n.setRenderTarget(G.map),n.clear();let dt=G.getViewportCount();for(let Rt=0;Rt<dt;Rt++){let $t=G.getViewport(Rt);o.set(r.x*$t.x,r.y*$t.y,r.x*$t.z,r.y*$t.w),B.viewport(o),G.updateMatrices(st,Rt),i=G.getFrustum(),S(D,k,G.camera,st,this.type)}G.isPointLightShadow!==!0&&this.type===Bi&&R(G,k),G.needsUpdate=!1}f=this.type,g.needsUpdate=!1,n.setRenderTarget(x,w,C)};function R(P,D){let k=t.update(b);p.defines.VSM_SAMPLES!==P.blurSamples&&(p.defines.VSM_SAMPLES=P.blurSamples,m.defines.VSM_SAMPLES=P.blurSamples,p.needsUpdate=!0,m.needsUpdate=!0),P.mapPass===null&&(P.mapPass=new Ui(s.x,s.y)),p.uniforms.shadow_pass.value=P.map.texture,p.uniforms.resolution.value=P.mapSize,p.uniforms.radius.value=P.radius,n.setRenderTarget(P.mapPass),n.clear(),n.renderBufferDirect(D,null,k,p,b,null),m.uniforms.shadow_pass.value=P.mapPass.texture,m.uniforms.resolution.value=P.mapSize,m.uniforms.radius.value=P.radius,n.setRenderTarget(P.map),n.clear(),n.renderBufferDirect(D,null,k,m,b,null)}function E(P,D,k,x){let w=null,C=k.isPointLight===!0?P.customDistanceMaterial:P.customDepthMaterial;if(C!==void 0)w=C;else if(w=k.isPointLight===!0?l:a,n.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0||D.alphaToCoverage===!0){let B=w.uuid,V=D.uuid,X=c[B];X===void 0&&(X={},c[B]=X);let K=X[V];K===void 0&&(K=w.clone(),X[V]=K,D.addEventListener("dispose",I)),w=K}if(w.visible=D.visible,w.wireframe=D.wireframe,x===Bi?w.side=D.shadowSide!==null?D.shadowSide:D.side:w.side=D.shadowSide!==null?D.shadowSide:d[D.side],w.alphaMap=D.alphaMap,w.alphaTest=D.alphaToCoverage===!0?.5:D.alphaTest,w.map=D.map,w.clipShadows=D.clipShadows,w.clippingPlanes=D.clippingPlanes,w.clipIntersection=D.clipIntersection,w.displacementMap=D.displacementMap,w.displacementScale=D.displacementScale,w.displacementBias=D.displacementBias,w.wireframeLinewidth=D.wireframeLinewidth,w.linewidth=D.linewidth,k.isPointLight===!0&&w.isMeshDistanceMaterial===!0){let B=n.properties.get(w);B.light=k}return w}function S(P,D,k,x,w){if(P.visible===!1)return;if(P.layers.test(D.layers)&&(P.isMesh||P.isLine||P.isPoints)&&(P.castShadow||P.receiveShadow&&w===Bi)&&(!P.frustumCulled||i.intersectsObject(P))){P.modelViewMatrix.multiplyMatrices(k.matrixWorldInverse,P.matrixWorld);let V=t.update(P),X=P.material;if(Array.isArray(X)){let K=V.groups;for(let Y=0,st=K.length;Y<st;Y++){let G=K[Y],lt=X[G.materialIndex];if(lt&&lt.visible){let dt=E(P,lt,x,w);P.onBeforeShadow(n,P,D,k,V,dt,G),n.renderBufferDirect(k,null,V,dt,P,G),P.onAfterShadow(n,P,D,k,V,dt,G)}}}else if(X.visible){let K=E(P,X,x,w);P.onBeforeShadow(n,P,D,k,V,K,null),n.renderBufferDirect(k,null,V,K,P,null),P.onAfterShadow(n,P,D,k,V,K,null)}}let B=P.children;for(let V=0,X=B.length;V<X;V++)S(B[V],D,k,x,w)}function I(P){P.target.removeEventListener("dispose",I);for(let k in c){let x=c[k],w=P.target.uuid;w in x&&(x[w].dispose(),delete x[w])}}}var U0={[va]:ya,[xa]:Ma,[ba]:Sa,[Fn]:wa,[ya]:va,[Ma]:xa,[Sa]:ba,[wa]:Fn};function N0(n,t){function e(){let L=!1,it=new we,ot=null,mt=new we(0,0,0,0);return{setMask:function(Q){ot!==Q&&!L&&(n.colorMask(Q,Q,Q,Q),ot=Q)},setLocked:function(Q){L=Q},setClear:function(Q,Z,vt,kt,ce){ce===!0&&(Q*=kt,Z*=kt,vt*=kt),it.set(Q,Z,vt,kt),mt.equals(it)===!1&&(n.clearColor(Q,Z,vt,kt),mt.copy(it))},reset:function(){L=!1,ot=null,mt.set(-1,0,0,0)}}}function i(){let L=!1,it=!1,ot=null,mt=null,Q=null;return{setReversed:function(Z){if(it!==Z){let vt=t.get("EXT_clip_control");Z?vt.clipControlEXT(vt.LOWER_LEFT_EXT,vt.ZERO_TO_ONE_EXT):vt.clipControlEXT(vt.LOWER_LEFT_EXT,vt.NEGATIVE_ONE_TO_ONE_EXT),it=Z;let kt=Q;Q=null,this.setClear(kt)}},getReversed:function(){return it},setTest:function(Z){Z?J(n.DEPTH_TEST):gt(n.DEPTH_TEST)},setMask:function(Z){ot!==Z&&!L&&(n.depthMask(Z),ot=Z)},setFunc:function(Z){if(it&&(Z=U0[Z]),mt!==Z){switch(Z){case va:n.depthFunc(n.NEVER);break;case ya:n.depthFunc(n.ALWAYS);break;case xa:n.depthFunc(n.LESS);break;case Fn:n.depthFunc(n.LEQUAL);break;case ba:n.depthFunc(n.EQUAL);break;case wa:n.depthFunc(n.GEQUAL);break;case Ma:n.depthFunc(n.GREATER);break;case Sa:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}mt=Z}},setLocked:function(Z){L=Z},setClear:function(Z){Q!==Z&&(it&&(Z=1-Z),n.clearDepth(Z),Q=Z)},reset:function(){L=!1,ot=null,mt=null,Q=null,it=!1}}}function s(){let L=!1,it=null,ot=null,mt=null,Q=null,Z=null,vt=null,kt=null,ce=null;return{setTest:function(ee){L||(ee?J(n.STENCIL_TEST):gt(n.STENCIL_TEST))},setMask:function(ee){it!==ee&&!L&&(n.stencilMask(ee),it=ee)},setFunc:function(ee,Wi,Ci){(ot!==ee||mt!==Wi||Q!==Ci)&&(n.stencilFunc(ee,Wi,Ci),ot=ee,mt=Wi,Q=Ci)},setOp:function(ee,Wi,Ci){(Z!==ee||vt!==Wi||kt!==Ci)&&(n.stencilOp(ee,Wi,Ci),Z=ee,vt=Wi,kt=Ci)},setLocked:function(ee){L=ee},setClear:function(ee){ce!==ee&&(n.clearStencil(ee),ce=ee)},reset:function(){L=!1,it=null,ot=null,mt=null,Q=null,Z=null,vt=null,kt=null,ce=null}}}let r=new e,o=new i,a=new s,l=new WeakMap,c=new WeakMap,h={},d={},p=new WeakMap,m=[],v=null,b=!1,g=null,f=null,R=null,E=null,S=null,I=null,P=null,D=new Ot(0,0,0),k=0,x=!1,w=null,C=null,B=null,V=null,X=null,K=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),Y=!1,st=0,G=n.getParameter(n.VERSION);G.indexOf("WebGL")!==-1?(st=parseFloat(/^WebGL (\d)/.exec(G)[1]),Y=st>=1):G.indexOf("OpenGL ES")!==-1&&(st=parseFloat(/^OpenGL ES (\d)/.exec(G)[1]),Y=st>=2);let lt=null,dt={},Rt=n.getParameter(n.SCISSOR_BOX),$t=n.getParameter(n.VIEWPORT),le=new we().fromArray(Rt),fe=new we().fromArray($t);function te(L,it,ot,mt){let Q=new Uint8Array(4),Z=n.createTexture();n.bindTexture(L,Z),n.texParameteri(L,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(L,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let vt=0;vt<ot;vt++)L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY?n.texImage3D(it,0,n.RGBA,1,1,mt,0,n.RGBA,n.UNSIGNED_BYTE,Q):n.texImage2D(it+vt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Q);return Z}let $={};$[n.TEXTURE_2D]=te(n.TEXTURE_2D,n.TEXTURE_2D,1),$[n.TEXTURE_CUBE_MAP]=te(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),$[n.TEXTURE_2D_ARRAY]=te(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),$[n.TEXTURE_3D]=te(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),J(n.DEPTH_TEST),o.setFunc(Fn),Ut(!1),xt(Fc),J(n.CULL_FACE),pe(en);function J(L){h[L]!==!0&&(n.enable(L),h[L]=!0)}function gt(L){h[L]!==!1&&(n.disable(L),h[L]=!1)}function Ft(L,it){return d[L]!==it?(n.bindFramebuffer(L,it),d[L]=it,L===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=it),L===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=it),!0):!1}function At(L,it){let ot=m,mt=!1;if(L){ot=p.get(it),ot===void 0&&(ot=[],p.set(it,ot));let Q=L.textures;if(ot.length!==Q.length||ot[0]!==n.COLOR_ATTACHMENT0){for(let Z=0,vt=Q.length;Z<vt;Z++)ot[Z]=n.COLOR_ATTACHMENT0+Z;ot.length=Q.length,mt=!0}}else ot[0]!==n.BACK&&(ot[0]=n.BACK,mt=!0);mt&&n.drawBuffers(ot)}function jt(L){return v!==L?(n.useProgram(L),v=L,!0):!1}let Oe={[pn]:n.FUNC_ADD,[Ju]:n.FUNC_SUBTRACT,[Qu]:n.FUNC_REVERSE_SUBTRACT};Oe[td]=n.MIN,Oe[ed]=n.MAX;let A={[id]:n.ZERO,[nd]:n.ONE,[sd]:n.SRC_COLOR,[Xo]:n.SRC_ALPHA,[hd]:n.SRC_ALPHA_SATURATE,[ld]:n.DST_COLOR,[od]:n.DST_ALPHA,[rd]:n.ONE_MINUS_SRC_COLOR,[qo]:n.ONE_MINUS_SRC_ALPHA,[cd]:n.ONE_MINUS_DST_COLOR,[ad]:n.ONE_MINUS_DST_ALPHA,[ud]:n.CONSTANT_COLOR,[dd]:n.ONE_MINUS_CONSTANT_COLOR,[fd]:n.CONSTANT_ALPHA,[pd]:n.ONE_MINUS_CONSTANT_ALPHA};function pe(L,it,ot,mt,Q,Z,vt,kt,ce,ee){if(L===en){b===!0&&(gt(n.BLEND),b=!1);return}if(b===!1&&(J(n.BLEND),b=!0),L!==ju){if(L!==g||ee!==x){if((f!==pn||S!==pn)&&(n.blendEquation(n.FUNC_ADD),f=pn,S=pn),ee)switch(L){case Nn:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case kc:n.blendFunc(n.ONE,n.ONE);break;case Bc:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case zc:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",L);break}else switch(L){case Nn:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case kc:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Bc:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case zc:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",L);break}R=null,E=null,I=null,P=null,D.set(0,0,0),k=0,g=L,x=ee}return}Q=Q||it,Z=Z||ot,vt=vt||mt,(it!==f||Q!==S)&&(n.blendEquationSeparate(Oe[it],Oe[Q]),f=it,S=Q),(ot!==R||mt!==E||Z!==I||vt!==P)&&(n.blendFuncSeparate(A[ot],A[mt],A[Z],A[vt]),R=ot,E=mt,I=Z,P=vt),(kt.equals(D)===!1||ce!==k)&&(n.blendColor(kt.r,kt.g,kt.b,ce),D.copy(kt),k=ce),g=L,x=!1}function Bt(L,it){L.side===zi?gt(n.CULL_FACE):J(n.CULL_FACE);let ot=L.side===Qe;it&&(ot=!ot),Ut(ot),L.blending===Nn&&L.transparent===!1?pe(en):pe(L.blending,L.blendEquation,L.blendSrc,L.blendDst,L.blendEquationAlpha,L.blendSrcAlpha,L.blendDstAlpha,L.blendColor,L.blendAlpha,L.premultipliedAlpha),o.setFunc(L.depthFunc),o.setTest(L.depthTest),o.setMask(L.depthWrite),r.setMask(L.colorWrite);let mt=L.stencilWrite;a.setTest(mt),mt&&(a.setMask(L.stencilWriteMask),a.setFunc(L.stencilFunc,L.stencilRef,L.stencilFuncMask),a.setOp(L.stencilFail,L.stencilZFail,L.stencilZPass)),bt(L.polygonOffset,L.polygonOffsetFactor,L.polygonOffsetUnits),L.alphaToCoverage===!0?J(n.SAMPLE_ALPHA_TO_COVERAGE):gt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Ut(L){w!==L&&(L?n.frontFace(n.CW):n.frontFace(n.CCW),w=L)}function xt(L){L!==$u?(J(n.CULL_FACE),L!==C&&(L===Fc?n.cullFace(n.BACK):L===Zu?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):gt(n.CULL_FACE),C=L}function me(L){L!==B&&(Y&&n.lineWidth(L),B=L)}function bt(L,it,ot){L?(J(n.POLYGON_OFFSET_FILL),(V!==it||X!==ot)&&(n.polygonOffset(it,ot),V=it,X=ot)):gt(n.POLYGON_OFFSET_FILL)}function Gt(L){L?J(n.SCISSOR_TEST):gt(n.SCISSOR_TEST)}function Le(L){L===void 0&&(L=n.TEXTURE0+K-1),lt!==L&&(n.activeTexture(L),lt=L)}function Se(L,it,ot){ot===void 0&&(lt===null?ot=n.TEXTURE0+K-1:ot=lt);let mt=dt[ot];mt===void 0&&(mt={type:void 0,texture:void 0},dt[ot]=mt),(mt.type!==L||mt.texture!==it)&&(lt!==ot&&(n.activeTexture(ot),lt=ot),n.bindTexture(L,it||$[L]),mt.type=L,mt.texture=it)}function T(){let L=dt[lt];L!==void 0&&L.type!==void 0&&(n.bindTexture(L.type,null),L.type=void 0,L.texture=void 0)}function y(){try{n.compressedTexImage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function O(){try{n.compressedTexImage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function q(){try{n.texSubImage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function j(){try{n.texSubImage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function W(){try{n.compressedTexSubImage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function Tt(){try{n.compressedTexSubImage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function rt(){try{n.texStorage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function wt(){try{n.texStorage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function St(){try{n.texImage2D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function et(){try{n.texImage3D(...arguments)}catch(L){console.error("THREE.WebGLState:",L)}}function ut(L){le.equals(L)===!1&&(n.scissor(L.x,L.y,L.z,L.w),le.copy(L))}function Dt(L){fe.equals(L)===!1&&(n.viewport(L.x,L.y,L.z,L.w),fe.copy(L))}function Et(L,it){let ot=c.get(it);ot===void 0&&(ot=new WeakMap,c.set(it,ot));let mt=ot.get(L);mt===void 0&&(mt=n.getUniformBlockIndex(it,L.name),ot.set(L,mt))}function ct(L,it){let mt=c.get(it).get(L);l.get(it)!==mt&&(n.uniformBlockBinding(it,mt,L.__bindingPointIndex),l.set(it,mt))}function Vt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),h={},lt=null,dt={},d={},p=new WeakMap,m=[],v=null,b=!1,g=null,f=null,R=null,E=null,S=null,I=null,P=null,D=new Ot(0,0,0),k=0,x=!1,w=null,C=null,B=null,V=null,X=null,le.set(0,0,n.canvas.width,n.canvas.height),fe.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:J,disable:gt,bindFramebuffer:Ft,drawBuffers:At,useProgram:jt,setBlending:pe,setMaterial:Bt,setFlipSided:Ut,setCullFace:xt,setLineWidth:me,setPolygonOffset:bt,setScissorTest:Gt,activeTexture:Le,bindTexture:Se,unbindTexture:T,compressedTexImage2D:y,compressedTexImage3D:O,texImage2D:St,texImage3D:et,updateUBOMapping:Et,uniformBlockBinding:ct,texStorage2D:rt,texStorage3D:wt,texSubImage2D:q,texSubImage3D:j,compressedTexSubImage2D:W,compressedTexSubImage3D:Tt,scissor:ut,viewport:Dt,reset:Vt}}function F0(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new zt,h=new WeakMap,d,p=new WeakMap,m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function v(T,y){return m?new OffscreenCanvas(T,y):or("canvas")}function b(T,y,O){let q=1,j=Se(T);if((j.width>O||j.height>O)&&(q=O/Math.max(j.width,j.height)),q<1)if(typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&T instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&T instanceof ImageBitmap||typeof VideoFrame<"u"&&T instanceof VideoFrame){let W=Math.floor(q*j.width),Tt=Math.floor(q*j.height);d===void 0&&(d=v(W,Tt));let rt=y?v(W,Tt):d;return rt.width=W,rt.height=Tt,rt.getContext("2d").drawImage(T,0,0,W,Tt),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+W+"x"+Tt+")."),rt}else return"data"in T&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),T;return T}function g(T){return T.generateMipmaps}function f(T){n.generateMipmap(T)}function R(T){return T.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:T.isWebGL3DRenderTarget?n.TEXTURE_3D:T.isWebGLArrayRenderTarget||T.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(T,y,O,q,j=!1){if(T!==null){if(n[T]!==void 0)return n[T];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+T+"'")}let W=y;if(y===n.RED&&(O===n.FLOAT&&(W=n.R32F),O===n.HALF_FLOAT&&(W=n.R16F),O===n.UNSIGNED_BYTE&&(W=n.R8)),y===n.RED_INTEGER&&(O===n.UNSIGNED_BYTE&&(W=n.R8UI),O===n.UNSIGNED_SHORT&&(W=n.R16UI),O===n.UNSIGNED_INT&&(W=n.R32UI),O===n.BYTE&&(W=n.R8I),O===n.SHORT&&(W=n.R16I),O===n.INT&&(W=n.R32I)),y===n.RG&&(O===n.FLOAT&&(W=n.RG32F),O===n.HALF_FLOAT&&(W=n.RG16F),O===n.UNSIGNED_BYTE&&(W=n.RG8)),y===n.RG_INTEGER&&(O===n.UNSIGNED_BYTE&&(W=n.RG8UI),O===n.UNSIGNED_SHORT&&(W=n.RG16UI),O===n.UNSIGNED_INT&&(W=n.RG32UI),O===n.BYTE&&(W=n.RG8I),O===n.SHORT&&(W=n.RG16I),O===n.INT&&(W=n.RG32I)),y===n.RGB_INTEGER&&(O===n.UNSIGNED_BYTE&&(W=n.RGB8UI),O===n.UNSIGNED_SHORT&&(W=n.RGB16UI),O===n.UNSIGNED_INT&&(W=n.RGB32UI),O===n.BYTE&&(W=n.RGB8I),O===n.SHORT&&(W=n.RGB16I),O===n.INT&&(W=n.RGB32I)),y===n.RGBA_INTEGER&&(O===n.UNSIGNED_BYTE&&(W=n.RGBA8UI),O===n.UNSIGNED_SHORT&&(W=n.RGBA16UI),O===n.UNSIGNED_INT&&(W=n.RGBA32UI),O===n.BYTE&&(W=n.RGBA8I),O===n.SHORT&&(W=n.RGBA16I),O===n.INT&&(W=n.RGBA32I)),y===n.RGB&&(O===n.UNSIGNED_INT_5_9_9_9_REV&&(W=n.RGB9_E5),O===n.UNSIGNED_INT_10F_11F_11F_REV&&(W=n.R11F_G11F_B10F)),y===n.RGBA){let Tt=j?sr:Jt.getTransfer(q);O===n.FLOAT&&(W=n.RGBA32F),O===n.HALF_FLOAT&&(W=n.RGBA16F),O===n.UNSIGNED_BYTE&&(W=Tt===ne?n.SRGB8_ALPHA8:n.RGBA8),O===n.UNSIGNED_SHORT_4_4_4_4&&(W=n.RGBA4),O===n.UNSIGNED_SHORT_5_5_5_1&&(W=n.RGB5_A1)}return(W===n.R16F||W===n.R32F||W===n.RG16F||W===n.RG32F||W===n.RGBA16F||W===n.RGBA32F)&&t.get("EXT_color_buffer_float"),W}function S(T,y){let O;return T?y===null||y===bn||y===Es?O=n.DEPTH24_STENCIL8:y===Ri?O=n.DEPTH32F_STENCIL8:y===Ms&&(O=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===bn||y===Es?O=n.DEPTH_COMPONENT24:y===Ri?O=n.DEPTH_COMPONENT32F:y===Ms&&(O=n.DEPTH_COMPONENT16),O}function I(T,y){return g(T)===!0||T.isFramebufferTexture&&T.minFilter!==ii&&T.minFilter!==Si?Math.log2(Math.max(y.width,y.height))+1:T.mipmaps!==void 0&&T.mipmaps.length>0?T.mipmaps.length:T.isCompressedTexture&&Array.isArray(T.image)?y.mipmaps.length:1}function P(T){let y=T.target;y.removeEventListener("dispose",P),k(y),y.isVideoTexture&&h.delete(y)}function D(T){let y=T.target;y.removeEventListener("dispose",D),w(y)}function k(T){let y=i.get(T);if(y.__webglInit===void 0)return;let O=T.source,q=p.get(O);if(q){let j=q[y.__cacheKey];j.usedTimes--,j.usedTimes===0&&x(T),Object.keys(q).length===0&&p.delete(O)}i.remove(T)}function x(T){let y=i.get(T);n.deleteTexture(y.__webglTexture);let O=T.source,q=p.get(O);delete q[y.__cacheKey],o.memory.textures--}function w(T){let y=i.get(T);if(T.depthTexture&&(T.depthTexture.dispose(),i.remove(T.depthTexture)),T.isWebGLCubeRenderTarget)for(let q=0;q<6;q++){if(Array.isArray(y.__webglFramebuffer[q]))for(let j=0;j<y.__webglFramebuffer[q].length;j++)n.deleteFramebuffer(y.__webglFramebuffer[q][j]);else n.deleteFramebuffer(y.__webglFramebuffer[q]);y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer[q])}else{if(Array.isArray(y.__webglFramebuffer))for(let q=0;q<y.__webglFramebuffer.length;q++)n.deleteFramebuffer(y.__webglFramebuffer[q]);else n.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&n.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let q=0;q<y.__webglColorRenderbuffer.length;q++)y.__webglColorRenderbuffer[q]&&n.deleteRenderbuffer(y.__webglColorRenderbuffer[q]);y.__webglDepthRenderbuffer&&n.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let O=T.textures;for(let q=0,j=O.length;q<j;q++){let W=i.get(O[q]);W.__webglTexture&&(n.deleteTexture(W.__webglTexture),o.memory.textures--),i.remove(O[q])}i.remove(T)}let C=0;function B(){C=0}function V(){let T=C;return T>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+T+" texture units while this GPU supports only "+s.maxTextures),C+=1,T}function X(T){let y=[];return y.push(T.wrapS),y.push(T.wrapT),y.push(T.wrapR||0),y.push(T.magFilter),y.push(T.minFilter),y.push(T.anisotropy),y.push(T.internalFormat),y.push(T.format),y.push(T.type),y.push(T.generateMipmaps),y.push(T.premultiplyAlpha),y.push(T.flipY),y.push(T.unpackAlignment),y.push(T.colorSpace),y.join()}function K(T,y){let O=i.get(T);if(T.isVideoTexture&&Gt(T),T.isRenderTargetTexture===!1&&T.isExternalTexture!==!0&&T.version>0&&O.__version!==T.version){let q=T.image;if(q===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(q.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{$(O,T,y);return}}else T.isExternalTexture&&(O.__webglTexture=T.sourceTexture?T.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,O.__webglTexture,n.TEXTURE0+y)}function Y(T,y){let O=i.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&O.__version!==T.version){$(O,T,y);return}e.bindTexture(n.TEXTURE_2D_ARRAY,O.__webglTexture,n.TEXTURE0+y)}function st(T,y){let O=i.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&O.__version!==T.version){$(O,T,y);return}e.bindTexture(n.TEXTURE_3D,O.__webglTexture,n.TEXTURE0+y)}function G(T,y){let O=i.get(T);if(T.version>0&&O.__version!==T.version){J(O,T,y);return}e.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+y)}let lt={[Yo]:n.REPEAT,[fn]:n.CLAMP_TO_EDGE,[$o]:n.MIRRORED_REPEAT},dt={[ii]:n.NEAREST,[Sd]:n.NEAREST_MIPMAP_NEAREST,[Rr]:n.NEAREST_MIPMAP_LINEAR,[Si]:n.LINEAR,[Ra]:n.LINEAR_MIPMAP_NEAREST,[xn]:n.LINEAR_MIPMAP_LINEAR},Rt={[Rd]:n.NEVER,[Ud]:n.ALWAYS,[Cd]:n.LESS,[Kc]:n.LEQUAL,[Pd]:n.EQUAL,[Dd]:n.GEQUAL,[Id]:n.GREATER,[Ld]:n.NOTEQUAL};function $t(T,y){if(y.type===Ri&&t.has("OES_texture_float_linear")===!1&&(y.magFilter===Si||y.magFilter===Ra||y.magFilter===Rr||y.magFilter===xn||y.minFilter===Si||y.minFilter===Ra||y.minFilter===Rr||y.minFilter===xn)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(T,n.TEXTURE_WRAP_S,lt[y.wrapS]),n.texParameteri(T,n.TEXTURE_WRAP_T,lt[y.wrapT]),(T===n.TEXTURE_3D||T===n.TEXTURE_2D_ARRAY)&&n.texParameteri(T,n.TEXTURE_WRAP_R,lt[y.wrapR]),n.texParameteri(T,n.TEXTURE_MAG_FILTER,dt[y.magFilter]),n.texParameteri(T,n.TEXTURE_MIN_FILTER,dt[y.minFilter]),y.compareFunction&&(n.texParameteri(T,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(T,n.TEXTURE_COMPARE_FUNC,Rt[y.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===ii||y.minFilter!==Rr&&y.minFilter!==xn||y.type===Ri&&t.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||i.get(y).__currentAnisotropy){let O=t.get("EXT_texture_filter_anisotropic");n.texParameterf(T,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),i.get(y).__currentAnisotropy=y.anisotropy}}}function le(T,y){let O=!1;T.__webglInit===void 0&&(T.__webglInit=!0,y.addEventListener("dispose",P));let q=y.source,j=p.get(q);j===void 0&&(j={},p.set(q,j));let W=X(y);if(W!==T.__cacheKey){j[W]===void 0&&(j[W]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,O=!0),j[W].usedTimes++;let Tt=j[T.__cacheKey];Tt!==void 0&&(j[T.__cacheKey].usedTimes--,Tt.usedTimes===0&&x(y)),T.__cacheKey=W,T.__webglTexture=j[W].texture}return O}function fe(T,y,O){return Math.floor(Math.floor(T/O)/y)}function te(T,y,O,q){let W=T.updateRanges;if(W.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,y.width,y.height,O,q,y.data);else{W.sort((et,ut)=>et.start-ut.start);let Tt=0;for(let et=1;et<W.length;et++){let ut=W[Tt],Dt=W[et],Et=ut.start+ut.count,ct=fe(Dt.start,y.width,4),Vt=fe(ut.start,y.width,4);Dt.start<=Et+1&&ct===Vt&&fe(Dt.start+Dt.count-1,y.width,4)===ct?ut.count=Math.max(ut.count,Dt.start+Dt.count-ut.start):(++Tt,W[Tt]=Dt)}W.length=Tt+1;let rt=n.getParameter(n.UNPACK_ROW_LENGTH),wt=n.getParameter(n.UNPACK_SKIP_PIXELS),St=n.getParameter(n.UNPACK_SKIP_ROWS);n.pixelStorei(n.UNPACK_ROW_LENGTH,y.width);for(let et=0,ut=W.length;et<ut;et++){let Dt=W[et],Et=Math.floor(Dt.start/4),ct=Math.ceil(Dt.count/4),Vt=Et%y.width,L=Math.floor(Et/y.width),it=ct,ot=1;n.pixelStorei(n.UNPACK_SKIP_PIXELS,Vt),n.pixelStorei(n.UNPACK_SKIP_ROWS,L),e.texSubImage2D(n.TEXTURE_2D,0,Vt,L,it,ot,O,q,y.data)}T.clearUpdateRanges(),n.pixelStorei(n.UNPACK_ROW_LENGTH,rt),n.pixelStorei(n.UNPACK_SKIP_PIXELS,wt),n.pixelStorei(n.UNPACK_SKIP_ROWS,St)}}function $(T,y,O){let q=n.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(q=n.TEXTURE_2D_ARRAY),y.isData3DTexture&&(q=n.TEXTURE_3D);let j=le(T,y),W=y.source;e.bindTexture(q,T.__webglTexture,n.TEXTURE0+O);let Tt=i.get(W);if(W.version!==Tt.__version||j===!0){e.activeTexture(n.TEXTURE0+O);let rt=Jt.getPrimaries(Jt.workingColorSpace),wt=y.colorSpace===sn?null:Jt.getPrimaries(y.colorSpace),St=y.colorSpace===sn||rt===wt?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,St);let et=b(y.image,!1,s.maxTextureSize);et=Le(y,et);let ut=r.convert(y.format,y.colorSpace),Dt=r.convert(y.type),Et=E(y.internalFormat,ut,Dt,y.colorSpace,y.isVideoTexture);$t(q,y);let ct,Vt=y.mipmaps,L=y.isVideoTexture!==!0,it=Tt.__version===void 0||j===!0,ot=W.dataReady,mt=I(y,et);if(y.isDepthTexture)Et=S(y.format===Ts,y.type),it&&(L?e.texStorage2D(n.TEXTURE_2D,1,Et,et.width,et.height):e.texImage2D(n.TEXTURE_2D,0,Et,et.width,et.height,0,ut,Dt,null));else if(y.isDataTexture)if(Vt.length>0){L&&it&&e.texStorage2D(n.TEXTURE_2D,mt,Et,Vt[0].width,Vt[0].height);for(let Q=0,Z=Vt.length;Q<Z;Q++)ct=Vt[Q],L?ot&&e.texSubImage2D(n.TEXTURE_2D,Q,0,0,ct.width,ct.height,ut,Dt,ct.data):e.texImage2D(n.TEXTURE_2D,Q,Et,ct.width,ct.height,0,ut,Dt,ct.data);y.generateMipmaps=!1}else L?(it&&e.texStorage2D(n.TEXTURE_2D,mt,Et,et.width,et.height),ot&&te(y,et,ut,Dt)):e.texImage2D(n.TEXTURE_2D,0,Et,et.width,et.height,0,ut,Dt,et.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){L&&it&&e.texStorage3D(n.TEXTURE_2D_ARRAY,mt,Et,Vt[0].width,Vt[0].height,et.depth);for(let Q=0,Z=Vt.length;Q<Z;Q++)if(ct=Vt[Q],y.format!==gi)if(ut!==null)if(L){if(ot)if(y.layerUpdates.size>0){let vt=sh(ct.width,ct.height,y.format,y.type);for(let kt of y.layerUpdates){let ce=ct.data.subarray(kt*vt/ct.data.BYTES_PER_ELEMENT,(kt+1)*vt/ct.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,Q,0,0,kt,ct.width,ct.height,1,ut,ce)}y.clearLayerUpdates()}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,Q,0,0,0,ct.width,ct.height,et.depth,ut,ct.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,Q,Et,ct.width,ct.height,et.depth,0,ct.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else L?ot&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,Q,0,0,0,ct.width,ct.height,et.depth,ut,Dt,ct.data):e.texImage3D(n.TEXTURE_2D_ARRAY,Q,Et,ct.width,ct.height,et.depth,0,ut,Dt,ct.data)}else{L&&it&&e.texStorage2D(n.TEXTURE_2D,mt,Et,Vt[0].width,Vt[0].height);for(let Q=0,Z=Vt.length;Q<Z;Q++)ct=Vt[Q],y.format!==gi?ut!==null?L?ot&&e.compressedTexSubImage2D(n.TEXTURE_2D,Q,0,0,ct.width,ct.height,ut,ct.data):e.compressedTexImage2D(n.TEXTURE_2D,Q,Et,ct.width,ct.height,0,ct.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):L?ot&&e.texSubImage2D(n.TEXTURE_2D,Q,0,0,ct.width,ct.height,ut,Dt,ct.data):e.texImage2D(n.TEXTURE_2D,Q,Et,ct.width,ct.height,0,ut,Dt,ct.data)}else if(y.isDataArrayTexture)if(L){if(it&&e.texStorage3D(n.TEXTURE_2D_ARRAY,mt,Et,et.width,et.height,et.depth),ot)if(y.layerUpdates.size>0){let Q=sh(et.width,et.height,y.format,y.type);for(let Z of y.layerUpdates){let vt=et.data.subarray(Z*Q/et.data.BYTES_PER_ELEMENT,(Z+1)*Q/et.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Z,et.width,et.height,1,ut,Dt,vt)}y.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,et.width,et.height,et.depth,ut,Dt,et.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,Et,et.width,et.height,et.depth,0,ut,Dt,et.data);else if(y.isData3DTexture)L?(it&&e.texStorage3D(n.TEXTURE_3D,mt,Et,et.width,et.height,et.depth),ot&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,et.width,et.height,et.depth,ut,Dt,et.data)):e.texImage3D(n.TEXTURE_3D,0,Et,et.width,et.height,et.depth,0,ut,Dt,et.data);else if(y.isFramebufferTexture){if(it)if(L)e.texStorage2D(n.TEXTURE_2D,mt,Et,et.width,et.height);else{let Q=et.width,Z=et.height;for(let vt=0;vt<mt;vt++)e.texImage2D(n.TEXTURE_2D,vt,Et,Q,Z,0,ut,Dt,null),Q>>=1,Z>>=1}}else if(Vt.length>0){if(L&&it){let Q=Se(Vt[0]);e.texStorage2D(n.TEXTURE_2D,mt,Et,Q.width,Q.height)}for(let Q=0,Z=Vt.length;Q<Z;Q++)ct=Vt[Q],L?ot&&e.texSubImage2D(n.TEXTURE_2D,Q,0,0,ut,Dt,ct):e.texImage2D(n.TEXTURE_2D,Q,Et,ut,Dt,ct);y.generateMipmaps=!1}else if(L){if(it){let Q=Se(et);e.texStorage2D(n.TEXTURE_2D,mt,Et,Q.width,Q.height)}ot&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,ut,Dt,et)}else e.texImage2D(n.TEXTURE_2D,0,Et,ut,Dt,et);g(y)&&f(q),Tt.__version=W.version,y.onUpdate&&y.onUpdate(y)}T.__version=y.version}function J(T,y,O){if(y.image.length!==6)return;let q=le(T,y),j=y.source;e.bindTexture(n.TEXTURE_CUBE_MAP,T.__webglTexture,n.TEXTURE0+O);let W=i.get(j);if(j.version!==W.__version||q===!0){e.activeTexture(n.TEXTURE0+O);let Tt=Jt.getPrimaries(Jt.workingColorSpace),rt=y.colorSpace===sn?null:Jt.getPrimaries(y.colorSpace),wt=y.colorSpace===sn||Tt===rt?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,wt);let St=y.isCompressedTexture||y.image[0].isCompressedTexture,et=y.image[0]&&y.image[0].isDataTexture,ut=[];for(let Z=0;Z<6;Z++)!St&&!et?ut[Z]=b(y.image[Z],!0,s.maxCubemapSize):ut[Z]=et?y.image[Z].image:y.image[Z],ut[Z]=Le(y,ut[Z]);let Dt=ut[0],Et=r.convert(y.format,y.colorSpace),ct=r.convert(y.type),Vt=E(y.internalFormat,Et,ct,y.colorSpace),L=y.isVideoTexture!==!0,it=W.__version===void 0||q===!0,ot=j.dataReady,mt=I(y,Dt);$t(n.TEXTURE_CUBE_MAP,y);let Q;if(St){L&&it&&e.texStorage2D(n.TEXTURE_CUBE_MAP,mt,Vt,Dt.width,Dt.height);for(let Z=0;Z<6;Z++){Q=ut[Z].mipmaps;for(let vt=0;vt<Q.length;vt++){let kt=Q[vt];y.format!==gi?Et!==null?L?ot&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,vt,0,0,kt.width,kt.height,Et,kt.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,vt,Vt,kt.width,kt.height,0,kt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):L?ot&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,vt,0,0,kt.width,kt.height,Et,ct,kt.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,vt,Vt,kt.width,kt.height,0,Et,ct,kt.data)}}}else{if(Q=y.mipmaps,L&&it){Q.length>0&&mt++;let Z=Se(ut[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,mt,Vt,Z.width,Z.height)}for(let Z=0;Z<6;Z++)if(et){L?ot&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0,0,0,ut[Z].width,ut[Z].height,Et,ct,ut[Z].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0,Vt,ut[Z].width,ut[Z].height,0,Et,ct,ut[Z].data);for(let vt=0;vt<Q.length;vt++){let ce=Q[vt].image[Z].image;L?ot&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,vt+1,0,0,ce.width,ce.height,Et,ct,ce.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,vt+1,Vt,ce.width,ce.height,0,Et,ct,ce.data)}}else{L?ot&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0,0,0,Et,ct,ut[Z]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0,Vt,Et,ct,ut[Z]);for(let vt=0;vt<Q.length;vt++){let kt=Q[vt];L?ot&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,vt+1,0,0,Et,ct,kt.image[Z]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,vt+1,Vt,Et,ct,kt.image[Z])}}}g(y)&&f(n.TEXTURE_CUBE_MAP),W.__version=j.version,y.onUpdate&&y.onUpdate(y)}T.__version=y.version}function gt(T,y,O,q,j,W){let Tt=r.convert(O.format,O.colorSpace),rt=r.convert(O.type),wt=E(O.internalFormat,Tt,rt,O.colorSpace),St=i.get(y),et=i.get(O);if(et.__renderTarget=y,!St.__hasExternalTextures){let ut=Math.max(1,y.width>>W),Dt=Math.max(1,y.height>>W);j===n.TEXTURE_3D||j===n.TEXTURE_2D_ARRAY?e.texImage3D(j,W,wt,ut,Dt,y.depth,0,Tt,rt,null):e.texImage2D(j,W,wt,ut,Dt,0,Tt,rt,null)}e.bindFramebuffer(n.FRAMEBUFFER,T),bt(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,q,j,et.__webglTexture,0,me(y)):(j===n.TEXTURE_2D||j>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,q,j,et.__webglTexture,W),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ft(T,y,O){if(n.bindRenderbuffer(n.RENDERBUFFER,T),y.depthBuffer){let q=y.depthTexture,j=q&&q.isDepthTexture?q.type:null,W=S(y.stencilBuffer,j),Tt=y.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,rt=me(y);bt(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,rt,W,y.width,y.height):O?n.renderbufferStorageMultisample(n.RENDERBUFFER,rt,W,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,W,y.width,y.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Tt,n.RENDERBUFFER,T)}else{let q=y.textures;for(let j=0;j<q.length;j++){let W=q[j],Tt=r.convert(W.format,W.colorSpace),rt=r.convert(W.type),wt=E(W.internalFormat,Tt,rt,W.colorSpace),St=me(y);O&&bt(y)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,St,wt,y.width,y.height):bt(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,St,wt,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,wt,y.width,y.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function At(T,y){if(y&&y.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(n.FRAMEBUFFER,T),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let q=i.get(y.depthTexture);q.__renderTarget=y,(!q.__webglTexture||y.depthTexture.image.width!==y.width||y.depthTexture.image.height!==y.height)&&(y.depthTexture.image.width=y.width,y.depthTexture.image.height=y.height,y.depthTexture.needsUpdate=!0),K(y.depthTexture,0);let j=q.__webglTexture,W=me(y);if(y.depthTexture.format===gs)bt(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,j,0,W):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,j,0);else if(y.depthTexture.format===Ts)bt(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,j,0,W):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,j,0);else throw new Error("Unknown depthTexture format")}function jt(T){let y=i.get(T),O=T.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==T.depthTexture){let q=T.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),q){let j=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,q.removeEventListener("dispose",j)};q.addEventListener("dispose",j),y.__depthDisposeCallback=j}y.__boundDepthTexture=q}if(T.depthTexture&&!y.__autoAllocateDepthBuffer){if(O)throw new Error("target.depthTexture not supported in Cube render targets");let q=T.texture.mipmaps;q&&q.length>0?At(y.__webglFramebuffer[0],T):At(y.__webglFramebuffer,T)}else if(O){y.__webglDepthbuffer=[];for(let q=0;q<6;q++)if(e.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[q]),y.__webglDepthbuffer[q]===void 0)y.__webglDepthbuffer[q]=n.createRenderbuffer(),Ft(y.__webglDepthbuffer[q],T,!1);else{let j=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,W=y.__webglDepthbuffer[q];n.bindRenderbuffer(n.RENDERBUFFER,W),n.framebufferRenderbuffer(n.FRAMEBUFFER,j,n.RENDERBUFFER,W)}}else{let q=T.texture.mipmaps;if(q&&q.length>0?e.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=n.createRenderbuffer(),Ft(y.__webglDepthbuffer,T,!1);else{let j=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,W=y.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,W),n.framebufferRenderbuffer(n.FRAMEBUFFER,j,n.RENDERBUFFER,W)}}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Oe(T,y,O){let q=i.get(T);y!==void 0&&gt(q.__webglFramebuffer,T,T.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),O!==void 0&&jt(T)}function A(T){let y=T.texture,O=i.get(T),q=i.get(y);T.addEventListener("dispose",D);let j=T.textures,W=T.isWebGLCubeRenderTarget===!0,Tt=j.length>1;if(Tt||(q.__webglTexture===void 0&&(q.__webglTexture=n.createTexture()),q.__version=y.version,o.memory.textures++),W){O.__webglFramebuffer=[];for(let rt=0;rt<6;rt++)if(y.mipmaps&&y.mipmaps.length>0){O.__webglFramebuffer[rt]=[];for(let wt=0;wt<y.mipmaps.length;wt++)O.__webglFramebuffer[rt][wt]=n.createFramebuffer()}else O.__webglFramebuffer[rt]=n.createFramebuffer()}else{if(y.mipmaps&&y.mipmaps.length>0){O.__webglFramebuffer=[];for(let rt=0;rt<y.mipmaps.length;rt++)O.__webglFramebuffer[rt]=n.createFramebuffer()}else O.__webglFramebuffer=n.createFramebuffer();if(Tt)for(let rt=0,wt=j.length;rt<wt;rt++){let St=i.get(j[rt]);St.__webglTexture===void 0&&(St.__webglTexture=n.createTexture(),o.memory.textures++)}if(T.samples>0&&bt(T)===!1){O.__webglMultisampledFramebuffer=n.createFramebuffer(),O.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let rt=0;rt<j.length;rt++){let wt=j[rt];O.__webglColorRenderbuffer[rt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,O.__webglColorRenderbuffer[rt]);let St=r.convert(wt.format,wt.colorSpace),et=r.convert(wt.type),ut=E(wt.internalFormat,St,et,wt.colorSpace,T.isXRRenderTarget===!0),Dt=me(T);n.renderbufferStorageMultisample(n.RENDERBUFFER,Dt,ut,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+rt,n.RENDERBUFFER,O.__webglColorRenderbuffer[rt])}n.bindRenderbuffer(n.RENDERBUFFER,null),T.depthBuffer&&(O.__webglDepthRenderbuffer=n.createRenderbuffer(),Ft(O.__webglDepthRenderbuffer,T,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(W){e.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture),$t(n.TEXTURE_CUBE_MAP,y);for(let rt=0;rt<6;rt++)if(y.mipmaps&&y.mipmaps.length>0)for(let wt=0;wt<y.mipmaps.length;wt++)gt(O.__webglFramebuffer[rt][wt],T,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,wt);else gt(O.__webglFramebuffer[rt],T,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0);g(y)&&f(n.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(Tt){for(let rt=0,wt=j.length;rt<wt;rt++){let St=j[rt],et=i.get(St),ut=n.TEXTURE_2D;(T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(ut=T.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ut,et.__webglTexture),$t(ut,St),gt(O.__webglFramebuffer,T,St,n.COLOR_ATTACHMENT0+rt,ut,0),g(St)&&f(ut)}e.unbindTexture()}else{let rt=n.TEXTURE_2D;if((T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(rt=T.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,q.__webglTexture),$t(rt,y),y.mipmaps&&y.mipmaps.length>0)for(let wt=0;wt<y.mipmaps.length;wt++)gt(O.__webglFramebuffer[wt],T,y,n.COLOR_ATTACHMENT0,rt,wt);else gt(O.__webglFramebuffer,T,y,n.COLOR_ATTACHMENT0,rt,0);g(y)&&f(rt),e.unbindTexture()}T.depthBuffer&&jt(T)}function pe(T){let y=T.textures;for(let O=0,q=y.length;O<q;O++){let j=y[O];if(g(j)){let W=R(T),Tt=i.get(j).__webglTexture;e.bindTexture(W,Tt),f(W),e.unbindTexture()}}}let Bt=[],Ut=[];function xt(T){if(T.samples>0){if(bt(T)===!1){let y=T.textures,O=T.width,q=T.height,j=n.COLOR_BUFFER_BIT,W=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Tt=i.get(T),rt=y.length>1;if(rt)for(let St=0;St<y.length;St++)e.bindFramebuffer(n.FRAMEBUFFER,Tt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+St,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,Tt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+St,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,Tt.__webglMultisampledFramebuffer);let wt=T.texture.mipmaps;wt&&wt.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Tt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Tt.__webglFramebuffer);for(let St=0;St<y.length;St++){if(T.resolveDepthBuffer&&(T.depthBuffer&&(j|=n.DEPTH_BUFFER_BIT),T.stencilBuffer&&T.resolveStencilBuffer&&(j|=n.STENCIL_BUFFER_BIT)),rt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Tt.__webglColorRenderbuffer[St]);let et=i.get(y[St]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,et,0)}n.blitFramebuffer(0,0,O,q,0,0,O,q,j,n.NEAREST),l===!0&&(Bt.length=0,Ut.length=0,Bt.push(n.COLOR_ATTACHMENT0+St),T.depthBuffer&&T.resolveDepthBuffer===!1&&(Bt.push(W),Ut.push(W),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,Ut)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Bt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),rt)for(let St=0;St<y.length;St++){e.bindFramebuffer(n.FRAMEBUFFER,Tt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+St,n.RENDERBUFFER,Tt.__webglColorRenderbuffer[St]);let et=i.get(y[St]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,Tt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+St,n.TEXTURE_2D,et,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Tt.__webglMultisampledFramebuffer)}else if(T.depthBuffer&&T.resolveDepthBuffer===!1&&l){let y=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[y])}}}function me(T){return Math.min(s.maxSamples,T.samples)}function bt(T){let y=i.get(T);return T.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Gt(T){let y=o.render.frame;h.get(T)!==y&&(h.set(T,y),T.update())}function Le(T,y){let O=T.colorSpace,q=T.format,j=T.type;return T.isCompressedTexture===!0||T.isVideoTexture===!0||O!==On&&O!==sn&&(Jt.getTransfer(O)===ne?(q!==gi||j!==Hi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",O)),y}function Se(T){return typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement?(c.width=T.naturalWidth||T.width,c.height=T.naturalHeight||T.height):typeof VideoFrame<"u"&&T instanceof VideoFrame?(c.width=T.displayWidth,c.height=T.displayHeight):(c.width=T.width,c.height=T.height),c}this.allocateTextureUnit=V,this.resetTextureUnits=B,this.setTexture2D=K,this.setTexture2DArray=Y,this.setTexture3D=st,this.setTextureCube=G,this.rebindTextures=Oe,this.setupRenderTarget=A,this.updateRenderTargetMipmap=pe,this.updateMultisampleRenderTarget=xt,this.setupDepthRenderbuffer=jt,this.setupFrameBufferTexture=gt,this.useMultisampledRTT=bt}function O0(n,t){function e(i,s=sn){let r,o=Jt.getTransfer(s);if(i===Hi)return n.UNSIGNED_BYTE;if(i===Pa)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Ia)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Wc)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Xc)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Vc)return n.BYTE;if(i===Gc)return n.SHORT;if(i===Ms)return n.UNSIGNED_SHORT;if(i===Ca)return n.INT;if(i===bn)return n.UNSIGNED_INT;if(i===Ri)return n.FLOAT;if(i===Ss)return n.HALF_FLOAT;if(i===qc)return n.ALPHA;if(i===Yc)return n.RGB;if(i===gi)return n.RGBA;if(i===gs)return n.DEPTH_COMPONENT;if(i===Ts)return n.DEPTH_STENCIL;if(i===La)return n.RED;if(i===Da)return n.RED_INTEGER;if(i===$c)return n.RG;if(i===Ua)return n.RG_INTEGER;if(i===Na)return n.RGBA_INTEGER;if(i===Cr||i===Pr||i===Ir||i===Lr)if(o===ne)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Cr)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Pr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ir)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Lr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Cr)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Pr)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ir)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Lr)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Fa||i===Oa||i===ka||i===Ba)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Fa)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Oa)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ka)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Ba)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===za||i===Ha||i===Va)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===za||i===Ha)return o===ne?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Va)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===Ga||i===Wa||i===Xa||i===qa||i===Ya||i===$a||i===Za||i===Ka||i===ja||i===Ja||i===Qa||i===tl||i===el||i===il)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Ga)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Wa)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Xa)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===qa)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ya)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===$a)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Za)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ka)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===ja)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ja)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Qa)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===tl)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===el)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===il)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===nl||i===sl||i===rl)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===nl)return o===ne?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===sl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===rl)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===ol||i===al||i===ll||i===cl)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===ol)return r.COMPRESSED_RED_RGTC1_EXT;if(i===al)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ll)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===cl)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Es?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var k0=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,B0=`
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

}`,_h=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new xr(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Ti({vertexShader:k0,fragmentShader:B0,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new qe(new br(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},vh=class extends Di{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,p=null,m=null,v=null,b=typeof XRWebGLBinding<"u",g=new _h,f={},R=e.getContextAttributes(),E=null,S=null,I=[],P=[],D=new zt,k=null,x=new We;x.viewport=new we;let w=new We;w.viewport=new we;let C=[x,w],B=new _a,V=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function($){let J=I[$];return J===void 0&&(J=new bs,I[$]=J),J.getTargetRaySpace()},this.getControllerGrip=function($){let J=I[$];return J===void 0&&(J=new bs,I[$]=J),J.getGripSpace()},this.getHand=function($){let J=I[$];return J===void 0&&(J=new bs,I[$]=J),J.getHandSpace()};function K($){let J=P.indexOf($.inputSource);if(J===-1)return;let gt=I[J];gt!==void 0&&(gt.update($.inputSource,$.frame,c||o),gt.dispatchEvent({type:$.type,data:$.inputSource}))}function Y(){s.removeEventListener("select",K),s.removeEventListener("selectstart",K),s.removeEventListener("selectend",K),s.removeEventListener("squeeze",K),s.removeEventListener("squeezestart",K),s.removeEventListener("squeezeend",K),s.removeEventListener("end",Y),s.removeEventListener("inputsourceschange",st);for(let $=0;$<I.length;$++){let J=P[$];J!==null&&(P[$]=null,I[$].disconnect(J))}V=null,X=null,g.reset();for(let $ in f)delete f[$];t.setRenderTarget(E),m=null,p=null,d=null,s=null,S=null,te.stop(),i.isPresenting=!1,t.setPixelRatio(k),t.setSize(D.width,D.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function($){r=$,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function($){a=$,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function($){c=$},this.getBaseLayer=function(){return p!==null?p:m},this.getBinding=function(){return d===null&&b&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return v},this.getSession=function(){return s},this.setSession=async function($){if(s=$,s!==null){if(E=t.getRenderTarget(),s.addEventListener("select",K),s.addEventListener("selectstart",K),s.addEventListener("selectend",K),s.addEventListener("squeeze",K),s.addEventListener("squeezestart",K),s.addEventListener("squeezeend",K),s.addEventListener("end",Y),s.addEventListener("inputsourceschange",st),R.xrCompatible!==!0&&await e.makeXRCompatible(),k=t.getPixelRatio(),t.getSize(D),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let gt=null,Ft=null,At=null;R.depth&&(At=R.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,gt=R.stencil?Ts:gs,Ft=R.stencil?Es:bn);let jt={colorFormat:e.RGBA8,depthFormat:At,scaleFactor:r};d=this.getBinding(),p=d.createProjectionLayer(jt),s.updateRenderState({layers:[p]}),t.setPixelRatio(1),t.setSize(p.textureWidth,p.textureHeight,!1),S=new Ui(p.textureWidth,p.textureHeight,{format:gi,type:Hi,depthTexture:new yr(p.textureWidth,p.textureHeight,Ft,void 0,void 0,void 0,void 0,void 0,void 0,gt),stencilBuffer:R.stencil,colorSpace:t.outputColorSpace,samples:R.antialias?4:0,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1})}else{let gt={antialias:R.antialias,alpha:!0,depth:R.depth,stencil:R.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,e,gt),s.updateRenderState({baseLayer:m}),t.setPixelRatio(1),t.setSize(m.framebufferWidth,m.framebufferHeight,!1),S=new Ui(m.framebufferWidth,m.framebufferHeight,{format:gi,type:Hi,colorSpace:t.outputColorSpace,stencilBuffer:R.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),te.setContext(s),te.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function st($){for(let J=0;J<$.removed.length;J++){let gt=$.removed[J],Ft=P.indexOf(gt);Ft>=0&&(P[Ft]=null,I[Ft].disconnect(gt))}for(let J=0;J<$.added.length;J++){let gt=$.added[J],Ft=P.indexOf(gt);if(Ft===-1){for(let jt=0;jt<I.length;jt++)if(jt>=P.length){P.push(gt),Ft=jt;break}else if(P[jt]===null){P[jt]=gt,Ft=jt;break}if(Ft===-1)break}let At=I[Ft];At&&At.connect(gt)}}let G=new F,lt=new F;function dt($,J,gt){G.setFromMatrixPosition(J.matrixWorld),lt.setFromMatrixPosition(gt.matrixWorld);let Ft=G.distanceTo(lt),At=J.projectionMatrix.elements,jt=gt.projectionMatrix.elements,Oe=At[14]/(At[10]-1),A=At[14]/(At[10]+1),pe=(At[9]+1)/At[5],Bt=(At[9]-1)/At[5],Ut=(At[8]-1)/At[0],xt=(jt[8]+1)/jt[0],me=Oe*Ut,bt=Oe*xt,Gt=Ft/(-Ut+xt),Le=Gt*-Ut;if(J.matrixWorld.decompose($.position,$.quaternion,$.scale),$.translateX(Le),$.translateZ(Gt),$.matrixWorld.compose($.position,$.quaternion,$.scale),$.matrixWorldInverse.copy($.matrixWorld).invert(),At[10]===-1)$.projectionMatrix.copy(J.projectionMatrix),$.projectionMatrixInverse.copy(J.projectionMatrixInverse);else{let Se=Oe+Gt,T=A+Gt,y=me-Le,O=bt+(Ft-Le),q=pe*A/T*Se,j=Bt*A/T*Se;$.projectionMatrix.makePerspective(y,O,q,j,Se,T),$.projectionMatrixInverse.copy($.projectionMatrix).invert()}}function Rt($,J){J===null?$.matrixWorld.copy($.matrix):$.matrixWorld.multiplyMatrices(J.matrixWorld,$.matrix),$.matrixWorldInverse.copy($.matrixWorld).invert()}this.updateCamera=function($){if(s===null)return;let J=$.near,gt=$.far;g.texture!==null&&(g.depthNear>0&&(J=g.depthNear),g.depthFar>0&&(gt=g.depthFar)),B.near=w.near=x.near=J,B.far=w.far=x.far=gt,(V!==B.near||X!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),V=B.near,X=B.far),B.layers.mask=$.layers.mask|6,x.layers.mask=B.layers.mask&3,w.layers.mask=B.layers.mask&5;let Ft=$.parent,At=B.cameras;Rt(B,Ft);for(let jt=0;jt<At.length;jt++)Rt(At[jt],Ft);At.length===2?dt(B,x,w):B.projectionMatrix.copy(x.projectionMatrix),$t($,B,Ft)};function $t($,J,gt){gt===null?$.matrix.copy(J.matrixWorld):($.matrix.copy(gt.matrixWorld),$.matrix.invert(),$.matrix.multiply(J.matrixWorld)),$.matrix.decompose($.position,$.quaternion,$.scale),$.updateMatrixWorld(!0),$.projectionMatrix.copy(J.projectionMatrix),$.projectionMatrixInverse.copy(J.projectionMatrixInverse),$.isPerspectiveCamera&&($.fov=_s*2*Math.atan(1/$.projectionMatrix.elements[5]),$.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(p===null&&m===null))return l},this.setFoveation=function($){l=$,p!==null&&(p.fixedFoveation=$),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=$)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(B)},this.getCameraTexture=function($){return f[$]};let le=null;function fe($,J){if(h=J.getViewerPose(c||o),v=J,h!==null){let gt=h.views;m!==null&&(t.setRenderTargetFramebuffer(S,m.framebuffer),t.setRenderTarget(S));let Ft=!1;gt.length!==B.cameras.length&&(B.cameras.length=0,Ft=!0);for(let A=0;A<gt.length;A++){let pe=gt[A],Bt=null;if(m!==null)Bt=m.getViewport(pe);else{let xt=d.getViewSubImage(p,pe);Bt=xt.viewport,A===0&&(t.setRenderTargetTextures(S,xt.colorTexture,xt.depthStencilTexture),t.setRenderTarget(S))}let Ut=C[A];Ut===void 0&&(Ut=new We,Ut.layers.enable(A),Ut.viewport=new we,C[A]=Ut),Ut.matrix.fromArray(pe.transform.matrix),Ut.matrix.decompose(Ut.position,Ut.quaternion,Ut.scale),Ut.projectionMatrix.fromArray(pe.projectionMatrix),Ut.projectionMatrixInverse.copy(Ut.projectionMatrix).invert(),Ut.viewport.set(Bt.x,Bt.y,Bt.width,Bt.height),A===0&&(B.matrix.copy(Ut.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),Ft===!0&&B.cameras.push(Ut)}let At=s.enabledFeatures;if(At&&At.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&b){d=i.getBinding();let A=d.getDepthInformation(gt[0]);A&&A.isValid&&A.texture&&g.init(A,s.renderState)}if(At&&At.includes("camera-access")&&b){t.state.unbindTexture(),d=i.getBinding();for(let A=0;A<gt.length;A++){let pe=gt[A].camera;if(pe){let Bt=f[pe];Bt||(Bt=new xr,f[pe]=Bt);let Ut=d.getCameraImage(pe);Bt.sourceTexture=Ut}}}}for(let gt=0;gt<I.length;gt++){let Ft=P[gt],At=I[gt];Ft!==null&&At!==void 0&&At.update(Ft,J,c||o)}le&&le($,J),J.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:J}),v=null}let te=new hf;te.setAnimationLoop(fe),this.setAnimationLoop=function($){le=$},this.dispose=function(){}}},Xn=new Ei,z0=new ae;function H0(n,t){function e(g,f){g.matrixAutoUpdate===!0&&g.updateMatrix(),f.value.copy(g.matrix)}function i(g,f){f.color.getRGB(g.fogColor.value,eh(n)),f.isFog?(g.fogNear.value=f.near,g.fogFar.value=f.far):f.isFogExp2&&(g.fogDensity.value=f.density)}function s(g,f,R,E,S){f.isMeshBasicMaterial||f.isMeshLambertMaterial?r(g,f):f.isMeshToonMaterial?(r(g,f),d(g,f)):f.isMeshPhongMaterial?(r(g,f),h(g,f)):f.isMeshStandardMaterial?(r(g,f),p(g,f),f.isMeshPhysicalMaterial&&m(g,f,S)):f.isMeshMatcapMaterial?(r(g,f),v(g,f)):f.isMeshDepthMaterial?r(g,f):f.isMeshDistanceMaterial?(r(g,f),b(g,f)):f.isMeshNormalMaterial?r(g,f):f.isLineBasicMaterial?(o(g,f),f.isLineDashedMaterial&&a(g,f)):f.isPointsMaterial?l(g,f,R,E):f.isSpriteMaterial?c(g,f):f.isShadowMaterial?(g.color.value.copy(f.color),g.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function r(g,f){g.opacity.value=f.opacity,f.color&&g.diffuse.value.copy(f.color),f.emissive&&g.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(g.map.value=f.map,e(f.map,g.mapTransform)),f.alphaMap&&(g.alphaMap.value=f.alphaMap,e(f.alphaMap,g.alphaMapTransform)),f.bumpMap&&(g.bumpMap.value=f.bumpMap,e(f.bumpMap,g.bumpMapTransform),g.bumpScale.value=f.bumpScale,f.side===Qe&&(g.bumpScale.value*=-1)),f.normalMap&&(g.normalMap.value=f.normalMap,e(f.normalMap,g.normalMapTransform),g.normalScale.value.copy(f.normalScale),f.side===Qe&&g.normalScale.value.negate()),f.displacementMap&&(g.displacementMap.value=f.displacementMap,e(f.displacementMap,g.displacementMapTransform),g.displacementScale.value=f.displacementScale,g.displacementBias.value=f.displacementBias),f.emissiveMap&&(g.emissiveMap.value=f.emissiveMap,e(f.emissiveMap,g.emissiveMapTransform)),f.specularMap&&(g.specularMap.value=f.specularMap,e(f.specularMap,g.specularMapTransform)),f.alphaTest>0&&(g.alphaTest.value=f.alphaTest);let R=t.get(f),E=R.envMap,S=R.envMapRotation;E&&(g.envMap.value=E,Xn.copy(S),Xn.x*=-1,Xn.y*=-1,Xn.z*=-1,E.isCubeTexture&&E.isRenderTargetTexture===!1&&(Xn.y*=-1,Xn.z*=-1),g.envMapRotation.value.setFromMatrix4(z0.makeRotationFromEuler(Xn)),g.flipEnvMap.value=E.isCubeTexture&&E.isRenderTargetTexture===!1?-1:1,g.reflectivity.value=f.reflectivity,g.ior.value=f.ior,g.refractionRatio.value=f.refractionRatio),f.lightMap&&(g.lightMap.value=f.lightMap,g.lightMapIntensity.value=f.lightMapIntensity,e(f.lightMap,g.lightMapTransform)),f.aoMap&&(g.aoMap.value=f.aoMap,g.aoMapIntensity.value=f.aoMapIntensity,e(f.aoMap,g.aoMapTransform))}function o(g,f){g.diffuse.value.copy(f.color),g.opacity.value=f.opacity,f.map&&(g.map.value=f.map,e(f.map,g.mapTransform))}function a(g,f){g.dashSize.value=f.dashSize,g.totalSize.value=f.dashSize+f.gapSize,g.scale.value=f.scale}function l(g,f,R,E){g.diffuse.value.copy(f.color),g.opacity.value=f.opacity,g.size.value=f.size*R,g.scale.value=E*.5,f.map&&(g.map.value=f.map,e(f.map,g.uvTransform)),f.alphaMap&&(g.alphaMap.value=f.alphaMap,e(f.alphaMap,g.alphaMapTransform)),f.alphaTest>0&&(g.alphaTest.value=f.alphaTest)}function c(g,f){g.diffuse.value.copy(f.color),g.opacity.value=f.opacity,g.rotation.value=f.rotation,f.map&&(g.map.value=f.map,e(f.map,g.mapTransform)),f.alphaMap&&(g.alphaMap.value=f.alphaMap,e(f.alphaMap,g.alphaMapTransform)),f.alphaTest>0&&(g.alphaTest.value=f.alphaTest)}function h(g,f){g.specular.value.copy(f.specular),g.shininess.value=Math.max(f.shininess,1e-4)}function d(g,f){f.gradientMap&&(g.gradientMap.value=f.gradientMap)}function p(g,f){g.metalness.value=f.metalness,f.metalnessMap&&(g.metalnessMap.value=f.metalnessMap,e(f.metalnessMap,g.metalnessMapTransform)),g.roughness.value=f.roughness,f.roughnessMap&&(g.roughnessMap.value=f.roughnessMap,e(f.roughnessMap,g.roughnessMapTransform)),f.envMap&&(g.envMapIntensity.value=f.envMapIntensity)}function m(g,f,R){g.ior.value=f.ior,f.sheen>0&&(g.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),g.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(g.sheenColorMap.value=f.sheenColorMap,e(f.sheenColorMap,g.sheenColorMapTransform)),f.sheenRoughnessMap&&(g.sheenRoughnessMap.value=f.sheenRoughnessMap,e(f.sheenRoughnessMap,g.sheenRoughnessMapTransform))),f.clearcoat>0&&(g.clearcoat.value=f.clearcoat,g.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(g.clearcoatMap.value=f.clearcoatMap,e(f.clearcoatMap,g.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,e(f.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(g.clearcoatNormalMap.value=f.clearcoatNormalMap,e(f.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===Qe&&g.clearcoatNormalScale.value.negate())),f.dispersion>0&&(g.dispersion.value=f.dispersion),f.iridescence>0&&(g.iridescence.value=f.iridescence,g.iridescenceIOR.value=f.iridescenceIOR,g.iridescenceThicknessMinimum.value=f.iridescenceThicknessRange[0],g.iridescenceThicknessMaximum.value=f.iridescenceThicknessRange[1],f.iridescenceMap&&(g.iridescenceMap.value=f.iridescenceMap,e(f.iridescenceMap,g.iridescenceMapTransform)),f.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=f.iridescenceThicknessMap,e(f.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),f.transmission>0&&(g.transmission.value=f.transmission,g.transmissionSamplerMap.value=R.texture,g.transmissionSamplerSize.value.set(R.width,R.height),f.transmissionMap&&(g.transmissionMap.value=f.transmissionMap,e(f.transmissionMap,g.transmissionMapTransform)),g.thickness.value=f.thickness,f.thicknessMap&&(g.thicknessMap.value=f.thicknessMap,e(f.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=f.attenuationDistance,g.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(g.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(g.anisotropyMap.value=f.anisotropyMap,e(f.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=f.specularIntensity,g.specularColor.value.copy(f.specularColor),f.specularColorMap&&(g.specularColorMap.value=f.specularColorMap,e(f.specularColorMap,g.specularColorMapTransform)),f.specularIntensityMap&&(g.specularIntensityMap.value=f.specularIntensityMap,e(f.specularIntensityMap,g.specularIntensityMapTransform))}function v(g,f){f.matcap&&(g.matcap.value=f.matcap)}function b(g,f){let R=t.get(f).light;g.referencePosition.value.setFromMatrixPosition(R.matrixWorld),g.nearDistance.value=R.shadow.camera.near,g.farDistance.value=R.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function V0(n,t,e,i){let s={},r={},o=[],a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(R,E){let S=E.program;i.uniformBlockBinding(R,S)}function c(R,E){let S=s[R.id];S===void 0&&(v(R),S=h(R),s[R.id]=S,R.addEventListener("dispose",g));let I=E.program;i.updateUBOMapping(R,I);let P=t.render.frame;r[R.id]!==P&&(p(R),r[R.id]=P)}function h(R){let E=d();R.__bindingPointIndex=E;let S=n.createBuffer(),I=R.__size,P=R.usage;return n.bindBuffer(n.UNIFORM_BUFFER,S),n.bufferData(n.UNIFORM_BUFFER,I,P),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,E,S),S}function d(){for(let R=0;R<a;R++)if(o.indexOf(R)===-1)return o.push(R),R;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function p(R){let E=s[R.id],S=R.uniforms,I=R.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let P=0,D=S.length;P<D;P++){let k=Array.isArray(S[P])?S[P]:[S[P]];for(let x=0,w=k.length;x<w;x++){let C=k[x];if(m(C,P,x,I)===!0){let B=C.__offset,V=Array.isArray(C.value)?C.value:[C.value],X=0;for(let K=0;K<V.length;K++){let Y=V[K],st=b(Y);typeof Y=="number"||typeof Y=="boolean"?(C.__data[0]=Y,n.bufferSubData(n.UNIFORM_BUFFER,B+X,C.__data)):Y.isMatrix3?(C.__data[0]=Y.elements[0],C.__data[1]=Y.elements[1],C.__data[2]=Y.elements[2],C.__data[3]=0,C.__data[4]=Y.elements[3],C.__data[5]=Y.elements[4],C.__data[6]=Y.elements[5],C.__data[7]=0,C.__data[8]=Y.elements[6],C.__data[9]=Y.elements[7],C.__data[10]=Y.elements[8],C.__data[11]=0):(Y.toArray(C.__data,X),X+=st.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,B,C.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function m(R,E,S,I){let P=R.value,D=E+"_"+S;if(I[D]===void 0)return typeof P=="number"||typeof P=="boolean"?I[D]=P:I[D]=P.clone(),!0;{let k=I[D];if(typeof P=="number"||typeof P=="boolean"){if(k!==P)return I[D]=P,!0}else if(k.equals(P)===!1)return k.copy(P),!0}return!1}function v(R){let E=R.uniforms,S=0,I=16;for(let D=0,k=E.length;D<k;D++){let x=Array.isArray(E[D])?E[D]:[E[D]];for(let w=0,C=x.length;w<C;w++){let B=x[w],V=Array.isArray(B.value)?B.value:[B.value];for(let X=0,K=V.length;X<K;X++){let Y=V[X],st=b(Y),G=S%I,lt=G%st.boundary,dt=G+lt;S+=lt,dt!==0&&I-dt<st.storage&&(S+=I-dt),B.__data=new Float32Array(st.storage/Float32Array.BYTES_PER_ELEMENT),B.__offset=S,S+=st.storage}}}let P=S%I;return P>0&&(S+=I-P),R.__size=S,R.__cache={},this}function b(R){let E={boundary:0,storage:0};return typeof R=="number"||typeof R=="boolean"?(E.boundary=4,E.storage=4):R.isVector2?(E.boundary=8,E.storage=8):R.isVector3||R.isColor?(E.boundary=16,E.storage=12):R.isVector4?(E.boundary=16,E.storage=16):R.isMatrix3?(E.boundary=48,E.storage=48):R.isMatrix4?(E.boundary=64,E.storage=64):R.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",R),E}function g(R){let E=R.target;E.removeEventListener("dispose",g);let S=o.indexOf(E.__bindingPointIndex);o.splice(S,1),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function f(){for(let R in s)n.deleteBuffer(s[R]);o=[],s={},r={}}return{bind:l,update:c,dispose:f}}var pl=class{constructor(t={}){let{canvas:e=Nd(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:p=!1}=t;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let v=new Uint32Array(4),b=new Int32Array(4),g=null,f=null,R=[],E=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=nn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let S=this,I=!1;this._outputColorSpace=ci;let P=0,D=0,k=null,x=-1,w=null,C=new we,B=new we,V=null,X=new Ot(0),K=0,Y=e.width,st=e.height,G=1,lt=null,dt=null,Rt=new we(0,0,Y,st),$t=new we(0,0,Y,st),le=!1,fe=new _r,te=!1,$=!1,J=new ae,gt=new F,Ft=new we,At={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},jt=!1;function Oe(){return k===null?G:1}let A=i;function pe(M,U){return e.getContext(M,U)}try{let M={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"180"}`),e.addEventListener("webglcontextlost",ot,!1),e.addEventListener("webglcontextrestored",mt,!1),e.addEventListener("webglcontextcreationerror",Q,!1),A===null){let U="webgl2";if(A=pe(U,M),A===null)throw pe(U)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(M){throw console.error("THREE.WebGLRenderer: "+M.message),M}let Bt,Ut,xt,me,bt,Gt,Le,Se,T,y,O,q,j,W,Tt,rt,wt,St,et,ut,Dt,Et,ct,Vt;function L(){Bt=new oy(A),Bt.init(),Et=new O0(A,Bt),Ut=new Qv(A,Bt,t,Et),xt=new N0(A,Bt),Ut.reversedDepthBuffer&&p&&xt.buffers.depth.setReversed(!0),me=new cy(A),bt=new w0,Gt=new F0(A,Bt,xt,bt,Ut,Et,me),Le=new ey(S),Se=new ry(S),T=new mg(A),ct=new jv(A,T),y=new ay(A,T,me,ct),O=new uy(A,y,T,me),et=new hy(A,Ut,Gt),rt=new ty(bt),q=new b0(S,Le,Se,Bt,Ut,ct,rt),j=new H0(S,bt),W=new S0,Tt=new P0(Bt),St=new Kv(S,Le,Se,xt,O,m,l),wt=new D0(S,O,Ut),Vt=new V0(A,me,Ut,xt),ut=new Jv(A,Bt,me),Dt=new ly(A,Bt,me),me.programs=q.programs,S.capabilities=Ut,S.extensions=Bt,S.properties=bt,S.renderLists=W,S.shadowMap=wt,S.state=xt,S.info=me}L();let it=new vh(S,A);this.xr=it,this.getContext=function(){return A},this.getContextAttributes=function(){return A.getContextAttributes()},this.forceContextLoss=function(){let M=Bt.get("WEBGL_lose_context");M&&M.loseContext()},this.forceContextRestore=function(){let M=Bt.get("WEBGL_lose_context");M&&M.restoreContext()},this.getPixelRatio=function(){return G},this.setPixelRatio=function(M){M!==void 0&&(G=M,this.setSize(Y,st,!1))},this.getSize=function(M){return M.set(Y,st)},this.setSize=function(M,U,z=!0){if(it.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}Y=M,st=U,e.width=Math.floor(M*G),e.height=Math.floor(U*G),z===!0&&(e.style.width=M+"px",e.style.height=U+"px"),this.setViewport(0,0,M,U)},this.getDrawingBufferSize=function(M){return M.set(Y*G,st*G).floor()},this.setDrawingBufferSize=function(M,U,z){Y=M,st=U,G=z,e.width=Math.floor(M*z),e.height=Math.floor(U*z),this.setViewport(0,0,M,U)},this.getCurrentViewport=function(M){return M.copy(C)},this.getViewport=function(M){return M.copy(Rt)},this.setViewport=function(M,U,z,H){M.isVector4?Rt.set(M.x,M.y,M.z,M.w):Rt.set(M,U,z,H),xt.viewport(C.copy(Rt).multiplyScalar(G).round())},this.getScissor=function(M){return M.copy($t)},this.setScissor=function(M,U,z,H){M.isVector4?$t.set(M.x,M.y,M.z,M.w):$t.set(M,U,z,H),xt.scissor(B.copy($t).multiplyScalar(G).round())},this.getScissorTest=function(){return le},this.setScissorTest=function(M){xt.setScissorTest(le=M)},this.setOpaqueSort=function(M){lt=M},this.setTransparentSort=function(M){dt=M},this.getClearColor=function(M){return M.copy(St.getClearColor())},this.setClearColor=function(){St.setClearColor(...arguments)},this.getClearAlpha=function(){return St.getClearAlpha()},this.setClearAlpha=function(){St.setClearAlpha(...arguments)},this.clear=function(M=!0,U=!0,z=!0){let H=0;if(M){let N=!1;if(k!==null){let tt=k.texture.format;N=tt===Na||tt===Ua||tt===Da}if(N){let tt=k.texture.type,ht=tt===Hi||tt===bn||tt===Ms||tt===Es||tt===Pa||tt===Ia,_t=St.getClearColor(),ft=St.getClearAlpha(),Lt=_t.r,Nt=_t.g,Ct=_t.b;ht?(v[0]=Lt,v[1]=Nt,v[2]=Ct,v[3]=ft,A.clearBufferuiv(A.COLOR,0,v)):(b[0]=Lt,b[1]=Nt,b[2]=Ct,b[3]=ft,A.clearBufferiv(A.COLOR,0,b))}else H|=A.COLOR_BUFFER_BIT}U&&(H|=A.DEPTH_BUFFER_BIT),z&&(H|=A.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),A.clear(H)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",ot,!1),e.removeEventListener("webglcontextrestored",mt,!1),e.removeEventListener("webglcontextcreationerror",Q,!1),St.dispose(),W.dispose(),Tt.dispose(),bt.dispose(),Le.dispose(),Se.dispose(),O.dispose(),ct.dispose(),Vt.dispose(),q.dispose(),it.dispose(),it.removeEventListener("sessionstart",Ci),it.removeEventListener("sessionend",Ch),Mn.stop()};function ot(M){M.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),I=!0}function mt(){console.log("THREE.WebGLRenderer: Context Restored."),I=!1;let M=me.autoReset,U=wt.enabled,z=wt.autoUpdate,H=wt.needsUpdate,N=wt.type;L(),me.autoReset=M,wt.enabled=U,wt.autoUpdate=z,wt.needsUpdate=H,wt.type=N}function Q(M){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",M.statusMessage)}function Z(M){let U=M.target;U.removeEventListener("dispose",Z),vt(U)}function vt(M){kt(M),bt.remove(M)}function kt(M){let U=bt.get(M).programs;U!==void 0&&(U.forEach(function(z){q.releaseProgram(z)}),M.isShaderMaterial&&q.releaseShaderCache(M))}this.renderBufferDirect=function(M,U,z,H,N,tt){U===null&&(U=At);let ht=N.isMesh&&N.matrixWorld.determinant()<0,_t=Of(M,U,z,H,N);xt.setMaterial(H,ht);let ft=z.index,Lt=1;if(H.wireframe===!0){if(ft=y.getWireframeAttribute(z),ft===void 0)return;Lt=2}let Nt=z.drawRange,Ct=z.attributes.position,Zt=Nt.start*Lt,se=(Nt.start+Nt.count)*Lt;tt!==null&&(Zt=Math.max(Zt,tt.start*Lt),se=Math.min(se,(tt.start+tt.count)*Lt)),ft!==null?(Zt=Math.max(Zt,0),se=Math.min(se,ft.count)):Ct!=null&&(Zt=Math.max(Zt,0),se=Math.min(se,Ct.count));let ve=se-Zt;if(ve<0||ve===1/0)return;ct.setup(N,H,_t,z,ft);let ue,oe=ut;if(ft!==null&&(ue=T.get(ft),oe=Dt,oe.setIndex(ue)),N.isMesh)H.wireframe===!0?(xt.setLineWidth(H.wireframeLinewidth*Oe()),oe.setMode(A.LINES)):oe.setMode(A.TRIANGLES);else if(N.isLine){let It=H.linewidth;It===void 0&&(It=1),xt.setLineWidth(It*Oe()),N.isLineSegments?oe.setMode(A.LINES):N.isLineLoop?oe.setMode(A.LINE_LOOP):oe.setMode(A.LINE_STRIP)}else N.isPoints?oe.setMode(A.POINTS):N.isSprite&&oe.setMode(A.TRIANGLES);if(N.isBatchedMesh)if(N._multiDrawInstances!==null)vs("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),oe.renderMultiDrawInstances(N._multiDrawStarts,N._multiDrawCounts,N._multiDrawCount,N._multiDrawInstances);else if(Bt.get("WEBGL_multi_draw"))oe.renderMultiDraw(N._multiDrawStarts,N._multiDrawCounts,N._multiDrawCount);else{let It=N._multiDrawStarts,ge=N._multiDrawCounts,Qt=N._multiDrawCount,si=ft?T.get(ft).bytesPerElement:1,$n=bt.get(H).currentProgram.getUniforms();for(let ri=0;ri<Qt;ri++)$n.setValue(A,"_gl_DrawID",ri),oe.render(It[ri]/si,ge[ri])}else if(N.isInstancedMesh)oe.renderInstances(Zt,ve,N.count);else if(z.isInstancedBufferGeometry){let It=z._maxInstanceCount!==void 0?z._maxInstanceCount:1/0,ge=Math.min(z.instanceCount,It);oe.renderInstances(Zt,ve,ge)}else oe.render(Zt,ve)};function ce(M,U,z){M.transparent===!0&&M.side===zi&&M.forceSinglePass===!1?(M.side=Qe,M.needsUpdate=!0,Br(M,U,z),M.side=Qi,M.needsUpdate=!0,Br(M,U,z),M.side=zi):Br(M,U,z)}this.compile=function(M,U,z=null){z===null&&(z=M),f=Tt.get(z),f.init(U),E.push(f),z.traverseVisible(function(N){N.isLight&&N.layers.test(U.layers)&&(f.pushLight(N),N.castShadow&&f.pushShadow(N))}),M!==z&&M.traverseVisible(function(N){N.isLight&&N.layers.test(U.layers)&&(f.pushLight(N),N.castShadow&&f.pushShadow(N))}),f.setupLights();let H=new Set;return M.traverse(function(N){if(!(N.isMesh||N.isPoints||N.isLine||N.isSprite))return;let tt=N.material;if(tt)if(Array.isArray(tt))for(let ht=0;ht<tt.length;ht++){let _t=tt[ht];ce(_t,z,N),H.add(_t)}else ce(tt,z,N),H.add(tt)}),f=E.pop(),H},this.compileAsync=function(M,U,z=null){let H=this.compile(M,U,z);return new Promise(N=>{function tt(){if(H.forEach(function(ht){bt.get(ht).currentProgram.isReady()&&H.delete(ht)}),H.size===0){N(M);return}setTimeout(tt,10)}Bt.get("KHR_parallel_shader_compile")!==null?tt():setTimeout(tt,10)})};let ee=null;function Wi(M){ee&&ee(M)}function Ci(){Mn.stop()}function Ch(){Mn.start()}let Mn=new hf;Mn.setAnimationLoop(Wi),typeof self<"u"&&Mn.setContext(self),this.setAnimationLoop=function(M){ee=M,it.setAnimationLoop(M),M===null?Mn.stop():Mn.start()},it.addEventListener("sessionstart",Ci),it.addEventListener("sessionend",Ch),this.render=function(M,U){if(U!==void 0&&U.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;if(M.matrixWorldAutoUpdate===!0&&M.updateMatrixWorld(),U.parent===null&&U.matrixWorldAutoUpdate===!0&&U.updateMatrixWorld(),it.enabled===!0&&it.isPresenting===!0&&(it.cameraAutoUpdate===!0&&it.updateCamera(U),U=it.getCamera()),M.isScene===!0&&M.onBeforeRender(S,M,U,k),f=Tt.get(M,E.length),f.init(U),E.push(f),J.multiplyMatrices(U.projectionMatrix,U.matrixWorldInverse),fe.setFromProjectionMatrix(J,Mi,U.reversedDepth),$=this.localClippingEnabled,te=rt.init(this.clippingPlanes,$),g=W.get(M,R.length),g.init(),R.push(g),it.enabled===!0&&it.isPresenting===!0){let tt=S.xr.getDepthSensingMesh();tt!==null&&Fl(tt,U,-1/0,S.sortObjects)}Fl(M,U,0,S.sortObjects),g.finish(),S.sortObjects===!0&&g.sort(lt,dt),jt=it.enabled===!1||it.isPresenting===!1||it.hasDepthSensing()===!1,jt&&St.addToRenderList(g,M),this.info.render.frame++,te===!0&&rt.beginShadows();let z=f.state.shadowsArray;wt.render(z,M,U),te===!0&&rt.endShadows(),this.info.autoReset===!0&&this.info.reset();let H=g.opaque,N=g.transmissive;if(f.setupLights(),U.isArrayCamera){let tt=U.cameras;if(N.length>0)for(let ht=0,_t=tt.length;ht<_t;ht++){let ft=tt[ht];Ih(H,N,M,ft)}jt&&St.render(M);for(let ht=0,_t=tt.length;ht<_t;ht++){let ft=tt[ht];Ph(g,M,ft,ft.viewport)}}else N.length>0&&Ih(H,N,M,U),jt&&St.render(M),Ph(g,M,U);k!==null&&D===0&&(Gt.updateMultisampleRenderTarget(k),Gt.updateRenderTargetMipmap(k)),M.isScene===!0&&M.onAfterRender(S,M,U),ct.resetDefaultState(),x=-1,w=null,E.pop(),E.length>0?(f=E[E.length-1],te===!0&&rt.setGlobalState(S.clippingPlanes,f.state.camera)):f=null,R.pop(),R.length>0?g=R[R.length-1]:g=null};function Fl(M,U,z,H){if(M.visible===!1)return;if(M.layers.test(U.layers)){if(M.isGroup)z=M.renderOrder;else if(M.isLOD)M.autoUpdate===!0&&M.update(U);else if(M.isLight)f.pushLight(M),M.castShadow&&f.pushShadow(M);else if(M.isSprite){if(!M.frustumCulled||fe.intersectsSprite(M)){H&&Ft.setFromMatrixPosition(M.matrixWorld).applyMatrix4(J);let ht=O.update(M),_t=M.material;_t.visible&&g.push(M,ht,_t,z,Ft.z,null)}}else if((M.isMesh||M.isLine||M.isPoints)&&(!M.frustumCulled||fe.intersectsObject(M))){let ht=O.update(M),_t=M.material;if(H&&(M.boundingSphere!==void 0?(M.boundingSphere===null&&M.computeBoundingSphere(),Ft.copy(M.boundingSphere.center)):(ht.boundingSphere===null&&ht.computeBoundingSphere(),Ft.copy(ht.boundingSphere.center)),Ft.applyMatrix4(M.matrixWorld).applyMatrix4(J)),Array.isArray(_t)){let ft=ht.groups;for(let Lt=0,Nt=ft.length;Lt<Nt;Lt++){let Ct=ft[Lt],Zt=_t[Ct.materialIndex];Zt&&Zt.visible&&g.push(M,ht,Zt,z,Ft.z,Ct)}}else _t.visible&&g.push(M,ht,_t,z,Ft.z,null)}}let tt=M.children;for(let ht=0,_t=tt.length;ht<_t;ht++)Fl(tt[ht],U,z,H)}function Ph(M,U,z,H){let N=M.opaque,tt=M.transmissive,ht=M.transparent;f.setupLightsView(z),te===!0&&rt.setGlobalState(S.clippingPlanes,z),H&&xt.viewport(C.copy(H)),N.length>0&&kr(N,U,z),tt.length>0&&kr(tt,U,z),ht.length>0&&kr(ht,U,z),xt.buffers.depth.setTest(!0),xt.buffers.depth.setMask(!0),xt.buffers.color.setMask(!0),xt.setPolygonOffset(!1)}function Ih(M,U,z,H){if((z.isScene===!0?z.overrideMaterial:null)!==null)return;f.state.transmissionRenderTarget[H.id]===void 0&&(f.state.transmissionRenderTarget[H.id]=new Ui(1,1,{generateMipmaps:!0,type:Bt.has("EXT_color_buffer_half_float")||Bt.has("EXT_color_buffer_float")?Ss:Hi,minFilter:xn,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:Jt.workingColorSpace}));let tt=f.state.transmissionRenderTarget[H.id],ht=H.viewport||C;tt.setSize(ht.z*S.transmissionResolutionScale,ht.w*S.transmissionResolutionScale);let _t=S.getRenderTarget(),ft=S.getActiveCubeFace(),Lt=S.getActiveMipmapLevel();S.setRenderTarget(tt),S.getClearColor(X),K=S.getClearAlpha(),K<1&&S.setClearColor(16777215,.5),S.clear(),jt&&St.render(z);let Nt=S.toneMapping;S.toneMapping=nn;let Ct=H.viewport;if(H.viewport!==void 0&&(H.viewport=void 0),f.setupLightsView(H),te===!0&&rt.setGlobalState(S.clippingPlanes,H),kr(M,z,H),Gt.updateMultisampleRenderTarget(tt),Gt.updateRenderTargetMipmap(tt),Bt.has("WEBGL_multisampled_render_to_texture")===!1){let Zt=!1;for(let se=0,ve=U.length;se<ve;se++){let ue=U[se],oe=ue.object,It=ue.geometry,ge=ue.material,Qt=ue.group;if(ge.side===zi&&oe.layers.test(H.layers)){let si=ge.side;ge.side=Qe,ge.needsUpdate=!0,Lh(oe,z,H,It,ge,Qt),ge.side=si,ge.needsUpdate=!0,Zt=!0}}Zt===!0&&(Gt.updateMultisampleRenderTarget(tt),Gt.updateRenderTargetMipmap(tt))}S.setRenderTarget(_t,ft,Lt),S.setClearColor(X,K),Ct!==void 0&&(H.viewport=Ct),S.toneMapping=Nt}function kr(M,U,z){let H=U.isScene===!0?U.overrideMaterial:null;for(let N=0,tt=M.length;N<tt;N++){let ht=M[N],_t=ht.object,ft=ht.geometry,Lt=ht.group,Nt=ht.material;Nt.allowOverride===!0&&H!==null&&(Nt=H),_t.layers.test(z.layers)&&Lh(_t,U,z,ft,Nt,Lt)}}function Lh(M,U,z,H,N,tt){M.onBeforeRender(S,U,z,H,N,tt),M.modelViewMatrix.multiplyMatrices(z.matrixWorldInverse,M.matrixWorld),M.normalMatrix.getNormalMatrix(M.modelViewMatrix),N.onBeforeRender(S,U,z,H,M,tt),N.transparent===!0&&N.side===zi&&N.forceSinglePass===!1?(N.side=Qe,N.needsUpdate=!0,S.renderBufferDirect(z,U,H,N,M,tt),N.side=Qi,N.needsUpdate=!0,S.renderBufferDirect(z,U,H,N,M,tt),N.side=zi):S.renderBufferDirect(z,U,H,N,M,tt),M.onAfterRender(S,U,z,H,N,tt)}function Br(M,U,z){U.isScene!==!0&&(U=At);let H=bt.get(M),N=f.state.lights,tt=f.state.shadowsArray,ht=N.state.version,_t=q.getParameters(M,N.state,tt,U,z),ft=q.getProgramCacheKey(_t),Lt=H.programs;H.environment=M.isMeshStandardMaterial?U.environment:null,H.fog=U.fog,H.envMap=(M.isMeshStandardMaterial?Se:Le).get(M.envMap||H.environment),H.envMapRotation=H.environment!==null&&M.envMap===null?U.environmentRotation:M.envMapRotation,Lt===void 0&&(M.addEventListener("dispose",Z),Lt=new Map,H.programs=Lt);let Nt=Lt.get(ft);if(Nt!==void 0){if(H.currentProgram===Nt&&H.lightsStateVersion===ht)return Uh(M,_t),Nt}else _t.uniforms=q.getUniforms(M),M.onBeforeCompile(_t,S),Nt=q.acquireProgram(_t,ft),Lt.set(ft,Nt),H.uniforms=_t.uniforms;let Ct=H.uniforms;return(!M.isShaderMaterial&&!M.isRawShaderMaterial||M.clipping===!0)&&(Ct.clippingPlanes=rt.uniform),Uh(M,_t),H.needsLights=Bf(M),H.lightsStateVersion=ht,H.needsLights&&(Ct.ambientLightColor.value=N.state.ambient,Ct.lightProbe.value=N.state.probe,Ct.directionalLights.value=N.state.directional,Ct.directionalLightShadows.value=N.state.directionalShadow,Ct.spotLights.value=N.state.spot,Ct.spotLightShadows.value=N.state.spotShadow,Ct.rectAreaLights.value=N.state.rectArea,Ct.ltc_1.value=N.state.rectAreaLTC1,Ct.ltc_2.value=N.state.rectAreaLTC2,Ct.pointLights.value=N.state.point,Ct.pointLightShadows.value=N.state.pointShadow,Ct.hemisphereLights.value=N.state.hemi,Ct.directionalShadowMap.value=N.state.directionalShadowMap,Ct.directionalShadowMatrix.value=N.state.directionalShadowMatrix,Ct.spotShadowMap.value=N.state.spotShadowMap,Ct.spotLightMatrix.value=N.state.spotLightMatrix,Ct.spotLightMap.value=N.state.spotLightMap,Ct.pointShadowMap.value=N.state.pointShadowMap,Ct.pointShadowMatrix.value=N.state.pointShadowMatrix),H.currentProgram=Nt,H.uniformsList=null,Nt}function Dh(M){if(M.uniformsList===null){let U=M.currentProgram.getUniforms();M.uniformsList=Ps.seqWithValue(U.seq,M.uniforms)}return M.uniformsList}function Uh(M,U){let z=bt.get(M);z.outputColorSpace=U.outputColorSpace,z.batching=U.batching,z.batchingColor=U.batchingColor,z.instancing=U.instancing,z.instancingColor=U.instancingColor,z.instancingMorph=U.instancingMorph,z.skinning=U.skinning,z.morphTargets=U.morphTargets,z.morphNormals=U.morphNormals,z.morphColors=U.morphColors,z.morphTargetsCount=U.morphTargetsCount,z.numClippingPlanes=U.numClippingPlanes,z.numIntersection=U.numClipIntersection,z.vertexAlphas=U.vertexAlphas,z.vertexTangents=U.vertexTangents,z.toneMapping=U.toneMapping}function Of(M,U,z,H,N){U.isScene!==!0&&(U=At),Gt.resetTextureUnits();let tt=U.fog,ht=H.isMeshStandardMaterial?U.environment:null,_t=k===null?S.outputColorSpace:k.isXRRenderTarget===!0?k.texture.colorSpace:On,ft=(H.isMeshStandardMaterial?Se:Le).get(H.envMap||ht),Lt=H.vertexColors===!0&&!!z.attributes.color&&z.attributes.color.itemSize===4,Nt=!!z.attributes.tangent&&(!!H.normalMap||H.anisotropy>0),Ct=!!z.morphAttributes.position,Zt=!!z.morphAttributes.normal,se=!!z.morphAttributes.color,ve=nn;H.toneMapped&&(k===null||k.isXRRenderTarget===!0)&&(ve=S.toneMapping);let ue=z.morphAttributes.position||z.morphAttributes.normal||z.morphAttributes.color,oe=ue!==void 0?ue.length:0,It=bt.get(H),ge=f.state.lights;if(te===!0&&($===!0||M!==w)){let $e=M===w&&H.id===x;rt.setState(H,M,$e)}let Qt=!1;H.version===It.__version?(It.needsLights&&It.lightsStateVersion!==ge.state.version||It.outputColorSpace!==_t||N.isBatchedMesh&&It.batching===!1||!N.isBatchedMesh&&It.batching===!0||N.isBatchedMesh&&It.batchingColor===!0&&N.colorTexture===null||N.isBatchedMesh&&It.batchingColor===!1&&N.colorTexture!==null||N.isInstancedMesh&&It.instancing===!1||!N.isInstancedMesh&&It.instancing===!0||N.isSkinnedMesh&&It.skinning===!1||!N.isSkinnedMesh&&It.skinning===!0||N.isInstancedMesh&&It.instancingColor===!0&&N.instanceColor===null||N.isInstancedMesh&&It.instancingColor===!1&&N.instanceColor!==null||N.isInstancedMesh&&It.instancingMorph===!0&&N.morphTexture===null||N.isInstancedMesh&&It.instancingMorph===!1&&N.morphTexture!==null||It.envMap!==ft||H.fog===!0&&It.fog!==tt||It.numClippingPlanes!==void 0&&(It.numClippingPlanes!==rt.numPlanes||It.numIntersection!==rt.numIntersection)||It.vertexAlphas!==Lt||It.vertexTangents!==Nt||It.morphTargets!==Ct||It.morphNormals!==Zt||It.morphColors!==se||It.toneMapping!==ve||It.morphTargetsCount!==oe)&&(Qt=!0):(Qt=!0,It.__version=H.version);let si=It.currentProgram;Qt===!0&&(si=Br(H,U,N));let $n=!1,ri=!1,Ds=!1,_e=si.getUniforms(),ui=It.uniforms;if(xt.useProgram(si.program)&&($n=!0,ri=!0,Ds=!0),H.id!==x&&(x=H.id,ri=!0),$n||w!==M){xt.buffers.depth.getReversed()&&M.reversedDepth!==!0&&(M._reversedDepth=!0,M.updateProjectionMatrix()),_e.setValue(A,"projectionMatrix",M.projectionMatrix),_e.setValue(A,"viewMatrix",M.matrixWorldInverse);let ti=_e.map.cameraPosition;ti!==void 0&&ti.setValue(A,gt.setFromMatrixPosition(M.matrixWorld)),Ut.logarithmicDepthBuffer&&_e.setValue(A,"logDepthBufFC",2/(Math.log(M.far+1)/Math.LN2)),(H.isMeshPhongMaterial||H.isMeshToonMaterial||H.isMeshLambertMaterial||H.isMeshBasicMaterial||H.isMeshStandardMaterial||H.isShaderMaterial)&&_e.setValue(A,"isOrthographic",M.isOrthographicCamera===!0),w!==M&&(w=M,ri=!0,Ds=!0)}if(N.isSkinnedMesh){_e.setOptional(A,N,"bindMatrix"),_e.setOptional(A,N,"bindMatrixInverse");let $e=N.skeleton;$e&&($e.boneTexture===null&&$e.computeBoneTexture(),_e.setValue(A,"boneTexture",$e.boneTexture,Gt))}N.isBatchedMesh&&(_e.setOptional(A,N,"batchingTexture"),_e.setValue(A,"batchingTexture",N._matricesTexture,Gt),_e.setOptional(A,N,"batchingIdTexture"),_e.setValue(A,"batchingIdTexture",N._indirectTexture,Gt),_e.setOptional(A,N,"batchingColorTexture"),N._colorsTexture!==null&&_e.setValue(A,"batchingColorTexture",N._colorsTexture,Gt));let di=z.morphAttributes;if((di.position!==void 0||di.normal!==void 0||di.color!==void 0)&&et.update(N,z,si),(ri||It.receiveShadow!==N.receiveShadow)&&(It.receiveShadow=N.receiveShadow,_e.setValue(A,"receiveShadow",N.receiveShadow)),H.isMeshGouraudMaterial&&H.envMap!==null&&(ui.envMap.value=ft,ui.flipEnvMap.value=ft.isCubeTexture&&ft.isRenderTargetTexture===!1?-1:1),H.isMeshStandardMaterial&&H.envMap===null&&U.environment!==null&&(ui.envMapIntensity.value=U.environmentIntensity),ri&&(_e.setValue(A,"toneMappingExposure",S.toneMappingExposure),It.needsLights&&kf(ui,Ds),tt&&H.fog===!0&&j.refreshFogUniforms(ui,tt),j.refreshMaterialUniforms(ui,H,G,st,f.state.transmissionRenderTarget[M.id]),Ps.upload(A,Dh(It),ui,Gt)),H.isShaderMaterial&&H.uniformsNeedUpdate===!0&&(Ps.upload(A,Dh(It),ui,Gt),H.uniformsNeedUpdate=!1),H.isSpriteMaterial&&_e.setValue(A,"center",N.center),_e.setValue(A,"modelViewMatrix",N.modelViewMatrix),_e.setValue(A,"normalMatrix",N.normalMatrix),_e.setValue(A,"modelMatrix",N.matrixWorld),H.isShaderMaterial||H.isRawShaderMaterial){let $e=H.uniformsGroups;for(let ti=0,Ol=$e.length;ti<Ol;ti++){let Sn=$e[ti];Vt.update(Sn,si),Vt.bind(Sn,si)}}return si}function kf(M,U){M.ambientLightColor.needsUpdate=U,M.lightProbe.needsUpdate=U,M.directionalLights.needsUpdate=U,M.directionalLightShadows.needsUpdate=U,M.pointLights.needsUpdate=U,M.pointLightShadows.needsUpdate=U,M.spotLights.needsUpdate=U,M.spotLightShadows.needsUpdate=U,M.rectAreaLights.needsUpdate=U,M.hemisphereLights.needsUpdate=U}function Bf(M){return M.isMeshLambertMaterial||M.isMeshToonMaterial||M.isMeshPhongMaterial||M.isMeshStandardMaterial||M.isShadowMaterial||M.isShaderMaterial&&M.lights===!0}this.getActiveCubeFace=function(){return P},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return k},this.setRenderTargetTextures=function(M,U,z){let H=bt.get(M);H.__autoAllocateDepthBuffer=M.resolveDepthBuffer===!1,H.__autoAllocateDepthBuffer===!1&&(H.__useRenderToTexture=!1),bt.get(M.texture).__webglTexture=U,bt.get(M.depthTexture).__webglTexture=H.__autoAllocateDepthBuffer?void 0:z,H.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(M,U){let z=bt.get(M);z.__webglFramebuffer=U,z.__useDefaultFramebuffer=U===void 0};let zf=A.createFramebuffer();this.setRenderTarget=function(M,U=0,z=0){k=M,P=U,D=z;let H=!0,N=null,tt=!1,ht=!1;if(M){let ft=bt.get(M);if(ft.__useDefaultFramebuffer!==void 0)xt.bindFramebuffer(A.FRAMEBUFFER,null),H=!1;else if(ft.__webglFramebuffer===void 0)Gt.setupRenderTarget(M);else if(ft.__hasExternalTextures)Gt.rebindTextures(M,bt.get(M.texture).__webglTexture,bt.get(M.depthTexture).__webglTexture);else if(M.depthBuffer){let Ct=M.depthTexture;if(ft.__boundDepthTexture!==Ct){if(Ct!==null&&bt.has(Ct)&&(M.width!==Ct.image.width||M.height!==Ct.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");Gt.setupDepthRenderbuffer(M)}}let Lt=M.texture;(Lt.isData3DTexture||Lt.isDataArrayTexture||Lt.isCompressedArrayTexture)&&(ht=!0);let Nt=bt.get(M).__webglFramebuffer;M.isWebGLCubeRenderTarget?(Array.isArray(Nt[U])?N=Nt[U][z]:N=Nt[U],tt=!0):M.samples>0&&Gt.useMultisampledRTT(M)===!1?N=bt.get(M).__webglMultisampledFramebuffer:Array.isArray(Nt)?N=Nt[z]:N=Nt,C.copy(M.viewport),B.copy(M.scissor),V=M.scissorTest}else C.copy(Rt).multiplyScalar(G).floor(),B.copy($t).multiplyScalar(G).floor(),V=le;if(z!==0&&(N=zf),xt.bindFramebuffer(A.FRAMEBUFFER,N)&&H&&xt.drawBuffers(M,N),xt.viewport(C),xt.scissor(B),xt.setScissorTest(V),tt){let ft=bt.get(M.texture);A.framebufferTexture2D(A.FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.TEXTURE_CUBE_MAP_POSITIVE_X+U,ft.__webglTexture,z)}else if(ht){let ft=U;for(let Lt=0;Lt<M.textures.length;Lt++){let Nt=bt.get(M.textures[Lt]);A.framebufferTextureLayer(A.FRAMEBUFFER,A.COLOR_ATTACHMENT0+Lt,Nt.__webglTexture,z,ft)}}else if(M!==null&&z!==0){let ft=bt.get(M.texture);A.framebufferTexture2D(A.FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.TEXTURE_2D,ft.__webglTexture,z)}x=-1},this.readRenderTargetPixels=function(M,U,z,H,N,tt,ht,_t=0){if(!(M&&M.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ft=bt.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&ht!==void 0&&(ft=ft[ht]),ft){xt.bindFramebuffer(A.FRAMEBUFFER,ft);try{let Lt=M.textures[_t],Nt=Lt.format,Ct=Lt.type;if(!Ut.textureFormatReadable(Nt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Ut.textureTypeReadable(Ct)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}U>=0&&U<=M.width-H&&z>=0&&z<=M.height-N&&(M.textures.length>1&&A.readBuffer(A.COLOR_ATTACHMENT0+_t),A.readPixels(U,z,H,N,Et.convert(Nt),Et.convert(Ct),tt))}finally{let Lt=k!==null?bt.get(k).__webglFramebuffer:null;xt.bindFramebuffer(A.FRAMEBUFFER,Lt)}}},this.readRenderTargetPixelsAsync=async function(M,U,z,H,N,tt,ht,_t=0){if(!(M&&M.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ft=bt.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&ht!==void 0&&(ft=ft[ht]),ft)if(U>=0&&U<=M.width-H&&z>=0&&z<=M.height-N){xt.bindFramebuffer(A.FRAMEBUFFER,ft);let Lt=M.textures[_t],Nt=Lt.format,Ct=Lt.type;if(!Ut.textureFormatReadable(Nt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Ut.textureTypeReadable(Ct))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Zt=A.createBuffer();A.bindBuffer(A.PIXEL_PACK_BUFFER,Zt),A.bufferData(A.PIXEL_PACK_BUFFER,tt.byteLength,A.STREAM_READ),M.textures.length>1&&A.readBuffer(A.COLOR_ATTACHMENT0+_t),A.readPixels(U,z,H,N,Et.convert(Nt),Et.convert(Ct),0);let se=k!==null?bt.get(k).__webglFramebuffer:null;xt.bindFramebuffer(A.FRAMEBUFFER,se);let ve=A.fenceSync(A.SYNC_GPU_COMMANDS_COMPLETE,0);return A.flush(),await Fd(A,ve,4),A.bindBuffer(A.PIXEL_PACK_BUFFER,Zt),A.getBufferSubData(A.PIXEL_PACK_BUFFER,0,tt),A.deleteBuffer(Zt),A.deleteSync(ve),tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(M,U=null,z=0){let H=Math.pow(2,-z),N=Math.floor(M.image.width*H),tt=Math.floor(M.image.height*H),ht=U!==null?U.x:0,_t=U!==null?U.y:0;Gt.setTexture2D(M,0),A.copyTexSubImage2D(A.TEXTURE_2D,z,0,0,ht,_t,N,tt),xt.unbindTexture()};let Hf=A.createFramebuffer(),Vf=A.createFramebuffer();this.copyTextureToTexture=function(M,U,z=null,H=null,N=0,tt=null){tt===null&&(N!==0?(vs("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),tt=N,N=0):tt=0);let ht,_t,ft,Lt,Nt,Ct,Zt,se,ve,ue=M.isCompressedTexture?M.mipmaps[tt]:M.image;if(z!==null)ht=z.max.x-z.min.x,_t=z.max.y-z.min.y,ft=z.isBox3?z.max.z-z.min.z:1,Lt=z.min.x,Nt=z.min.y,Ct=z.isBox3?z.min.z:0;else{let di=Math.pow(2,-N);ht=Math.floor(ue.width*di),_t=Math.floor(ue.height*di),M.isDataArrayTexture?ft=ue.depth:M.isData3DTexture?ft=Math.floor(ue.depth*di):ft=1,Lt=0,Nt=0,Ct=0}H!==null?(Zt=H.x,se=H.y,ve=H.z):(Zt=0,se=0,ve=0);let oe=Et.convert(U.format),It=Et.convert(U.type),ge;U.isData3DTexture?(Gt.setTexture3D(U,0),ge=A.TEXTURE_3D):U.isDataArrayTexture||U.isCompressedArrayTexture?(Gt.setTexture2DArray(U,0),ge=A.TEXTURE_2D_ARRAY):(Gt.setTexture2D(U,0),ge=A.TEXTURE_2D),A.pixelStorei(A.UNPACK_FLIP_Y_WEBGL,U.flipY),A.pixelStorei(A.UNPACK_PREMULTIPLY_ALPHA_WEBGL,U.premultiplyAlpha),A.pixelStorei(A.UNPACK_ALIGNMENT,U.unpackAlignment);let Qt=A.getParameter(A.UNPACK_ROW_LENGTH),si=A.getParameter(A.UNPACK_IMAGE_HEIGHT),$n=A.getParameter(A.UNPACK_SKIP_PIXELS),ri=A.getParameter(A.UNPACK_SKIP_ROWS),Ds=A.getParameter(A.UNPACK_SKIP_IMAGES);A.pixelStorei(A.UNPACK_ROW_LENGTH,ue.width),A.pixelStorei(A.UNPACK_IMAGE_HEIGHT,ue.height),A.pixelStorei(A.UNPACK_SKIP_PIXELS,Lt),A.pixelStorei(A.UNPACK_SKIP_ROWS,Nt),A.pixelStorei(A.UNPACK_SKIP_IMAGES,Ct);let _e=M.isDataArrayTexture||M.isData3DTexture,ui=U.isDataArrayTexture||U.isData3DTexture;if(M.isDepthTexture){let di=bt.get(M),$e=bt.get(U),ti=bt.get(di.__renderTarget),Ol=bt.get($e.__renderTarget);xt.bindFramebuffer(A.READ_FRAMEBUFFER,ti.__webglFramebuffer),xt.bindFramebuffer(A.DRAW_FRAMEBUFFER,Ol.__webglFramebuffer);for(let Sn=0;Sn<ft;Sn++)_e&&(A.framebufferTextureLayer(A.READ_FRAMEBUFFER,A.COLOR_ATTACHMENT0,bt.get(M).__webglTexture,N,Ct+Sn),A.framebufferTextureLayer(A.DRAW_FRAMEBUFFER,A.COLOR_ATTACHMENT0,bt.get(U).__webglTexture,tt,ve+Sn)),A.blitFramebuffer(Lt,Nt,ht,_t,Zt,se,ht,_t,A.DEPTH_BUFFER_BIT,A.NEAREST);xt.bindFramebuffer(A.READ_FRAMEBUFFER,null),xt.bindFramebuffer(A.DRAW_FRAMEBUFFER,null)}else if(N!==0||M.isRenderTargetTexture||bt.has(M)){let di=bt.get(M),$e=bt.get(U);xt.bindFramebuffer(A.READ_FRAMEBUFFER,Hf),xt.bindFramebuffer(A.DRAW_FRAMEBUFFER,Vf);for(let ti=0;ti<ft;ti++)_e?A.framebufferTextureLayer(A.READ_FRAMEBUFFER,A.COLOR_ATTACHMENT0,di.__webglTexture,N,Ct+ti):A.framebufferTexture2D(A.READ_FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.TEXTURE_2D,di.__webglTexture,N),ui?A.framebufferTextureLayer(A.DRAW_FRAMEBUFFER,A.COLOR_ATTACHMENT0,$e.__webglTexture,tt,ve+ti):A.framebufferTexture2D(A.DRAW_FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.TEXTURE_2D,$e.__webglTexture,tt),N!==0?A.blitFramebuffer(Lt,Nt,ht,_t,Zt,se,ht,_t,A.COLOR_BUFFER_BIT,A.NEAREST):ui?A.copyTexSubImage3D(ge,tt,Zt,se,ve+ti,Lt,Nt,ht,_t):A.copyTexSubImage2D(ge,tt,Zt,se,Lt,Nt,ht,_t);xt.bindFramebuffer(A.READ_FRAMEBUFFER,null),xt.bindFramebuffer(A.DRAW_FRAMEBUFFER,null)}else ui?M.isDataTexture||M.isData3DTexture?A.texSubImage3D(ge,tt,Zt,se,ve,ht,_t,ft,oe,It,ue.data):U.isCompressedArrayTexture?A.compressedTexSubImage3D(ge,tt,Zt,se,ve,ht,_t,ft,oe,ue.data):A.texSubImage3D(ge,tt,Zt,se,ve,ht,_t,ft,oe,It,ue):M.isDataTexture?A.texSubImage2D(A.TEXTURE_2D,tt,Zt,se,ht,_t,oe,It,ue.data):M.isCompressedTexture?A.compressedTexSubImage2D(A.TEXTURE_2D,tt,Zt,se,ue.width,ue.height,oe,ue.data):A.texSubImage2D(A.TEXTURE_2D,tt,Zt,se,ht,_t,oe,It,ue);A.pixelStorei(A.UNPACK_ROW_LENGTH,Qt),A.pixelStorei(A.UNPACK_IMAGE_HEIGHT,si),A.pixelStorei(A.UNPACK_SKIP_PIXELS,$n),A.pixelStorei(A.UNPACK_SKIP_ROWS,ri),A.pixelStorei(A.UNPACK_SKIP_IMAGES,Ds),tt===0&&U.generateMipmaps&&A.generateMipmap(ge),xt.unbindTexture()},this.initRenderTarget=function(M){bt.get(M).__webglFramebuffer===void 0&&Gt.setupRenderTarget(M)},this.initTexture=function(M){M.isCubeTexture?Gt.setTextureCube(M,0):M.isData3DTexture?Gt.setTexture3D(M,0):M.isDataArrayTexture||M.isCompressedArrayTexture?Gt.setTexture2DArray(M,0):Gt.setTexture2D(M,0),xt.unbindTexture()},this.resetState=function(){P=0,D=0,k=null,xt.reset(),ct.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Mi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Jt._getDrawingBufferColorSpace(t),e.unpackColorSpace=Jt._getUnpackColorSpace()}};var mf={type:"change"},bh={type:"start"},_f={type:"end"},gl=new mn,gf=new Ke,G0=Math.cos(70*Qc.DEG2RAD),Ie=new F,ni=2*Math.PI,re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},xh=1e-6,_l=class extends Tr{constructor(t,e=null){super(t,e),this.state=re.NONE,this.target=new F,this.cursor=new F,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:vn.ROTATE,MIDDLE:vn.DOLLY,RIGHT:vn.PAN},this.touches={ONE:yn.ROTATE,TWO:yn.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new F,this._lastQuaternion=new mi,this._lastTargetPosition=new F,this._quat=new mi().setFromUnitVectors(t.up,new F(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ws,this._sphericalDelta=new ws,this._scale=1,this._panOffset=new F,this._rotateStart=new zt,this._rotateEnd=new zt,this._rotateDelta=new zt,this._panStart=new zt,this._panEnd=new zt,this._panDelta=new zt,this._dollyStart=new zt,this._dollyEnd=new zt,this._dollyDelta=new zt,this._dollyDirection=new F,this._mouse=new zt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=X0.bind(this),this._onPointerDown=W0.bind(this),this._onPointerUp=q0.bind(this),this._onContextMenu=Q0.bind(this),this._onMouseWheel=Z0.bind(this),this._onKeyDown=K0.bind(this),this._onTouchStart=j0.bind(this),this._onTouchMove=J0.bind(this),this._onMouseDown=Y0.bind(this),this._onMouseMove=$0.bind(this),this._interceptControlDown=tx.bind(this),this._interceptControlUp=ex.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(mf),this.update(),this.state=re.NONE}update(t=null){let e=this.object.position;Ie.copy(e).sub(this.target),Ie.applyQuaternion(this._quat),this._spherical.setFromVector3(Ie),this.autoRotate&&this.state===re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ni:i>Math.PI&&(i-=ni),s<-Math.PI?s+=ni:s>Math.PI&&(s-=ni),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Ie.setFromSpherical(this._spherical),Ie.applyQuaternion(this._quatInverse),e.copy(this.target).add(Ie),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Ie.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new F(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new F(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Ie.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(gl.origin.copy(this.object.position),gl.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(gl.direction))<G0?this.object.lookAt(this.target):(gf.setFromNormalAndCoplanarPoint(this.object.up,this.target),gl.intersectPlane(gf,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>xh||8*(1-this._lastQuaternion.dot(this.object.quaternion))>xh||this._lastTargetPosition.distanceToSquared(this.target)>xh?(this.dispatchEvent(mf),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ni/60*this.autoRotateSpeed*t:ni/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Ie.setFromMatrixColumn(e,0),Ie.multiplyScalar(-t),this._panOffset.add(Ie)}_panUp(t,e){this.screenSpacePanning===!0?Ie.setFromMatrixColumn(e,1):(Ie.setFromMatrixColumn(e,0),Ie.crossVectors(this.object.up,Ie)),Ie.multiplyScalar(t),this._panOffset.add(Ie)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Ie.copy(s).sub(this.target);let r=Ie.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientX),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ni*this._rotateDelta.x/e.clientHeight),this._rotateUp(ni*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ni*this._rotateDelta.x/e.clientHeight),this._rotateUp(ni*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new zt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function W0(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n)))}function X0(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function q0(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(_f),this.state=re.NONE;break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function Y0(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case vn.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=re.DOLLY;break;case vn.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=re.ROTATE}break;case vn.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=re.PAN}break;default:this.state=re.NONE}this.state!==re.NONE&&this.dispatchEvent(bh)}function $0(n){switch(this.state){case re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function Z0(n){this.enabled===!1||this.enableZoom===!1||this.state!==re.NONE||(n.preventDefault(),this.dispatchEvent(bh),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(_f))}function K0(n){this.enabled!==!1&&this._handleKeyDown(n)}function j0(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case yn.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(n),this.state=re.TOUCH_ROTATE;break;case yn.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(n),this.state=re.TOUCH_PAN;break;default:this.state=re.NONE}break;case 2:switch(this.touches.TWO){case yn.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=re.TOUCH_DOLLY_PAN;break;case yn.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=re.TOUCH_DOLLY_ROTATE;break;default:this.state=re.NONE}break;default:this.state=re.NONE}this.state!==re.NONE&&this.dispatchEvent(bh)}function J0(n){switch(this._trackPointer(n),this.state){case re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=re.NONE}}function Q0(n){this.enabled!==!1&&n.preventDefault()}function tx(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function ex(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function vf(){let n=document.createElement("canvas");n.width=n.height=64;let t=n.getContext("2d");return t.fillStyle="#fff",t.beginPath(),t.arc(32,32,30,0,7),t.fill(),new vr(n)}function _i(n){return new Me().setAttribute("position",new be(n,3))}function yf(n){let t=[0,1,0,2,0,3,0,4,1,2,2,3,3,4,4,1],e=n.length/15,i=new Float32Array(e*t.length*3);for(let s=0;s<e;s++)t.forEach((r,o)=>{let a=15*s+3*r;i.set(n.subarray(a,a+3),3*(s*t.length+o))});return i}function xf(n){let t=new gr(new wr(1,16,12),new Mr({color:11883306,transparent:!0,opacity:.45,depthWrite:!1}),n);return t.frustumCulled=!1,t}function bf(n,t,e,i,s){let r=new ae;for(let o=0;o<e.length;o++){let a=i.subarray(9*o,9*o+9),l=3*e[o];r.set(a[0]*s,a[3]*s,a[6]*s,t[l],a[1]*s,a[4]*s,a[7]*s,t[l+1],a[2]*s,a[5]*s,a[8]*s,t[l+2],0,0,0,1),n.setMatrixAt(o,r)}n.instanceMatrix.needsUpdate=!0}function wh(n,t,e,i,s,r=9,o=()=>!0){let a=new ae().multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse).elements,l=null,c=r*r;for(let h=0;h<n.length;h+=t){let d=n[h],p=n[h+1],m=n[h+2],v=a[3]*d+a[7]*p+a[11]*m+a[15];if(v<=0)continue;let b=((a[0]*d+a[4]*p+a[8]*m+a[12])/v+1)/2*i.width-s[0],g=(1-(a[1]*d+a[5]*p+a[9]*m+a[13])/v)/2*i.height-s[1],f=b*b+g*g;f<c&&o(d,p,m)&&(c=f,l=h/t)}return l}var vl=class{constructor(t,e){this.boxes=new Map;this.select=u("select",{id:"space-colour"},...xe(["role","rays","sigma","w","redundancy","residual"],t=>_("studio_space.colouring",{by:t})));this.scale=u("input",{type:"range",id:"ellipsoid-scale",min:-20,max:20,value:0});this.scaleWords=u("output",{for:"ellipsoid-scale"});this.typicalSize=1;let i=(s,r)=>{let o=u("input",{type:"checkbox",id:`show-${s}`,checked:r});return o.addEventListener("change",t),this.boxes.set(s,o),u("label",{},o,_("studio_space.shown",{name:s}))};this.select.addEventListener("change",t),this.scale.addEventListener("input",()=>{this.showScale(),t()}),this.parts=[u("label",{},_("studio_space.colour"),this.select),i("points",!0),i("stations",!0),i("bars",!0),i("ellipsoids",!1),u("label",{title:_("studio_space.enlargement")},"\xD7",this.scale,this.scaleWords),yt("studio_space.all",e)]}shows(t){return this.boxes.get(t).checked}get colouring(){return this.select.value}set typical(t){this.typicalSize=t,this.showScale()}get enlarged(){return this.typicalSize*10**(Number(this.scale.value)/10)}showScale(){this.scaleWords.textContent=oi(String(Number(this.enlarged.toPrecision(2))))}};var ix={f4:Float32Array,u1:Uint8Array,u2:Uint16Array,u4:Uint32Array},yl=class{constructor(t){this.rows=null;let e=new DataView(t).getUint32(0,!0);this.head=JSON.parse(new TextDecoder().decode(new Uint8Array(t,4,e)));let i=new Map,s=4+e;for(let{name:o,kind:a,shape:l}of this.head.arrays){let c=ix[a],h=l.reduce((d,p)=>d*p,1);i.set(o,new c(t,s,h)),s+=Math.ceil(h*c.BYTES_PER_ELEMENT/4)*4}let r=(o,a)=>i.get(o)??a;this.xyz=r("xyz",new Float32Array(0)),this.role=r("role",new Uint8Array(0)),this.rays=r("rays",new Uint16Array(0)),this.sigma=r("sigma",new Float32Array(0)),this.w=r("w",new Float32Array(0)),this.r=r("r",new Float32Array(0)),this.v=r("v",new Float32Array(0)),this.centre=r("centre",new Float32Array(0)),this.ellipsoid=r("ellipsoid_of",new Uint32Array(0)),this.axes=r("ellipsoid",new Float32Array(0)),this.bars=r("bars",new Uint32Array(0)),this.pairs=r("pair",new Uint32Array(0)),this.common=r("common",new Uint32Array(0)),this.frusta=this.pyramids(r("frustum",new Float32Array(0)))}pyramids(t){let e=new Float32Array(5*this.centre.length);for(let i=0;i<this.centre.length/3;i++)e.set(this.centre.subarray(3*i,3*i+3),15*i),e.set(t.subarray(12*i,12*i+12),15*i+3);return e}get points(){return this.role.length}nameOf(t){return this.head.names[t]??""}rowOf(t){return this.rows??=new Map(this.head.names.map((e,i)=>[e,i])),this.rows.get(t)}centreOf(t){let e=this.head.image_ids.indexOf(t);return e<0?null:this.centre.subarray(3*e,3*e+3)}at(t){return this.xyz.subarray(3*t,3*t+3)}};var nx=["","coordinates","distance","angle","area","length","plane","line","to_plane","to_line"],Mh=6,wf=n=>_("studio_space.quantity",{kind:n||"any"}),xl=class{constructor(t,e){this.changed=e;this.names=[];this.words="";this.box=u("input",{type:"checkbox",id:"space-measure"});this.kind=u("select",{id:"space-kind","aria-label":_("studio_space.measured")},...xe(nx,wf));this.turn=0;this.box.addEventListener("change",()=>this.clear()),this.kind.addEventListener("change",()=>void this.answer()),this.parts=[u("span",{class:"group"},u("label",{title:Be("studio_space.measure")},this.box,_("studio_space.measure")),this.kind,yt("studio_space.add_current",()=>t.current&&this.add(t.current)),yt("studio_space.clear",()=>this.clear()))]}get on(){return this.box.checked}get closed(){return this.what==="area"}get what(){let t=this.names.length;return this.kind.value||(t===1?"coordinates":t===2?"distance":t===3?"angle":"area")}take(t){this.names.some(e=>t.rowOf(e)===void 0)&&this.clear()}add(t){this.names=this.names.includes(t)?this.names.filter(e=>e!==t):[...this.names,t],this.answer()}clear(){this.names=[],this.words=this.on?_("studio_space.click_points"):_("studio_space.click"),this.changed()}async answer(){let t=++this.turn;if(this.words=this.names.join(", "),this.changed(),!!this.names.length){try{let e=await Pt("/api/query",{kind:this.what,points:this.names});if(t!==this.turn)return;let i=e.values.map(({name:r,value:o,sigma:a,unit:l})=>{let c=`${pt(o,ke(a))} \xB1 ${pt(a,ke(a))}`;return`${e.values.length>1?`${r} `:""}${ye(c,l.replace("^2","\xB2").replace("deg","\xB0"))}`}),s=i.length>Mh?` (+${i.length-Mh})`:"";this.words=`${wf(this.what)} ${this.names.join(", ")}: ${i.slice(0,Mh).join("; ")}${s}${e.remark?`
${e.remark}`:""}`}catch(e){if(t!==this.turn)return;this.words=`${this.names.join(", ")}: ${e.message}`}this.changed()}}};var Mf=100,Sf=["#882255","#ddaa33","#0072b2"],bl=class{constructor(t){this.changed=t;this.lines=new tn(new Me,new Ai({vertexColors:!0}));this.box=u("input",{type:"checkbox",id:"show-pairs"});this.least=u("input",{type:"range",id:"pairs-least",min:0,max:Mf,value:0,"aria-label":_("studio_space.fewest")});this.words=u("output",{for:"pairs-least"});this.data=null;for(let e of[this.box,this.least])e.addEventListener("input",()=>this.show());this.parts=[u("span",{class:"group"},u("label",{title:Be("studio_space.pairs")},this.box,_("studio_space.pairs")),this.least,this.words)],this.lines.frustumCulled=!1,this.showFewest()}take(t){this.data=t;let{pairs:e,common:i,centre:s,head:r}=t,o=new Float32Array(3*e.length),a=new Float32Array(3*e.length),l=Sf.map(c=>new Ot(c));e.forEach((c,h)=>{let d=i[h>>1];o.set(s.subarray(3*c,3*c+3),3*h),l[d<r.few?0:d<r.strong?1:2].toArray(a,3*h)}),this.lines.geometry.dispose(),this.lines.geometry=_i(o).setAttribute("color",new be(a,3)),this.show()}get legend(){if(!this.box.checked||!this.data)return[];let{few:t,strong:e}=this.data.head,i=[0,0,0];for(let r=0;r<this.drawn;r++)i[this.data.common[r]<t?0:this.data.common[r]<e?1:2]++;let s=[_("studio_space.weak_pairs",{limit:t}),`${t}\u2013${e-1}`,`\u2265 ${e}`];return Sf.map((r,o)=>[r,`${s[o]}: ${fi(i[o])}`])}get fewest(){return Math.round(Math.max(this.data?.common[0]??1,1)**(Number(this.least.value)/Mf))}get drawn(){let{common:t}=this.data,[e,i]=[0,t.length];for(;e<i;){let s=e+i>>1;t[s]>=this.fewest?e=s+1:i=s}return e}show(){this.lines.visible=this.box.checked,this.data&&this.lines.geometry.setDrawRange(0,2*this.drawn),this.showFewest(),this.changed()}showFewest(){this.words.textContent=`\u2265 ${fi(this.fewest)}`,this.least.setAttribute("aria-valuetext",String(this.fewest))}};var wl=["#4f7896","#d55e00","#007f5f"],Nr=["#20406e","#2f86b0","#7fb79a","#e69f00","#c2410c"],Ef="#9aa3ab";function Af(n,t){return t==="role"?sx(n):t==="rays"?Fr(n.rays,[2,3,5,9],[...Nr].reverse(),[_("studio_space.few_rays"),"3","4\u20135","6\u20139","\u2265 10"]):t==="w"?Fr(n.w,[1,2,2.6,3.3],Nr,Sh(t,"",["1","2","2.6","3.3"])):t==="redundancy"?Fr(n.r,[.1,.3,.5,.7],[...Nr].reverse(),Sh(t,"",["0.1","0.3","0.5","0.7"])):t==="residual"?Tf(n.v,t,"px"):Tf(n.sigma,t,n.head.unit)}function sx(n){let t=Eh(wl),e=new Uint32Array(n.points);for(let s=0;s<n.points;s++)e[s]=t[Math.min(n.role[s],2)];let i=["tie","control","check"];return{rgb:new Uint8Array(e.buffer),legend:i.map((s,r)=>[wl[r],_("studio_space.role",{role:s})]).filter((s,r)=>n.role.includes(r))}}function Tf(n,t,e){let i=n.filter(r=>r>0).sort();if(!i.length)return Fr(n,[0,0,0,0],Nr,[]);let s=[.2,.4,.6,.8].map(r=>i[Math.floor(r*(i.length-1))]);return Fr(n,s,Nr,Sh(t,e,s.map(r=>Mt(r,2))))}function Sh(n,t,e){let i=e.map(s=>ye(oi(s),t));return[_("studio_space.up_to",{by:n,limit:i[0]}),...i.slice(1).map(s=>`\u2264 ${s}`),`> ${i[3]}`]}function Fr(n,t,e,i){let s=Eh(e),[r]=Eh([Ef]),o=new Uint32Array(n.length),a=!1;for(let c=0;c<n.length;c++){let h=n[c];h>=0||(a=!0);let d=0;for(;d<t.length&&h>t[d];)d++;o[c]=h>=0?s[d]:r}let l=i.map((c,h)=>[e[h],c]);return{rgb:new Uint8Array(o.buffer),legend:a?[...l,[Ef,_("studio_space.unknown")]]:l}}function Eh(n){let t=new Uint8Array(4*n.length).fill(255);return n.forEach((e,i)=>{let{r:s,g:r,b:o}=new Ot(e);t.set([s,r,o].map(a=>Math.round(255*a)),4*i)}),new Uint32Array(t.buffer)}var Ml=class{constructor(t,e){this.data=t;this.scene=new pr;this.specialRows=[];let i=vf(),s=(l,c={vertexColors:!0})=>new Bn({size:l*Math.min(devicePixelRatio,2),map:i,alphaTest:.4,sizeAttenuation:!1,...c});for(let l=0;l<t.points;l++)t.role[l]>0&&this.specialRows.push(l);let r=t.points>6e4,o=new Bn({size:2*Math.min(devicePixelRatio,2),sizeAttenuation:!1,vertexColors:!0});this.points=new ki(_i(t.xyz),r?o:s(4)),this.points.geometry.setIndex(new be(rx(t.points),1)),this.special=new ki(_i(this.picked(t.xyz)),s(11)),this.stations=new tn(_i(yf(t.frusta)),new Ai({color:2767433})),this.ellipsoids=xf(t.ellipsoid.length),this.bars=new tn(_i(this.rowsOf(t.bars)),new Ai({color:32607,linewidth:2})),this.rays=new tn(new Me,new Ai({color:5974662})),this.mark=new ki(new Me,s(14,{color:13385103,depthTest:!1})),this.measured=new kn(new Me,new Ai({color:1118481,depthTest:!1})),this.ends=new ki(new Me,s(10,{color:1118481,depthTest:!1})),this.beyond=new ki(new Me,s(8,{color:12720271,depthTest:!1}));for(let l of[this.rays,this.mark,this.measured,this.ends,this.beyond])l.frustumCulled=!1;this.scene.background=new Ot(16250352),this.scene.add(new Er(16777215,10129280,3),this.points,this.special,this.stations,this.ellipsoids,this.bars,this.rays,this.mark,this.measured,this.ends,this.beyond,e);let a=t.sigma.filter(l=>l>0).sort();this.typical=a.length?.012*t.head.extent/a[Math.floor(a.length/2)]:1,this.enlarge(this.typical)}picked(t){let e=new Float32Array(3*this.specialRows.length);return this.specialRows.forEach((i,s)=>e.set(t.subarray(3*i,3*i+3),3*s)),e}rowsOf(t){let e=new Float32Array(3*t.length);return t.forEach((i,s)=>e.set(this.data.at(i),3*s)),e}thin(t){this.points.geometry.setDrawRange(0,t<1?Math.ceil(t*this.data.points):1/0),this.ellipsoids.count=Math.ceil(t*this.data.ellipsoid.length)}colour(t){let{rgb:e,legend:i}=Af(this.data,t);this.points.geometry.setAttribute("color",new be(e,4,!0));let s=new Float32Array(3*this.specialRows.length),r=wl.map(o=>new Ot(o));return this.specialRows.forEach((o,a)=>r[Math.min(this.data.role[o],2)].toArray(s,3*a)),this.special.geometry.setAttribute("color",new be(s,3)),i}enlarge(t){bf(this.ellipsoids,this.data.xyz,this.data.ellipsoid,this.data.axes,t)}current(t,e){this.mark.geometry.dispose(),this.rays.geometry.dispose(),this.mark.geometry=t?_i(new Float32Array(t)):new Me;let i=t?e.map(r=>this.data.centreOf(r)).filter(r=>r!==null):[],s=new Float32Array(6*i.length);i.forEach((r,o)=>{s.set(Array.from(t),6*o),s.set(r,6*o+3)}),this.rays.geometry=_i(s)}cut(t){for(let e of[this.points,this.special,this.ellipsoids,this.bars])e.material.clippingPlanes=t}far(t){this.beyond.geometry.dispose(),this.beyond.geometry=_i(this.rowsOf(Uint32Array.from(t)))}between(t,e){let i=e&&t.length>2?[...t,t[0]]:t;this.measured.geometry.dispose(),this.ends.geometry.dispose(),this.measured.geometry=_i(this.rowsOf(Uint32Array.from(i))),this.ends.geometry=_i(this.rowsOf(Uint32Array.from(t)))}dispose(){this.scene.traverse(t=>{(t instanceof ki||t instanceof kn||t instanceof qe)&&(t.geometry.dispose(),t.material.dispose())})}};function rx(n){let t=new Uint32Array(n);for(let i=0;i<n;i++)t[i]=i;let e=1;for(let i=n-1;i>0;i--){e=Math.imul(e,1664525)+1013904223>>>0;let s=Math.floor(e/4294967296*(i+1));[t[i],t[s]]=[t[s],t[i]]}return t}var wn=200,ox={"":"none",0:"side",1:"front",2:"level",points:"points"},Sl=class{constructor(t,e){this.names=t;this.changed=e;this.across=u("select",{id:"section-across"},...xe(["","0","1","2","points"],t=>_("studio_space.across",{across:ox[t]})));this.place=u("input",{type:"range",id:"section-place",min:0,max:wn,value:wn/2,"aria-label":_("studio_space.section_place")});this.thick=u("input",{type:"range",id:"section-thickness",min:1,max:wn,value:wn/10,"aria-label":_("studio_space.section_thickness")});this.words=u("output",{for:"section-place section-thickness"});this.data=null;this.normal=new F;this.range=[0,0];this.begin=0;this.across.addEventListener("change",()=>this.turn());for(let i of[this.place,this.thick])i.addEventListener("input",()=>this.changed());this.parts=[u("span",{class:"group"},u("label",{title:Be("studio_space.section")},_("studio_space.section"),this.across),u("label",{title:_("studio_space.section_place")},"\u2194",this.place),u("label",{title:_("studio_space.section_thickness")},"\u2195",this.thick),this.words)],this.place.disabled=this.thick.disabled=!0}take(t){this.data=t,this.turn()}get planes(){if(!this.on)return[];let{middle:t,half:e}=this;return[new Ke(this.normal.clone(),e-t),new Ke(this.normal.clone().negate(),e+t)]}measured(){this.across.value==="points"&&!this.on&&this.turn()}holds(t,e,i){return this.on?Math.abs(this.normal.x*t+this.normal.y*e+this.normal.z*i-this.middle)<=this.half:!0}show(){let t=`\xB1 ${ye(Mt(this.half),this.data?.head.unit??"")}`;this.words.textContent=this.across.value?this.on?t:_("studio_space.three_points_first"):""}get on(){return this.across.value!==""&&this.normal.lengthSq()>0}get middle(){let[t,e]=this.range;return t+(e-t)*Number(this.place.value)/wn}get half(){let[t,e]=this.range;return Math.max(e-t,1e-12)*Number(this.thick.value)/wn/2}turn(){let t=this.across.value;for(let e of[this.place,this.thick])e.disabled=!t;this.normal.set(0,0,0),this.data&&t==="points"?this.throughPoints(this.data):this.data&&t&&this.normal.set(...this.data.head.basis.slice(3*Number(t),3*Number(t)+3)),this.data&&this.on&&this.ranged(this.data),this.changed()}throughPoints(t){let e=this.names().slice(0,3).map(i=>t.rowOf(i)).filter(i=>i!==void 0).map(i=>new F(...t.at(i)));if(!(e.length<3)){if(this.normal.crossVectors(e[1].clone().sub(e[0]),e[2].clone().sub(e[0])),this.normal.length()<1e-9*t.head.extent**2)return void this.normal.set(0,0,0);this.normal.normalize(),this.begin=this.normal.dot(e[0])}}ranged(t){let e=Math.max(Math.floor(t.points/2e4),1),i=[];for(let a=0;a<t.points;a+=e){let[l,c,h]=t.at(a);i.push(this.normal.x*l+this.normal.y*c+this.normal.z*h)}if(i.sort((a,l)=>a-l),this.range=i.length?[i[Math.floor(.01*i.length)],i[Math.ceil(.99*i.length)-1]]:[0,0],this.across.value!=="points")return;let[s,r]=this.range,o=Math.max(r-this.begin,this.begin-s,1e-9*t.head.extent);this.range=[this.begin-o,this.begin+o],this.place.value=String(wn/2),this.thick.value=String(wn/40)}};var Rf=10,ax=33,lx=3e4,cx=15e5;function hx(){let n=document.createElement("canvas").getContext("webgl2"),t=n?.getExtension("WEBGL_debug_renderer_info"),e=n?String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)):"";return n?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(e)}var El=class{constructor(t,e){this.model=t;this.open=e;this.box=nt("space");this.status=nt("space-status");this.tip=u("div",{class:"tip",hidden:!0});this.renderer=null;this.camera=new We(40,1,.01,1e3);this.drawn=null;this.stale=!0;this.frameSoon=vi(()=>this.frame());this.share=1;this.software=!1;this.coarse=!1;this.turning=!1;this.timed=!1;this.rest=Re(()=>this.still(),250);this.bar=new vl(()=>this.shown(),()=>this.home()),this.measure=new xl(t,()=>this.measured()),this.pairs=new bl(()=>this.shown()),this.section=new Sl(()=>this.measure.names,()=>this.cut()),nt("space-bar").append(...this.bar.parts,...this.measure.parts,...this.pairs.parts,...this.section.parts),t.on("read",()=>{this.stale=!0,nt("stage-space").hidden||this.show()}),ei.onchange(()=>this.far()),t.on(["current","prediction","state"],()=>this.current())}async show(){if(!(!this.renderer&&!this.begin())){if(this.stale){this.stale=!1;try{this.take(new yl(await Wr("/api/scene")))}catch(t){return this.stale=!0,this.model.fail(t)}}this.sized()}}begin(){this.software=hx();try{this.renderer=new pl({antialias:!this.software})}catch{return this.box.textContent=_("studio_space.no_graphics"),!1}this.renderer.localClippingEnabled=!0;let t=this.renderer.domElement;return t.tabIndex=0,t.setAttribute("role","application"),t.setAttribute("aria-label",_("studio_space.canvas")),this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.box.append(t,this.tip),this.controls=new _l(this.camera,t),this.controls.zoomToCursor=!0,this.controls.addEventListener("change",()=>this.moving()),new ResizeObserver(()=>this.sized()).observe(this.box),this.pointers(t),!0}take(t){let e=!this.drawn;this.drawn?.dispose(),this.drawn=new Ml(t,this.pairs.lines),this.measure.take(t),this.pairs.take(t),this.section.take(t);let{extent:i}=t.head;this.camera.near=i/1e3,this.camera.far=i*200,this.bar.typical=this.drawn.typical,e&&(this.share=this.software?Math.min(lx/Math.max(t.points,1),1):1),e&&this.home(),this.shown(),this.current(),this.far(),this.status.textContent=t.points<t.head.total?_("studio_space.points_shown",{n:t.points,of:t.head.total}):_("studio_space.click")}axis(t){return new F(...this.drawn.data.head.basis.slice(3*t,3*t+3))}home(){if(!this.drawn)return;let{extent:t}=this.drawn.data.head;this.camera.up.copy(this.axis(2)),this.camera.position.set(0,0,0).addScaledVector(this.axis(1),1.35*t).addScaledVector(this.axis(2),.45*t).addScaledVector(this.axis(0),.4*t),this.controls.target.set(0,0,0),this.controls.update(),this.render()}sized(){let{clientWidth:t,clientHeight:e}=this.box;!this.renderer||!t||!e||(this.renderer.setSize(t,e),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.frame())}render(){this.share<1&&(this.drawn?.thin(this.share),this.rest()),this.frameSoon()}frame(){!this.renderer||!this.drawn||nt("stage-space").hidden||(this.renderer.render(this.drawn.scene,this.camera),this.turning&&this.timing())}moving(){let t=this.box.clientWidth*this.box.clientHeight>cx;this.software&&t&&!this.coarse&&this.fine(!1),this.turning=!0,this.render(),this.rest()}timing(){let t=this.renderer.getContext(),e=t.fenceSync(t.SYNC_GPU_COMMANDS_COMPLETE,0);if(!e)return;if(this.timed)return t.deleteSync(e);this.timed=!0;let i=performance.now();t.flush();let s=()=>{if(t.getSyncParameter(e,t.SYNC_STATUS)!==t.SIGNALED)return void setTimeout(s,4);t.deleteSync(e),this.timed=!1;let r=ax/Math.max(performance.now()-i,1);this.share=Math.min(Math.max(this.share*Math.min(Math.max(r,.25),1.25),.005),1)};setTimeout(s,4)}fine(t){this.coarse=!t,this.renderer.setPixelRatio(t?Math.min(devicePixelRatio,2):.5)}still(){this.turning=!1,this.drawn?.thin(1),this.coarse&&this.fine(!0),this.frameSoon()}shown(){let{drawn:t,bar:e}=this;if(!t)return;let i=t.colour(e.colouring);t.points.visible=e.shows("points"),t.stations.visible=e.shows("stations"),t.ellipsoids.visible=e.shows("ellipsoids"),t.bars.visible=e.shows("bars"),t.ellipsoids.visible&&t.enlarge(e.enlarged),i.push(...this.pairs.legend),ei.points.size&&i.push(["#c2188f",_("studio_space.beyond",{n:ei.points.size})]),nt("space-legend").replaceChildren(...i.map(([s,r])=>{let o=u("span",{class:"dot"});return o.style.background=s,u("li",{},o,r)})),this.render()}cut(){this.section.show(),this.drawn?.cut(this.section.planes),this.render()}current(){let{drawn:t,model:e}=this;if(!t)return;let i=t.data.rowOf(e.current),s=e.prediction?.point===e.current?e.prediction?.located.xyz:null,r=s?s.map((o,a)=>o-t.data.head.origin[a]):i===void 0?null:t.data.at(i);t.current(e.current?r:null,e.marksOf(e.current).map(o=>o.image)),this.render()}far(){this.drawn&&(this.drawn.far([...ei.points].map(t=>this.drawn.data.rowOf(t)).filter(t=>t!==void 0)),this.shown())}measured(){if(!this.drawn)return;let t=this.measure.names.map(e=>this.drawn.data.rowOf(e)).filter(e=>e!==void 0);this.drawn.between(t,this.measure.closed),this.section.measured(),this.measure.words&&(this.status.textContent=this.measure.words),this.render()}pointers(t){let e=[0,0],i=!1,s=a=>{let l=t.getBoundingClientRect();return[a.clientX-l.left,a.clientY-l.top]};t.addEventListener("pointerdown",a=>{e=[a.clientX,a.clientY],i=!0,this.tip.hidden=!0}),t.addEventListener("pointerup",a=>{i=!1,Math.hypot(a.clientX-e[0],a.clientY-e[1])<4&&this.click(s(a))});let r=[0,0],o=vi(()=>this.hover(r));t.addEventListener("pointermove",a=>{r=s(a),i||o()}),t.addEventListener("pointerleave",()=>this.tip.hidden=!0),t.addEventListener("keydown",a=>this.key(a))}find(t){let{drawn:e,box:i}=this;if(!e)return{};let s={width:i.clientWidth,height:i.clientHeight},r=(l,c,h)=>this.section.holds(l,c,h),o=e.stations.visible?wh(e.data.centre,3,this.camera,s,t,Rf):null;if(o!==null)return{image:e.data.head.image_ids[o]};let a=e.points.visible?wh(e.data.xyz,3,this.camera,s,t,Rf,r):null;return a===null?{}:{row:a}}hover(t){let{image:e,row:i}=this.find(t);this.tip.hidden=e===void 0&&i===void 0,!this.tip.hidden&&(this.tip.textContent=e??this.words(i),this.tip.style.left=`${Math.min(t[0]+16,this.box.clientWidth-230)}px`,this.tip.style.top=`${Math.min(t[1]+14,this.box.clientHeight-70)}px`)}words(t){let{data:e}=this.drawn,i=e.head.unit;return _("studio_space.point",{name:e.nameOf(t)||"none",n:e.rays[t],sigma:e.sigma[t]>0?ye(Mt(e.sigma[t],2),i):"none",w:e.w[t]>=0?Mt(e.w[t],2):"none"})}click(t){let{image:e,row:i}=this.find(t);if(e!==void 0&&!this.measure.on)return this.open(e);if(i===void 0)return;let s=this.drawn.data.nameOf(i);s&&(this.measure.on?this.measure.add(s):(this.model.choose(s),this.status.textContent=this.words(i)))}key(t){let i={ArrowLeft:[1,0],ArrowRight:[-1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[t.key];if(i)this.turn(.1*i[0],.1*i[1]);else if(t.key==="+"||t.key==="=")this.closer(.85);else if(t.key==="-")this.closer(1.18);else if(t.key==="0")this.home();else return;t.preventDefault(),t.stopPropagation()}turn(t,e){let{target:i}=this.controls,s=this.camera.position.clone().sub(i),r=this.camera.up.clone().normalize();s.applyAxisAngle(r,-t);let o=r.clone().cross(s).normalize(),a=s.clone().applyAxisAngle(o,-e);a.clone().cross(r).length()>.05*a.length()&&s.copy(a),this.camera.position.copy(i).add(s),this.controls.update()}closer(t){let{target:e}=this.controls;this.camera.position.sub(e).multiplyScalar(t).add(e),this.controls.update()}};var Tl=class{constructor(t,e){this.model=t;this.goTo=e;t.on("overview",()=>this.show())}show(){let{standing:t}=this.model.overview,e=t.oriented<t.images||t.wrong.length>0||t.words.length>0,i=nt("standing");if(i.hidden=!e,!e)return;let s=new Set(t.wrong.map(a=>a.words)),r=new Set(t.lacking.filter(a=>a.kind==="marks"&&!a.have).map(a=>a.words)),o=t.words.filter(a=>!s.has(a)&&!r.has(a));i.replaceChildren(u("p",{id:"standing-line",class:t.oriented<t.images?"open":""},t.line.join("; ")),u("ul",{},...t.wrong.map(a=>u("li",{class:"wrong"},Xt(a.words,_("studio_point.show",{point:a.point}),()=>this.goTo(a.point,a.images[0]),"link"))),...o.map(a=>u("li",{},a))))}};var Al=class{constructor(t){this.open=t;this.root=u("section",{class:"leaf","aria-label":_("studio_product.part",{part:"files"}),hidden:!0})}async show(){}take(t){this.root.replaceChildren(...t.map(e=>this.folder(e))),t.length||this.root.append(u("p",{class:"note"},_("studio_product.no_files")))}folder({folder:t,files:e,more:i}){let s=e.map(o=>u("tr",{},u("th",{scope:"row"},u("a",{href:Th(o.path),target:"_blank",rel:"noopener"},o.name)),u("td",{},ux(o.bytes)),u("td",{},o.picture?yt("studio_product.show",()=>this.open(o.path)):""))),r=i?[u("p",{class:"note"},_("studio_product.more",{n:i}))]:[];return u("div",{class:"camera"},u("h3",{},t),u("table",{class:"figures-of"},u("tbody",{},...s)),...r)}},Th=n=>`/product/file/${n.split("/").map(encodeURIComponent).join("/")}`;function ux(n){return n<1e3?`${n} B`:n<1e6?`${pt(n/1e3,0)} kB`:`${pt(n/1e6,n<1e7?1:0)} MB`}var Rl=class{constructor(t,e){this.model=t;this.name=e;this.command=u("code",{class:"command"});this.go=yt("studio_product.make",()=>void this.make(),"main");this.stop=yt("studio_run.stop",()=>nt("stop").click());this.status=u("p",{class:"counts",role:"status","aria-live":"polite"});this.bar=u("progress",{max:1,value:0,"aria-label":_("studio_run.progress")});this.words=u("pre",{class:"printed",tabindex:0,"aria-label":_("studio_run.output")});this.field="";this.known=!1;this.form=new Li(`product-${e}`,i=>void this.send(i)),this.go.id=`make-${e}`,this.root=u("section",{class:"leaf","aria-label":_("studio_product.part",{part:e}),hidden:!0},u("p",{class:"note"},_("studio_product.about",{product:e})),u("div",{class:"deeds"},this.go,this.stop),this.status,this.bar,this.words,u("h3",{},_("studio_decide.command")),u("p",{},this.command),u("h3",{},_("studio_run.settings")),this.form.root),this.run(null)}async show(){this.known?await this.send(this.form.values()):this.take(await Pt("/api/product",{name:this.name})),this.known=!0}async drawn(t){await this.show(),await this.send({...this.form.values(),[this.field]:`'${t}'`})}take(t){this.form.fill(t.fields),this.command.textContent=t.command,this.field=t.drawn,t.run?.name===this.name&&this.run(t.run)}async send(t){try{this.take(await Ee("/api/product/settings",{name:this.name,values:t}))}catch(e){this.model.fail(e)}}async make(){try{let{run:t}=await Ee("/api/product/make",{name:this.name,values:this.form.values()});this.model.run=t,this.run(t)}catch(t){this.model.fail(t)}}run(t){let e=t?.outcome==="running";this.go.disabled=e,this.stop.disabled=!e,this.bar.hidden=!e,this.status.hidden=!t,this.words.hidden=!t?.words,t&&(this.bar.value=t.share,this.status.textContent=$l(t),this.words.textContent=t.outcome==="running"?t.words:`${t.command}

${t.words}`,this.words.classList.toggle("bad",t.outcome==="failed"),t.outcome==="done"&&this.show())}};var dx="surface_3d.html",Cl=class{constructor(){this.root=u("section",{class:"leaf whole","aria-label":_("studio_product.part",{part:"pages"}),hidden:!0});this.select=u("select",{id:"page-file"});this.note=u("p",{class:"note"},_("studio_product.no_files"));this.frame=Os(_("studio_product.part",{part:"pages"}));this.at="";this.select.addEventListener("change",()=>void this.show()),this.root.append(u("div",{class:"deeds"},u("label",{for:"page-file"},_("studio_product.page")),this.select),this.note,this.frame)}take(t){let e=t.flatMap(s=>s.files.filter(r=>r.page).map(r=>r.path)),i=e.includes(this.select.value)?this.select.value:e.find(s=>s.endsWith(dx))??e[0];this.select.replaceChildren(...e.map(s=>u("option",{value:s,selected:s===i},s))),this.select.disabled=this.frame.hidden=!e.length,this.note.hidden=!!e.length}async show(){!this.select.value||this.select.value===this.at||(this.at=this.select.value,this.frame.src=Th(this.at))}};var Pl=class{constructor(t,e,i,s){this.model=t;this.drawn=e;this.edit=i;this.kept=s;this.name=Fe("drawing-name",_("studio_product.name"),{maxlength:"200"});this.layer=Fe("drawing-layer",_("studio_product.layer"),{maxlength:"200"});this.note=Fe("drawing-note",_("studio_product.note"),{maxlength:"200"});this.rows=u("table",{id:"drawings","aria-label":_("studio_product.drawings")});this.surface="";let r=yt("studio_product.keep",()=>this.form.requestSubmit(),"main");r.id="drawing-keep",r.type="button",this.form=u("form",{class:"deeds",hidden:!0},this.name,this.layer,this.note,r),this.form.addEventListener("submit",o=>{o.preventDefault(),this.keep()}),this.root=u("div",{},this.form,this.rows),t.on("state",()=>this.show())}get here(){return this.model.state.drawings.filter(t=>t.surface===this.surface)}turn(t){this.surface=t,this.show()}offer(){let t=this.drawn();if(t&&this.form.hidden&&!this.name.value){let e=new Set(this.model.state.drawings.map(s=>s.drawing)),i=1;for(;e.has(_("studio_product.default_name",{shape:t.kind,n:i}));)i++;this.name.value=_("studio_product.default_name",{shape:t.kind,n:i}),this.layer.value||="lines"}this.form.hidden=!t}show(){this.rows.hidden=!this.here.length,this.rows.replaceChildren(...this.here.map(t=>u("tr",{},u("td",{},Xt(t.drawing,_("studio_product.edit",{name:t.drawing}),()=>this.again(t),"link")),u("td",{},t.layer),u("td",{},t.note),u("td",{},Xt("\u2715",_("studio_product.erase",{name:t.drawing}),()=>void this.model.act("erase",{drawing:t.drawing},"studio_product.erased",{name:t.drawing}),"small")))))}again(t){[this.name.value,this.layer.value,this.note.value]=[t.drawing,t.layer,t.note],this.edit(t)}async keep(){let t=this.drawn(),e=this.name.value.trim();if(!t)return;let i={drawing:e,...t,layer:this.layer.value.trim()||"lines",note:this.note.value.trim(),surface:this.surface};await this.model.act("draw",i,"studio_product.kept",{name:e})&&(this.name.value=this.note.value="",this.kept())}};var fx=.0016,Ah=["orthophoto.tif","heights.tif","facade.tif"],Cf=8,Pf="#1f5a96",If="#8a2be2",Il=class{constructor(t,e){this.model=t;this.drawn=e;this.root=u("section",{class:"leaf whole","aria-label":_("studio_product.part",{part:"plan"}),hidden:!0});this.select=u("select",{id:"plan-file","aria-label":_("studio_product.picture")});this.canvas=u("canvas",{id:"plan",tabindex:0,"aria-label":_("studio_product.part",{part:"plan"})});this.place=u("p",{class:"note",id:"plan-place",role:"status"});this.picture=null;this.files=[];this.left=0;this.top=0;this.scale=1;this.shown=null;this.turn=0;this.mode="";this.kind="area";this.corners=[];this.fetchSoon=Re(()=>void this.fetch(),120);this.valueSoon=Re(()=>void this.value(),120);this.at=null;this.modes=["area","line"].map(s=>{let r=yt("studio_product.draw",()=>this.begin(s),"",{shape:s});return r.id=`plan-${s}`,[s,r]}),this.uses=[["area","volume"],["line","section"]].map(([s,r])=>{let o=yt("studio_product.use",()=>this.drawn(r,this.text()),"main",{shape:s});return o.id=`plan-use-${s}`,[s,o]});let i=yt("studio_product.clear",()=>this.begin(""));i.id="plan-clear",this.select.addEventListener("change",()=>void this.open(this.select.value)),this.root.append(u("div",{class:"deeds"},u("label",{for:"plan-file"},_("studio_product.picture")),this.select,...this.modes.map(([,s])=>s),i,...this.uses.map(([,s])=>s),yt("studio_space.all",()=>this.whole())),this.canvas,this.place),this.kept=new Pl(t,()=>this.enough()?{kind:this.kind,corners:this.corners.map(s=>this.rounded(s))}:null,s=>this.again(s),()=>this.begin("")),this.root.append(this.kept.root),t.on("state",()=>this.paint()),this.listen(),new ResizeObserver(()=>this.resized()).observe(this.canvas),this.buttons()}get has(){return this.files.length>0}take(t){let e=t.flatMap(r=>r.files.filter(o=>o.picture).map(o=>o.path)),i=r=>(Ah.indexOf(r.split("/").pop())+Ah.length+1)%(Ah.length+1);this.files=e.sort((r,o)=>i(r)-i(o)||r.localeCompare(o));let s=this.select.value;this.select.replaceChildren(...this.files.map(r=>u("option",{value:r,selected:r===s},r))),this.select.disabled=!this.has,this.has||(this.place.textContent=_("studio_product.no_picture"))}async show(){this.has&&await this.open(this.select.value),this.resized()}async open(t){try{let e=this.picture;this.picture={...await Pt("/api/picture",{file:t}),path:t},this.select.value=t,this.shown=null;let i=this.picture,[s]=t.split("/");this.kept.turn(s==="surface"?s:`${s}/surface`),!(e&&e.width===i.width&&e.height===i.height&&String(e.place)===String(i.place))||e.path===i.path&&e.stamp!==i.stamp?(this.corners=[],this.whole()):this.fetchSoon(),this.buttons()}catch(e){this.model.fail(e)}}begin(t){this.mode=t,t&&(this.kind=t),this.corners=[],this.buttons(),this.paint(),this.canvas.focus()}buttons(){let t=!!this.picture?.place;for(let[e,i]of this.modes)i.disabled=!t,i.setAttribute("aria-pressed",String(e===this.mode));for(let[e,i]of this.uses)i.hidden=!this.picture?.path.startsWith("surface/")||e!==this.kind||!this.enough();this.kept.offer()}enough(){return!!this.picture?.place&&this.corners.length>=(this.kind==="area"?3:2)}again(t){this.picture?.place&&(this.begin(t.kind),this.corners=t.corners.map(i=>this.inPicture(i)),this.buttons(),this.paint())}inPicture([t,e]){let i=this.picture.place;return[(t-i[0])/i[2],(i[1]-e)/i[3]]}rounded(t){let e=this.decimals();return this.object(t).map(i=>Number(i.toFixed(e)))}decimals(){return Math.max(0,Math.ceil(-Math.log10(Math.abs(this.picture.place[2])))+1)}text(){return this.corners.map(t=>this.object(t).map(e=>e.toFixed(this.decimals())).join(" ")).join(", ")}object([t,e]){let i=this.picture?.place;return i?[i[0]+i[2]*t,i[1]-i[3]*e]:null}whole(){let t=this.picture;!t||!this.canvas.clientWidth||(this.scale=Math.min(this.canvas.clientWidth/t.width,this.canvas.clientHeight/t.height),this.left=(t.width-this.canvas.clientWidth/this.scale)/2,this.top=(t.height-this.canvas.clientHeight/this.scale)/2,this.paint(),this.fetchSoon())}resized(){let t=window.devicePixelRatio||1,[e,i]=[Math.round(this.canvas.clientWidth*t),Math.round(this.canvas.clientHeight*t)];if(!e||e===this.canvas.width&&i===this.canvas.height)return;let s=this.canvas.width===300;this.canvas.width=e,this.canvas.height=i,s||!this.shown?this.whole():this.paint(),this.fetchSoon()}async fetch(){let t=this.picture;if(!t||!this.canvas.clientWidth)return;let e=++this.turn,i={left:this.left,top:this.top,width:this.canvas.clientWidth/this.scale,height:this.canvas.clientHeight/this.scale},s=new URLSearchParams({...Object.fromEntries(Object.entries(i).map(([r,o])=>[r,String(o)])),stamp:t.stamp,across:String(Math.min(4096,this.canvas.width)),down:String(Math.min(4096,this.canvas.height))});try{let r=await fetch(`/product/picture/${t.path.split("/").map(encodeURIComponent).join("/")}?${s}`);if(!r.ok)throw new Error((await r.json()).error);let o=await createImageBitmap(await r.blob());if(e!==this.turn)return;this.shown={image:o,...i},this.paint()}catch(r){this.model.fail(r)}}paint(){let t=this.canvas.getContext("2d"),e=this.canvas.width/Math.max(this.canvas.clientWidth,1);t.setTransform(1,0,0,1,0,0),t.fillStyle="#fff",t.fillRect(0,0,this.canvas.width,this.canvas.height);let i=this.scale*e;if(this.shown){let{image:o,left:a,top:l,width:c,height:h}=this.shown;t.imageSmoothingEnabled=!0,t.drawImage(o,(a-this.left)*i,(l-this.top)*i,c*i,h*i)}let s=o=>o.map(([a,l])=>[(a-this.left)*i,(l-this.top)*i]);if(t.font="13px system-ui, sans-serif".replace("13",String(13*e)),this.picture?.place)for(let o of this.kept.here){let a=s(o.corners.map(l=>this.inPicture(l)));Lf(t,a,o.kind,e,If),t.strokeStyle="#fff",t.lineWidth=3*e,t.strokeText(o.drawing,a[0][0]+6*e,a[0][1]-6*e),t.fillStyle=If,t.fillText(o.drawing,a[0][0]+6*e,a[0][1]-6*e)}let r=s(this.corners);if(r.length){Lf(t,r,this.kind,e,Pf),t.fillStyle=Pf;for(let[o,a]of r)t.fillRect(o-3*e,a-3*e,6*e,6*e)}}pixel(t){let e=this.canvas.getBoundingClientRect();return[this.left+(t.clientX-e.left)/this.scale,this.top+(t.clientY-e.top)/this.scale]}listen(){let t=null,e=0;this.canvas.addEventListener("pointerdown",i=>{t=[i.clientX,i.clientY],e=0,this.canvas.setPointerCapture(i.pointerId)}),this.canvas.addEventListener("pointermove",i=>{if(this.at=this.pixel(i),this.valueSoon(),!t)return;let[s,r]=[i.clientX-t[0],i.clientY-t[1]];e+=Math.abs(s)+Math.abs(r),!(e<Cf/2)&&(this.left-=s/this.scale,this.top-=r/this.scale,t=[i.clientX,i.clientY],this.paint(),this.fetchSoon())}),this.canvas.addEventListener("pointerup",i=>{t&&e<Cf/2&&this.mode&&this.corner(this.pixel(i)),t=null}),this.canvas.addEventListener("wheel",i=>{i.preventDefault(),this.zoom(Math.exp(-i.deltaY*fx),this.pixel(i))},{passive:!1}),this.canvas.addEventListener("keydown",i=>this.key(i))}key(t){let e=60/this.scale,i=[this.left+this.canvas.clientWidth/this.scale/2,this.top+this.canvas.clientHeight/this.scale/2],s={ArrowLeft:[-e,0],ArrowRight:[e,0],ArrowUp:[0,-e],ArrowDown:[0,e]};if(s[t.key])this.left+=s[t.key][0],this.top+=s[t.key][1],this.at=i,this.valueSoon(),this.paint(),this.fetchSoon();else if(t.key==="+"||t.key==="-")this.zoom(t.key==="+"?1.25:.8,i);else if(t.key==="Enter"&&this.mode)this.corner(i);else if(t.key==="Backspace"&&this.corners.length)this.corners.pop(),this.buttons(),this.paint();else if(t.key==="Escape"&&this.mode)this.begin("");else return;t.preventDefault(),t.stopPropagation()}zoom(t,[e,i]){let s=Math.min(64,Math.max(this.scale*t,1e-4));this.left=e-(e-this.left)*this.scale/s,this.top=i-(i-this.top)*this.scale/s,this.scale=s,this.paint(),this.fetchSoon()}corner(t){this.corners.push(t),this.buttons(),this.paint()}async value(){let t=this.picture;if(!t?.place||!this.at)return;let e=this.at,[i,s]=this.object(e),r=this.decimals(),o={x:pt(i,r),y:pt(s,r),z:"none",s:"none"};if(t.heights)try{let a=await Pt("/api/picture/place",{file:t.path,column:e[0],row:e[1]});if(e!==this.at)return;a.height!==null&&(o.z=pt(a.height,r+1)),a.sigma!==null&&(o.s=pt(a.sigma,r+2))}catch(a){return this.model.fail(a)}this.place.textContent=_("studio_product.place",o)}};function Lf(n,t,e,i,s){let r=new Path2D;t.forEach(([o,a],l)=>l?r.lineTo(o,a):r.moveTo(o,a)),e==="area"&&(t.length>2&&r.closePath(),n.fillStyle=`${s}2e`,n.fill(r));for(let[o,a]of[["#fff",4],[s,2]])n.strokeStyle=o,n.lineWidth=a*i,n.stroke(r)}var px=["done","failed","stopped"],Ll=class{constructor(t,e){this.model=t;this.isOpen=e;this.pages=new Cl;this.forms=new Map;this.leaves=[];this.heads=[];this.now="";this.plan=new Il(t,(i,s)=>void this.drawn(i,s)),this.files=new Al(i=>{this.turn("plan"),this.plan.open(i)}),t.on("run",()=>{let i=t.run;this.forms.get(i?.name??"")?.run(i),i&&px.includes(i.outcome)&&this.isOpen()&&this.read()}),t.on("read",()=>this.isOpen()&&void this.show())}async show(){try{await this.read(),await this.leaf(this.now).show()}catch(t){this.model.fail(t)}}async read(){let t=await Pt("/api/products");this.leaves.length||this.make(t.products),this.files.take(t.files),this.plan.take(t.files),this.pages.take(t.files),this.now||this.turn(this.plan.has?"plan":t.products[0])}make(t){for(let e of t)this.forms.set(e,new Rl(this.model,e));this.leaves=[["plan",this.plan],...this.forms.entries(),["pages",this.pages],["files",this.files]],this.heads=this.leaves.map(([e])=>{let i=yt("studio_product.part",()=>this.turn(e),"",{part:e});return i.id=`product-${e}`,i}),nt("products-bar").append(u("span",{class:"group",role:"group","aria-label":_("studio_product.title")},...this.heads)),nt("products").append(...this.leaves.map(([,e])=>e.root))}leaf(t){return this.leaves.find(([e])=>e===t)[1]}turn(t){this.now=t,this.leaves.forEach(([e,i],s)=>{this.heads[s].setAttribute("aria-pressed",String(e===t)),i.root.hidden=e!==t}),this.isOpen()&&this.leaf(t).show().catch(e=>this.model.fail(e))}async drawn(t,e){let i=this.forms.get(t);this.turn(t),await i.drawn(e)}};var Dl=class{constructor(t,e){this.model=t;this.undo=nt("undo");this.redo=nt("redo");this.adjust=nt("adjust");this.outcome="";this.progress=nt("progress");this.undo.addEventListener("click",()=>void e.undo()),this.redo.addEventListener("click",()=>void e.redo()),this.adjust.addEventListener("click",()=>void this.begin()),nt("stop").addEventListener("click",()=>void Ee("/api/stop",{})),t.on("state",()=>this.buttons()),t.on("message",()=>this.message()),t.on("overview",()=>this.names()),t.actions.onwaiting=(i,s)=>this.waiting(i,s)}buttons(){this.undo.disabled=!this.model.state.can_undo,this.redo.disabled=!this.model.state.can_redo}message(){let{code:t,words:e,kind:i}=this.model.message,s=nt("message");s.dataset.code=t,s.textContent=s.title=e,s.className=i;let r=nt("command");r.textContent=this.model.command}names(){let t=this.model.overview;nt("title").textContent=document.title=`${t.title} \u2013 studio`,nt("title").textContent=t.title||"raybundle studio";let e=[t.headline,t.sigma0===null?"":_("studio_page.sigma0",{sigma0:t.sigma0}),t.free_scale?_("studio_page.free_scale"):""],i=nt("headline");i.textContent=i.title=e.filter(s=>s).join(" \xB7 ")||_("studio_page.contents",{kind:t.kind,images:t.images.length,points:t.points}),i.className=t.grade,nt("report").hidden=!t.report}async begin(){try{let{begun:t}=await Ee("/api/adjust",{});t?this.model.say("studio_page.adjusting"):this.model.say("studio_page.busy")}catch(t){this.model.fail(t)}}pointer(t){nt("pointer").textContent=t}connection(t){let e=nt("connection");e.textContent=t?_("studio_page.connected"):_("studio_page.connection_lost"),e.className=t?"":"bad"}waiting(t,e){e&&(t?this.model.say("studio_page.actions_wait",{n:t},"bad"):this.model.show(""))}receive(t){t.type==="state"?this.model.take(t.state):t.type==="oriented"?this.model.read().catch(()=>{}):t.type==="progress"?(nt("work").hidden=!1,this.adjust.disabled=!0,this.progress.value=t.share,nt("work-stage").textContent=Bs(t.stage)):t.type==="run"?this.showRun(t.run):t.type==="targets"?this.showTargets(t):this.adjusted(t)}showTargets({images:t,error:e,code:i}){nt("work").hidden=!0,this.adjust.disabled=!1,e?this.model.show(e,"bad",i):this.model.say("studio_target.found_in",{n:t.length,image:t[0]??""},"good"),Te.forget(),this.model.emit("targets")}showRun(t){let e=this.outcome;this.outcome=t.outcome,this.model.run=t;let i=t.outcome==="running";if(nt("work").hidden=!i,this.adjust.disabled=i,this.progress.value=t.share,nt("work-stage").textContent=`${t.name}: ${Bs(t.step)}`,this.model.emit("run"),i||e===t.outcome)return;let s=t.words.split(`
`);t.outcome==="done"?this.model.show(s[0].trim(),"good"):t.outcome==="failed"?this.model.show(s[s.length-1],"bad"):this.model.say("studio_run.stopped"),t.outcome==="done"&&this.model.read().catch(()=>{})}async adjusted(t){if(nt("work").hidden=!0,this.adjust.disabled=!1,t.error)return this.model.show(t.error,"bad",t.code);await this.model.read(),this.showResult(t.folder)}showResult(t){this.model.say("studio_page.adjusted",{sigma0:this.model.overview.sigma0,folder:t||"none"},"good")}};var Gi=26,Ls=200,Or=8e6,Df={points:"/api/points",observations:"/api/table/observations",pairs:"/api/table/pairs"},Uf={points:[["point",_("label.point"),n=>n.point],["role",_("label.role"),n=>_("studio_point.role",{role:n.role})],...["X","Y","Z"].map((n,t)=>[n,n,e=>pt(e.xyz[t],ke(e.sigma[t]))]),...["X","Y","Z"].map((n,t)=>[`s${n}`,_("label.sigma_of",{symbol:n}),e=>pt(e.sigma[t],ke(e.sigma[t]))]),["rays",_("label.rays"),n=>String(n.rays)],["w",_("studio_table.largest_w"),n=>pt(n.w,2)]],observations:[["image",_("label.image"),n=>n.image],["point",_("label.point"),n=>n.point],["x",_("studio_table.x"),n=>pt(n.x,2)],["y",_("studio_table.y"),n=>pt(n.y,2)],["vx",_("studio_table.vx"),n=>pt(n.vx,3)],["vy",_("studio_table.vy"),n=>pt(n.vy,3)],["w",_("studio_table.w"),n=>pt(n.w,2)],["r",_("studio_table.redundancy"),n=>pt(n.r,2)],["",_("label.rejected"),n=>n.rejected]],pairs:[["image",_("label.image"),n=>n.image],["other",_("studio_table.other_image"),n=>n.other],["common",_("label.common_points"),n=>fi(n.common)],["base",_("studio_table.base"),n=>Mt(n.base,4)]]},Ul=class{constructor(t,e,i){this.isOpen=e;this.opened=i;this.kind="points";this.sort="";this.down=!1;this.total=0;this.at=-1;this.pages=new Map;this.turn=0;this.search=u("input",{type:"search",id:"table-search","aria-label":_("studio_table.filter"),placeholder:_("studio_table.filter"),autocomplete:"off",spellcheck:"false"});this.status=u("span",{class:"note","aria-live":"polite"});this.head=u("div",{role:"row",class:"head"});this.rows=u("div",{class:"rows"});this.tall=u("div",{class:"tall"},this.rows);this.scroll=u("div",{class:"scroll",tabindex:0,role:"rowgroup","aria-label":_("studio_table.rows")},this.tall);this.grid=u("div",{role:"table",class:"grid","aria-label":_("studio_table.table")},this.head,this.scroll);this.drawSoon=vi(()=>this.draw());let s=u("select",{id:"table-kind","aria-label":_("studio_table.table")},...xe(Object.keys(Df),r=>_("studio_table.kind",{kind:r})));s.addEventListener("change",()=>this.of(s.value)),nt("table-bar").append(s,this.search,this.status),nt("table").append(this.grid),this.search.addEventListener("input",Re(()=>this.begin(),200)),this.scroll.addEventListener("scroll",this.drawSoon),this.scroll.addEventListener("keydown",r=>this.key(r)),this.rows.addEventListener("click",r=>{let o=r.target.closest("[data-row]");o&&this.open(Number(o.dataset.row))}),new ResizeObserver(this.drawSoon).observe(this.scroll),t.on("read",()=>this.isOpen()&&this.begin())}show(){this.of(this.kind)}of(t){t!==this.kind&&([this.sort,this.down]=["",!1]),this.kind=t,this.grid.className=`grid ${t}`,this.begin()}heads(){this.head.replaceChildren(...Uf[this.kind].map(([t,e])=>{let i=t&&t===this.sort,s=()=>{this.down=i?!this.down:["w","common","base"].includes(t)||t.startsWith("s"),this.sort=t,this.begin()},r=u("div",{role:"columnheader","aria-sort":i?this.down?"descending":"ascending":"none"});return r.append(t?u("button",{type:"button",title:_("studio_table.sort",{name:e}),onclick:s},`${e}${i?this.down?" \u25BC":" \u25B2":""}`):e),r}))}begin(){this.heads(),this.turn++,this.pages.clear(),this.at=-1,this.scroll.scrollTop=0,this.rows.replaceChildren(),this.load(0)}async load(t){if(this.pages.has(t))return;let{turn:e}=this;this.pages.set(t,null);try{let i=await Pt(Df[this.kind],{sort:this.sort,down:this.down?1:0,search:this.search.value.trim(),offset:t*Ls,limit:Ls});if(e!==this.turn)return;this.pages.set(t,i.rows),this.total=i.total,this.status.textContent=_("studio_table.count",{n:i.total}),this.grid.setAttribute("aria-rowcount",String(i.total+1)),this.tall.style.height=`${Math.min(i.total*Gi,Or)}px`}catch{e===this.turn&&this.pages.delete(t)}this.drawSoon()}get first(){let{scrollTop:t,clientHeight:e}=this.scroll;return this.total*Gi<=Or?t/Gi:t/Math.max(Or-e,1)*Math.max(this.total-e/Gi,0)}draw(){if(!this.isOpen()||!this.total)return void(this.total||this.rows.replaceChildren());let{first:t}=this,e=Math.ceil(this.scroll.clientHeight/Gi)+1,i=Math.floor(t);this.rows.style.transform=`translateY(${this.scroll.scrollTop-(t-i)*Gi}px)`;let s=[];for(let r=i;r<Math.min(i+e,this.total);r++){let o=Math.floor(r/Ls),a=this.pages.get(o)?.[r%Ls];a||this.load(o),s.push(this.row(r,a))}this.rows.replaceChildren(...s)}row(t,e){let i=Uf[this.kind].map(([,,s])=>u("div",{role:"cell"},e?s(e):"\u2026"));return u("div",{role:"row","data-row":t,"aria-rowindex":t+2,class:t===this.at?"at":""},...i)}open(t){this.at=t;let e=this.pages.get(Math.floor(t/Ls))?.[t%Ls];this.draw(),e&&this.opened(e)}key(t){let e=Math.max(Math.floor(this.scroll.clientHeight/Gi)-1,1),i={ArrowDown:1,ArrowUp:-1,PageDown:e,PageUp:-e,Home:-this.total,End:this.total};if(t.key==="Enter"&&this.at>=0)this.open(this.at);else if(t.key in i)this.at=Math.min(Math.max(this.at+i[t.key],0),this.total-1),this.reveal();else return;t.preventDefault(),t.stopPropagation()}reveal(){let t=this.scroll.clientHeight/Gi,{first:e}=this,i=this.at<e?this.at:this.at+1>e+t?this.at+1-t:e,s=this.total*Gi,r=i/Math.max(this.total-t,1);this.scroll.scrollTop=s<=Or?i*Gi:r*(Or-this.scroll.clientHeight),this.draw()}},Nf=n=>"other"in n,Ff=n=>"xyz"in n;var Rh=["images","space","tables","epochs","decide","products","journal"],Nl=class{constructor(){this.opened=new Map;this.now="images";Rh.forEach(t=>{let e=nt(`tab-${t}`);e.addEventListener("click",()=>this.show(t)),e.addEventListener("keydown",i=>{let s={ArrowRight:1,ArrowLeft:-1}[i.key];if(!s)return;i.preventDefault();let r=Rh.filter(a=>!nt(`tab-${a}`).hidden),o=r[(r.indexOf(t)+s+r.length)%r.length];this.show(o),nt(`tab-${o}`).focus()})})}onopen(t,e){this.opened.set(t,e)}show(t){this.now=t;for(let e of Rh){let i=nt(`tab-${e}`);i.setAttribute("aria-selected",String(e===t)),i.tabIndex=e===t?0:-1,nt(`stage-${e}`).hidden=e!==t}this.opened.get(t)?.()}};async function mx(){Zh();let n=new yo,t=new Rn(n),e=new Dl(n,t),i=new Nl,s=new mo(n,t,v=>e.pointer(v)),r=(v,b,g)=>{i.show("images"),s.visit(v,b,g)};new uo(n,(v,b)=>{i.show("images"),s.open(v,b).body.focus()});let o=new xo(n,t,{visit:r});new Tl(n,(v,b)=>{n.choose(v),o.goTo(v,b)}),new ro(n),new oo(n),new ao(n),new lo(n),new co(n),new ho(n),new _o(n,v=>{i.show("images"),(v?s.open(v):s.activePane)?.body.focus()});let a=new El(n,v=>{i.show("images"),s.open(v)}),l=new Ul(n,()=>i.now==="tables",v=>{if(Nf(v))return i.show("images"),s.open(v.image).body.focus(),void s.open(v.other,!0);n.choose(v.point),Ff(v)||o.goTo(v.point,v.image)}),c=new go(n,()=>i.now==="journal"),h=new eo(n,()=>i.now==="decide",{images:v=>{i.show("images"),v&&s.open(v).body.focus()},space:()=>i.show("space"),visit:(v,b)=>{n.choose(v),o.goTo(v,b)}}),d=new Ll(n,()=>i.now==="products");i.onopen("products",()=>void d.show());let p=new so(n,()=>i.now==="epochs",v=>{n.choose(v),o.goTo(v)});i.onopen("epochs",()=>p.show()),i.onopen("decide",()=>h.show()),i.onopen("space",()=>void a.show()),i.onopen("tables",()=>l.show()),i.onopen("journal",()=>void c.show()),nt("help").addEventListener("click",oc);let m=v=>()=>{i.show("images"),v(),s.activePane?.body.focus()};xu({"?":oc,n:m(()=>void t.newPoint()),w:()=>void o.worst(),v:()=>o.visitNext(),"ctrl z":()=>void t.undo(),"ctrl shift z":()=>void t.redo(),"ctrl y":()=>void t.redo(),s:()=>o.nextSnap(),c:m(()=>s.centre()),escape:()=>gx(n,s),g:m(()=>s.setCount({1:2,2:4}[n.panes.length]??1)),"[":()=>s.step(-1),"]":()=>s.step(1),f2:()=>o.typeName()},v=>s.toggleLoupe(v),()=>qt.loupe),await _x(n,e),s.activePane?.body.focus()}function gx(n,t){if(Kt.on)return Kt.end();document.activeElement!==t.activePane?.body?t.activePane?.body.focus():n.choose("")}async function _x(n,t){try{await n.read()}catch(s){throw n.fail(s),s}let e=()=>{n.overview.sigma0!==null&&!n.message.words&&t.showResult("")};e();let i=Re(()=>void n.read().then(e).catch(()=>{}),100);bu(s=>t.receive(s),(s,r)=>{t.connection(s),s&&(r||n.overview.sigma0===null)&&i()})}mx();})();
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
