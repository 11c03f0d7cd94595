"use strict";(()=>{var Pn=s=>Number(s.toPrecision(9)),Vt=(s,t,e)=>Math.min(e,Math.max(t,s)),Ee=(s,t,e)=>(1-e)*s+e*t,Se=s=>[...new Set(s)].sort((t,e)=>t-e),$n=(s,t)=>s.length===t.length&&s.every((e,n)=>e===t[n]);function re(s,t,e){return s.has(t)||s.set(t,e(t)),s.get(t)}function vt(s,t){let e=0;for(let n=0;n<s.length;n++)e+=s[n]*t[n];return e}function ec(s){let t=Math.hypot(...s);return s.map(e=>e/t)}function _n(s,t,e){if(s.length===1)return t[0];let[n,i]=Hr(s,e);return t[n].map((r,o)=>Ee(r,t[n+1][o],i))}function Hr(s,t){let e=Wr(s,t);return[e,(t-s[e])/(s[e+1]-s[e])]}function Wr(s,t){let e=0;for(;e<s.length-2&&t>=s[e+1];)e++;return e}function es(s){let t=0;for(let e=1;e<s.length;e++)t+=Math.hypot(...s[e].map((n,i)=>n-s[e-1][i]));return t}var Xr=["linear","smooth","stepped"],Gm=2**-7,en=s=>s[2]??"linear",Vm=(s,t,e="linear",n=null)=>[s,t,...n!==null?[e,n]:e==="linear"?[]:[e]];function qr(s,t,e,n=Hm(s,t),i=s.find(([r])=>r===t)?.[3]){return[...nc(s,t),Vm(t,e,n,i)].sort(([r],[o])=>r-o)}var nc=(s,t)=>s.filter(([e])=>e!==t);function Hm(s,t){let e=s.findLast(([n])=>n<=t)??s[0];return e&&en(e)}function Pu(s,t,e){let[[n,i],[r,o]]=[s[t],s[t+1]],a=en(s[t]);if(a==="linear")return Ee(i,o,(e-n)/(r-n));let[l,c]=a==="stepped"?Wm(n,r,e):[Math.max(n,Math.floor(e)),Math.min(r,Math.ceil(e))],h=d=>a==="smooth"?Xm(s,t,d):d===r?o:i;return c>l?Ee(h(l),h(c),(e-l)/(c-l)):h(l)}var $r=s=>s.slice(1).flatMap(([t],e)=>en(s[e])==="stepped"?[Lu(s[e][0],t)]:[]),Lu=(s,t)=>Math.max(s,t-Gm);function Wm(s,t,e){let n=Lu(s,t);return e<=n?[s,s]:[n,t]}function Xm(s,t,e){let[[n,i],[r,o]]=[s[t],s[t+1]],a=r-n,l=(e-n)/a,[c,h]=[t,t+1].map(u=>a*ic(s,u)),d=1-l;return i*(1+2*l)*d*d+c*l*d*d+o*l*l*(3-2*l)-h*l*l*d}function ic(s,t){let[e,n,i]=[s[t-1],s[t],s[t+1]];if(n.length>3)return n[3];if(!e||!i)return 0;let[r,o]=[n[0]-e[0],i[0]-n[0]],[a,l]=[(n[1]-e[1])/r,(i[1]-n[1])/o];if(a*l<=0)return 0;let[c,h]=[r+2*o,2*r+o];return(c+h)/(c/a+h/l)}function Yn({controls:s},{keys:t,constants:e,span:n=null}){let i=(r,o)=>Object.fromEntries([...r].sort(([a],[l])=>a-l).map(([a,l])=>[s[a].name,o(l)]));return{keys:i(t,r=>r.map(([o,a,...l])=>[Pn(o),Pn(a),...l])),standing:i(e,Pn),...n?{span:n}:{}}}function Kn({keys:s,standing:t,span:e},{controls:n,animation:i}){let r=i.isFree&&qm(e)?e:null;return{keys:sc(s,n,Ym),constants:sc(t,n,Number.isFinite),span:r}}var ui=(s,t)=>Yn(s,{keys:new Map,constants:t}).standing,Ln=(s,t)=>sc(s,t,Number.isFinite);function sc(s,t,e){let n=new Map(t.map(({name:r},o)=>[r,o])),i=Object.entries(s??{}).filter(([r,o])=>n.has(r)&&e(o));return new Map(i.map(([r,o])=>[n.get(r),o]))}function hn(s,t=null){try{return JSON.parse(s)}catch{return t}}var qm=s=>Array.isArray(s)&&s.length===2&&s.every(Number.isInteger)&&s[0]<s[1],$m=s=>Array.isArray(s)&&[2,3,4].includes(s.length)&&s.slice(0,2).every(Number.isFinite)&&Xr.includes(en(s))&&Number.isFinite(s[3]??0),Ym=s=>Array.isArray(s)&&s.length>0&&s.every($m);var Xs=44;function O(s,t={},...e){let n=document.createElement(s);for(let[i,r]of Object.entries(t))i.startsWith("on")?n.addEventListener(i.slice(2),r):i==="class"?n.className=r:i==="style"?Object.assign(n.style,r):i.includes("-")||i==="role"||i==="for"?n.setAttribute(i,r):n[i]=r;return n.append(...e.filter(i=>i!=null)),n}var Me=(...s)=>O("p",{class:"hint"},...s),je=(...s)=>O("div",{class:"actions"},...s),di=(s,t,e={})=>O("label",{class:"field",...e},O("span",{},s),t);function Yr(s,t,e){let n=O("input",{type:"range",...s,oninput:()=>e(Number(n.value))});return n.update=()=>{n.value=t(),n.style.setProperty("--at",ns(n.value,[n.min,n.max]))},n}function Kr(s,t,e,n){let{label:i}=s.controls[t],r=O("input",{"aria-label":i,...e,onchange:()=>{let o=parseFloat(r.value.replace(",","."));Number.isFinite(o)&&s.edit(`Set ${i}`,()=>s.set([[t,o]]),`${n} ${t}`),r.value=s.worded(t)}});return r}var ns=(s,[t,e])=>`${100*(s-t)/(e-t)}%`;function Zn(s,t){for(let[e,n]of Object.entries(t))s.setAttribute(e,String(n))}var Zr=({left:s,top:t,width:e,height:n},{x:i,y:r})=>i>=s&&i<s+e&&r>=t&&r<t+n,ce=(s,t)=>`${s} ${t}${s===1?"":"s"}`,is=s=>s.charAt(0).toUpperCase()+s.slice(1);function rc(s){let t=/[_.:\- ][^_.:\- ]{1,9}$/.exec(s)??/[A-Z][a-z]{1,8}$/.exec(s);return t?t[0]:s.slice(-5)}function qs(s){let t=rc(s),e=s.slice(0,s.length-t.length);return O("span",{class:"long-name"},O("span",{class:"start"},e),O("span",{},t))}var yt=(s,t,e,n={})=>O("button",{type:"button",title:t,onclick:e,...n},s);function Nn(s,t,e,n){let i=yt(s,t,n,{class:"toggle"});return i.update=()=>Zn(i,{"aria-pressed":e()}),i.update(),i}function fi(s,t,e,n){let i=t.map(([o,a,l])=>yt(a,l,()=>n(o))),r=O("div",{class:"segmented",role:"group","aria-label":s},...i);return r.update=()=>{i.forEach((o,a)=>Zn(o,{"aria-pressed":t[a][0]===e()}))},r.update(),r}function Mn(s,t,e="text/plain"){let n=URL.createObjectURL(new Blob([t],{type:e})),i=O("a",{href:n,download:s});document.body.append(i),i.click(),i.remove(),setTimeout(()=>URL.revokeObjectURL(n),1e4)}async function pi(s,t,e){let n=await Km(s);try{n&&await e(n)}catch(i){t(i.message)}}function Km(s){return new Promise(t=>{let e=O("input",{type:"file",accept:s});e.addEventListener("change",async()=>{let n=e.files[0];t(n?{name:n.name,file:n,text:s.startsWith("audio")?"":await n.text()}:null)}),e.addEventListener("cancel",()=>t(null)),e.click()})}function Du(s,t=1){let e=Vt(2-Math.floor(Math.log10(Math.max(t,1e-6))),2,6);return s.toFixed(e)}var Oi=32,Zm=2;function Jr(s,t,e){let n=a=>Oi*Math.floor(Math.max(0,a)/Oi),i=(a,l)=>Math.min(l,Oi*Math.ceil(a/Oi)),r=[n(s[0]),n(s[1]),i(s[2],e[0]),i(s[3],e[1])];return r[0]<r[2]&&r[1]<r[3]?t&&r[0]>=t[0]&&r[1]>=t[1]&&r[2]<=t[2]&&r[3]<=t[3]&&Nu(t)<=Zm*Nu(r)?t:r:t??[0,0,1,1]}var Nu=([s,t,e,n])=>(e-s)*(n-t);function jr(s,[t,e,n,i]){Object.assign(s.style,{left:`${t}px`,top:`${e}px`,width:`${n-t}px`,height:`${i-e}px`})}var Jm=14*Math.PI/180,oc=Math.tan(Jm/2),Ou=88*Math.PI/180,Dn=class{right;above;towards;constructor(t,e){this.up=Fi(t);let n=Fi(ge(e,ie(this.up,vt(e,this.up))));this.front=n??jm(this.up),this.side=Be(this.up,this.front),this.target=[0,0,0],this.distance=1,this.size=1,this.half=oc,this.turn(0,0)}turn(t,e){this.distance*=this.half/oc,this.half=oc,this.azimuth=t,this.elevation=Vt(e,-Ou,Ou);let n=fe(ie(this.front,Math.cos(t)),ie(this.side,Math.sin(t)));this.towards=fe(ie(n,Math.cos(this.elevation)),ie(this.up,Math.sin(this.elevation))),this.right=Fi(Be(this.up,this.towards)),this.above=Be(this.towards,this.right)}leaveShot(){this.turn(this.azimuth,this.elevation)}lookFrom(t,e,n){this.turn(Math.atan2(vt(e,this.side),vt(e,this.front)),Math.asin(Vt(vt(e,this.up),-1,1))),this.target=t,this.distance=n}lookThrough([t,e,n,i,[r,o]],{width:a,height:l}){let c=vt(ge(i,this.target),n);this.lookFrom(this.target,n,c>0?c:this.distance),this.target=ge(i,ie(n,this.distance)),Object.assign(this,{right:t,above:e,towards:n,half:Math.max(o,r*l/a)})}frame(t,e,n,i=1.06){if(!t.length)return;let r=[this.right,this.above,this.towards].map(h=>t.reduce(([d,u],f)=>[Math.min(d,vt(f,h)),Math.max(u,vt(f,h))],[1/0,-1/0]));this.target=[this.right,this.above,this.towards].reduce((h,d,u)=>fe(h,ie(d,.5*(r[u][0]+r[u][1]))),[0,0,0]);let[o,a,l]=r.map(([h,d])=>d-h),c=.5*i*Math.max(a,o*n/Math.max(1,e),1e-6);this.distance=c/this.half+.5*l,this.size=Math.max(o,a,l)}zoom(t){this.leaveShot(),this.distance=Vt(this.distance*t,.02*this.size,50*this.size)}pan(t,e,n){this.leaveShot();let i=this.pixelSize(n);this.target=fe(this.target,fe(ie(this.right,-t*i),ie(this.above,e*i)))}pixelSize(t){return 2*this.distance*this.half/t}get position(){return fe(this.target,ie(this.towards,this.distance))}get fieldDegrees(){return 2*Math.atan(this.half)*180/Math.PI}projector(t){let e=this.position,n=t.height/(2*this.half),[i,r]=[t.left+t.width/2,t.top+t.height/2],{right:o,above:a,towards:l}=this;return c=>{let h=ge(c,e),d=-vt(h,l),u=n/Math.max(d,1e-9);return[i+vt(h,o)*u,r-vt(h,a)*u,d]}}unproject(t,e,n,i){let r=2*this.half*i/t.height,o=(e-t.left-t.width/2)*r,a=-(n-t.top-t.height/2)*r,l=fe(fe(ie(this.right,o),ie(this.above,a)),ie(this.towards,-i));return fe(this.position,l)}},fe=(s,t)=>[s[0]+t[0],s[1]+t[1],s[2]+t[2]],ge=(s,t)=>[s[0]-t[0],s[1]-t[1],s[2]-t[2]],ie=(s,t)=>[s[0]*t,s[1]*t,s[2]*t];function Be(s,t){return[s[1]*t[2]-s[2]*t[1],s[2]*t[0]-s[0]*t[2],s[0]*t[1]-s[1]*t[0]]}function Fi(s){let t=Math.hypot(...s);return t>1e-12?ie(s,1/t):null}var jm=s=>Fi(Be(Math.abs(s[0])<.9?[1,0,0]:[0,1,0],s));function mi(s,t=[]){return["#usda 1.0",...t.length?["(",...t.map(n=>`    ${n}`),")"]:[],"",...Fu(Qm(s)),""].join(`
`)}var ss=(s,...t)=>[`${s} = {`,"    dictionary usdrigui = {",...t.map(e=>`        ${e}`),"    }","}"];function Qm(s){let t={children:new Map};for(let[e,n]of s){let i=t;for(let r of e.split("/").filter(Boolean))i.children.has(r)||i.children.set(r,{children:new Map,type:"over",metadata:"",lines:[]}),i=i.children.get(r);Object.assign(i,n)}return t}function Fu({children:s},t=""){return[...s].flatMap(([e,n])=>[`${t}${n.type} ${ze(e)}${n.metadata&&" ("}`,...n.metadata?[...n.metadata.split(`
`).map(i=>`${t}    ${i}`),`${t})`]:[],`${t}{`,...n.lines.map(i=>`${t}    ${i}`),...Fu(n,`${t}    `),`${t}}`])}function ze(s){return`"${s.replace(/["\\]/g,"\\$&").replace(/\n/g,"\\n")}"`}var tg=s=>s.slice(1,-1).replace(/\\(.)/g,(t,e)=>e==="n"?`
`:e);function ac(s,t=""){return[...s.matchAll(new RegExp(`${t}("(?:[^"\\\\]|\\\\.)*"|'(?:[^'\\\\]|\\\\.)*')`,"g"))].map(([,n])=>tg(n))}var Ui=(s,t)=>ac(t,`string ${s} = `);function Uu(s){let t=n=>hn(n.replaceAll("(","[").replaceAll(")","]"));return{samples:[...s.matchAll(/^ +([-+.\de]+): (.*?)(?:;.*)?,$/gm)].map(([,n,i])=>[Number(n),t(i)]),one:t(/^[^\n=]* = ([-+.\de]+)/.exec(s)?.[1]??"")}}var xe=s=>String(Pn(s)+0),rs=s=>`(${[...s].map(xe).join(", ")})`;var lc=24,eg=.004,ku=1-1e-7;function Bu(s,t){let{target:e,towards:n,right:i,distance:r}=s;return{target:e.map(os),towards:n.map(os),right:i.map(os),distance:os(r),height:os(s.pixelSize(1)),aspect:os(t.width/t.height)}}function cc({target:s,towards:t,right:e},[n,i]){return fe(s,fe(ie(e,n),ie(Be(t,e),i)))}function zu({target:s,towards:t,right:e},n){let i=ge(n,s);return[vt(i,e),vt(i,Be(t,e))]}var Gu=(s,{towards:t,right:e})=>vt(s.towards,t)>ku&&vt(s.right,e)>ku;function Qr(s,t){if(s.length<3)return s;let[e,n]=[s[0],s.at(-1)],i=s.map(o=>ng(o,e,n)),r=i.indexOf(Math.max(...i));return i[r]<=t?[e,n]:[...Qr(s.slice(0,r+1),t).slice(0,-1),...Qr(s.slice(r),t)]}function ng([s,t],[e,n],[i,r]){let[o,a]=[i-e,r-n],l=o*o+a*a,c=l?Vt(((s-e)*o+(t-n)*a)/l,0,1):0;return Math.hypot(s-e-c*o,t-n-c*a)}function $s({controls:s},t){return new Map([...t.entries()].filter(([e,n])=>n!==s[e].default))}function as({controls:s},{values:t}){return Float64Array.from(s,({default:e},n)=>t.get(n)??e)}function hc(s,{id:t,frame:e,neutral:n,text:i,done:r,values:o,section:a,look:l,strokes:c}){return{id:t,root:s.character.root,frame:e,neutral:n,text:i,done:r,values:ui(s,o),section:a,look:l,strokes:c}}function uc(s,{controls:t}){let{id:e,frame:n,neutral:i,text:r,done:o,values:a,section:l,look:c,strokes:h}=s??{};return typeof e=="string"&&Number.isFinite(n)&&sg(c)&&Array.isArray(h)&&h.every(ig)?{id:e,frame:n,neutral:i===!0,text:String(r??""),done:o===!0,values:Ln(a,t),section:String(l??""),look:c,strokes:h}:null}function to(s,t,e){let{root:n}=t.character,i=s.filter(r=>r.root===n||n===e[0]&&!e.includes(r.root));return Ys([],i.map(r=>uc(r,t)).filter(Boolean))}function Ys(s,t){let e=new Map(s.map(n=>[n.id,n]));return t.forEach(n=>e.set(n.id,n)),[...e.values()]}var Vu=(s,t)=>Array.isArray(s)&&s.length===t&&s.every(Number.isFinite),ig=s=>Array.isArray(s)&&s.length>0&&s.every(t=>Vu(t,2)),sg=s=>["target","towards","right"].every(t=>Vu(s?.[t],3))&&Math.abs(vt(s.towards,s.right))<.001&&!!Fi(s.towards)&&!!Fi(s.right)&&["distance","height","aspect"].every(t=>s[t]>0&&Number.isFinite(s[t]));function Hu(s){let t=new Map;for(let[n,i]of s){if(!i.length)continue;let r=`${n.character.root}/RigUIReview`;t.set(r,{type:"def Scope",lines:['uniform token purpose = "guide"']}),i.forEach((o,a)=>rg(t,`${r}/note_${a+1}`,n,o))}let[e=""]=[...t.keys()].map(n=>n.split("/")[1]);return mi(t,[`defaultPrim = ${ze(e)}`])}function rg(s,t,e,n){s.set(t,{type:"def Scope",metadata:[`displayName = ${ze(dc(n))}`,`doc = ${ze(n.text)}`,...ss("customData",`string note = ${ze(JSON.stringify(hc(e,n)))}`)].join(`
`)}),s.set(`${t}/view`,{type:"def Camera",lines:og(n.look)}),n.strokes.length&&s.set(`${t}/strokes`,{type:"def BasisCurves",lines:ag(n)})}var dc=({frame:s,neutral:t})=>t?"Neutral pose":`Frame ${xe(s)}`;function og({target:s,towards:t,right:e,distance:n,height:i,aspect:r}){let o=Be(t,e),a=[[e,0],[o,0],[t,0],[fe(s,ie(t,n)),1]],l=lc*n/i;return[`float focalLength = ${xe(l)}`,`float horizontalAperture = ${xe(lc*r)}`,`float verticalAperture = ${lc}`,`float2 clippingRange = (${xe(.01*n)}, ${xe(100*n)})`,`matrix4d xformOp:transform = ( ${a.map(([c,h])=>rs([...c,h])).join(", ")} )`,'uniform token[] xformOpOrder = ["xformOp:transform"]']}function ag({look:s,strokes:t,frame:e,neutral:n}){let i=t.map(o=>o.length>1?o:[o[0],o[0]]),r=[`    ${xe(e-1)}: "invisible",`,`    ${xe(e)}: "inherited",`,`    ${xe(e+1)}: "invisible",`];return['uniform token type = "linear"',`int[] curveVertexCounts = [${i.map(o=>o.length).join(", ")}]`,`point3f[] points = [${i.flat().map(o=>rs(cc(s,o))).join(", ")}]`,`float[] widths = [${xe(eg*s.height)}] (`,'    interpolation = "constant"',")","color3f[] primvars:displayColor = [(0.871, 0.397, 0.07)] (",'    interpolation = "constant"',")",...n?[]:["token visibility.timeSamples = {",...r,"}"]]}function eo(s){let t=s.startsWith("#usda")?Ui("note",s).map(e=>hn(e)).filter(Boolean):[];if(!t.length)throw new Error("This layer holds no notes written by the viewer.");return t}var os=s=>Pn(s)+0;var io=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1];function un(s,t){let e=new Array(16);for(let n=0;n<16;n+=4)for(let i=0;i<4;i++)e[n+i]=s[n]*t[i]+s[n+1]*t[4+i]+s[n+2]*t[8+i]+s[n+3]*t[12+i];return e}function so(s){let t=Xu(qu(s));if(!t)return null;let[e,n,i]=[s[12],s[13],s[14]];return ro(t,-(e*t[0]+n*t[3]+i*t[6]),-(e*t[1]+n*t[4]+i*t[7]),-(e*t[2]+n*t[5]+i*t[8]))}var ro=(s,t,e,n)=>[s[0],s[1],s[2],0,s[3],s[4],s[5],0,s[6],s[7],s[8],0,t,e,n,1],oo=(s,t,e,n)=>[0,1,2].map(i=>t*s[i]+e*s[4+i]+n*s[8+i]+s[12+i]),Wu=s=>[s.slice(0,3),s.slice(3,6),s.slice(6,9)];function ao(s){let[t,e,n]=Wu(s);return vt(t,Be(e,n))}function Xu(s){let[t,e,n]=Wu(s),i=[Be(e,n),Be(n,t),Be(t,e)],r=vt(t,i[0]);return Math.abs(r)>1e-300?ls(i.flat()).map(o=>o/r):null}function On(s,t){let e=new Array(9);for(let n=0;n<9;n+=3)for(let i=0;i<3;i++)e[n+i]=s[n]*t[i]+s[n+1]*t[3+i]+s[n+2]*t[6+i];return e}var qu=s=>[0,1,2,4,5,6,8,9,10].map(t=>s[t]),ls=s=>[0,3,6,1,4,7,2,5,8].map(t=>s[t]);function Jn(s){let t=qu(s),e=t;for(let r=0;r<60;r++){let o=Xu(ls(e));if(!o)return{stretch:t,rotation:[1,0,0,0,1,0,0,0,1]};let a=e.map((c,h)=>.5*(c+o[h])),l=a.reduce((c,h,d)=>Math.max(c,Math.abs(h-e[d])),0);if(e=a,l<1e-14)break}let n=Math.sign(ao(e))||1,i=e.map(r=>r*n);return{stretch:On(t,ls(i)),rotation:i}}function lo(s,t,e){let n=Math.hypot(s,t,e),i=n<1e-8?1:Math.sin(n)/n,r=n<1e-8?1:Math.sin(n/2)/(n/2),o=[0,e,-t,-e,0,s,t,-s,0],a=On(o,o);return o.map((l,c)=>(c%4===0?1:0)+i*l+.5*r*r*a[c])}function co(s){let[t,e,n,i,r,o,a,l,c]=ls(s),h=t+r+c,d=Math.max(h,t,r,c),u;return d===h?u=[1+h,l-o,n-a,i-e]:d===t?u=[l-o,1+2*t-h,e+i,n+a]:d===r?u=[n-a,e+i,1+2*r-h,o+l]:u=[i-e,n+a,o+l,1+2*c-h],ec(u)}function fc(s,t){let[[e,...n],[i,...r]]=[s,t];return[e*i-vt(n,r),...fe(Be(n,r),fe(ie(r,e),ie(n,i)))]}function Ks([s,t,e,n]){return[1-2*(e*e+n*n),2*(t*e+s*n),2*(t*n-s*e),2*(t*e-s*n),1-2*(t*t+n*n),2*(e*n+s*t),2*(t*n+s*e),2*(e*n-s*t),1-2*(t*t+e*e)]}function $u(s){let t=co(s),[e,...n]=t[0]<0?t.map(o=>-o):t,i=Math.hypot(...n),r=i<1e-12?2:2*Math.atan2(i,e)/i;return n.map(o=>r*o)}function no(s){let t=[0,4,8].map(r=>Array.from(s.slice(r,r+3))),e=t.map(r=>Math.hypot(...r)||1),n=ao(t.flat())<0?-1:1,i=t.flatMap((r,o)=>r.map(a=>a/(e[o]*n)));return{translation:Array.from(s.slice(12,15)),rotation:co(i),scale:e.map(r=>r*n)}}function Yu(s,t,e){let[n,i]=[no(s),no(t)],r=u=>n[u].map((f,p)=>Ee(f,i[u][p],e)),[o,a]=[r("scale"),Ks(lg(n.rotation,i.rotation,e))],l=a.map((u,f)=>u*o[Math.floor(f/3)]),[c,h,d]=r("translation");return ro(l,c,h,d)}function lg(s,t,e){let n=vt(s,t),i=Math.acos(Math.min(1,Math.abs(n))),r=Math.sin(i),[o,a]=r<1e-6?[1-e,e]:[Math.sin((1-e)*i)/r,Math.sin(e*i)/r],l=s.map((c,h)=>o*c+Math.sign(n||1)*a*t[h]);return ec(l)}function Ju(s){return ed(Qu(s,cs(s)))}function ju(s,t,e){return od(s.map(n=>Qu(n,t(n))),e)}function cs(s){let{animation:t,keys:e}=s,n=new Map([...s.allConstants()].filter(([i])=>!t.isAnimated(i,e)));return Yn(s,{keys:e,constants:n,span:s.span})}function Qu(s,t){let{animation:e}=s,n=Kn(t,s),i=Se([...n.keys.keys(),...n.constants.keys()]),r=i.length?Zs(s,hg(e,n),o=>e.at(o,n)):[];return sd(s,i,r,e.range(n.keys,n.span),t)}function td(s){let{frame:t,neutral:e,animation:n,values:i}=s,r=e?{weights:null,locals:null}:n.clipAt(t),o=Zs(s,[t],()=>({...r,values:i})),a=[...s.controls.keys()],l=new Map(a.map(c=>[c,i[c]]));return ed(sd(s,a,o,[t,t],Yn(s,{keys:new Map,constants:l})))}var ed=s=>({text:s.animations.size?od([s]):"",unwritten:s.unwritten});function nd(s,t){let{character:e,controls:n}=s,i=Zs(s,[null],()=>({values:as(s,{values:t}),weights:null,locals:null})),{animations:r,unwritten:o}=ad(s,[...t.keys()]),a=new Set([...t.keys()].flatMap(c=>n[c].drive.channels)),l=c=>({...c,channels:c.channels.filter(h=>a.has(h)),joints:c.joints.filter(h=>c.driven.has(h))});return{animations:[...r].map(([c,h])=>({path:c,lines:ld(e,l(h),i)})),unwritten:o}}function id(s,t){let e=cg(s),n=Kn(e.find(({root:i})=>i===t.character.root)??e[0],t);if(!n.keys.size&&!n.constants.size)throw new Error("No control of this character is named in the layer.");return n}function cg(s){let[t]=Ui("work",s);if(!s.startsWith("#usda")||!t)throw new Error("This layer was not written by the viewer.");return mc(t)}function mc(s){let t=hn(s);return(t?.characters??[t]).filter(Boolean).map(({root:e,keys:n={},standing:i={},span:r})=>({root:e,keys:n,standing:i,...r&&{span:r}}))}function hg(s,t){let e=s.times(t.keys,t.span),n=[...t.keys.keys()].filter(o=>s.controls[o].drive.values.length>2);if(!n.length)return e;let i=e.map(o=>s.at(o,t).values),r=n.flatMap(o=>e.slice(1).flatMap((a,l)=>ug(s.controls[o].drive.values,[e[l],i[l][o]],[a,i[l+1][o]])));return Se([...e,...r])}function ug(s,[t,e],[n,i]){return s.filter(o=>(o-e)*(o-i)<0).map(o=>t+(o-e)/(i-e)*(n-t)).filter(o=>o>t&&o<n)}function Zs(s,t,e){let{deformer:n,character:i}=s,r=t.map(o=>{let{values:a,weights:l,locals:c}=e(o);return n.setBase(l,c),n.drive(a),{time:o,values:Float64Array.from(a),left:l,weights:Array.from(n.weights),locals:i.joints.map((h,d)=>Array.from(n.skeletons.localAt(d,n.moves)))}});return s.showBase(),n.drive(s.values),r}function sd(s,t,e,n,i){let{character:r,animation:o}=s,{animations:a,unwritten:l}=ad(s,t),c=new Map;for(let[d,u]of a)u.made&&u.skeletons.forEach(f=>xg(c,r.skeletons[f].path,d)),pc(c,d,{type:u.made?"def SkelAnimation":"over",lines:ld(r,u,e)});for(let d of rd(r.controls,t.filter(u=>dg(r,u,e)))){let[u,f]=r.controls[d].attribute.split(".");pc(c,u,{type:"over",lines:gg(f,d,e)})}let h=[`${r.root}/`,...r.skeletons.map(d=>`${fo(d)}.`)];return{animations:a,unwritten:l,prims:c,range:n,rate:o.rate,own:h,work:{root:r.root,...i}}}function dg({baseWeights:s,controls:t},e,n){let{channels:i}=t[e].drive;return n.every(({left:r})=>!r||i.every(o=>Math.abs(r[o]-s[o])<1e-5))}function rd(s,t){let e=({drive:i,kind:r},o)=>o.drive.channels.some(a=>i.channels.includes(a))||(r!=="joint"||o.kind!=="joint")&&o.drive.joints.some(a=>i.joints.includes(a)),n=t.filter(i=>s[i].attribute&&s.every((r,o)=>t.includes(o)||!e(s[i],r)));return n.length===t.length?n:rd(s,n)}function od(s,t=[]){let[{rate:e,work:n}]=s,i=new Map(t.map(o=>[o.root,o]));for(let{work:o}of s){let{keys:a,standing:l}=i.get(o.root)??{};i.set(o.root,{...o,keys:{...o.keys,...a},standing:{...o.standing,...l}})}let r=[...i.values()];return mi(new Map(s.flatMap(({prims:o})=>[...o])),[`defaultPrim = ${ze(n.root.split("/")[1]??"")}`,`startTimeCode = ${xe(Math.min(...s.map(({range:o})=>o[0])))}`,`endTimeCode = ${xe(Math.max(...s.map(({range:o})=>o[1])))}`,`timeCodesPerSecond = ${xe(e)}`,`framesPerSecond = ${xe(e)}`,...ss("customLayerData",`string work = ${ze(JSON.stringify(r.length>1?{characters:r}:r[0]))}`,`string[] own = [${s.flatMap(({own:o})=>o).map(ze).join(", ")}]`)])}function ad({character:s,controls:t},e){let{channels:n,joints:i,skeletons:r}=s,o=r.map(fo),a=n.map((d,u)=>pg(s,o,d,u)),l=new Map,c=d=>re(l,d,()=>fg(s,o,d)),h=[];for(let d of e){let{drive:u,name:f}=t[d],p=u.channels.flatMap(x=>a[x]);p.forEach(x=>c(x).weighted=!0),u.joints.forEach(x=>c(o[i[x].skeleton]).driven.add(x)),u.channels.length&&!p.length&&h.push(f)}for(let[d,u]of l){n.forEach((p,x)=>u.weighted&&a[x].includes(d)&&u.channels.push(x)),u.channels.sort((p,x)=>Ku(n[p])-Ku(n[x]));let f=u.channels.map(p=>n[p].token);u.channels=u.channels.filter((p,x)=>f.indexOf(f[x])===x),u.driven.size&&(u.joints=mg(i,u))}return{animations:l,unwritten:h}}var fo=({path:s,animation:t})=>t||`${s}/usdrigui_animation`,fg=({skeletons:s,channels:t},e,n)=>({skeletons:[...s.keys()].filter(i=>e[i]===n),made:[...s,...t].every(({animation:i})=>i!==n),weighted:!1,driven:new Set,channels:[],joints:[]}),Ku=({index:s})=>s<0?1/0:s;function pg({meshes:s,joints:t,channels:e},n,{animation:i,index:r},o){if(i&&r>=0)return[i];let l=s.filter(({shapes:c})=>c.some(h=>h.channel===o)).flatMap(({skin:c,shapes:h})=>{if(c)return[n[t[c.joints[0]].skeleton]];let d=h.map(u=>e[u.channel]).find(u=>u.animation);return d?[d.animation]:n});return[...new Set(l)]}function mg(s,{skeletons:t,driven:e}){let n=new Map;return s.forEach(({path:i,skeleton:r},o)=>{t.includes(r)&&(!n.has(i)||e.has(o))&&n.set(i,o)}),[...n.values()]}function ld(s,{channels:t,joints:e},n){let i=[];if(t.length&&(i.push(Zu("blendShapes",t.map(r=>s.channels[r].token))),i.push(...uo("float[] blendShapeWeights",n,({weights:r})=>t.map(o=>xe(r[o]))))),e.length){let r=n.map(({time:a,locals:l})=>({time:a,parts:e.map(c=>no(l[c]))})),o=a=>l=>l.parts.map(c=>`(${c[a].map(xe).join(", ")})`);i.push(Zu("joints",e.map(a=>s.joints[a].path))),i.push(...uo("quatf[] rotations",r,o("rotation"))),i.push(...uo("half3[] scales",r,o("scale"))),i.push(...uo("float3[] translations",r,o("translation")))}return i}function gg(s,t,e){let n=e.map(({time:i,values:r})=>[xe(i),xe(r[t])]);return n.every(([,i])=>i===n[0][1])?[`double ${s} = ${n[0][1]}`]:[`double ${s}.timeSamples = {`,...n.map(([i,r])=>`    ${i}: ${r},`),"}"]}var Zu=(s,t)=>`uniform token[] ${s} = [${t.map(ze).join(", ")}]`;function uo(s,t,e){if(t[0].time===null)return[`${s} = [${e(t[0]).join(", ")}]`];let n=t.map(i=>`    ${xe(i.time)}: [${e(i).join(", ")}],`);return[`${s}.timeSamples = {`,...n,"}"]}function xg(s,t,e){pc(s,t,{type:"over",metadata:'prepend apiSchemas = ["SkelBindingAPI"]',lines:[`rel skel:animationSource = <${e}>`]})}function pc(s,t,{type:e,metadata:n="",lines:i}){let r=s.get(t)??{type:"over",metadata:"",lines:[]};s.set(t,{type:e==="over"?r.type:e,metadata:n||r.metadata,lines:[...r.lines,...i]})}function hd(s,t){let e=new Set,n=new Map([["/Poses",{type:"def Scope"}]]);for(let{name:i,values:r,picture:o}of t){let{animations:a,unwritten:l}=nd(s,r);l.forEach(u=>e.add(u));let c={name:i,values:ui(s,r),picture:o},h=cd("/Poses",i,n),d=[`displayName = ${ze(i)}`,...ss("customData",`string pose = ${ze(JSON.stringify(c))}`)].join(`
`);n.set(h,{type:"def Scope",metadata:d});for(let{path:u,lines:f}of a)n.set(cd(h,u.split("/").at(-1),n),{type:"def SkelAnimation",lines:f})}return{text:mi(n,['defaultPrim = "Poses"']),unwritten:[...e]}}function ud(s,t){if(!s.startsWith("#usda")||!Ui("pose",s).length)throw new Error("This layer holds no poses saved by the viewer.");let e=gc(s,t);if(!e.length)throw new Error("No control of this character is named in the poses.");return e}var gc=(s,t)=>Ui("pose",s).map(e=>xc(JSON.parse(e),t)).filter(Boolean);function xc({name:s,values:t,picture:e},n){let i=Ln(t,n.controls),r=typeof e=="string"&&e.startsWith("data:image/")?e:"";return i.size?{name:String(s),values:i,picture:r}:null}function cd(s,t,e){let n=`${s}/${t.replace(/[^A-Za-z0-9_]/g,"_").replace(/^(?=[0-9]|$)/,"_")}`,i=n;for(let r=2;e.has(i);r++)i=`${n}_${r}`;return i}function po(s){let{frame:t,neutral:e,own:n,controls:i,elements:r,moved:o,locks:a,shelf:l,notes:c,received:h,sound:d,span:u}=s,f=e?s.rest:s.given,p=[...n.keys()].filter(x=>n[x]!==f[x]);return!s.keys.size&&!s.constants.size&&!p.length&&!u&&fd(s)?null:{frame:t,neutral:e,...Yn(s,s),changed:Object.fromEntries(p.map(x=>[i[x].name,n[x]])),locks:[...a].map(x=>i[x].name),shelf:l.map(x=>({...x,values:ui(s,x.values)})),notes:c.map(x=>hc(s,x)),received:h,sound:d,moved:[...o].map(([x,m])=>[r.list[x].name,m,r.placement(r.list[x])])}}var dd=s=>!s.unkeyed().length&&fd(s),fd=({moved:s,locks:t,shelf:e,sound:n,notes:i,arrived:r})=>!s.size&&!t.size&&!e.length&&!n&&i===r;function pd(s,t){let{controls:e,elements:n}=s,i=s.snapshot(),{keys:r,constants:o,span:a}=Kn(t,s);s.locks=new Set(e.flatMap(({name:m},g)=>t.locks?.includes(m)?[g]:[]));for(let[m,g,M]of t.moved??[]){let A=n.list.find(b=>b.name===m&&b.members.length===M.members.length);!A||!Array.isArray(g)||(n.restore(A,M),s.moved.set(A.index,g))}let l=t.neutral===!0,c=Number.isFinite(t.frame)?t.frame:s.frame,h=l?Float64Array.from(s.rest):s.animation.at(c,{keys:r,constants:o}).values,d=Float64Array.from(h);Ln(t.changed,e).forEach((m,g)=>d[g]=m);let u=(t.shelf??[]).map(m=>xc(m,s)).filter(Boolean),f=yg(t.sound)?t.sound:null,p=s.notes.filter(({id:m})=>!t.received?.includes(m)),x=Ys(p,(t.notes??[]).map(m=>uc(m,s)).filter(Boolean));s.received=[...new Set([...s.received,...t.received??[]])],s.restore({frame:c,neutral:l,keys:r,constants:o,given:h,values:d,shelf:u,notes:x,sound:f,span:a}),s.step("Restore work",i),s.emit("options"),s.emit("layout")}function md({keys:s,standing:t,changed:e,moved:n,shelf:i,notes:r,sound:o,span:a}){let l=Object.values(s??{}),c=l.reduce((d,u)=>d+u.length,0),h=Object.keys({...t,...e}).length;return[c?`${ce(c,"key")} of ${ce(l.length,"control")}`:"",h?`${ce(h,"control")} changed without a key`:"",n?.length?`${ce(n.length,"element")} moved`:"",i?.length?`${ce(i.length,"pose")} on the shelf`:"",r?.length?ce(r.length,"note"):"",o?`the place of ${o.name}`:"",a?`frames ${a[0]} to ${a[1]}`:""].filter(Boolean).join(", ")||"locks"}var yg=s=>typeof s?.name=="string"&&Number.isFinite(s.start)&&s.seconds>=0;var vg=300,mo=class{constructor(t,e,n=()=>!1){this.isElsewhere=n,this.session=t,this.storage=e,this.prefix=`usdrigui ${t.character.identity} `,this.slot=`${this.prefix}${Date.now().toString(36)}${Math.random().toString(36).slice(2,8)}`,this.stored=null,this.filed=null}listen(t){this.onfail=t;for(let e of["changed","time","options"])this.session.on(e,()=>this.schedule());this.session.on("saved",()=>this.filed=gd(this.session))}schedule(){clearTimeout(this.timer),this.timer=setTimeout(()=>this.flush(),vg)}flush(){if(clearTimeout(this.timer),!this.storage||this.session.trial)return;let t=this.isElsewhere()?null:po(this.session),e=JSON.stringify(t);try{t?this.storage.setItem(this.slot,JSON.stringify({saved:Date.now(),work:t})):this.storage.removeItem(this.slot),this.stored=e}catch{this.failed||this.onfail?.(),this.failed=!0}}get isUnsaved(){let{session:t}=this;if(this.isElsewhere()||JSON.stringify(po(t))===this.stored)return!1;let e=gd(t);return e!=="null"&&e!==this.filed||t.notes!==t.arrived&&t.notes!==t.sent}get offered(){if(!this.storage)return null;let n=Object.keys(this.storage).filter(i=>i.startsWith(this.prefix)&&i!==this.slot).map(i=>({slot:i,...hn(this.storage.getItem(i))})).filter(({work:i})=>i).sort((i,r)=>r.saved-i.saved)[0];return n?{...n,words:md(n.work)}:null}forget(){clearTimeout(this.timer),this.storage?.removeItem(this.slot)}discard({slot:t}){this.storage.removeItem(t)}};function xd(){try{let{localStorage:s}=window;return s.setItem("usdrigui",""),s.removeItem("usdrigui"),s}catch{return null}}var gd=s=>JSON.stringify(po(Object.create(s,{notes:{value:s.arrived}})));var go=184,hs=46,yd=26,_c=50,yc=24,ki=10,_g="11.5px system-ui, sans-serif",xo=class{constructor(t){this.session=t,this.scroll=0,this.most=0,this.cells=new Map,this.headings=[],this.front=new Dn(t.character.up,t.section.view)}get elements(){return this.session.elements.list.filter(t=>t.onBoard&&this.session.isShown(t))}place(t,e){if(!this.elements.length)return null;if(e>t){let o=Math.min(.32*e,this.tall(t)+ki);return{left:0,top:e-o,width:t,height:o}}let i=Vt(.1*t,go,1.25*go),r=Math.min(Math.ceil(this.tall(i)/e),Math.max(1,Math.floor(.36*t/i)));return{left:t-r*i,top:0,width:r*i,height:e}}tall(t){let e=Math.max(1,Math.floor(t/go)),n=new Set(this.elements.map(({category:i})=>i)).size;return ki+(n*yc+this.elements.reduce((i,r)=>i+vc(r),0))/e+yd}arrange(t){if(this.rect=t,this.cells=new Map,this.headings=[],!t)return;let e=Math.max(1,Math.floor(t.width/go));this.room=t.width/e-hs-2.6*ki;let n=Math.max(t.height,this.tall(t.width)),i={column:0,top:ki},r=(a,l=a)=>(i.top+l>n&&i.column+1<e&&Object.assign(i,{column:i.column+1,top:ki}),i.top+=a,{left:t.left+i.column*t.width/e+ki,top:t.top+i.top-a-this.scroll}),o=null;for(let a of[...this.elements].sort(bg)){(a.category!==o||!this.cells.size)&&this.headings.push({...r(yc,yc+vc(a)),text:Js(a)}),o=a.category;let l=vc(a);this.cells.set(a,{...r(l),height:l,...this.shape(a)})}this.most=Math.max(0,Math.max(0,...[...this.cells.values()].map(a=>a.top+a.height))+this.scroll-t.top-t.height);for(let a of this.cells.values())a.map=wg(a)}shape(t){let{rest:e}=this.session,{right:n,above:i}=this.front,r=t.members.map(f=>f.track),o=t.members.map((f,p)=>_n(f.values,r[p],e[f.control])),a=f=>p=>vt(ge(p.at(-1),p[0]),[n,i][f]),l=t.axes.length>1?0:Math.atan2(a(1)(r.at(-1)),a(0)(r.at(-1))),[c,h]=[Math.cos(l),Math.sin(l)],d=f=>{let[p,x]=[vt(f,n),vt(f,i)];return[c*p+h*x,h*p-c*x]};return{points:r.flatMap((f,p)=>f.map(x=>d(ge(x,o[p])))),origin:d(o[0]),flat:d,likeness:{members:t.members,tracks:r,origins:o}}}seen(t){return[vt(t,this.front.right),-vt(t,this.front.above)]}mapOf(t){return this.cells.get(t)?.map}heldStill(t){let{tracks:e}=this.cells.get(t).likeness;return{...t,tracks:e}}handleOf(t){let{members:e,tracks:n,origins:i}=this.cells.get(t).likeness;return this.session.elements.handleAt({members:e,tracks:n},this.session.values,i)}contains(t){return!!this.rect&&Zr(this.rect,t)}scrollBy(t){let e=this.scroll;return this.scroll=Vt(this.scroll+t,0,this.most),this.scroll!==e}draw(t){let{rect:e,session:n}=this;if(e){t.globalAlpha=1,t.fillStyle="rgba(36, 39, 43, 0.96)",t.fillRect(e.left,e.top,e.width,e.height),t.textAlign="left",t.font="600 10.5px system-ui, sans-serif",t.fillStyle="#979da6";for(let{left:i,top:r,text:o}of this.headings)t.fillText(o.toUpperCase(),i,r+15);t.font=_g;for(let[i,{left:r,top:o,height:a}]of this.cells){let l=n.hover===i||n.selection.has(i.index);t.fillStyle=l?"#f4f5f7":"#b4bac2",t.fillText(Sg(t,i.label,this.room),r+hs+ki,o+a/2+4)}this.most>0&&this.drawBar(t)}}drawBar(t){let{rect:e,most:n,scroll:i}=this,r=e.height*e.height/(e.height+n);t.fillStyle="rgba(255, 255, 255, 0.25)",t.fillRect(e.left+e.width-4,e.top+i/n*(e.height-r),3,r)}},Js=s=>s.category&&s.heading||"Off the face",Mg=globalThis.matchMedia?.("(pointer: coarse)").matches??!1,vc=s=>s.axes.length>1?_c:Mg?Xs:yd,bg=(s,t)=>s.rank-t.rank||+(s.category>t.category)-+(s.category<t.category)||s.index-t.index;function wg({left:s,top:t,height:e,points:n,origin:i,flat:r}){let o=x=>[Math.min(0,...n.map(m=>m[x])),Math.max(0,...n.map(m=>m[x]))],[[a,l],[c,h]]=[o(0),o(1)],d=Math.min(hs-12,e===_c?e-14:hs),u=Math.min(d/Math.max(l-a,1e-12),(e===_c?d:hs)/Math.max(h-c,1e-12),1e12),[f,p]=[s+hs/2-u*(a+l)/2,t+e/2-u*(c+h)/2];return x=>{let[m,g]=r(x);return[f+u*(m-i[0]),p+u*(g-i[1]),1]}}function Sg(s,t,e){if(s.measureText(t).width<=e)return t;for(let n of[rc(t),""]){let i=t.length-n.length-1;for(;i>1&&s.measureText(`${t.slice(0,i)}…${n}`).width>e;)i--;if(i>1)return`${t.slice(0,i)}…${n}`}return""}var Mc=1e3,yo=class{constructor(t,e){this.session=t,this.view=e,this.search=O("input",{type:"search",class:"search",placeholder:"Search controls  ( / )","aria-label":"Search controls",oninput:()=>this.filter(),onkeydown:n=>n.key==="Escape"&&this.clearSearch()}),this.rows=t.controls.map((n,i)=>this.makeRow(n,i)),this.body=O("div",{class:"rows"},...this.sections()),this.empty=Me("No control has this name."),this.empty.hidden=!0,this.node=O("section",{class:"list","aria-label":"Controls"},this.search,this.body,this.empty),t.on("pose",()=>this.updateValues()),t.on("selection",()=>this.updateMarks(!0)),t.on("hover",()=>this.updateMarks(!1)),t.on("options",()=>this.updateMarks(!1)),t.on("layout",()=>this.body.replaceChildren(...this.sections())),this.shown=new Float64Array(t.controls.length).fill(NaN),this.updateValues(),this.updateMarks(!1)}sections(){let t=new Map;return this.rows.forEach((n,i)=>{let r=this.session.elements.byControl.get(i),o=r?r.onBoard?Js(r):"":"Not in the layout";re(t,o,()=>[]).push(n.node)}),[...t].sort(([n],[i])=>vd(n)-vd(i)).flatMap(([n,i])=>n?[O("h3",{},n),...i]:i)}makeRow(t,e){let{session:n,view:i}=this,r=n.elements.byControl.get(e),o=O("input",{type:"range",min:0,max:Mc,step:1,"aria-label":t.label,oninput:()=>{let f=t.minimum+o.value/Mc*(t.maximum-t.minimum);n.edit(`Set ${t.label}`,()=>n.set([[e,f]]),`list ${e}`)},ondblclick:()=>n.reset([e])}),a={type:"text",inputMode:"decimal",class:"number","aria-label":`${t.label}, value`,onfocus:()=>l.select()},l=Kr(n,e,a,"list"),c=yt("","Lock: neither drags nor pulls change it",()=>n.toggleLock(e),{class:"lock","aria-label":`Lock ${t.label}`}),h=yt(qs(t.label),t.label===t.name?t.name:`${t.label} (${t.name})`,f=>r&&n.reveal(r,f.shiftKey?"toggle":"replace"),{class:"name",tabIndex:-1,"aria-label":t.label}),d=O("i",{class:"chip",style:{background:n.colours[r?.side??"none"]}});return{node:O("div",{class:"row","data-control":t.name,onpointerenter:()=>i.pointAt(e),onpointerleave:()=>i.pointAt(null)},d,h,o,l,c),slider:o,number:l,lock:c,index:e,element:r}}updateValues(){let{session:t,shown:e}=this;for(let{slider:n,number:i,index:r,node:o}of this.rows){let a=t.values[r];if(a===e[r])continue;e[r]=a;let{minimum:l,maximum:c}=t.controls[r],h=c-l;n.value=Mc*(a-l)/h;let d=[a,t.rest[r]].map(u=>100*(u-l)/h);n.style.setProperty("--from",`${Math.min(...d)}%`),n.style.setProperty("--at",`${Math.max(...d)}%`),document.activeElement!==i&&(i.value=t.worded(r)),o.classList.toggle("moved",a!==t.rest[r])}}updateMarks(t){let{session:e}=this,n=null;for(let{node:i,lock:r,element:o,index:a}of this.rows){let l=o!==void 0&&e.selection.has(o.index);i.classList.toggle("selected",l),i.classList.toggle("hovered",o!==void 0&&e.hover===o),Zn(r,{"aria-pressed":e.locks.has(a)}),l&&(n??=i)}t&&n&&!this.node.contains(document.activeElement)&&n.scrollIntoView({block:"nearest"})}filter(){let t=this.search.value.toLowerCase().split(/\s+/).filter(Boolean),e=({index:r})=>{let{name:o,label:a,source:l}=this.session.controls[r],c=`${o} ${a} ${l}`.toLowerCase();return t.every(h=>c.includes(h))},n=0;for(let r of this.rows)r.node.hidden=!e(r),n+=r.node.hidden?0:1;this.body.classList.toggle("searching",t.length>0),this.empty.hidden=n>0;let i=this.rows.filter(r=>t.length&&!r.node.hidden&&r.element).map(r=>r.element);t.length&&this.session.select(new Set(i))}clearSearch(){this.search.value="",this.filter(),this.session.select([])}},vd=s=>s===""?0:s==="Not in the layout"?2:1;var bc=[["Front",0,0],["¾",.7,.05],["Side",Math.PI/2,0],["Back",Math.PI,0]],vo=class{constructor(t){this.app=t,this.groups=[this.chooser(),this.tabs(),...this.toggles(),this.looks(),t.live?.makeNode(),this.study()].filter(Boolean),this.row=O("div",{class:"bar-row"}),this.menu=O("details",{class:"menu"},O("summary",{title:"More","aria-label":"More"},"⋯"),O("div",{class:"menu-items"})),this.title=O("h1",{},t.scene.title),this.node=O("header",{class:"bar"},this.title,this.row,this.menu,this.always()),new ResizeObserver(()=>this.fit()).observe(this.node)}fit(){let t=this.menu.lastElementChild;this.row.replaceChildren(),t.replaceChildren(),this.menu.hidden=!1;for(let e of this.groups)this.row.append(e),this.row.scrollWidth>this.row.clientWidth&&t.append(e);this.menu.hidden=!t.children.length}act(t,e,n,i=t){return yt(t,e,n,{"aria-label":i})}always(){let{app:t}=this;return O("div",{class:"group"},this.act("↶","Undo (Ctrl+Z)",()=>t.undo(),"Undo"),this.act("↷","Redo (Ctrl+Shift+Z)",()=>t.redo(),"Redo"),this.act("Key","Key the selected controls and all that changed, at this frame (K)",()=>t.timeline.key()),this.panel("inspector","Panel","Selection, display, poses, layout (P)"),this.act("?","Gestures and keys (?)",()=>t.showHelp(),"Shortcuts"))}panel(t,e,n){return this.app.session.updating(Nn(e,n,()=>!this.app[t].node.hidden,()=>this.app.fold(t)))}chooser(){let{scene:t,index:e}=this.app;if(t.characters.length<2)return null;let n=t.characters.map(({root:i},r)=>O("option",{value:r,selected:r===e},i));return O("select",{"aria-label":"Character",onchange:({target:i})=>this.app.open(Number(i.value))},...n)}tabs(){let{session:t}=this.app,{sections:e}=t.character.layout;if(e.length<2)return null;let n=e.map((r,o)=>[r,r.title,`Show: ${r.title} (${o+1} of ${e.length})`]),i=fi("Part",n,()=>t.section,r=>t.show(e.indexOf(r)));return t.on("section",()=>i.update()),i}toggles(){let{app:t}=this,{session:e}=t,n=(i,r,o)=>e.updating(Nn(r,o,()=>e.options[i],()=>e.flipOption(i)));return[n("symmetric","Symmetry","Both sides at once (S)"),this.panel("list","List","All controls as sliders (C)"),this.panel("review","Review","Notes: words and strokes at frames, to send and to open (N)"),n("handles","Handles","Show or hide the handles (H)"),e.updating(fi("Where the controls are",[["face","On face","Controls on the face"],["beside","On copy","Controls on a copy of the face, the clean face next to it"]],()=>e.options.arrangement,i=>t.setArrangement(i))),n("rearrange","Rearrange","Drag elements to other points of the face")]}looks(){let t=([e,n,i])=>this.act(e,`View: ${e}`,()=>this.app.view.home(n,i),`View: ${e}`);return O("div",{class:"group looks"},...bc.map(t))}study(){return"study"in document.body.dataset?this.act("Evaluate","Match target faces with three interfaces",()=>this.app.evaluation.open()):null}};var _o=class{constructor(t){this.app=t,this.device="",this.rows=null,this.taken=null,this.path=0,this.pressed=null;for(let e of["pointerdown","pointermove","pointerup"])t.node.addEventListener(e,n=>this.follow(n),!0)}record(t){Object.assign(this,{rows:t,taken:null,pressed:null,last:null,path:0})}follow(t){if(!this.rows)return;let{clientX:e,clientY:n,type:i}=t;if(this.last&&(this.path+=Math.hypot(e-this.last[0],n-this.last[1])),this.last=[e,n],this.device=t.pointerType,i==="pointerdown"){let r=t.target.closest?.('[data-control] input[type="range"]');this.pressed={at:performance.now(),x:e,y:n,pixels:this.path,slider:r?.closest("[data-control]").dataset.control},this.path=0}else i==="pointerup"&&this.pressed&&this.release(e,n)}take(t){this.taken??=t.members.map(({control:e})=>this.app.session.controls[e].name).join("+")}release(t,e){let{slider:n,...i}=this.pressed,r=this.taken??n??"";r?(this.rows.push({event:"grab",control:r,...i}),this.rows.push({event:"release",control:r,at:performance.now(),x:t,y:e,pixels:this.path}),this.path=0):this.isNearHandle(i)&&this.rows.push({event:"miss",control:r,...i}),Object.assign(this,{pressed:null,taken:null})}isNearHandle({x:t,y:e}){let{view:n}=this.app,{left:i,top:r}=n.node.getBoundingClientRect();return n.session.options.handles&&n.overlay.drawn.some(({handle:o,width:a})=>Math.hypot(o[0]+i-t,o[1]+r-e)<2*a)}};var us=class{done=[];undone=[];push(t,e,n,i=null,r=[]){let o=performance.now(),a=this.done.at(-1);i&&a?.merge===i&&o-a.when<900?Object.assign(a,{redo:n,when:o,states:[...a.states,...r]}):this.done.push({label:t,undo:e,redo:n,merge:i,states:r,when:o}),this.done.length>200&&this.done.shift(),this.undone=[]}get states(){return[...this.done,...this.undone].flatMap(({states:t})=>t)}undo(){let t=this.done.pop();return t?(t.undo(),this.undone.push({...t,merge:null}),t.label):null}redo(){let t=this.undone.pop();return t?(t.redo(),this.done.push(t),t.label):null}};var Ag=["amateur","professional"],wc={list:"Slider list",face:"Controls on the face",beside:"Controls on a copy beside the face"},js=[["list","face","beside"],["face","beside","list"],["beside","list","face"],["list","beside","face"],["face","list","beside"],["beside","face","list"]],wd=[1,2],Sd=[6,8],Eg=13,ds=wd.length+Sd.length+1,Sc=3*(ds-1)+1,Tg=.02,Cg=.1,Rg=2,Ig={overall_list:["Working with the slider list","poor","good"],overall_face:["Working with the controls on the face","poor","good"],overall_beside:["Working with the controls on a copy beside the face","poor","good"],easy:["On the face: I could make the expressions without effort","no","yes"],unexpected:["On the face: a control did something else than I thought","never","often"],cluttered:["On the face: there was too much in one place","no","yes"],placed:["On the face: a control stood where it acts","no","yes"],direct:["On the face: it felt like moving the face itself","no","yes"]};function Cc(s,t,e=null){let n=Ac(s),i=Ed(20230806),[r,o]=e?Pg(e,t):[Ec(t,Eg,i),n.map(()=>[...wd,...Sd].map(a=>Ec(t,a,i)))];return n.flatMap((a,l)=>[...o[l].map((c,h)=>({block:l+1,name:a,face:`${l+1}${"abcd"[h]}`,target:c})),{block:l+1,name:a,face:"common",target:r}])}var Ac=s=>js[(s-1)%js.length];function Pg(s,t){let e=Ad(s,t),n=js[0].map((i,r)=>[0,1,2,3].map(o=>e[r+3*o]));return[e[e.length-1],n]}function Ad(s,t){let e=r=>Float64Array.from(t.rest,(o,a)=>r.get(a)??o),n=r=>r.reduce((o,a,l)=>o+(a!==t.rest[l]?1:0),0);return s.map(e).map((r,o)=>({each:r,i:o,count:n(r)})).filter(({count:r})=>r).sort((r,o)=>r.count-o.count||r.i-o.i).map(({each:r})=>r)}function _d(s,t){let{length:e}=Ad(s,t);return e<Sc?`${e} of the poses given move a control of this character; the evaluation needs ${Sc}.`:""}function Lg({animation:s,controls:t,rest:e}){let n=(a,l)=>t.map(({minimum:c,maximum:h},d)=>Math.abs(a[d]-l[d])/(h-c||1)),i=s.times(new Map).map(a=>{let{values:l}=s.clipAt(a);return n(l,e).map((c,h)=>c>Tg?l[h]:e[h])}),r=new Set,o=i.map(a=>Math.max(...n(a,e)));for(;r.size<Sc&&Math.max(...o)>Cg;){let a=o.indexOf(Math.max(...o));r.add(a),o=o.map((l,c)=>Math.min(l,Math.max(...n(i[c],i[a]))))}return i.filter((a,l)=>r.has(l)).map(a=>new Map(a.entries()))}function Ng(s,t,e=null){let n=Ed(20210806),i=js[0].map(()=>Ec(t,Rg,n));return Cc(s,t,e).flatMap((r,o)=>{let{block:a,name:l}=r;return o%ds?[r]:[{block:a,name:l,face:"practice",target:i[a-1]},r]})}function Ec(s,t,e){let n=Float64Array.from(s.rest),i=s.elements.list.filter(o=>!o.onBoard),r=[...i.length>=t?i:s.elements.list];for(let o=0;o<t&&r.length;o++){let[a]=r.splice(Math.floor(e()*r.length),1),{control:l}=a.members[Math.floor(e()*a.members.length)],{minimum:c,maximum:h}=s.controls[l],d=h>s.rest[l]?h:c;n[l]+=(.4+.6*e())*(d-s.rest[l])}return n}function Ed(s){let t=s;return()=>{t=t+1831565813|0;let e=Math.imul(t^t>>>15,1|t);return e=e+Math.imul(e^e>>>7,61|e)^e,((e^e>>>14)>>>0)/4294967296}}function Md(s,t,e,n=null){let i=0,r=0;for(let o=0;o<t.length;o++){let a=n&&n[o]||1;i+=((s[o]-t[o])/a)**2,r+=((e[o]-t[o])/a)**2}return r>0?i/r:0}var bd=["participant","block","interface","trial","face","target_controls","seconds","share_of_time","edits","weight_error_squared","vertex_error_squared","question","answer","paused","face_pixels","target_pixels","window","device","level","order","targets","character","layout","version"],Dg=["participant","trial","face","interface","event","seconds","control","x","y","pixels"];function Og(s,t,e={},n={}){let i=Tc(t),r=t.map((l,c)=>({block:l.block,interface:l.name,trial:c+1,face:l.face,target_controls:l.controls,seconds:l.seconds.toFixed(2),share_of_time:(i?l.seconds/i:0).toFixed(5),edits:l.edits,weight_error_squared:l.weightError.toFixed(6),vertex_error_squared:l.vertexError.toFixed(6),paused:(l.paused??0).toFixed(2),face_pixels:(l.facePixels??0).toFixed(1),target_pixels:(l.targetPixels??0).toFixed(1),window:l.window,device:l.device})),o=Object.entries(e).map(([l,c])=>({question:l,answer:Td(c)})),a=[...r,...o].map(l=>({participant:s,...n,...l}));return`${[bd,...a.map(l=>bd.map(c=>l[c]??""))].map(l=>l.join(",")).join(`
`)}
`}var Tc=s=>s.reduce((t,{seconds:e})=>t+e,0);function Fg(s,t){let e=t.flatMap(({face:n,name:i,events:r=[]},o)=>r.map(({event:a,at:l,control:c,x:h,y:d,pixels:u})=>[s,o+1,n,i,a,(l/1e3).toFixed(3),Td(c),Math.round(h),Math.round(d),Math.round(u)].join(",")));return`${[Dg.join(","),...e].join(`
`)}
`}var Td=s=>typeof s=="number"?s:`"${s.replace(/"/g,'""').replace(/\s+/g," ")}"`,Mo=class{constructor(t){this.app=t,this.running=null,this.trials=[],this.results=[],this.panel=O("div",{class:"evaluation",hidden:!0,role:"dialog","aria-label":"Evaluation"}),this.hand=new _o(t),t.session.on("edited",()=>this.running&&this.running.edits++),t.session.on("dragging",()=>this.running&&t.session.dragging?.members&&this.hand.take(t.session.dragging))}open(){let t=O("input",{type:"number",min:1,value:1,"aria-label":"Participant number"}),e=Me(),n=()=>{let u=Ac(Math.max(1,Number(t.value))).map(f=>wc[f]);e.textContent=`Order: ${u.join(" → ")}`};t.addEventListener("input",n),n();let i=O("input",{type:"checkbox"}),r=(u,f)=>O("select",{"aria-label":u},...f.map(p=>O("option",{value:p},p||"choose"))),o=r("Experience",["",...Ag]),a=this.sets(),l=r("Target faces",[...a.keys()]),c=yt("Start","",()=>{this.setting={level:o.value,targets:l.value},this.start(Math.max(1,Math.floor(Number(t.value))||1))},{class:"primary"}),h=()=>c.disabled=!i.checked||!o.value;for(let u of[i,o])u.addEventListener("change",h);h();let d=this.kept();this.show(O("h2",{},"Match the target face"),O("p",{},"Fifteen faces, five with each of three interfaces, and one to practise on before each five. Change your face until it looks like the target, then press Done. Pulling the skin, shortcuts and playback are off, so that the interfaces can be compared."),di("Participant",t),e,di("I animate faces as",o),di("Target faces",l),Me(this.lacking),O("label",{class:"field"},i,O("span",{},"I agree that my times, errors, answers and what my pointer does are saved under this number, without my name, and may be published. I can stop at any time.")),je(c,d&&yt(`Go on with participant ${d.participant}`,`${d.results.length} of 15 faces are done`,()=>{this.setting=d.setting,this.start(d.participant,d.results)}),yt("Cancel","",()=>this.close())))}sets(){let{session:t,targets:e}=this.app,n=a=>a.map(({values:l})=>l),i=n(e.flatMap(a=>gc(a,t))),r=new Map,o=(a,l)=>_d(l,t)||r.set(a,l);return o("the poses given",i),o("the shelf",n(t.shelf)),r.set("drawn from the controls",null),o("the clip",Lg(t)),this.lacking=e.length?_d(i,t):"",r}get slot(){return`usdrigui study ${this.app.session.character.identity}`}kept(){return hn(this.app.storage?.getItem(this.slot))}keep(t){try{t?this.app.storage?.setItem(this.slot,JSON.stringify({participant:this.participant,results:t,setting:this.setting})):this.app.storage?.removeItem(this.slot)}catch{this.app.say("This browser has no room to keep the session: finish it without closing the page")}}show(...t){this.panel.replaceChildren(...t),this.panel.classList.remove("strip"),this.panel.hidden=!1}start(t,e=[]){let{session:n,timeline:i}=this.app;i.stop(),n.trial=!0,this.before={work:n.snapshot(),history:n.history,options:{...n.options}},this.participant=t,this.results=e,this.setting={...this.setting,order:Ac(t).join("-"),...this.app.identity()},this.trials=Ng(t,n,this.sets().get(this.setting.targets)).slice(Math.floor(e.length/ds)*(ds+1)),this.trials.splice(1,e.length%ds),this.next()}next(){let t=this.trials.shift();if(!t){this.ask();return}let{session:e}=this.app;e.history=new us,e.select([]),e.clear(),this.neutral=Float32Array.from(e.deformer.points),this.targetPoints=Float32Array.from(e.deformer.pose(t.target)),e.reshape(),this.app.arrangeForTrial(t.name,this.targetPoints),this.running={...t,began:performance.now(),paused:0,edits:0,events:[]},this.hand.record(this.running.events);let n=t.face==="practice"?"practice, not counted":`${this.results.length+1} of ${js[0].length*ds}`;this.show(O("span",{class:"strip-title"},wc[t.name]),O("span",{class:"hint"},n),yt("Done","",()=>this.done(),{class:"primary"}),yt("Pause","",i=>this.pause(i.target)),yt("Stop","",()=>this.finish())),this.panel.classList.add("strip")}pause(t){let{running:e}=this,n=performance.now();e.since&&(e.paused+=n-e.since),e.since=e.since?0:n,this.app.node.classList.toggle("paused",!!e.since),t.textContent=e.since?"Go on":"Pause"}done(){let{session:t,view:e}=this.app;this.running.since&&this.pause(O("i"));let{target:n,began:i,paused:r,events:o,...a}=this.running;this.running=null,a.face!=="practice"&&(this.results.push({...a,seconds:(performance.now()-i-r)/1e3,paused:r/1e3,facePixels:e.faceHeight(a.name==="face"?"controls":"clean"),targetPixels:e.faceHeight("target"),window:`${window.innerWidth}x${window.innerHeight}@${window.devicePixelRatio}`,device:this.hand.device,events:o.map(l=>({...l,at:l.at-i})),controls:[...n.keys()].filter(l=>n[l]!==t.rest[l]).length,weightError:Md(t.values,n,t.rest,t.controls.map(({minimum:l,maximum:c})=>c-l)),vertexError:Md(t.deformer.points,this.targetPoints,this.neutral)}),this.keep(this.results)),this.next()}finish(){this.leave(),this.results.length?this.thank({}):this.close()}leave(){this.running=null,this.hand.record(null),this.app.node.classList.remove("paused"),this.app.session.trial&&this.app.endTrials(this.before)}ask(){this.leave();let t=Object.entries(Ig).map(([i,[r,o,a]])=>{let l=[1,2,3,4,5].map(c=>O("label",{},O("input",{type:"radio",name:i,value:c,required:!0,"aria-label":`${r}: ${c} of 5`}),String(c)));return O("fieldset",{class:"question"},O("legend",{},r),O("span",{class:"hint"},o),...l,O("span",{class:"hint"},a))}),e=O("textarea",{"aria-label":"What else you would like to say",placeholder:"What else you would like to say",rows:2}),n=O("form",{class:"questions",onsubmit:i=>{i.preventDefault();let r=Object.fromEntries([...new FormData(n)].map(([o,a])=>[o,Number(a)]));this.thank(e.value.trim()?{...r,comment:e.value.trim()}:r)}},...t,e,je(O("button",{type:"submit",class:"primary"},"Done")));this.show(O("h2",{},"How was it?"),n)}thank(t){let e=Og(this.participant,this.results,t,this.setting),n=()=>{Mn(`evaluation-${this.participant}.csv`,e,"text/csv"),Object.keys(t).length&&this.keep(null)};this.show(O("h2",{},"Thank you"),this.summary(),je(yt("Save CSV","",n,{class:"primary"}),yt("Save events","",()=>Mn(`events-${this.participant}.csv`,Fg(this.participant,this.results),"text/csv")),yt("Close","",()=>this.close())))}summary(){let t=Object.entries(wc).map(([n,i])=>{let r=this.results.filter(c=>c.name===n),o=c=>r.length?(r.reduce((h,d)=>h+d[c],0)/r.length).toFixed(3):"–",a=Tc(r),l=[i,`${a.toFixed(0)} s`,`${Math.round(100*a/Tc(this.results))} %`,o("weightError"),o("vertexError")];return O("tr",{},...l.map(c=>O("td",{},c)))}),e=["","Time","Share","Weight error","Vertex error"].map(n=>O("th",{},n));return O("table",{},O("tr",{},...e),...t)}close(){this.panel.hidden=!0}};function Rc(s){let t=ui(s,$s(s,s.values));return`${JSON.stringify({usdrigui:"pose",root:s.character.root,values:t},null,2)}
`}function Cd(s,t){let e=hn(s,void 0);if(e===void 0)throw new Error("This is not JSON.");let n=e?.values??e;if(n===null||typeof n!="object"||Array.isArray(n))throw new Error("This JSON holds no pose.");let i=Ln(n,t.controls);if(!i.size&&Object.keys(n).length)throw new Error("No control of this character is named in the pose.");return as(t,{values:i}).entries()}var Qs=256,Rd=.75;function Id({pupil:s,iris:t,white:e,radii:n}){let i=new Float32Array(3*Qs);for(let r=0;r<Qs;r++){let o=(r+.5)*Rd/Qs,a=1-.6*gi(.75*n[1],n[1],o),l=gi(n[0]-.015,n[0]+.015,o),c=gi(n[1]-.025,n[1]+.025,o);for(let h=0;h<3;h++){let d=s[h]+l*(a*t[h]-s[h]);i[3*r+h]=(d+c*(e[h]-d))/e[h]}}return{factors:i,perRadius:Qs/Rd,last:Qs-1}}function Pd(s,t){let e=new Uint8Array(s.length/3);for(let n=0,i=0;n<s.length;n+=3,i++)e[i]=[0,1,2].every(r=>Math.abs(t[2*s[n+r]])<3)?1:0;return e}function gi(s,t,e){let n=Vt((e-s)/(t-s),0,1);return n*n*(3-2*n)}var Od="#1f2124",Ld=-14409441,Ic=[-.4,.52,.755],Pc=[.7,-.05,.71],Ye=5,Ug=.3,Nd=1/16,kg=1e-4,Lc=.5,Nc=254,Dc=.5,tr=.001,xi=class{pixels;nearness;tiles;across;wide;high;box;size;constructor(t,e){this.canvas=t,this.pen=t.getContext("2d",{alpha:!1}),this.surface=e,this.left=0,this.top=0,this.screen=null,this.before=null,this.colours=null,this.changed=null,this.used=Uint32Array.from(new Set(e.triangles)),this.mapped=new Float64Array(7),this.view=[],this.resize(1,1,1)}resize(t,e,n){this.ratio=n,this.size=[t,e],this.wide=Math.max(1,Math.round(t*n)),this.high=Math.max(1,Math.round(e*n)),this.image=this.pen.createImageData(this.wide,this.high),this.pixels=new Int32Array(this.image.data.buffer),this.nearness=new Float32Array(this.pixels.length),this.across=(this.wide>>Ye)+1,this.tiles=new Uint8Array(this.across*((this.high>>Ye)+1)),this.box=null,this.view=[]}draw(t,e,n){let i=t.map(n),r=this.seesAgain(t,e,i);r||this.wipe();let o=[1/0,1/0,0,0];t.forEach((a,l)=>{if(!i[l])return;this.prepare(i[l],a,e),r&&this.isMuch()&&(r=!1,this.wipe()),r&&this.wipeMoved();let c=this.frameOf(a);o=this.extended(o,c),this.fill(c)}),this.show(this.cover(o)&&r)}extended(t,e){let n=zg(this.screen,this.used);return[0,1,2,3].map(i=>{let[r,o]=i<2?[Math.max,Math.min]:[Math.min,Math.max];return o(t[i],r(e[i],n[i]))})}cover(t){let{ratio:e,canvas:n,wide:i,high:r}=this,o=Jr(t.map(a=>a/e),this.box,this.size);return o===this.box?!0:(this.box=o,[this.left,this.top]=[Math.round(o[0]*e),Math.round(o[1]*e)],n.width=Math.max(1,Math.min(i,Math.round(o[2]*e))-this.left),n.height=Math.max(1,Math.min(r,Math.round(o[3]*e))-this.top),jr(n,o),!1)}isMuch(){let{changed:t}=this;return t.reduce((e,n)=>e+n,0)>Ug*t.length}seesAgain(t,{position:e,right:n,above:i},r){let o=r[0]?[r[0].points,r[0].colours]:[],a=[t.length,...t.flatMap(({left:c,top:h,width:d,height:u})=>[c,h,d,u]),...e,...n,...i,...o],l=t.length===1&&$n(a,this.view);return this.view=a,l}prepare(t,e,n){let{length:i}=t.points;[this.screen,this.before]=[this.before??new Float32Array(i),this.screen??new Float32Array(i)],(this.changed??=new Uint8Array(i/3)).fill(0),this.paint=t.paint,this.project(t.points,e,n),this.light(t,n)}wipe(){this.pixels.fill(Ld),this.nearness.fill(0),this.tiles.fill(1)}wipeMoved(){let{changed:t,tiles:e,across:n,wide:i,high:r,pixels:o,nearness:a}=this,{triangles:l}=this.surface;e.fill(0);for(let c=0;c<l.length;c+=3)t[l[c]]|t[l[c+1]]|t[l[c+2]]&&(this.markTiles(this.before,c),this.markTiles(this.screen,c));for(let c=0;c<e.length;c++){if(!e[c])continue;let h=c%n<<Ye,d=Math.floor(c/n)<<Ye,u=Math.min(i,h+(1<<Ye)),f=Math.min(r,d+(1<<Ye));for(let p=d;p<f;p++)o.fill(Ld,p*i+h,p*i+u),a.fill(0,p*i+h,p*i+u)}}markTiles(t,e){let{tiles:n,across:i,wide:r,high:o}=this,{triangles:a,facing:l}=this.surface,c=3*a[e],h=3*a[e+1],d=3*a[e+2],u=t[c],f=t[c+1],p=t[h],x=t[h+1],m=t[d],g=t[d+1];if(l[e/3]*((p-u)*(g-f)-(x-f)*(m-u))>0)return;let M=Math.max(0,Math.ceil(Math.min(u,p,m)))>>Ye,A=Math.min(r-1,Math.floor(Math.max(u,p,m)))>>Ye,b=Math.max(0,Math.ceil(Math.min(f,x,g)))>>Ye,T=Math.min(o-1,Math.floor(Math.max(f,x,g)))>>Ye;for(let E=b;E<=T;E++)for(let y=M;y<=A;y++)n[E*i+y]=1}isOpen(t,e,n,i){let{tiles:r,across:o}=this;for(let a=n>>Ye;a<=i>>Ye;a++)for(let l=t>>Ye;l<=e>>Ye;l++)if(r[a*o+l])return!0;return!1}show(t){let{canvas:e,left:n,top:i}=this,[r,o,a,l]=t?this.openTiles():[n,i,n+e.width,i+e.height];a>r&&this.pen.putImageData(this.image,-n,-i,r,o,a-r,l-o)}openTiles(){let{tiles:t,across:e}=this,[n,i,r,o]=[1/0,1/0,0,0];return t.forEach((a,l)=>{if(!a)return;let[c,h]=[l%e,Math.floor(l/e)];[n,i,r,o]=[Math.min(n,c),Math.min(i,h),Math.max(r,c+1),Math.max(o,h+1)]}),[n,i,r,o].map(a=>a<<Ye)}frameOf({left:t,top:e,width:n,height:i}){let{wide:r,high:o,ratio:a}=this,l=(c,h)=>Vt(Math.round(c*a),0,h);return[l(t,r),l(e,o),l(t+n,r),l(e+i,o)]}project(t,e,{position:n,right:i,above:r,towards:o,half:a}){let{screen:l,before:c,changed:h}=this,d=this.ratio*e.height/(2*a),u=this.ratio*(e.left+e.width/2)-.5,f=this.ratio*(e.top+e.height/2)-.5,[p,x,m]=n,[g,M,A]=i,[b,T,E]=r,[y,w,D]=o;for(let C=0;C<t.length;C+=3){let L=t[C]-p,F=t[C+1]-x,W=t[C+2]-m,I=-(L*y+F*w+W*D),z=I>1e-9?1/I:0,q=u+(L*g+F*M+W*A)*z*d,G=f-(L*b+F*T+W*E)*z*d;if(Math.abs(q-c[C])<Nd&&Math.abs(G-c[C+1])<Nd&&Math.abs(z-c[C+2])<=kg*z){l[C]=c[C],l[C+1]=c[C+1],l[C+2]=c[C+2];continue}l[C]=q,l[C+1]=G,l[C+2]=z,h[C/3]=1}}light({points:t,normals:e,paint:n,colours:i},{position:r,right:o,above:a,towards:l}){let c=this.colours??=new Float32Array(t.length),{changed:h}=this,[d,u,f]=o,[p,x,m]=a,[g,M,A]=l;for(let b=0,T=0;b<t.length;b+=3,T+=4){let E=Math.sqrt(e[b]*e[b]+e[b+1]*e[b+1]+e[b+2]*e[b+2]),y=E>0?1/E:0,w=y*(e[b]*d+e[b+1]*u+e[b+2]*f),D=y*(e[b]*p+e[b+1]*x+e[b+2]*m),C=y*(e[b]*g+e[b+1]*M+e[b+2]*A);C<.1&&Gg(e,t,b,y,r)&&(w=-w,D=-D,C=-C);let L=Math.max(0,w*Ic[0]+D*Ic[1]+C*Ic[2]),F=Math.max(0,w*Pc[0]+D*Pc[1]+C*Pc[2]),W=.5+.5*D,I=1-Math.abs(C),z=I*I*I*.035,q=i[b],G=i[b+1],tt=i[b+2];n[T]>2&&([q,G,tt]=Wg(n[T]/255,[q,G,tt])),q=Lc+Nc*Math.min(1,q*Math.sqrt(.2*W+.8*L+.2*F)+z),G=Lc+Nc*Math.min(1,G*Math.sqrt(.21*W+.77*L+.22*F)+z),tt=Lc+Nc*Math.min(1,tt*Math.sqrt(.23*W+.73*L+.26*F)+z),!(Math.abs(c[b]-q)<Dc&&Math.abs(c[b+1]-G)<Dc&&Math.abs(c[b+2]-tt)<Dc)&&(c[b]=q,c[b+1]=G,c[b+2]=tt,h[b/3]=1)}}fill(t){let{screen:e}=this,{triangles:n,facing:i,eyes:r,texturing:o}=this.surface,a=o?.on,[l,c,h,d]=t;for(let u=0,f=0;u<n.length;u+=3,f++){let p=3*n[u],x=3*n[u+1],m=3*n[u+2],g=e[x]-e[p],M=e[x+1]-e[p+1],A=e[m]-e[p],b=e[m+1]-e[p+1],T=g*b-M*A;if(i[f]*T>0||T===0||e[p+2]===0||e[x+2]===0||e[m+2]===0)continue;let E=Math.max(l,Math.ceil(Math.min(e[p],e[x],e[m]))),y=Math.min(h-1,Math.floor(Math.max(e[p],e[x],e[m])));if(E>y)continue;let w=Math.max(c,Math.ceil(Math.min(e[p+1],e[x+1],e[m+1]))),D=Math.min(d-1,Math.floor(Math.max(e[p+1],e[x+1],e[m+1])));w>D||!this.isOpen(E,y,w,D)||(r[f]?this.eye(p,x,m,1/T,E,y,w,D):this.triangle(p,x,m,1/T,E,y,w,D,a?.[f]?u:-1))}}triangle(t,e,n,i,r,o,a,l,c){let{screen:h,colours:d,pixels:u,nearness:f,wide:p}=this,x=h[t],m=h[t+1],g=(h[n+1]-m)*i,M=(x-h[n])*i,A=(m-h[e+1])*i,b=(h[e]-x)*i,T=h[t+2],E=h[e+2]-T,y=h[n+2]-T,w=g*E+A*y,D=M*E+b*y,C=256*d[t],L=256*d[e]-C,F=256*d[n]-C,W=g*L+A*F,I=M*L+b*F,z=256*d[t+1],q=256*d[e+1]-z,G=256*d[n+1]-z,tt=g*q+A*G,X=M*q+b*G,Q=256*d[t+2],et=256*d[e+2]-Q,Mt=256*d[n+2]-Q,Dt=g*et+A*Mt,K=M*et+b*Mt,pt=tt|0,_t=((Dt|0)<<16)+(W|0)|0,{mapped:At}=this;c>=0&&this.mapping(t,e,n,c,g,M,A,b);let ht=t,It=e,oe=n,Ct=0;h[It+1]<h[ht+1]&&(Ct=ht,ht=It,It=Ct),h[oe+1]<h[It+1]&&(Ct=It,It=oe,oe=Ct),h[It+1]<h[ht+1]&&(Ct=ht,ht=It,It=Ct);let qt=h[ht],Yt=h[ht+1],kt=h[It],pe=h[It+1],ve=h[oe],De=h[oe+1],ae=(ve-qt)/(De-Yt),cn=(kt-qt)/(pe-Yt),be=(ve-kt)/(De-pe),Xe=qt+(pe-Yt)*ae<kt;for(let ue=a;ue<=l;ue++){let qe=qt+(ue-Yt)*ae,N=ue<pe?qt+(ue-Yt)*cn:kt+(ue-pe)*be,Oe=Math.max(r,Math.ceil((Xe?qe:N)-tr)),ne=Math.min(o,Math.floor((Xe?N:qe)+tr));if(!(Oe<=ne))continue;let jt=Oe-x,rt=ue-m,de=T+jt*w+rt*D,Rt=z+jt*tt+rt*X|0,Lt=(Q+jt*Dt+rt*K<<16)+(C+jt*W+rt*I|0)|0;if(c>=0){let S=At[0]+jt*At[1]+rt*At[2]|0,v=At[3]+jt*At[4]+rt*At[5]|0;this.texturedRow(ue*p+Oe,ue*p+ne,de,w,Rt,pt,Lt,_t,S,At[1]|0,v,At[4]|0,At[6]);continue}for(let S=ue*p+Oe,v=ue*p+ne;S<=v;S++)de>f[S]&&(f[S]=de,u[S]=-16777216|Lt>>>8&16711935|Rt&65280),de+=w,Rt=Rt+pt|0,Lt=Lt+_t|0}}mapping(t,e,n,i,r,o,a,l){let{mapped:c,paint:h}=this,{corners:d,places:u,width:f,height:p}=this.surface.texturing,x=2*d[i],m=2*d[i+1],g=2*d[i+2];for(let A=0;A<2;A++){let b=65536*(A?p:f),T=b*u[x+A],E=b*u[m+A]-T,y=b*u[g+A]-T;c[3*A]=T,c[3*A+1]=r*E+a*y,c[3*A+2]=o*E+l*y}let M=h[4*t/3]+h[4*e/3]+h[4*n/3];c[6]=M>8?Math.round(255*.85*gi(.01,.2,M/765)):0}texturedRow(t,e,n,i,r,o,a,l,c,h,d,u,f){let{pixels:p,nearness:x}=this,{texels:m,width:g}=this.surface.texturing;for(;t<=e;t++){if(n>x[t]){let M=m[(d>>16)*g+(c>>16)];if(M<0){x[t]=n,f&&(M=Bg(M,f));let A=(M>>16&255)*(a>>>16)&16711680,b=(M>>8&255)*r>>8&65280;p[t]=-16777216|A|b|(M&255)*(a&65535)>>16}}n+=i,r=r+o|0,a=a+l|0,c=c+h|0,d=d+u|0}}eye(t,e,n,i,r,o,a,l){let{screen:c,colours:h,pixels:d,nearness:u,surface:f}=this,{gaze:p,tints:x}=f,{factors:m,perRadius:g,last:M}=x,[A,b,T]=[2*t/3,2*e/3,2*n/3],E=(c[n+1]-c[t+1])*i,y=(c[t]-c[n])*i,w=(c[t+1]-c[e+1])*i,D=(c[e]-c[t])*i;for(let C=a;C<=l;C++){let L=(r-c[t])*E+(C-c[t+1])*y,F=(r-c[t])*w+(C-c[t+1])*D;for(let W=r,I=C*this.wide+r;W<=o;W++,I++,L+=E,F+=w){let z=1-L-F;if(z<-tr||L<-tr||F<-tr)continue;let q=z*c[t+2]+L*c[e+2]+F*c[n+2];if(q<=u[I])continue;u[I]=q;let G=z*p[A]+L*p[b]+F*p[T],tt=z*p[A+1]+L*p[b+1]+F*p[T+1],X=3*Math.min(M,Math.floor(Math.sqrt(G*G+tt*tt)*g)),Q=m[X]*(z*h[t]+L*h[e]+F*h[n]),et=m[X+1]*(z*h[t+1]+L*h[e+1]+F*h[n+1]),Mt=m[X+2]*(z*h[t+2]+L*h[e+2]+F*h[n+2]);d[I]=-16777216|Mt<<16|et<<8|Q}}}};function Bg(s,t){let e=n=>((s>>n&255)*(255-t)+255*t)/255;return-16777216|e(16)<<16|e(8)<<8|e(0)}function zg(s,t){let e=new Float64Array([1/0,1/0,-1/0,-1/0]);for(let n=0;n<t.length;n++){let i=s[3*t[n]],r=s[3*t[n]+1];i<e[0]&&(e[0]=i),r<e[1]&&(e[1]=r),i>=e[2]&&(e[2]=i+1),r>=e[3]&&(e[3]=r+1)}return e}function Gg(s,t,e,n,i){let r=t[e]-i[0],o=t[e+1]-i[1],a=t[e+2]-i[2];return n*(s[e]*r+s[e+1]*o+s[e+2]*a)>.3*Math.sqrt(r*r+o*o+a*a)}var Dd=[.2,.24,.62],Vg=[.78,.2,.44],Hg=[1,.82,.3];function Wg(s,t){let e=.85*gi(.01,.2,s),n=gi(0,.5,s),i=gi(.45,1,s);return t.map((r,o)=>{let a=Dd[o]+n*(Vg[o]-Dd[o]);return r+e*(a+i*(Hg[o]-a)-r)})}var Fn=112,Xg=2;function Fd(s,t){let{character:e,section:n,elements:i}=s,r=new Dn(e.up,n.view),a=i.list.filter(m=>s.isShown(m)&&!m.onBoard).map(({restPoint:m})=>m);r.frame(a.length?a:[...qg(t.skin.points)],Fn,Fn,1.35);let l=new xi(O("canvas"),t);l.resize(Fn,Fn,Xg),t.refresh();let c={...t.skin,paint:new Uint8Array(t.skin.paint.length)};l.draw([{left:0,top:0,width:Fn,height:Fn}],r,()=>c);let h=O("canvas",{width:Fn,height:Fn}),d=h.getContext("2d"),[u,f,p,x]=l.box;return d.fillStyle=Od,d.fillRect(0,0,Fn,Fn),d.drawImage(l.canvas,u,f,p-u,x-f),h.toDataURL("image/jpeg",.85)}function*qg(s){for(let t=0;t<s.length;t+=3)yield s.subarray(t,t+3)}var bo=class{constructor(t,e,n){this.session=t,this.view=e,this.say=n,this.share=1,this.grid=O("div",{class:"shelf"}),this.saving=yt("Save shelf","Download the poses as a USD layer",()=>this.save()),this.node=O("div",{},this.grid,this.amount(),je(yt("Keep pose","Put the pose of the selection, or of all controls, on the shelf",()=>this.keep()),this.saving,yt("Open…","Add the poses of a layer saved before",()=>this.open()))),t.on("time",()=>this.update()),this.update()}amount(){let t=Yr({min:0,max:100,title:"How far a click goes from the present pose to the kept one","aria-label":"Share of the pose"},()=>100*this.share,e=>{this.share=e/100,t.update()});return t.update(),di("Share",t)}update(){let{shelf:t}=this.session;if(this.shown===t)return;this.shown=t,this.saving.disabled=!t.length;let e=Me("No poses yet. Keep the present one; a click on its picture gives it back.");this.grid.replaceChildren(...t.length?t.map(n=>this.item(n)):[e])}item(t){let e=O("input",{type:"text",value:t.name,"aria-label":`Name of the pose ${t.name}`,onchange:()=>this.put("Rename a pose",this.session.shelf.map(i=>i===t?{...t,name:e.value||t.name}:i))}),n=`${t.name}: ${ce(t.values.size,"control")}`;return O("div",{class:"pose"},yt(t.picture?O("img",{src:t.picture,alt:""}):null,n,()=>this.take(t),{class:"pose-picture","aria-label":`Take the pose ${t.name}`}),e,yt("×","Take it off the shelf",()=>this.put("Take a pose off the shelf",this.session.shelf.filter(i=>i!==t)),{class:"pose-away","aria-label":`Take ${t.name} off the shelf`}))}put(t,e){this.session.put(t,{shelf:e})}keep(){let{session:t}=this,e=Fd(t,this.view.stage),n=$g(`pose ${t.shelf.length+1}`,t.shelf);this.put("Keep a pose",[...t.shelf,{name:n,values:t.copy(),picture:e}])}take({name:t,values:e}){let{session:n}=this,i=new Set(n.selection.size?n.chosenControls:[]),r=[...e].filter(([a])=>i.has(a)),o=(r.length?r:[...e]).map(([a,l])=>[a,n.values[a]+this.share*(l-n.values[a])]);n.asWritten(`Pose ${t}`,o)}save(){this.session.save("poses.usda",hd(this.session,this.session.shelf),this.say)}open(){return pi(".usda,.usd",this.say,({name:t,text:e})=>{let n=ud(e,this.session);this.put(`Open ${t}`,[...this.session.shelf,...n]),this.say(`${ce(n.length,"pose")} added`)})}};function $g(s,t){let e=new Set(t.map(n=>n.name));for(let n=2,i=s;;i=`${s} (${n++})`)if(!e.has(i))return i}var er=24,Yg=2,Kg=4,wo=.02,Zg=1.02,Jg=.25,jg=6,Bd=1e-9;function zd(s,t,e,n,i){let r=s.members.map(({values:l},c)=>Qg(l,s.tracks[c],h=>i(h).slice(0,2))),o=n0(s.axes.map(l=>t0(s,l,r,t,e))),a=o.map(({ends:l})=>Uc(l,c=>n[c]));return{axes:o,start:a,current:a}}function Gd(s,t,e){let n=s.axes.map((h,d)=>d).filter(h=>s.axes[h].follows),[i,r,o]=[s.axes,s.start,s.current].map(h=>n.map(d=>h[d])),a=i.reduce((h,d,u)=>Bc(h,kc(d,r[u])),[t,e]),l=i.length>2?o0(i,r,o,a):s0(i,r,o,a);s.current=[...s.start],n.forEach((h,d)=>s.current[h]=l[d]);let c=new Map;return i.forEach(({ends:h},d)=>h.forEach(u=>c.set(u.control,Fc(u,l[d])))),c}function So(s,t,e,n,i,r){let o=Hd(s,s.axes[t],n,i),a=Uc(o,l=>r[l])+e;return o.map(l=>[l.control,Fc(l,a)])}function Vd({axes:s},t){let e=s.map(({points:r,follows:o})=>{let a=yi(r.at(-1),r[0]),l=Math.hypot(...a);return o&&l?(a[0]*t[0]+a[1]*t[1])/l:0}),n=e.map(Math.abs),i=n.indexOf(Math.max(...n));return[i,e[i]<0?-1:1]}var Hd=(s,t,e,n)=>t.map((i,r)=>e0(s.members[i].control,t.length>1?2*r-1:0,e,n));function Qg(s,t,e){let n=t.map((o,a)=>({value:s[a],point:o,at:e(o)})),i=[n[0]],r=(o,a,l)=>{let c=o.point.map((u,f)=>Ee(u,a.point[f],.5)),h={value:Ee(o.value,a.value,.5),point:c,at:e(c)},d=h.at.map((u,f)=>u-Ee(o.at[f],a.at[f],.5));!l||Math.hypot(...d)<=Jg?i.push(a):(r(o,h,l-1),r(h,a,l-1))};return n.slice(1).forEach((o,a)=>r(n[a],o,jg)),{values:i.map(({value:o})=>o),points:i.map(({at:o})=>o)}}function t0(s,t,e,n,i){let r=Hd(s,t,n,i),o=Uc(r,u=>i[u]),a=r.flatMap((u,f)=>e[t[f]].values.map(p=>u.sign*Wd(u,p))),l=[o,...r.flatMap(({sign:u})=>[0,u]),...a].sort((u,f)=>u-f),c=l.filter((u,f)=>f+1===l.length||l[f+1]-u>Bd),h=(u,f)=>_n(e[t[u]].values,e[t[u]].points,f),d=u=>(f,p,x)=>Bc(f,yi(h(x,Fc(p,u)),h(x,p.base)));return{ends:r,base:o,at:c,points:c.map(u=>r.reduce(d(u),[0,0])),follows:!0}}function e0(s,t,e,n){let{minimum:i,default:r,maximum:o}=e[s],a=n[s];return t===0?{control:s,sign:1,off:i,far:o,base:a}:{control:s,sign:t,off:r,far:Ao(e[s]),base:a}}var Ao=({minimum:s,default:t,maximum:e})=>e-t>=t-s?e:s;function Fc({sign:s,off:t,far:e,base:n},i){let r=Vt(s*i,0,1),o=Ee(t,e,r);return Math.abs(o-n)<=1e-12*Math.abs(e-t)?n:o}var Wd=({off:s,far:t},e)=>t===s?0:Vt((e-s)/(t-s),0,1),Uc=(s,t)=>s.reduce((e,n)=>e+n.sign*Wd(n,t(n.control)),0);function n0(s){let t=s.map(({points:r})=>es(r)),e=Math.max(...t),n=(r,o)=>t[r]>=o/4;if(e>=er/4)return s.map((r,o)=>({...r,follows:n(o,er)}));if(s.length===1)return[i0(s[0])];if(e<1)return s.map(r=>({...r,follows:!1}));let i=([r,o])=>[r*er/e,o*er/e];return s.map((r,o)=>({...r,points:r.points.map(i),follows:n(o,e)}))}function i0(s){let t=yi(s.points.at(-1),s.points[0]),e=Math.hypot(...t),[n,i]=e>=1?[t[0]/e,t[1]/e]:[0,-1],r=s.at.map(o=>er*(o-s.base)/(s.at.at(-1)-s.at[0]));return{...s,points:r.map(o=>[o*n,o*i])}}var Ud={ends:[],base:0,at:[0,1],points:[[0,0],[0,0]]};function s0(s,t,e,n){if(s.length===2)return Oc(s,t,e,n).at;let[i=Ud]=s;return Oc([i,Ud],[...t,0,0],[...e,0,0],n).at.slice(0,s.length)}function Oc([s,t],e,n,i){let r=s.at.slice(1).map((c,h)=>t.at.slice(1).map((d,u)=>r0(s,t,h,u,e,i))),a=r.flat().reduce((c,h)=>h.away<c.away?h:c),l=r[Wr(s.at,n[0])][Wr(t.at,n[1])];for(let c=kd(r,l);c!==l;c=kd(r,l))l=c;return l.away>Yg*a.away+Kg?a:l}function kd(s,t){return s.slice(Math.max(0,t.i-1),t.i+2).flatMap(n=>n.slice(Math.max(0,t.j-1),t.j+2)).reduce((n,i)=>i.away<n.away?i:n,t)}function r0(s,t,e,n,i,r){let o=[...yi(s.points[e+1],s.points[e]),wo*(s.at[e+1]-s.at[e]),0],a=[...yi(t.points[n+1],t.points[n]),0,wo*(t.at[n+1]-t.at[n])],c=[...yi(Bc(s.points[e],t.points[n]),r),wo*(s.at[e]-i[0]),wo*(t.at[n]-i[1])],[h,d,u,f,p]=[vt(o,o),vt(a,a),vt(o,a),vt(c,o),vt(c,a)],x=Math.max(h*d-u*u,1e-300),m=[[(u*p-d*f)/x,(u*f-h*p)/x],[-f/h,0],[-(f+u)/h,1],[0,-p/d],[1,-(p+u)/d]],g={away:1/0};for(let M of m){let[A,b]=M.map(E=>Vt(E,0,1)),T=Math.hypot(...c.map((E,y)=>E+A*o[y]+b*a[y]));T<g.away&&(g={away:T,i:e,j:n,at:[Ee(s.at[e],s.at[e+1],A),Ee(t.at[n],t.at[n+1],b)]})}return g}function o0(s,t,e,n){let i=(c,h)=>Math.abs(e[c]-s[c].base)>Bd&&e[c]>s[c].base===h,r=s.filter((c,h)=>i(h,!0)||i(h,!1)).length,o=c=>c.filter(({i:h,arm:d})=>i(h,d.at.at(-1)>s[h].base)).length===r,a=a0(s),l={away:1/0,set:e};for(let c of[...a.filter(o),...a.filter(h=>!o(h))]){let h=c.map(({i:m})=>m),u=s.filter((m,g)=>!h.includes(g)).reduce((m,g)=>yi(m,kc(g,g.base)),n),f=c.map(({i:m,arm:g})=>Vt(e[m],g.at[0],g.at.at(-1))),p=Oc(c.map(({arm:m})=>m),h.map(m=>t[m]),f,u);if(p.away*Zg+1e-6>=l.away)continue;let x=s.map((m,g)=>h.includes(g)?p.at[h.indexOf(g)]:m.base);l={away:p.away,set:x}}return l.set}function a0(s){let e=s.flatMap((i,r)=>l0(i).map(o=>({i:r,arm:o,angle:c0(o,kc(i,i.base))}))).sort((i,r)=>i.angle-r.angle);return e.map((i,r)=>[i,e[(r+1)%e.length]]).filter(([i,r])=>i.i!==r.i&&(r.angle-i.angle+2*Math.PI)%(2*Math.PI)<Math.PI)}function l0(s){let t=s.at.map(i=>Math.abs(i-s.base)),e=t.indexOf(Math.min(...t)),n=(i,r)=>({at:s.at.slice(i,r),points:s.points.slice(i,r)});return[n(0,e+1),n(e)].filter(({at:i})=>i.length>1)}function c0(s,t){let n=s.points.map(i=>yi(i,t)).reduce((i,r)=>vt(r,r)>vt(i,i)?r:i);return Math.atan2(n[1],n[0])}var kc=(s,t)=>_n(s.at,s.points,t),Bc=(s,t)=>[s[0]+t[0],s[1]+t[1]],yi=(s,t)=>[s[0]-t[0],s[1]-t[1]];var h0=.01,qd=.5,u0=3,d0=.15,f0=2,p0=1e3,$d=1e-9;function Yd({model:s,start:t,now:e,targets:n,groups:i,towards:r,locality:o}){let a=p=>Zd(n.map((x,m)=>x-p[m]),r),l=null,c=null,h=null,d=[Float64Array.from(e)];for(let p=0;p<f0;p++){let x=s.linearise(d[p]);if(c??=_0(s,i,x,o),!c.length)return new Map;l=M0(s,x,t,d[p],a(x.at),c,r),h=h?Eo(l,ir(l,h.held,h.rest)):E0(l),d.push(g0(s,t,c,m0(l,h).x))}let u=[...y0(s,t,c)?[]:[t],...d.slice(1)],f=jd(u,p=>v0(l,c,t,p,a(s.linearise(p).at)));return new Map(i.flat().map(p=>[p,f[p]]))}function m0(s,{held:t,rest:e}){let[n,i]=[e.subarray(0,3),.5*qd*nr(s.right.subarray(0,3))],r=Math.min(1,i/Math.max(nr(n),1e-30)),o={...s,right:s.right.map((a,l)=>a+(l<3?r:1)*e[l])};return Eo(o,ir(o,t,e))}function g0(s,t,e,n){let i=Float64Array.from(t);return e.forEach((r,o)=>{for(let a of r){let l=Vt(t[a]+n[o],s.minimum(a),s.maximum(a));i[a]=x0(s,a,l)?s.off(a):l}}),i}var x0=(s,t,e)=>s.opposites(t).length>0&&Math.abs(e-s.off(t))<=$d*(s.maximum(t)-s.minimum(t));function y0(s,t,e){let n=i=>t[i]!==s.off(i);return e.flat().some(i=>n(i)&&s.opposites(i).some(n))}function v0({ridge:s},t,e,n,i){return vt(i,i)+t.reduce((r,[o],a)=>r+s[a]*(n[o]-e[o])**2,0)}function Kd(s,t,e,n){let i=new Float64Array(n),r=e.map(o=>{let a=t.motion(o);return a.forEach((l,c)=>i[c]+=l),Math.hypot(a[0],a[1],a[2])*(s.maximum(o)-s.minimum(o))});return{column:i,paths:r}}function _0(s,t,e,n){let i=t.map(l=>Math.max(...Kd(s,e,l,e.at.length).paths)),r=n*i.reduce((l,c)=>Math.max(l,c),0),o=t.filter((l,c)=>i[c]>0&&i[c]>=r),a=new Set(o.flat().flatMap(l=>s.opposites(l)));return t.filter(l=>o.includes(l)||l.some(c=>a.has(c)))}var zc=(s,t)=>Math.max(...t.map(e=>s.maximum(e)-s.minimum(e)));function Zd(s,t){let e=t?(1-d0)*vt(t,s):0;return Float64Array.from(s,(n,i)=>e&&i<3?n-e*t[i]:n)}function M0(s,t,e,n,i,r,o){let a=r.map(f=>Kd(s,t,f,t.at.length)),l=a.map(({column:f})=>Zd(f,o)),c=Float64Array.from(i);r.forEach(([f],p)=>{for(let x=0;x<c.length;x++)c[x]+=l[p][x]*(n[f]-e[f])});let h=Math.max(...a.flatMap(({paths:f})=>f)),d=r.map((f,p)=>w0(s,f,a[p].paths)*(h/zc(s,f))**2),u=S0(s,r,e);return{columns:l,right:c,ridge:d,...u,sparse:b0(s,r,l,c,u),pairs:A0(s,r)}}function b0(s,t,e,n,{lower:i,upper:r}){let o=(l,c)=>{let h=vt(l,n);return(h>0?r[c]>0:i[c]<0)?Math.abs(h)*zc(s,t[c]):0},a=Math.max(...e.map(o));return t.map(l=>qd*a/zc(s,l))}function w0(s,t,e){return t.reduce((n,i,r)=>{let o=Math.min(1,e[r]/Math.max(s.peak(i),1e-30));return n+h0*(1+u0*(1-o)**2)},0)}function S0(s,t,e){let n=(a,l)=>a.map(c=>s[l](c)-e[c]),i=t.map(a=>Math.max(...n(a,"minimum"))),r=t.map(a=>Math.min(...n(a,"maximum"))),o=t.map((a,l)=>s.opposites(a[0]).length?s.off(a[0])===s.minimum(a[0])?i[l]=Math.min(...n(a,"off")):r[l]=Math.max(...n(a,"off")):0);return{lower:i,upper:r,off:o}}function A0(s,t){let e=new Map;t.forEach((i,r)=>i.forEach(o=>e.set(o,r)));let n=[];return t.forEach((i,r)=>{let o=new Set;for(let a of i)for(let l of s.opposites(a))o.add(e.get(l));for(let a of o)a>r&&n.push([r,a])}),n}function E0(s){let t=ir(s,[],null),e=Eo(s,t),n=p0;for(let i=[t];i.length&&n>0;){let r=i.pop();if(r.cost>=e.cost)continue;let o=C0(s,r.x);o?i.push(...o.map(a=>ir(s,[...r.held,a],r.rest)).sort((a,l)=>l.cost-a.cost)):e=r,n-=2*s.columns.length}return e}function Eo(s,t){let e=Jd(s,t.x);if(!e.length)return t;let n=e.map(([i,r])=>Gc(s,t.x,i)<Gc(s,t.x,r)?i:r);return Eo(s,ir(s,[...t.held,...n],t.rest))}function ir(s,t,e){let[n,i]=[[...s.lower],[...s.upper]];for(let o of t)n[o]=i[o]=s.off[o];let r=R0({...s,lower:n,upper:i},e);return{held:t,...r,cost:O0(s,r.x)}}var Gc=({columns:s,off:t},e,n)=>Math.abs(e[n]-t[n])*Math.sqrt(vt(s[n],s[n])),T0=({lower:s,upper:t,off:e},n,i)=>Math.abs(n[i]-e[i])>$d*(t[i]-s[i]),Jd=(s,t)=>s.pairs.filter(e=>e.every(n=>T0(s,t,n)));function C0(s,t){let e=n=>Math.min(...n.map(i=>Gc(s,t,i)));return jd(Jd(s,t),n=>-e(n))}function jd(s,t){let[e,n]=[void 0,1/0];for(let i of s){let r=t(i);r<n&&([e,n]=[i,r])}return e}function R0(s,t=null){let e=I0(s),{rows:n,right:i}=e,r=t??new Float64Array(n),o=Xd(e,r),a=1e-12*(nr(i)+nr(o.gradient));for(let l=0;l<100&&nr(o.gradient)>a;l++){let c=D0(P0(e,o.free),o.gradient.map(h=>-h));r=L0(e,r,c,o),o=Xd(e,r)}return{x:o.x,rest:r}}function I0({columns:s,right:t,ridge:e,sparse:n,lower:i,upper:r}){let o=t.length,a=new Float64Array(s.length*o);for(let c=0,h=0;c<s.length;c++)for(let d=0;d<o;d++,h++)a[h]=s[c][d];let l=n?Float64Array.from(n,c=>.5*c):new Float64Array(s.length);return{rows:o,columns:a,right:t,slack:l,ridge:Float64Array.from(e),lower:Float64Array.from(i),upper:Float64Array.from(r)}}function Qd({rows:s,columns:t,ridge:e},n){let i=new Float64Array(e.length);for(let r=0,o=0;r<i.length;r++){let a=0;for(let l=0;l<s;l++,o++)a+=t[o]*n[l];i[r]=a}return i}function Xd(s,t){let{rows:e,columns:n,right:i,slack:r,ridge:o,lower:a,upper:l}=s,c=Qd(s,t),h=new Float64Array(c.length),d=new Float64Array(e),u=[];for(let f=0;f<e;f++)d[f]=t[f]-i[f];for(let f=0;f<h.length;f++){let p=tf(c[f],r[f])/o[f];if(h[f]=Vt(p,a[f],l[f]),h[f]===p&&p!==0&&l[f]>a[f]&&u.push(f),h[f]!==0)for(let x=0;x<e;x++)d[x]+=n[f*e+x]*h[f]}return{x:h,gradient:d,along:c,free:u}}function P0({rows:s,columns:t,ridge:e},n){let i=Array.from({length:s},()=>new Float64Array(s));i.forEach((r,o)=>r[o]=1);for(let r of n){let o=r*s;for(let a=0;a<s;a++){let l=i[a],c=t[o+a]/e[r];for(let h=0;h<=a;h++)l[h]+=c*t[o+h]}}return i}function L0(s,t,e,{along:n,gradient:i}){let r=Qd(s,e),o=[vt(t,e)-vt(s.right,e),vt(e,e)],a=.1*Math.abs(vt(i,e)),[l,c,h]=[0,1/0,1];for(let d=0;d<=40;d++){let u=o[0]+h*o[1]+N0(s,n,r,h);if(Math.abs(u)<=a)break;u>0?c=h:l=h,h=c<1/0?(l+c)/2:2*h}return t.map((d,u)=>d+h*e[u])}function N0({slack:s,ridge:t,lower:e,upper:n},i,r,o){let a=0;for(let l=0;l<r.length;l++)a+=r[l]*Vt(tf(i[l]+o*r[l],s[l])/t[l],e[l],n[l]);return a}function D0(s,t){let e=t.length,n=s.map(r=>Float64Array.from(r));for(let r=0;r<e;r++){for(let a=0;a<r;a++)for(let l=r;l<e;l++)n[l][r]-=n[l][a]*n[r][a];let o=Math.sqrt(Math.max(n[r][r],1e-300));for(let a=r;a<e;a++)n[a][r]/=o}let i=Float64Array.from(t);for(let r=0;r<e;r++){for(let o=0;o<r;o++)i[r]-=n[r][o]*i[o];i[r]/=n[r][r]}for(let r=e-1;r>=0;r--){for(let o=r+1;o<e;o++)i[r]-=n[o][r]*i[o];i[r]/=n[r][r]}return i}function O0({columns:s,right:t,ridge:e,sparse:n},i){let r=t.map((a,l)=>s.reduce((c,h,d)=>c-h[l]*i[d],a)),o=vt(r,r);for(let a=0;a<i.length;a++)o+=(e[a]*Math.abs(i[a])+(n?.[a]??0))*Math.abs(i[a]);return o}var tf=(s,t)=>Math.sign(s)*Math.max(0,Math.abs(s)-t),nr=s=>Math.sqrt(vt(s,s));var Vc=.001,fs=class{constructor(t,e,n){this.session=t,this.towards=n,this.start=Float64Array.from(t.values),this.places=[t.place(e),...t.pins],this.origin=t.shown(this.places[0]),this.controls=t.controls}to(t){let{session:e}=this,n=[t,...e.pins.map(a=>a.at)].flat(),i=a=>Yd({model:this,start:this.start,now:e.values,targets:n,groups:a,towards:this.towards,locality:e.options.locality}),r=i(e.groups(!1)),o=r.size?r:i(e.groups(!0));e.affected=this.changes(o),e.set(o)}get acts(){let{motion:t}=this.linearise(this.session.values);return this.session.groups(!0).flat().some(e=>Math.hypot(...t(e).slice(0,3))>0)}changes(t){let e=new Map;for(let[n,i]of t){let r=Math.abs(i-this.start[n])/(this.maximum(n)-this.minimum(n));r>.005&&e.set(n,r)}return e}minimum(t){return this.opposites(t).length?Math.min(this.off(t),Ao(this.controls[t])):this.controls[t].minimum}maximum(t){return this.opposites(t).length?Math.max(this.off(t),Ao(this.controls[t])):this.controls[t].maximum}opposites(t){return this.session.opposites[t]}off(t){return this.controls[t].default}peak(t){return this.session.influence.peak(t)}linearise(t){let{deformer:e}=this.session,n=()=>this.places.flatMap(o=>this.session.traced(o));e.drive(t);let i=n();return{at:i,motion:o=>{let a=this.maximum(o)-this.minimum(o),c=(this.maximum(o)-t[o]>=Vc*a?Vc:-Vc)*a;return e.withControl(o,t[o],t[o]+c,n).map((d,u)=>(d-i[u])/c)}}}};var F0=3,U0=.1,k0=500,To=class{constructor(t){this.view=t,this.session=t.session,this.active=null,this.pending=null,this.reach=0,this.fingers=new Map;let e=t.surface,n={pointerdown:this.press,pointermove:this.move,pointerup:this.release,pointercancel:this.lose,pointerleave:this.leave,dblclick:this.doubleClick};for(let[i,r]of Object.entries(n))e.addEventListener(i,o=>r.call(this,o));e.addEventListener("contextmenu",i=>i.preventDefault()),e.addEventListener("wheel",i=>this.wheel(i),{passive:!1})}press(t){let e=this.view.locate(t);if(t.pointerType==="touch"){if(this.active?.isOfPen)return;if(this.fingers.set(t.pointerId,e),this.fingers.size===2)return this.beginTwo()}if(this.active)return;this.view.surface.focus({preventScroll:!0}),this.view.surface.setPointerCapture(t.pointerId),this.view.freshen(),this.reach=t.pointerType==="touch"?Xs/2:0;let{pointerId:n,pointerType:i}=t;this.active={pointer:n,isOfPen:i==="pen",start:e,last:e,hand:e,moved:!1,...this.chooseGesture(t,e)},this.active.begin?.(),clearTimeout(this.holding),i!=="mouse"&&this.active.hold&&(this.holding=setTimeout(()=>this.hold(n),k0)),t.preventDefault()}hold(t){this.flush();let{active:e}=this;e?.pointer!==t||e.moved||(e.hold(),Object.assign(e,{grab:null,drag:null,drop:null,click:null,undo:null}))}move(t){let e=this.view.locate(t);if(this.fingers.has(t.pointerId)&&this.fingers.set(t.pointerId,e),this.active?.isOfTwo)return this.active.stale=!0,this.view.request();if(this.active&&this.active.pointer!==t.pointerId)return;t.pointerType!=="touch"&&(this.reach=0);let n=this.session.options.draw&&this.active?t.getCoalescedEvents?.()??[]:[],i=[...this.pending?.trail??[],...(n.length?n:[t]).map(r=>this.view.locate(r))];return this.pending={at:e,trail:i,fine:t.ctrlKey||t.metaKey},this.view.request()}beginTwo(){this.cancel(),this.pending=null,this.active={isOfTwo:!0,...this.grip()}}grip(){let[t,e]=[...this.fingers.values()];return{x:(t.x+e.x)/2,y:(t.y+e.y)/2,apart:Math.hypot(e.x-t.x,e.y-t.y)||1,angle:Math.atan2(e.y-t.y,e.x-t.x)}}moveTwo(){if(this.fingers.size<2||!this.active.stale)return;let{camera:t,columns:[{left:e,top:n,width:i,height:r}]}=this.view,[o,a]=[this.active,this.grip()],l=a.apart/o.apart;t.zoom(1/l);let c=(d,u,f)=>d-f-l*(u-f);t.pan(c(a.x,o.x,e+i/2),c(a.y,o.y,n+r/2),r);let h=Math.atan2(Math.sin(a.angle-o.angle),Math.cos(a.angle-o.angle));t.turn(t.azimuth+h,t.elevation),Object.assign(this.active,a,{stale:!1}),this.view.changed("camera")}lose(t){this.fingers.delete(t.pointerId),this.cancel()}flush(){if(this.active?.isOfTwo&&this.moveTwo(),!this.pending)return;let{at:t,trail:e,fine:n}=this.pending;this.pending=null,this.active?this.dragTo(t,n,e):this.hover(t)}dragTo(t,e,n){let{active:i}=this,r=e?U0:1,o=[t.x-i.last.x,t.y-i.last.y];i.hand={...t,x:i.hand.x+r*o[0],y:i.hand.y+r*o[1]},i.last=t,!(!i.moved&&Math.hypot(t.x-i.start.x,t.y-i.start.y)<F0)&&(i.moved||i.grab?.(),i.moved=!0,i.drag?.(i.hand,o,t,n))}release(t){if(this.active?.isOfTwo&&this.moveTwo(),this.fingers.delete(t.pointerId),this.active?.isOfTwo&&(this.active=null),!this.active||this.active.pointer!==t.pointerId)return;this.move(t),this.flush();let{active:e}=this;this.active=null,e.moved?e.drop?.(e.last):e.click?.(),this.session.quiet||=e.moved,this.setDragging(null),this.view.changed("pose")}cancel(){let{active:t}=this;return this.active=null,t?.undo?.(),this.setDragging(null),t!==null}leave(){this.active||this.session.setHover(null)}doubleClick(t){let e=this.view.locate(t),n=this.view.elementAt(e),i=n?null:this.view.pick(e);n?this.session.reset(n.members.map(({control:r})=>r)):i&&this.view.dive(i)}wheel(t){return t.preventDefault(),this.view.overlay.dock.contains(this.view.locate(t))?this.scroll(t.deltaY):(this.view.camera.zoom(Math.exp(.0012*Vt(t.deltaY,-300,300))),this.view.changed("camera"))}scroll(t){let{view:e}=this;e.overlay.dock.scrollBy(t)&&(e.arrange(),e.changed("overlay"))}hover(t){if(this.session.options.draw&&t.column)return this.session.setHover(null),this.view.setCursor("crosshair");let{overlay:e}=this.view;this.view.controlsAt(t)&&t.column&&!this.reach&&e.point(t.x,t.y)&&this.view.changed("overlay");let n=this.view.elementAt(t);this.session.setHover(n);let i=!n&&t.column?.kind!=="target"&&this.view.pick(t);return this.view.setCursor(n?"grab":i&&this.session.options.skinDrag?"crosshair":"default")}chooseGesture(t,e){let{view:n,session:i}=this;if(t.button===1||t.button===2)return this.panning();if(i.options.draw&&e.column&&e.column===n.controlsColumn&&!t.altKey)return n.review.drawing(e);let{reach:r}=this,o=n.controlsAt(e)?n.overlay.badgeAt(e.x,e.y,r?r/2:void 0):null;if(o)return{click:()=>i.openOrClose([o])};if(r&&e.column&&n.overlay.isAmbiguous(e.x,e.y,r))return this.opening(e);let a=n.elementAt(e,r);if(!a&&n.overlay.dock.contains(e))return{drag:(h,[,d])=>this.scroll(-d)};if(t.altKey||!(a||e.column)||e.column?.kind==="target")return this.orbiting();if(a&&i.options.rearrange)return n.rearranging.gesture(a);if(a)return t.shiftKey?{click:()=>i.select([a],"toggle")}:this.handling(a);let l=n.controlsAt(e)?n.overlay.pinAt(e.x,e.y,r):null;if(l)return{click:()=>i.removePin(l)};let c=i.options.skinDrag?n.pick(e):null;return t.shiftKey?this.marquee(c,e):c&&!i.options.rearrange?this.pulling(c,e):this.orbiting()}orbiting(){let{camera:t}=this.view;return{drag:(e,[n,i])=>{t.turn(t.azimuth-.008*n,t.elevation+.008*i),this.view.changed("camera")},click:()=>this.session.select([])}}panning(){let{camera:t}=this.view;return{drag:(e,[n,i])=>{t.pan(n,i,this.view.columns[0].height),this.view.changed("camera")}}}opening(t){return{begin:()=>{this.view.overlay.point(t.x,t.y,Xs),this.view.changed("overlay"),this.view.say("Several handles lay under the finger: drag the one you mean")}}}handling(t){let{session:e,view:n}=this,i=null,r=null;return{begin:()=>{e.selection.has(t.index)||e.select([t]),e.emit("editing"),this.setDragging(t),n.setCursor("grabbing")},grab:()=>{r=e.beginEdit(),i=n.beginDrag(t)},drag:o=>{let a=Gd(i,o.x-this.active.start.x,o.y-this.active.start.y);e.set(this.withSelection(t,i,a,r))},drop:()=>e.endEdit(`Drag ${t.label}`,r),undo:()=>this.takeBack(r)}}withSelection(t,e,n,i){let{controls:r,rest:o,selectedElements:a}=this.session,l=new Map(n);for(let c of a.filter(h=>h!==t))c.axes.slice(0,e.axes.length).forEach((h,d)=>{let u=e.current[d]-e.start[d],f=u?So(c,d,u,r,o,i):[];f.some(([p])=>l.has(p))||f.forEach(([p,x])=>l.set(p,x))});return l}pulling(t,e){let{session:n,view:i}=this,r=null,o=null;return{grab:()=>{o=n.beginEdit(),r=new fs(n,t,i.camera.towards),this.setDragging("skin"),i.setCursor(r.acts?"grabbing":"not-allowed"),r.acts||i.say("No control that is free moves the skin here")},drag:a=>{let{column:l}=e,c=i.camera.unproject(l,e.x,e.y,t.depth),h=i.camera.unproject(l,a.x,a.y,t.depth);r.to(fe(r.origin,ge(h,c)))},drop:()=>{r.acts&&o.every((a,l)=>a===n.values[l])&&i.say("No control that is free moves the skin here that way"),n.endEdit("Pull the skin",o)},click:()=>i.showInfluences(t),hold:()=>{n.addPin(t),i.say("Pinned: pulls leave this point. A tap on the pin takes it out")},undo:()=>this.takeBack(o)}}marquee(t,e){let{session:n,view:i}=this,r=o=>[e.x,e.y,o.x,o.y];return{drag:(o,a,l)=>{i.overlay.marquee=r(l),i.changed("overlay")},drop:o=>{i.overlay.marquee=null,n.select(i.overlay.elementsIn(r(o)),"add")},click:()=>t&&n.addPin(t),undo:()=>i.overlay.marquee=null}}takeBack(t){t&&this.session.set([...t.entries()])}setDragging(t){Object.assign(this.session,{dragging:t,affected:new Map}),this.session.emit("dragging")}};function ef(s){let t=s.meshes.filter(i=>i.visible),e=new Uint32Array(t.reduce((i,r)=>i+r.triangles.length,0)),n=0;for(let i of t)for(let r of i.triangles)e[n++]=i.start+r;return e}function nf({meshes:s,texture:t,pointCount:e}){if(!t||!s.some(c=>c.texture))return null;let n=new Array(2*e).fill(NaN),[i,r,o]=[[],[],[]],a=new Map,l=(c,h,d)=>{if(Number.isNaN(n[2*c])&&([n[2*c],n[2*c+1]]=[h,d]),n[2*c]===h&&n[2*c+1]===d)return c;let u=`${c} ${h} ${d}`;return re(a,u,()=>(i.push(c),n.push(h,d),e+i.length-1))};for(let{start:c,triangles:h,visible:d,texture:u}of s){if(!d)continue;let f=h.length/3;h.forEach((p,x)=>{let m=Math.floor(x/3),g=u?u.images[m]:-1;if(x%3===0&&o.push(g<0?0:1),g<0)r.push(l(c+p,-1,-1));else{let[M,A,b,T]=t.boxes[g],[E,y]=[0,3*f].map(w=>u.uv[w+x%3*f+m]/65535);r.push(l(c+p,(M+.5+E*(b-1))/t.width,(A+.5+(1-y)*(T-1))/t.height))}})}return{...t,corners:Uint32Array.from(r),doubles:i,places:Float32Array.from(n),on:Uint8Array.from(o)}}function Hc(s,t,e,n=new s.constructor(s.length+t*e.length)){return n===s||(n.set(s),e.forEach((i,r)=>{for(let o=0;o<t;o++)n[s.length+t*r+o]=s[t*i+o]})),n}function sf(s){let t=new Float32Array(3*s.pointCount),e=new Float32Array(2*s.pointCount).fill(9);for(let n of s.meshes)n.colours.forEach((i,r)=>t[3*n.start+r]=i/255),n.gaze&&e.set(n.gaze,2*n.start);return{colours:t,gaze:e}}function rf(s,t){let e=B0(t,s.pointCount),n=new Map;for(let i of s.meshes)for(let r=0;r<i.count;r++){if(!e[i.start+r])continue;let o=`${i.path} ${i.points.subarray(3*r,3*r+3).join()}`;re(n,o,()=>[]).push(i.start+r)}return[...n.values()].filter(i=>i.length>1)}function B0(s,t){let e=new Uint8Array(t);for(let n of of(s,t))e[Math.floor(n/t)]=e[n%t]=1;return e}function of(s,t){let e=new Map;for(let n=0;n<s.length;n+=3)for(let i=0;i<3;i++){let[r,o]=[s[n+i],s[n+(i+1)%3]];Co(e,Math.min(r,o)*t+Math.max(r,o))}return[...e].filter(([,n])=>n===1).map(([n])=>n)}var Co=(s,t,e=1)=>s.set(t,(s.get(t)??0)+e);function Ro(s,t,e,n){n.fill(0),z0(s,t,n),G0(e,n)}function z0(s,t,e){for(let n=0;n<t.length;n+=3){let i=3*t[n],r=3*t[n+1],o=3*t[n+2],a=s[r]-s[i],l=s[r+1]-s[i+1],c=s[r+2]-s[i+2],h=s[o]-s[i],d=s[o+1]-s[i+1],u=s[o+2]-s[i+2],f=l*u-c*d,p=c*h-a*u,x=a*d-l*h;e[i]+=f,e[i+1]+=p,e[i+2]+=x,e[r]+=f,e[r+1]+=p,e[r+2]+=x,e[o]+=f,e[o+1]+=p,e[o+2]+=x}}function G0(s,t){for(let e of s)for(let n=0;n<3;n++){let i=0;for(let r of e)i+=t[3*r+n];for(let r of e)t[3*r+n]=i}}function af(s,t){let e=V0(t,s.length/3),n=new Map,i=new Map;for(let a=0;a<t.length;a+=3){let l=e[t[a]];Co(n,l),Co(i,l,H0(s,t,a,3*l))}let r=W0(t,e,s.length/3),o=new Int8Array(t.length/3);for(let a=0;a<o.length;a++){let l=e[t[3*a]],c=(r.get(l)??0)<.08*n.get(l);o[a]=c?Math.sign(i.get(l)):0}return o}function V0(s,t){let e=Uint32Array.from({length:t},(i,r)=>r),n=i=>{for(;e[i]!==i;)i=e[i]=e[e[i]];return i};for(let i=0;i<s.length;i+=3)e[n(s[i+1])]=n(s[i]),e[n(s[i+2])]=n(s[i]);return e.map((i,r)=>n(r))}function H0(s,t,e,n){let[i,r,o]=[0,1,2].map(a=>[0,1,2].map(l=>s[3*t[e+a]+l]-s[n+l]));return vt(i,Be(r,o))}function W0(s,t,e){let n=new Map;for(let i of of(s,e))Co(n,t[i%e]);return n}function lf(s,t,e,n,i,r,o=t){let a=n.position,l=q0(s,n,a,i),c=0;for(let h=0,d=0;h<t.length;h+=3,d++){let[u,f,p]=[t[h],t[h+1],t[h+2]];l[u]&l[f]&l[p]||e[d]!==0&&e[d]*X0(s,3*u,3*f,3*p,a)<=0||(r[c++]=o[h],r[c++]=o[h+1],r[c++]=o[h+2])}return c}function X0(s,t,e,n,i){let r=s[t],o=s[t+1],a=s[t+2],l=s[e]-r,c=s[e+1]-o,h=s[e+2]-a,d=s[n]-r,u=s[n+1]-o,f=s[n+2]-a;return(c*f-h*u)*(i[0]-r)+(h*d-l*f)*(i[1]-o)+(l*u-c*d)*(i[2]-a)}function q0(s,{right:t,above:e,towards:n,half:i},r,o){let a=new Uint8Array(s.length/3);for(let l=0,c=0;l<a.length;l++,c+=3){let h=s[c]-r[0],d=s[c+1]-r[1],u=s[c+2]-r[2],f=-(h*n[0]+d*n[1]+u*n[2]),p=h*t[0]+d*t[1]+u*t[2],x=h*e[0]+d*e[1]+u*e[2],[m,g]=[f*i*o,f*i];a[l]=(p>m?1:0)|(p<-m?2:0)|(x>g?4:0)|(x<-g?8:0)|(f<=0?16:0)}return a}var $0=[240,169,75],Y0=[88,166,255],K0=160,Z0=26,J0=.004,Io=class{constructor(t){this.view=t,this.node=O("canvas",{class:"onion","aria-hidden":"true",hidden:!0}),this.drawn=[],this.painter=null}follow(){let t=this.wanted();$n(t,this.drawn)||(this.node.hidden=!0,this.drawn=[],clearTimeout(this.timer),t.length&&(this.timer=setTimeout(()=>this.draw(),K0)))}wanted(){let{session:t,camera:e,controlsColumn:n}=this.view;if(!t.options.onion||!n||t.neutral||!t.keys.size)return[];let{left:i,top:r,width:o,height:a}=n;return[t.frame,t.keys,t.constants,[...t.selection].join(),e.azimuth,e.elevation,e.distance,...e.target,i,r,o,a]}draw(){let{view:t}=this,{width:e,height:n}=t;if(this.drawn=this.wanted(),!this.drawn.length)return;this.painter??=new xi(O("canvas"),t.stage),this.painter.resize(e,n,1);let i=new ImageData(Math.max(1,Math.round(e)),Math.max(1,Math.round(n))),{before:r,after:o}=j0(t.session),a=this.outlineAt(t.session.frame);r!==null&&cf(this.outlineAt(r),a,$0,i),o!==null&&cf(this.outlineAt(o),a,Y0,i),Object.assign(this.node,{width:i.width,height:i.height,hidden:!1}),this.node.getContext("2d").putImageData(i,0,0)}outlineAt(t){let{view:e,painter:n}=this,{deformer:i}=e.session,r=e.session.atFrame(t,l=>i.posedAside(l));i.updateMaps();let o=new Float32Array(r.length);Ro(r,e.stage.triangles,e.stage.welded,o);let a={...e.stage.skin,points:r,normals:o,paint:new Uint8Array(4*r.length/3)};return n.draw([e.controlsColumn],e.camera,()=>a),Q0(n)}};function j0({keys:s,frame:t,selection:e,chosenControls:n}){let i=new Set(e.size?n:[]),r=[...s].filter(([a])=>i.has(a)),o=Se((r.length?r:[...s]).flatMap(([,a])=>a.map(([l])=>l)));return{before:o.findLast(a=>a<t)??null,after:o.find(a=>a>t)??null}}function Q0({pixels:s,nearness:t,wide:e}){let n=new Float32Array(s.length);for(let r=0;r<n.length;r++){let o=s[r];n[r]=.3*(o&255)+.59*(o>>8&255)+.11*(o>>16&255)}let i=new Uint8Array(s.length);for(let r=e+1;r<i.length-e-1;r++){let o=Math.abs(n[r+1]-n[r-1])+Math.abs(n[r+e]-n[r-e]),a=Math.max(Math.abs(t[r+1]-t[r]),Math.abs(t[r+e]-t[r])),l=Math.max(o/Z0,a/(J0*Math.max(t[r],1e-12)))-1;l>0&&(i[r]=210*Math.min(1,l))}return i}function cf(s,t,[e,n,i],{data:r,width:o}){for(let a=o+1;a<s.length-o-1;a++)s[a]<=r[4*a+3]||t[a]||t[a-1]||t[a+1]||t[a-o]||t[a+o]||(r[4*a]=e,r[4*a+1]=n,r[4*a+2]=i,r[4*a+3]=s[a])}function tx(s,t,e=()=>!1){let n=s.map(([r,o])=>[r,o]),i=s.map((r,o)=>e(o));for(let r=0;r<160;r++)if(!ex(n,i,t*1.02))return n;return nx(n,s,i,t)}function ex(s,t,e){let n=!1;for(let i=0;i<s.length;i++)for(let r=0;r<i;r++){if(t[i]&&t[r])continue;let[o,a]=[s[i][0]-s[r][0],s[i][1]-s[r][1]],l=Math.hypot(o,a);if(l>=e)continue;n=!0;let c=2.4*(i+1),[h,d]=l>1e-6?[o/l,a/l]:[Math.cos(c),Math.sin(c)],u=(e-l)*(t[i]||t[r]?1:.5);t[i]||(s[i]=[s[i][0]+u*h,s[i][1]+u*d]),t[r]||(s[r]=[s[r][0]-u*h,s[r][1]-u*d])}return n}function nx(s,t,e,n){let i=s.filter((l,c)=>!e[c]),r=hf(i),o=r>0?Math.max(1,n/r):1,a=[0,1].map(l=>i.reduce((c,h)=>c+h[l],0)/Math.max(1,i.length));return s.map((l,c)=>e[c]?t[c]:l.map((h,d)=>a[d]+o*(h-a[d])))}function hf(s){let t=1/0;return s.forEach(([e,n],i)=>s.slice(0,i).forEach(([r,o])=>t=Math.min(t,Math.hypot(e-r,n-o)))),t}function uf(s,t,e,n=-1){let i=7*e,r=([l,c])=>Math.hypot(l-t[0],c-t[1]),o=s.map((l,c)=>c).filter(l=>r(s[l])<i+2*e);if(hf(o.filter(l=>r(s[l])<i).map(l=>s[l]))>=e)return null;let a=tx(o.map(l=>s[l]),e,l=>o[l]===n||r(s[o[l]])>i);return new Map(o.map((l,c)=>[l,[a[c][0]-s[l][0],a[c][1]-s[l][1]]]))}var df=11,ix=22,ff=30,sx=8,rx=2,Wc=6,Po=class{constructor(t){this.session=t,this.drawn=[],this.enlarged=1,this.leftward=0,this.dock=new xo(t),this.lens=null,this.look="",this.magnifications=new Map}arrange(t,e,n){let{session:i}=this,r=e.projector(t),o=1/e.pixelSize(t.height),a=Vt(i.elements.width*o,df,ix);this.enlarged=a/(i.elements.width*o);let l=new Map(this.drawn.map(p=>[p.element,p]));n&&(this.magnifications=new Map);let{azimuth:c,elevation:h,distance:d,target:u}=e,f=[c,h,d,...u,t.left,t.width,t.height].join();f!==this.look&&(this.lens=null),this.look=f,this.drawn=i.elements.list.filter(p=>i.isShown(p)&&(!p.onBoard||this.dock.mapOf(p))).map(p=>{if(p.onBoard)return this.docked(p);let x=n&&this.facesAway(p,e);return this.arranged(p,r,x?()=>!0:n,a,l.get(p))}),this.pinned=i.pins.map(p=>r(i.shown(p))),this.column=t,this.leftward=Math.sign(vt(i.character.layout.planeNormal,e.right)),this.lens&&this.shift()}mapOf(t,e,n=t.origin){let i=e(n),r=re(this.magnifications,t,()=>ax(t.tracks.map(l=>l.map(e)))),[o,a]=this.lens?.offsets.get(t)??[0,0];return l=>{let[c,h,d]=e(l);return[i[0]+r*(c-i[0])+o,i[1]+r*(h-i[1])+a,d]}}draggable(t,e){let n=this.dock.mapOf(t);return t.onBoard&&n?[this.dock.heldStill(t),n]:[t,this.mapOf(t,e)]}docked(t){let e=this.dock.mapOf(t),{tracks:n}=this.dock.heldStill(t),i=t.members.map((u,f)=>this.screenTrack(u,n[f],e,()=>!1)),r=this.dock.handleOf(t),o=t.members[0],a=e(_n(o.values,n[0],this.session.rest[o.control])),[l,c]=[e(r),df+1],h=c/(this.session.elements.width*this.enlarged),d=t.glyph&&t.glyph.points.map(u=>{let[f,p]=this.dock.seen(u);return[l[0]+h*f,l[1]+h*p,1]});return{element:t,handle:l,tracks:i,width:c,hidden:!1,corners:d,origin:a}}point(t,e,n=null){let{lens:i}=this;if(i&&Math.hypot(t-i.at[0],e-i.at[1])<rx*i.apart&&(n??0)<=i.apart)return!1;let r=this.drawn.filter(x=>!x.element.onBoard&&this.isReachable(x)),o=n??(r[0]?.width??0)+2,a=x=>Math.hypot(x.handle[0]-t,x.handle[1]-e),l=r.reduce((x,m)=>x&&a(x)<=a(m)?x:m,null),c=l&&a(l)<=l.width/2?r.indexOf(l):-1,h=c<0?null:r[c].handle,d=this.closeLens();if(!this.session.options.handles)return d;let u=r.map(({handle:x})=>x),f=uf(u.map((x,m)=>m===c?h:x),[t,e],o,c);if(!f)return d;let p=new Map([...f].map(([x,[m,g]])=>{let[M,A]=x===c?[h[0]-u[x][0],h[1]-u[x][1]]:[0,0];return[r[x].element,[m+M,g+A]]}));return this.lens={offsets:p,at:[t,e],apart:o},this.shift(),!0}closeLens(){return this.lens?(this.shift(-1),this.lens=null,!0):!1}shift(t=1){let{offsets:e}=this.lens;for(let n of this.drawn){let[i,r]=e.get(n.element)??[0,0];if(!i&&!r)continue;let o=([a,l,c])=>[a+t*i,l+t*r,c];n.home=t>0?n.handle:null,n.handle=o(n.handle),n.origin=o(n.origin),n.corners=n.corners&&n.corners.map(o),n.tracks=n.tracks.map(a=>a.map(({at:l,covered:c})=>({at:o(l),covered:c})))}}isReachable({handle:t,hidden:e}){return t[2]>0&&(!e||this.session.options.occlusion==="overlay")}facesAway(t,{towards:e}){let{occlusion:n}=this.session.options;return n!=="overlay"&&!t.onBoard&&vt(t.normal,e)<-.2}arranged(t,e,n,i,r){let o=this.lens;this.lens=null;let a=this.mapOf(t,e);this.lens=o;let l=a(t.handle),c=t.tracks.map((p,x)=>{let m=n?null:r?.tracks[x];return this.screenTrack(t.members[x],p,a,(g,M)=>n?.(g)??m?.[M]?.covered??!1)}),h=n?n(l)&&ox(c):r?.hidden??!1,d=e(t.handle),u=([p,x,m])=>[p+l[0]-d[0],x+l[1]-d[1],m],f=t.glyph&&t.outline.map(p=>u(e(p)));return{element:t,handle:l,tracks:c,width:i,hidden:h,corners:f,origin:e(t.origin)}}screenTrack(t,e,n,i){let{minimum:r,maximum:o}=this.session.controls[t.control],a=t.values.filter(h=>h>r&&h<o),l=[r,...a,o];return l.flatMap((h,d)=>{let u=l[d+1];return u===void 0?[h]:[0,1,2,3].map(f=>h+f/4*(u-h))}).map((h,d)=>{let u=n(_n(t.values,e,h));return{at:u,covered:i(u,d)}})}badgeOf({element:t,handle:e,width:n}){let{session:i}=this;return t.inner.length||i.levels.coarseOf(t).length&&(i.hover===t||i.selection.has(t.index))?[e[0]+n/2+4,e[1]+n/2+4]:null}badgeAt(t,e,n=Wc+2){return this.session.options.handles?this.drawn.filter(r=>this.isReachable(r)).find(r=>{let o=this.badgeOf(r);return o&&Math.hypot(o[0]-t,o[1]-e)<=n})?.element??null:null}elementAt(t,e,n=0){let{session:i,dock:r}=this;if(!i.options.handles)return null;let o=r.contains({x:t,y:e}),a=null;for(let l of this.drawn){let{element:c,handle:h,width:d}=l;if(!this.isReachable(l)||c.onBoard!==o)continue;let u=Math.hypot(h[0]-t,h[1]-e);u<=Math.max(n,d/2+4)&&(!a||u<a.off)&&(a={element:c,off:u})}return a?.element??null}isAmbiguous(t,e,n){return!this.session.options.handles||this.lens&&this.lens.apart>=2*n?!1:this.drawn.filter(r=>!r.element.onBoard&&this.isReachable(r)&&Math.hypot(r.handle[0]-t,r.handle[1]-e)<=n).length>1}pinAt(t,e,n=0){let i=(this.pinned??[]).findIndex(r=>Math.hypot(r[0]+5-t,r[1]-15-e)<Math.max(9,n));return i<0?null:this.session.pins[i]}elementsIn([t,e,n,i]){let r=([a,l])=>a>=Math.min(t,n)&&a<=Math.max(t,n)&&l>=Math.min(e,i)&&l<=Math.max(e,i),o=this.session.options.occlusion==="overlay";return this.drawn.filter(a=>r(a.handle)&&(o||!a.hidden)).map(a=>a.element)}};function ox(s){let t=s.flat();return t.filter(({covered:e})=>e).length>.6*t.length}function ax(s){let t=Math.max(...s.map(e=>es(e.map(n=>n.slice(0,2)))));return t<ff/sx?1:Math.max(1,ff/t)}var lx="#5fd6ff",Xc=.22,Lo=40,Do=class extends Po{constructor(t,e){super(e),this.canvas=t,this.pen=t.getContext("2d"),this.marquee=null,this.placing=null}resize(t,e,n){this.ratio=n,this.width=t,this.height=e,this.box=null}draw(t=[],e=[]){let{pen:n,session:i}=this;if(this.cover(t,e),n.clearRect(0,0,this.width,this.height),i.options.handles&&this.column){this.clipTo(this.column);let r=this.drawn.filter(({element:o})=>!o.onBoard).sort((o,a)=>a.handle[2]-o.handle[2]);this.drawElements(r),e.forEach(o=>this.drawTrail(o)),i.options.labels==="all"&&this.drawLabels(r),n.restore(),this.dock.rect&&this.drawDock()}this.drawPins(),t.forEach(r=>this.drawStroke(r)),this.drawPlacing(),this.marquee&&this.drawMarquee(this.marquee)}cover(t,e){let{canvas:n,pen:i,ratio:r}=this,o=Jr(this.reach(t,e),this.box,[this.width,this.height]);o!==this.box&&(this.box=o,n.width=Math.round((o[2]-o[0])*r),n.height=Math.round((o[3]-o[1])*r),jr(n,o),i.setTransform(r,0,0,r,-o[0]*r,-o[1]*r))}reach(t,e){let{session:n,dock:i}=this;if(t.length||this.marquee||this.placing||n.options.labels==="all")return[0,0,this.width,this.height];let r=n.options.handles?this.drawn:[],o=n.options.handles&&i.rect,a=o?[[o.left,o.top],[o.left+o.width,o.top+o.height]]:[],[l,c,h,d]=[1/0,1/0,-1/0,-1/0],u=([f,p])=>{f<l&&(l=f),f>h&&(h=f),p<c&&(c=p),p>d&&(d=p)};[...a,...this.pinned??[],...e.flatMap(({places:f})=>f.map(({at:p})=>p))].forEach(u);for(let{element:f,handle:p,home:x,tracks:m,origin:g,corners:M}of r){let A=(T,E)=>([y,w])=>u([T[0]+E*(y-T[0]),T[1]+E*(w-T[1])]),b=A(g,f.axes.length>1?2:1);m.forEach(T=>T.forEach(({at:E})=>b(E))),M?.forEach(A(p,1.3*this.enlarged)),u(p),x&&u(x)}return[l-Lo,c-Lo,h+Lo,d+Lo]}drawElements(t){for(let e of["drawLeader","drawTracks","drawHandle","drawBadge"])t.forEach(n=>this[e](n))}drawDock(){this.clipTo(this.dock.rect),this.dock.draw(this.pen),this.drawElements(this.drawn.filter(({element:t})=>t.onBoard)),this.pen.restore()}drawLeader({element:t,home:e,handle:n,hidden:i}){!e||Math.hypot(e[0]-n[0],e[1]-n[1])<3||(this.pen.globalAlpha=.5*this.strength(t,i),jn(this.pen,[e,n]),Ge(this.pen,1,"#f4f5f7"))}drawBadge(t){let e=this.badgeOf(t);if(!e)return;let{pen:n}=this,i=this.strength(t.element,t.hidden);if(i<.3)return;let[r,o]=e,[a,l]=[[[r-3,o],[r+3,o]],[[r,o-3],[r,o+3]]];n.globalAlpha=i,No(n,e,Wc,"#f4f5f7"),jn(n,a,...t.element.inner.length?[l]:[]),Ge(n,1.6,"#16181b"),n.globalAlpha=1}clipTo({left:t,top:e,width:n,height:i}){this.pen.save(),this.pen.beginPath(),this.pen.rect(t,e,n,i),this.pen.clip()}strength(t,e){let{session:n}=this,{opacity:i,fade:r,occlusion:o}=n.options,a=n.dragging,l=n.selection.has(t.index)||n.hover===t||this.affectedShare(t)>0,c=i;return r&&a&&a!==t&&!l&&(c*=.18),e&&o!=="overlay"&&(c*=o==="ghost"?.2:0),c}affectedShare(t){return t.members.reduce((e,{control:n})=>Math.max(e,this.session.affected.get(n)??0),0)}colour(t){return this.affectedShare(t)>0&&this.session.dragging==="skin"?lx:this.session.colours[t.side]}drawTracks(t){let{element:e,tracks:n}=t,{pen:i,session:r}=this,o=r.selection.has(e.index)||r.hover===e,a=this.colour(e);e.axes.length>1&&this.drawPatch(t,a,o),Object.assign(i,{lineCap:"round",lineJoin:"round"});let l=this.strength(e,!1)<Xc;n.forEach(c=>{l||this.strokeRuns(e,c,"#14161a",o?5.5:4,.55),this.strokeRuns(e,c,a,o?3:1.9,.95)}),n.forEach(c=>this.drawEnd(e,c.at(-1),a)),i.globalAlpha=1}strokeRuns(t,e,n,i,r){let{pen:o}=this,a=0;for(;a+1<e.length;){let l=e[a].covered&&e[a+1].covered;o.globalAlpha=r*this.strength(t,l);let c=[e[a].at];do c.push(e[++a].at);while(a+1<e.length&&(e[a].covered&&e[a+1].covered)===l);jn(o,c),o.globalAlpha>0&&Ge(o,i,n)}}drawEnd(t,{at:e,covered:n},i){this.pen.globalAlpha=.9*this.strength(t,n),No(this.pen,e,2.2,i)}drawPatch({element:t,tracks:e,origin:n,hidden:i},r,o){let{pen:a}=this,l=t.axes.map(d=>{let u=e[d.at(-1)].at(-1).at;return[d.length>1?e[d[0]].at(-1).at:e[d[0]][0].at,u].map(p=>[p[0]-n[0],p[1]-n[1]])});a.globalAlpha=(o?.3:.16)*this.strength(t,i),a.fillStyle=r;let c=l.length>2?ux(l):l,h=l.length>2?c.length:1;for(let d=0;d<h;d++){let[u,f]=[c[d],c[(d+1)%c.length]];h>1&&dx(u[1],f[1])>Math.PI+1e-6||(jn(a,[[0,0],[1,0],[1,1],[0,1]].map(([p,x])=>[0,1].map(m=>n[m]+u[p][m]+f[x][m]))),a.fill())}}drawHandle(t){let{element:e,handle:n,width:i,hidden:r}=t,{pen:o,session:a}=this,l=this.strength(e,r);if(l<=0||n[2]<=0)return;let[c,h]=n,d=a.hover===e,u=a.selection.has(e.index),f=e.members.some(({control:M})=>a.values[M]!==a.rest[M]),p=e.members.every(({control:M})=>a.locks.has(M)),x=i/2*(d?1.22:1);o.globalAlpha=l;let m=f?this.colour(e):"#2a2d32",g=u?"#ffffff":this.colour(e);e.glyph?this.drawGlyph(t,m,g,(u?2.6:1.8)+(f?.8:0),d?1.22:1):(o.beginPath(),qc(o,e.axes.length,c,h,x),l>=Xc&&Ge(o,4,"rgba(15, 17, 20, 0.75)"),o.fillStyle=m,o.fill(),!f&&l>=Xc&&this.fillHalf(e,c,h,x),Ge(o,u?2.6:1.8,g)),p&&cx(o,c,h,x*.5,f?"#16181b":this.colour(e)),(d||u)&&this.drawHalo(e,c,h,x+4.5,u&&!d?.35:.7),o.globalAlpha=1}fillHalf(t,e,n,i){let r={left:this.leftward,right:-this.leftward}[t.side];if(!r)return;let{pen:o}=this;o.save(),o.clip(),o.fillStyle=this.session.colours[t.side],o.fillRect(r>0?e:e-2*i,n-2*i,2*i,4*i),o.restore(),o.beginPath(),qc(o,t.axes.length,e,n,i)}drawGlyph({element:t,handle:e,corners:n},i,r,o,a){let{pen:l}=this,{parts:c,closed:h}=t.glyph,d=this.enlarged*a,u=x=>[0,1].map(m=>e[m]+d*(n[x][m]-e[m])),f=c.map(x=>{let m=new Path2D;for(let[g,M]of x.map(u))m.lineTo(g,M);return h&&m.closePath(),m}),p=(x,m)=>f.forEach(g=>Ge(l,x,m,g));if(p(h?2*o+2:o+2.2,"rgba(15, 17, 20, 0.75)"),p(h?2*o:o,r),!!h){l.fillStyle=i;for(let x of f)l.fill(x);p(.7,i)}}drawHalo(t,e,n,i,r){let{pen:o}=this;o.globalAlpha=r,o.beginPath(),qc(o,t.axes.length,e,n,i),Ge(o,1.4,"#ffffff")}drawLabels(t){let{pen:e}=this,n=[];e.font="11px system-ui, sans-serif",e.textAlign="left";for(let{element:i,handle:r,width:o,hidden:a}of[...t].reverse()){let l=this.strength(i,a);if(l<.3||i.onBoard)continue;let c=i.label,h=[r[0]+o/2+5,r[1]-7,e.measureText(c).width+10,14];n.some(d=>hx(h,d))||(n.push(h),e.globalAlpha=.72*l,e.fillStyle="#17191c",e.fillRect(...h),e.globalAlpha=l,e.fillStyle=this.session.colours[i.side],e.fillRect(h[0],h[1],3,h[3]),e.fillStyle="#f4f5f7",e.fillText(c,h[0]+6,h[1]+11))}e.globalAlpha=1}drawPins(){let{pen:t}=this;for(let[e,n,i]of this.pinned??[])i<=0||(jn(t,[[e,n],[e+5,n-13]]),Ge(t,3.5,"#14161a"),Ge(t,1.6,"#f2f3f5"),No(t,[e+5.5,n-15],4.5,"#f08c4b"),t.stroke())}drawPlacing(){if(!this.placing)return;let{pen:t}=this,{from:e,to:n,free:i,refused:r}=this.placing;t.setLineDash([4,4]),jn(t,[e,n]),Ge(t,1.5,r?this.session.colours.right:i?"#9aa0a8":"#7ee787"),t.setLineDash([]),t.beginPath(),t.arc(n[0],n[1],8,0,7),t.stroke()}drawTrail({colour:t,places:e}){let{pen:n,session:i}=this,r=e.filter(({at:c})=>c[2]>0),o=r.findLast(({frame:c})=>c<=i.frame);Object.assign(n,{globalAlpha:1,lineCap:"round",lineJoin:"round"}),jn(n,r.map(({at:c})=>c)),Ge(n,4,"#14161a"),Ge(n,2,t);let[a,l]=[!1,!0].map(c=>r.filter(({isKey:h})=>h===c));for(let c of[...a,...l,...o?[o]:[]]){let[h,d]=c===o?[4.5,"#ffffff"]:c.isKey?[4,"#f0a94b"]:[1.5,"#f4f5f7"];No(n,c.at,h,d),h>2&&Ge(n,1.5,"#14161a")}}drawMarquee([t,e,n,i]){let{pen:r}=this;r.fillStyle="rgba(120, 170, 255, 0.12)",r.strokeStyle="rgba(150, 190, 255, 0.9)",r.lineWidth=1,r.fillRect(t,e,n-t,i-e),r.strokeRect(t+.5,e+.5,n-t,i-e)}drawStroke(t){let{pen:e}=this;Object.assign(e,{lineCap:"round",lineJoin:"round"}),jn(e,[...t,t.at(-1)]),Ge(e,5.5,"#14161a"),Ge(e,3,"#f0a94b")}};function jn(s,...t){s.beginPath();for(let e of t)e.forEach(([n,i],r)=>r?s.lineTo(n,i):s.moveTo(n,i))}function Ge(s,t,e,n=null){Object.assign(s,{lineWidth:t,strokeStyle:e}),n?s.stroke(n):s.stroke()}function No(s,t,e,n){s.beginPath(),s.arc(t[0],t[1],e,0,7),s.fillStyle=n,s.fill()}function qc(s,t,e,n,i){if(t===1)s.arc(e,n,i,0,7);else{let r=t===2?4:3,o=i*(t===2?1.25:1.4);for(let a=0;a<r;a++){let l=-Math.PI/2+2*Math.PI*a/r;s.lineTo(e+o*Math.cos(l),n+o*Math.sin(l))}}s.closePath()}function cx(s,t,e,n,i){jn(s,[[t-n,e-n],[t+n,e+n]],[[t+n,e-n],[t-n,e+n]]),Ge(s,1.8,i)}var hx=(s,t)=>s[0]<t[0]+t[2]&&t[0]<s[0]+s[2]&&s[1]<t[1]+t[3]&&t[1]<s[1]+s[3],Oo=([s,t])=>Math.atan2(t,s),ux=s=>[...s].sort((t,e)=>Oo(t[1])-Oo(e[1])),dx=(s,t)=>(Oo(t)-Oo(s)+2*Math.PI)%(2*Math.PI);var Fo=class{constructor(t,e){this.points=t,this.triangles=e,this.screen=new Float32Array(t.length),this.invalidate()}invalidate(){this.column=null,this.depths=null}project(t,e){if(this.column===e)return;let{points:n,screen:i}=this,r=t.position,{right:o,above:a,towards:l,half:c}=t,h=e.height/(2*c),d=e.left+e.width/2,u=e.top+e.height/2;for(let f=0;f<n.length;f+=3){let p=n[f]-r[0],x=n[f+1]-r[1],m=n[f+2]-r[2],g=-(p*l[0]+x*l[1]+m*l[2]),M=g>1e-9?h/g:NaN;i[f]=d+(p*o[0]+x*o[1]+m*o[2])*M,i[f+1]=u-(p*a[0]+x*a[1]+m*a[2])*M,i[f+2]=g}this.column=e,this.depths=null}pick(t,e,n,i){this.project(t,e);let{screen:r,triangles:o}=this,a=null;for(let l=0;l<o.length;l+=3){let c=3*o[l],h=3*o[l+1],d=3*o[l+2],u=r[c]-n,f=r[h]-n,p=r[d]-n;if(u>0&&f>0&&p>0||u<0&&f<0&&p<0)continue;let x=r[c+1]-i,m=r[h+1]-i,g=r[d+1]-i,M=f*g-m*p,A=p*x-g*u,b=u*m-x*f;if(!(M>=0&&A>=0&&b>=0||M<=0&&A<=0&&b<=0))continue;let T=M+A+b;if(T===0)continue;let E=T/(M/r[c+2]+A/r[h+2]+b/r[d+2]);(a===null||E<a.depth)&&(a={triangle:l,depth:E,on:[M/T,A/T,b/T]})}return a&&this.hit(a)}hit({triangle:t,depth:e,on:n}){let i=Array.from(this.triangles.subarray(t,t+3)),r=n.map((a,l)=>a*e/this.screen[3*i[l]+2]),o=i[r.indexOf(Math.max(...r))];return{corners:i,shares:r,depth:e,nearest:o}}depthGrid(t,e){if(this.project(t,e),this.depths)return this.depths;let n=Math.ceil(e.width/3)+1,i=Math.ceil(e.height/3)+1,r=new Float32Array(n*i).fill(1/0),{screen:o,triangles:a}=this;for(let l=0;l<a.length;l+=3)fx(r,n,i,o,3*a[l],3*a[l+1],3*a[l+2],e);return this.depths={grid:r,wide:n,high:i},this.depths}hides(t,e,[n,i,r],o){let{grid:a,wide:l,high:c}=this.depthGrid(t,e),h=Math.round((n-e.left)/3),d=Math.round((i-e.top)/3);return h<0||d<0||h>=l||d>=c?!1:a[d*l+h]<r-o}};function fx(s,t,e,n,i,r,o,a){let l=(n[i]-a.left)/3,c=(n[i+1]-a.top)/3,h=(n[r]-a.left)/3,d=(n[r+1]-a.top)/3,u=(n[o]-a.left)/3,f=(n[o+1]-a.top)/3,p=(h-l)*(f-c)-(d-c)*(u-l);if(!(Math.abs(p)>1e-9))return;let x=Math.max(0,Math.ceil(Math.min(l,h,u))),m=Math.min(t-1,Math.floor(Math.max(l,h,u))),g=Math.max(0,Math.ceil(Math.min(c,d,f))),M=Math.min(e-1,Math.floor(Math.max(c,d,f)));for(let A=g;A<=M;A++)for(let b=x;b<=m;b++){let T=((h-b)*(f-A)-(d-A)*(u-b))/p,E=((u-b)*(c-A)-(f-A)*(l-b))/p,y=1-T-E;if(T<0||E<0||y<0)continue;let w=T*n[i+2]+E*n[r+2]+y*n[o+2],D=A*t+b;w<s[D]&&(s[D]=w)}}var pf="/RigUICorrections/",px={type:"def Scope",metadata:'prepend apiSchemas = ["RigUICorrectionAPI"]'},mx=3,Uo=class{constructor(t){this.view=t,this.session=t.session,this.moved=t.session.moved}gesture(t){let{view:e,session:n}=this,{overlay:i}=e,r=i.drawn.find(l=>l.element===t).handle,o=null,a=()=>{i.placing=null,e.changed("overlay")};return{begin:()=>n.select([t]),drag:(l,c,h)=>{o=h.column===e.controlsColumn?e.pick(h):null;let d=o!==null&&!this.holds(t,o.nearest);i.placing={from:r,to:[h.x,h.y],free:!o,refused:d},e.changed("overlay")},drop:()=>{a(),o&&!this.holds(t,o.nearest)?e.say(`${t.label} does not move this point: drop it on the coloured area`):o?this.moveToSkin(t,o.nearest):this.moveBeside(t)},undo:a}}holds(t,e){return t.members.every(({control:n})=>this.session.influence.ofControl(n)[e]>=mx)}moveToSkin(t,e){let n=this.session.options.symmetric?this.mirrorOf(t):null,i=n&&this.partnerOf(e);this.change(`Move ${t.label}`,[t,n].filter(Boolean),()=>{this.anchor(t,e),n&&this.anchor(n,i)})}anchor(t,e){let[n,i]=this.session.meshOf(e);this.session.elements.reanchor(t,n,i,this.session.character.layout.leastTrack);let{meshes:r,metresPerUnit:o,up:a}=this.session.character,l=this.pointsAt(this.session.controls.map(c=>c.default));this.moved.set(t.index,['uniform token rigUI:correction:place = "point"',ps("uniform point3f rigUI:correction:position",rs(l(e))),ps("uniform vector3f rigUI:correction:up",rs(a)),ps("uniform double rigUI:correction:metersPerUnit",xe(o)),ps("rel rigUI:correction:prim",`<${r[n].path}>`),ps("uniform int rigUI:correction:pointIndex",i)])}moveBeside(t){this.change(`Move ${t.label} beside the face`,[t],()=>{this.session.elements.putBeside(t),this.moved.set(t.index,['uniform token rigUI:correction:place = "board"'])})}change(t,e,n){let{session:i}=this,r=()=>e.map(c=>[c,i.elements.placement(c),this.moved.get(c.index)]),o=c=>{for(let[h,d,u]of c)i.elements.restore(h,d),u?this.moved.set(h.index,u):this.moved.delete(h.index);i.relayout()},a=r();n();let l=r();i.history.push(t,()=>o(a),()=>o(l)),i.relayout()}mirrorOf(t){let e=this.session.elements.list.find(n=>n.name===t.mirror);return e&&e!==t?e:null}partnerOf(t){let{character:e,rest:n}=this.session,{planeOrigin:i,planeNormal:r}=e.layout,o=this.pointsAt(n),a=ge(o(t),ie(r,2*vt(ge(o(t),i),r))),{start:l,count:c}=e.meshes[this.session.meshOf(t)[0]],h=[1/0,t];for(let d=l;d<l+c;d++){let u=ge(o(d),a);vt(u,u)<h[0]&&(h=[vt(u,u),d])}return h[1]}pointsAt(t){let e=this.session.deformer.posedAside(t);return n=>e.subarray(3*n,3*n+3)}corrections(){let{character:t,controls:e,elements:n}=this.session,i=new Map;i.set(t.root+pf,{type:"def Scope"});for(let[r,o]of this.moved)for(let{control:a}of n.list[r].members){let{name:l}=e[a],c=t.root+pf+l.replace(/\W|^(?=\d)/g,"_");for(;i.has(c);)c+="_";i.set(c,{...px,lines:[ps("uniform string rigUI:correction:control",ze(l)),...o]})}return mi(i)}},ps=(s,t)=>`${s} = ${t}`;/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var Ff=0,_h=1,Uf=2;var Sr=1,kf=2,Fs=3,Ii=0,Je=1,yn=2,Yi=0,Us=1,Mh=2,bh=3,wh=4,Bf=5;var Ki=100,zf=101,Gf=102,Vf=103,Hf=104,Wf=200,Xf=201,qf=202,$f=203,Sh=204,Ah=205,Yf=206,Kf=207,Zf=208,Jf=209,jf=210,Qf=211,tp=212,ep=213,np=214,oa=0,aa=1,la=2,Rs=3,ca=4,ha=5,ua=6,da=7,Eh=0,ip=1,sp=2,Vn=0,Th=1,Ch=2,Rh=3,Ih=4,Ph=5,Lh=6,Nh=7;var Dh=300,Zi=301,ks=302,ka=303,Ba=304,fa=1e3,kn=1001,pa=1002,Le=1003,rp=1004;var Ar=1005;var Ne=1006,za=1007;var En=1008;var ln=1009,Oh=1010,Fh=1011,Bs=1012,Ga=1013,Tn=1014,Cn=1015,Rn=1016,Va=1017,Ha=1018,Ji=1020,Uh=35902,kh=35899,Bh=1021,zh=1022,In=1023,ri=1026,ai=1027,Gh=1028,Wa=1029,Pi=1030,Xa=1031;var qa=1033,Er=33776,Tr=33777,Cr=33778,Rr=33779,$a=35840,Ya=35841,Ka=35842,Za=35843,Ja=36196,ja=37492,Qa=37496,tl=37488,el=37489,Ir=37490,nl=37491,il=37808,sl=37809,rl=37810,ol=37811,al=37812,ll=37813,cl=37814,hl=37815,ul=37816,dl=37817,fl=37818,pl=37819,ml=37820,gl=37821,xl=36492,yl=36494,vl=36495,_l=36283,Ml=36284,Pr=36285,bl=36286;var cr=2300,ma=2301,sa=2302,ph=2303,mh=2400,gh=2401,xh=2402;var op=3200;var Vh=0,ap=1,li="",rn="srgb",Wi="srgb-linear",hr="linear",te="srgb";var ra=7680;var lp=519,cp=512,hp=513,up=514,Hh=515,dp=516,fp=517,Wh=518,Xh=519,pp=35044,qh=35048;var $h="300 es",fn=2e3,ur=2001;function gx(s){for(let t=s.length-1;t>=0;--t)if(s[t]>=65535)return!0;return!1}function xx(s){return ArrayBuffer.isView(s)&&!(s instanceof DataView)}function dr(s){return document.createElementNS("http://www.w3.org/1999/xhtml",s)}function mp(){let s=dr("canvas");return s.style.display="block",s}var mf={},Is=null;function Yh(...s){let t="THREE."+s.shift();Is?Is("log",t,...s):console.log(t,...s)}function gp(s){let t=s[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=s[1];e&&e.isStackTrace?s[0]+=" "+e.getLocation():s[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return s}function Nt(...s){s=gp(s);let t="THREE."+s.shift();if(Is)Is("warn",t,...s);else{let e=s[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...s)}}function Ot(...s){s=gp(s);let t="THREE."+s.shift();if(Is)Is("error",t,...s);else{let e=s[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...s)}}function lr(...s){let t=s.join(" ");t in mf||(mf[t]=!0,Nt(...s))}function xp(s,t,e){return new Promise(function(n,i){function r(){switch(s.clientWaitSync(t,s.SYNC_FLUSH_COMMANDS_BIT,0)){case s.WAIT_FAILED:i();break;case s.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var yp={[oa]:oa,[la]:ua,[ca]:ca,[Rs]:ha,[aa]:aa,[ua]:la,[da]:da,[ha]:Rs},Bn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let i=n[t];if(i!==void 0){let r=i.indexOf(e);r!==-1&&i.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let i=n.slice(0);for(let r=0,o=i.length;r<o;r++)i[r].call(this,t);t.target=null}}},Ve=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var $c=Math.PI/180,ga=180/Math.PI;function Lr(){let s=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Ve[s&255]+Ve[s>>8&255]+Ve[s>>16&255]+Ve[s>>24&255]+"-"+Ve[t&255]+Ve[t>>8&255]+"-"+Ve[t>>16&15|64]+Ve[t>>24&255]+"-"+Ve[e&63|128]+Ve[e>>8&255]+"-"+Ve[e>>16&255]+Ve[e>>24&255]+Ve[n&255]+Ve[n>>8&255]+Ve[n>>16&255]+Ve[n>>24&255]).toLowerCase()}function $t(s,t,e){return Math.max(t,Math.min(e,s))}function yx(s,t){return(s%t+t)%t}function Yc(s,t,e){return(1-e)*s+e*t}function vp(s){return Math.pow(2,Math.floor(Math.log(s)/Math.LN2))}function Kh(s){switch(s.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function vx(s,t){if(t.constructor===Float32Array)return s;let e=Kh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(s/e,-1)}function _x(s,t){if(t.constructor===Float32Array)return s;let e=Kh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(s*e)}var Jt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,i=t.elements;return this.x=i[0]*e+i[3]*n+i[6],this.y=i[1]*e+i[4]*n+i[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=$t(this.x,t.x,e.x),this.y=$t(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=$t(this.x,t,e),this.y=$t(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar($t(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos($t(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),i=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*i+t.x,this.y=r*i+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},zn=class{constructor(t=0,e=0,n=0,i=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=i}static slerpFlat(t,e,n,i,r,o,a){let l=n[i+0],c=n[i+1],h=n[i+2],d=n[i+3],u=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(d!==x||l!==u||c!==f||h!==p){let m=l*u+c*f+h*p+d*x;m<0&&(u=-u,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let M=Math.acos(m),A=Math.sin(M);g=Math.sin(g*M)/A,a=Math.sin(a*M)/A,l=l*g+u*a,c=c*g+f*a,h=h*g+p*a,d=d*g+x*a}else{l=l*g+u*a,c=c*g+f*a,h=h*g+p*a,d=d*g+x*a;let M=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=M,c*=M,h*=M,d*=M}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,n,i,r,o){let a=n[i],l=n[i+1],c=n[i+2],h=n[i+3],d=r[o],u=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*d+l*f-c*u,t[e+1]=l*p+h*u+c*d-a*f,t[e+2]=c*p+h*f+a*u-l*d,t[e+3]=h*p-a*d-l*u-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,i){return this._x=t,this._y=e,this._z=n,this._w=i,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,i=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(i/2),d=a(r/2),u=l(n/2),f=l(i/2),p=l(r/2);switch(o){case"XYZ":this._x=u*h*d+c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d-u*f*p;break;case"YXZ":this._x=u*h*d+c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d+u*f*p;break;case"ZXY":this._x=u*h*d-c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d-u*f*p;break;case"ZYX":this._x=u*h*d-c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d+u*f*p;break;case"YZX":this._x=u*h*d+c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d-u*f*p;break;case"XZY":this._x=u*h*d-c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d+u*f*p;break;default:Nt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,i=Math.sin(n);return this._x=t.x*i,this._y=t.y*i,this._z=t.z*i,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],i=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],d=e[10],u=n+a+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-i)*f}else if(n>a&&n>d){let f=2*Math.sqrt(1+n-a-d);this._w=(h-l)/f,this._x=.25*f,this._y=(i+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-n-d);this._w=(r-c)/f,this._x=(i+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+d-n-a);this._w=(o-i)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs($t(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let i=Math.min(1,e/n);return this.slerp(t,i),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,i=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+i*c-r*l,this._y=i*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-i*a,this._w=o*h-n*a-i*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,i=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,i=-i,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+i*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+i*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),i=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(i*Math.sin(t),i*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},H=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(gf.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(gf.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,i=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*i,this.y=r[1]*e+r[4]*n+r[7]*i,this.z=r[2]*e+r[5]*n+r[8]*i,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,i=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*i+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*i+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*i+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*i+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,i=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*i-a*n),h=2*(a*e-r*i),d=2*(r*n-o*e);return this.x=e+l*c+o*d-a*h,this.y=n+l*h+a*c-r*d,this.z=i+l*d+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,i=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*i,this.y=r[1]*e+r[5]*n+r[9]*i,this.z=r[2]*e+r[6]*n+r[10]*i,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=$t(this.x,t.x,e.x),this.y=$t(this.y,t.y,e.y),this.z=$t(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=$t(this.x,t,e),this.y=$t(this.y,t,e),this.z=$t(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar($t(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,i=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=i*l-r*a,this.y=r*o-n*l,this.z=n*a-i*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Kc.copy(this).projectOnVector(t),this.sub(Kc)}reflect(t){return this.sub(Kc.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos($t(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,i=this.z-t.z;return e*e+n*n+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let i=Math.sin(e)*t;return this.x=i*Math.sin(n),this.y=Math.cos(e)*t,this.z=i*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),i=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=i,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Kc=new H,gf=new zn,Ft=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,i,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,i,r,o,a,l,c)}set(t,e,n,i,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=i,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,i=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],f=n[5],p=n[8],x=i[0],m=i[3],g=i[6],M=i[1],A=i[4],b=i[7],T=i[2],E=i[5],y=i[8];return r[0]=o*x+a*M+l*T,r[3]=o*m+a*A+l*E,r[6]=o*g+a*b+l*y,r[1]=c*x+h*M+d*T,r[4]=c*m+h*A+d*E,r[7]=c*g+h*b+d*y,r[2]=u*x+f*M+p*T,r[5]=u*m+f*A+p*E,r[8]=u*g+f*b+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],i=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+i*r*c-i*o*l}invert(){let t=this.elements,e=t[0],n=t[1],i=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=h*o-a*c,u=a*l-h*r,f=c*r-o*l,p=e*d+n*u+i*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=d*x,t[1]=(i*c-h*n)*x,t[2]=(a*n-i*o)*x,t[3]=u*x,t[4]=(h*e-i*l)*x,t[5]=(i*r-a*e)*x,t[6]=f*x,t[7]=(n*l-c*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,i,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-i*c,i*l,-i*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return lr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Zc.makeScale(t,e)),this}rotate(t){return lr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Zc.makeRotation(-t)),this}translate(t,e){return lr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Zc.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let i=0;i<9;i++)if(e[i]!==n[i])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Zc=new Ft,xf=new Ft().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),yf=new Ft().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Mx(){let s={enabled:!0,workingColorSpace:Wi,spaces:{},convert:function(i,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===te&&(i.r=si(i.r),i.g=si(i.g),i.b=si(i.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(i.applyMatrix3(this.spaces[r].toXYZ),i.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===te&&(i.r=Cs(i.r),i.g=Cs(i.g),i.b=Cs(i.b))),i},workingToColorSpace:function(i,r){return this.convert(i,this.workingColorSpace,r)},colorSpaceToWorking:function(i,r){return this.convert(i,r,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===li?hr:this.spaces[i].transfer},getToneMappingMode:function(i){return this.spaces[i].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(i,r=this.workingColorSpace){return i.fromArray(this.spaces[r].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,r,o){return i.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return s.define({[Wi]:{primaries:t,whitePoint:n,transfer:hr,toXYZ:xf,fromXYZ:yf,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:rn},outputColorSpaceConfig:{drawingBufferColorSpace:rn}},[rn]:{primaries:t,whitePoint:n,transfer:te,toXYZ:xf,fromXYZ:yf,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:rn}}}),s}var Ht=Mx();function si(s){return s<.04045?s*.0773993808:Math.pow(s*.9478672986+.0521327014,2.4)}function Cs(s){return s<.0031308?s*12.92:1.055*Math.pow(s,.41666)-.055}var ms,xa=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{ms===void 0&&(ms=dr("canvas")),ms.width=t.width,ms.height=t.height;let i=ms.getContext("2d");t instanceof ImageData?i.putImageData(t,0,0):i.drawImage(t,0,0,t.width,t.height),n=ms}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=dr("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let i=n.getImageData(0,0,t.width,t.height),r=i.data;for(let o=0;o<r.length;o++)r[o]=si(r[o]/255)*255;return n.putImageData(i,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(si(e[n]/255)*255):e[n]=si(e[n]);return{data:e,width:t.width,height:t.height}}else return Nt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},bx=0,Ps=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:bx++}),this.uuid=Lr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},i=this.data;if(i!==null){let r;if(Array.isArray(i)){r=[];for(let o=0,a=i.length;o<a;o++)i[o].isDataTexture?r.push(Jc(i[o].image)):r.push(Jc(i[o]))}else r=Jc(i);n.url=r}return e||(t.images[this.uuid]=n),n}};function Jc(s){return typeof HTMLImageElement<"u"&&s instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&s instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&s instanceof ImageBitmap?xa.getDataURL(s):s.data?{data:Array.from(s.data),width:s.width,height:s.height,type:s.data.constructor.name}:(Nt("Texture: Unable to serialize Texture."),{})}var wx=0,jc=new H,Qe=class s extends Bn{constructor(t=s.DEFAULT_IMAGE,e=s.DEFAULT_MAPPING,n=kn,i=kn,r=Ne,o=En,a=In,l=ln,c=s.DEFAULT_ANISOTROPY,h=li){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:wx++}),this.uuid=Lr(),this.name="",this.source=new Ps(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=i,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Jt(0,0),this.repeat=new Jt(1,1),this.center=new Jt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ft,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(jc).x}get height(){return this.source.getSize(jc).y}get depth(){return this.source.getSize(jc).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Nt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let i=this[e];if(i===void 0){Nt(`Texture.setValues(): property '${e}' does not exist.`);continue}i&&n&&i.isVector2&&n.isVector2||i&&n&&i.isVector3&&n.isVector3||i&&n&&i.isMatrix3&&n.isMatrix3?i.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Dh)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case fa:t.x=t.x-Math.floor(t.x);break;case kn:t.x=t.x<0?0:1;break;case pa:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case fa:t.y=t.y-Math.floor(t.y);break;case kn:t.y=t.y<0?0:1;break;case pa:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Qe.DEFAULT_IMAGE=null;Qe.DEFAULT_MAPPING=Dh;Qe.DEFAULT_ANISOTROPY=1;var ye=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,i=1){this.x=t,this.y=e,this.z=n,this.w=i}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,i){return this.x=t,this.y=e,this.z=n,this.w=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,i=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*i+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*i+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*i+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*i+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,i,r,l=t.elements,c=l[0],h=l[4],d=l[8],u=l[1],f=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(c+1)/2,b=(f+1)/2,T=(g+1)/2,E=(h+u)/4,y=(d+x)/4,w=(p+m)/4;return A>b&&A>T?A<.01?(n=0,i=.707106781,r=.707106781):(n=Math.sqrt(A),i=E/n,r=y/n):b>T?b<.01?(n=.707106781,i=0,r=.707106781):(i=Math.sqrt(b),n=E/i,r=w/i):T<.01?(n=.707106781,i=.707106781,r=0):(r=Math.sqrt(T),n=y/r,i=w/r),this.set(n,i,r,e),this}let M=Math.sqrt((m-p)*(m-p)+(d-x)*(d-x)+(u-h)*(u-h));return Math.abs(M)<.001&&(M=1),this.x=(m-p)/M,this.y=(d-x)/M,this.z=(u-h)/M,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=$t(this.x,t.x,e.x),this.y=$t(this.y,t.y,e.y),this.z=$t(this.z,t.z,e.z),this.w=$t(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=$t(this.x,t,e),this.y=$t(this.y,t,e),this.z=$t(this.z,t,e),this.w=$t(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar($t(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ya=class extends Bn{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ne,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new ye(0,0,t,e),this.scissorTest=!1,this.viewport=new ye(0,0,t,e),this.textures=[];let i=n.count;for(let r=0;r<i;r++)this.textures[r]=new Qe({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ne,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let i=0,r=this.textures.length;i<r;i++)this.textures[i].image.width=t,this.textures[i].image.height=e,this.textures[i].image.depth=n,this.textures[i].isData3DTexture!==!0&&(this.textures[i].isArrayTexture=this.textures[i].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let i=Object.assign({},t.textures[e].image);this.textures[e].source=new Ps(i)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},on=class extends ya{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},fr=class extends Qe{constructor(t=null,e=1,n=1,i=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:i},this.magFilter=Le,this.minFilter=Le,this.wrapR=kn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var va=class extends Qe{constructor(t=null,e=1,n=1,i=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:i},this.magFilter=Le,this.minFilter=Le,this.wrapR=kn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var _e=class s{static{this.prototype.isMatrix4=!0}constructor(t,e,n,i,r,o,a,l,c,h,d,u,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,i,r,o,a,l,c,h,d,u,f,p,x,m)}set(t,e,n,i,r,o,a,l,c,h,d,u,f,p,x,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=n,g[12]=i,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=d,g[14]=u,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new s().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,i=1/gs.setFromMatrixColumn(t,0).length(),r=1/gs.setFromMatrixColumn(t,1).length(),o=1/gs.setFromMatrixColumn(t,2).length();return e[0]=n[0]*i,e[1]=n[1]*i,e[2]=n[2]*i,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,i=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(i),c=Math.sin(i),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let u=o*h,f=o*d,p=a*h,x=a*d;e[0]=l*h,e[4]=-l*d,e[8]=c,e[1]=f+p*c,e[5]=u-x*c,e[9]=-a*l,e[2]=x-u*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let u=l*h,f=l*d,p=c*h,x=c*d;e[0]=u+x*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*d,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=x+u*a,e[10]=o*l}else if(t.order==="ZXY"){let u=l*h,f=l*d,p=c*h,x=c*d;e[0]=u-x*a,e[4]=-o*d,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=x-u*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let u=o*h,f=o*d,p=a*h,x=a*d;e[0]=l*h,e[4]=p*c-f,e[8]=u*c+x,e[1]=l*d,e[5]=x*c+u,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let u=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=x-u*d,e[8]=p*d+f,e[1]=d,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*d+p,e[10]=u-x*d}else if(t.order==="XZY"){let u=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=-d,e[8]=c*h,e[1]=u*d+x,e[5]=o*h,e[9]=f*d-p,e[2]=p*d-f,e[6]=a*h,e[10]=x*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Sx,t,Ax)}lookAt(t,e,n){let i=this.elements;return nn.subVectors(t,e),nn.lengthSq()===0&&(nn.z=1),nn.normalize(),vi.crossVectors(n,nn),vi.lengthSq()===0&&(Math.abs(n.z)===1?nn.x+=1e-4:nn.z+=1e-4,nn.normalize(),vi.crossVectors(n,nn)),vi.normalize(),ko.crossVectors(nn,vi),i[0]=vi.x,i[4]=ko.x,i[8]=nn.x,i[1]=vi.y,i[5]=ko.y,i[9]=nn.y,i[2]=vi.z,i[6]=ko.z,i[10]=nn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,i=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],f=n[13],p=n[2],x=n[6],m=n[10],g=n[14],M=n[3],A=n[7],b=n[11],T=n[15],E=i[0],y=i[4],w=i[8],D=i[12],C=i[1],L=i[5],F=i[9],W=i[13],I=i[2],z=i[6],q=i[10],G=i[14],tt=i[3],X=i[7],Q=i[11],et=i[15];return r[0]=o*E+a*C+l*I+c*tt,r[4]=o*y+a*L+l*z+c*X,r[8]=o*w+a*F+l*q+c*Q,r[12]=o*D+a*W+l*G+c*et,r[1]=h*E+d*C+u*I+f*tt,r[5]=h*y+d*L+u*z+f*X,r[9]=h*w+d*F+u*q+f*Q,r[13]=h*D+d*W+u*G+f*et,r[2]=p*E+x*C+m*I+g*tt,r[6]=p*y+x*L+m*z+g*X,r[10]=p*w+x*F+m*q+g*Q,r[14]=p*D+x*W+m*G+g*et,r[3]=M*E+A*C+b*I+T*tt,r[7]=M*y+A*L+b*z+T*X,r[11]=M*w+A*F+b*q+T*Q,r[15]=M*D+A*W+b*G+T*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],i=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],d=t[6],u=t[10],f=t[14],p=t[3],x=t[7],m=t[11],g=t[15],M=l*f-c*u,A=a*f-c*d,b=a*u-l*d,T=o*f-c*h,E=o*u-l*h,y=o*d-a*h;return e*(x*M-m*A+g*b)-n*(p*M-m*T+g*E)+i*(p*A-x*T+g*y)-r*(p*b-x*E+m*y)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],i=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+i*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let i=this.elements;return t.isVector3?(i[12]=t.x,i[13]=t.y,i[14]=t.z):(i[12]=t,i[13]=e,i[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],i=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=t[9],u=t[10],f=t[11],p=t[12],x=t[13],m=t[14],g=t[15],M=e*a-n*o,A=e*l-i*o,b=e*c-r*o,T=n*l-i*a,E=n*c-r*a,y=i*c-r*l,w=h*x-d*p,D=h*m-u*p,C=h*g-f*p,L=d*m-u*x,F=d*g-f*x,W=u*g-f*m,I=M*W-A*F+b*L+T*C-E*D+y*w;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let z=1/I;return t[0]=(a*W-l*F+c*L)*z,t[1]=(i*F-n*W-r*L)*z,t[2]=(x*y-m*E+g*T)*z,t[3]=(u*E-d*y-f*T)*z,t[4]=(l*C-o*W-c*D)*z,t[5]=(e*W-i*C+r*D)*z,t[6]=(m*b-p*y-g*A)*z,t[7]=(h*y-u*b+f*A)*z,t[8]=(o*F-a*C+c*w)*z,t[9]=(n*C-e*F-r*w)*z,t[10]=(p*E-x*b+g*M)*z,t[11]=(d*b-h*E-f*M)*z,t[12]=(a*D-o*L-l*w)*z,t[13]=(e*L-n*D+i*w)*z,t[14]=(x*A-p*T-m*M)*z,t[15]=(h*T-d*A+u*M)*z,this}scale(t){let e=this.elements,n=t.x,i=t.y,r=t.z;return e[0]*=n,e[4]*=i,e[8]*=r,e[1]*=n,e[5]*=i,e[9]*=r,e[2]*=n,e[6]*=i,e[10]*=r,e[3]*=n,e[7]*=i,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],i=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,i))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),i=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-i*l,c*l+i*a,0,c*a+i*l,h*a+n,h*l-i*o,0,c*l-i*a,h*l+i*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,i,r,o){return this.set(1,n,r,0,t,1,o,0,e,i,1,0,0,0,0,1),this}compose(t,e,n){let i=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,d=a+a,u=r*c,f=r*h,p=r*d,x=o*h,m=o*d,g=a*d,M=l*c,A=l*h,b=l*d,T=n.x,E=n.y,y=n.z;return i[0]=(1-(x+g))*T,i[1]=(f+b)*T,i[2]=(p-A)*T,i[3]=0,i[4]=(f-b)*E,i[5]=(1-(u+g))*E,i[6]=(m+M)*E,i[7]=0,i[8]=(p+A)*y,i[9]=(m-M)*y,i[10]=(1-(u+x))*y,i[11]=0,i[12]=t.x,i[13]=t.y,i[14]=t.z,i[15]=1,this}decompose(t,e,n){let i=this.elements;t.x=i[12],t.y=i[13],t.z=i[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=gs.set(i[0],i[1],i[2]).length(),a=gs.set(i[4],i[5],i[6]).length(),l=gs.set(i[8],i[9],i[10]).length();r<0&&(o=-o),bn.copy(this);let c=1/o,h=1/a,d=1/l;return bn.elements[0]*=c,bn.elements[1]*=c,bn.elements[2]*=c,bn.elements[4]*=h,bn.elements[5]*=h,bn.elements[6]*=h,bn.elements[8]*=d,bn.elements[9]*=d,bn.elements[10]*=d,e.setFromRotationMatrix(bn),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,i,r,o,a=fn,l=!1){let c=this.elements,h=2*r/(e-t),d=2*r/(n-i),u=(e+t)/(e-t),f=(n+i)/(n-i),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===fn)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===ur)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,i,r,o,a=fn,l=!1){let c=this.elements,h=2/(e-t),d=2/(n-i),u=-(e+t)/(e-t),f=-(n+i)/(n-i),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===fn)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===ur)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let i=0;i<16;i++)if(e[i]!==n[i])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},gs=new H,bn=new _e,Sx=new H(0,0,0),Ax=new H(1,1,1),vi=new H,ko=new H,nn=new H,vf=new _e,_f=new zn,Ai=class s{constructor(t=0,e=0,n=0,i=s.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=i}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,i=this._order){return this._x=t,this._y=e,this._z=n,this._order=i,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let i=t.elements,r=i[0],o=i[4],a=i[8],l=i[1],c=i[5],h=i[9],d=i[2],u=i[6],f=i[10];switch(e){case"XYZ":this._y=Math.asin($t(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-$t(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin($t(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-$t(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin($t(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-$t(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Nt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return vf.makeRotationFromQuaternion(t),this.setFromRotationMatrix(vf,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return _f.setFromEuler(this),this.setFromQuaternion(_f,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ai.DEFAULT_ORDER="XYZ";var pr=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Ex=0,Mf=new H,xs=new zn,Qn=new _e,Bo=new H,sr=new H,Tx=new H,Cx=new zn,bf=new H(1,0,0),wf=new H(0,1,0),Sf=new H(0,0,1),Af={type:"added"},Rx={type:"removed"},ys={type:"childadded",child:null},Qc={type:"childremoved",child:null},mn=class s extends Bn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Ex++}),this.uuid=Lr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=s.DEFAULT_UP.clone();let t=new H,e=new Ai,n=new zn,i=new H(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:i},modelViewMatrix:{value:new _e},normalMatrix:{value:new Ft}}),this.matrix=new _e,this.matrixWorld=new _e,this.matrixAutoUpdate=s.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=s.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new pr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return xs.setFromAxisAngle(t,e),this.quaternion.multiply(xs),this}rotateOnWorldAxis(t,e){return xs.setFromAxisAngle(t,e),this.quaternion.premultiply(xs),this}rotateX(t){return this.rotateOnAxis(bf,t)}rotateY(t){return this.rotateOnAxis(wf,t)}rotateZ(t){return this.rotateOnAxis(Sf,t)}translateOnAxis(t,e){return Mf.copy(t).applyQuaternion(this.quaternion),this.position.add(Mf.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(bf,t)}translateY(t){return this.translateOnAxis(wf,t)}translateZ(t){return this.translateOnAxis(Sf,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Qn.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Bo.copy(t):Bo.set(t,e,n);let i=this.parent;this.updateWorldMatrix(!0,!1),sr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Qn.lookAt(sr,Bo,this.up):Qn.lookAt(Bo,sr,this.up),this.quaternion.setFromRotationMatrix(Qn),i&&(Qn.extractRotation(i.matrixWorld),xs.setFromRotationMatrix(Qn),this.quaternion.premultiply(xs.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Ot("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Af),ys.child=t,this.dispatchEvent(ys),ys.child=null):Ot("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Rx),Qc.child=t,this.dispatchEvent(Qc),Qc.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Qn.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Qn.multiply(t.parent.matrixWorld)),t.applyMatrix4(Qn),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Af),ys.child=t,this.dispatchEvent(ys),ys.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,i=this.children.length;n<i;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let i=this.children;for(let r=0,o=i.length;r<o;r++)i[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(sr,t,Tx),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(sr,Cx,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,i=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*i,r[13]+=n-r[1]*e-r[5]*n-r[9]*i,r[14]+=i-r[2]*e-r[6]*n-r[10]*i}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let i={};i.uuid=this.uuid,i.type=this.type,i.name=this.name,i.castShadow=this.castShadow,i.receiveShadow=this.receiveShadow,i.visible=this.visible,i.frustumCulled=this.frustumCulled,i.renderOrder=this.renderOrder,i.static=this.static,i.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(i.userData=this.userData),i.layers=this.layers.mask,i.matrix=this.matrix.toArray(),i.up=this.up.toArray(),this.pivot!==null&&(i.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(i.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(i.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(i.type="InstancedMesh",i.count=this.count,i.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(i.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(i.type="BatchedMesh",i.perObjectFrustumCulled=this.perObjectFrustumCulled,i.sortObjects=this.sortObjects,i.drawRanges=this._drawRanges,i.reservedRanges=this._reservedRanges,i.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),i.instanceInfo=this._instanceInfo.map(a=>({...a})),i.availableInstanceIds=this._availableInstanceIds.slice(),i.availableGeometryIds=this._availableGeometryIds.slice(),i.nextIndexStart=this._nextIndexStart,i.nextVertexStart=this._nextVertexStart,i.geometryCount=this._geometryCount,i.maxInstanceCount=this._maxInstanceCount,i.maxVertexCount=this._maxVertexCount,i.maxIndexCount=this._maxIndexCount,i.geometryInitialized=this._geometryInitialized,i.matricesTexture=this._matricesTexture.toJSON(t),i.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(i.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(i.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(i.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?i.background=this.background.toJSON():this.background.isTexture&&(i.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(i.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){i.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(i.bindMode=this.bindMode,i.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),i.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));i.material=a}else i.material=r(t.materials,this.material);if(this.children.length>0){i.children=[];for(let a=0;a<this.children.length;a++)i.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){i.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];i.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),d=o(t.shapes),u=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=i,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let i=t.children[n];this.add(i.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};mn.DEFAULT_UP=new H(0,1,0);mn.DEFAULT_MATRIX_AUTO_UPDATE=!0;mn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Hi=class extends mn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Ix={type:"move"},Ls=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Hi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Hi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new H,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new H),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Hi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new H,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new H,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let i=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,n),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,p=.005;c.inputState.pinching&&u>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(i=e.getPose(t.targetRaySpace,n),i===null&&r!==null&&(i=r),i!==null&&(a.matrix.fromArray(i.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,i.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(i.linearVelocity)):a.hasLinearVelocity=!1,i.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(i.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Ix)))}return a!==null&&(a.visible=i!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Hi;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},_p={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},_i={h:0,s:0,l:0},zo={h:0,s:0,l:0};function th(s,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?s+(t-s)*6*e:e<1/2?t:e<2/3?s+(t-s)*6*(2/3-e):s}var Zt=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let i=t;i&&i.isColor?this.copy(i):typeof i=="number"?this.setHex(i):typeof i=="string"&&this.setStyle(i)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=rn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Ht.colorSpaceToWorking(this,e),this}setRGB(t,e,n,i=Ht.workingColorSpace){return this.r=t,this.g=e,this.b=n,Ht.colorSpaceToWorking(this,i),this}setHSL(t,e,n,i=Ht.workingColorSpace){if(t=yx(t,1),e=$t(e,0,1),n=$t(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=th(o,r,t+1/3),this.g=th(o,r,t),this.b=th(o,r,t-1/3)}return Ht.colorSpaceToWorking(this,i),this}setStyle(t,e=rn){function n(r){r!==void 0&&parseFloat(r)<1&&Nt("Color: Alpha component of "+t+" will be ignored.")}let i;if(i=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=i[1],a=i[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Nt("Color: Unknown color model "+t)}}else if(i=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=i[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Nt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=rn){let n=_p[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Nt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=si(t.r),this.g=si(t.g),this.b=si(t.b),this}copyLinearToSRGB(t){return this.r=Cs(t.r),this.g=Cs(t.g),this.b=Cs(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=rn){return Ht.workingToColorSpace(He.copy(this),t),Math.round($t(He.r*255,0,255))*65536+Math.round($t(He.g*255,0,255))*256+Math.round($t(He.b*255,0,255))}getHexString(t=rn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Ht.workingColorSpace){Ht.workingToColorSpace(He.copy(this),e);let n=He.r,i=He.g,r=He.b,o=Math.max(n,i,r),a=Math.min(n,i,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case n:l=(i-r)/d+(i<r?6:0);break;case i:l=(r-n)/d+2;break;case r:l=(n-i)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Ht.workingColorSpace){return Ht.workingToColorSpace(He.copy(this),e),t.r=He.r,t.g=He.g,t.b=He.b,t}getStyle(t=rn){Ht.workingToColorSpace(He.copy(this),t);let e=He.r,n=He.g,i=He.b;return t!==rn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${i.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(i*255)})`}offsetHSL(t,e,n){return this.getHSL(_i),this.setHSL(_i.h+t,_i.s+e,_i.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(_i),t.getHSL(zo);let n=Yc(_i.h,zo.h,e),i=Yc(_i.s,zo.s,e),r=Yc(_i.l,zo.l,e);return this.setHSL(n,i,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,i=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*i,this.g=r[1]*e+r[4]*n+r[7]*i,this.b=r[2]*e+r[5]*n+r[8]*i,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},He=new Zt;Zt.NAMES=_p;var mr=class extends mn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ai,this.environmentIntensity=1,this.environmentRotation=new Ai,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},wn=new H,ti=new H,eh=new H,ei=new H,vs=new H,_s=new H,Ef=new H,nh=new H,ih=new H,sh=new H,rh=new ye,oh=new ye,ah=new ye,Si=class s{constructor(t=new H,e=new H,n=new H){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,i){i.subVectors(n,e),wn.subVectors(t,e),i.cross(wn);let r=i.lengthSq();return r>0?i.multiplyScalar(1/Math.sqrt(r)):i.set(0,0,0)}static getBarycoord(t,e,n,i,r){wn.subVectors(i,e),ti.subVectors(n,e),eh.subVectors(t,e);let o=wn.dot(wn),a=wn.dot(ti),l=wn.dot(eh),c=ti.dot(ti),h=ti.dot(eh),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,f=(c*l-a*h)*u,p=(o*h-a*l)*u;return r.set(1-f-p,p,f)}static containsPoint(t,e,n,i){return this.getBarycoord(t,e,n,i,ei)===null?!1:ei.x>=0&&ei.y>=0&&ei.x+ei.y<=1}static getInterpolation(t,e,n,i,r,o,a,l){return this.getBarycoord(t,e,n,i,ei)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ei.x),l.addScaledVector(o,ei.y),l.addScaledVector(a,ei.z),l)}static getInterpolatedAttribute(t,e,n,i,r,o){return rh.setScalar(0),oh.setScalar(0),ah.setScalar(0),rh.fromBufferAttribute(t,e),oh.fromBufferAttribute(t,n),ah.fromBufferAttribute(t,i),o.setScalar(0),o.addScaledVector(rh,r.x),o.addScaledVector(oh,r.y),o.addScaledVector(ah,r.z),o}static isFrontFacing(t,e,n,i){return wn.subVectors(n,e),ti.subVectors(t,e),wn.cross(ti).dot(i)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,i){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[i]),this}setFromAttributeAndIndices(t,e,n,i){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,i),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return wn.subVectors(this.c,this.b),ti.subVectors(this.a,this.b),wn.cross(ti).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return s.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return s.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,i,r){return s.getInterpolation(t,this.a,this.b,this.c,e,n,i,r)}containsPoint(t){return s.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return s.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,i=this.b,r=this.c,o,a;vs.subVectors(i,n),_s.subVectors(r,n),nh.subVectors(t,n);let l=vs.dot(nh),c=_s.dot(nh);if(l<=0&&c<=0)return e.copy(n);ih.subVectors(t,i);let h=vs.dot(ih),d=_s.dot(ih);if(h>=0&&d<=h)return e.copy(i);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(vs,o);sh.subVectors(t,r);let f=vs.dot(sh),p=_s.dot(sh);if(p>=0&&f<=p)return e.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(n).addScaledVector(_s,a);let m=h*p-f*d;if(m<=0&&d-h>=0&&f-p>=0)return Ef.subVectors(r,i),a=(d-h)/(d-h+(f-p)),e.copy(i).addScaledVector(Ef,a);let g=1/(m+x+u);return o=x*g,a=u*g,e.copy(n).addScaledVector(vs,o).addScaledVector(_s,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Ei=class{constructor(t=new H(1/0,1/0,1/0),e=new H(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Sn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Sn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Sn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Sn):Sn.fromBufferAttribute(r,o),Sn.applyMatrix4(t.matrixWorld),this.expandByPoint(Sn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Go.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Go.copy(n.boundingBox)),Go.applyMatrix4(t.matrixWorld),this.union(Go)}let i=t.children;for(let r=0,o=i.length;r<o;r++)this.expandByObject(i[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Sn),Sn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(rr),Vo.subVectors(this.max,rr),Ms.subVectors(t.a,rr),bs.subVectors(t.b,rr),ws.subVectors(t.c,rr),Mi.subVectors(bs,Ms),bi.subVectors(ws,bs),Bi.subVectors(Ms,ws);let e=[0,-Mi.z,Mi.y,0,-bi.z,bi.y,0,-Bi.z,Bi.y,Mi.z,0,-Mi.x,bi.z,0,-bi.x,Bi.z,0,-Bi.x,-Mi.y,Mi.x,0,-bi.y,bi.x,0,-Bi.y,Bi.x,0];return!lh(e,Ms,bs,ws,Vo)||(e=[1,0,0,0,1,0,0,0,1],!lh(e,Ms,bs,ws,Vo))?!1:(Ho.crossVectors(Mi,bi),e=[Ho.x,Ho.y,Ho.z],lh(e,Ms,bs,ws,Vo))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Sn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Sn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ni[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ni[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ni[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ni[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ni[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ni[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ni[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ni[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ni),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ni=[new H,new H,new H,new H,new H,new H,new H,new H],Sn=new H,Go=new Ei,Ms=new H,bs=new H,ws=new H,Mi=new H,bi=new H,Bi=new H,rr=new H,Vo=new H,Ho=new H,zi=new H;function lh(s,t,e,n,i){for(let r=0,o=s.length-3;r<=o;r+=3){zi.fromArray(s,r);let a=i.x*Math.abs(zi.x)+i.y*Math.abs(zi.y)+i.z*Math.abs(zi.z),l=t.dot(zi),c=e.dot(zi),h=n.dot(zi);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Ae=new H,Wo=new Jt,Px=0,Ze=class extends Bn{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Px++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=pp,this.updateRanges=[],this.gpuType=Cn,this.version=0,this._normalizationScale=t!==void 0?Kh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let i=0,r=this.itemSize;i<r;i++)this.array[t+i]=e.array[n+i];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Wo.fromBufferAttribute(this,e),Wo.applyMatrix3(t),this.setXY(e,Wo.x,Wo.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)Ae.fromBufferAttribute(this,e),Ae.applyMatrix3(t),this.setXYZ(e,Ae.x,Ae.y,Ae.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)Ae.fromBufferAttribute(this,e),Ae.applyMatrix4(t),this.setXYZ(e,Ae.x,Ae.y,Ae.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Ae.fromBufferAttribute(this,e),Ae.applyNormalMatrix(t),this.setXYZ(e,Ae.x,Ae.y,Ae.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Ae.fromBufferAttribute(this,e),Ae.transformDirection(t),this.setXYZ(e,Ae.x,Ae.y,Ae.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=i,this}setXYZW(t,e,n,i,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),i=this._normalize(i),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=i,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):vx(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):_x(t,this.array)}};var gr=class extends Ze{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var xr=class extends Ze{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var pn=class extends Ze{constructor(t,e,n){super(new Float32Array(t),e,n)}},Lx=new Ei,or=new H,ch=new H,Ns=class{constructor(t=new H,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Lx.setFromPoints(t).getCenter(n);let i=0;for(let r=0,o=t.length;r<o;r++)i=Math.max(i,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(i),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;or.subVectors(t,this.center);let e=or.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),i=(n-this.radius)*.5;this.center.addScaledVector(or,i/n),this.radius+=i}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(ch.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(or.copy(t.center).add(ch)),this.expandByPoint(or.copy(t.center).sub(ch))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Nx=0,dn=new _e,hh=new mn,Ss=new H,sn=new Ei,ar=new Ei,Pe=new H,Gn=class s extends Bn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Nx++}),this.uuid=Lr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(gx(t)?xr:gr)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Ft().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let i=this.attributes.tangent;return i!==void 0&&(i.transformDirection(t),i.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return dn.makeRotationFromQuaternion(t),this.applyMatrix4(dn),this}rotateX(t){return dn.makeRotationX(t),this.applyMatrix4(dn),this}rotateY(t){return dn.makeRotationY(t),this.applyMatrix4(dn),this}rotateZ(t){return dn.makeRotationZ(t),this.applyMatrix4(dn),this}translate(t,e,n){return dn.makeTranslation(t,e,n),this.applyMatrix4(dn),this}scale(t,e,n){return dn.makeScale(t,e,n),this.applyMatrix4(dn),this}lookAt(t){return hh.lookAt(t),hh.updateMatrix(),this.applyMatrix4(hh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ss).negate(),this.translate(Ss.x,Ss.y,Ss.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let i=0,r=t.length;i<r;i++){let o=t[i];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new pn(n,3))}else{let n=Math.min(t.length,e.count);for(let i=0;i<n;i++){let r=t[i];e.setXYZ(i,r.x,r.y,r.z||0)}t.length>e.count&&Nt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ei);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ot("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new H(-1/0,-1/0,-1/0),new H(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,i=e.length;n<i;n++){let r=e[n];sn.setFromBufferAttribute(r),this.morphTargetsRelative?(Pe.addVectors(this.boundingBox.min,sn.min),this.boundingBox.expandByPoint(Pe),Pe.addVectors(this.boundingBox.max,sn.max),this.boundingBox.expandByPoint(Pe)):(this.boundingBox.expandByPoint(sn.min),this.boundingBox.expandByPoint(sn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ot('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ns);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ot("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new H,1/0);return}if(t){let n=this.boundingSphere.center;if(sn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ar.setFromBufferAttribute(a),this.morphTargetsRelative?(Pe.addVectors(sn.min,ar.min),sn.expandByPoint(Pe),Pe.addVectors(sn.max,ar.max),sn.expandByPoint(Pe)):(sn.expandByPoint(ar.min),sn.expandByPoint(ar.max))}sn.getCenter(n);let i=0;for(let r=0,o=t.count;r<o;r++)Pe.fromBufferAttribute(t,r),i=Math.max(i,n.distanceToSquared(Pe));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Pe.fromBufferAttribute(a,c),l&&(Ss.fromBufferAttribute(t,c),Pe.add(Ss)),i=Math.max(i,n.distanceToSquared(Pe))}this.boundingSphere.radius=Math.sqrt(i),isNaN(this.boundingSphere.radius)&&Ot('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Ot("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,i=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Ze(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let D=0;D<n.count;D++)a[D]=new H,l[D]=new H;let h=new H,d=new H,u=new H,f=new Jt,p=new Jt,x=new Jt,m=new H,g=new H;function M(D,C,L){c[D]=c[C]=c[L]=1,h.fromBufferAttribute(n,D),d.fromBufferAttribute(n,C),u.fromBufferAttribute(n,L),f.fromBufferAttribute(r,D),p.fromBufferAttribute(r,C),x.fromBufferAttribute(r,L),d.sub(h),u.sub(h),p.sub(f),x.sub(f);let F=1/(p.x*x.y-x.x*p.y);isFinite(F)&&(m.copy(d).multiplyScalar(x.y).addScaledVector(u,-p.y).multiplyScalar(F),g.copy(u).multiplyScalar(p.x).addScaledVector(d,-x.x).multiplyScalar(F),a[D].add(m),a[C].add(m),a[L].add(m),l[D].add(g),l[C].add(g),l[L].add(g))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let D=0,C=A.length;D<C;++D){let L=A[D],F=L.start,W=L.count;for(let I=F,z=F+W;I<z;I+=3)M(t.getX(I+0),t.getX(I+1),t.getX(I+2))}let b=new H,T=new H,E=new H,y=new H;function w(D){E.fromBufferAttribute(i,D),y.copy(E);let C=a[D];b.copy(C),b.sub(E.multiplyScalar(E.dot(C))).normalize(),T.crossVectors(y,C);let F=T.dot(l[D])<0?-1:1;o.setXYZW(D,b.x,b.y,b.z,F)}for(let D=0,C=n.count;D<C;++D)c[D]&&w(D);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Ze(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let u=0,f=n.count;u<f;u++)n.setXYZ(u,0,0,0);let i=new H,r=new H,o=new H,a=new H,l=new H,c=new H,h=new H,d=new H;if(t)for(let u=0,f=t.count;u<f;u+=3){let p=t.getX(u+0),x=t.getX(u+1),m=t.getX(u+2);i.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),h.subVectors(o,r),d.subVectors(i,r),h.cross(d),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,f=e.count;u<f;u+=3)i.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),d.subVectors(i,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Pe.fromBufferAttribute(t,e),Pe.normalize(),t.setXYZ(e,Pe.x,Pe.y,Pe.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h),f=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*h;for(let g=0;g<h;g++)u[p++]=c[f++]}return new Ze(u,h,d)}if(this.index===null)return Nt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new s,n=this.index.array,i=this.attributes;for(let a in i){let l=i[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){let u=c[h],f=t(u,n);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let i={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let f=c[d];h.push(f.toJSON(t.data))}h.length>0&&(i[l]=h,r=!0)}r&&(t.data.morphAttributes=i,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let i=t.attributes;for(let c in i){let h=i[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var uh=new H,Dx=new H,Ox=new Ft,An=class{constructor(t=new H(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,i){return this.normal.set(t,e,n),this.constant=i,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let i=uh.subVectors(n,e).cross(Dx.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(i,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let i=t.delta(uh),r=this.normal.dot(i);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(i,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Ox.getNormalMatrix(t),i=this.coplanarPoint(uh).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-i.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Fx=0,Xi=class extends Bn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Fx++}),this.uuid=Lr(),this.name="",this.type="Material",this.blending=Us,this.side=Ii,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Sh,this.blendDst=Ah,this.blendEquation=Ki,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Zt(0,0,0),this.blendAlpha=0,this.depthFunc=Rs,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=lp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ra,this.stencilZFail=ra,this.stencilZPass=ra,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Nt(`Material: parameter '${e}' has value of undefined.`);continue}let i=this[e];if(i===void 0){Nt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}i&&i.isColor?i.set(n):i&&i.isVector2&&n&&n.isVector2||i&&i.isEuler&&n&&n.isEuler||i&&i.isVector3&&n&&n.isVector3?i.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function i(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=i(t.textures),o=i(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Zt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new An().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Jt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Jt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let i=e.length;n=new Array(i);for(let r=0;r!==i;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var ii=new H,dh=new H,Xo=new H,qo=new H,_a=class{constructor(t=new H,e=new H(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ii)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ii.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ii.copy(this.origin).addScaledVector(this.direction,e),ii.distanceToSquared(t))}distanceSqToSegment(t,e,n,i){dh.copy(t).add(e).multiplyScalar(.5),Xo.copy(e).sub(t).normalize(),qo.copy(this.origin).sub(dh);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Xo),a=qo.dot(this.direction),l=-qo.dot(Xo),c=qo.lengthSq(),h=Math.abs(1-o*o),d,u,f,p;if(h>0)if(d=o*l-a,u=o*a-l,p=r*h,d>=0)if(u>=-p)if(u<=p){let x=1/h;d*=x,u*=x,f=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u<=-p?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c):u<=p?(d=0,u=Math.min(Math.max(-r,-l),r),f=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),i&&i.copy(dh).addScaledVector(Xo,u),f}intersectSphere(t,e){if(t.radius<0)return null;ii.subVectors(t.center,this.origin);let n=ii.dot(this.direction),i=ii.dot(ii)-n*n,r=t.radius*t.radius;if(i>r)return null;let o=Math.sqrt(r-i),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,i,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(t.min.x-u.x)*c,i=(t.max.x-u.x)*c):(n=(t.max.x-u.x)*c,i=(t.min.x-u.x)*c),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),n>o||r>i||((r>n||isNaN(n))&&(n=r),(o<i||isNaN(i))&&(i=o),d>=0?(a=(t.min.z-u.z)*d,l=(t.max.z-u.z)*d):(a=(t.max.z-u.z)*d,l=(t.min.z-u.z)*d),n>l||a>i)||((a>n||n!==n)&&(n=a),(l<i||i!==i)&&(i=l),i<0)?null:this.at(n>=0?n:i,e)}intersectsBox(t){return this.intersectBox(t,ii)!==null}intersectTriangle(t,e,n,i,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,d=t.x-o.x,u=t.y-o.y,f=t.z-o.z,p=e.x-o.x,x=e.y-o.y,m=e.z-o.z,g=n.x-o.x,M=n.y-o.y,A=n.z-o.z,b=Math.abs(l),T=Math.abs(c),E=Math.abs(h),y,w,D,C,L,F,W,I,z,q,G,tt;if(b>=T&&b>=E?(D=l,F=d,z=p,tt=g,l>=0?(y=c,w=h,C=u,L=f,W=x,I=m,q=M,G=A):(y=h,w=c,C=f,L=u,W=m,I=x,q=A,G=M)):T>=E?(D=c,F=u,z=x,tt=M,c>=0?(y=h,w=l,C=f,L=d,W=m,I=p,q=A,G=g):(y=l,w=h,C=d,L=f,W=p,I=m,q=g,G=A)):(D=h,F=f,z=m,tt=A,h>=0?(y=l,w=c,C=d,L=u,W=p,I=x,q=g,G=M):(y=c,w=l,C=u,L=d,W=x,I=p,q=M,G=g)),D===0)return null;let X=y/D,Q=w/D,et=1/D,Mt=C-X*F,Dt=L-Q*F,K=W-X*z,pt=I-Q*z,_t=q-X*tt,At=G-Q*tt,ht=_t*pt-At*K,It=Mt*At-Dt*_t,oe=K*Dt-pt*Mt;if(i){if(ht<0||It<0||oe<0)return null}else if((ht<0||It<0||oe<0)&&(ht>0||It>0||oe>0))return null;let Ct=ht+It+oe;if(Ct===0)return null;let qt=et*(ht*F+It*z+oe*tt);return(Ct>0?qt<0:qt>0)?null:this.at(qt/Ct,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ma=class extends Xi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Zt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ai,this.combine=Eh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Tf=new _e,Gi=new _a,$o=new Ns,Cf=new H,Yo=new H,Ko=new H,Zo=new H,fh=new H,Jo=new H,Rf=new H,jo=new H,gn=class extends mn{constructor(t=new Gn,e=new Ma){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let i=e[n[0]];if(i!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=i.length;r<o;r++){let a=i[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,i=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(i,t);let a=this.morphTargetInfluences;if(r&&a){Jo.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],d=r[l];h!==0&&(fh.fromBufferAttribute(d,t),o?Jo.addScaledVector(fh,h):Jo.addScaledVector(fh.sub(e),h))}e.add(Jo)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,i=this.material,r=this.matrixWorld;i!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),$o.copy(n.boundingSphere),$o.applyMatrix4(r),Gi.copy(t.ray).recast(t.near),!($o.containsPoint(Gi.origin)===!1&&(Gi.intersectSphere($o,Cf)===null||Gi.origin.distanceToSquared(Cf)>(t.far-t.near)**2))&&(Tf.copy(r).invert(),Gi.copy(t.ray).applyMatrix4(Tf),!(n.boundingBox!==null&&Gi.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Gi)))}_computeIntersections(t,e,n){let i,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=u.length;p<x;p++){let m=u[p],g=o[m.materialIndex],M=Math.max(m.start,f.start),A=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=M,T=A;b<T;b+=3){let E=a.getX(b),y=a.getX(b+1),w=a.getX(b+2);i=Qo(this,g,t,n,c,h,d,E,y,w),i&&(i.faceIndex=Math.floor(b/3),i.face.materialIndex=m.materialIndex,e.push(i))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let M=a.getX(m),A=a.getX(m+1),b=a.getX(m+2);i=Qo(this,o,t,n,c,h,d,M,A,b),i&&(i.faceIndex=Math.floor(m/3),e.push(i))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=u.length;p<x;p++){let m=u[p],g=o[m.materialIndex],M=Math.max(m.start,f.start),A=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=M,T=A;b<T;b+=3){let E=b,y=b+1,w=b+2;i=Qo(this,g,t,n,c,h,d,E,y,w),i&&(i.faceIndex=Math.floor(b/3),i.face.materialIndex=m.materialIndex,e.push(i))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let M=m,A=m+1,b=m+2;i=Qo(this,o,t,n,c,h,d,M,A,b),i&&(i.faceIndex=Math.floor(m/3),e.push(i))}}}};function Ux(s,t,e,n,i,r,o,a){let l;if(t.side===Je?l=n.intersectTriangle(o,r,i,!0,a):l=n.intersectTriangle(i,r,o,t.side===Ii,a),l===null)return null;jo.copy(a),jo.applyMatrix4(s.matrixWorld);let c=e.ray.origin.distanceTo(jo);return c<e.near||c>e.far?null:{distance:c,point:jo.clone(),object:s}}function Qo(s,t,e,n,i,r,o,a,l,c){s.getVertexPosition(a,Yo),s.getVertexPosition(l,Ko),s.getVertexPosition(c,Zo);let h=Ux(s,t,e,n,Yo,Ko,Zo,Rf);if(h){let d=new H;Si.getBarycoord(Rf,Yo,Ko,Zo,d),i&&(h.uv=Si.getInterpolatedAttribute(i,a,l,c,d,new Jt)),r&&(h.uv1=Si.getInterpolatedAttribute(r,a,l,c,d,new Jt)),o&&(h.normal=Si.getInterpolatedAttribute(o,a,l,c,d,new H),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new H,materialIndex:0};Si.getNormal(Yo,Ko,Zo,u.normal),h.face=u,h.barycoord=d}return h}var qi=class extends Qe{constructor(t=null,e=1,n=1,i,r,o,a,l,c=Le,h=Le,d,u){super(null,o,a,l,c,h,i,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Vi=new Ns,kx=new Jt(.5,.5),ta=new H,$i=class{constructor(t=new An,e=new An,n=new An,i=new An,r=new An,o=new An){this.planes=[t,e,n,i,r,o]}set(t,e,n,i,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(i),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=fn,n=!1){let i=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],f=r[7],p=r[8],x=r[9],m=r[10],g=r[11],M=r[12],A=r[13],b=r[14],T=r[15];if(i[0].setComponents(c-o,f-h,g-p,T-M).normalize(),i[1].setComponents(c+o,f+h,g+p,T+M).normalize(),i[2].setComponents(c+a,f+d,g+x,T+A).normalize(),i[3].setComponents(c-a,f-d,g-x,T-A).normalize(),n)i[4].setComponents(l,u,m,b).normalize(),i[5].setComponents(c-l,f-u,g-m,T-b).normalize();else if(i[4].setComponents(c-l,f-u,g-m,T-b).normalize(),e===fn)i[5].setComponents(c+l,f+u,g+m,T+b).normalize();else if(e===ur)i[5].setComponents(l,u,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Vi.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Vi.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Vi)}intersectsSprite(t){Vi.center.set(0,0,0);let e=kx.distanceTo(t.center);return Vi.radius=.7071067811865476+e,Vi.applyMatrix4(t.matrixWorld),this.intersectsSphere(Vi)}intersectsSphere(t){let e=this.planes,n=t.center,i=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<i)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let i=e[n];if(ta.x=i.normal.x>0?t.max.x:t.min.x,ta.y=i.normal.y>0?t.max.y:t.min.y,ta.z=i.normal.z>0?t.max.z:t.min.z,i.distanceToPoint(ta)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},If=new _e,ba=class s{constructor(){this.coordinateSystem=fn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let i=0;i<e.length;i++){let r=e[i];If.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[i]===void 0&&(n[i]=new $i),n[i].setFromProjectionMatrix(If,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let i=0;i<t._count;i++)e[i]===void 0&&(e[i]=new $i),e[i].copy(n[i]);return this._count=t._count,this}clone(){return new s().copy(this)}};var yr=class extends Qe{constructor(t=[],e=Zi,n,i,r,o,a,l,c,h){super(t,e,n,i,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var oi=class extends Qe{constructor(t,e,n=Tn,i,r,o,a=Le,l=Le,c,h=ri,d=1){if(h!==ri&&h!==ai)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:d};super(u,i,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Ps(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},vr=class extends oi{constructor(t,e=Tn,n=Zi,i,r,o=Le,a=Le,l,c=ri){let h={width:t,height:t,depth:1},d=[h,h,h,h,h,h];super(t,t,e,n,i,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},_r=class extends Qe{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Ds=class s extends Gn{constructor(t=1,e=1,n=1,i=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:i,heightSegments:r,depthSegments:o};let a=this;i=Math.floor(i),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],d=[],u=0,f=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,i,o,2),p("x","z","y",1,-1,t,n,-e,i,o,3),p("x","y","z",1,-1,t,e,n,i,r,4),p("x","y","z",-1,-1,t,e,-n,i,r,5),this.setIndex(l),this.setAttribute("position",new pn(c,3)),this.setAttribute("normal",new pn(h,3)),this.setAttribute("uv",new pn(d,2));function p(x,m,g,M,A,b,T,E,y,w,D){let C=b/y,L=T/w,F=b/2,W=T/2,I=E/2,z=y+1,q=w+1,G=0,tt=0,X=new H;for(let Q=0;Q<q;Q++){let et=Q*L-W;for(let Mt=0;Mt<z;Mt++){let Dt=Mt*C-F;X[x]=Dt*M,X[m]=et*A,X[g]=I,c.push(X.x,X.y,X.z),X[x]=0,X[m]=0,X[g]=E>0?1:-1,h.push(X.x,X.y,X.z),d.push(Mt/y),d.push(1-Q/w),G+=1}}for(let Q=0;Q<w;Q++)for(let et=0;et<y;et++){let Mt=u+et+z*Q,Dt=u+et+z*(Q+1),K=u+(et+1)+z*(Q+1),pt=u+(et+1)+z*Q;l.push(Mt,Dt,pt),l.push(Dt,K,pt),tt+=6}a.addGroup(f,tt,D),f+=tt,u+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Mr=class s extends Gn{constructor(t=1,e=1,n=1,i=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:i};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(i),c=a+1,h=l+1,d=t/a,u=e/l,f=[],p=[],x=[],m=[];for(let g=0;g<h;g++){let M=g*u-o;for(let A=0;A<c;A++){let b=A*d-r;p.push(b,-M,0),x.push(0,0,1),m.push(A/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let M=0;M<a;M++){let A=M+c*g,b=M+c*(g+1),T=M+1+c*(g+1),E=M+1+c*g;f.push(A,b,E),f.push(b,T,E)}this.setIndex(f),this.setAttribute("position",new pn(p,3)),this.setAttribute("normal",new pn(x,3)),this.setAttribute("uv",new pn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.width,t.height,t.widthSegments,t.heightSegments)}};function ji(s){let t={};for(let e in s){t[e]={};for(let n in s[e]){let i=s[e][n];if(Pf(i))i.isRenderTargetTexture?(Nt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=i.clone();else if(Array.isArray(i))if(Pf(i[0])){let r=[];for(let o=0,a=i.length;o<a;o++)r[o]=i[o].clone();t[e][n]=r}else t[e][n]=i.slice();else t[e][n]=i}}return t}function We(s){let t={};for(let e=0;e<s.length;e++){let n=ji(s[e]);for(let i in n)t[i]=n[i]}return t}function Pf(s){return s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)}function Bx(s){let t=[];for(let e=0;e<s.length;e++)t.push(s[e].clone());return t}function Zh(s){let t=s.getRenderTarget();return t===null?s.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Ht.workingColorSpace}var Mp={clone:ji,merge:We},zx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Gx=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,xn=class extends Xi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=zx,this.fragmentShader=Gx,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=ji(t.uniforms),this.uniformsGroups=Bx(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let i in this.uniforms){let o=this.uniforms[i].value;o&&o.isTexture?e.uniforms[i]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[i]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[i]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[i]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[i]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[i]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[i]={type:"m4",value:o.toArray()}:e.uniforms[i]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let i in this.extensions)this.extensions[i]===!0&&(n[i]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let i=t.uniforms[n];switch(this.uniforms[n]={},i.type){case"t":this.uniforms[n].value=e[i.value]||null;break;case"c":this.uniforms[n].value=new Zt().setHex(i.value);break;case"v2":this.uniforms[n].value=new Jt().fromArray(i.value);break;case"v3":this.uniforms[n].value=new H().fromArray(i.value);break;case"v4":this.uniforms[n].value=new ye().fromArray(i.value);break;case"m3":this.uniforms[n].value=new Ft().fromArray(i.value);break;case"m4":this.uniforms[n].value=new _e().fromArray(i.value);break;default:this.uniforms[n].value=i.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},wa=class extends xn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Sa=class extends Xi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=op,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Aa=class extends Xi{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function As(s,t){return!s||s.constructor===t?s:typeof t.BYTES_PER_ELEMENT=="number"?new t(s):Array.prototype.slice.call(s)}function ea(s){return s!==void 0&&s.inTangents!==void 0&&s.outTangents!==void 0}var Ti=class{constructor(t,e,n,i){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=i!==void 0?i:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,i=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<i)){for(let a=n+2;;){if(i===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=i,i=e[++n],t<i)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(i=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(i=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,i)}return this.interpolate_(n,r,t,i)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,i=this.valueSize,r=t*i;for(let o=0;o!==i;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ea=class extends Ti{constructor(t,e,n,i){super(t,e,n,i),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:mh,endingEnd:mh}}intervalChanged_(t,e,n){let i=this.parameterPositions,r=t-2,o=t+1,a=i[r],l=i[o];if(a===void 0)switch(this.getSettings_().endingStart){case gh:r=t,a=2*e-n;break;case xh:r=i.length-2,a=e+i[r]-i[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case gh:o=t,l=2*n-e;break;case xh:o=1,l=n+i[1]-i[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,i){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,p=(n-e)/(i-e),x=p*p,m=x*p,g=-u*m+2*u*x-u*p,M=(1+u)*m+(-1.5-2*u)*x+(-.5+u)*p+1,A=(-1-f)*m+(1.5+f)*x+.5*p,b=f*m-f*x;for(let T=0;T!==a;++T)r[T]=g*o[h+T]+M*o[c+T]+A*o[l+T]+b*o[d+T];return r}},Ta=class extends Ti{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t,e,n,i){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(i-e),d=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*d+o[l+u]*h;return r}},Ca=class extends Ti{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t){return this.copySampleValue_(t-1)}},Ra=class extends Ti{interpolate_(t,e,n,i){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let p=(n-e)/(i-e),x=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let u=a*2,f=t-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=f*u+p*2,M=d[g],A=d[g+1],b=t*u+p*2,T=h[b],E=h[b+1],y=Hx(n,e,M,T,i);r[p]=bp(y,x,A,E,m)}return r}};function bp(s,t,e,n,i){let r=1-s;return r*r*r*t+3*r*r*s*e+3*r*s*s*n+s*s*s*i}function Vx(s,t,e,n,i){let r=1-s;return 3*r*r*(e-t)+6*r*s*(n-e)+3*s*s*(i-n)}function Hx(s,t,e,n,i){let r=(s-t)/(i-t);for(let o=0;o<8;o++){let a=bp(r,t,e,n,i)-s;if(Math.abs(a)<1e-10)break;let l=Vx(r,t,e,n,i);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var an=class{constructor(t,e,n,i){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=As(e,this.TimeBufferType),this.values=As(n,this.ValueBufferType),this.setInterpolation(i||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:As(t.times,Array),values:As(t.values,Array)};let i=t.getInterpolation();i!==t.DefaultInterpolation&&(n.interpolation=i),ea(t.settings)&&(n.settings={inTangents:As(t.settings.inTangents,Array),outTangents:As(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Ca(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Ta(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ea(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Ra(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case cr:e=this.InterpolantFactoryMethodDiscrete;break;case ma:e=this.InterpolantFactoryMethodLinear;break;case sa:e=this.InterpolantFactoryMethodSmooth;break;case ph:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Nt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return cr;case this.InterpolantFactoryMethodLinear:return ma;case this.InterpolantFactoryMethodSmooth:return sa;case this.InterpolantFactoryMethodBezier:return ph}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,i=e.length;n!==i;++n)e[n]+=t;ea(this.settings)&&(Lf(this.settings.inTangents,t),Lf(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,i=e.length;n!==i;++n)e[n]*=t;ea(this.settings)&&(Nf(this.settings.inTangents,t),Nf(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,i=n.length,r=0,o=i-1;for(;r!==i&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==i){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Ot("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,i=this.values,r=n.length;r===0&&(Ot("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Ot("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){Ot("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(i!==void 0&&xx(i))for(let a=0,l=i.length;a!==l;++a){let c=i[a];if(isNaN(c)){Ot("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),i=this.getInterpolation()===sa,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(i)l=!0;else{let d=a*n,u=d-n,f=d+n;for(let p=0;p!==n;++p){let x=e[d+p];if(x!==e[u+p]||x!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*n,u=o*n;for(let f=0;f!==n;++f)e[u+f]=e[d+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,i=new n(this.name,t,e);return i.createInterpolant=this.createInterpolant,ea(this.settings)&&(i.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),i}};function Lf(s,t){for(let e=0,n=s.length;e!==n;e+=2)s[e]+=t}function Nf(s,t){for(let e=0,n=s.length;e!==n;e+=2)s[e]*=t}an.prototype.ValueTypeName="";an.prototype.TimeBufferType=Float32Array;an.prototype.ValueBufferType=Float32Array;an.prototype.DefaultInterpolation=ma;var Ci=class extends an{constructor(t,e,n){super(t,e,n)}};Ci.prototype.ValueTypeName="bool";Ci.prototype.ValueBufferType=Array;Ci.prototype.DefaultInterpolation=cr;Ci.prototype.InterpolantFactoryMethodLinear=void 0;Ci.prototype.InterpolantFactoryMethodSmooth=void 0;var Ia=class extends an{constructor(t,e,n,i){super(t,e,n,i)}};Ia.prototype.ValueTypeName="color";var Pa=class extends an{constructor(t,e,n,i){super(t,e,n,i)}};Pa.prototype.ValueTypeName="number";var La=class extends Ti{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t,e,n,i){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(i-e),c=t*a;for(let h=c+a;c!==h;c+=4)zn.slerpFlat(r,0,o,c-a,o,c,l);return r}},br=class extends an{constructor(t,e,n,i){super(t,e,n,i)}InterpolantFactoryMethodLinear(t){return new La(this.times,this.values,this.getValueSize(),t)}};br.prototype.ValueTypeName="quaternion";br.prototype.InterpolantFactoryMethodSmooth=void 0;var Ri=class extends an{constructor(t,e,n){super(t,e,n)}};Ri.prototype.ValueTypeName="string";Ri.prototype.ValueBufferType=Array;Ri.prototype.DefaultInterpolation=cr;Ri.prototype.InterpolantFactoryMethodLinear=void 0;Ri.prototype.InterpolantFactoryMethodSmooth=void 0;var Na=class extends an{constructor(t,e,n,i){super(t,e,n,i)}};Na.prototype.ValueTypeName="vector";var Da=class{constructor(t,e,n){let i=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&i.onStart!==void 0&&i.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,i.onProgress!==void 0&&i.onProgress(h,o,a),o===a&&(r=!1,i.onLoad!==void 0&&i.onLoad())},this.itemError=function(h){i.onError!==void 0&&i.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let f=c[d],p=c[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},wp=new Da,Oa=class{constructor(t){this.manager=t!==void 0?t:wp,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(i,r){n.load(t,i,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Oa.DEFAULT_MATERIAL_NAME="__DEFAULT";var na=new H,ia=new zn,Un=new H,wr=class extends mn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new _e,this.projectionMatrix=new _e,this.projectionMatrixInverse=new _e,this.coordinateSystem=fn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(na,ia,Un),Un.x===1&&Un.y===1&&Un.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(na,ia,Un.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(na,ia,Un),Un.x===1&&Un.y===1&&Un.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(na,ia,Un.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},wi=new H,Df=new Jt,Of=new Jt,Ke=class extends wr{constructor(t=50,e=1,n=.1,i=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=i,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=ga*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan($c*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return ga*2*Math.atan(Math.tan($c*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){wi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(wi.x,wi.y).multiplyScalar(-t/wi.z),wi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(wi.x,wi.y).multiplyScalar(-t/wi.z)}getViewSize(t,e){return this.getViewBounds(t,Df,Of),e.subVectors(Of,Df)}setViewOffset(t,e,n,i,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=i,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan($c*.5*this.fov)/this.zoom,n=2*e,i=this.aspect*n,r=-.5*i,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*i/l,e-=o.offsetY*n/c,i*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+i,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Fa=class extends wr{constructor(t=-1,e=1,n=1,i=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=i,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,i,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=i,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,i=(this.top+this.bottom)/2,r=n-t,o=n+t,a=i+e,l=i-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var Es=-90,Ts=1,Os=class extends mn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let i=new Ke(Es,Ts,t,e);i.layers=this.layers,this.add(i);let r=new Ke(Es,Ts,t,e);r.layers=this.layers,this.add(r);let o=new Ke(Es,Ts,t,e);o.layers=this.layers,this.add(o);let a=new Ke(Es,Ts,t,e);a.layers=this.layers,this.add(a);let l=new Ke(Es,Ts,t,e);l.layers=this.layers,this.add(l);let c=new Ke(Es,Ts,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,i,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===fn)n.up.set(0,1,0),n.lookAt(1,0,0),i.up.set(0,1,0),i.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ur)n.up.set(0,-1,0),n.lookAt(-1,0,0),i.up.set(0,-1,0),i.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:i}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,i),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,i),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,i),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,i),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,i),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=x,t.setRenderTarget(n,5,i),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(d,u,f),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Ua=class extends Ke{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Jh="\\[\\]\\.:\\/",Wx=new RegExp("["+Jh+"]","g"),jh="[^"+Jh+"]",Xx="[^"+Jh.replace("\\.","")+"]",qx=/((?:WC+[\/:])*)/.source.replace("WC",jh),$x=/(WCOD+)?/.source.replace("WCOD",Xx),Yx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",jh),Kx=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",jh),Zx=new RegExp("^"+qx+$x+Yx+Kx+"$"),Jx=["material","materials","bones","map"],yh=class{constructor(t,e,n){let i=n||he.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,i)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,i=this._bindings[n];i!==void 0&&i.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let i=this._targetGroup.nCachedObjects_,r=n.length;i!==r;++i)n[i].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},he=class s{constructor(t,e,n){this.path=e,this.parsedPath=n||s.parseTrackName(e),this.node=s.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new s.Composite(t,e,n):new s(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Wx,"")}static parseTrackName(t){let e=Zx.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},i=n.nodeName&&n.nodeName.lastIndexOf(".");if(i!==void 0&&i!==-1){let r=n.nodeName.substring(i+1);Jx.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,i),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},i=n(t.children);if(i)return i}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let i=0,r=n.length;i!==r;++i)t[e++]=n[i]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let i=0,r=n.length;i!==r;++i)n[i]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let i=0,r=n.length;i!==r;++i)n[i]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let i=0,r=n.length;i!==r;++i)n[i]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,i=e.propertyName,r=e.propertyIndex;if(t||(t=s.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Nt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){Ot("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Ot("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Ot("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Ot("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Ot("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){Ot("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){Ot("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[i];if(o===void 0){let c=e.nodeName;Ot("PropertyBinding: Trying to update property for track: "+c+"."+i+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(i==="morphTargetInfluences"){if(!t.geometry){Ot("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Ot("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=i;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};he.Composite=yh;he.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};he.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};he.prototype.GetterByBindingType=[he.prototype._getValue_direct,he.prototype._getValue_array,he.prototype._getValue_arrayElement,he.prototype._getValue_toArray];he.prototype.SetterByBindingTypeAndVersioning=[[he.prototype._setValue_direct,he.prototype._setValue_direct_setNeedsUpdate,he.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[he.prototype._setValue_array,he.prototype._setValue_array_setNeedsUpdate,he.prototype._setValue_array_setMatrixWorldNeedsUpdate],[he.prototype._setValue_arrayElement,he.prototype._setValue_arrayElement_setNeedsUpdate,he.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[he.prototype._setValue_fromArray,he.prototype._setValue_fromArray_setNeedsUpdate,he.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Q1=new Float32Array(1);var vh=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,i){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,i)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,i){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=i,this}};function Qh(s,t,e,n){let i=jx(n);switch(e){case Bh:return s*t;case Gh:return s*t/i.components*i.byteLength;case Wa:return s*t/i.components*i.byteLength;case Pi:return s*t*2/i.components*i.byteLength;case Xa:return s*t*2/i.components*i.byteLength;case zh:return s*t*3/i.components*i.byteLength;case In:return s*t*4/i.components*i.byteLength;case qa:return s*t*4/i.components*i.byteLength;case Er:case Tr:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*8;case Cr:case Rr:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*16;case Ya:case Za:return Math.max(s,16)*Math.max(t,8)/4;case $a:case Ka:return Math.max(s,8)*Math.max(t,8)/2;case Ja:case ja:case tl:case el:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*8;case Qa:case Ir:case nl:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*16;case il:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*16;case sl:return Math.floor((s+4)/5)*Math.floor((t+3)/4)*16;case rl:return Math.floor((s+4)/5)*Math.floor((t+4)/5)*16;case ol:return Math.floor((s+5)/6)*Math.floor((t+4)/5)*16;case al:return Math.floor((s+5)/6)*Math.floor((t+5)/6)*16;case ll:return Math.floor((s+7)/8)*Math.floor((t+4)/5)*16;case cl:return Math.floor((s+7)/8)*Math.floor((t+5)/6)*16;case hl:return Math.floor((s+7)/8)*Math.floor((t+7)/8)*16;case ul:return Math.floor((s+9)/10)*Math.floor((t+4)/5)*16;case dl:return Math.floor((s+9)/10)*Math.floor((t+5)/6)*16;case fl:return Math.floor((s+9)/10)*Math.floor((t+7)/8)*16;case pl:return Math.floor((s+9)/10)*Math.floor((t+9)/10)*16;case ml:return Math.floor((s+11)/12)*Math.floor((t+9)/10)*16;case gl:return Math.floor((s+11)/12)*Math.floor((t+11)/12)*16;case xl:case yl:case vl:return Math.ceil(s/4)*Math.ceil(t/4)*16;case _l:case Ml:return Math.ceil(s/4)*Math.ceil(t/4)*8;case Pr:case bl:return Math.ceil(s/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function jx(s){switch(s){case ln:case Oh:return{byteLength:1,components:1};case Bs:case Fh:case Rn:return{byteLength:2,components:1};case Va:case Ha:return{byteLength:2,components:4};case Tn:case Ga:case Cn:return{byteLength:4,components:1};case Uh:case kh:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${s}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Nt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Xp(){let s=null,t=!1,e=null,n=null;function i(r,o){n=s.requestAnimationFrame(i),e(r,o)}return{start:function(){t!==!0&&e!==null&&s!==null&&(n=s.requestAnimationFrame(i),t=!0)},stop:function(){s!==null&&s.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){s=r}}}function ty(s){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,d=c.byteLength,u=s.createBuffer();s.bindBuffer(l,u),s.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=s.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=s.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=s.HALF_FLOAT:f=s.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=s.SHORT;else if(c instanceof Uint32Array)f=s.UNSIGNED_INT;else if(c instanceof Int32Array)f=s.INT;else if(c instanceof Int8Array)f=s.BYTE;else if(c instanceof Uint8Array)f=s.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=s.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,l,c){let h=l.array,d=l.updateRanges;if(s.bindBuffer(c,a),d.length===0)s.bufferSubData(c,0,h);else{d.sort((f,p)=>f.start-p.start);let u=0;for(let f=1;f<d.length;f++){let p=d[u],x=d[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++u,d[u]=x)}d.length=u+1;for(let f=0,p=d.length;f<p;f++){let x=d[f];s.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function i(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(s.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:i,remove:r,update:o}}var ey=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ny=`#ifdef USE_ALPHAHASH
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
#endif`,iy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,sy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ry=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,oy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ay=`#ifdef USE_AOMAP
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
#endif`,ly=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,cy=`#ifdef USE_BATCHING
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
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,hy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,uy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,dy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,fy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,py=`#ifdef USE_IRIDESCENCE
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
#endif`,my=`#ifdef USE_BUMPMAP
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
#endif`,gy=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,xy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,yy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,vy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,_y=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,My=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,by=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,wy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Sy=`#define PI 3.141592653589793
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
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
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
} // validated`,Ay=`vec3 transformedNormal = objectNormal;
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
#endif`,Ey=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ty=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Cy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Ry=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Iy="gl_FragColor = linearToOutputTexel( gl_FragColor );",Py=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Ly=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Ny=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Dy=`#ifdef USE_ENVMAP
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
#endif`,Oy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Fy=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Uy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,ky=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,By=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,zy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Gy=`#ifdef USE_GRADIENTMAP
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
}`,Vy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Hy=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Wy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Xy=`uniform bool receiveShadow;
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
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
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
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
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
#endif
#include <lightprobes_pars_fragment>`,qy=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,$y=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Yy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Ky=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Zy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Jy=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
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
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
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
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
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
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
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
#endif`,jy=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
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
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
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
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
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
		return 0.5 / max( gv + gl, EPSILON );
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
		float roughness = max( material.clearcoatRoughness, 0.045 );
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
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
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
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
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
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
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
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
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
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
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
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Qy=`
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
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
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
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
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
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,tv=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,ev=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,nv=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,iv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,sv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,rv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ov=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,av=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,lv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,cv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,hv=`#if defined( USE_POINTS_UV )
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
#endif`,uv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,dv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,fv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,pv=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,mv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,gv=`#ifdef USE_MORPHTARGETS
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
#endif`,xv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,yv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
	#ifdef DOUBLE_SIDED
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
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,vv=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,_v=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Mv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,bv=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,wv=`#ifdef USE_NORMALMAP
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
#endif`,Sv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Av=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Ev=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Tv=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Cv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Rv=`vec3 packNormalToRGB( const in vec3 normal ) {
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
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Iv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Pv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Lv=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Nv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Dv=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Ov=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Fv=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
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
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Uv=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
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
#endif`,kv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
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
#endif`,Bv=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
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
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
}`,zv=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Gv=`#ifdef USE_SKINNING
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
#endif`,Vv=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Hv=`#ifdef USE_SKINNING
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
#endif`,Wv=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Xv=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,qv=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,$v=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Yv=`#ifdef USE_TRANSMISSION
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
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Kv=`#ifdef USE_TRANSMISSION
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
#endif`,Zv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,Jv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,jv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
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
#endif`,Qv=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,t_=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,e_=`uniform sampler2D t2D;
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
}`,n_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,i_=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,s_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,r_=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,o_=`#include <common>
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
}`,a_=`#if DEPTH_PACKING == 3200
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
}`,l_=`#define DISTANCE
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
}`,c_=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,h_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,u_=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,d_=`uniform float scale;
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
}`,f_=`uniform vec3 diffuse;
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
}`,p_=`#include <common>
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
}`,m_=`uniform vec3 diffuse;
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
}`,g_=`#define LAMBERT
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
}`,x_=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,y_=`#define MATCAP
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
}`,v_=`#define MATCAP
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
}`,__=`#define NORMAL
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
}`,M_=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
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
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,b_=`#define PHONG
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
}`,w_=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,S_=`#define STANDARD
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
}`,A_=`#define STANDARD
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
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
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
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
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
}`,E_=`#define TOON
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
}`,T_=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
}`,C_=`uniform float size;
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
}`,R_=`uniform vec3 diffuse;
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
}`,I_=`#include <common>
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
}`,P_=`uniform vec3 color;
uniform float opacity;
#include <common>
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
	#include <premultiplied_alpha_fragment>
}`,L_=`uniform float rotation;
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
}`,N_=`uniform vec3 diffuse;
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
}`,Gt={alphahash_fragment:ey,alphahash_pars_fragment:ny,alphamap_fragment:iy,alphamap_pars_fragment:sy,alphatest_fragment:ry,alphatest_pars_fragment:oy,aomap_fragment:ay,aomap_pars_fragment:ly,batching_pars_vertex:cy,batching_vertex:hy,begin_vertex:uy,beginnormal_vertex:dy,bsdfs:fy,iridescence_fragment:py,bumpmap_pars_fragment:my,clipping_planes_fragment:gy,clipping_planes_pars_fragment:xy,clipping_planes_pars_vertex:yy,clipping_planes_vertex:vy,color_fragment:_y,color_pars_fragment:My,color_pars_vertex:by,color_vertex:wy,common:Sy,defaultnormal_vertex:Ay,displacementmap_pars_vertex:Ey,displacementmap_vertex:Ty,emissivemap_fragment:Cy,emissivemap_pars_fragment:Ry,colorspace_fragment:Iy,colorspace_pars_fragment:Py,envmap_fragment:Ly,envmap_common_pars_fragment:Ny,envmap_pars_fragment:Dy,envmap_pars_vertex:Oy,envmap_physical_pars_fragment:qy,envmap_vertex:Fy,fog_vertex:Uy,fog_pars_vertex:ky,fog_fragment:By,fog_pars_fragment:zy,gradientmap_pars_fragment:Gy,lightmap_pars_fragment:Vy,lights_lambert_fragment:Hy,lights_lambert_pars_fragment:Wy,lights_pars_begin:Xy,lights_toon_fragment:$y,lights_toon_pars_fragment:Yy,lights_phong_fragment:Ky,lights_phong_pars_fragment:Zy,lights_physical_fragment:Jy,lights_physical_pars_fragment:jy,lights_fragment_begin:Qy,lights_fragment_maps:tv,lights_fragment_end:ev,lightprobes_pars_fragment:nv,logdepthbuf_fragment:iv,logdepthbuf_pars_fragment:sv,logdepthbuf_pars_vertex:rv,logdepthbuf_vertex:ov,map_fragment:av,map_pars_fragment:lv,map_particle_fragment:cv,map_particle_pars_fragment:hv,metalnessmap_fragment:uv,metalnessmap_pars_fragment:dv,morphinstance_vertex:fv,morphcolor_vertex:pv,morphnormal_vertex:mv,morphtarget_pars_vertex:gv,morphtarget_vertex:xv,normal_fragment_begin:yv,normal_fragment_maps:vv,normal_pars_fragment:_v,normal_pars_vertex:Mv,normal_vertex:bv,normalmap_pars_fragment:wv,clearcoat_normal_fragment_begin:Sv,clearcoat_normal_fragment_maps:Av,clearcoat_pars_fragment:Ev,iridescence_pars_fragment:Tv,opaque_fragment:Cv,packing:Rv,premultiplied_alpha_fragment:Iv,project_vertex:Pv,dithering_fragment:Lv,dithering_pars_fragment:Nv,roughnessmap_fragment:Dv,roughnessmap_pars_fragment:Ov,shadowmap_pars_fragment:Fv,shadowmap_pars_vertex:Uv,shadowmap_vertex:kv,shadowmask_pars_fragment:Bv,skinbase_vertex:zv,skinning_pars_vertex:Gv,skinning_vertex:Vv,skinnormal_vertex:Hv,specularmap_fragment:Wv,specularmap_pars_fragment:Xv,tonemapping_fragment:qv,tonemapping_pars_fragment:$v,transmission_fragment:Yv,transmission_pars_fragment:Kv,uv_pars_fragment:Zv,uv_pars_vertex:Jv,uv_vertex:jv,worldpos_vertex:Qv,background_vert:t_,background_frag:e_,backgroundCube_vert:n_,backgroundCube_frag:i_,cube_vert:s_,cube_frag:r_,depth_vert:o_,depth_frag:a_,distance_vert:l_,distance_frag:c_,equirect_vert:h_,equirect_frag:u_,linedashed_vert:d_,linedashed_frag:f_,meshbasic_vert:p_,meshbasic_frag:m_,meshlambert_vert:g_,meshlambert_frag:x_,meshmatcap_vert:y_,meshmatcap_frag:v_,meshnormal_vert:__,meshnormal_frag:M_,meshphong_vert:b_,meshphong_frag:w_,meshphysical_vert:S_,meshphysical_frag:A_,meshtoon_vert:E_,meshtoon_frag:T_,points_vert:C_,points_frag:R_,shadow_vert:I_,shadow_frag:P_,sprite_vert:L_,sprite_frag:N_},gt={common:{diffuse:{value:new Zt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ft},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ft}},envmap:{envMap:{value:null},envMapRotation:{value:new Ft},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ft}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ft}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ft},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ft},normalScale:{value:new Jt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ft},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ft}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ft}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ft}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Zt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Zt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0},uvTransform:{value:new Ft}},sprite:{diffuse:{value:new Zt(16777215)},opacity:{value:1},center:{value:new Jt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ft},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0}}},Wn={basic:{uniforms:We([gt.common,gt.specularmap,gt.envmap,gt.aomap,gt.lightmap,gt.fog]),vertexShader:Gt.meshbasic_vert,fragmentShader:Gt.meshbasic_frag},lambert:{uniforms:We([gt.common,gt.specularmap,gt.envmap,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.fog,gt.lights,{emissive:{value:new Zt(0)},envMapIntensity:{value:1}}]),vertexShader:Gt.meshlambert_vert,fragmentShader:Gt.meshlambert_frag},phong:{uniforms:We([gt.common,gt.specularmap,gt.envmap,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.fog,gt.lights,{emissive:{value:new Zt(0)},specular:{value:new Zt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Gt.meshphong_vert,fragmentShader:Gt.meshphong_frag},standard:{uniforms:We([gt.common,gt.envmap,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.roughnessmap,gt.metalnessmap,gt.fog,gt.lights,{emissive:{value:new Zt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Gt.meshphysical_vert,fragmentShader:Gt.meshphysical_frag},toon:{uniforms:We([gt.common,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.gradientmap,gt.fog,gt.lights,{emissive:{value:new Zt(0)}}]),vertexShader:Gt.meshtoon_vert,fragmentShader:Gt.meshtoon_frag},matcap:{uniforms:We([gt.common,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.fog,{matcap:{value:null}}]),vertexShader:Gt.meshmatcap_vert,fragmentShader:Gt.meshmatcap_frag},points:{uniforms:We([gt.points,gt.fog]),vertexShader:Gt.points_vert,fragmentShader:Gt.points_frag},dashed:{uniforms:We([gt.common,gt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Gt.linedashed_vert,fragmentShader:Gt.linedashed_frag},depth:{uniforms:We([gt.common,gt.displacementmap]),vertexShader:Gt.depth_vert,fragmentShader:Gt.depth_frag},normal:{uniforms:We([gt.common,gt.bumpmap,gt.normalmap,gt.displacementmap,{opacity:{value:1}}]),vertexShader:Gt.meshnormal_vert,fragmentShader:Gt.meshnormal_frag},sprite:{uniforms:We([gt.sprite,gt.fog]),vertexShader:Gt.sprite_vert,fragmentShader:Gt.sprite_frag},background:{uniforms:{uvTransform:{value:new Ft},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Gt.background_vert,fragmentShader:Gt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ft}},vertexShader:Gt.backgroundCube_vert,fragmentShader:Gt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Gt.cube_vert,fragmentShader:Gt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Gt.equirect_vert,fragmentShader:Gt.equirect_frag},distance:{uniforms:We([gt.common,gt.displacementmap,{referencePosition:{value:new H},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Gt.distance_vert,fragmentShader:Gt.distance_frag},shadow:{uniforms:We([gt.lights,gt.fog,{color:{value:new Zt(0)},opacity:{value:1}}]),vertexShader:Gt.shadow_vert,fragmentShader:Gt.shadow_frag}};Wn.physical={uniforms:We([Wn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ft},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ft},clearcoatNormalScale:{value:new Jt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ft},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ft},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ft},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ft},sheen:{value:0},sheenColor:{value:new Zt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ft},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ft},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ft},transmissionSamplerSize:{value:new Jt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ft},attenuationDistance:{value:0},attenuationColor:{value:new Zt(0)},specularColor:{value:new Zt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ft},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ft},anisotropyVector:{value:new Jt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ft}}]),vertexShader:Gt.meshphysical_vert,fragmentShader:Gt.meshphysical_frag};var wl={r:0,b:0,g:0},D_=new _e,qp=new Ft;qp.set(-1,0,0,0,1,0,0,0,1);function O_(s,t,e,n,i,r){let o=new Zt(0),a=i===!0?0:1,l,c,h=null,d=0,u=null;function f(M){let A=M.isScene===!0?M.background:null;if(A&&A.isTexture){let b=M.backgroundBlurriness>0;A=t.get(A,b)}return A}function p(M){let A=!1,b=f(M);b===null?m(o,a):b&&b.isColor&&(m(b,1),A=!0);let T=s.xr.getEnvironmentBlendMode();T==="additive"?e.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(s.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),s.clear(s.autoClearColor,s.autoClearDepth,s.autoClearStencil))}function x(M,A){let b=f(A);b&&b.isCubeTexture?(c===void 0&&(c=new gn(new Ds(1,1,1),new xn({name:"BackgroundCubeMaterial",uniforms:ji(Wn.backgroundCube.uniforms),vertexShader:Wn.backgroundCube.vertexShader,fragmentShader:Wn.backgroundCube.fragmentShader,side:Je,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,E,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(D_.makeRotationFromEuler(A.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(qp),c.material.toneMapped=Ht.getTransfer(b.colorSpace)!==te,(h!==b||d!==b.version||u!==s.toneMapping)&&(c.material.needsUpdate=!0,h=b,d=b.version,u=s.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new gn(new Mr(2,2),new xn({name:"BackgroundMaterial",uniforms:ji(Wn.background.uniforms),vertexShader:Wn.background.vertexShader,fragmentShader:Wn.background.fragmentShader,side:Ii,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=Ht.getTransfer(b.colorSpace)!==te,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||d!==b.version||u!==s.toneMapping)&&(l.material.needsUpdate=!0,h=b,d=b.version,u=s.toneMapping),l.layers.enableAll(),M.unshift(l,l.geometry,l.material,0,0,null))}function m(M,A){M.getRGB(wl,Zh(s)),e.buffers.color.setClear(wl.r,wl.g,wl.b,A,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(M,A=1){o.set(M),a=A,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(M){a=M,m(o,a)},render:p,addToRenderList:x,dispose:g}}function F_(s,t){let e=s.getParameter(s.MAX_VERTEX_ATTRIBS),n={},i=u(null),r=i,o=!1;function a(L,F,W,I,z){let q=!1,G=d(L,I,W,F);r!==G&&(r=G,c(r.object)),q=f(L,I,W,z),q&&p(L,I,W,z),z!==null&&t.update(z,s.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,b(L,F,W,I),z!==null&&s.bindBuffer(s.ELEMENT_ARRAY_BUFFER,t.get(z).buffer))}function l(){return s.createVertexArray()}function c(L){return s.bindVertexArray(L)}function h(L){return s.deleteVertexArray(L)}function d(L,F,W,I){let z=I.wireframe===!0,q=n[F.id];q===void 0&&(q={},n[F.id]=q);let G=L.isInstancedMesh===!0?L.id:0,tt=q[G];tt===void 0&&(tt={},q[G]=tt);let X=tt[W.id];X===void 0&&(X={},tt[W.id]=X);let Q=X[z];return Q===void 0&&(Q=u(l()),X[z]=Q),Q}function u(L){let F=[],W=[],I=[];for(let z=0;z<e;z++)F[z]=0,W[z]=0,I[z]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:W,attributeDivisors:I,object:L,attributes:{},index:null}}function f(L,F,W,I){let z=r.attributes,q=F.attributes,G=0,tt=W.getAttributes();for(let X in tt)if(tt[X].location>=0){let et=z[X],Mt=q[X];if(Mt===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(Mt=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(Mt=L.instanceColor)),et===void 0||et.attribute!==Mt||Mt&&et.data!==Mt.data)return!0;G++}return r.attributesNum!==G||r.index!==I}function p(L,F,W,I){let z={},q=F.attributes,G=0,tt=W.getAttributes();for(let X in tt)if(tt[X].location>=0){let et=q[X];et===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(et=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(et=L.instanceColor));let Mt={};Mt.attribute=et,et&&et.data&&(Mt.data=et.data),z[X]=Mt,G++}r.attributes=z,r.attributesNum=G,r.index=I}function x(){let L=r.newAttributes;for(let F=0,W=L.length;F<W;F++)L[F]=0}function m(L){g(L,0)}function g(L,F){let W=r.newAttributes,I=r.enabledAttributes,z=r.attributeDivisors;W[L]=1,I[L]===0&&(s.enableVertexAttribArray(L),I[L]=1),z[L]!==F&&(s.vertexAttribDivisor(L,F),z[L]=F)}function M(){let L=r.newAttributes,F=r.enabledAttributes;for(let W=0,I=F.length;W<I;W++)F[W]!==L[W]&&(s.disableVertexAttribArray(W),F[W]=0)}function A(L,F,W,I,z,q,G){G===!0?s.vertexAttribIPointer(L,F,W,z,q):s.vertexAttribPointer(L,F,W,I,z,q)}function b(L,F,W,I){x();let z=I.attributes,q=W.getAttributes(),G=F.defaultAttributeValues;for(let tt in q){let X=q[tt];if(X.location>=0){let Q=z[tt];if(Q===void 0&&(tt==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),tt==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let et=Q.normalized,Mt=Q.itemSize,Dt=t.get(Q);if(Dt===void 0)continue;let K=Dt.buffer,pt=Dt.type,_t=Dt.bytesPerElement,At=pt===s.INT||pt===s.UNSIGNED_INT||Q.gpuType===Ga;if(Q.isInterleavedBufferAttribute){let ht=Q.data,It=ht.isInterleavedBuffer===!0?ht.stride:ht.itemSize,oe=Q.offset;if(ht.isInstancedInterleavedBuffer||ht.isInstancedBufferAttribute){for(let Ct=0;Ct<X.locationSize;Ct++)g(X.location+Ct,ht.meshPerAttribute);L.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ht.meshPerAttribute*ht.count)}else for(let Ct=0;Ct<X.locationSize;Ct++)m(X.location+Ct);s.bindBuffer(s.ARRAY_BUFFER,K);for(let Ct=0;Ct<X.locationSize;Ct++)A(X.location+Ct,Mt/X.locationSize,pt,et,It*_t,(oe+Mt/X.locationSize*Ct)*_t,At)}else{if(Q.isInstancedBufferAttribute){for(let ht=0;ht<X.locationSize;ht++)g(X.location+ht,Q.meshPerAttribute);L.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let ht=0;ht<X.locationSize;ht++)m(X.location+ht);s.bindBuffer(s.ARRAY_BUFFER,K);for(let ht=0;ht<X.locationSize;ht++)A(X.location+ht,Mt/X.locationSize,pt,et,Mt*_t,Mt/X.locationSize*ht*_t,At)}}else if(G!==void 0){let et=G[tt];if(et!==void 0)switch(et.length){case 2:s.vertexAttrib2fv(X.location,et);break;case 3:s.vertexAttrib3fv(X.location,et);break;case 4:s.vertexAttrib4fv(X.location,et);break;default:s.vertexAttrib1fv(X.location,et)}}}}M()}function T(){D();for(let L in n){let F=n[L];for(let W in F){let I=F[W];for(let z in I){let q=I[z];for(let G in q)h(q[G].object),delete q[G];delete I[z]}}delete n[L]}}function E(L){if(n[L.id]===void 0)return;let F=n[L.id];for(let W in F){let I=F[W];for(let z in I){let q=I[z];for(let G in q)h(q[G].object),delete q[G];delete I[z]}}delete n[L.id]}function y(L){for(let F in n){let W=n[F];for(let I in W){let z=W[I];if(z[L.id]===void 0)continue;let q=z[L.id];for(let G in q)h(q[G].object),delete q[G];delete z[L.id]}}}function w(L){for(let F in n){let W=n[F],I=L.isInstancedMesh===!0?L.id:0,z=W[I];if(z!==void 0){for(let q in z){let G=z[q];for(let tt in G)h(G[tt].object),delete G[tt];delete z[q]}delete W[I],Object.keys(W).length===0&&delete n[F]}}}function D(){C(),o=!0,r!==i&&(r=i,c(r.object))}function C(){i.geometry=null,i.program=null,i.wireframe=!1}return{setup:a,reset:D,resetDefaultState:C,dispose:T,releaseStatesOfGeometry:E,releaseStatesOfObject:w,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:m,disableUnusedAttributes:M}}function U_(s,t,e){let n;function i(l){n=l}function r(l,c){s.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(s.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let f=0;f<h;f++)u+=c[f];e.update(u,n,1)}this.setMode=i,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function k_(s,t,e,n){let i;function r(){if(i!==void 0)return i;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");i=s.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else i=0;return i}function o(y){return!(y!==In&&n.convert(y)!==s.getParameter(s.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let w=y===Rn&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==ln&&y!==Cn&&!w&&n.convert(y)!==s.getParameter(s.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(s.getShaderPrecisionFormat(s.VERTEX_SHADER,s.HIGH_FLOAT).precision>0&&s.getShaderPrecisionFormat(s.FRAGMENT_SHADER,s.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&s.getShaderPrecisionFormat(s.VERTEX_SHADER,s.MEDIUM_FLOAT).precision>0&&s.getShaderPrecisionFormat(s.FRAGMENT_SHADER,s.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Nt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&Nt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&Nt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=s.getParameter(s.MAX_TEXTURE_IMAGE_UNITS),p=s.getParameter(s.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=s.getParameter(s.MAX_TEXTURE_SIZE),m=s.getParameter(s.MAX_CUBE_MAP_TEXTURE_SIZE),g=s.getParameter(s.MAX_VERTEX_ATTRIBS),M=s.getParameter(s.MAX_VERTEX_UNIFORM_VECTORS),A=s.getParameter(s.MAX_VARYING_VECTORS),b=s.getParameter(s.MAX_FRAGMENT_UNIFORM_VECTORS),T=s.getParameter(s.MAX_SAMPLES),E=s.getParameter(s.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:M,maxVaryings:A,maxFragmentUniforms:b,maxSamples:T,samples:E}}function B_(s){let t=this,e=null,n=0,i=!1,r=!1,o=new An,a=new Ft,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||n!==0||i;return i=u,n=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=h(d,u,0)},this.setState=function(d,u,f){let p=d.clippingPlanes,x=d.clipIntersection,m=d.clipShadows,g=s.get(d);if(!i||p===null||p.length===0||r&&!m)r?h(null):c();else{let M=r?0:n,A=M*4,b=g.clippingState||null;l.value=b,b=h(p,u,A,f);for(let T=0;T!==A;++T)b[T]=e[T];g.clippingState=b,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(d,u,f,p){let x=d!==null?d.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=f+x*4,M=u.matrixWorldInverse;a.getNormalMatrix(M),(m===null||m.length<g)&&(m=new Float32Array(g));for(let A=0,b=f;A!==x;++A,b+=4)o.copy(d[A]).applyMatrix4(M,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}var Or=class extends on{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},i=[n,n,n,n,n,n];this.texture=new yr(i),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},i=new Ds(5,5,5),r=new xn({name:"CubemapFromEquirect",uniforms:ji(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Je,blending:Yi});r.uniforms.tEquirect.value=e;let o=new gn(i,r),a=e.minFilter;return e.minFilter===En&&(e.minFilter=Ne),new Os(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,i=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,i);t.setRenderTarget(r)}},Sp=256,z_=3,G_=20,$p=256,Yp=16,V_=3,H_=new H,W_=new Zt,Al=class s{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Os(1,10,null),this._boxMesh=new gn(new Ds(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,i=100,r={}){let{size:o=256,position:a=H_}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(W_));let m=new Os(n,i,h);return m.position.copy(a),m.update(l,t),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=f,l.autoClearStencil=p,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Tp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Ep(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Sp,vp(t))}_fromTexture(t,e){t.mapping===Zi||t.mapping===ks?this._setSize(t.image.length===0?Sp:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=Ap(t,!1,!1),n=Math.log2(t)-z_;for(let i=0;i<=n;i++)e.texture.mipmaps.push({width:t>>i,height:t>>i});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Ap(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let i=this._boxMesh,r=this._cubeCamera;i.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,i),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Zi||t.mapping===ks?(this._cubemapMaterial===null&&(this._cubemapMaterial=Tp()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Ep()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=X_(),this._integrationMaterial=q_());let e=this._cubeSize,n=t.texture.mipmaps.length-1,i=this._ggxMaterial.uniforms;i.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Yp);for(let o=0;o<=n;o++){let a=s.lodToRoughness(o,n);if(o>n-V_)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/($p*Math.pow(a,4)))+.5:0;i.roughness.value=a,i.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=$_());let n=this._blurMaterial,i=n.uniforms,r=this._sourceTarget;i.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,i.envMap.value=r.texture,this._renderCube(t,0,n),i.envMap.value=t.texture,this._renderCube(r,0,n)}};function Ap(s,t,e){return new Or(s,{minFilter:En,generateMipmaps:t,type:Rn,colorSpace:Wi,depthBuffer:e})}function Fr(s,t,e){return new xn({name:s,uniforms:t,vertexShader:Gt.cube_vert,fragmentShader:e,side:Je,blending:Yi,depthTest:!1,depthWrite:!1})}function X_(){return Fr("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${$p}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function q_(){return Fr("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Yp}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function $_(){return Fr("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${G_}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Ep(){return Fr("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Tp(){return Fr("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Y_(s){let t=new WeakMap,e=new WeakMap,n=null;function i(u,f=!1){return u==null?null:f?o(u):r(u)}function r(u){if(u&&u.isTexture){let f=u.mapping;if(f===ka||f===Ba)if(t.has(u)){let p=t.get(u).texture;return a(p,u.mapping)}else{let p=u.image;if(p&&p.height>0){let x=new Or(p.height);return x.fromEquirectangularTexture(s,u),t.set(u,x),u.addEventListener("dispose",c),a(x.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,p=f===ka||f===Ba,x=f===Zi||f===ks;if(p||x){let m=e.get(u),g=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==g)return n===null&&(n=new Al(s)),m=p?n.fromEquirectangular(u,m):n.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),m.texture;if(m!==void 0)return m.texture;{let M=u.image;return p&&M&&M.height>0||x&&M&&l(M)?(n===null&&(n=new Al(s)),m=p?n.fromEquirectangular(u):n.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function a(u,f){return f===ka?u.mapping=Zi:f===Ba&&(u.mapping=ks),u}function l(u){let f=0,p=6;for(let x=0;x<p;x++)u[x]!==void 0&&f++;return f===p}function c(u){let f=u.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(u){let f=u.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function d(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:i,dispose:d}}function K_(s){let t={};function e(n){if(t[n]!==void 0)return t[n];let i=s.getExtension(n);return t[n]=i,i}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let i=e(n);return i===null&&lr("WebGLRenderer: "+n+" extension not supported."),i}}}function Z_(s,t,e,n){let i={},r=new WeakMap,o=new FinalizationRegistry(p=>delete i[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete i[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,x){return i[x.id]!==void 0||(x.addEventListener("dispose",a),i[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(p){let x=p.attributes;for(let m in x)t.update(x[m],s.ARRAY_BUFFER)}function d(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let M=x!==null?x.array.length:m.array.length/3-1,A=m.count>=65535?xr:gr,b=new A(Math.ceil(M/3)*6,1),T=b.array;if(x!==null){let y=x.array;g=x.version;for(let w=0,D=0;w<M;w+=3){let C=y[w+0],L=y[w+1],F=y[w+2];T[D++]=C,T[D++]=L,T[D++]=L,T[D++]=F,T[D++]=F,T[D++]=C}}else{g=m.version;for(let y=0,w=0;y<M;y+=3){let D=y+0,C=y+1,L=y+2;T[w++]=D,T[w++]=C,T[w++]=C,T[w++]=L,T[w++]=L,T[w++]=D}}b.version=g;let E=r.get(p);E&&t.remove(E),r.set(p,b)}function u(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&d(p)}else d(p);return r.get(p)}function f(){for(let p in i){let x=i[p].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:u,dispose:f}}function J_(s,t,e){let n;function i(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,u){s.drawElements(n,u,r,d*o),e.update(u,n,1)}function c(d,u,f){f!==0&&(s.drawElementsInstanced(n,u,r,d*o,f),e.update(u,n,f))}function h(d,u,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,d,0,f);let x=0;for(let m=0;m<f;m++)x+=u[m];e.update(x,n,1)}this.setMode=i,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function j_(s){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case s.TRIANGLES:e.triangles+=a*(r/3);break;case s.LINES:e.lines+=a*(r/2);break;case s.LINE_STRIP:e.lines+=a*(r-1);break;case s.LINE_LOOP:e.lines+=a*r;break;case s.POINTS:e.points+=a*r;break;default:Ot("WebGLInfo: Unknown draw mode:",o);break}}function i(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:i,update:n}}function Q_(s,t,e){let n=new WeakMap,i=new ye;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(a);if(u===void 0||u.count!==d){let D=function(){y.dispose(),n.delete(a),a.removeEventListener("dispose",D)};u!==void 0&&u.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],M=a.morphAttributes.color||[],A=0;f===!0&&(A=1),p===!0&&(A=2),x===!0&&(A=3);let b=a.attributes.position.count*A,T=1;b>t.maxTextureSize&&(T=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let E=new Float32Array(b*T*4*d),y=new fr(E,b,T,d);y.type=Cn,y.needsUpdate=!0;let w=A*4;for(let C=0;C<d;C++){let L=m[C],F=g[C],W=M[C],I=b*T*4*C;for(let z=0;z<L.count;z++){let q=z*w;f===!0&&(i.fromBufferAttribute(L,z),E[I+q+0]=i.x,E[I+q+1]=i.y,E[I+q+2]=i.z,E[I+q+3]=0),p===!0&&(i.fromBufferAttribute(F,z),E[I+q+4]=i.x,E[I+q+5]=i.y,E[I+q+6]=i.z,E[I+q+7]=0),x===!0&&(i.fromBufferAttribute(W,z),E[I+q+8]=i.x,E[I+q+9]=i.y,E[I+q+10]=i.z,E[I+q+11]=W.itemSize===4?i.w:1)}}u={count:d,texture:y,size:new Jt(b,T)},n.set(a,u),a.addEventListener("dispose",D)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(s,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(s,"morphTargetBaseInfluence",p),l.getUniforms().setValue(s,"morphTargetInfluences",c)}l.getUniforms().setValue(s,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(s,"morphTargetsTextureSize",u.size)}return{update:r}}function tM(s,t,e,n,i){let r=new WeakMap;function o(c){let h=i.render.frame,d=c.geometry,u=t.get(c,d);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,s.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,s.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return u}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var eM={[Th]:"LINEAR_TONE_MAPPING",[Ch]:"REINHARD_TONE_MAPPING",[Rh]:"CINEON_TONE_MAPPING",[Ih]:"ACES_FILMIC_TONE_MAPPING",[Lh]:"AGX_TONE_MAPPING",[Nh]:"NEUTRAL_TONE_MAPPING",[Ph]:"CUSTOM_TONE_MAPPING"};function nM(s,t,e,n,i,r){let o=new on(t,e,{type:s,depthBuffer:i,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Gn;h.setAttribute("position",new pn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new pn([0,2,0,0,2,0],2));let d=new wa({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new gn(h,d),f=new Fa(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,M=null,A=[],b=!1;this.setSize=function(T,E){o.setSize(T,E),a!==null&&a.setSize(T,E),l!==null&&l.setSize(T,E);for(let y=0;y<A.length;y++){let w=A[y];w.setSize&&w.setSize(T,E)}},this.setEffects=function(T){A=T,b=A.length>0&&A[0].isRenderPass===!0;let E=o.width,y=o.height;A.length>0&&a===null&&(a=new on(E,y,{type:Rn,depthBuffer:!1,stencilBuffer:!1}),l=new on(E,y,{type:Rn,depthBuffer:!1,stencilBuffer:!1}));let w=i===!0&&A.some(D=>D.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new oi(E,y),r===!0&&(c.format=ai,c.type=Ji)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let D=0;D<A.length;D++){let C=A[D];C.setSize&&C.setSize(E,y),w&&C.needsDepthTexture===!0&&C.setDepthTexture&&C.setDepthTexture(c)}},this.begin=function(T,E){if(m||T.toneMapping===Vn&&A.length===0)return!1;if(M=E,E!==null){let y=E.width,w=E.height;(o.width!==y||o.height!==w)&&this.setSize(y,w)}return b===!1&&T.setRenderTarget(o),g=T.toneMapping,T.toneMapping=Vn,!0},this.hasRenderPass=function(){return b},this.end=function(T,E){T.toneMapping=g,m=!0;let y=o,w=a;for(let D=0;D<A.length;D++){let C=A[D];C.enabled!==!1&&(C.render(T,w,y,E),C.needsSwap!==!1&&(y=w,w=w===a?l:a))}if(p!==T.outputColorSpace||x!==T.toneMapping){p=T.outputColorSpace,x=T.toneMapping,d.defines={},Ht.getTransfer(p)===te&&(d.defines.SRGB_TRANSFER="");let D=eM[x];D&&(d.defines[D]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=y.texture,T.setRenderTarget(M),T.render(u,f),M=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var Kp=new Qe,Zp=new oi(1,1),Jp=new vr(1),jp=new fr,Qp=new va,tm=new yr,Cp=[],Rp=[],Ip=new Float32Array(16),Pp=new Float32Array(9),Lp=new Float32Array(4);function Gs(s,t,e){let n=s[0];if(n<=0||n>0)return s;let i=t*e,r=Cp[i];if(r===void 0&&(r=new Float32Array(i),Cp[i]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,s[o].toArray(r,a)}return r}function Te(s,t){if(s.length!==t.length)return!1;for(let e=0,n=s.length;e<n;e++)if(s[e]!==t[e])return!1;return!0}function Ce(s,t){for(let e=0,n=t.length;e<n;e++)s[e]=t[e]}function Tl(s,t){let e=Rp[t];e===void 0&&(e=new Int32Array(t),Rp[t]=e);for(let n=0;n!==t;++n)e[n]=s.allocateTextureUnit();return e}function iM(s,t){let e=this.cache;e[0]!==t&&(s.uniform1f(this.addr,t),e[0]=t)}function sM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(s.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Te(e,t))return;s.uniform2fv(this.addr,t),Ce(e,t)}}function rM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(s.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(s.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Te(e,t))return;s.uniform3fv(this.addr,t),Ce(e,t)}}function oM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(s.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Te(e,t))return;s.uniform4fv(this.addr,t),Ce(e,t)}}function aM(s,t){let e=this.cache,n=t.elements;if(n===void 0){if(Te(e,t))return;s.uniformMatrix2fv(this.addr,!1,t),Ce(e,t)}else{if(Te(e,n))return;Lp.set(n),s.uniformMatrix2fv(this.addr,!1,Lp),Ce(e,n)}}function lM(s,t){let e=this.cache,n=t.elements;if(n===void 0){if(Te(e,t))return;s.uniformMatrix3fv(this.addr,!1,t),Ce(e,t)}else{if(Te(e,n))return;Pp.set(n),s.uniformMatrix3fv(this.addr,!1,Pp),Ce(e,n)}}function cM(s,t){let e=this.cache,n=t.elements;if(n===void 0){if(Te(e,t))return;s.uniformMatrix4fv(this.addr,!1,t),Ce(e,t)}else{if(Te(e,n))return;Ip.set(n),s.uniformMatrix4fv(this.addr,!1,Ip),Ce(e,n)}}function hM(s,t){let e=this.cache;e[0]!==t&&(s.uniform1i(this.addr,t),e[0]=t)}function uM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(s.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Te(e,t))return;s.uniform2iv(this.addr,t),Ce(e,t)}}function dM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(s.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Te(e,t))return;s.uniform3iv(this.addr,t),Ce(e,t)}}function fM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(s.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Te(e,t))return;s.uniform4iv(this.addr,t),Ce(e,t)}}function pM(s,t){let e=this.cache;e[0]!==t&&(s.uniform1ui(this.addr,t),e[0]=t)}function mM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(s.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Te(e,t))return;s.uniform2uiv(this.addr,t),Ce(e,t)}}function gM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(s.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Te(e,t))return;s.uniform3uiv(this.addr,t),Ce(e,t)}}function xM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(s.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Te(e,t))return;s.uniform4uiv(this.addr,t),Ce(e,t)}}function Cl(s){return s.version===0&&(s.compareFunction=Xh,s.needsUpdate=!0),s}function yM(s,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(s.uniform1i(this.addr,i),n[0]=i);let r;this.type===s.SAMPLER_2D_SHADOW?r=Cl(Zp):r=Kp,e.setTexture2D(t||r,i)}function vM(s,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(s.uniform1i(this.addr,i),n[0]=i),e.setTexture3D(t||Qp,i)}function _M(s,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(s.uniform1i(this.addr,i),n[0]=i);let r;this.type===s.SAMPLER_CUBE_SHADOW?r=Cl(Jp):r=tm,e.setTextureCube(t||r,i)}function MM(s,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(s.uniform1i(this.addr,i),n[0]=i),e.setTexture2DArray(t||jp,i)}function bM(s){switch(s){case 5126:return iM;case 35664:return sM;case 35665:return rM;case 35666:return oM;case 35674:return aM;case 35675:return lM;case 35676:return cM;case 5124:case 35670:return hM;case 35667:case 35671:return uM;case 35668:case 35672:return dM;case 35669:case 35673:return fM;case 5125:return pM;case 36294:return mM;case 36295:return gM;case 36296:return xM;case 35678:case 36198:case 36298:case 36306:case 35682:return yM;case 35679:case 36299:case 36307:return vM;case 35680:case 36300:case 36308:case 36293:return _M;case 36289:case 36303:case 36311:case 36292:return MM}}function wM(s,t){s.uniform1fv(this.addr,t)}function SM(s,t){let e=Gs(t,this.size,2);s.uniform2fv(this.addr,e)}function AM(s,t){let e=Gs(t,this.size,3);s.uniform3fv(this.addr,e)}function EM(s,t){let e=Gs(t,this.size,4);s.uniform4fv(this.addr,e)}function TM(s,t){let e=Gs(t,this.size,4);s.uniformMatrix2fv(this.addr,!1,e)}function CM(s,t){let e=Gs(t,this.size,9);s.uniformMatrix3fv(this.addr,!1,e)}function RM(s,t){let e=Gs(t,this.size,16);s.uniformMatrix4fv(this.addr,!1,e)}function IM(s,t){s.uniform1iv(this.addr,t)}function PM(s,t){s.uniform2iv(this.addr,t)}function LM(s,t){s.uniform3iv(this.addr,t)}function NM(s,t){s.uniform4iv(this.addr,t)}function DM(s,t){s.uniform1uiv(this.addr,t)}function OM(s,t){s.uniform2uiv(this.addr,t)}function FM(s,t){s.uniform3uiv(this.addr,t)}function UM(s,t){s.uniform4uiv(this.addr,t)}function kM(s,t,e){let n=this.cache,i=t.length,r=Tl(e,i);Te(n,r)||(s.uniform1iv(this.addr,r),Ce(n,r));let o;this.type===s.SAMPLER_2D_SHADOW?o=Cl(Zp):o=Kp;for(let a=0;a!==i;++a)e.setTexture2D(t[a]||o,r[a])}function BM(s,t,e){let n=this.cache,i=t.length,r=Tl(e,i);Te(n,r)||(s.uniform1iv(this.addr,r),Ce(n,r));for(let o=0;o!==i;++o)e.setTexture3D(t[o]||Qp,r[o])}function zM(s,t,e){let n=this.cache,i=t.length,r=Tl(e,i);Te(n,r)||(s.uniform1iv(this.addr,r),Ce(n,r));let o;this.type===s.SAMPLER_CUBE_SHADOW?o=Cl(Jp):o=tm;for(let a=0;a!==i;++a)e.setTextureCube(t[a]||o,r[a])}function GM(s,t,e){let n=this.cache,i=t.length,r=Tl(e,i);Te(n,r)||(s.uniform1iv(this.addr,r),Ce(n,r));for(let o=0;o!==i;++o)e.setTexture2DArray(t[o]||jp,r[o])}function VM(s){switch(s){case 5126:return wM;case 35664:return SM;case 35665:return AM;case 35666:return EM;case 35674:return TM;case 35675:return CM;case 35676:return RM;case 5124:case 35670:return IM;case 35667:case 35671:return PM;case 35668:case 35672:return LM;case 35669:case 35673:return NM;case 5125:return DM;case 36294:return OM;case 36295:return FM;case 36296:return UM;case 35678:case 36198:case 36298:case 36306:case 35682:return kM;case 35679:case 36299:case 36307:return BM;case 35680:case 36300:case 36308:case 36293:return zM;case 36289:case 36303:case 36311:case 36292:return GM}}var nu=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=bM(e.type)}},iu=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=VM(e.type)}},su=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let i=this.seq;for(let r=0,o=i.length;r!==o;++r){let a=i[r];a.setValue(t,e[a.id],n)}}},tu=/(\w+)(\])?(\[|\.)?/g;function Np(s,t){s.seq.push(t),s.map[t.id]=t}function HM(s,t,e){let n=s.name,i=n.length;for(tu.lastIndex=0;;){let r=tu.exec(n),o=tu.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===i){Np(e,c===void 0?new nu(a,s,t):new iu(a,s,t));break}else{let d=e.map[a];d===void 0&&(d=new su(a),Np(e,d)),e=d}}}var zs=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);HM(a,l,this)}let i=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?i.push(o):r.push(o);i.length>0&&(this.seq=i.concat(r))}setValue(t,e,n,i){let r=this.map[e];r!==void 0&&r.setValue(t,n,i)}setOptional(t,e,n){let i=e[n];i!==void 0&&this.setValue(t,n,i)}static upload(t,e,n,i){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,i)}}static seqWithValue(t,e){let n=[];for(let i=0,r=t.length;i!==r;++i){let o=t[i];o.id in e&&n.push(o)}return n}};function Dp(s,t,e){let n=s.createShader(t);return s.shaderSource(n,e),s.compileShader(n),n}var WM=37297,XM=0;function qM(s,t){let e=s.split(`
`),n=[],i=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=i;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var Op=new Ft;function $M(s){Ht._getMatrix(Op,Ht.workingColorSpace,s);let t=`mat3( ${Op.elements.map(e=>e.toFixed(4))} )`;switch(Ht.getTransfer(s)){case hr:return[t,"LinearTransferOETF"];case te:return[t,"sRGBTransferOETF"];default:return Nt("WebGLProgram: Unsupported color space: ",s),[t,"LinearTransferOETF"]}}function Fp(s,t,e){let n=s.getShaderParameter(t,s.COMPILE_STATUS),r=(s.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+qM(s.getShaderSource(t),a)}else return r}function YM(s,t){let e=$M(t);return[`vec4 ${s}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var KM={[Th]:"Linear",[Ch]:"Reinhard",[Rh]:"Cineon",[Ih]:"ACESFilmic",[Lh]:"AgX",[Nh]:"Neutral",[Ph]:"Custom"};function ZM(s,t){let e=KM[t];return e===void 0?(Nt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+s+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+s+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Sl=new H;function JM(){Ht.getLuminanceCoefficients(Sl);let s=Sl.x.toFixed(4),t=Sl.y.toFixed(4),e=Sl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${s}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function jM(s){return[s.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",s.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Dr).join(`
`)}function QM(s){let t=[];for(let e in s){let n=s[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function tb(s,t){let e={},n=s.getProgramParameter(t,s.ACTIVE_ATTRIBUTES);for(let i=0;i<n;i++){let r=s.getActiveAttrib(t,i),o=r.name,a=1;r.type===s.FLOAT_MAT2&&(a=2),r.type===s.FLOAT_MAT3&&(a=3),r.type===s.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:s.getAttribLocation(t,o),locationSize:a}}return e}function Dr(s){return s!==""}function Up(s,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return s.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function kp(s,t){return s.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var eb=/^[ \t]*#include +<([\w\d./]+)>/gm;function ru(s){return s.replace(eb,nb)}function nb(s,t){let e=Gt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return ru(e)}var ib=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Bp(s){return s.replace(ib,sb)}function sb(s,t,e,n){let i="";for(let r=parseInt(t);r<parseInt(e);r++)i+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return i}function zp(s){let t=`precision ${s.precision} float;
	precision ${s.precision} int;
	precision ${s.precision} sampler2D;
	precision ${s.precision} samplerCube;
	precision ${s.precision} sampler3D;
	precision ${s.precision} sampler2DArray;
	precision ${s.precision} sampler2DShadow;
	precision ${s.precision} samplerCubeShadow;
	precision ${s.precision} sampler2DArrayShadow;
	precision ${s.precision} isampler2D;
	precision ${s.precision} isampler3D;
	precision ${s.precision} isamplerCube;
	precision ${s.precision} isampler2DArray;
	precision ${s.precision} usampler2D;
	precision ${s.precision} usampler3D;
	precision ${s.precision} usamplerCube;
	precision ${s.precision} usampler2DArray;
	`;return s.precision==="highp"?t+=`
#define HIGH_PRECISION`:s.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:s.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var rb={[Sr]:"SHADOWMAP_TYPE_PCF",[Fs]:"SHADOWMAP_TYPE_VSM"};function ob(s){return rb[s.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var ab={[ks]:"ENVMAP_MODE_REFRACTION"};function lb(s){return s.envMap===!1?"ENVMAP_MODE_REFLECTION":ab[s.envMapMode]||"ENVMAP_MODE_REFLECTION"}var cb={[Eh]:"ENVMAP_BLENDING_MULTIPLY",[ip]:"ENVMAP_BLENDING_MIX",[sp]:"ENVMAP_BLENDING_ADD"};function hb(s){return s.envMap===!1?"ENVMAP_BLENDING_NONE":cb[s.combine]||"ENVMAP_BLENDING_NONE"}function ub(s,t,e,n){let i=s.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=ob(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=lb(e),d=hb(e),u=jM(e),f=QM(r),p=i.createProgram(),x,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Dr).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Dr).join(`
`),m.length>0&&(m+=`
`)):(x=[zp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Dr).join(`
`),m=[zp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Vn?"#define TONE_MAPPING":"",e.toneMapping!==Vn?Gt.tonemapping_pars_fragment:"",e.toneMapping!==Vn?ZM("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Gt.colorspace_pars_fragment,YM("linearToOutputTexel",e.outputColorSpace),JM(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Dr).join(`
`)),o=ru(o),o=Up(o,e),o=kp(o,e),a=ru(a),a=Up(a,e),a=kp(a,e),o=Bp(o),a=Bp(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",e.glslVersion===$h?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===$h?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let M=g+x+o,A=g+m+a,b=Dp(i,i.VERTEX_SHADER,M),T=Dp(i,i.FRAGMENT_SHADER,A);i.attachShader(p,b),i.attachShader(p,T),e.index0AttributeName!==void 0?i.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&i.bindAttribLocation(p,0,"position"),i.linkProgram(p);function E(C){if(s.debug.checkShaderErrors){let L=i.getProgramInfoLog(p)||"",F=i.getShaderInfoLog(b)||"",W=i.getShaderInfoLog(T)||"",I=L.trim(),z=F.trim(),q=W.trim(),G=!0,tt=!0;if(i.getProgramParameter(p,i.LINK_STATUS)===!1)if(G=!1,typeof s.debug.onShaderError=="function")s.debug.onShaderError(i,p,b,T);else{let X=Fp(i,b,"vertex"),Q=Fp(i,T,"fragment");Ot("WebGLProgram: Shader Error "+i.getError()+" - VALIDATE_STATUS "+i.getProgramParameter(p,i.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+I+`
`+X+`
`+Q)}else I!==""?Nt("WebGLProgram: Program Info Log:",I):(z===""||q==="")&&(tt=!1);tt&&(C.diagnostics={runnable:G,programLog:I,vertexShader:{log:z,prefix:x},fragmentShader:{log:q,prefix:m}})}i.deleteShader(b),i.deleteShader(T),y=new zs(i,p),w=tb(i,p)}let y;this.getUniforms=function(){return y===void 0&&E(this),y};let w;this.getAttributes=function(){return w===void 0&&E(this),w};let D=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=i.getProgramParameter(p,WM)),D},this.destroy=function(){n.releaseStatesOfProgram(this),i.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=XM++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=T,this}var db=0,ou=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let i=this._getShaderCacheForMaterial(t);return i.has(e)===!1&&(i.add(e),e.usedTimes++),i.has(n)===!1&&(i.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new au(t),e.set(t,n)),n}},au=class{constructor(t){this.id=db++,this.code=t,this.usedTimes=0}};function fb(s){return s===Pi||s===Ir||s===Pr}function pb(s,t,e,n,i,r){let o=new pr,a=new ou,l=new Set,c=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,w,D,C,L,F){let W=C.fog,I=L.geometry,z=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?C.environment:null,q=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,G=t.get(y.envMap||z,q),tt=u[y.type],X=n.precision;y.precision!==null&&(X=n.getMaxPrecision(y.precision),X!==y.precision&&Nt("WebGLProgram.getParameters:",y.precision,"not supported, using",X,"instead."));let Q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,et=Q!==void 0?Q.length:0,Mt=0;I.morphAttributes.position!==void 0&&(Mt=1),I.morphAttributes.normal!==void 0&&(Mt=2),I.morphAttributes.color!==void 0&&(Mt=3);let Dt,K,pt,_t;if(tt){let mt=Wn[tt];Dt=mt.vertexShader,K=mt.fragmentShader}else{Dt=y.vertexShader,K=y.fragmentShader;let mt=a.getVertexShaderStage(y),ee=a.getFragmentShaderStage(y);a.update(y,mt,ee),pt=mt.id,_t=ee.id}let At=s.getRenderTarget(),ht=s.state.buffers.depth.getReversed(),It=L.isInstancedMesh===!0,oe=L.isBatchedMesh===!0,Ct=!!y.map,qt=!!y.matcap,Yt=!!G,kt=Yt&&G.isPMREMTexture===!0,pe=!!y.aoMap,ve=!!y.lightMap,De=!!y.bumpMap&&y.wireframe===!1,ae=!!y.normalMap,cn=!!y.displacementMap,be=!!y.emissiveMap,Xe=!!y.metalnessMap,ue=!!y.roughnessMap,qe=y.anisotropy>0,N=y.clearcoat>0,Oe=y.diffuseRoughness>0,ne=y.dispersion>0,jt=y.retroreflectivity>0,rt=y.iridescence>0,de=y.sheen>0,Rt=y.transmission>0,Lt=qe&&!!y.anisotropyMap,S=N&&!!y.clearcoatMap,v=N&&!!y.clearcoatNormalMap,k=N&&!!y.clearcoatRoughnessMap,nt=Oe&&!!y.diffuseRoughnessMap,j=rt&&!!y.iridescenceMap,ot=rt&&!!y.iridescenceThicknessMap,dt=de&&!!y.sheenColorMap,Y=de&&!!y.sheenRoughnessMap,Z=!!y.specularMap,lt=!!y.specularColorMap,R=!!y.specularIntensityMap,J=Rt&&!!y.transmissionMap,$=Rt&&!!y.thicknessMap,ct=!!y.gradientMap,st=!!y.alphaMap,at=y.alphaTest>0,Tt=!!y.alphaHash,zt=!!y.extensions,it=Vn;y.toneMapped&&(At===null||At.isXRRenderTarget===!0)&&(it=s.toneMapping);let Pt=kt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Bt={shaderID:tt,shaderType:y.type,shaderName:y.name,vertexShader:Dt,fragmentShader:K,defines:y.defines,customVertexShaderID:pt,customFragmentShaderID:_t,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:X,batching:oe,batchingColor:oe&&L._colorsTexture!==null,instancing:It,instancingColor:It&&L.instanceColor!==null,instancingMorph:It&&L.morphTexture!==null,outputColorSpace:At===null?s.outputColorSpace:At.isXRRenderTarget===!0?At.texture.colorSpace:Ht.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Ct,matcap:qt,envMap:Yt,envMapMode:Yt&&G.mapping,envMapPMREM:kt,envMapMaxLod:kt?Pt.length-1:null,envMapSize:kt?Pt[0].width:null,aoMap:pe,lightMap:ve,bumpMap:De,normalMap:ae,displacementMap:cn,emissiveMap:be,normalMapObjectSpace:ae&&y.normalMapType===ap,normalMapTangentSpace:ae&&y.normalMapType===Vh,packedNormalMap:ae&&y.normalMapType===Vh&&fb(y.normalMap.format),metalnessMap:Xe,roughnessMap:ue,anisotropy:qe,anisotropyMap:Lt,clearcoat:N,clearcoatMap:S,clearcoatNormalMap:v,clearcoatRoughnessMap:k,diffuseRoughness:Oe,diffuseRoughnessMap:nt,dispersion:ne,retroreflection:jt,iridescence:rt,iridescenceMap:j,iridescenceThicknessMap:ot,sheen:de,sheenColorMap:dt,sheenRoughnessMap:Y,specularMap:Z,specularColorMap:lt,specularIntensityMap:R,transmission:Rt,transmissionMap:J,thicknessMap:$,gradientMap:ct,opaque:y.transparent===!1&&y.blending===Us&&y.alphaToCoverage===!1,alphaMap:st,alphaTest:at,alphaHash:Tt,combine:y.combine,mapUv:Ct&&f(y.map.channel),aoMapUv:pe&&f(y.aoMap.channel),lightMapUv:ve&&f(y.lightMap.channel),bumpMapUv:De&&f(y.bumpMap.channel),normalMapUv:ae&&f(y.normalMap.channel),displacementMapUv:cn&&f(y.displacementMap.channel),emissiveMapUv:be&&f(y.emissiveMap.channel),metalnessMapUv:Xe&&f(y.metalnessMap.channel),roughnessMapUv:ue&&f(y.roughnessMap.channel),anisotropyMapUv:Lt&&f(y.anisotropyMap.channel),clearcoatMapUv:S&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:v&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:k&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:nt&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:j&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:ot&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:dt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:Y&&f(y.sheenRoughnessMap.channel),specularMapUv:Z&&f(y.specularMap.channel),specularColorMapUv:lt&&f(y.specularColorMap.channel),specularIntensityMapUv:R&&f(y.specularIntensityMap.channel),transmissionMapUv:J&&f(y.transmissionMap.channel),thicknessMapUv:$&&f(y.thicknessMap.channel),alphaMapUv:st&&f(y.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(ae||qe),vertexNormals:!!I.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!I.attributes.uv&&(Ct||st),fog:!!W,useFog:y.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||I.attributes.normal===void 0&&ae===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:ht,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:Mt,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:F.filter(mt=>mt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:s.shadowMap.enabled&&D.length>0,shadowMapType:s.shadowMap.type,toneMapping:it,decodeVideoTexture:Ct&&y.map.isVideoTexture===!0&&Ht.getTransfer(y.map.colorSpace)===te,decodeVideoTextureEmissive:be&&y.emissiveMap.isVideoTexture===!0&&Ht.getTransfer(y.emissiveMap.colorSpace)===te,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===yn,flipSided:y.side===Je,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:zt&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(zt&&y.extensions.multiDraw===!0||oe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Bt.vertexUv1s=l.has(1),Bt.vertexUv2s=l.has(2),Bt.vertexUv3s=l.has(3),l.clear(),Bt}function x(y){let w=[];if(y.shaderID?w.push(y.shaderID):(w.push(y.customVertexShaderID),w.push(y.customFragmentShaderID)),y.defines!==void 0)for(let D in y.defines)w.push(D),w.push(y.defines[D]);return y.isRawShaderMaterial===!1&&(m(w,y),g(w,y),w.push(s.outputColorSpace)),w.push(y.customProgramCacheKey),w.join()}function m(y,w){y.push(w.precision),y.push(w.outputColorSpace),y.push(w.envMapMode),y.push(w.envMapPMREM),y.push(w.envMapMaxLod),y.push(w.envMapSize),y.push(w.mapUv),y.push(w.alphaMapUv),y.push(w.lightMapUv),y.push(w.aoMapUv),y.push(w.bumpMapUv),y.push(w.normalMapUv),y.push(w.displacementMapUv),y.push(w.emissiveMapUv),y.push(w.metalnessMapUv),y.push(w.roughnessMapUv),y.push(w.anisotropyMapUv),y.push(w.clearcoatMapUv),y.push(w.clearcoatNormalMapUv),y.push(w.clearcoatRoughnessMapUv),y.push(w.diffuseRoughnessMapUv),y.push(w.iridescenceMapUv),y.push(w.iridescenceThicknessMapUv),y.push(w.sheenColorMapUv),y.push(w.sheenRoughnessMapUv),y.push(w.specularMapUv),y.push(w.specularColorMapUv),y.push(w.specularIntensityMapUv),y.push(w.transmissionMapUv),y.push(w.thicknessMapUv),y.push(w.combine),y.push(w.fogExp2),y.push(w.sizeAttenuation),y.push(w.morphTargetsCount),y.push(w.numSunLights),y.push(w.numDirLights),y.push(w.numPointLights),y.push(w.numSpotLights),y.push(w.numSpotLightMaps),y.push(w.numHemiLights),y.push(w.numRectAreaLights),y.push(w.numSunLightShadows),y.push(w.numDirLightShadows),y.push(w.numPointLightShadows),y.push(w.numSpotLightShadows),y.push(w.numSpotLightShadowsWithMaps),y.push(w.numLightProbes),y.push(w.numLightProbeGrids),y.push(w.shadowMapType),y.push(w.toneMapping),y.push(w.numClippingPlanes),y.push(w.numClipIntersection),y.push(w.depthPacking)}function g(y,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function M(y){let w=u[y.type],D;if(w){let C=Wn[w];D=Mp.clone(C.uniforms)}else D=y.uniforms;return D}function A(y,w){let D=h.get(w);return D!==void 0?++D.usedTimes:(D=new ub(s,w,y,i),c.push(D),h.set(w,D)),D}function b(y){if(--y.usedTimes===0){let w=c.indexOf(y);c[w]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function T(y){a.remove(y)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:M,acquireProgram:A,releaseProgram:b,releaseShaderCache:T,programs:c,dispose:E}}function mb(){let s=new WeakMap;function t(o){return s.has(o)}function e(o){let a=s.get(o);return a===void 0&&(a={},s.set(o,a)),a}function n(o){s.delete(o)}function i(o,a,l){s.get(o)[a]=l}function r(){s=new WeakMap}return{has:t,get:e,remove:n,update:i,dispose:r}}function gb(s,t){return s.groupOrder!==t.groupOrder?s.groupOrder-t.groupOrder:s.renderOrder!==t.renderOrder?s.renderOrder-t.renderOrder:s.material.id!==t.material.id?s.material.id-t.material.id:s.materialVariant!==t.materialVariant?s.materialVariant-t.materialVariant:s.z!==t.z?s.z-t.z:s.id-t.id}function Gp(s,t){return s.groupOrder!==t.groupOrder?s.groupOrder-t.groupOrder:s.renderOrder!==t.renderOrder?s.renderOrder-t.renderOrder:s.z!==t.z?t.z-s.z:s.id-t.id}function Vp(){let s=[],t=0,e=[],n=[],i=[];function r(){t=0,e.length=0,n.length=0,i.length=0}function o(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function a(u,f,p,x,m,g){let M=s[t];return M===void 0?(M={id:u.id,object:u,geometry:f,material:p,materialVariant:o(u),groupOrder:x,renderOrder:u.renderOrder,z:m,group:g},s[t]=M):(M.id=u.id,M.object=u,M.geometry=f,M.material=p,M.materialVariant=o(u),M.groupOrder=x,M.renderOrder=u.renderOrder,M.z=m,M.group=g),t++,M}function l(u,f,p,x,m,g,M){M.reversedDepth===!0&&(m=-m);let A=a(u,f,p,x,m,g);p.transmission>0?n.push(A):p.transparent===!0?i.push(A):e.push(A)}function c(u,f,p,x,m,g){let M=a(u,f,p,x,m,g);p.transmission>0?n.unshift(M):p.transparent===!0?i.unshift(M):e.unshift(M)}function h(u,f){e.length>1&&e.sort(u||gb),n.length>1&&n.sort(f||Gp),i.length>1&&i.sort(f||Gp)}function d(){for(let u=t,f=s.length;u<f;u++){let p=s[u];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:i,init:r,push:l,unshift:c,finish:d,sort:h}}function xb(){let s=new WeakMap;function t(n,i){let r=s.get(n),o;return r===void 0?(o=new Vp,s.set(n,[o])):i>=r.length?(o=new Vp,r.push(o)):o=r[i],o}function e(){s=new WeakMap}return{get:t,dispose:e}}function yb(){let s={};return{get:function(t){if(s[t.id]!==void 0)return s[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new H,color:new Zt};break;case"SpotLight":e={position:new H,direction:new H,color:new Zt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new H,color:new Zt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new H,skyColor:new Zt,groundColor:new Zt};break;case"RectAreaLight":e={color:new Zt,position:new H,halfWidth:new H,halfHeight:new H};break}return s[t.id]=e,e}}}function vb(){let s={};return{get:function(t){if(s[t.id]!==void 0)return s[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt,shadowCameraNear:1,shadowCameraFar:1e3};break}return s[t.id]=e,e}}}var _b=0;function Mb(s,t){return(t.castShadow?2:0)-(s.castShadow?2:0)+(t.map?1:0)-(s.map?1:0)}function bb(s){let t=new yb,e=vb(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new H);let i=new H,r=new _e,o=new _e;function a(c){let h=0,d=0,u=0;for(let F=0;F<9;F++)n.probe[F].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,M=0,A=0,b=0,T=0,E=0,y=0,w=0,D=0,C=0;c.sort(Mb);for(let F=0,W=c.length;F<W;F++){let I=c[F],z=I.color,q=I.intensity,G=I.distance,tt=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===Pi?tt=I.shadow.map.texture:tt=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=z.r*q,d+=z.g*q,u+=z.b*q;else if(I.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(I.sh.coefficients[X],q);C++}else if(I.isSunLight){let X=t.get(I);if(X.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,et=e.get(I);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[p]=et,n.sunShadowMap[p]=tt;let Mt=Q.getViewportCount();for(let Dt=0;Dt<Mt;Dt++)n.sunShadowMatrix[x+Dt]=Q.getMatrix(Dt),n.sunShadowCascade[x+Dt]=Q._cascadeData[Dt];x+=Mt,p++}n.sun[f]=X,f++}else if(I.isDirectionalLight){let X=t.get(I);if(X.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,et=e.get(I);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,n.directionalShadow[m]=et,n.directionalShadowMap[m]=tt,n.directionalShadowMatrix[m]=I.shadow.matrix,T++}n.directional[m]=X,m++}else if(I.isSpotLight){let X=t.get(I);X.position.setFromMatrixPosition(I.matrixWorld),X.color.copy(z).multiplyScalar(q),X.distance=G,X.coneCos=Math.cos(I.angle),X.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),X.decay=I.decay,n.spot[M]=X;let Q=I.shadow;if(I.map&&(n.spotLightMap[w]=I.map,w++,Q.updateMatrices(I),I.castShadow&&D++),n.spotLightMatrix[M]=Q.matrix,I.castShadow){let et=e.get(I);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,n.spotShadow[M]=et,n.spotShadowMap[M]=tt,y++}M++}else if(I.isRectAreaLight){let X=t.get(I);X.color.copy(z).multiplyScalar(q),X.halfWidth.set(I.width*.5,0,0),X.halfHeight.set(0,I.height*.5,0),n.rectArea[A]=X,A++}else if(I.isPointLight){let X=t.get(I);if(X.color.copy(I.color).multiplyScalar(I.intensity),X.distance=I.distance,X.decay=I.decay,I.castShadow){let Q=I.shadow,et=e.get(I);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,et.shadowCameraNear=Q.camera.near,et.shadowCameraFar=Q.camera.far,n.pointShadow[g]=et,n.pointShadowMap[g]=tt,n.pointShadowMatrix[g]=I.shadow.matrix,E++}n.point[g]=X,g++}else if(I.isHemisphereLight){let X=t.get(I);X.skyColor.copy(I.color).multiplyScalar(q),X.groundColor.copy(I.groundColor).multiplyScalar(q),n.hemi[b]=X,b++}}A>0&&(s.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=gt.LTC_FLOAT_1,n.rectAreaLTC2=gt.LTC_FLOAT_2):(n.rectAreaLTC1=gt.LTC_HALF_1,n.rectAreaLTC2=gt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let L=n.hash;(L.sunLength!==f||L.directionalLength!==m||L.pointLength!==g||L.spotLength!==M||L.rectAreaLength!==A||L.hemiLength!==b||L.numSunShadows!==p||L.numDirectionalShadows!==T||L.numPointShadows!==E||L.numSpotShadows!==y||L.numSpotMaps!==w||L.numLightProbes!==C)&&(n.sun.length=f,n.directional.length=m,n.spot.length=M,n.rectArea.length=A,n.point.length=g,n.hemi.length=b,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=T,n.directionalShadowMap.length=T,n.directionalShadowMatrix.length=T,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+w-D,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=D,n.numLightProbes=C,L.sunLength=f,L.directionalLength=m,L.pointLength=g,L.spotLength=M,L.rectAreaLength=A,L.hemiLength=b,L.numSunShadows=p,L.numDirectionalShadows=T,L.numPointShadows=E,L.numSpotShadows=y,L.numSpotMaps=w,L.numLightProbes=C,n.version=_b++)}function l(c,h){let d=0,u=0,f=0,p=0,x=0,m=0,g=h.matrixWorldInverse;for(let M=0,A=c.length;M<A;M++){let b=c[M];if(b.isSunLight){let T=n.sun[d];T.direction.setFromMatrixPosition(b.matrixWorld),T.direction.transformDirection(g),d++}else if(b.isDirectionalLight){let T=n.directional[u];T.direction.setFromMatrixPosition(b.matrixWorld),i.setFromMatrixPosition(b.target.matrixWorld),T.direction.sub(i),T.direction.transformDirection(g),u++}else if(b.isSpotLight){let T=n.spot[p];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(g),T.direction.setFromMatrixPosition(b.matrixWorld),i.setFromMatrixPosition(b.target.matrixWorld),T.direction.sub(i),T.direction.transformDirection(g),p++}else if(b.isRectAreaLight){let T=n.rectArea[x];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),T.halfWidth.set(b.width*.5,0,0),T.halfHeight.set(0,b.height*.5,0),T.halfWidth.applyMatrix4(o),T.halfHeight.applyMatrix4(o),x++}else if(b.isPointLight){let T=n.point[f];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let T=n.hemi[m];T.direction.setFromMatrixPosition(b.matrixWorld),T.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:n}}function Hp(s){let t=new bb(s),e=[],n=[],i=[];function r(d){h.camera=d,e.length=0,n.length=0,i.length=0}function o(d){d.isLightProbeGrid?i.push(d):e.push(d)}function a(d){n.push(d)}function l(){t.setup(e),i.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){t.setupView(e,d)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:i,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function wb(s){let t=new WeakMap;function e(i,r=0){let o=t.get(i),a;return o===void 0?(a=new Hp(s),t.set(i,[a])):r>=o.length?(a=new Hp(s),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var Sb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Ab=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Eb=[new H(1,0,0),new H(-1,0,0),new H(0,1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1)],Tb=[new H(0,-1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1),new H(0,-1,0),new H(0,-1,0)],Wp=new _e,Nr=new H,eu=new H;function Cb(s,t,e){let n=new $i,i=new Jt,r=new Jt,o=new ye,a=new Sa,l=new Aa,c={},h=e.maxTextureSize,d={[Ii]:Je,[Je]:Ii,[yn]:yn},u=new xn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Jt},radius:{value:4}},vertexShader:Sb,fragmentShader:Ab}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let p=new Gn;p.setAttribute("position",new Ze(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new gn(p,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Sr;let g=this.type;this.render=function(E,y,w){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===kf&&(Nt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Sr);let D=s.getRenderTarget(),C=s.getActiveCubeFace(),L=s.getActiveMipmapLevel(),F=s.state;F.setBlending(Yi),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let W=g!==this.type;W&&y.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(z=>z.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,z=E.length;I<z;I++){let q=E[I],G=q.shadow;if(G===void 0){Nt("WebGLShadowMap:",q,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;i.copy(G.mapSize);let tt=G.getFrameExtents();i.multiply(tt),r.copy(G.mapSize),(i.x>h||i.y>h)&&(i.x>h&&(r.x=Math.floor(h/tt.x),i.x=r.x*tt.x,G.mapSize.x=r.x),i.y>h&&(r.y=Math.floor(h/tt.y),i.y=r.y*tt.y,G.mapSize.y=r.y));let X=s.state.buffers.depth.getReversed();if(G.camera._reversedDepth=X,G.map===null||W===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Fs){if(q.isPointLight){Nt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new on(i.x,i.y,{format:Pi,type:Rn,minFilter:Ne,magFilter:Ne,generateMipmaps:!1}),G.map.texture.name=q.name+".shadowMap",G.map.depthTexture=new oi(i.x,i.y,Cn),G.map.depthTexture.name=q.name+".shadowMapDepth",G.map.depthTexture.format=ri,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Le,G.map.depthTexture.magFilter=Le}else q.isPointLight?(G.map=new Or(i.x),G.map.depthTexture=new vr(i.x,Tn)):(G.map=new on(i.x,i.y),G.map.depthTexture=new oi(i.x,i.y,Tn)),G.map.depthTexture.name=q.name+".shadowMap",G.map.depthTexture.format=ri,this.type===Sr?(G.map.depthTexture.compareFunction=X?Wh:Hh,G.map.depthTexture.minFilter=Ne,G.map.depthTexture.magFilter=Ne):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Le,G.map.depthTexture.magFilter=Le);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==i.x||G.map.height!==i.y)&&G.map.setSize(i.x,i.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();q.isPointLight!==!0&&G.updateMatrices(q,w);let et=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:w.layers;for(let Mt=0;Mt<Q;Mt++){let Dt=G.getCamera(Mt);if(q.isPointLight){let K=G.camera,pt=G.matrix,_t=q.distance||K.far;_t!==K.far&&(K.far=_t,K.updateProjectionMatrix()),Nr.setFromMatrixPosition(q.matrixWorld),K.position.copy(Nr),eu.copy(K.position),eu.add(Eb[Mt]),K.up.copy(Tb[Mt]),K.lookAt(eu),K.updateMatrixWorld(),pt.makeTranslation(-Nr.x,-Nr.y,-Nr.z),Wp.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Wp,K.coordinateSystem,K.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)s.setRenderTarget(G.map,Mt),s.clear();else{Mt===0&&(s.setRenderTarget(G.map),s.clear());let K=G.getViewport(Mt);o.set(r.x*K.x,r.y*K.y,r.x*K.z,r.y*K.w),F.viewport(o)}n=G.getFrustum(Mt),b(y,w,Dt,q,et,this.type)}G.isPointLightShadow!==!0&&this.type===Fs&&M(G,w),G.needsUpdate=!1}g=this.type,m.needsUpdate=!1,s.setRenderTarget(D,C,L)};function M(E,y){let w=t.update(x);u.defines.VSM_SAMPLES!==E.blurSamples&&(u.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new on(i.x,i.y,{format:Pi,type:Rn}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),u.uniforms.shadow_pass.value=E.map.depthTexture,u.uniforms.resolution.value.set(E.map.width,E.map.height),u.uniforms.radius.value=E.radius,s.setRenderTarget(E.mapPass),s.clear(),s.renderBufferDirect(y,null,w,u,x,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,s.setRenderTarget(E.map),s.clear(),s.renderBufferDirect(y,null,w,f,x,null)}function A(E,y,w,D){let C=null,L=w.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(L!==void 0)C=L;else if(C=w.isPointLight===!0?l:a,s.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let F=C.uuid,W=y.uuid,I=c[F];I===void 0&&(I={},c[F]=I);let z=I[W];z===void 0&&(z=C.clone(),I[W]=z,y.addEventListener("dispose",T)),C=z}if(C.visible=y.visible,C.wireframe=y.wireframe,D===Fs?C.side=y.shadowSide!==null?y.shadowSide:y.side:C.side=y.shadowSide!==null?y.shadowSide:d[y.side],C.alphaMap=y.alphaMap,C.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,C.map=y.map,C.clipShadows=y.clipShadows,C.clippingPlanes=y.clippingPlanes,C.clipIntersection=y.clipIntersection,C.displacementMap=y.displacementMap,C.displacementScale=y.displacementScale,C.displacementBias=y.displacementBias,C.wireframeLinewidth=y.wireframeLinewidth,C.linewidth=y.linewidth,w.isPointLight===!0&&C.isMeshDistanceMaterial===!0){let F=s.properties.get(C);F.light=w}return C}function b(E,y,w,D,C,L){if(E.visible===!1)return;if(E.layers.test(C)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&L===Fs)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,E.matrixWorld);let I=t.update(E),z=E.material;if(Array.isArray(z)){let q=I.groups;for(let G=0,tt=q.length;G<tt;G++){let X=q[G],Q=z[X.materialIndex];if(Q&&Q.visible){let et=A(E,Q,D,L);E.onBeforeShadow(s,E,y,w,I,et,X),s.renderBufferDirect(w,null,I,et,E,X),E.onAfterShadow(s,E,y,w,I,et,X)}}}else if(z.visible){let q=A(E,z,D,L);E.onBeforeShadow(s,E,y,w,I,q,null),s.renderBufferDirect(w,null,I,q,E,null),E.onAfterShadow(s,E,y,w,I,q,null)}}let W=E.children;for(let I=0,z=W.length;I<z;I++)b(W[I],y,w,D,C,L)}function T(E){E.target.removeEventListener("dispose",T);for(let w in c){let D=c[w],C=E.target.uuid;C in D&&(D[C].dispose(),delete D[C])}}}function Rb(s,t){function e(){let R=!1,J=new ye,$=null,ct=new ye(0,0,0,0);return{setMask:function(st){$!==st&&!R&&(s.colorMask(st,st,st,st),$=st)},setLocked:function(st){R=st},setClear:function(st,at,Tt,zt,it){it===!0&&(st*=zt,at*=zt,Tt*=zt),J.set(st,at,Tt,zt),ct.equals(J)===!1&&(s.clearColor(st,at,Tt,zt),ct.copy(J))},reset:function(){R=!1,$=null,ct.set(-1,0,0,0)}}}function n(){let R=!1,J=!1,$=null,ct=null,st=null;return{setReversed:function(at){if(J!==at){let Tt=t.get("EXT_clip_control");at?Tt.clipControlEXT(Tt.LOWER_LEFT_EXT,Tt.ZERO_TO_ONE_EXT):Tt.clipControlEXT(Tt.LOWER_LEFT_EXT,Tt.NEGATIVE_ONE_TO_ONE_EXT),J=at;let zt=st;st=null,this.setClear(zt)}},getReversed:function(){return J},setTest:function(at){at?ht(s.DEPTH_TEST):It(s.DEPTH_TEST)},setMask:function(at){$!==at&&!R&&(s.depthMask(at),$=at)},setFunc:function(at){if(J&&(at=yp[at]),ct!==at){switch(at){case oa:s.depthFunc(s.NEVER);break;case aa:s.depthFunc(s.ALWAYS);break;case la:s.depthFunc(s.LESS);break;case Rs:s.depthFunc(s.LEQUAL);break;case ca:s.depthFunc(s.EQUAL);break;case ha:s.depthFunc(s.GEQUAL);break;case ua:s.depthFunc(s.GREATER);break;case da:s.depthFunc(s.NOTEQUAL);break;default:s.depthFunc(s.LEQUAL)}ct=at}},setLocked:function(at){R=at},setClear:function(at){st!==at&&(st=at,J&&(at=1-at),s.clearDepth(at))},reset:function(){R=!1,$=null,ct=null,st=null,J=!1}}}function i(){let R=!1,J=null,$=null,ct=null,st=null,at=null,Tt=null,zt=null,it=null;return{setTest:function(Pt){R||(Pt?ht(s.STENCIL_TEST):It(s.STENCIL_TEST))},setMask:function(Pt){J!==Pt&&!R&&(s.stencilMask(Pt),J=Pt)},setFunc:function(Pt,Bt,mt){($!==Pt||ct!==Bt||st!==mt)&&(s.stencilFunc(Pt,Bt,mt),$=Pt,ct=Bt,st=mt)},setOp:function(Pt,Bt,mt){(at!==Pt||Tt!==Bt||zt!==mt)&&(s.stencilOp(Pt,Bt,mt),at=Pt,Tt=Bt,zt=mt)},setLocked:function(Pt){R=Pt},setClear:function(Pt){it!==Pt&&(s.clearStencil(Pt),it=Pt)},reset:function(){R=!1,J=null,$=null,ct=null,st=null,at=null,Tt=null,zt=null,it=null}}}let r=new e,o=new n,a=new i,l={},c=new WeakMap,h={},d={},u={},f=new WeakMap,p=[],x=null,m=!1,g=null,M=null,A=null,b=null,T=null,E=null,y=null,w=new Zt(0,0,0),D=0,C=!1,L=null,F=null,W=null,I=null,z=null,q=s.getParameter(s.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,tt=0,X=s.getParameter(s.VERSION);X.indexOf("WebGL")!==-1?(tt=parseFloat(/^WebGL (\d)/.exec(X)[1]),G=tt>=1):X.indexOf("OpenGL ES")!==-1&&(tt=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),G=tt>=2);let Q=null,et={},Mt=s.getParameter(s.SCISSOR_BOX),Dt=s.getParameter(s.VIEWPORT),K=new ye().fromArray(Mt),pt=new ye().fromArray(Dt);function _t(R,J,$,ct){let st=new Uint8Array(4),at=s.createTexture();s.bindTexture(R,at),s.texParameteri(R,s.TEXTURE_MIN_FILTER,s.NEAREST),s.texParameteri(R,s.TEXTURE_MAG_FILTER,s.NEAREST);for(let Tt=0;Tt<$;Tt++)R===s.TEXTURE_3D||R===s.TEXTURE_2D_ARRAY?s.texImage3D(J,0,s.RGBA,1,1,ct,0,s.RGBA,s.UNSIGNED_BYTE,st):s.texImage2D(J+Tt,0,s.RGBA,1,1,0,s.RGBA,s.UNSIGNED_BYTE,st);return at}let At={};At[s.TEXTURE_2D]=_t(s.TEXTURE_2D,s.TEXTURE_2D,1),At[s.TEXTURE_CUBE_MAP]=_t(s.TEXTURE_CUBE_MAP,s.TEXTURE_CUBE_MAP_POSITIVE_X,6),At[s.TEXTURE_2D_ARRAY]=_t(s.TEXTURE_2D_ARRAY,s.TEXTURE_2D_ARRAY,1,1),At[s.TEXTURE_3D]=_t(s.TEXTURE_3D,s.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ht(s.DEPTH_TEST),o.setFunc(Rs),De(!1),ae(_h),ht(s.CULL_FACE),pe(Yi);function ht(R){h[R]!==!0&&(s.enable(R),h[R]=!0)}function It(R){h[R]!==!1&&(s.disable(R),h[R]=!1)}function oe(R,J){return u[R]!==J?(s.bindFramebuffer(R,J),u[R]=J,R===s.DRAW_FRAMEBUFFER&&(u[s.FRAMEBUFFER]=J),R===s.FRAMEBUFFER&&(u[s.DRAW_FRAMEBUFFER]=J),!0):!1}function Ct(R,J){let $=p,ct=!1;if(R){$=f.get(J),$===void 0&&($=[],f.set(J,$));let st=R.textures;if($.length!==st.length||$[0]!==s.COLOR_ATTACHMENT0){for(let at=0,Tt=st.length;at<Tt;at++)$[at]=s.COLOR_ATTACHMENT0+at;$.length=st.length,ct=!0}}else $[0]!==s.BACK&&($[0]=s.BACK,ct=!0);ct&&s.drawBuffers($)}function qt(R){return x!==R?(s.useProgram(R),x=R,!0):!1}let Yt={[Ki]:s.FUNC_ADD,[zf]:s.FUNC_SUBTRACT,[Gf]:s.FUNC_REVERSE_SUBTRACT};Yt[Vf]=s.MIN,Yt[Hf]=s.MAX;let kt={[Wf]:s.ZERO,[Xf]:s.ONE,[qf]:s.SRC_COLOR,[Sh]:s.SRC_ALPHA,[jf]:s.SRC_ALPHA_SATURATE,[Zf]:s.DST_COLOR,[Yf]:s.DST_ALPHA,[$f]:s.ONE_MINUS_SRC_COLOR,[Ah]:s.ONE_MINUS_SRC_ALPHA,[Jf]:s.ONE_MINUS_DST_COLOR,[Kf]:s.ONE_MINUS_DST_ALPHA,[Qf]:s.CONSTANT_COLOR,[tp]:s.ONE_MINUS_CONSTANT_COLOR,[ep]:s.CONSTANT_ALPHA,[np]:s.ONE_MINUS_CONSTANT_ALPHA};function pe(R,J,$,ct,st,at,Tt,zt,it,Pt){if(R===Yi){m===!0&&(It(s.BLEND),m=!1);return}if(m===!1&&(ht(s.BLEND),m=!0),R!==Bf){if(R!==g||Pt!==C){if((M!==Ki||T!==Ki)&&(s.blendEquation(s.FUNC_ADD),M=Ki,T=Ki),Pt)switch(R){case Us:s.blendFuncSeparate(s.ONE,s.ONE_MINUS_SRC_ALPHA,s.ONE,s.ONE_MINUS_SRC_ALPHA);break;case Mh:s.blendFunc(s.ONE,s.ONE);break;case bh:s.blendFuncSeparate(s.ZERO,s.ONE_MINUS_SRC_COLOR,s.ZERO,s.ONE);break;case wh:s.blendFuncSeparate(s.DST_COLOR,s.ONE_MINUS_SRC_ALPHA,s.ZERO,s.ONE);break;default:Ot("WebGLState: Invalid blending: ",R);break}else switch(R){case Us:s.blendFuncSeparate(s.SRC_ALPHA,s.ONE_MINUS_SRC_ALPHA,s.ONE,s.ONE_MINUS_SRC_ALPHA);break;case Mh:s.blendFuncSeparate(s.SRC_ALPHA,s.ONE,s.ONE,s.ONE);break;case bh:Ot("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case wh:Ot("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ot("WebGLState: Invalid blending: ",R);break}A=null,b=null,E=null,y=null,w.set(0,0,0),D=0,g=R,C=Pt}return}st=st||J,at=at||$,Tt=Tt||ct,(J!==M||st!==T)&&(s.blendEquationSeparate(Yt[J],Yt[st]),M=J,T=st),($!==A||ct!==b||at!==E||Tt!==y)&&(s.blendFuncSeparate(kt[$],kt[ct],kt[at],kt[Tt]),A=$,b=ct,E=at,y=Tt),(zt.equals(w)===!1||it!==D)&&(s.blendColor(zt.r,zt.g,zt.b,it),w.copy(zt),D=it),g=R,C=!1}function ve(R,J){R.side===yn?It(s.CULL_FACE):ht(s.CULL_FACE);let $=R.side===Je;J&&($=!$),De($),R.blending===Us&&R.transparent===!1?pe(Yi):pe(R.blending,R.blendEquation,R.blendSrc,R.blendDst,R.blendEquationAlpha,R.blendSrcAlpha,R.blendDstAlpha,R.blendColor,R.blendAlpha,R.premultipliedAlpha),o.setFunc(R.depthFunc),o.setTest(R.depthTest),o.setMask(R.depthWrite),r.setMask(R.colorWrite);let ct=R.stencilWrite;a.setTest(ct),ct&&(a.setMask(R.stencilWriteMask),a.setFunc(R.stencilFunc,R.stencilRef,R.stencilFuncMask),a.setOp(R.stencilFail,R.stencilZFail,R.stencilZPass)),be(R.polygonOffset,R.polygonOffsetFactor,R.polygonOffsetUnits),R.alphaToCoverage===!0?ht(s.SAMPLE_ALPHA_TO_COVERAGE):It(s.SAMPLE_ALPHA_TO_COVERAGE)}function De(R){L!==R&&(R?s.frontFace(s.CW):s.frontFace(s.CCW),L=R)}function ae(R){R!==Ff?(ht(s.CULL_FACE),R!==F&&(R===_h?s.cullFace(s.BACK):R===Uf?s.cullFace(s.FRONT):s.cullFace(s.FRONT_AND_BACK))):It(s.CULL_FACE),F=R}function cn(R){R!==W&&(G&&s.lineWidth(R),W=R)}function be(R,J,$){R?(ht(s.POLYGON_OFFSET_FILL),(I!==J||z!==$)&&(I=J,z=$,o.getReversed()&&(J=-J,$=-$),s.polygonOffset(J,$))):It(s.POLYGON_OFFSET_FILL)}function Xe(R){R?ht(s.SCISSOR_TEST):It(s.SCISSOR_TEST)}function ue(R){R===void 0&&(R=s.TEXTURE0+q-1),Q!==R&&(s.activeTexture(R),Q=R)}function qe(R,J,$){$===void 0&&(Q===null?$=s.TEXTURE0+q-1:$=Q);let ct=et[$];ct===void 0&&(ct={type:void 0,texture:void 0},et[$]=ct),(ct.type!==R||ct.texture!==J)&&(Q!==$&&(s.activeTexture($),Q=$),s.bindTexture(R,J||At[R]),ct.type=R,ct.texture=J)}function N(){let R=et[Q];R!==void 0&&R.type!==void 0&&(s.bindTexture(R.type,null),R.type=void 0,R.texture=void 0)}function Oe(){try{s.compressedTexImage2D(...arguments)}catch(R){Ot("WebGLState:",R)}}function ne(){try{s.compressedTexImage3D(...arguments)}catch(R){Ot("WebGLState:",R)}}function jt(){try{s.texSubImage2D(...arguments)}catch(R){Ot("WebGLState:",R)}}function rt(){try{s.texSubImage3D(...arguments)}catch(R){Ot("WebGLState:",R)}}function de(){try{s.compressedTexSubImage2D(...arguments)}catch(R){Ot("WebGLState:",R)}}function Rt(){try{s.compressedTexSubImage3D(...arguments)}catch(R){Ot("WebGLState:",R)}}function Lt(){try{s.texStorage2D(...arguments)}catch(R){Ot("WebGLState:",R)}}function S(){try{s.texStorage3D(...arguments)}catch(R){Ot("WebGLState:",R)}}function v(){try{s.texImage2D(...arguments)}catch(R){Ot("WebGLState:",R)}}function k(){try{s.texImage3D(...arguments)}catch(R){Ot("WebGLState:",R)}}function nt(R){return d[R]!==void 0?d[R]:s.getParameter(R)}function j(R,J){d[R]!==J&&(s.pixelStorei(R,J),d[R]=J)}function ot(R){K.equals(R)===!1&&(s.scissor(R.x,R.y,R.z,R.w),K.copy(R))}function dt(R){pt.equals(R)===!1&&(s.viewport(R.x,R.y,R.z,R.w),pt.copy(R))}function Y(R,J){let $=c.get(J);$===void 0&&($=new WeakMap,c.set(J,$));let ct=$.get(R);ct===void 0&&(ct=s.getUniformBlockIndex(J,R.name),s.uniformBlockBinding(J,ct,ct),$.set(R,ct))}function Z(R,J,$){let st=c.get(J).get(R);l[st]!==$&&(s.bindBufferBase(s.UNIFORM_BUFFER,st,$),l[st]=$)}function lt(){s.disable(s.BLEND),s.disable(s.CULL_FACE),s.disable(s.DEPTH_TEST),s.disable(s.POLYGON_OFFSET_FILL),s.disable(s.SCISSOR_TEST),s.disable(s.STENCIL_TEST),s.disable(s.SAMPLE_ALPHA_TO_COVERAGE),s.blendEquation(s.FUNC_ADD),s.blendFunc(s.ONE,s.ZERO),s.blendFuncSeparate(s.ONE,s.ZERO,s.ONE,s.ZERO),s.blendColor(0,0,0,0),s.colorMask(!0,!0,!0,!0),s.clearColor(0,0,0,0),s.depthMask(!0),s.depthFunc(s.LESS),o.setReversed(!1),s.clearDepth(1),s.stencilMask(4294967295),s.stencilFunc(s.ALWAYS,0,4294967295),s.stencilOp(s.KEEP,s.KEEP,s.KEEP),s.clearStencil(0),s.cullFace(s.BACK),s.frontFace(s.CCW),s.polygonOffset(0,0),s.activeTexture(s.TEXTURE0),s.bindFramebuffer(s.FRAMEBUFFER,null),s.bindFramebuffer(s.DRAW_FRAMEBUFFER,null),s.bindFramebuffer(s.READ_FRAMEBUFFER,null),s.useProgram(null),s.lineWidth(1),s.scissor(0,0,s.canvas.width,s.canvas.height),s.viewport(0,0,s.canvas.width,s.canvas.height),s.pixelStorei(s.PACK_ALIGNMENT,4),s.pixelStorei(s.UNPACK_ALIGNMENT,4),s.pixelStorei(s.UNPACK_FLIP_Y_WEBGL,!1),s.pixelStorei(s.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),s.pixelStorei(s.UNPACK_COLORSPACE_CONVERSION_WEBGL,s.BROWSER_DEFAULT_WEBGL),s.pixelStorei(s.PACK_ROW_LENGTH,0),s.pixelStorei(s.PACK_SKIP_PIXELS,0),s.pixelStorei(s.PACK_SKIP_ROWS,0),s.pixelStorei(s.UNPACK_ROW_LENGTH,0),s.pixelStorei(s.UNPACK_IMAGE_HEIGHT,0),s.pixelStorei(s.UNPACK_SKIP_PIXELS,0),s.pixelStorei(s.UNPACK_SKIP_ROWS,0),s.pixelStorei(s.UNPACK_SKIP_IMAGES,0),h={},d={},Q=null,et={},u={},l={},f=new WeakMap,p=[],x=null,m=!1,g=null,M=null,A=null,b=null,T=null,E=null,y=null,w=new Zt(0,0,0),D=0,C=!1,L=null,F=null,W=null,I=null,z=null,K.set(0,0,s.canvas.width,s.canvas.height),pt.set(0,0,s.canvas.width,s.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ht,disable:It,bindFramebuffer:oe,drawBuffers:Ct,useProgram:qt,setBlending:pe,setMaterial:ve,setFlipSided:De,setCullFace:ae,setLineWidth:cn,setPolygonOffset:be,setScissorTest:Xe,activeTexture:ue,bindTexture:qe,unbindTexture:N,compressedTexImage2D:Oe,compressedTexImage3D:ne,texImage2D:v,texImage3D:k,pixelStorei:j,getParameter:nt,updateUBOMapping:Y,uniformBlockBinding:Z,texStorage2D:Lt,texStorage3D:S,texSubImage2D:jt,texSubImage3D:rt,compressedTexSubImage2D:de,compressedTexSubImage3D:Rt,scissor:ot,viewport:dt,reset:lt}}function Ib(s,t,e,n,i,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Jt,h=new WeakMap,d=new Set,u,f=new WeakMap,p=new Set,x=new FinalizationRegistry(S=>p.delete(S)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(S,v){return m?new OffscreenCanvas(S,v):dr("canvas")}function M(S,v,k){let nt=1,j=Lt(S);if((j.width>k||j.height>k)&&(nt=k/Math.max(j.width,j.height)),nt<1)if(typeof HTMLImageElement<"u"&&S instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&S instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&S instanceof ImageBitmap||typeof VideoFrame<"u"&&S instanceof VideoFrame){let ot=Math.floor(nt*j.width),dt=Math.floor(nt*j.height);u===void 0&&(u=g(ot,dt));let Y=v?g(ot,dt):u;return Y.width=ot,Y.height=dt,Y.getContext("2d").drawImage(S,0,0,ot,dt),Nt("WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+ot+"x"+dt+")."),Y}else return"data"in S&&Nt("WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),S;return S}function A(S){return S.generateMipmaps}function b(S){s.generateMipmap(S)}function T(S){return S.isWebGLCubeRenderTarget?s.TEXTURE_CUBE_MAP:S.isWebGL3DRenderTarget?s.TEXTURE_3D:S.isWebGLArrayRenderTarget||S.isCompressedArrayTexture?s.TEXTURE_2D_ARRAY:s.TEXTURE_2D}function E(S,v,k,nt,j,ot=!1){if(S!==null){if(s[S]!==void 0)return s[S];Nt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+S+"'")}let dt;nt&&(dt=t.get("EXT_texture_norm16"),dt||Nt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Y=v;if(v===s.RED&&(k===s.FLOAT&&(Y=s.R32F),k===s.HALF_FLOAT&&(Y=s.R16F),k===s.UNSIGNED_BYTE&&(Y=s.R8),k===s.UNSIGNED_SHORT&&dt&&(Y=dt.R16_EXT),k===s.SHORT&&dt&&(Y=dt.R16_SNORM_EXT)),v===s.RED_INTEGER&&(k===s.UNSIGNED_BYTE&&(Y=s.R8UI),k===s.UNSIGNED_SHORT&&(Y=s.R16UI),k===s.UNSIGNED_INT&&(Y=s.R32UI),k===s.BYTE&&(Y=s.R8I),k===s.SHORT&&(Y=s.R16I),k===s.INT&&(Y=s.R32I)),v===s.RG&&(k===s.FLOAT&&(Y=s.RG32F),k===s.HALF_FLOAT&&(Y=s.RG16F),k===s.UNSIGNED_BYTE&&(Y=s.RG8),k===s.UNSIGNED_SHORT&&dt&&(Y=dt.RG16_EXT),k===s.SHORT&&dt&&(Y=dt.RG16_SNORM_EXT)),v===s.RG_INTEGER&&(k===s.UNSIGNED_BYTE&&(Y=s.RG8UI),k===s.UNSIGNED_SHORT&&(Y=s.RG16UI),k===s.UNSIGNED_INT&&(Y=s.RG32UI),k===s.BYTE&&(Y=s.RG8I),k===s.SHORT&&(Y=s.RG16I),k===s.INT&&(Y=s.RG32I)),v===s.RGB_INTEGER&&(k===s.UNSIGNED_BYTE&&(Y=s.RGB8UI),k===s.UNSIGNED_SHORT&&(Y=s.RGB16UI),k===s.UNSIGNED_INT&&(Y=s.RGB32UI),k===s.BYTE&&(Y=s.RGB8I),k===s.SHORT&&(Y=s.RGB16I),k===s.INT&&(Y=s.RGB32I)),v===s.RGBA_INTEGER&&(k===s.UNSIGNED_BYTE&&(Y=s.RGBA8UI),k===s.UNSIGNED_SHORT&&(Y=s.RGBA16UI),k===s.UNSIGNED_INT&&(Y=s.RGBA32UI),k===s.BYTE&&(Y=s.RGBA8I),k===s.SHORT&&(Y=s.RGBA16I),k===s.INT&&(Y=s.RGBA32I)),v===s.RGB&&(k===s.UNSIGNED_SHORT&&dt&&(Y=dt.RGB16_EXT),k===s.SHORT&&dt&&(Y=dt.RGB16_SNORM_EXT),k===s.UNSIGNED_INT_5_9_9_9_REV&&(Y=s.RGB9_E5),k===s.UNSIGNED_INT_10F_11F_11F_REV&&(Y=s.R11F_G11F_B10F)),v===s.RGBA){let Z=ot?hr:Ht.getTransfer(j);k===s.FLOAT&&(Y=s.RGBA32F),k===s.HALF_FLOAT&&(Y=s.RGBA16F),k===s.UNSIGNED_BYTE&&(Y=Z===te?s.SRGB8_ALPHA8:s.RGBA8),k===s.UNSIGNED_SHORT&&dt&&(Y=dt.RGBA16_EXT),k===s.SHORT&&dt&&(Y=dt.RGBA16_SNORM_EXT),k===s.UNSIGNED_SHORT_4_4_4_4&&(Y=s.RGBA4),k===s.UNSIGNED_SHORT_5_5_5_1&&(Y=s.RGB5_A1)}return(Y===s.R16F||Y===s.R32F||Y===s.RG16F||Y===s.RG32F||Y===s.RGBA16F||Y===s.RGBA32F)&&t.get("EXT_color_buffer_float"),Y}function y(S,v){let k;return S?v===null||v===Tn||v===Ji?k=s.DEPTH24_STENCIL8:v===Cn?k=s.DEPTH32F_STENCIL8:v===Bs&&(k=s.DEPTH24_STENCIL8,Nt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===Tn||v===Ji?k=s.DEPTH_COMPONENT24:v===Cn?k=s.DEPTH_COMPONENT32F:v===Bs&&(k=s.DEPTH_COMPONENT16),k}function w(S,v){return A(S)===!0||S.isFramebufferTexture&&S.minFilter!==Le&&S.minFilter!==Ne?Math.log2(Math.max(v.width,v.height))+1:S.mipmaps.length>0?S.mipmaps.length:S.isCompressedTexture&&Array.isArray(S.image)?v.mipmaps.length:1}function D(S){let v=new WeakRef(S);n.get(S).__ref=v,p.add(v),x.register(S,v,v)}function C(S){let v=n.get(S).__ref;v!==void 0&&(p.delete(v),x.unregister(v))}function L(S){W(S.target)}function F(S){I(S.target)}function W(S){S.removeEventListener("dispose",L),C(S),q(S),S.isVideoTexture&&h.delete(S),S.isHTMLTexture&&d.delete(S)}function I(S){S.removeEventListener("dispose",F),C(S),tt(S)}function z(){for(let S of p){let v=S.deref();v!==void 0&&(v.isRenderTarget===!0?I(v):W(v))}p.clear(),d.clear()}function q(S){let v=n.get(S);if(v.__webglInit===void 0)return;let k=S.source,nt=f.get(k);if(nt){let j=nt[v.__cacheKey];j.usedTimes--,j.usedTimes===0&&G(S),Object.keys(nt).length===0&&f.delete(k)}n.remove(S)}function G(S){let v=n.get(S);s.deleteTexture(v.__webglTexture);let k=S.source,nt=f.get(k);delete nt[v.__cacheKey],o.memory.textures--}function tt(S){let v=n.get(S);v.__depthDisposeCallback&&v.__depthDisposeCallback();let k=S.depthTexture;if(k&&k.renderTarget===S&&W(k),S.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(v.__webglFramebuffer[j]))for(let ot=0;ot<v.__webglFramebuffer[j].length;ot++)s.deleteFramebuffer(v.__webglFramebuffer[j][ot]);else s.deleteFramebuffer(v.__webglFramebuffer[j]);v.__webglDepthbuffer&&s.deleteRenderbuffer(v.__webglDepthbuffer[j])}else{if(Array.isArray(v.__webglFramebuffer))for(let j=0;j<v.__webglFramebuffer.length;j++)s.deleteFramebuffer(v.__webglFramebuffer[j]);else s.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&s.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&s.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let j=0;j<v.__webglColorRenderbuffer.length;j++)v.__webglColorRenderbuffer[j]&&s.deleteRenderbuffer(v.__webglColorRenderbuffer[j]);v.__webglDepthRenderbuffer&&s.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let nt=S.textures;for(let j=0,ot=nt.length;j<ot;j++){let dt=n.get(nt[j]);dt.__webglTexture&&(s.deleteTexture(dt.__webglTexture),o.memory.textures--),n.remove(nt[j])}n.remove(S)}let X=0;function Q(){X=0}function et(){return X}function Mt(S){X=S}function Dt(){let S=X;return S>=i.maxTextures&&Nt("WebGLTextures: Trying to use "+(S+1)+" texture units while this GPU supports only "+i.maxTextures),X+=1,S}function K(S){let v=[];return v.push(S.wrapS),v.push(S.wrapT),v.push(S.wrapR||0),v.push(S.magFilter),v.push(S.minFilter),v.push(S.anisotropy),v.push(S.internalFormat),v.push(S.format),v.push(S.type),v.push(S.generateMipmaps),v.push(S.mipmapsAutoUpdate),v.push(S.premultiplyAlpha),v.push(S.flipY),v.push(S.unpackAlignment),v.push(S.colorSpace),v.join()}function pt(S,v){let k=n.get(S);if(S.isVideoTexture&&de(S),S.isRenderTargetTexture===!1&&S.isExternalTexture!==!0&&S.version>0&&k.__version!==S.version){let nt=S.image;if(nt===null)Nt("WebGLRenderer: Texture marked for update but no image data found.");else if(nt.complete===!1)Nt("WebGLRenderer: Texture marked for update but image is incomplete");else{ve(k,S,v);return}}else S.isExternalTexture&&(k.__webglTexture=S.sourceTexture?S.sourceTexture:null);e.bindTexture(s.TEXTURE_2D,k.__webglTexture,s.TEXTURE0+v)}function _t(S,v){let k=n.get(S);if(S.isRenderTargetTexture===!1&&S.version>0&&k.__version!==S.version){ve(k,S,v);return}else S.isExternalTexture&&(k.__webglTexture=S.sourceTexture?S.sourceTexture:null);e.bindTexture(s.TEXTURE_2D_ARRAY,k.__webglTexture,s.TEXTURE0+v)}function At(S,v){let k=n.get(S);if(S.isRenderTargetTexture===!1&&S.version>0&&k.__version!==S.version){ve(k,S,v);return}e.bindTexture(s.TEXTURE_3D,k.__webglTexture,s.TEXTURE0+v)}function ht(S,v){let k=n.get(S);if(S.version>0&&k.__version!==S.version){De(k,S,v);return}e.bindTexture(s.TEXTURE_CUBE_MAP,k.__webglTexture,s.TEXTURE0+v)}let It={[fa]:s.REPEAT,[kn]:s.CLAMP_TO_EDGE,[pa]:s.MIRRORED_REPEAT},oe={[Le]:s.NEAREST,[rp]:s.NEAREST_MIPMAP_NEAREST,[Ar]:s.NEAREST_MIPMAP_LINEAR,[Ne]:s.LINEAR,[za]:s.LINEAR_MIPMAP_NEAREST,[En]:s.LINEAR_MIPMAP_LINEAR},Ct={[cp]:s.NEVER,[Xh]:s.ALWAYS,[hp]:s.LESS,[Hh]:s.LEQUAL,[up]:s.EQUAL,[Wh]:s.GEQUAL,[dp]:s.GREATER,[fp]:s.NOTEQUAL};function qt(S,v){if(v.type===Cn&&t.has("OES_texture_float_linear")===!1&&(v.magFilter===Ne||v.magFilter===za||v.magFilter===Ar||v.magFilter===En||v.minFilter===Ne||v.minFilter===za||v.minFilter===Ar||v.minFilter===En)&&Nt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),s.texParameteri(S,s.TEXTURE_WRAP_S,It[v.wrapS]),s.texParameteri(S,s.TEXTURE_WRAP_T,It[v.wrapT]),(S===s.TEXTURE_3D||S===s.TEXTURE_2D_ARRAY)&&s.texParameteri(S,s.TEXTURE_WRAP_R,It[v.wrapR]),s.texParameteri(S,s.TEXTURE_MAG_FILTER,oe[v.magFilter]),s.texParameteri(S,s.TEXTURE_MIN_FILTER,oe[v.minFilter]),v.compareFunction&&(s.texParameteri(S,s.TEXTURE_COMPARE_MODE,s.COMPARE_REF_TO_TEXTURE),s.texParameteri(S,s.TEXTURE_COMPARE_FUNC,Ct[v.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===Le||v.minFilter!==Ar&&v.minFilter!==En||v.type===Cn&&t.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||n.get(v).__currentAnisotropy){let k=t.get("EXT_texture_filter_anisotropic");s.texParameterf(S,k.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,i.getMaxAnisotropy())),n.get(v).__currentAnisotropy=v.anisotropy}}}function Yt(S,v){let k=!1;S.__webglInit===void 0&&(S.__webglInit=!0,v.addEventListener("dispose",L),D(v));let nt=v.source,j=f.get(nt);j===void 0&&(j={},f.set(nt,j));let ot=K(v);if(ot!==S.__cacheKey){j[ot]===void 0&&(j[ot]={texture:s.createTexture(),usedTimes:0},o.memory.textures++,k=!0),j[ot].usedTimes++;let dt=j[S.__cacheKey];dt!==void 0&&(j[S.__cacheKey].usedTimes--,dt.usedTimes===0&&G(v)),S.__cacheKey=ot,S.__webglTexture=j[ot].texture}return k}function kt(S,v,k){return Math.floor(Math.floor(S/k)/v)}function pe(S,v,k,nt){let ot=S.updateRanges;if(ot.length===0)e.texSubImage2D(s.TEXTURE_2D,0,0,0,v.width,v.height,k,nt,v.data);else{ot.sort((R,J)=>R.start-J.start);let dt=0;for(let R=1;R<ot.length;R++){let J=ot[dt],$=ot[R],ct=J.start+J.count,st=kt($.start,v.width,4),at=kt(J.start,v.width,4);$.start<=ct+1&&st===at&&kt($.start+$.count-1,v.width,4)===st?J.count=Math.max(J.count,$.start+$.count-J.start):(++dt,ot[dt]=$)}ot.length=dt+1;let Y=e.getParameter(s.UNPACK_ROW_LENGTH),Z=e.getParameter(s.UNPACK_SKIP_PIXELS),lt=e.getParameter(s.UNPACK_SKIP_ROWS);e.pixelStorei(s.UNPACK_ROW_LENGTH,v.width);for(let R=0,J=ot.length;R<J;R++){let $=ot[R],ct=Math.floor($.start/4),st=Math.ceil($.count/4),at=ct%v.width,Tt=Math.floor(ct/v.width),zt=st,it=1;e.pixelStorei(s.UNPACK_SKIP_PIXELS,at),e.pixelStorei(s.UNPACK_SKIP_ROWS,Tt),e.texSubImage2D(s.TEXTURE_2D,0,at,Tt,zt,it,k,nt,v.data)}S.clearUpdateRanges(),e.pixelStorei(s.UNPACK_ROW_LENGTH,Y),e.pixelStorei(s.UNPACK_SKIP_PIXELS,Z),e.pixelStorei(s.UNPACK_SKIP_ROWS,lt)}}function ve(S,v,k){let nt=s.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(nt=s.TEXTURE_2D_ARRAY),v.isData3DTexture&&(nt=s.TEXTURE_3D);let j=Yt(S,v),ot=v.source;e.bindTexture(nt,S.__webglTexture,s.TEXTURE0+k);let dt=n.get(ot);if(ot.version!==dt.__version||j===!0){if(e.activeTexture(s.TEXTURE0+k),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let it=Ht.getPrimaries(Ht.workingColorSpace),Pt=v.colorSpace===li?null:Ht.getPrimaries(v.colorSpace),Bt=v.colorSpace===li||it===Pt?s.NONE:s.BROWSER_DEFAULT_WEBGL;e.pixelStorei(s.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(s.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(s.UNPACK_COLORSPACE_CONVERSION_WEBGL,Bt)}e.pixelStorei(s.UNPACK_ALIGNMENT,v.unpackAlignment);let Z=M(v.image,!1,i.maxTextureSize);Z=Rt(v,Z);let lt=r.convert(v.format,v.colorSpace),R=r.convert(v.type),J=E(v.internalFormat,lt,R,v.normalized,v.colorSpace,v.isVideoTexture);qt(nt,v);let $,ct=v.mipmaps,st=v.isVideoTexture!==!0,at=dt.__version===void 0||j===!0,Tt=ot.dataReady,zt=w(v,Z);if(v.isDepthTexture)J=y(v.format===ai,v.type),at&&(st?e.texStorage2D(s.TEXTURE_2D,1,J,Z.width,Z.height):e.texImage2D(s.TEXTURE_2D,0,J,Z.width,Z.height,0,lt,R,null));else if(v.isDataTexture)if(ct.length>0){st&&at&&e.texStorage2D(s.TEXTURE_2D,zt,J,ct[0].width,ct[0].height);for(let it=0,Pt=ct.length;it<Pt;it++)$=ct[it],st?Tt&&e.texSubImage2D(s.TEXTURE_2D,it,0,0,$.width,$.height,lt,R,$.data):e.texImage2D(s.TEXTURE_2D,it,J,$.width,$.height,0,lt,R,$.data);v.generateMipmaps=!1}else st?(at&&e.texStorage2D(s.TEXTURE_2D,zt,J,Z.width,Z.height),Tt&&pe(v,Z,lt,R)):e.texImage2D(s.TEXTURE_2D,0,J,Z.width,Z.height,0,lt,R,Z.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){st&&at&&e.texStorage3D(s.TEXTURE_2D_ARRAY,zt,J,ct[0].width,ct[0].height,Z.depth);for(let it=0,Pt=ct.length;it<Pt;it++)if($=ct[it],v.format!==In)if(lt!==null)if(st){if(Tt)if(v.layerUpdates.size>0){let Bt=Qh($.width,$.height,v.format,v.type);for(let mt of v.layerUpdates){let ee=$.data.subarray(mt*Bt/$.data.BYTES_PER_ELEMENT,(mt+1)*Bt/$.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(s.TEXTURE_2D_ARRAY,it,0,0,mt,$.width,$.height,1,lt,ee)}}else e.compressedTexSubImage3D(s.TEXTURE_2D_ARRAY,it,0,0,0,$.width,$.height,Z.depth,lt,$.data)}else e.compressedTexImage3D(s.TEXTURE_2D_ARRAY,it,J,$.width,$.height,Z.depth,0,$.data,0,0);else Nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else st?Tt&&e.texSubImage3D(s.TEXTURE_2D_ARRAY,it,0,0,0,$.width,$.height,Z.depth,lt,R,$.data):e.texImage3D(s.TEXTURE_2D_ARRAY,it,J,$.width,$.height,Z.depth,0,lt,R,$.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{st&&at&&e.texStorage2D(s.TEXTURE_2D,zt,J,ct[0].width,ct[0].height);for(let it=0,Pt=ct.length;it<Pt;it++)$=ct[it],v.format!==In?lt!==null?st?Tt&&e.compressedTexSubImage2D(s.TEXTURE_2D,it,0,0,$.width,$.height,lt,$.data):e.compressedTexImage2D(s.TEXTURE_2D,it,J,$.width,$.height,0,$.data):Nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):st?Tt&&e.texSubImage2D(s.TEXTURE_2D,it,0,0,$.width,$.height,lt,R,$.data):e.texImage2D(s.TEXTURE_2D,it,J,$.width,$.height,0,lt,R,$.data)}else if(v.isDataArrayTexture)if(st){if(at&&e.texStorage3D(s.TEXTURE_2D_ARRAY,zt,J,Z.width,Z.height,Z.depth),Tt)if(v.layerUpdates.size>0){let it=Qh(Z.width,Z.height,v.format,v.type);for(let Pt of v.layerUpdates){let Bt=Z.data.subarray(Pt*it/Z.data.BYTES_PER_ELEMENT,(Pt+1)*it/Z.data.BYTES_PER_ELEMENT);e.texSubImage3D(s.TEXTURE_2D_ARRAY,0,0,0,Pt,Z.width,Z.height,1,lt,R,Bt)}v.clearLayerUpdates()}else e.texSubImage3D(s.TEXTURE_2D_ARRAY,0,0,0,0,Z.width,Z.height,Z.depth,lt,R,Z.data)}else e.texImage3D(s.TEXTURE_2D_ARRAY,0,J,Z.width,Z.height,Z.depth,0,lt,R,Z.data);else if(v.isData3DTexture)st?(at&&e.texStorage3D(s.TEXTURE_3D,zt,J,Z.width,Z.height,Z.depth),Tt&&e.texSubImage3D(s.TEXTURE_3D,0,0,0,0,Z.width,Z.height,Z.depth,lt,R,Z.data)):e.texImage3D(s.TEXTURE_3D,0,J,Z.width,Z.height,Z.depth,0,lt,R,Z.data);else if(v.isFramebufferTexture){if(at)if(st)e.texStorage2D(s.TEXTURE_2D,zt,J,Z.width,Z.height);else{let it=Z.width,Pt=Z.height;for(let Bt=0;Bt<zt;Bt++)e.texImage2D(s.TEXTURE_2D,Bt,J,it,Pt,0,lt,R,null),it>>=1,Pt>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in s){let it=s.canvas;if(it.hasAttribute("layoutsubtree")||it.setAttribute("layoutsubtree","true"),Z.parentNode!==it){it.appendChild(Z),d.add(v),it.onpaint=Pt=>{let Bt=Pt.changedElements;for(let mt of d)Bt.includes(mt.image)&&(mt.needsUpdate=!0)},it.requestPaint();return}if(s.texElementImage2D.length===3)s.texElementImage2D(s.TEXTURE_2D,s.RGBA8,Z);else{let Bt=s.RGBA,mt=s.RGBA,ee=s.UNSIGNED_BYTE;s.texElementImage2D(s.TEXTURE_2D,0,Bt,mt,ee,Z)}s.texParameteri(s.TEXTURE_2D,s.TEXTURE_MIN_FILTER,s.LINEAR),s.texParameteri(s.TEXTURE_2D,s.TEXTURE_WRAP_S,s.CLAMP_TO_EDGE),s.texParameteri(s.TEXTURE_2D,s.TEXTURE_WRAP_T,s.CLAMP_TO_EDGE)}}else if(ct.length>0){if(st&&at){let it=Lt(ct[0]);e.texStorage2D(s.TEXTURE_2D,zt,J,it.width,it.height)}for(let it=0,Pt=ct.length;it<Pt;it++)$=ct[it],st?Tt&&e.texSubImage2D(s.TEXTURE_2D,it,0,0,lt,R,$):e.texImage2D(s.TEXTURE_2D,it,J,lt,R,$);v.generateMipmaps=!1}else if(st){if(at){let it=Lt(Z);e.texStorage2D(s.TEXTURE_2D,zt,J,it.width,it.height)}Tt&&e.texSubImage2D(s.TEXTURE_2D,0,0,0,lt,R,Z)}else e.texImage2D(s.TEXTURE_2D,0,J,lt,R,Z);A(v)&&v.mipmapsAutoUpdate===!0&&b(nt),dt.__version=ot.version,v.onUpdate&&v.onUpdate(v)}S.__version=v.version}function De(S,v,k){if(v.image.length!==6)return;let nt=Yt(S,v),j=v.source;e.bindTexture(s.TEXTURE_CUBE_MAP,S.__webglTexture,s.TEXTURE0+k);let ot=n.get(j);if(j.version!==ot.__version||nt===!0){e.activeTexture(s.TEXTURE0+k);let dt=Ht.getPrimaries(Ht.workingColorSpace),Y=v.colorSpace===li?null:Ht.getPrimaries(v.colorSpace),Z=v.colorSpace===li||dt===Y?s.NONE:s.BROWSER_DEFAULT_WEBGL;e.pixelStorei(s.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(s.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(s.UNPACK_ALIGNMENT,v.unpackAlignment),e.pixelStorei(s.UNPACK_COLORSPACE_CONVERSION_WEBGL,Z);let lt=v.isCompressedTexture||v.image[0].isCompressedTexture,R=v.image[0]&&v.image[0].isDataTexture,J=[];for(let mt=0;mt<6;mt++)!lt&&!R?J[mt]=M(v.image[mt],!0,i.maxCubemapSize):J[mt]=R?v.image[mt].image:v.image[mt],J[mt]=Rt(v,J[mt]);let $=J[0],ct=r.convert(v.format,v.colorSpace),st=r.convert(v.type),at=E(v.internalFormat,ct,st,v.normalized,v.colorSpace),Tt=v.isVideoTexture!==!0,zt=ot.__version===void 0||nt===!0,it=j.dataReady,Pt=w(v,$);qt(s.TEXTURE_CUBE_MAP,v);let Bt;if(v.isDepthTexture){if(at=y(v.format===ai,v.type),zt)if(Tt)e.texStorage2D(s.TEXTURE_CUBE_MAP,1,at,$.width,$.height);else for(let mt=0;mt<6;mt++)e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,at,$.width,$.height,0,ct,st,null)}else if(lt){Tt&&zt&&e.texStorage2D(s.TEXTURE_CUBE_MAP,Pt,at,$.width,$.height);for(let mt=0;mt<6;mt++){Bt=J[mt].mipmaps;for(let ee=0;ee<Bt.length;ee++){let Re=Bt[ee];v.format!==In?ct!==null?Tt?it&&e.compressedTexSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ee,0,0,Re.width,Re.height,ct,Re.data):e.compressedTexImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ee,at,Re.width,Re.height,0,Re.data):Nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Tt?it&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ee,0,0,Re.width,Re.height,ct,st,Re.data):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ee,at,Re.width,Re.height,0,ct,st,Re.data)}}}else{if(Bt=v.mipmaps,Tt&&zt){Bt.length>0&&Pt++;let mt=Lt(J[0]);e.texStorage2D(s.TEXTURE_CUBE_MAP,Pt,at,mt.width,mt.height)}for(let mt=0;mt<6;mt++)if(R){Tt?it&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,0,0,J[mt].width,J[mt].height,ct,st,J[mt].data):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,at,J[mt].width,J[mt].height,0,ct,st,J[mt].data);for(let ee=0;ee<Bt.length;ee++){let ci=Bt[ee].image[mt].image;Tt?it&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ee+1,0,0,ci.width,ci.height,ct,st,ci.data):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ee+1,at,ci.width,ci.height,0,ct,st,ci.data)}}else{Tt?it&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,0,0,ct,st,J[mt]):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,at,ct,st,J[mt]);for(let ee=0;ee<Bt.length;ee++){let Re=Bt[ee];Tt?it&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ee+1,0,0,ct,st,Re.image[mt]):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ee+1,at,ct,st,Re.image[mt])}}}A(v)&&v.mipmapsAutoUpdate===!0&&b(s.TEXTURE_CUBE_MAP),ot.__version=j.version,v.onUpdate&&v.onUpdate(v)}S.__version=v.version}function ae(S,v,k,nt,j,ot){let dt=r.convert(k.format,k.colorSpace),Y=r.convert(k.type),Z=E(k.internalFormat,dt,Y,k.normalized,k.colorSpace),lt=n.get(v),R=n.get(k);if(R.__renderTarget=v,!lt.__hasExternalTextures){let J=Math.max(1,v.width>>ot),$=Math.max(1,v.height>>ot);j===s.TEXTURE_3D||j===s.TEXTURE_2D_ARRAY?e.texImage3D(j,ot,Z,J,$,v.depth,0,dt,Y,null):e.texImage2D(j,ot,Z,J,$,0,dt,Y,null)}e.bindFramebuffer(s.FRAMEBUFFER,S),rt(v)?a.framebufferTexture2DMultisampleEXT(s.FRAMEBUFFER,nt,j,R.__webglTexture,0,jt(v)):(j===s.TEXTURE_2D||j>=s.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=s.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&s.framebufferTexture2D(s.FRAMEBUFFER,nt,j,R.__webglTexture,ot),e.bindFramebuffer(s.FRAMEBUFFER,null)}function cn(S,v,k){if(s.bindRenderbuffer(s.RENDERBUFFER,S),v.depthBuffer){let nt=v.depthTexture,j=nt&&nt.isDepthTexture?nt.type:null,ot=y(v.stencilBuffer,j),dt=v.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT;rt(v)?a.renderbufferStorageMultisampleEXT(s.RENDERBUFFER,jt(v),ot,v.width,v.height):k?s.renderbufferStorageMultisample(s.RENDERBUFFER,jt(v),ot,v.width,v.height):s.renderbufferStorage(s.RENDERBUFFER,ot,v.width,v.height),s.framebufferRenderbuffer(s.FRAMEBUFFER,dt,s.RENDERBUFFER,S)}else{let nt=v.textures;for(let j=0;j<nt.length;j++){let ot=nt[j],dt=r.convert(ot.format,ot.colorSpace),Y=r.convert(ot.type),Z=E(ot.internalFormat,dt,Y,ot.normalized,ot.colorSpace);rt(v)?a.renderbufferStorageMultisampleEXT(s.RENDERBUFFER,jt(v),Z,v.width,v.height):k?s.renderbufferStorageMultisample(s.RENDERBUFFER,jt(v),Z,v.width,v.height):s.renderbufferStorage(s.RENDERBUFFER,Z,v.width,v.height)}}s.bindRenderbuffer(s.RENDERBUFFER,null)}function be(S,v,k){let nt=v.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(s.FRAMEBUFFER,S),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let j=n.get(v.depthTexture);j.__renderTarget=v;let ot=nt?v.depthTexture.image[0]:v.depthTexture.image;(!j.__webglTexture||ot.width!==v.width||ot.height!==v.height)&&(ot.width=v.width,ot.height=v.height,v.depthTexture.needsUpdate=!0),nt?ht(v.depthTexture,0):pt(v.depthTexture,0);let dt=j.__webglTexture,Y=jt(v),Z=nt?s.TEXTURE_CUBE_MAP_POSITIVE_X+k:s.TEXTURE_2D,lt=v.depthTexture.format===ai?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT;if(v.depthTexture.format===ri)rt(v)?a.framebufferTexture2DMultisampleEXT(s.FRAMEBUFFER,lt,Z,dt,0,Y):s.framebufferTexture2D(s.FRAMEBUFFER,lt,Z,dt,0);else if(v.depthTexture.format===ai)rt(v)?a.framebufferTexture2DMultisampleEXT(s.FRAMEBUFFER,lt,Z,dt,0,Y):s.framebufferTexture2D(s.FRAMEBUFFER,lt,Z,dt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Xe(S){let v=n.get(S),k=S.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==S.depthTexture){let nt=S.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),nt){let j=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,nt.removeEventListener("dispose",j)};nt.addEventListener("dispose",j),v.__depthDisposeCallback=j}v.__boundDepthTexture=nt}if(S.depthTexture&&!v.__autoAllocateDepthBuffer)if(k)for(let nt=0;nt<6;nt++)be(v.__webglFramebuffer[nt],S,nt);else S.texture.mipmaps.length>0?be(v.__webglFramebuffer[0],S,0):be(v.__webglFramebuffer,S,0);else if(k){v.__webglDepthbuffer=[];for(let nt=0;nt<6;nt++)if(e.bindFramebuffer(s.FRAMEBUFFER,v.__webglFramebuffer[nt]),v.__webglDepthbuffer[nt]===void 0)v.__webglDepthbuffer[nt]=s.createRenderbuffer(),cn(v.__webglDepthbuffer[nt],S,!1);else{let j=S.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT,ot=v.__webglDepthbuffer[nt];s.bindRenderbuffer(s.RENDERBUFFER,ot),s.framebufferRenderbuffer(s.FRAMEBUFFER,j,s.RENDERBUFFER,ot)}}else if(S.texture.mipmaps.length>0?e.bindFramebuffer(s.FRAMEBUFFER,v.__webglFramebuffer[0]):e.bindFramebuffer(s.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=s.createRenderbuffer(),cn(v.__webglDepthbuffer,S,!1);else{let j=S.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT,ot=v.__webglDepthbuffer;s.bindRenderbuffer(s.RENDERBUFFER,ot),s.framebufferRenderbuffer(s.FRAMEBUFFER,j,s.RENDERBUFFER,ot)}e.bindFramebuffer(s.FRAMEBUFFER,null)}function ue(S,v,k){let nt=n.get(S);v!==void 0&&ae(nt.__webglFramebuffer,S,S.texture,s.COLOR_ATTACHMENT0,s.TEXTURE_2D,0),k!==void 0&&Xe(S)}function qe(S){let v=S.texture,k=n.get(S),nt=n.get(v);S.addEventListener("dispose",F),D(S);let j=S.textures,ot=S.isWebGLCubeRenderTarget===!0,dt=j.length>1;if(dt||(nt.__webglTexture===void 0&&(nt.__webglTexture=s.createTexture()),nt.__version=v.version,o.memory.textures++),ot){k.__webglFramebuffer=[];for(let Y=0;Y<6;Y++)if(v.mipmaps.length>0){k.__webglFramebuffer[Y]=[];for(let Z=0;Z<v.mipmaps.length;Z++)k.__webglFramebuffer[Y][Z]=s.createFramebuffer()}else k.__webglFramebuffer[Y]=s.createFramebuffer()}else{if(v.mipmaps.length>0){k.__webglFramebuffer=[];for(let Y=0;Y<v.mipmaps.length;Y++)k.__webglFramebuffer[Y]=s.createFramebuffer()}else k.__webglFramebuffer=s.createFramebuffer();if(dt)for(let Y=0,Z=j.length;Y<Z;Y++){let lt=n.get(j[Y]);lt.__webglTexture===void 0&&(lt.__webglTexture=s.createTexture(),o.memory.textures++)}if(S.samples>0&&rt(S)===!1){k.__webglMultisampledFramebuffer=s.createFramebuffer(),k.__webglColorRenderbuffer=[],e.bindFramebuffer(s.FRAMEBUFFER,k.__webglMultisampledFramebuffer);for(let Y=0;Y<j.length;Y++){let Z=j[Y];k.__webglColorRenderbuffer[Y]=s.createRenderbuffer(),s.bindRenderbuffer(s.RENDERBUFFER,k.__webglColorRenderbuffer[Y]);let lt=r.convert(Z.format,Z.colorSpace),R=r.convert(Z.type),J=E(Z.internalFormat,lt,R,Z.normalized,Z.colorSpace,S.isXRRenderTarget===!0),$=jt(S);s.renderbufferStorageMultisample(s.RENDERBUFFER,$,J,S.width,S.height),s.framebufferRenderbuffer(s.FRAMEBUFFER,s.COLOR_ATTACHMENT0+Y,s.RENDERBUFFER,k.__webglColorRenderbuffer[Y])}s.bindRenderbuffer(s.RENDERBUFFER,null),S.depthBuffer&&(k.__webglDepthRenderbuffer=s.createRenderbuffer(),cn(k.__webglDepthRenderbuffer,S,!0)),e.bindFramebuffer(s.FRAMEBUFFER,null)}}if(ot){e.bindTexture(s.TEXTURE_CUBE_MAP,nt.__webglTexture),qt(s.TEXTURE_CUBE_MAP,v);for(let Y=0;Y<6;Y++)if(v.mipmaps.length>0)for(let Z=0;Z<v.mipmaps.length;Z++)ae(k.__webglFramebuffer[Y][Z],S,v,s.COLOR_ATTACHMENT0,s.TEXTURE_CUBE_MAP_POSITIVE_X+Y,Z);else ae(k.__webglFramebuffer[Y],S,v,s.COLOR_ATTACHMENT0,s.TEXTURE_CUBE_MAP_POSITIVE_X+Y,0);A(v)?b(s.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&s.texParameteri(s.TEXTURE_CUBE_MAP,s.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}else if(dt){for(let Y=0,Z=j.length;Y<Z;Y++){let lt=j[Y],R=n.get(lt),J=s.TEXTURE_2D;(S.isWebGL3DRenderTarget||S.isWebGLArrayRenderTarget)&&(J=S.isWebGL3DRenderTarget?s.TEXTURE_3D:s.TEXTURE_2D_ARRAY),e.bindTexture(J,R.__webglTexture),qt(J,lt),ae(k.__webglFramebuffer,S,lt,s.COLOR_ATTACHMENT0+Y,J,0),A(lt)&&b(J)}e.unbindTexture()}else{let Y=s.TEXTURE_2D;if((S.isWebGL3DRenderTarget||S.isWebGLArrayRenderTarget)&&(Y=S.isWebGL3DRenderTarget?s.TEXTURE_3D:s.TEXTURE_2D_ARRAY),e.bindTexture(Y,nt.__webglTexture),qt(Y,v),v.mipmaps.length>0)for(let Z=0;Z<v.mipmaps.length;Z++)ae(k.__webglFramebuffer[Z],S,v,s.COLOR_ATTACHMENT0,Y,Z);else ae(k.__webglFramebuffer,S,v,s.COLOR_ATTACHMENT0,Y,0);A(v)?b(Y):v.mipmaps.length>0&&s.texParameteri(Y,s.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}S.depthBuffer&&Xe(S)}function N(S){let v=S.textures;for(let k=0,nt=v.length;k<nt;k++){let j=v[k];if(A(j)&&j.mipmapsAutoUpdate===!0){let ot=T(S),dt=n.get(j).__webglTexture;e.bindTexture(ot,dt),b(ot),e.unbindTexture()}}}let Oe=[];function ne(S){if(S.samples>0){if(rt(S)===!1){let v=S.textures,k=S.width,nt=S.height,j=s.COLOR_BUFFER_BIT,ot=S.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT,dt=n.get(S),Y=v.length>1;if(Y)for(let lt=0;lt<v.length;lt++)e.bindFramebuffer(s.FRAMEBUFFER,dt.__webglMultisampledFramebuffer),s.framebufferRenderbuffer(s.FRAMEBUFFER,s.COLOR_ATTACHMENT0+lt,s.RENDERBUFFER,null),e.bindFramebuffer(s.FRAMEBUFFER,dt.__webglFramebuffer),s.framebufferTexture2D(s.DRAW_FRAMEBUFFER,s.COLOR_ATTACHMENT0+lt,s.TEXTURE_2D,null,0);e.bindFramebuffer(s.READ_FRAMEBUFFER,dt.__webglMultisampledFramebuffer),S.texture.mipmaps.length>0?e.bindFramebuffer(s.DRAW_FRAMEBUFFER,dt.__webglFramebuffer[0]):e.bindFramebuffer(s.DRAW_FRAMEBUFFER,dt.__webglFramebuffer);for(let lt=0;lt<v.length;lt++){if(S.resolveDepthBuffer&&(S.depthBuffer&&(j|=s.DEPTH_BUFFER_BIT),S.stencilBuffer&&S.resolveStencilBuffer&&(j|=s.STENCIL_BUFFER_BIT)),Y){s.framebufferRenderbuffer(s.READ_FRAMEBUFFER,s.COLOR_ATTACHMENT0,s.RENDERBUFFER,dt.__webglColorRenderbuffer[lt]);let R=n.get(v[lt]).__webglTexture;s.framebufferTexture2D(s.DRAW_FRAMEBUFFER,s.COLOR_ATTACHMENT0,s.TEXTURE_2D,R,0)}s.blitFramebuffer(0,0,k,nt,0,0,k,nt,j,s.NEAREST),l===!0&&(Oe.length=0,Oe.push(s.COLOR_ATTACHMENT0+lt),S.depthBuffer&&S.storeMultisampledDepthBuffer===!1&&Oe.push(ot),s.invalidateFramebuffer(s.READ_FRAMEBUFFER,Oe))}if(e.bindFramebuffer(s.READ_FRAMEBUFFER,null),e.bindFramebuffer(s.DRAW_FRAMEBUFFER,null),Y)for(let lt=0;lt<v.length;lt++){e.bindFramebuffer(s.FRAMEBUFFER,dt.__webglMultisampledFramebuffer),s.framebufferRenderbuffer(s.FRAMEBUFFER,s.COLOR_ATTACHMENT0+lt,s.RENDERBUFFER,dt.__webglColorRenderbuffer[lt]);let R=n.get(v[lt]).__webglTexture;e.bindFramebuffer(s.FRAMEBUFFER,dt.__webglFramebuffer),s.framebufferTexture2D(s.DRAW_FRAMEBUFFER,s.COLOR_ATTACHMENT0+lt,s.TEXTURE_2D,R,0)}e.bindFramebuffer(s.DRAW_FRAMEBUFFER,dt.__webglMultisampledFramebuffer)}else if(S.depthBuffer&&S.storeMultisampledDepthBuffer===!1&&l){let v=S.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT;s.invalidateFramebuffer(s.DRAW_FRAMEBUFFER,[v])}}}function jt(S){return Math.min(i.maxSamples,S.samples)}function rt(S){let v=n.get(S);return S.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function de(S){let v=o.render.frame;h.get(S)!==v&&(h.set(S,v),S.update())}function Rt(S,v){let k=S.colorSpace,nt=S.format,j=S.type;return S.isCompressedTexture===!0||S.isVideoTexture===!0||k!==Wi&&k!==li&&(Ht.getTransfer(k)===te?(nt!==In||j!==ln)&&Nt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ot("WebGLTextures: Unsupported texture color space:",k)),v}function Lt(S){return typeof HTMLImageElement<"u"&&S instanceof HTMLImageElement?(c.width=S.naturalWidth||S.width,c.height=S.naturalHeight||S.height):typeof VideoFrame<"u"&&S instanceof VideoFrame?(c.width=S.displayWidth,c.height=S.displayHeight):(c.width=S.width,c.height=S.height),c}this.allocateTextureUnit=Dt,this.resetTextureUnits=Q,this.getTextureUnits=et,this.setTextureUnits=Mt,this.setTexture2D=pt,this.setTexture2DArray=_t,this.setTexture3D=At,this.setTextureCube=ht,this.rebindTextures=ue,this.setupRenderTarget=qe,this.updateRenderTargetMipmap=N,this.updateMultisampleRenderTarget=ne,this.setupDepthRenderbuffer=Xe,this.setupFrameBufferTexture=ae,this.useMultisampledRTT=rt,this.dispose=z}function Pb(s,t){function e(n,i=li){let r,o=Ht.getTransfer(i);if(n===ln)return s.UNSIGNED_BYTE;if(n===Va)return s.UNSIGNED_SHORT_4_4_4_4;if(n===Ha)return s.UNSIGNED_SHORT_5_5_5_1;if(n===Uh)return s.UNSIGNED_INT_5_9_9_9_REV;if(n===kh)return s.UNSIGNED_INT_10F_11F_11F_REV;if(n===Oh)return s.BYTE;if(n===Fh)return s.SHORT;if(n===Bs)return s.UNSIGNED_SHORT;if(n===Ga)return s.INT;if(n===Tn)return s.UNSIGNED_INT;if(n===Cn)return s.FLOAT;if(n===Rn)return s.HALF_FLOAT;if(n===Bh)return s.ALPHA;if(n===zh)return s.RGB;if(n===In)return s.RGBA;if(n===ri)return s.DEPTH_COMPONENT;if(n===ai)return s.DEPTH_STENCIL;if(n===Gh)return s.RED;if(n===Wa)return s.RED_INTEGER;if(n===Pi)return s.RG;if(n===Xa)return s.RG_INTEGER;if(n===qa)return s.RGBA_INTEGER;if(n===Er||n===Tr||n===Cr||n===Rr)if(o===te)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Er)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Tr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Cr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Rr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Er)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Tr)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Cr)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Rr)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===$a||n===Ya||n===Ka||n===Za)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===$a)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Ya)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Ka)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Za)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Ja||n===ja||n===Qa||n===tl||n===el||n===Ir||n===nl)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Ja||n===ja)return o===te?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Qa)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===tl)return r.COMPRESSED_R11_EAC;if(n===el)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ir)return r.COMPRESSED_RG11_EAC;if(n===nl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===il||n===sl||n===rl||n===ol||n===al||n===ll||n===cl||n===hl||n===ul||n===dl||n===fl||n===pl||n===ml||n===gl)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===il)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===sl)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===rl)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===ol)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===al)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===ll)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===cl)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===hl)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ul)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===dl)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===fl)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===pl)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===ml)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===gl)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===xl||n===yl||n===vl)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===xl)return o===te?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===yl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===vl)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===_l||n===Ml||n===Pr||n===bl)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===_l)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Ml)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Pr)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===bl)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Ji?s.UNSIGNED_INT_24_8:s[n]!==void 0?s[n]:null}return{convert:e}}var Lb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Nb=`
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

}`,lu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new _r(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new xn({vertexShader:Lb,fragmentShader:Nb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new gn(new Mr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},cu=class extends Bn{constructor(t,e){super();let n=this,i=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new lu,g={},M=e.getContextAttributes(),A=null,b=null,T=[],E=[],y=new Jt,w=null,D=null,C=new Ke;C.viewport=new ye;let L=new Ke;L.viewport=new ye;let F=[C,L],W=new Ua,I=null,z=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let pt=T[K];return pt===void 0&&(pt=new Ls,T[K]=pt),pt.getTargetRaySpace()},this.getControllerGrip=function(K){let pt=T[K];return pt===void 0&&(pt=new Ls,T[K]=pt),pt.getGripSpace()},this.getHand=function(K){let pt=T[K];return pt===void 0&&(pt=new Ls,T[K]=pt),pt.getHandSpace()};function q(K){let pt=E.indexOf(K.inputSource);if(pt===-1)return;let _t=T[pt];_t!==void 0&&(_t.update(K.inputSource,K.frame,c||o),_t.dispatchEvent({type:K.type,data:K.inputSource}))}function G(){i.removeEventListener("select",q),i.removeEventListener("selectstart",q),i.removeEventListener("selectend",q),i.removeEventListener("squeeze",q),i.removeEventListener("squeezestart",q),i.removeEventListener("squeezeend",q),i.removeEventListener("end",G),i.removeEventListener("inputsourceschange",tt);for(let K=0;K<T.length;K++){let pt=E[K];pt!==null&&(E[K]=null,T[K].disconnect(pt))}I=null,z=null,m.reset();for(let K in g)delete g[K];if(t.setRenderTarget(A),f=null,u=null,d=null,i=null,b=null,Dt.stop(),n.isPresenting=!1,t.setPixelRatio(w),t.setSize(y.width,y.height,!1),D!==null){let K=D.camera;K.fov=D.fov,K.zoom=D.zoom,K.updateProjectionMatrix(),D=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){r=K,n.isPresenting===!0&&Nt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){a=K,n.isPresenting===!0&&Nt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(K){c=K},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d===null&&x&&(d=new XRWebGLBinding(i,e)),d},this.getFrame=function(){return p},this.getSession=function(){return i},this.setSession=async function(K){if(i=K,i!==null){if(A=t.getRenderTarget(),i.addEventListener("select",q),i.addEventListener("selectstart",q),i.addEventListener("selectend",q),i.addEventListener("squeeze",q),i.addEventListener("squeezestart",q),i.addEventListener("squeezeend",q),i.addEventListener("end",G),i.addEventListener("inputsourceschange",tt),M.xrCompatible!==!0&&await e.makeXRCompatible(),w=t.getPixelRatio(),t.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let _t=null,At=null,ht=null;M.depth&&(ht=M.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,_t=M.stencil?ai:ri,At=M.stencil?Ji:Tn);let It={colorFormat:e.RGBA8,depthFormat:ht,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(It),i.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),b=new on(u.textureWidth,u.textureHeight,{format:In,type:ln,depthTexture:new oi(u.textureWidth,u.textureHeight,At,void 0,void 0,void 0,void 0,void 0,void 0,_t),stencilBuffer:M.stencil,colorSpace:t.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let _t={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(i,e,_t),i.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new on(f.framebufferWidth,f.framebufferHeight,{format:In,type:ln,colorSpace:t.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await i.requestReferenceSpace(a),Dt.setContext(i),Dt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(i!==null)return i.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function tt(K){for(let pt=0;pt<K.removed.length;pt++){let _t=K.removed[pt],At=E.indexOf(_t);At>=0&&(E[At]=null,T[At].disconnect(_t))}for(let pt=0;pt<K.added.length;pt++){let _t=K.added[pt],At=E.indexOf(_t);if(At===-1){for(let It=0;It<T.length;It++)if(It>=E.length){E.push(_t),At=It;break}else if(E[It]===null){E[It]=_t,At=It;break}if(At===-1)break}let ht=T[At];ht&&ht.connect(_t)}}function X(K,pt){pt===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(pt.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(i===null)return;let pt=K.near,_t=K.far;m.texture!==null&&(m.depthNear>0&&(pt=m.depthNear),m.depthFar>0&&(_t=m.depthFar)),W.near=L.near=C.near=pt,W.far=L.far=C.far=_t,(I!==W.near||z!==W.far)&&(i.updateRenderState({depthNear:W.near,depthFar:W.far}),I=W.near,z=W.far),W.layers.mask=K.layers.mask|6,C.layers.mask=W.layers.mask&-5,L.layers.mask=W.layers.mask&-3;let At=K.parent,ht=W.cameras;X(W,At);for(let It=0;It<ht.length;It++)X(ht[It],At);W.projectionMatrix.copy(C.projectionMatrix),W.projectionMatrixInverse.copy(C.projectionMatrixInverse),D===null&&K.isPerspectiveCamera&&(D={camera:K,fov:K.fov,zoom:K.zoom}),Q(K,W,At)};function Q(K,pt,_t){_t===null?K.matrix.copy(pt.matrixWorld):(K.matrix.copy(_t.matrixWorld),K.matrix.invert(),K.matrix.multiply(pt.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(pt.projectionMatrix),K.projectionMatrixInverse.copy(pt.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=ga*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function(K){l=K,u!==null&&(u.fixedFoveation=K),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=K)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(W)},this.getCameraTexture=function(K){return g[K]};let et=null;function Mt(K,pt){if(h=pt.getViewerPose(c||o),p=pt,h!==null){let _t=h.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let At=!1;_t.length!==W.cameras.length&&(W.cameras.length=0,At=!0);for(let Ct=0;Ct<_t.length;Ct++){let qt=_t[Ct],Yt=null;if(f!==null)Yt=f.getViewport(qt);else{let pe=d.getViewSubImage(u,qt);Yt=pe.viewport,Ct===0&&(t.setRenderTargetTextures(b,pe.colorTexture,pe.depthStencilTexture),t.setRenderTarget(b))}let kt=F[Ct];kt===void 0&&(kt=new Ke,kt.layers.enable(Ct),kt.viewport=new ye,F[Ct]=kt),kt.matrix.fromArray(qt.transform.matrix),kt.matrix.decompose(kt.position,kt.quaternion,kt.scale),kt.projectionMatrix.fromArray(qt.projectionMatrix),kt.projectionMatrixInverse.copy(kt.projectionMatrix).invert(),kt.viewport.set(Yt.x,Yt.y,Yt.width,Yt.height),Ct===0&&(W.matrix.copy(kt.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),At===!0&&W.cameras.push(kt)}let ht=i.enabledFeatures;if(ht&&ht.includes("depth-sensing")&&i.depthUsage=="gpu-optimized"&&x){d=n.getBinding();let Ct=d.getDepthInformation(_t[0]);Ct&&Ct.isValid&&Ct.texture&&m.init(Ct,i.renderState)}if(ht&&ht.includes("camera-access")&&x){t.state.unbindTexture(),d=n.getBinding();for(let Ct=0;Ct<_t.length;Ct++){let qt=_t[Ct].camera;if(qt){let Yt=g[qt];Yt||(Yt=new _r,g[qt]=Yt);let kt=d.getCameraImage(qt);Yt.sourceTexture=kt}}}}for(let _t=0;_t<T.length;_t++){let At=E[_t],ht=T[_t];At!==null&&ht!==void 0&&ht.update(At,pt,c||o)}et&&et(K,pt),pt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:pt}),p=null}let Dt=new Xp;Dt.setAnimationLoop(Mt),this.setAnimationLoop=function(K){et=K},this.dispose=function(){}}},Db=new _e,em=new Ft;em.set(-1,0,0,0,1,0,0,0,1);function Ob(s,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,Zh(s)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function i(m,g,M,A,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),d(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),u(m,g),g.isMeshPhysicalMaterial&&f(m,g,b)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,M,A):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Je&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Je&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let M=t.get(g),A=M.envMap,b=M.envMapRotation;A&&(m.envMap.value=A,m.envMapRotation.value.setFromMatrix4(Db.makeRotationFromEuler(b)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(em),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,M,A){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*M,m.scale.value=A*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function d(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function u(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,M){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Je&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let M=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:i}}function Fb(s,t,e,n){let i={},r={};function o(M,A){let b=A.program;n.uniformBlockBinding(M,b,i[M.id])}function a(M,A){let b=i[M.id];b===void 0&&(p(M),b=l(M),i[M.id]=b,M.addEventListener("dispose",m));let T=A.program;n.updateUBOMapping(M,T);let E=t.render.frame;r[M.id]!==E&&(c(M),r[M.id]=E)}function l(M){let A=s.createBuffer(),b=M.__size,T=M.usage;return s.bindBuffer(s.UNIFORM_BUFFER,A),s.bufferData(s.UNIFORM_BUFFER,b,T),s.bindBuffer(s.UNIFORM_BUFFER,null),A}function c(M){let A=i[M.id],b=M.uniforms,T=M.__cache;s.bindBuffer(s.UNIFORM_BUFFER,A);for(let E=0,y=b.length;E<y;E++){let w=b[E];if(Array.isArray(w))for(let D=0,C=w.length;D<C;D++)h(w[D],E,D,T);else h(w,E,0,T)}s.bindBuffer(s.UNIFORM_BUFFER,null)}function h(M,A,b,T){if(u(M,A,b,T)===!0){let E=M.__offset,y=M.value;if(Array.isArray(y)){let w=0;for(let D=0;D<y.length;D++){let C=y[D],L=x(C,!0);d(C,M.__data,w),w+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else d(y,M.__data,0);s.bufferSubData(s.UNIFORM_BUFFER,E,M.__data)}}function d(M,A,b){typeof M=="number"||typeof M=="boolean"?A[b]=M:M.isMatrix3?(A[b]=M.elements[0],A[b+1]=M.elements[1],A[b+2]=M.elements[2],A[b+3]=0,A[b+4]=M.elements[3],A[b+5]=M.elements[4],A[b+6]=M.elements[5],A[b+7]=0,A[b+8]=M.elements[6],A[b+9]=M.elements[7],A[b+10]=M.elements[8],A[b+11]=0):ArrayBuffer.isView(M)?A.set(M.subarray(0,A.length-b),b):M.toArray(A,b)}function u(M,A,b,T){let E=M.value,y=A+"_"+b;if(Array.isArray(E)){T[y]===void 0&&(T[y]=[]);let w=T[y],D=!1;for(let C=0;C<E.length;C++)f(E[C],w,C)===!0&&(D=!0);return D}return f(E,T,y)}function f(M,A,b){if(A[b]===void 0)return typeof M=="number"||typeof M=="boolean"?A[b]=M:ArrayBuffer.isView(M)?A[b]=M.slice():A[b]=M.clone(),!0;{let T=A[b];if(typeof M=="number"||typeof M=="boolean"){if(T!==M)return A[b]=M,!0}else{if(ArrayBuffer.isView(M))return!0;if(T.equals(M)===!1)return T.copy(M),!0}}return!1}function p(M){let A=M.uniforms,b=0,T=16;for(let y=0,w=A.length;y<w;y++){let D=Array.isArray(A[y])?A[y]:[A[y]];for(let C=0,L=D.length;C<L;C++){let F=D[C],W=Array.isArray(F.value)?F.value:[F.value],I=Array.isArray(A[y])||Array.isArray(F.value),z=b;for(let G=0,tt=W.length;G<tt;G++){let X=W[G],Q=x(X,I),et=b%T,Mt=et%Q.boundary,Dt=et+Mt;b+=Mt,Dt!==0&&T-Dt<Q.storage&&(b+=T-Dt),G===0&&(z=b),b+=Q.storage}let q=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new q((b-z)/Float32Array.BYTES_PER_ELEMENT),F.__offset=z}}let E=b%T;return E>0&&(b+=T-E),M.__size=b,M.__cache={},this}function x(M,A){let b={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(b.boundary=4,b.storage=4):M.isVector2?(b.boundary=8,b.storage=8):M.isVector3||M.isColor?(b.boundary=16,b.storage=12):M.isVector4?(b.boundary=16,b.storage=16):M.isMatrix3?(b.boundary=16,b.storage=48):M.isMatrix4?(b.boundary=16,b.storage=64):M.isTexture?Nt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(M)?(b.boundary=16,b.storage=M.byteLength):Nt("WebGLRenderer: Unsupported uniform value type.",M),A===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(M){let A=M.target;A.removeEventListener("dispose",m),s.deleteBuffer(i[A.id]),delete i[A.id],delete r[A.id]}function g(){for(let M in i)s.deleteBuffer(i[M]);i={},r={}}return{bind:o,update:a,dispose:g}}var Ub=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Hn=null;function kb(){return Hn===null&&(Hn=new qi(Ub,16,16,Pi,Rn),Hn.name="DFG_LUT",Hn.minFilter=Ne,Hn.magFilter=Ne,Hn.wrapS=kn,Hn.wrapT=kn,Hn.generateMipmaps=!1,Hn.needsUpdate=!0),Hn}var El=class{constructor(t={}){let{canvas:e=mp(),context:n=null,depth:i=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:f=ln}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let x=f,m=new Set([qa,Xa,Wa]),g=new Set([ln,Tn,Bs,Ji,Va,Ha]),M=new Uint32Array(4),A=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},T=null,E=null,y=[],w=[],D=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Vn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let C=this,L=!1,F=null,W=null,I=null,z=null;this._outputColorSpace=rn;let q=0,G=0,tt=null,X=-1,Q=null,et=new ye,Mt=new ye,Dt=null,K=new Zt(0),pt=0,_t=e.width,At=e.height,ht=1,It=null,oe=null,Ct=new ye(0,0,_t,At),qt=new ye(0,0,_t,At),Yt=!1,kt=new $i,pe=new ba,ve=!1,De=!1,ae=new _e,cn=new H,be=new ye,Xe={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ue=!1;function qe(){return tt===null?ht:1}let N=n;function Oe(_,P){return e.getContext(_,P)}let ne,jt,rt,de,Rt,Lt,S,v,k,nt,j,ot,dt,Y,Z,lt,R,J,$,ct,st,at,Tt;try{let _={alpha:!0,depth:i,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Pt,!1),e.addEventListener("webglcontextrestored",Bt,!1),e.addEventListener("webglcontextcreationerror",mt,!1),N===null){let P="webgl2";if(N=Oe(P,_),N===null)throw Oe(P)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}zt()}catch(_){throw e.removeEventListener("webglcontextlost",Pt,!1),e.removeEventListener("webglcontextrestored",Bt,!1),e.removeEventListener("webglcontextcreationerror",mt,!1),Ot("WebGLRenderer: "+_.message),_}function zt(){ne=new K_(N),ne.init(),st=new Pb(N,ne),jt=new k_(N,ne,t,st),rt=new Rb(N,ne),jt.reversedDepthBuffer&&u&&rt.buffers.depth.setReversed(!0),W=N.createFramebuffer(),I=N.createFramebuffer(),z=N.createFramebuffer(),de=new j_(N),Rt=new mb,Lt=new Ib(N,ne,rt,Rt,jt,st,de),S=new Y_(C),v=new ty(N),at=new F_(N,v),k=new Z_(N,v,de,at),nt=new tM(N,k,v,at,de),J=new Q_(N,jt,Lt),Z=new B_(Rt),j=new pb(C,S,ne,jt,at,Z),ot=new Ob(C,Rt),dt=new xb,Y=new wb(ne),R=new O_(C,S,rt,nt,p,l),lt=new Cb(C,nt,jt),Tt=new Fb(N,de,jt,rt),$=new U_(N,ne,de),ct=new J_(N,ne,de),de.programs=j.programs,C.capabilities=jt,C.extensions=ne,C.properties=Rt,C.renderLists=dt,C.shadowMap=lt,C.state=rt,C.info=de}x!==ln&&(D=new nM(x,e.width,e.height,a,i,r));let it=new cu(C,N);this.xr=it,this.getContext=function(){return N},this.getContextAttributes=function(){return N.getContextAttributes()},this.forceContextLoss=function(){let _=ne.get("WEBGL_lose_context");_&&_.loseContext()},this.forceContextRestore=function(){let _=ne.get("WEBGL_lose_context");_&&_.restoreContext()},this.getPixelRatio=function(){return ht},this.setPixelRatio=function(_){_!==void 0&&(ht=_,this.setSize(_t,At,!1))},this.getSize=function(_){return _.set(_t,At)},this.setSize=function(_,P,V=!0){if(it.isPresenting){Nt("WebGLRenderer: Can't change size while VR device is presenting.");return}_t=_,At=P,e.width=Math.floor(_*ht),e.height=Math.floor(P*ht),V===!0&&(e.style.width=_+"px",e.style.height=P+"px"),D!==null&&D.setSize(e.width,e.height),this.setViewport(0,0,_,P)},this.getDrawingBufferSize=function(_){return _.set(_t*ht,At*ht).floor()},this.setDrawingBufferSize=function(_,P,V){_t=_,At=P,ht=V,e.width=Math.floor(_*V),e.height=Math.floor(P*V),this.setViewport(0,0,_,P)},this.setEffects=function(_){if(x===ln){Ot("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(_){for(let P=0;P<_.length;P++)if(_[P].isOutputPass===!0){Nt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(_||[])},this.getCurrentViewport=function(_){return _.copy(et)},this.getViewport=function(_){return _.copy(Ct)},this.setViewport=function(_,P,V,U){_.isVector4?Ct.set(_.x,_.y,_.z,_.w):Ct.set(_,P,V,U),rt.viewport(et.copy(Ct).multiplyScalar(qe()).round())},this.getScissor=function(_){return _.copy(qt)},this.setScissor=function(_,P,V,U){_.isVector4?qt.set(_.x,_.y,_.z,_.w):qt.set(_,P,V,U),rt.scissor(Mt.copy(qt).multiplyScalar(qe()).round())},this.getScissorTest=function(){return Yt},this.setScissorTest=function(_){rt.setScissorTest(Yt=_)},this.setOpaqueSort=function(_){It=_},this.setTransparentSort=function(_){oe=_},this.getClearColor=function(_){return _.copy(R.getClearColor())},this.setClearColor=function(){R.setClearColor(...arguments)},this.getClearAlpha=function(){return R.getClearAlpha()},this.setClearAlpha=function(){R.setClearAlpha(...arguments)},this.clear=function(_=!0,P=!0,V=!0){let U=0;if(_){let B=!1;if(tt!==null){let ft=tt.texture.format;B=m.has(ft)}if(B){let ft=tt.texture.type,bt=g.has(ft),ut=R.getClearColor(),xt=R.getClearAlpha(),Et=ut.r,Ut=ut.g,Wt=ut.b;bt?(M[0]=Et,M[1]=Ut,M[2]=Wt,M[3]=xt,N.clearBufferuiv(N.COLOR,0,M)):(A[0]=Et,A[1]=Ut,A[2]=Wt,A[3]=xt,N.clearBufferiv(N.COLOR,0,A))}else U|=N.COLOR_BUFFER_BIT}P&&(U|=N.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),V&&(U|=N.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),U!==0&&N.clear(U)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(_){_.setRenderer(this),F=_},this.dispose=function(){e.removeEventListener("webglcontextlost",Pt,!1),e.removeEventListener("webglcontextrestored",Bt,!1),e.removeEventListener("webglcontextcreationerror",mt,!1),R.dispose(),dt.dispose(),Y.dispose(),Lt.dispose(),Rt.dispose(),S.dispose(),nt.dispose(),k.dispose(),at.dispose(),Tt.dispose(),j.dispose(),it.dispose(),it.removeEventListener("sessionstart",Mu),it.removeEventListener("sessionend",bu),Li.stop()};function Pt(_){_.preventDefault(),Yh("WebGLRenderer: Context Lost."),L=!0}function Bt(){Yh("WebGLRenderer: Context Restored."),L=!1;let _=de.autoReset,P=lt.enabled,V=lt.autoUpdate,U=lt.needsUpdate,B=lt.type;zt(),de.autoReset=_,lt.enabled=P,lt.autoUpdate=V,lt.needsUpdate=U,lt.type=B}function mt(_){Ot("WebGLRenderer: A WebGL context could not be created. Reason: ",_.statusMessage)}function ee(_){let P=_.target;P.removeEventListener("dispose",ee),Re(P)}function Re(_){ci(_),Rt.remove(_)}function ci(_){let P=Rt.get(_).programs;P!==void 0&&(P.forEach(function(V){j.releaseProgram(V)}),_.isShaderMaterial&&j.releaseShaderCache(_))}this.renderBufferDirect=function(_,P,V,U,B,ft){P===null&&(P=Xe);let bt=B.isMesh&&B.matrixWorld.determinantAffine()<0,ut=km(_,P,V,U,B);rt.setMaterial(U,bt);let xt=V.index,Et=1;if(U.wireframe===!0){if(xt=k.getWireframeAttribute(V),xt===void 0)return;Et=2}let Ut=V.drawRange,Wt=V.attributes.position,wt=Ut.start*Et,Xt=(Ut.start+Ut.count)*Et;ft!==null&&(wt=Math.max(wt,ft.start*Et),Xt=Math.min(Xt,(ft.start+ft.count)*Et)),xt!==null?(wt=Math.max(wt,0),Xt=Math.min(Xt,xt.count)):Wt!=null&&(wt=Math.max(wt,0),Xt=Math.min(Xt,Wt.count));let we=Xt-wt;if(we<0||we===1/0)return;at.setup(B,U,ut,V,xt);let le,se=$;if(xt!==null&&(le=v.get(xt),se=ct,se.setIndex(le)),B.isMesh)U.wireframe===!0?(rt.setLineWidth(U.wireframeLinewidth*qe()),se.setMode(N.LINES)):se.setMode(N.TRIANGLES);else if(B.isLine){let Ue=U.linewidth;Ue===void 0&&(Ue=1),rt.setLineWidth(Ue*qe()),B.isLineSegments?se.setMode(N.LINES):B.isLineLoop?se.setMode(N.LINE_LOOP):se.setMode(N.LINE_STRIP)}else B.isPoints?se.setMode(N.POINTS):B.isSprite&&se.setMode(N.TRIANGLES);if(B.isBatchedMesh)if(ne.get("WEBGL_multi_draw"))se.renderMultiDraw(B._multiDrawStarts,B._multiDrawCounts,B._multiDrawCount);else{let Ue=B._multiDrawStarts,St=B._multiDrawCounts,$e=B._multiDrawCount,Qt=xt?v.get(xt).bytesPerElement:1,Ni=Rt.get(U).currentProgram.getUniforms();for(let ke=0;ke<$e;ke++)Ni.setValue(N,"_gl_DrawID",ke),se.render(Ue[ke]/Qt,St[ke])}else if(B.isInstancedMesh)se.renderInstances(wt,we,B.count);else if(V.isInstancedBufferGeometry){let Ue=V._maxInstanceCount!==void 0?V._maxInstanceCount:1/0,St=Math.min(V.instanceCount,Ue);se.renderInstances(wt,we,St)}else se.render(wt,we)};function _u(_,P,V,U){F!==null&&_.isNodeMaterial&&F.setObject(U,_),ve===!0&&Z.setState(_,V,!1),_.transparent===!0&&_.side===yn&&_.forceSinglePass===!1?(_.side=Je,_.needsUpdate=!0,Ws(_,P,U),_.side=Ii,_.needsUpdate=!0,Ws(_,P,U),_.side=yn):Ws(_,P,U)}this.compile=function(_,P,V=null){V===null&&(V=_),F!==null&&F.renderStart(_,P,V),E=Y.get(V),E.init(P),w.push(E),V.traverseVisible(function(B){B.isLight&&B.layers.test(P.layers)&&(E.pushLight(B),B.castShadow&&E.pushShadow(B))}),_!==V&&_.traverseVisible(function(B){B.isLight&&B.layers.test(P.layers)&&(E.pushLight(B),B.castShadow&&E.pushShadow(B))}),E.setupLights(),F!==null&&F.updateLights(E.state.lightsArray),De=this.localClippingEnabled,ve=Z.init(this.clippingPlanes,De),ve===!0&&Z.setGlobalState(this.clippingPlanes,P),F!==null&&lt.render(E.state.shadowsArray,V,P);let U=new Set;return _.traverse(function(B){if(!(B.isMesh||B.isPoints||B.isLine||B.isSprite))return;let ft=B.material;if(ft)if(Array.isArray(ft))for(let bt=0;bt<ft.length;bt++){let ut=ft[bt];_u(ut,V,P,B),U.add(ut)}else _u(ft,V,P,B),U.add(ft)}),E=w.pop(),F!==null&&F.renderEnd(),U},this.compileAsync=function(_,P,V=null){let U=this.compile(_,P,V);return new Promise(B=>{function ft(){if(U.forEach(function(bt){let xt=Rt.get(bt).currentProgram;(xt===void 0||xt.isReady())&&U.delete(bt)}),U.size===0){B(_);return}setTimeout(ft,10)}ne.get("KHR_parallel_shader_compile")!==null?ft():setTimeout(ft,10)})};let Ql=null;function Fm(_){Ql&&Ql(_)}function Mu(){Li.stop()}function bu(){Li.start()}let Li=new Xp;Li.setAnimationLoop(Fm),typeof self<"u"&&Li.setContext(self),this.setAnimationLoop=function(_){Ql=_,it.setAnimationLoop(_),_===null?Li.stop():Li.start()},it.addEventListener("sessionstart",Mu),it.addEventListener("sessionend",bu),this.render=function(_,P){if(P!==void 0&&P.isCamera!==!0){Ot("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;F!==null&&F.renderStart(_,P);let V=it.enabled===!0&&it.isPresenting===!0,U=D!==null&&(tt===null||V)&&D.begin(C,tt);if(_.matrixWorldAutoUpdate===!0&&_.updateMatrixWorld(),P.parent===null&&P.matrixWorldAutoUpdate===!0&&P.updateMatrixWorld(),it.enabled===!0&&it.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(it.cameraAutoUpdate===!0&&it.updateCamera(P),P=it.getCamera()),_.isScene===!0&&_.onBeforeRender(C,_,P,tt),E=Y.get(_,w.length),E.init(P),E.state.textureUnits=Lt.getTextureUnits(),w.push(E),ae.multiplyMatrices(P.projectionMatrix,P.matrixWorldInverse),P.isArrayCamera?pe.setFromArrayCamera(P):kt.setFromProjectionMatrix(ae,fn,P.reversedDepth),De=this.localClippingEnabled,ve=Z.init(this.clippingPlanes,De),T=dt.get(_,y.length),T.init(),y.push(T),this.info.render.frame++,it.enabled===!0&&it.isPresenting===!0){let bt=C.xr.getDepthSensingMesh();bt!==null&&tc(bt,P,-1/0,C.sortObjects)}tc(_,P,0,C.sortObjects),T.finish(),F!==null&&F.updateLights(E.state.lightsArray),C.sortObjects===!0&&T.sort(It,oe),ue=it.enabled===!1||it.isPresenting===!1||it.hasDepthSensing()===!1,ue&&R.addToRenderList(T,_),this.info.autoReset===!0&&this.info.reset(),ve===!0&&Z.beginShadows();let B=E.state.shadowsArray;if(lt.render(B,_,P),ve===!0&&Z.endShadows(),(U&&D.hasRenderPass())===!1){let bt=T.opaque,ut=T.transmissive;if(E.setupLights(),P.isArrayCamera){let xt=P.cameras;if(ut.length>0)for(let Et=0,Ut=xt.length;Et<Ut;Et++){let Wt=xt[Et];Su(bt,ut,_,Wt)}ue&&R.render(_);for(let Et=0,Ut=xt.length;Et<Ut;Et++){let Wt=xt[Et];wu(T,_,Wt,Wt.viewport)}}else ut.length>0&&Su(bt,ut,_,P),ue&&R.render(_),wu(T,_,P)}tt!==null&&G===0&&(Lt.updateMultisampleRenderTarget(tt),Lt.updateRenderTargetMipmap(tt)),U&&D.end(C),_.isScene===!0&&_.onAfterRender(C,_,P),at.resetDefaultState(),X=-1,Q=null,w.pop(),w.length>0?(E=w[w.length-1],Lt.setTextureUnits(E.state.textureUnits),ve===!0&&Z.setGlobalState(C.clippingPlanes,E.state.camera)):E=null,y.pop(),y.length>0?T=y[y.length-1]:T=null,F!==null&&F.renderEnd()};function tc(_,P,V,U){if(_.visible===!1)return;if(_.layers.test(P.layers)){if(_.isGroup)V=_.renderOrder;else if(_.isLOD)_.autoUpdate===!0&&_.update(P);else if(_.isLight)E.pushLight(_),_.castShadow&&E.pushShadow(_);else if(_.isSprite){let bt=P.isArrayCamera?pe:kt;if(!_.frustumCulled||_.intersectsFrustum(bt)){U&&be.setFromMatrixPosition(_.matrixWorld).applyMatrix4(ae);let ut=nt.update(_),xt=_.material;xt.visible&&T.push(_,ut,xt,V,be.z,null,P)}}else if(_.isMesh||_.isLine||_.isPoints){let bt=P.isArrayCamera?pe:kt;if(!_.frustumCulled||_.intersectsFrustum(bt)){let ut=nt.update(_),xt=_.material;if(U&&(_.boundingSphere!==void 0?(_.boundingSphere===null&&_.computeBoundingSphere(),be.copy(_.boundingSphere.center)):(ut.boundingSphere===null&&ut.computeBoundingSphere(),be.copy(ut.boundingSphere.center)),be.applyMatrix4(_.matrixWorld).applyMatrix4(ae)),Array.isArray(xt)){let Et=ut.groups;for(let Ut=0,Wt=Et.length;Ut<Wt;Ut++){let wt=Et[Ut],Xt=xt[wt.materialIndex];Xt&&Xt.visible&&T.push(_,ut,Xt,V,be.z,wt,P)}}else xt.visible&&T.push(_,ut,xt,V,be.z,null,P)}}}let ft=_.children;for(let bt=0,ut=ft.length;bt<ut;bt++)tc(ft[bt],P,V,U)}function wu(_,P,V,U){let{opaque:B,transmissive:ft,transparent:bt}=_;E.setupLightsView(V),ve===!0&&Z.setGlobalState(C.clippingPlanes,V),U&&rt.viewport(et.copy(U)),B.length>0&&Gr(B,P,V),ft.length>0&&Gr(ft,P,V),bt.length>0&&Gr(bt,P,V),rt.buffers.depth.setTest(!0),rt.buffers.depth.setMask(!0),rt.buffers.color.setMask(!0),rt.setPolygonOffset(!1)}function Su(_,P,V,U){if((V.isScene===!0?V.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[U.id]===void 0){let wt=ne.has("EXT_color_buffer_half_float")||ne.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[U.id]=new on(1,1,{generateMipmaps:!0,type:wt?Rn:ln,minFilter:En,samples:Math.max(4,jt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ht.workingColorSpace})}let ft=E.state.transmissionRenderTarget[U.id],bt=U.viewport||et;ft.setSize(bt.z*C.transmissionResolutionScale,bt.w*C.transmissionResolutionScale);let ut=C.getRenderTarget(),xt=C.getActiveCubeFace(),Et=C.getActiveMipmapLevel();C.setRenderTarget(ft),C.getClearColor(K),pt=C.getClearAlpha(),pt<1&&C.setClearColor(16777215,.5),C.clear(),ue&&R.render(V);let Ut=C.toneMapping;C.toneMapping=Vn;let Wt=U.viewport;if(U.viewport!==void 0&&(U.viewport=void 0),E.setupLightsView(U),ve===!0&&Z.setGlobalState(C.clippingPlanes,U),Gr(_,V,U),Lt.updateMultisampleRenderTarget(ft),Lt.updateRenderTargetMipmap(ft),ne.has("WEBGL_multisampled_render_to_texture")===!1){let wt=!1;for(let Xt=0,we=P.length;Xt<we;Xt++){let le=P[Xt],{object:se,geometry:Ue,material:St,group:$e}=le;if(St.side===yn&&se.layers.test(U.layers)){let Qt=St.side;St.side=Je,St.needsUpdate=!0,Au(se,V,U,Ue,St,$e),St.side=Qt,St.needsUpdate=!0,wt=!0}}wt===!0&&(Lt.updateMultisampleRenderTarget(ft),Lt.updateRenderTargetMipmap(ft))}C.setRenderTarget(ut,xt,Et),C.setClearColor(K,pt),Wt!==void 0&&(U.viewport=Wt),C.toneMapping=Ut}function Gr(_,P,V){let U=P.isScene===!0?P.overrideMaterial:null;for(let B=0,ft=_.length;B<ft;B++){let bt=_[B],{object:ut,geometry:xt,group:Et}=bt,Ut=bt.material;Ut.allowOverride===!0&&U!==null&&(Ut=U),ut.layers.test(V.layers)&&Au(ut,P,V,xt,Ut,Et)}}function Au(_,P,V,U,B,ft){F!==null&&B.isNodeMaterial&&F.setObject(_,B),_.onBeforeRender(C,P,V,U,B,ft),_.modelViewMatrix.multiplyMatrices(V.matrixWorldInverse,_.matrixWorld),_.normalMatrix.getNormalMatrix(_.modelViewMatrix),B.onBeforeRender(C,P,V,U,_,ft),B.transparent===!0&&B.side===yn&&B.forceSinglePass===!1?(B.side=Je,B.needsUpdate=!0,C.renderBufferDirect(V,P,U,B,_,ft),B.side=Ii,B.needsUpdate=!0,C.renderBufferDirect(V,P,U,B,_,ft),B.side=yn):C.renderBufferDirect(V,P,U,B,_,ft),_.onAfterRender(C,P,V,U,B,ft)}function Eu(_){let P=0;for(let V of _)V.texture!==null&&P++;return P}function Ws(_,P,V){P.isScene!==!0&&(P=Xe);let U=Rt.get(_),B=E.state.lights,ft=E.state.shadowsArray,bt=B.state.version,ut=j.getParameters(_,B.state,ft,P,V,E.state.lightProbeGridArray),xt=j.getProgramCacheKey(ut),Et=U.programs;U.environment=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?P.environment:null,U.fog=P.fog;let Ut=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap;U.envMap=S.get(_.envMap||U.environment,Ut),U.envMapRotation=U.environment!==null&&_.envMap===null?P.environmentRotation:_.envMapRotation,Et===void 0&&(_.addEventListener("dispose",ee),Et=new Map,U.programs=Et,U.programVariants=new Map);let Wt=Et.get(xt);if(Wt!==void 0){if(U.currentProgram===Wt&&U.lightsStateVersion===bt)return Cu(_,ut),Wt}else ut.uniforms=j.getUniforms(_),F!==null&&_.isNodeMaterial&&F.build(_,V,ut),_.onBeforeCompile(ut,C),Wt=j.acquireProgram(ut,xt),Et.set(xt,Wt),U.uniforms=ut.uniforms;let wt=U.uniforms;return(!_.isShaderMaterial&&!_.isRawShaderMaterial||_.clipping===!0)&&(wt.clippingPlanes=Z.uniform),Cu(_,ut),U.needsLights=zm(_),U.lightsStateVersion=bt,U.needsLights&&(wt.ambientLightColor.value=B.state.ambient,wt.lightProbe.value=B.state.probe,wt.sunLights.value=B.state.sun,wt.sunLightShadows.value=B.state.sunShadow,wt.directionalLights.value=B.state.directional,wt.directionalLightShadows.value=B.state.directionalShadow,wt.spotLights.value=B.state.spot,wt.spotLightShadows.value=B.state.spotShadow,wt.rectAreaLights.value=B.state.rectArea,wt.ltc_1.value=B.state.rectAreaLTC1,wt.ltc_2.value=B.state.rectAreaLTC2,wt.pointLights.value=B.state.point,wt.pointLightShadows.value=B.state.pointShadow,wt.hemisphereLights.value=B.state.hemi,wt.sunShadowMatrix.value=B.state.sunShadowMatrix,wt.sunShadowCascade.value=B.state.sunShadowCascade,wt.directionalShadowMatrix.value=B.state.directionalShadowMatrix,wt.spotLightMatrix.value=B.state.spotLightMatrix,wt.spotLightMap.value=B.state.spotLightMap,wt.pointShadowMatrix.value=B.state.pointShadowMatrix),U.numLightProbeGrids=Eu(E.state.lightProbeGridArray),U.currentProgram=Wt,U.uniformsList=null,Wt}function Um(_,P,V,U,B){let ft=Rt.get(_),bt=ft.currentProgram.id+","+U+","+B,ut=ft.programVariants.get(bt);return ut===void 0?(ut=Ws(_,P,V),ft.programVariants.set(bt,ut)):(ft.currentProgram=ut,ft.uniformsList=null,ft.outputColorSpace=U,ft.toneMapping=B),ut}function Tu(_){if(_.uniformsList===null){let P=_.currentProgram.getUniforms();_.uniformsList=zs.seqWithValue(P.seq,_.uniforms)}return _.uniformsList}function Cu(_,P){let V=Rt.get(_);V.outputColorSpace=P.outputColorSpace,V.batching=P.batching,V.batchingColor=P.batchingColor,V.instancing=P.instancing,V.instancingColor=P.instancingColor,V.instancingMorph=P.instancingMorph,V.skinning=P.skinning,V.morphTargets=P.morphTargets,V.morphNormals=P.morphNormals,V.morphColors=P.morphColors,V.morphTargetsCount=P.morphTargetsCount,V.numClippingPlanes=P.numClippingPlanes,V.numIntersection=P.numClipIntersection,V.vertexAlphas=P.vertexAlphas,V.vertexTangents=P.vertexTangents,V.toneMapping=P.toneMapping}function km(_,P,V,U,B){P.isScene!==!0&&(P=Xe),Lt.resetTextureUnits();let ft=P.fog,bt=U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial?P.environment:null,ut=tt===null?C.outputColorSpace:tt.isXRRenderTarget===!0?tt.texture.colorSpace:Ht.workingColorSpace,xt=U.isMeshStandardMaterial||U.isMeshLambertMaterial&&!U.envMap||U.isMeshPhongMaterial&&!U.envMap,Et=S.get(U.envMap||bt,xt),Ut=U.vertexColors===!0&&!!V.attributes.color&&V.attributes.color.itemSize===4,Wt=!!V.attributes.tangent&&(!!U.normalMap||U.anisotropy>0),wt=!!V.morphAttributes.position,Xt=!!V.morphAttributes.normal,we=!!V.morphAttributes.color,le=Vn;U.toneMapped&&(tt===null||tt.isXRRenderTarget===!0)&&(le=C.toneMapping);let se=V.morphAttributes.position||V.morphAttributes.normal||V.morphAttributes.color,Ue=se!==void 0?se.length:0,St=Rt.get(U),$e=E.state.lights;if(ve===!0&&(De===!0||_!==Q)){let me=_===Q&&U.id===X;Z.setState(U,_,me)}let Qt=!1,Ni=!1;U.version===St.__version?St.needsLights&&St.lightsStateVersion!==$e.state.version||B.isBatchedMesh&&St.batching===!1||!B.isBatchedMesh&&St.batching===!0||B.isBatchedMesh&&St.batchingColor===!0&&B._colorsTexture===null||B.isBatchedMesh&&St.batchingColor===!1&&B._colorsTexture!==null||B.isInstancedMesh&&St.instancing===!1||!B.isInstancedMesh&&St.instancing===!0||B.isSkinnedMesh&&St.skinning===!1||!B.isSkinnedMesh&&St.skinning===!0||B.isInstancedMesh&&St.instancingColor===!0&&B.instanceColor===null||B.isInstancedMesh&&St.instancingColor===!1&&B.instanceColor!==null||B.isInstancedMesh&&St.instancingMorph===!0&&B.morphTexture===null||B.isInstancedMesh&&St.instancingMorph===!1&&B.morphTexture!==null||St.envMap!==Et||U.fog===!0&&St.fog!==ft||St.numClippingPlanes!==void 0&&(St.numClippingPlanes!==Z.numPlanes||St.numIntersection!==Z.numIntersection)||St.vertexAlphas!==Ut||St.vertexTangents!==Wt||St.morphTargets!==wt||St.morphNormals!==Xt||St.morphColors!==we||St.morphTargetsCount!==Ue||St.numLightProbeGrids!==Eu(E.state.lightProbeGridArray)?Qt=!0:(St.outputColorSpace!==ut||St.toneMapping!==le)&&(Ni=!0):(Qt=!0,St.__version=U.version);let ke=St.currentProgram;(Qt===!0||Ni===!0)&&(ke=Ni===!0?Um(U,P,B,ut,le):Ws(U,P,B),F&&U.isNodeMaterial&&F.onUpdateProgram(U,ke,St));let Vr=!1,hi=!1,Di=!1,Kt=ke.getUniforms(),Fe=St.uniforms;if(rt.useProgram(ke.program)&&(Vr=!0,hi=!0,Di=!0),U.id!==X&&(X=U.id,hi=!0),Vr||Q!==_){rt.buffers.depth.getReversed()&&_.reversedDepth!==!0&&(_._reversedDepth=!0,_.updateProjectionMatrix()),Kt.setValue(N,"projectionMatrix",_.projectionMatrix),Kt.setValue(N,"viewMatrix",_.matrixWorldInverse);let Ie=Kt.map.cameraPosition;Ie!==void 0&&Ie.setValue(N,cn.setFromMatrixPosition(_.matrixWorld)),jt.logarithmicDepthBuffer&&Kt.setValue(N,"logDepthBufFC",2/(Math.log(_.far+1)/Math.LN2)),(U.isMeshPhongMaterial||U.isMeshToonMaterial||U.isMeshLambertMaterial||U.isMeshBasicMaterial||U.isMeshStandardMaterial||U.isShaderMaterial)&&Kt.setValue(N,"isOrthographic",_.isOrthographicCamera===!0),Q!==_&&(Q=_,hi=!0,Di=!0)}if(St.needsLights&&($e.state.sunShadowMap.length>0&&Kt.setValue(N,"sunShadowMap",$e.state.sunShadowMap,Lt),$e.state.directionalShadowMap.length>0&&Kt.setValue(N,"directionalShadowMap",$e.state.directionalShadowMap,Lt),$e.state.spotShadowMap.length>0&&Kt.setValue(N,"spotShadowMap",$e.state.spotShadowMap,Lt),$e.state.pointShadowMap.length>0&&Kt.setValue(N,"pointShadowMap",$e.state.pointShadowMap,Lt)),B.isSkinnedMesh){Kt.setOptional(N,B,"bindMatrix"),Kt.setOptional(N,B,"bindMatrixInverse");let me=B.skeleton;me&&(me.boneTexture===null&&me.computeBoneTexture(),Kt.setValue(N,"boneTexture",me.boneTexture,Lt))}B.isBatchedMesh&&(Kt.setOptional(N,B,"batchingTexture"),Kt.setValue(N,"batchingTexture",B._matricesTexture,Lt),Kt.setOptional(N,B,"batchingIdTexture"),Kt.setValue(N,"batchingIdTexture",B._indirectTexture,Lt),Kt.setOptional(N,B,"batchingColorTexture"),B._colorsTexture!==null&&Kt.setValue(N,"batchingColorTexture",B._colorsTexture,Lt));let vn=V.morphAttributes;if((vn.position!==void 0||vn.normal!==void 0||vn.color!==void 0)&&J.update(B,V,ke),(hi||St.receiveShadow!==B.receiveShadow)&&(St.receiveShadow=B.receiveShadow,Kt.setValue(N,"receiveShadow",B.receiveShadow)),(U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial)&&U.envMap===null&&P.environment!==null&&(Fe.envMapIntensity.value=P.environmentIntensity),Fe.dfgLUT!==void 0&&(Fe.dfgLUT.value=kb()),hi){if(Kt.setValue(N,"toneMappingExposure",C.toneMappingExposure),St.needsLights&&Bm(Fe,Di),ft&&U.fog===!0&&ot.refreshFogUniforms(Fe,ft),ot.refreshMaterialUniforms(Fe,U,ht,At,E.state.transmissionRenderTarget[_.id]),St.needsLights&&St.numLightProbeGrids>0){let me=b,Ie=0;for(let qn of E.state.lightProbeGridArray)qn.texture!==null&&(me.textures[Ie]=qn.texture,me.min[Ie]=qn.boundingBox.min,me.max[Ie]=qn.boundingBox.max,me.resolution[Ie]=qn.resolution,Ie++);for(let qn in me)me[qn].length=Ie;Fe.probesSH.value=me.textures,Fe.probesMin.value=me.min,Fe.probesMax.value=me.max,Fe.probesResolution.value=me.resolution}zs.upload(N,Tu(St),Fe,Lt)}if(U.isShaderMaterial&&U.uniformsNeedUpdate===!0&&(zs.upload(N,Tu(St),Fe,Lt),U.uniformsNeedUpdate=!1),U.isSpriteMaterial&&Kt.setValue(N,"center",B.center),Kt.setValue(N,"modelViewMatrix",B.modelViewMatrix),Kt.setValue(N,"normalMatrix",B.normalMatrix),Kt.setValue(N,"modelMatrix",B.matrixWorld),U.uniformsGroups!==void 0){let me=U.uniformsGroups;for(let Ie=0,qn=me.length;Ie<qn;Ie++){let Iu=me[Ie];Tt.update(Iu,ke),Tt.bind(Iu,ke)}}return ke}function Bm(_,P){_.ambientLightColor.needsUpdate=P,_.lightProbe.needsUpdate=P,_.sunLights.needsUpdate=P,_.sunLightShadows.needsUpdate=P,_.directionalLights.needsUpdate=P,_.directionalLightShadows.needsUpdate=P,_.pointLights.needsUpdate=P,_.pointLightShadows.needsUpdate=P,_.spotLights.needsUpdate=P,_.spotLightShadows.needsUpdate=P,_.rectAreaLights.needsUpdate=P,_.hemisphereLights.needsUpdate=P}function zm(_){return _.isMeshLambertMaterial||_.isMeshToonMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isShadowMaterial||_.isShaderMaterial&&_.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return tt},this.setRenderTargetTextures=function(_,P,V){let U=Rt.get(_);U.__autoAllocateDepthBuffer=_.resolveDepthBuffer===!1,U.__autoAllocateDepthBuffer===!1&&(U.__useRenderToTexture=!1),Rt.get(_.texture).__webglTexture=P,Rt.get(_.depthTexture).__webglTexture=U.__autoAllocateDepthBuffer?void 0:V,U.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(_,P){let V=Rt.get(_);V.__webglFramebuffer=P,V.__useDefaultFramebuffer=P===void 0},this.setRenderTarget=function(_,P=0,V=0){tt=_,q=P,G=V;let U=null,B=!1,ft=!1;if(_){let ut=Rt.get(_);if(ut.__useDefaultFramebuffer!==void 0){rt.bindFramebuffer(N.FRAMEBUFFER,ut.__webglFramebuffer),et.copy(_.viewport),Mt.copy(_.scissor),Dt=_.scissorTest,rt.viewport(et),rt.scissor(Mt),rt.setScissorTest(Dt),X=-1;return}else if(ut.__webglFramebuffer===void 0)Lt.setupRenderTarget(_);else if(ut.__hasExternalTextures)Lt.rebindTextures(_,Rt.get(_.texture).__webglTexture,Rt.get(_.depthTexture).__webglTexture);else if(_.depthBuffer){let Ut=_.depthTexture;if(ut.__boundDepthTexture!==Ut){if(Ut!==null&&Rt.has(Ut)&&(_.width!==Ut.image.width||_.height!==Ut.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Lt.setupDepthRenderbuffer(_)}}let xt=_.texture;(xt.isData3DTexture||xt.isDataArrayTexture||xt.isCompressedArrayTexture)&&(ft=!0);let Et=Rt.get(_).__webglFramebuffer;_.isWebGLCubeRenderTarget?(Array.isArray(Et[P])?U=Et[P][V]:U=Et[P],B=!0):_.samples>0&&Lt.useMultisampledRTT(_)===!1?U=Rt.get(_).__webglMultisampledFramebuffer:Array.isArray(Et)?U=Et[V]:U=Et,et.copy(_.viewport),Mt.copy(_.scissor),Dt=_.scissorTest}else et.copy(Ct).multiplyScalar(ht).floor(),Mt.copy(qt).multiplyScalar(ht).floor(),Dt=Yt;if(V!==0&&(U=W),rt.bindFramebuffer(N.FRAMEBUFFER,U)&&rt.drawBuffers(_,U),rt.viewport(et),rt.scissor(Mt),rt.setScissorTest(Dt),B){let ut=Rt.get(_.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_CUBE_MAP_POSITIVE_X+P,ut.__webglTexture,V)}else if(ft){let ut=P;for(let xt=0;xt<_.textures.length;xt++){let Et=Rt.get(_.textures[xt]);N.framebufferTextureLayer(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0+xt,Et.__webglTexture,V,ut)}}else if(_!==null&&V!==0){let ut=Rt.get(_.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,ut.__webglTexture,V)}X=-1};function Ru(_){let P=Rt.get(_);return(P.__readFormat!==_.format||P.__readType!==_.type)&&(P.__readFormat=_.format,P.__readType=_.type,P.__formatReadable=jt.textureFormatReadable(_.format),P.__typeReadable=jt.textureTypeReadable(_.type)),P}this.readRenderTargetPixels=function(_,P,V,U,B,ft,bt,ut=0){if(!(_&&_.isWebGLRenderTarget)){Ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let xt=Rt.get(_).__webglFramebuffer;if(_.isWebGLCubeRenderTarget&&bt!==void 0&&(xt=xt[bt],Array.isArray(xt)&&(xt=xt[0])),xt){rt.bindFramebuffer(N.FRAMEBUFFER,xt);try{let Et=_.textures[ut],Ut=Et.format,Wt=Et.type;_.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+ut);let wt=Ru(Et);if(wt.__formatReadable===!1){Ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(wt.__typeReadable===!1){Ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}P>=0&&P<=_.width-U&&V>=0&&V<=_.height-B&&N.readPixels(P,V,U,B,st.convert(Ut),st.convert(Wt),ft)}finally{let Et=tt!==null?Rt.get(tt).__webglFramebuffer:null;rt.bindFramebuffer(N.FRAMEBUFFER,Et)}}},this.readRenderTargetPixelsAsync=async function(_,P,V,U,B,ft,bt,ut=0){if(!(_&&_.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let xt=Rt.get(_).__webglFramebuffer;if(_.isWebGLCubeRenderTarget&&bt!==void 0&&(xt=xt[bt],Array.isArray(xt)&&(xt=xt[0])),xt)if(P>=0&&P<=_.width-U&&V>=0&&V<=_.height-B){rt.bindFramebuffer(N.FRAMEBUFFER,xt);let Et=_.textures[ut],Ut=Et.format,Wt=Et.type;_.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+ut);let wt=Ru(Et);if(wt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(wt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Xt=N.createBuffer();N.bindBuffer(N.PIXEL_PACK_BUFFER,Xt),N.bufferData(N.PIXEL_PACK_BUFFER,ft.byteLength,N.STREAM_READ),N.readPixels(P,V,U,B,st.convert(Ut),st.convert(Wt),0),N.bindBuffer(N.PIXEL_PACK_BUFFER,null);let we=tt!==null?Rt.get(tt).__webglFramebuffer:null;rt.bindFramebuffer(N.FRAMEBUFFER,we);let le=N.fenceSync(N.SYNC_GPU_COMMANDS_COMPLETE,0);return N.flush(),await xp(N,le,4),N.bindBuffer(N.PIXEL_PACK_BUFFER,Xt),N.getBufferSubData(N.PIXEL_PACK_BUFFER,0,ft),N.bindBuffer(N.PIXEL_PACK_BUFFER,null),N.deleteBuffer(Xt),N.deleteSync(le),ft}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(_,P=null,V=0){let U=Math.pow(2,-V),B=Math.floor(_.image.width*U),ft=Math.floor(_.image.height*U),bt=P!==null?P.x:0,ut=P!==null?P.y:0;Lt.setTexture2D(_,0),N.copyTexSubImage2D(N.TEXTURE_2D,V,0,0,bt,ut,B,ft),rt.unbindTexture()},this.copyTextureToTexture=function(_,P,V=null,U=null,B=0,ft=0){let bt,ut,xt,Et,Ut,Wt,wt,Xt,we,le=_.isCompressedTexture?_.mipmaps[ft]:_.image;if(V!==null)bt=V.max.x-V.min.x,ut=V.max.y-V.min.y,xt=V.isBox3?V.max.z-V.min.z:1,Et=V.min.x,Ut=V.min.y,Wt=V.isBox3?V.min.z:0;else{let Kt=Math.pow(2,-B);bt=Math.floor(le.width*Kt),ut=Math.floor(le.height*Kt),_.isDataArrayTexture?xt=le.depth:_.isData3DTexture?xt=Math.floor(le.depth*Kt):xt=1,Et=0,Ut=0,Wt=0}U!==null?(wt=U.x,Xt=U.y,we=U.z):(wt=0,Xt=0,we=0);let se=st.convert(P.format),Ue=st.convert(P.type),St;P.isData3DTexture?(Lt.setTexture3D(P,0),St=N.TEXTURE_3D):P.isDataArrayTexture||P.isCompressedArrayTexture?(Lt.setTexture2DArray(P,0),St=N.TEXTURE_2D_ARRAY):(Lt.setTexture2D(P,0),St=N.TEXTURE_2D),rt.activeTexture(N.TEXTURE0),rt.pixelStorei(N.UNPACK_FLIP_Y_WEBGL,P.flipY),rt.pixelStorei(N.UNPACK_PREMULTIPLY_ALPHA_WEBGL,P.premultiplyAlpha),rt.pixelStorei(N.UNPACK_ALIGNMENT,P.unpackAlignment);let $e=rt.getParameter(N.UNPACK_ROW_LENGTH),Qt=rt.getParameter(N.UNPACK_IMAGE_HEIGHT),Ni=rt.getParameter(N.UNPACK_SKIP_PIXELS),ke=rt.getParameter(N.UNPACK_SKIP_ROWS),Vr=rt.getParameter(N.UNPACK_SKIP_IMAGES);rt.pixelStorei(N.UNPACK_ROW_LENGTH,le.width),rt.pixelStorei(N.UNPACK_IMAGE_HEIGHT,le.height),rt.pixelStorei(N.UNPACK_SKIP_PIXELS,Et),rt.pixelStorei(N.UNPACK_SKIP_ROWS,Ut),rt.pixelStorei(N.UNPACK_SKIP_IMAGES,Wt);let hi=_.isDataArrayTexture||_.isData3DTexture,Di=P.isDataArrayTexture||P.isData3DTexture;if(_.isDepthTexture){let Kt=Rt.get(_),Fe=Rt.get(P),vn=Rt.get(Kt.__renderTarget),me=Rt.get(Fe.__renderTarget);rt.bindFramebuffer(N.READ_FRAMEBUFFER,vn.__webglFramebuffer),rt.bindFramebuffer(N.DRAW_FRAMEBUFFER,me.__webglFramebuffer);for(let Ie=0;Ie<xt;Ie++)hi&&(N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Rt.get(_).__webglTexture,B,Wt+Ie),N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Rt.get(P).__webglTexture,ft,we+Ie)),N.blitFramebuffer(Et,Ut,Et+bt,Ut+ut,wt,Xt,wt+bt,Xt+ut,N.DEPTH_BUFFER_BIT,N.NEAREST);rt.bindFramebuffer(N.READ_FRAMEBUFFER,null),rt.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else if(B!==0||_.isRenderTargetTexture||Rt.has(_)){let Kt=Rt.get(_),Fe=Rt.get(P);rt.bindFramebuffer(N.READ_FRAMEBUFFER,I),rt.bindFramebuffer(N.DRAW_FRAMEBUFFER,z);for(let vn=0;vn<xt;vn++)hi?N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Kt.__webglTexture,B,Wt+vn):N.framebufferTexture2D(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,Kt.__webglTexture,B),Di?N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Fe.__webglTexture,ft,we+vn):N.framebufferTexture2D(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,Fe.__webglTexture,ft),B!==0?N.blitFramebuffer(Et,Ut,Et+bt,Ut+ut,wt,Xt,wt+bt,Xt+ut,N.COLOR_BUFFER_BIT,N.NEAREST):Di?N.copyTexSubImage3D(St,ft,wt,Xt,we+vn,Et,Ut,bt,ut):N.copyTexSubImage2D(St,ft,wt,Xt,Et,Ut,bt,ut);rt.bindFramebuffer(N.READ_FRAMEBUFFER,null),rt.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else Di?_.isDataTexture||_.isData3DTexture?N.texSubImage3D(St,ft,wt,Xt,we,bt,ut,xt,se,Ue,le.data):P.isCompressedArrayTexture?N.compressedTexSubImage3D(St,ft,wt,Xt,we,bt,ut,xt,se,le.data):N.texSubImage3D(St,ft,wt,Xt,we,bt,ut,xt,se,Ue,le):_.isDataTexture?N.texSubImage2D(N.TEXTURE_2D,ft,wt,Xt,bt,ut,se,Ue,le.data):_.isCompressedTexture?N.compressedTexSubImage2D(N.TEXTURE_2D,ft,wt,Xt,le.width,le.height,se,le.data):N.texSubImage2D(N.TEXTURE_2D,ft,wt,Xt,bt,ut,se,Ue,le);rt.pixelStorei(N.UNPACK_ROW_LENGTH,$e),rt.pixelStorei(N.UNPACK_IMAGE_HEIGHT,Qt),rt.pixelStorei(N.UNPACK_SKIP_PIXELS,Ni),rt.pixelStorei(N.UNPACK_SKIP_ROWS,ke),rt.pixelStorei(N.UNPACK_SKIP_IMAGES,Vr),ft===0&&P.generateMipmaps===!0&&P.mipmapsAutoUpdate===!0&&N.generateMipmap(St),rt.unbindTexture()},this.initRenderTarget=function(_){Rt.get(_).__webglFramebuffer===void 0&&Lt.setupRenderTarget(_)},this.initTexture=function(_){_.isCubeTexture?Lt.setTextureCube(_,0):_.isData3DTexture?Lt.setTexture3D(_,0):_.isDataArrayTexture||_.isCompressedArrayTexture?Lt.setTexture2DArray(_,0):Lt.setTexture2D(_,0),rt.unbindTexture()},this.resetState=function(){q=0,G=0,tt=null,rt.reset(),at.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return fn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Ht._getDrawingBufferColorSpace(t),e.unpackColorSpace=Ht._getUnpackColorSpace()}};Ht.enabled=!1;var zb=2040100,Gb=`
  attribute vec2 paint;
  attribute vec3 own;
  attribute vec2 gaze;
  attribute vec2 place;
  varying vec3 colour;
  varying vec2 ball;
  varying vec3 on;
  vec3 ramp(float heat) {
    vec3 low = mix(vec3(0.20, 0.24, 0.62), vec3(0.78, 0.20, 0.44), smoothstep(0.0, 0.5, heat));
    return mix(low, vec3(1.0, 0.82, 0.30), smoothstep(0.45, 1.0, heat));
  }
  void main() {
    vec4 at = modelViewMatrix * vec4(position, 1.0);
    gl_Position = projectionMatrix * at;
    vec3 n = normalize(normalMatrix * normal);
    n = dot(n, normalize(at.xyz)) > 0.3 ? -n : n; // the inside of an open part
    float key = max(dot(n, vec3(-0.40, 0.52, 0.755)), 0.0);
    float fill = max(dot(n, vec3(0.70, -0.05, 0.71)), 0.0);
    float sky = 0.5 + 0.5 * n.y;
    float heat = 0.85 * smoothstep(0.01, 0.2, paint.x);
    vec3 base = mix(own, ramp(paint.x), heat);
    vec3 light = vec3(0.20, 0.21, 0.23) * sky + vec3(0.80, 0.77, 0.73) * key + vec3(0.20, 0.22, 0.26) * fill;
    colour = base * sqrt(light) + pow(1.0 - abs(n.z), 3.0) * 0.035;
    ball = gaze;
    on = vec3(place, heat);
  }`,Vb=`
  uniform sampler2D tints;
  uniform float perRadius;
  varying vec3 colour;
  varying vec2 ball;
  varying vec3 on;
  #ifdef TEXTURED
  uniform sampler2D skin;
  #endif
  void main() {
    vec3 tint = max(abs(ball.x), abs(ball.y)) < 3.0 ? texture2D(tints, vec2(length(ball) * perRadius, 0.5)).rgb : vec3(1.0);
    #ifdef TEXTURED
    if (on.x >= 0.0) {
      vec4 texel = texture2D(skin, on.xy);
      if (texel.a < 0.5) discard;
      tint = mix(texel.rgb, vec3(1.0), on.z);
    }
    #endif
    gl_FragColor = vec4(colour * tint, 1.0);
  }`,Hb=/swiftshader|llvmpipe|softpipe|software|basic render/i;function nm(s,t){let e={antialias:!1,powerPreference:"high-performance",failIfMajorPerformanceCaveat:!t},n=s.getContext("webgl2",e);return!n||t||!Hb.test(Wb(n))?n:(n.getExtension("WEBGL_lose_context")?.loseContext(),null)}function Wb(s){let t=s.getParameter(s.RENDERER),e=t==="WebKit WebGL"&&s.getExtension("WEBGL_debug_renderer_info");return e?s.getParameter(e.UNMASKED_RENDERER_WEBGL):t}var Rl=class{constructor(t,e,n){this.canvas=t,this.surface=e,this.renderer=new El({canvas:t,context:n}),this.renderer.setClearColor(zb),this.renderer.outputColorSpace=Wi,this.renderer.autoClear=!1,this.camera=new Ke,this.size={width:1,height:1},this.tints=Xb(e.tints),this.skinTexture=e.texturing&&qb(e.texturing),this.known=new Map}resize(t,e,n){this.renderer.setPixelRatio(n),this.renderer.setSize(t,e,!1),this.size={width:t,height:e}}draw(t,e,n){let{renderer:i,camera:r,size:o}=this;i.setScissorTest(!0),r.fov=e.fieldDegrees,r.near=Math.max(e.distance-6*e.size,.01*e.distance),r.far=e.distance+60*e.size,r.position.fromArray(e.position),r.up.fromArray(e.above),r.lookAt(new H().fromArray(e.target)),r.updateMatrixWorld();let a=Math.max(...t.map(({width:c,height:h})=>c/h)),l=new Map([...new Set(t.map(n))].filter(Boolean).map(c=>[c,this.sent(c,e,a)]));this.forget(l);for(let c of t){let h=l.get(n(c)),d=o.height-c.top-c.height;i.setViewport(c.left,d,c.width,c.height),i.setScissor(c.left,d,c.width,c.height),r.aspect=c.width/c.height,r.updateProjectionMatrix(),i.clear(),h&&i.render(h.scene,r)}}sent(t,e,n){this.known.has(t)||this.known.set(t,$b(t,this.surface,this.tints,this.skinTexture));let i=this.known.get(t),{attributes:r,index:o}=i.geometry,{triangles:a,facing:l,texturing:c}=this.surface,h=(u,f)=>{Hc(f,u.itemSize,c?.doubles??[],u.array),u.needsUpdate=!0};i.seen.shape!==t.changes.shape&&(h(r.position,t.points),h(r.normal,t.normals)),i.seen.paint!==t.changes.paint&&h(r.paint,t.paint),i.seen={...t.changes};let d=lf(t.points,a,l,e,n,o.array,c?.corners);return o.clearUpdateRanges(),o.addUpdateRange(0,d),o.needsUpdate=!0,i.geometry.setDrawRange(0,d),i}forget(t){for(let[e,{geometry:n,material:i}]of this.known)t.has(e)||(n.dispose(),i.dispose(),this.known.delete(e))}};function Xb({factors:s,perRadius:t,last:e}){let n=Uint8Array.from({length:4*(e+1)},(r,o)=>Math.round(255*Math.min(1,s[3*(o>>2)+(o&3)]??1))),i=new qi(n,e+1,1);return i.magFilter=Ne,i.needsUpdate=!0,{texture:i,perRadius:t/(e+1)}}function qb({texels:s,width:t,height:e}){let n=new qi(new Uint8Array(s.buffer),t,e);return Object.assign(n,{magFilter:Ne,minFilter:En,generateMipmaps:!0,needsUpdate:!0}),n}function $b(s,{triangles:t,gaze:e,texturing:n},i,r){let o=(f,p)=>n?.doubles.length?Hc(f,p,n.doubles):f,a=new Gn,l=(f,p,x=!1)=>new Ze(f,p,x).setUsage(qh);a.setIndex(l(new Uint32Array(t.length),1));let c={position:l(o(s.points,3),3),normal:l(o(s.normals,3),3),paint:l(o(s.paint,4),4,!0),own:new Ze(o(s.colours,3),3),gaze:new Ze(o(e,2),2),...n&&{place:new Ze(n.places,2)}};for(let[f,p]of Object.entries(c))a.setAttribute(f,p);let h=new xn({vertexShader:Gb,fragmentShader:Vb,side:yn,defines:n?{TEXTURED:1}:{},uniforms:{tints:{value:i.texture},perRadius:{value:i.perRadius},skin:{value:r}}}),d=new gn(a,h);d.frustumCulled=!1;let u=new mr;return u.matrixWorldAutoUpdate=!1,u.add(d),{scene:u,geometry:a,material:h,seen:{...s.changes}}}var Yb=[.8,.95,1.08],Il=class{drawer;constructor(t,e,n=null){this.node=O("div",{class:"skin"}),this.onlost=null,this.triangles=ef(t),this.welded=rf(t,this.triangles),this.facing=af(e,this.triangles);let{colours:i,gaze:r}=sf(t);this.gaze=r,this.eyes=Pd(this.triangles,r),this.tints=Id(t.eye),this.texturing=nf(t),this.skin=im(e,i),this.target=null,this.size=[1,1,1],this.open(n)}open(t){let e=O("canvas"),n=t==="canvas"?null:nm(e,t==="webgl");this.drawer=n?new Rl(e,this,n):new xi(O("canvas"),this),this.drawnBy=n?"graphics card":"processor",n&&e.addEventListener("webglcontextlost",()=>this.loseCard()),this.node.replaceChildren(this.drawer.canvas)}loseCard(){this.open("canvas"),this.resize(...this.size),this.onlost?.()}refresh(t=this.skin){Ro(t.points,this.triangles,this.welded,t.normals),t.changes.shape++}paint(t){let{paint:e,changes:n}=this.skin;if(!(!t&&!this.heated)){this.heated=t!==null;for(let i=0,r=0;r<e.length;i++,r+=4)e[r]=t?t[i]:0;n.paint++}}setTarget(t){this.target=t&&im(t,this.skin.colours.map((e,n)=>Math.min(1,e*Yb[n%3]))),this.target&&this.refresh(this.target)}resize(t,e,n){this.size=[t,e,n],this.drawer.resize(t,e,n)}draw(t,e){this.drawer.draw(t,e,({kind:n})=>n==="target"?this.target:this.skin)}};function im(s,t){return{points:s,normals:new Float32Array(s.length),paint:new Uint8Array(4*s.length/3),colours:t,changes:{shape:0,paint:0}}}var Kb=45,sm=180,Zb=7e5,rm=2,Jb=15e4,Pl=class{ratio;closeness;constructor(t,e){this.say=e,this.session=t;let n=O("canvas",{class:"marks"});this.tip=O("div",{class:"tip",hidden:!0}),this.sides=[O("div",{class:"side-tag",style:{left:"14px"}}),O("div",{class:"side-tag"})],this.captions=O("div",{class:"captions"}),this.surface=O("div",{class:"surface",tabIndex:0,role:"application","aria-label":"Face: drag handles or skin"}),this.stage=new Il(t.character,t.deformer.points,jb()),this.stage.onlost=()=>this.changed("camera"),this.onion=new Io(this),this.node=O("div",{class:"view"},this.stage.node,this.onion.node,n,this.surface,this.captions,...this.sides,this.tip),this.overlay=new Do(n,t),this.camera=new Dn(t.character.up,t.section.view),this.picker=new Fo(t.deformer.points,this.stage.triangles),this.rearranging=new Uo(this),this.gestures=new To(this),this.kinds=null,this.closeLook=null,this.showsInfluence=!1,this.bare=!1,this.onInfluences=null,this.review=null,this.trails=null,this.shotLook=null,this.columns=[],this.stale=new Set(["pose","camera","overlay"]),this.fineness=1,this.drawn=0,this.listen(),new ResizeObserver(()=>this.resize()).observe(this.node)}beginDrag(t){let{session:e}=this,[n,i]=this.overlay.draggable(t,this.camera.projector(this.controlsColumn));return zd(n,e.controls,e.rest,e.values,i)}listen(){let{session:t}=this;t.on("pose",()=>this.changed("pose"));for(let e of["selection","hover","dragging"])t.on(e,()=>this.changed("overlay"));for(let e of["options","layout"])t.on(e,()=>this.arrange());t.on("time",()=>t.options.shot&&this.changed("camera")),t.on("section",()=>{let{up:e}=t.character;this.camera=new Dn(e,t.section.view),this.overlay.dock.front=new Dn(e,t.section.view),t.emit("selection"),t.emit("options"),this.home()});for(let e of["hover","selection","options","dragging"])t.on(e,()=>this.repaint=!0)}changed(t){this.stale.add(t),this.request()}request(){this.scheduled??=requestAnimationFrame(t=>{this.scheduled=null,this.frame(t)})}resize(){let{clientWidth:t,clientHeight:e}=this.node;if(!t||!e)return;let n=!this.columns.length;this.width=t,this.height=e,this.ratio=Math.min(2,window.devicePixelRatio||1),this.stage.resize(this.width,this.height,this.ratio*this.fineness),this.overlay.resize(this.width,this.height,this.ratio),this.arrange(),n&&this.home()}arrange(){if(!this.width)return;let{arrangement:t,handles:e}=this.session.options,{dock:n}=this.overlay,i=this.kinds??(t==="beside"&&e?["controls","clean"]:["controls"]),r=i.includes("controls")?n.place(this.width,this.height):null;n.arrange(r);let[o,a]=r&&r.width<this.width?[r.left,this.height]:[this.width,r?r.top:this.height],[l,c]=this.roomOf?.()??[1/0,1/0],h=Math.floor(Math.min(l,o/i.length)),d=Math.min(a,c),u=Math.floor((o-h*i.length)/2),f={controls:"Controls",clean:"Clean face",target:"Target"};this.columns=i.map((p,x)=>({kind:p,left:u+x*h,top:0,width:h,height:d})),this.controlsColumn=this.columns.find(p=>p.kind==="controls")??null,this.captions.replaceChildren(...(i.length>1?i:[]).map((p,x)=>O("span",{style:{left:`${u+x*h}px`,width:`${h}px`}},this.captionOf?.(p)??f[p]))),this.sides.forEach(p=>p.style.bottom=`${this.height-a+12}px`),this.sides[1].style.right=`${this.width-o+14}px`,this.picker.invalidate(),this.changed("camera")}setColumns(t,e=null,n=null){this.kinds=t,this.roomOf=n,this.captionOf=e,this.arrange(),this.home()}commonRoom(t){let e=this.node.parentElement?.clientWidth??this.width,n=this.overlay.dock.place(e,this.height),i=n&&n.width<e;return[Math.min((i?n.left:e)/3,(e-t)/2),n&&!i?n.top:this.height]}faceHeight(t){let e=this.columns.find(i=>i.kind===t);if(!e)return 0;let n=this.session.section.frame.map(i=>this.camera.projector(e)(i)[1]);return Math.max(...n)-Math.min(...n)}home(t=0,e=0){this.camera.turn(t,e);let n=this.columns[0]??{width:1,height:1};this.camera.frame(this.session.section.frame,n.width,n.height),this.closeness=this.camera.distance,this.changed("camera")}shownElements(){return this.session.elements.list.filter(t=>this.session.isShown(t))}lookAs({target:t,towards:e,distance:n,aspect:i}){let{width:r,height:o}=this.controlsColumn??this.columns[0];this.camera.lookFrom([...t],e,n*Math.max(1,i*o/r)),this.changed("camera")}frameClosely(){let{session:t,camera:e}=this,n=()=>JSON.stringify([e.target,e.towards,e.distance,[...t.selection]]);if(this.closeLook?.where===n()){let{target:u,towards:f,distance:p}=this.closeLook.before;e.lookFrom(u,f,p),this.closeLook=null,this.changed("camera");return}let{target:i,towards:r,distance:o}=e,a=this.shownElements().filter(u=>!u.onBoard),l=t.selectedElements.filter(u=>!u.onBoard),c=l.length?l:a,h=this.columns[0],d=c.flatMap(u=>u.tracks.flat());e.frame(d,h.width,h.height,l.length?3:1.2),this.closeLook={where:n(),before:{target:i,towards:r,distance:o}},this.changed("camera")}locate(t){let e=this.surface.getBoundingClientRect(),n={x:t.clientX-e.left,y:t.clientY-e.top};return{...n,column:this.overlay.dock.contains(n)?null:this.columns.find(i=>Zr(i,n))??null}}controlsAt(t){return this.overlay.dock.contains(t)||t.column!==null&&t.column===this.controlsColumn}elementAt(t,e=0){return this.controlsAt(t)?this.overlay.elementAt(t.x,t.y,e):null}dive(t){let{camera:e}=this;return e.distance<.7*this.closeness?this.home(e.azimuth,e.elevation):(e.target=this.session.shown(t),e.zoom(.4),this.changed("camera"))}pick({x:t,y:e,column:n}){return n?this.picker.pick(this.camera,n,t,e):null}freshen(){this.gestures.flush(),this.stale.size&&this.drawNow()}frame(t){this.gestures.flush(),this.pace(t),(this.stale.size||this.repaint)&&this.drawNow()}lookThroughShot(){let{camera:t,session:e}=this,{shotCamera:n,timeCodes:i}=e.character,r=()=>[t.half,t.distance,...t.target,...t.towards].join();if(!e.options.shot)this.shotLook=null;else if(this.shotLook&&this.shotLook!==r())e.setOption("shot",!1);else{let o=Math.round(e.frame-(i?.[0]??e.frame));t.lookThrough(n[Vt(o,0,n.length-1)],this.columns[0]),this.shotLook=r()}}drawNow(){let{stale:t}=this;t.has("camera")&&this.lookThroughShot(),this.repaint&&this.paint(),t.has("pose")&&this.stage.refresh(),(t.has("pose")||t.has("camera"))&&this.picker.invalidate();let e=t.has("pose")||t.has("camera")||this.repaint;this.repaint=!1;let n=t.has("camera");t.clear(),e&&(this.stage.draw(this.columns,this.camera),this.drawn++),this.arrangeOverlay(n),this.overlay.draw(this.review?.lines(),this.trails?.shown()),this.onion.follow(),this.placeTip(),this.nameSides()}arrangeOverlay(t){let e=this.controlsColumn;if(!e)return;let{session:n,camera:i,picker:r}=this,o=.8*n.elements.width,a=n.dragging!==null&&!t,c=n.options.occlusion==="overlay"?()=>!1:a?null:h=>r.hides(i,e,h,o);this.overlay.arrange(e,i,c)}pace(t){let e=this.stale.has("pose")||this.stale.has("camera")||this.repaint;e&&this.fineness>this.brisk&&this.setFineness(this.brisk),e&&this.lastFrame&&t-this.lastFrame<400?(this.average=.8*(this.average??0)+.2*(t-this.lastFrame),this.average>Kb&&this.fineness>.5&&this.setFineness(this.fineness-.25)):this.average=0,this.lastFrame=e?t:null,clearTimeout(this.settling),this.fineness!==this.finest&&(this.settling=setTimeout(()=>this.sharpen(),sm))}get brisk(){if(this.stage.drawnBy!=="processor")return 1;let t=Math.sqrt(Zb/(this.width*this.height));return Math.min(1,Math.floor(Oi*t)/Oi/this.ratio)}get finest(){return this.stage.drawnBy==="processor"&&this.ratio<rm&&this.stage.triangles.length<=3*Jb?rm:1}sharpen(){this.gestures.active?this.settling=setTimeout(()=>this.sharpen(),sm):(this.setFineness(this.finest),this.drawNow())}setFineness(t){this.fineness=t,this.average=0,this.stage.resize(this.width,this.height,this.ratio*t),this.stale.add("camera")}paint(){let{session:t}=this,e=t.dragging!==null,n=this.showsInfluence?[...t.selectedElements,t.hover].filter(Boolean):t.hover&&!t.quiet?[t.hover]:[],i=this.pointedControl??n.flatMap(a=>a.members.map(({control:l})=>l)),r=Array.isArray(i)?i:[i],o=t.options.heat&&!e&&r.length;this.stage.paint(o?t.influence.ofControls(r):null)}hold(t,e){this[t]=e;for(let{style:n}of[this.overlay.canvas,this.tip])n.visibility=this.bare?"hidden":"";this.repaint=!0,this.request()}pointAt(t){this.pointedControl=t===null?null:[t],this.repaint=!0,this.request()}placeTip(){let{hover:t,dragging:e,controls:n}=this.session,i=e&&e!=="skin"?e:t,r=i&&this.overlay.drawn.find(d=>d.element===i);if(this.tip.hidden=!r||!this.session.options.handles,this.tip.hidden)return;let o=i.members.map(({control:d})=>O("div",{},O("b",{},this.session.worded(d)),` ${n[d].label}`)),a=O("div",{class:"tip-side",style:{borderColor:this.session.colours[i.side]}},Vs(i.side));this.tip.replaceChildren(...Vs(i.side)?[a]:[],...o);let[l,c]=r.handle,h=l+230>this.width;this.tip.style.transform=`translate(${Math.round(h?l-18:l+18)}px, ${Math.round(c-12)}px) translateX(${h?-100:0}%)`}nameSides(){let t=this.session.character.layout.planeNormal,e=vt(t,this.camera.right),n=Math.abs(e)<.25?[null,null]:e>0?["right","left"]:["left","right"];this.sides.forEach((i,r)=>{let o=n[r];i.hidden=!o||!this.session.options.handles,o&&(i.textContent=r===0?`◂ Character’s ${o}`:`Character’s ${o} ▸`,i.style.borderColor=this.session.colours[o])})}setCursor(t){this.surface.style.cursor=t}showInfluences(t){this.onInfluences?.(t)}};function jb(){let s=new URLSearchParams(window.location.hash.slice(1)).get("draw");return s==="webgl"||s==="canvas"?s:null}function Vs(s){return{left:"Character’s left",right:"Character’s right",middle:"Middle",none:""}[s]}var Qb=12,Ll=class{constructor(t,e,n,i){this.session=t,this.view=e,this.timeline=n,this.say=i,this.numbers=[],this.chosen=O("div",{class:"chosen"}),this.ranked=O("div",{class:"ranked"}),this.influences=Qi("Acts here",this.ranked,!1),this.influences.hidden=!0,this.node=O("aside",{class:"inspector","aria-label":"Inspector"},Qi("Selection",this.chosen),this.influences,Qi("Display",this.display()),Qi("Pulling the skin",this.pulling(),!1),Qi("Pose",this.poses()),Qi("Shelf",new bo(t,e,i).node),Qi("Layout",this.layout(),!1)),e.onInfluences=r=>this.showInfluences(r),t.on("selection",()=>{this.choosing||(this.influences.hidden=!0),this.showSelection()}),t.on("pose",()=>this.updateNumbers()),this.showSelection()}showSelection(){let{session:t}=this,e=t.selectedElements;if(this.numbers=[],!e.length){this.chosen.replaceChildren(Me("Drag a handle, or pull the skin. Click the skin to see what acts there; shift-drag selects."));return}this.chosen.replaceChildren(...e.slice(0,8).map(n=>this.elementCard(n)),...e.length>8?[Me(`and ${e.length-8} more`)]:[],je(yt("Zero","Selected controls to their defaults (0)",()=>t.zero(t.chosenControls)),yt("Reset","Selected controls to the base pose (R)",()=>t.reset(t.chosenControls)),yt("Hide","Hide the selected elements",()=>t.hide(t.selectedElements)),yt("Key","Key the selected controls and all that changed, at this frame (K)",()=>this.timeline.key()))),this.updateNumbers()}elementCard(t){let e=[Vs(t.side),t.onBoard?Js(t):""].filter(Boolean).join(" · ");return O("div",{class:"card",style:{borderLeftColor:this.session.colours[t.side]}},O("div",{class:"card-title"},t.label),e?Me(e):null,this.levelButton(t),...t.members.map(({control:n})=>this.numberRow(n)),t.reason?Me(`${is(t.reason)}.`):null)}levelButton(t){let e=this.session.levels.coarseOf(t);if(!e.length)return null;let[n,i]=t.inner.length?[`Open: ${t.inner.length} members`,"Show its members in its place (M)"]:[`Close ${e.map(r=>r.label).join(", ")}`,"Show it again in place of its members (M)"];return yt(n,i,()=>this.session.openOrClose([t]),{class:"level"})}numberRow(t){let{session:e}=this,n=e.controls[t],{minimum:i,maximum:r}=n,o=Kr(e,t,{type:"number",step:(r-i)/100,min:i,max:r},"number");this.numbers.push({input:o,index:t});let a=`${e.worded(t,i)} … ${e.worded(t,r)}`;return O("label",{class:"number-row",title:`${n.name}: ${a}`},qs(n.label),o)}updateNumbers(){for(let{input:t,index:e}of this.numbers)document.activeElement!==t&&(t.value=this.session.worded(e))}showInfluences(t){let{session:e,view:n}=this,i=e.place(t),r=e.influence.rank(e.values,()=>e.traced(i));e.deformer.drive(e.values),this.influences.hidden=!1,this.influences.open=!0,this.ranked.replaceChildren(...r.length?[]:[Me("No control moves this point.")],...r.slice(0,Qb).map(({control:o,share:a})=>{let{label:l,name:c}=e.controls[o],h=e.elements.byControl.get(o),d=Math.round(100*a),u=p=>{this.choosing=!0,h&&e.select([h],p.shiftKey?"toggle":"replace"),this.choosing=!1},f=yt(qs(l),l,u,{class:"ranked-row","aria-label":l,"data-control":c,onpointerenter:()=>n.pointAt(o),onpointerleave:()=>n.pointAt(null)});return f.prepend(O("i",{style:{width:`${d}%`,background:e.colours[h?.side??"none"]}})),f.append(O("small",{},`${d} %`)),f})),this.influences.scrollIntoView({block:"nearest"})}option(t,e,n){let{session:i}=this,r=fi(n,e,()=>i.options[t],o=>i.setOption(t,o));return O("div",{class:"field"},O("span",{},n),i.updating(r))}check(t,e,n){let{session:i}=this,r=O("input",{type:"checkbox",onchange:()=>i.setOption(t,r.checked)});return r.update=()=>r.checked=i.options[t],O("label",{class:"check",title:n},i.updating(r),e)}slide(t,e,n,i,r){let{session:o}=this,a={min:i,max:r,step:(r-i)/100,"aria-label":e},l=Yr(a,()=>o.options[t],c=>o.setOption(t,c));return di(e,o.updating(l),{title:n})}display(){let{session:t}=this,e=yt("Show hidden elements","",()=>t.showAll());return e.update=()=>e.hidden=!t.hidden.size,O("div",{},this.option("occlusion",[["overlay","Overlay","Draw everything on top"],["ghost","Ghost","Draw what the face covers faintly"],["hide","Depth","Do not draw what the face covers"]],"Covered"),this.option("labels",[["hover","Hover","Name the handle under the pointer"],["all","All","Name every handle (L)"]],"Labels"),this.slide("opacity","Opacity","How strongly handles and tracks are drawn",.1,1),this.check("fade","Fade the others while dragging"),this.check("heat","Show the area of influence","Heat map of the hovered or selected control"),this.check("onion","Onion skin","The keys before and after as outlines, amber and blue (O)"),this.check("trails","Motion trails","The ways of the selected handles on the face through the frames that play, a dot for each key (T)"),this.session.character.shotCamera&&this.check("shot","The shot's camera","Look as the camera of the stage does, frame by frame, until you turn, move or zoom (V)"),this.check("follow","Elements follow the skin","Off: they stay where they are at rest"),t.updating(e),t.updating(this.drawnBy()))}drawnBy(){let t=Me("Drawn by the processor: this browser has no WebGL, or only one in software.");return t.update=()=>t.hidden=this.view.stage.drawnBy!=="processor",t}pulling(){let{session:t}=this,e=O("div",{class:"field"});return e.update=()=>{let n=yt("Remove all","",()=>{t.pins=[],t.emit("options")});e.replaceChildren(O("span",{},`Pins: ${t.pins.length}`),t.pins.length?n:"")},O("div",{},this.check("skinDrag","The skin can be pulled"),this.slide("locality","Locality","Controls that matter less than this at the grabbed point stay as they are",.01,.6),t.updating(e),Me("Shift-click the skin to pin it; click a pin to take it out."))}poses(){let{session:t,say:e}=this;return je(yt("Zero all","Every control to its default",()=>t.zero()),yt("Reset all","Every control to the pose of the layout",()=>t.reset()),yt("Copy","Keep the values of the selection, or of all controls",()=>t.copy()),yt("Paste","Give the controls the values that were kept",()=>t.paste()),yt("Flip","The pose seen in a mirror",()=>t.flip()),yt("Left to right","The pose of the character’s left on its right, too",()=>t.mirror("left")),yt("Right to left","The pose of the character’s right on its left, too",()=>t.mirror("right")),yt("Copy JSON","The pose to the clipboard",()=>this.copy()),yt("Save JSON","Download the pose",()=>t.save("pose.json",{text:Rc(t)})),yt("Save pose layer","Download the pose as a USD layer",()=>t.save("pose.usda",td(t),e)),yt("Load…","A pose or layer saved before",()=>pi(".json,.usda,.usd",e,({text:n})=>this.load(n))))}async copy(){try{await navigator.clipboard.writeText(Rc(this.session)),this.say("Pose copied")}catch{this.say("The browser does not let this page write to the clipboard: use Save JSON")}}load(t){let{session:e}=this,{keys:n,constants:i}=t.startsWith("#usda")?id(t,e):{keys:new Map,constants:Cd(t,e)};n.size?e.load("Load keys",n,i):e.edit("Load pose",()=>e.set(i)),this.say("Pose loaded")}layout(){let{session:t,view:e}=this,{layout:n}=t.character,i=Me();i.update=()=>{let c=e.rearranging.moved.size;i.textContent=c?`${ce(c,"element")} moved`:"Drag an element to another point of the face, or off it.",o.disabled=!c};let r=Nn("Rearrange","Drag elements to other points of the face",()=>t.options.rearrange,()=>t.flipOption("rearrange")),o=yt("Save corrections","Download the changes for `usdrigui process --corrections`: they hold for every later version",()=>Mn(t.fileNamed("corrections.usda"),e.rearranging.corrections())),a=[`${n.elements.length} elements, ${t.controls.length} controls`,n.leftOff.length?`${n.leftOff.length} left off`:null].filter(Boolean),l=n.leftOff.map(([c,,h])=>O("li",{},O("b",{},c),` ${h}`));return O("div",{},je(t.updating(r),o),t.updating(i),Me(a.join(" · ")),l.length?O("details",{class:"left-off"},O("summary",{},"Left off"),O("ul",{},...l)):null)}};function Qi(s,t,e=!0){return O("details",{class:"section",open:e},O("summary",{},s),t)}var tw=.02,om={ArrowRight:[1,0],ArrowLeft:[-1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},ew=300,Nl=class{constructor(t,e){this.session=t,this.view=e,this.nodes=t.elements.list.map(n=>this.makeStop(n)),e.node.append(O("div",{class:"stops",role:"group","aria-label":"Elements on the face"},...this.nodes)),t.on("pose",()=>this.speakSoon()),t.on("options",()=>this.leaveOut()),this.leaveOut(),this.speak()}makeStop(t){let{session:e}=this,n=Vs(t.side);return O("div",{role:"slider",tabIndex:0,"aria-label":n?`${t.label}, ${n}`:t.label,"data-element":t.name,onfocus:()=>{e.select([t]),e.setHover(t)},onblur:()=>e.setHover(null),onkeydown:i=>this.key(i,t)})}leaveOut(){this.nodes.forEach((t,e)=>t.hidden=!this.session.isShown(this.session.elements.list[e]))}speakSoon(){let t=this.nodes.indexOf(document.activeElement);t>=0&&this.speak([t]),clearTimeout(this.resting),this.resting=setTimeout(()=>this.speak(),ew)}speak(t=this.nodes.keys()){for(let e of t){let n=this.session.elements.list[e],[i]=n.members,{minimum:r,maximum:o}=this.session.controls[i.control],a=n.members.map(({control:l})=>`${this.session.controls[l].label} ${this.session.worded(l)}`);Zn(this.nodes[e],{"aria-valuemin":r,"aria-valuemax":o,"aria-valuenow":this.session.values[i.control],"aria-valuetext":a.join(", ")})}}key(t,e){let n=t.shiftKey?5:t.ctrlKey||t.metaKey?.1:1;if(om[t.key]){let[i,r]=this.along(e,om[t.key]);this.nudge(e,i,r*tw*n)}else if(t.key==="Home"||t.key==="End")this.nudge(e,0,t.key==="Home"?-1/0:1/0);else return;t.preventDefault(),t.stopPropagation()}along(t,[e,n]){return t.axes.length===1?[0,e-n]:Vd(this.view.beginDrag(t),[e,n])}nudge(t,e,n){let{session:i}=this,r=So(t,e,n,i.controls,i.rest,i.values);i.edit(`Nudge ${t.label}`,()=>i.set(r),`nudge ${t.index}`)}},am="input[type=text], input[type=number], input[type=search], textarea";function lm(){let s=document.activeElement;return!(s instanceof HTMLElement)||!s.matches(am)?!1:(s.blur(),!0)}var nw=250;function cm(s,t={},e=n=>n===""){let n=new Map,i=o=>!o.target.matches(am);document.addEventListener("keydown",o=>{let a=o.target,l=[o.ctrlKey||o.metaKey?"Ctrl+":"",o.shiftKey?"Shift+":"",o.key.length===1?o.key.toLowerCase():o.key].join("");if(!i(o)&&l!=="Escape"||e(l))return;if(t[l]){!o.repeat&&!n.has(l)&&n.set(l,performance.now()),o.repeat||t[l](!0),o.preventDefault();return}let c=s[l];c&&(a.matches("button, summary, a")&&(l===" "||l==="Enter")||c()!==!1&&o.preventDefault())});let r=o=>{let a=n.get(o);a!==void 0&&(n.delete(o),t[o](!1),performance.now()-a<nw&&s[o]?.())};document.addEventListener("keyup",o=>r(o.key.toLowerCase())),window.addEventListener("blur",()=>[...n.keys()].forEach(r))}function kr(s,t,e){let n=[],i=(c,h,d,u)=>Ur(d,h)?u:Ur(u,h)||Ur(d,u)?d:(n.push(c),d??u),r=hm(s.keys,t.keys,e.keys,(c,...h)=>{let[d,u,f]=h.map(m=>new Map((m??[]).map(g=>[g[0],g]))),x=Se([...d.keys(),...u.keys(),...f.keys()]).map(m=>i([c,m],d.get(m),u.get(m),f.get(m))).filter(Boolean);return x.length?x:void 0}),o=hm(s.standing,t.standing,e.standing,(c,...h)=>i([c,null],...h)),a=i(["frames",null],s.span,t.span,e.span),l={keys:r,standing:o,...a&&{span:a}};return{work:l,conflicts:n,taken:uu(t,l)}}var hu={keys:{},standing:{}};function uu(s,t){let e=n=>um(s[n],t[n]).filter(i=>!Ur(s[n][i],t[n][i]));return[...new Set([...e("keys"),...e("standing"),...Ur(s.span,t.span)?[]:["frames"]])]}function hm(s,t,e,n){let i=um(s,t,e).map(r=>[r,n(r,s[r],t[r],e[r])]);return Object.fromEntries(i.filter(([,r])=>r!==void 0))}var um=(...s)=>[...new Set(s.flatMap(Object.keys))].sort(),Ur=(s,t)=>JSON.stringify(s)===JSON.stringify(t);var iw=1e-5;function dm(s,t,{changed:e,names:n,written:i}){let{controls:r,animation:o}=s,a=Kn(t,s),l=new Map(a.keys),c=new Map(a.constants),h=Object.fromEntries(Object.entries(e).map(([f,p])=>[f,Uu(p)])),d=new Map,u=f=>re(d,f,()=>Zs(s,[f],p=>o.at(p,a))[0]);return r.forEach(({attribute:f,minimum:p,maximum:x},m)=>{let{samples:g,one:M}=h[f]??{samples:[],one:null},A=f in h&&i.includes(f),b=(l.get(m)??[]).filter(([C])=>!A||M!==null||g.some(([L])=>L===C)),T=!g.length&&M!==null,E=o.isAnimated(m,l),y=b.length?b.map(([C])=>C):o.range(a.keys,a.span),w=[...sw(s,m,h,n,u),...T&&E?y.map(C=>[C,M]):g],D=([C,L])=>L!==null&&Math.abs(L-u(C).values[m])>iw*(x-p);l.set(m,w.filter(D).reduce((C,L)=>qr(C,...L),b)),T&&!E?c.set(m,M):A&&!g.length&&c.delete(m)}),{...a,keys:new Map([...l].filter(([,f])=>f.length)),constants:c}}function sw({animation:s,controls:t,character:{channels:e,joints:n,skeletons:i}},r,o,a,l){let{reading:c}=t[r];if(!c)return[];let[h,d]=c.rises?.[0]??[],u=n[c.joint];if(!u&&t.some(({reading:g})=>g?.rises?.[0][0]===h&&g.rises.length<c.rises.length))return[];let{token:f,index:p,animation:x}=u?{token:u.path,animation:fo(i[u.skeleton])}:e[h];return Object.entries(o).filter(([g])=>g.endsWith(`${x}.${u?"rotations":"blendShapeWeights"}`)).flatMap(([g,{samples:M}])=>{let A=ac(a[g.replace(/\w+$/,u?"joints":"blendShapes")]??"");return M.map(([b,T])=>{let{values:E,weights:y,locals:w}=l(b),D=T?.[A.length?A.indexOf(f):p],[C,L,F,W]=u&&D||[],I=z=>s.turned(c,z);return[b,E[r]+(u?I(Ks([C,L,F,W]))-I(Jn(w[c.joint]).rotation):((D??NaN)-y[h])/d)]})})}var rw=300,ow=3,fm={open:"reading",saved:"saved",unsaved:"saving",lost:"link lost: save before you close"},aw={saved:"Every change is in this layer",lost:"The command that serves this page has ended; the browser keeps your work, and Save animation layer downloads it"},Dl=class{constructor(t,e,n,i="edit"){this.sessions=t,this.name=e,this.say=n,this.address=i,this.base=new Map,this.others=[],this.asked=[],this.revision="",this.changed=!1,this.isAhead=!1,this.waited=0,this.state="open",this.refusal=""}makeNode(){return this.words=O("output",{class:"link",role:"status"}),this.button=yt("Take theirs","What was changed here and elsewhere is as here now",()=>this.takeTheirs(),{hidden:!0}),this.tell(this.state),O("div",{class:"group live"},this.words,this.button)}follow(t){for(let e of["changed","time"])t.on(e,()=>this.changed=!0)}async run(){await this.turn(),setTimeout(()=>this.run(),rw)}async turn(){if(!this.isBusy)try{let t=this.waited++%ow===0;this.changed&&this.revision&&(t||!this.refusal)?await this.push():t&&await this.pull()}catch(t){if(!(t instanceof TypeError))throw t;this.tell("lost")}}get isBusy(){return this.sessions.some(({dragging:t,trial:e})=>t||e)}holds(t){return this.state==="saved"&&this.agrees(t)}agrees(t,e=cs(t)){return!uu(this.baseOf(t),e).length}async push(){this.changed=!1;let t=new Map(this.sessions.map(i=>[i,cs(i)]));if(!this.isAhead&&this.sessions.every(i=>this.agrees(i,t.get(i)))){this.tell();return}this.refusal||this.tell("unsaved");let e=ju(this.sessions,i=>t.get(i),this.others),n=await this.send("PUT",{"If-Match":this.revision},e);n.status===412?(this.changed=!0,await this.pull()):n.ok?(this.revision=n.headers.get("ETag")??"",this.isAhead=!1,this.base=t,this.tell()):(this.changed=!0,await this.refuse(n))}async refuse(t){let e=t.status===404?fm.lost:(await t.text()).trim();e!==this.refusal&&this.say(`${this.name}: ${e}`),this.tell("refused",e)}takeTheirs(){this.asked.splice(0).forEach(({session:t,here:e,there:n})=>pm(t,e,n)),this.changed=!0,this.tell()}async pull(){let t=await this.send("GET",{"If-None-Match":this.revision});if(t.status===304)this.tell();else if(t.ok){let e=await t.text();if(this.isBusy)return;let n=!this.revision;this.revision=t.headers.get("ETag")??"",this.take(e,n)}else await this.refuse(t)}take(t,e){if(!t){e||this.say(`${this.name} is gone: the next change writes it anew`),this.base.clear(),this.tell("saved");return}let n=JSON.parse(t);this.isAhead=Object.keys(n.changed).length>0,this.others=mc(n.work);for(let i of this.sessions){let r=this.others.find(({root:a})=>a===i.character.root)??hu,o=this.others.length?r:this.baseOf(i);this.merge(i,Yn(i,dm(i,o,n)),e);for(let{name:a}of i.controls)delete r.keys[a],delete r.standing[a]}this.tell()}merge(t,e,n){let i=this.baseOf(t),r=cs(t),{work:o,conflicts:a,taken:l}=kr(i,r,e);l.length&&(pm(t,i,e),n||this.say(`${this.name} changed elsewhere: ${mm(l.map(c=>gm(t,c)))}`)),this.base.set(t,e),this.changed||=this.isAhead||!this.agrees(t),a.length&&(this.say(`Changed here and elsewhere, as here now: ${mm(a.map(c=>lw(t,c)))}`),this.asked.push({session:t,conflicts:a,here:o,there:kr(i,e,r).work}))}baseOf(t){return this.base.get(t)??hu}send(t,e,n){return fetch(this.address,{method:t,headers:e,body:n,cache:"no-store",credentials:"omit",redirect:"error"})}tell(t=this.changed?"unsaved":"saved",e=""){this.asked=this.asked.filter(({session:n,here:i,there:r})=>kr(i,cs(n),r).taken.length),Object.assign(this,{state:t,refusal:e}),this.words&&(this.words.textContent=`${this.name}: ${e||fm[t]}`,this.words.title=aw[t]??"",this.words.classList.toggle("wrong",["lost","refused"].includes(t)),this.button.hidden=!this.asked.length)}},pm=(s,t,e)=>s.rebase(n=>Kn(kr(t,Yn(s,n),e).work,s)),mm=s=>s.length>4?`${s.slice(0,3).join(", ")} and ${s.length-3} more`:s.join(", "),gm=({controls:s},t)=>s.find(e=>e.name===t)?.label??t,lw=(s,[t,e])=>`${gm(s,t)}${e===null?"":` at frame ${e}`}`;var cw=.7,Ol=class{constructor(t,e,n,i,r,o){this.session=t,this.view=e,this.timeline=n,this.say=i,this.roots=r,this.partsOf=o,e.review=this,this.line=null,this.shown=[],this.list=O("div",{class:"notes"}),this.pen=Nn("Draw","Draw on the view: two fingers, the wheel and other buttons still move it",()=>t.options.draw,()=>this.setPen()),this.back=yt("Take back","Take away the last stroke of this note",()=>this.takeBack()),this.saving=yt("Save review","Download the notes as a small USD layer, to send",()=>this.save()),this.node=O("aside",{class:"review","aria-label":"Review"},je(yt("Add note","A note on the frame, the pose and the view shown now",()=>this.write()),this.pen,this.back,this.saving,yt("Open…","Add the notes of a review that somebody sent",()=>this.open())),this.list);for(let a of["time","options","editing"])t.on(a,()=>this.update());this.update()}get chosen(){return this.session.notes.find(({id:t})=>t===this.session.note)??null}isHere({frame:t,neutral:e}){return t===this.session.frame&&e===this.session.neutral}get seen(){let{chosen:t}=this;return t&&this.isHere(t)&&Gu(t.look,this.view.camera)?t:null}lines(){let{view:t,seen:e,line:n}=this;if(!t.controlsColumn)return[];let i=t.camera.projector(t.controlsColumn);return[...e?.strokes.map(o=>[e.look,o])??[],...n?[[n.look,n.pairs]]:[]].map(([o,a])=>a.map(l=>i(cc(o,l))))}setPen(t=!this.session.options.draw){this.session.setOption("draw",t)}note(t={}){let{session:e}=this,{frame:n,neutral:i,values:r,section:o}=e;return{id:crypto.getRandomValues(new Uint32Array(2)).join("-"),frame:n,neutral:i,text:"",done:!1,values:$s(e,r),section:o.title,look:this.look(),strokes:[],...t}}look(){return this.view.camera.leaveShot(),this.view.changed("camera"),Bu(this.view.camera,this.view.controlsColumn)}add(t,e){this.session.note=e.id,this.session.put(t,{notes:[...this.session.notes,e]})}write(){this.add("Add a note",this.note()),this.list.querySelector(".chosen textarea")?.focus()}change(t,e,n,i=null){this.session.put(t,{notes:this.session.notes.map(r=>r.id===e.id?{...r,...n}:r)},i)}remove(t){this.session.put("Take away a note",{notes:this.session.notes.filter(({id:e})=>e!==t.id)})}drawing(t){let{view:e,seen:n}=this,{camera:i,controlsColumn:r}=e,o=n?.look??this.look(),a=vt(ge(i.position,o.target),i.towards),l=h=>{this.line.pairs.push(...h.map(({x:d,y:u})=>zu(o,i.unproject(r,d,u,a)))),e.changed("overlay")},c=()=>{let h=Qr(this.line.pairs,cw*i.pixelSize(r.height)).map(d=>d.map(u=>Number(u.toPrecision(6))));this.line=null,n?this.change("Draw",n,{strokes:[...n.strokes,h]}):this.add("Draw",this.note({look:o,strokes:[h]}))};return{begin:()=>{this.line={look:o,pairs:[]},l([t])},drag:(h,d,u,f)=>l(f),drop:c,click:c,undo:()=>{this.line=null,e.changed("overlay")}}}takeBack(){let{chosen:t}=this;t?.strokes.length&&this.change("Take back a stroke",t,{strokes:t.strokes.slice(0,-1)})}show(t){let{session:e,view:n}=this,{sections:i}=e.character.layout,r=i.findIndex(({title:o})=>o===t.section);r>=0&&i[r]!==e.section&&e.show(r),this.timeline.stop(),this.isHere(t)||this.timeline.go(t.frame,t.neutral),n.lookAs(t.look),e.note=t.id,e.look(as(e,t)),e.emit("options")}update(){let{session:t,chosen:e}=this;this.pen.update(),this.back.disabled=!e?.strokes.length,this.saving.disabled=!t.notes.length;let n=[t.notes,t.note,e&&this.isHere(e),t.looks];if($n(n,this.shown)||(this.shown=n,this.view.changed("overlay"),this.typing))return;let i=Me("No notes yet. Pose the face or turn the view, then draw on it or add a note. Send the saved file back: `usdrigui view LAYER --review FILE` opens it.");this.list.replaceChildren(...t.notes.length?t.notes.map((r,o)=>this.item(r,o)):[i])}item(t,e){let n=t.id===this.session.note,i=t.strokes.length?`, ${ce(t.strokes.length,"stroke")}`:"",r=O("input",{type:"checkbox",checked:t.done,"aria-label":`Note ${e+1} is done`,title:"Done",onchange:()=>this.change("Tick a note",t,{done:r.checked})}),o=O("textarea",{value:t.text,rows:n?3:1,placeholder:"Comment","aria-label":`Comment of note ${e+1}`,oninput:()=>this.type(t,o.value)});return O("div",{class:`note${n?" chosen":""}${t.done?" done":""}`,"data-note":t.id},O("div",{class:"note-head"},yt(`${e+1} · ${dc(t)}${i}`,"Go to its frame, view and pose",()=>this.show(t),{class:"note-go"}),r,yt("×","Take this note away",()=>this.remove(t),{class:"note-away","aria-label":`Take note ${e+1} away`})),o,n?this.poseActions(t):null)}type(t,e){this.typing=!0,this.change("Write a comment",t,{text:e},`comment ${t.id}`),this.typing=!1}poseActions(t){let{session:e}=this;return e.looks?je(yt("Take this pose","Set the controls to the pose of the note",()=>e.adopt())):this.isHere(t)?je(yt("Set pose","Give the note the pose shown now",()=>this.change("Give a note the pose",t,{values:$s(e,e.values)}))):null}save(){Mn("review.usda",Hu(this.partsOf()));for(let[t]of this.partsOf())t.sent=t.notes;this.say(`Saved review.usda, ${ce(this.session.notes.length,"note")}`)}open(){return pi(".usda",this.say,({name:t,text:e})=>{let n=to(eo(e),this.session,this.roots);if(!n.length)throw new Error("The notes are of another character.");this.session.received=[...new Set([...this.session.received,...n.map(({id:i})=>i)])],this.session.put(`Open ${t}`,{notes:Ys(this.session.notes,n)}),this.say(`${ce(n.length,"note")} opened`)})}};var hw=.0003662109375,uw={u1:Uint8Array,u2:Uint16Array,i2:Int16Array,u4:Uint32Array,i4:Int32Array,f4:Float32Array,f8:Float64Array};async function xm(s){let t=Uint8Array.from(atob(s),l=>l.charCodeAt(0)),e=new Blob([t]).stream().pipeThrough(new DecompressionStream("deflate")),n=new Uint8Array(await new Response(e).arrayBuffer()),i=new DataView(n.buffer).getUint32(0,!0),r=JSON.parse(new TextDecoder().decode(n.subarray(4,4+i))),o=n.subarray(4+i);r.characters.forEach(l=>fw(l,o));let a=await dw((r.images??[]).map(l=>tn(l,o)));for(let l of r.characters)l.texture=a;return r}async function dw(s){if(!s.length||typeof createImageBitmap>"u")return null;let t=await Promise.all(s.map(l=>createImageBitmap(new Blob([l]),{colorSpaceConversion:"none"}))),e=Math.max(...t.flatMap(({width:l,height:c})=>[l,c])),n=Math.ceil(Math.sqrt(t.length)),[i,r]=[n*e,Math.ceil(t.length/n)*e],o=Object.assign(document.createElement("canvas"),{width:i,height:r}).getContext("2d"),a=t.map((l,c)=>[c%n*e,Math.floor(c/n)*e,l.width,l.height]);return t.forEach((l,c)=>o.drawImage(l,a[c][0],a[c][1])),{width:i,height:r,boxes:a,texels:new Int32Array(o.getImageData(0,0,i,r).data.buffer)}}function fw(s,t){s.bind=tn(s.bind,t),s.base=tn(s.base,t);let e=0;for(let n of s.meshes){if(n.points=mw(tn(n.points,t),n.low,n.step),n.count=n.points.length/3,n.start=e,e+=n.count,n.triangles=tn(n.triangles,t),n.texture)for(let i of["uv","images"])n.texture[i]=tn(n.texture[i],t);n.colours=tn(n.colours,t),n.gaze=n.gaze&&Float32Array.from(tn(n.gaze,t),i=>i*hw);for(let i of n.shapes)i.points=tn(i.points,t),i.offsets=tn(i.offsets,t);n.skin&&pw(n.skin,t)}s.pointCount=e,s.shotCamera=s.shotCamera?.map(n=>[0,3,6,9,12].map(i=>n.slice(i,i+3))),s.clip&&(s.clip.weights=tn(s.clip.weights,t),s.clip.locals=tn(s.clip.locals,t))}function pw(s,t){let[e,n]=s.joints.shape;s.rows=e,s.width=n,s.joints=tn(s.joints,t);let i=tn(s.weights,t);s.weights=new Float64Array(i.length);for(let r=0;r<e;r++){let o=i.subarray(r*n,(r+1)*n).reduce((l,c)=>l+c,0),a=Math.abs(o-65535)<=n?o:65535;for(let l=r*n;l<(r+1)*n;l++)s.weights[l]=i[l]/a}}function tn(s,t){let e=uw[s.kind],n=e.BYTES_PER_ELEMENT,i=s.shape.reduce((a,l)=>a*l,1),r=new Uint8Array(i*n);for(let a=0;a<n;a++){let l=s.at+a*i;for(let c=0;c<i;c++)r[c*n+a]=t[l+c]}let o=new e(r.buffer);if(s.sum)for(let a=1;a<i;a++)o[a]+=o[a-1];return o}var mw=(s,t,e)=>Float32Array.from(s,(n,i)=>t[i%3]+n*e[i%3]);var gw=[1,48],xw=24,yw=1e-6,Fl=class{constructor(t,e){this.character=t,this.controls=t.controls,this.clip=t.clip,this.rest=e;let[n,i,r]=t.timeCodes??[...gw,xw];this.rate=this.clip?.framesPerSecond||r;let o=this.clip&&this.clip.times.length>1?this.clip.times:[n,i];this.first=Math.floor(o[0]),this.last=Math.max(this.first+1,Math.ceil(o.at(-1))),this.span=null,this.readings=this.controls.map(({reading:a})=>this.clip&&a),this.moving=this.readings.map(a=>a!==null&&this.isMoved(a)),this.recent=new Map}isMoved({rises:t,joint:e}){let{weights:n,locals:i,times:r}=this.clip,o=(a,l,c,h)=>{for(let d=c;d<c+h;d++)for(let u=1;u<r.length;u++)if(Math.abs(a[u*l+d]-a[d])>yw)return!0;return!1};return t?o(n,this.character.channels.length,t[0][0],1):o(i,16*this.character.joints.length,16*e,11)}isAnimated(t,e){return e.has(t)||this.moving[t]}at(t,{keys:e,constants:n}){let{values:i,weights:r,locals:o}=this.clipAt(t),a=Float64Array.from(i);for(let[l,c]of n)this.isAnimated(l,e)||(a[l]=c);for(let[l,c]of e)a[l]=du(c,t,this.moving[l]?h=>this.clipAt(h).values[l]:null);return{values:a,weights:r,locals:o}}get isFree(){return!(this.clip?.times.length>1)}range(t,e=this.span){let n=[...t.values()].flatMap(o=>[o[0][0],o.at(-1)[0]]),[i,r]=e??[this.first,this.last];return[Math.min(i,...n.map(Math.floor)),Math.max(r,...n.map(Math.ceil))]}times(t,e=this.span){let[n,i]=this.range(t,e),r=new Set(this.clip?.times??[]);for(let o=n;o<=i;o++)r.add(o);for(let[o,a]of t){for(let[l]of a)r.add(l);for(let l of $r(a))r.add(l);this.moving[o]&&r.add(a[0][0]-1).add(a.at(-1)[0]+1)}return Se(r)}clipAt(t){return this.clip?re(this.recent,t,()=>(this.recent.size>=4&&this.recent.delete(this.recent.keys().next().value),this.readClip(t))):{values:this.rest,weights:null,locals:null}}readClip(t){let e=this.weightsAt(t),n=this.localsAt(t),i=new Map,r=Float64Array.from(this.controls,(o,a)=>{let l=this.readings[a];if(!l)return o.default;let{rises:c,joint:h}=l,d=c?(e[c[0][0]]-this.character.baseWeights[c[0][0]])/c[0][1]:this.turned(l,Jn(n.subarray(16*h,16*h+16)).rotation);if(!c){let u=i.get(h)??[0,0,0];i.set(h,u.map((f,p)=>f+d*l.turn[p]))}return o.default+d});this.readings.forEach((o,a)=>{let l=r[a]-this.controls[a].default;o?.rises?.forEach(([c,h])=>e[c]-=l*h)});for(let[o,a]of i)vw(n.subarray(16*o,16*o+16),a);return{values:r,weights:e,locals:n}}turned({joint:t,turn:e},n){let i=Jn(this.character.base.subarray(16*t,16*t+16)).rotation,r=$u(On(n,ls(i)));return vt(r,e)/vt(e,e)}weightsAt(t){let{low:e,high:n,share:i}=this.between(t),r=this.character.channels.length,{weights:o}=this.clip;return Float64Array.from({length:r},(a,l)=>Ee(o[e*r+l],o[n*r+l],i))}localsAt(t){let{low:e,high:n,share:i}=this.between(t),r=16*this.character.joints.length,o=l=>this.clip.locals.subarray(l*r,(l+1)*r),a=Float64Array.from(o(e));if(i===0)return a;for(let l=0;l<r;l+=16){let[c,h]=[o(e),o(n)].map(d=>d.subarray(l,l+16));c.some((d,u)=>d!==h[u])&&a.set(Yu(c,h,i),l)}return a}between(t){let{times:e}=this.clip,n=Math.max(0,e.findLastIndex(o=>o<=t)),i=Math.min(n+1,e.length-1),r=i>n?Math.max(0,(t-e[n])/(e[i]-e[n])):0;return{low:n,high:i,share:r}}};function du(s,t,e){let n=s.findIndex(([a])=>a>=t);if(n>0)return Pu(s,n-1,t);let[i,r]=n===0?s[0]:s.at(-1),o=Math.abs(t-i);return!e||o===0?r:o>=1?e(t):Ee(r,e(i+Math.sign(t-i)),o)}function vw(s,t){let{stretch:e,rotation:n}=Jn(s),i=lo(...t.map(o=>-o)),r=On(e,On(i,n));for(let o=0;o<3;o++)s.set(r.slice(3*o,3*o+3),4*o)}var ym=1e6,fu=(s,t)=>t.flatMap(([e,n])=>(s.get(e)??[]).filter(([i])=>i===n).map(i=>[e,i]));function vm(s,t,e,n=!1){let i=fu(s,t).map(([r,o])=>{let[a,l]=e(o,r),c=(e([o[0]+ym,o[1]],r)[0]-a)/ym;return[r,[a,l,en(o),o.length>3&&c?o[3]/c:null]]});return{keys:ts(n?s:Br(s,t),i),picked:new Set(i.map(([r,[o]])=>`${r} ${o}`))}}function ts(s,t){let e=new Map(s);for(let[n,i]of t)e.set(n,qr(e.get(n)??[],...i));return e}function Ul(s,t,e){if(!e)return i=>i+s;let n=t-e[0]>e[1]-t?e[0]:e[1];return i=>Math.round(n+(i-n)*(t+s-n)/(t-n))}function Br(s,t){let e=new Map(s);for(let[n,i]of t){let r=nc(e.get(n)??[],i);r.length?e.set(n,r):e.delete(n)}return e}var _m=(s,t,e)=>ts(t,fu(t,e).map(([n,[i,r]])=>[n,[i,r,s,null]]));function Mm(s,t){let e=Math.min(...t.map(([,n])=>n));return fu(s,t).map(([n,i])=>[n,[i[0]-e,...i.slice(1)]])}var bm=(s,t,e)=>ts(s,t.map(([n,[i,r,o="linear",a=null]])=>[n,[e+i,r,o,a]])),kl=(s,t,[e,n]=[-1/0,1/0])=>t.flatMap(i=>(s.get(i)??[]).filter(([r])=>r>=e&&r<=n).map(([r])=>[i,r]));function wm(s,t,e,n){return t.flatMap(i=>{let r=s.get(i)??[],[o,a]=[r.findLast(([l])=>l<e),r.find(([l])=>l>e)];return o&&a?[[i,o[1]+n*(a[1]-o[1])]]:[]})}function Sm({values:s,controls:t,rest:e,twins:n,opposites:i,crosses:r,mirrored:o}){return t.flatMap(({minimum:a,maximum:l},c)=>{if(n[c]>=0)return[[c,o(n[c],c)]];if(!r(c))return[];let[h]=i[c];return h!==void 0&&r(h)?[[c,o(h,c)]]:a<e[c]&&l>e[c]?[[c,2*e[c]-s[c]]]:[]})}function Am(s,{twins:t,sideOf:e,mirrored:n}){return[...t.entries()].filter(([i,r])=>r>=0&&e(i)===s).map(([i,r])=>[r,n(i,r)])}var _w=1e-8,Bl=class{constructor(t){this.joints=t.joints,this.count=this.joints.length,this.toRoot=t.skeletons.map(e=>e.toRoot.flat()),this.unbind=this.joints.map((e,n)=>so(t.bind.subarray(16*n,16*n+16))),this.restLocals=t.base,this.locals=t.base,this.factors=new Map,this.whole=[...this.joints.keys()]}setBase(t){this.locals=t??this.restLocals,this.factors.clear()}chainOf(t){let e=new Set;for(let n of t)for(;n>=0&&!e.has(n);n=this.joints[n].parent)e.add(n);return Se(e)}skinning(t,e=this.whole){let n=new Array(this.count),i=new Array(this.count);for(let r of e){let o=this.localAt(r,t),a=this.joints[r].parent;n[r]=a<0?o:un(o,n[a]),i[r]=un(this.unbind[r]??io,n[r])}return i}localAt(t,e){let n=this.locals.subarray(16*t,16*t+16),i=9*t;if(e.subarray(i,i+9).every(h=>h===0))return n;let{stretch:r,rotation:o}=re(this.factors,t,()=>Jn(n)),a=lo(e[i],e[i+1],e[i+2]),l=On(On(r,a),o),c=Array.from(n);for(let h=0;h<3;h++){let d=Math.exp(e[i+6+h]);for(let u=0;u<3;u++)c[4*h+u]=d*l[3*h+u];c[12+h]+=e[i+3+h]}return c}rowMap(t,e,n,i){let r=t.dualQuaternion?ww(t,e,i??Em(n)):bw(t,e,n),o=this.toRoot[this.joints[t.joints[0]].skeleton];return un(un(t.bind,r),o)}maps(t,e,n){let i=mu(t),r=this.toRoot[this.joints[t.joints[0]].skeleton];if(t.sumsToOne&&i.every(l=>Mw(e[l],e[i[0]],n)))return pu([un(un(t.bind,e[i[0]]),r)]);if(t.sumsToOne&&!t.dualQuaternion)return this.linearMaps(t,e,i,r);let o=t.dualQuaternion?Em(e):null,a=[];for(let l=0;l<t.rows;l++)a.push(this.rowMap(t,l,e,o));return pu(a)}linearMaps(t,e,n,i){let r=new Float64Array(12*this.count),o=pu(n.map(l=>un(un(t.bind,e[l]),i)));n.forEach((l,c)=>r.set(o.subarray(12*c,12*c+12),12*l));let a=new Float64Array(12*t.rows);for(let l=0,c=0;l<t.rows;l++)for(let h=c+t.width;c<h;c++){let d=t.weights[c];if(d===0)continue;let u=12*t.joints[c];for(let f=0;f<12;f++)a[12*l+f]+=d*r[u+f]}return a}};function Tm(s){s.bind=s.geomBind.flat(),s.sumsToOne=!0;for(let t=0;t<s.rows&&s.sumsToOne;t++){let e=0;for(let n=t*s.width;n<(t+1)*s.width;n++)e+=s.weights[n];s.sumsToOne=Math.abs(e-1)<=1e-6}}function mu(s){return s.used??=Se(s.joints.filter((t,e)=>s.weights[e]!==0)),s.used}function Mw(s,t,e){for(let n=0;n<15;n++)if(Math.abs(s[n]-t[n])>_w*(n>11?e:1))return!1;return!0}function pu(s){let t=new Float64Array(12*s.length);return s.forEach((e,n)=>{for(let i=0;i<4;i++)t.set([e[4*i],e[4*i+1],e[4*i+2]],12*n+3*i)}),t}function bw(s,t,e){let n=new Array(16).fill(0);for(let i=t*s.width;i<(t+1)*s.width;i++){let r=s.weights[i];if(r===0)continue;let o=e[s.joints[i]];for(let a=0;a<16;a++)n[a]+=r*o[a]}return n[15]=1,n}function Em(s){return s.map(t=>{let{stretch:e,rotation:n}=Jn(t),i=co(n),r=fc([0,t[12],t[13],t[14]],i).map(o=>.5*o);return{stretch:e,real:i,dual:r}})}function ww(s,t,e){let n=t*s.width,i=n;for(let p=n;p<n+s.width;p++)s.weights[p]>s.weights[i]&&(i=p);let r=e[s.joints[i]].real,o=new Array(9).fill(0),a=[0,0,0,0],l=[0,0,0,0];for(let p=n;p<n+s.width;p++){let x=s.weights[p];if(x===0)continue;let m=e[s.joints[p]],g=vt(m.real,r)<0?-x:x;for(let M=0;M<9;M++)o[M]+=x*m.stretch[M];for(let M=0;M<4;M++)a[M]+=g*m.real[M],l[M]+=g*m.dual[M]}let c=Math.hypot(...a)||1,h=a.map(p=>p/c),d=[h[0],-h[1],-h[2],-h[3]],u=fc(l.map(p=>p/c),d),f=On(o,Ks(h));return ro(f,2*u[1],2*u[2],2*u[3])}var zl=class{constructor(t){this.character=t,this.controls=t.controls,this.baseWeights=Float64Array.from(t.baseWeights),this.weights=new Float64Array(t.channels.length),this.moves=new Float64Array(9*t.joints.length),this.skeletons=new Bl(t),this.points=new Float32Array(3*t.pointCount);for(let e of t.meshes)Aw(e);this.jointsAt=null}setBase(t,e){this.baseWeights=Float64Array.from(t??this.character.baseWeights),this.skeletons.setBase(e),this.jointsAt=null}drive(t){this.weights.set(this.baseWeights),this.moves.fill(0);for(let e=0;e<this.controls.length;e++)t[e]!==this.controls[e].default&&this.addDrive(e,t[e])}addDrive(t,e,n=1){let{drive:i}=this.controls[t],[r,o]=Hr(i.values,e),a=(l,c)=>n*Ee(l[r][c],l[r+1][c],o);i.channels.forEach((l,c)=>this.weights[l]+=a(i.weights,c)),i.joints.forEach((l,c)=>{[i.rotations,i.translations,i.scales].forEach((h,d)=>{for(let u=0;u<3;u++){let f=9*l+3*d+u;this.moves[f]=Sw(this.moves[f]+n*Ee(h[r][c][u],h[r+1][c][u],o))}})})}pose(t){this.drive(t),this.updateMaps();for(let e of this.character.meshes)e.visible&&this.poseMesh(e);return this.points}posedAside(t){let e=this.points;this.points=new Float32Array(e.length);let n=this.pose(t);return this.points=e,n}updateMaps(){let{jointsAt:t,moves:e}=this;if(t&&e.every((i,r)=>i===t[r]))return;let n=this.skeletons.skinning(e);for(let i of this.character.meshes)i.skin&&(i.maps=this.skeletons.maps(i.skin,n,i.size)),i.plain=i.maps.length===12&&Cm(i.maps);this.jointsAt=e.slice()}poseMesh(t){let e=this.points.subarray(3*t.start,3*(t.start+t.count)),n=t.plain?e:t.blended??=new Float32Array(t.points.length);n.set(t.points);for(let i of t.shapes){let r=this.weights[i.channel];r!==0&&Ew(i,r,n)}t.plain||Tw(n,t.maps,e)}tracer(t,e,n=-1){let i=this.character.meshes[t],r=[];for(let a of i.shapes){let l=a.points.indexOf(e);l>=0&&r.push({shape:a,row:l})}let o={mesh:i,point:e,shapes:r,row:0,chain:[],skin:i.skin};if(i.skin&&n>=0)o.skin={...i.skin,joints:Uint16Array.of(n),weights:Float64Array.of(1),rows:1,width:1},o.chain=this.skeletons.chainOf([n]);else if(i.skin){o.row=i.skin.rows===1?0:e;let a=o.row*i.skin.width,l=i.skin.joints.subarray(a,a+i.skin.width);o.chain=this.skeletons.chainOf(l.filter((c,h)=>i.skin.weights[a+h]!==0))}return o}trace(t,e=this.traceMap(t)){let[n,i,r]=this.traceBlend(t);return oo(e,n,i,r)}traceBlend({mesh:t,point:e,shapes:n}){let i=Array.from(t.points.subarray(3*e,3*e+3));for(let{shape:r,row:o}of n){let a=this.weights[r.channel];a!==0&&Rm(r,a,(l,c)=>{let h=3*(l*r.points.length+o);for(let d=0;d<3;d++)i[d]+=c*r.step*r.offsets[h+d]})}return i}traceMap({mesh:t,skin:e,row:n,chain:i}){return e?this.skeletons.rowMap(e,n,this.skeletons.skinning(this.moves,i)):t.root}withControl(t,e,n,i){let{drive:r}=this.controls[t],o=r.channels.map(c=>this.weights[c]),a=r.joints.map(c=>this.moves.slice(9*c,9*c+9));this.addDrive(t,e,-1),this.addDrive(t,n);let l=i();return r.channels.forEach((c,h)=>this.weights[c]=o[h]),r.joints.forEach((c,h)=>this.moves.set(a[h],9*c)),l}},Sw=s=>Math.abs(s)<1e-14?0:s;function Aw(s){s.root=s.toRoot.flat(),s.size=s.points.reduce((t,e)=>Math.max(t,Math.abs(e)),1e-30),s.maps=Float64Array.from([0,1,2,3].flatMap(t=>s.root.slice(4*t,4*t+3))),s.plain=Cm(s.maps),s.skin&&(Tm(s.skin),mu(s.skin));for(let t of s.shapes)t.nodes=Se([...t.weights,0]),t.zero=t.nodes.indexOf(0)}function Cm(s){return[1,0,0,0,1,0,0,0,1,0,0,0].every((t,e)=>Math.abs(s[e]-t)<1e-12)}function Rm(s,t,e){if(s.weights.length===1){e(0,t);return}let[n,i]=Hr(s.nodes,t);for(let[r,o]of[[n,1-i],[n+1,i]])r!==s.zero&&o!==0&&e(r>s.zero?r-1:r,o)}function Ew(s,t,e){let{points:n,offsets:i,step:r}=s,o=n.length;Rm(s,t,(a,l)=>{let c=l*r,h=3*a*o;for(let d=0;d<o;d++,h+=3){let u=3*n[d];e[u]+=c*i[h],e[u+1]+=c*i[h+1],e[u+2]+=c*i[h+2]}})}function Tw(s,t,e){let n=t.length===12?0:12;for(let i=0,r=0;i<s.length;i+=3,r+=n){let o=s[i],a=s[i+1],l=s[i+2];e[i]=o*t[r]+a*t[r+3]+l*t[r+6]+t[r+9],e[i+1]=o*t[r+1]+a*t[r+4]+l*t[r+7]+t[r+10],e[i+2]=o*t[r+2]+a*t[r+5]+l*t[r+8]+t[r+11]}}var Gl=class{width;constructor(t,e){this.deformer=e,this.rest=Cw(t),this.list=t.layout.elements.map((n,i)=>({...n,index:i})),this.byControl=new Map;for(let n of this.list){for(let i of n.members)this.claim(i.control,n);this.prepare(n)}}claim(t,e){this.byControl.get(t)?.inner.includes(e.name)||this.byControl.set(t,e)}prepare(t){let{deformer:e}=this,{held:n,deforms:i,joint:r}=t.follows[t.onBoard?"board":"character"],o=e.tracer(t.mesh,t.point,r);Object.assign(t,{held:n,deforms:i,carrier:o,tracer:e.tracer(t.mesh,t.point)}),e.setBase(null,null),e.drive(this.rest),t.restMap=e.traceMap(o),t.restPoint=e.trace(o,t.restMap),t.restInverse=so(t.restMap),t.enlarged=t.members.some(a=>a.magnification!==1)}follow(t,e=!1,n=this.list){this.deformer.drive(t);for(let i of n)this.followOne(i,t,e||!i.deforms)}followOne(t,e,n){let{carrier:i,restInverse:r,restPoint:o}=t,[a,l]=this.without(t.held,e,()=>{let u=this.deformer.traceMap(i);return[u,this.deformer.trace(i,u)]}),c=r?un(r,a):io,h=n?oo(c,...o):l;t.tracks=t.members.map(u=>u.track.map(f=>Im(f,o,c,h)));let d=t.members.map((u,f)=>_n(u.values,t.tracks[f],this.rest[u.control]));if(t.origin=d[0],t.handle=n||t.enlarged?this.handleAt(t,e,d):this.deformer.trace(i),t.glyph){let u=n||!r?c:un(r,this.deformer.traceMap(i));t.outline=t.glyph.points.map(f=>Im(f,[0,0,0],u,t.handle))}}handleAt(t,e,n){let i=(r,o,a)=>fe(r,ge(_n(o.values,t.tracks[a],e[o.control]),n[a]));return t.members.reduce(i,n[0])}paths(t){let{deformer:e,rest:n}=this,i=e.trace(t.tracer);return t.members.map(({control:r,values:o,magnification:a})=>o.map(l=>{let c=e.withControl(r,n[r],l,()=>e.trace(t.tracer));return fe(i,ie(ge(c,i),a))}))}without(t,e,n){return t.reduce((r,o)=>e[o]===this.rest[o]?r:()=>this.deformer.withControl(o,e[o],this.rest[o],r),n)()}reanchor(t,e,n,i){Object.assign(t,{mesh:e,point:n,onBoard:!1,category:""}),t.tracer=this.deformer.tracer(e,n),this.deformer.setBase(null,null),this.deformer.drive(this.rest),t.position=this.deformer.trace(t.tracer);for(let a of t.members)a.magnification=1;let r=this.paths(t);t.members.forEach((a,l)=>a.magnification=Rw(r[l],i*this.width));let o=this.paths(t);t.members.forEach((a,l)=>a.track=o[l].map(c=>[...c])),this.prepare(t)}putBeside(t){Object.assign(t,{onBoard:!0,category:t.boardCategory}),this.prepare(t)}placement(t){let{mesh:e,point:n,onBoard:i,category:r,position:o}=t,a=t.members.map(({track:l,magnification:c})=>({track:l,magnification:c}));return{mesh:e,point:n,onBoard:i,category:r,position:o,members:a}}restore(t,{members:e,...n}){Object.assign(t,n),t.members.forEach((i,r)=>Object.assign(i,e[r])),this.prepare(t)}};function Cw(s){let t=s.layout.baseValues;return Float64Array.from(s.controls,(e,n)=>t[n]??e.default)}function Rw(s,t){let e=es(s);return e>0&&e<t?t/e:1}function Im(s,t,e,n){let[i,r,o]=ge(s,t);return[0,1,2].map(a=>n[a]+i*e[a]+r*e[4+a]+o*e[8+a])}var Vl=class{constructor(t){this.named=new Map(t.map(e=>[e.name,e])),this.holders=new Map;for(let e of t)for(let n of e.inner)re(this.holders,n,()=>[]).push(e.name);this.opened=new Set}coarseOf(t){return t.inner.length?[t]:(this.holders.get(t.name)??[]).map(e=>this.named.get(e))}shows(t){if(this.opened.has(t.name))return!1;let e=this.holders.get(t.name);return!e||e.some(n=>this.opened.has(n))}toggle(t,e){for(let n of t)for(let i of[n.name,n.mirror])this.named.get(i)?.inner.length&&this.opened[e?"add":"delete"](i)}};var Iw={arrangement:"face",handles:!0,labels:"hover",opacity:.9,fade:!0,occlusion:"ghost",follow:!0,heat:!0,symmetric:!1,rearrange:!1,autoKey:!1,draw:!1,onion:!1,trails:!1,shot:!1,interpolation:"linear",locality:.1,skinDrag:!0},Hl=class{section;within;constructor(t){this.character=t,this.controls=t.controls,this.deformer=new zl(t),this.elements=new Gl(t,this.deformer),this.levels=new Vl(this.elements.list),this.colours=t.layout.colours,this.options={...Iw},this.selection=new Set,this.hidden=new Set,this.hover=null,this.quiet=!1,this.listeners=new Map}on(t,e){re(this.listeners,t,()=>new Set).add(e)}fileNamed(t){return`${this.character.root.split("/").at(-1)||"character"}.${t}`}save(t,{text:e,unwritten:n=[]},i=r=>r){e&&Mn(this.fileNamed(t),e),this.emit("saved"),n.length&&i(`No animation drives ${n.join(", ")}`)}updating(t){for(let e of["options","layout"])this.on(e,()=>t.update());return t.update(),t}emit(t){this.listeners.get(t)?.forEach(e=>e())}select(t,e="replace"){e==="replace"&&this.selection.clear();for(let n of t)e==="toggle"&&this.selection.has(n.index)?this.selection.delete(n.index):this.selection.add(n.index);this.emit("selection")}get selectedElements(){return[...this.selection].map(t=>this.elements.list[t])}get chosenControls(){let t=this.selectedElements.flatMap(e=>e.members.map(n=>n.control));return t.length?t:[...this.controls.keys()]}setHover(t){this.hover!==t&&(this.hover=t,this.quiet=!1,this.emit("hover"))}hide(t){t.forEach(e=>this.hidden.add(e.index)),this.selection.clear(),this.emit("selection"),this.emit("options")}showAll(){this.hidden.clear(),this.emit("options")}show(t){this.section=this.character.layout.sections[t],this.within=new Set(this.section.elements),this.elements.width=this.section.handleWidth,this.selection.clear(),this.emit("section")}isShown(t){return this.within.has(t.name)&&!this.hidden.has(t.index)&&this.levels.shows(t)}openOrClose(t=this.selectedElements){let e=t.filter(i=>i.inner.length),n=t.flatMap(i=>i.inner.length?[]:this.levels.coarseOf(i));return!e.length&&!n.length?!1:(this.levels.toggle(e,!0),this.levels.toggle(e.length?[]:n,!1),this.select(this.elements.list.filter(i=>this.isShown(i)&&this.replaced(i,e,n))),this.emit("options"),!0)}reveal(t,e){let n=this.character.layout.sections.findIndex(({elements:i})=>i.includes(t.name));n>=0&&!this.within.has(t.name)&&this.show(n),this.levels.shows(t)||(this.levels.toggle(this.levels.coarseOf(t).slice(0,1),!t.inner.length),this.emit("options")),this.select([t],e)}replaced(t,e,n){return e.length?e.some(({inner:i})=>i.includes(t.name)):n.includes(t)}};var Pw=64,Wl=class{constructor(t,e,n){this.character=t,this.deformer=e,this.rest=n,this.known=new Map,this.peaks=new Map,this.sideways=new Map}peak(t){return re(this.peaks,t,()=>this.longest(t))}longest(t){let{drive:e,minimum:n,maximum:i}=this.character.controls[t];if(e.joints.length)return this.ofControl(t),this.peaks.get(t);let r=i-n,o=l=>{let c=e.values.slice(1).map((h,d)=>Math.abs((e.weights[d+1][l]-e.weights[d][l])/(h-e.values[d])));return r*Math.max(...c)},a=new Map(e.channels.map((l,c)=>[l,o(c)]));return Math.max(0,...this.character.meshes.flatMap(l=>l.shapes.filter(({channel:c})=>a.has(c)).map(c=>a.get(c.channel)*Nw(c)*Dw(l.maps))))}sidewaysOf(t,e){return re(this.sideways,t,()=>{let{minimum:n,maximum:i}=this.character.controls[t],[r,...o]=this.pointsAt(t,[this.rest[t],n,i]);return Math.max(...o.map(a=>Lw(r,a,e)))})}isWide(t){if(!this.character.controls[t].drive.joints.length)return!1;let e=this.ofControl(t);return e.filter(n=>n>Pw).length>.5*e.length}ofControl(t){return re(this.known,t,()=>this.measure(t))}ofControls(t){let e=t.map(n=>this.ofControl(n));return e.length===1?e[0]:e[0].map((n,i)=>e.reduce((r,o)=>Math.max(r,o[i]),n))}measure(t){let e=this.character.controls[t],n=[...new Set([e.minimum,e.maximum])].filter(l=>l!==this.rest[t]),[i,...r]=this.pointsAt(t,[this.rest[t],...n]),o=new Float32Array(i.length/3);for(let l of r)for(let c=0,h=0;c<o.length;c++,h+=3)o[c]=Math.max(o[c],Math.hypot(l[h]-i[h],l[h+1]-i[h+1],l[h+2]-i[h+2]));let a=o.reduce((l,c)=>Math.max(l,c),0);return e.drive.joints.length&&this.peaks.set(t,a),Uint8Array.from(o,l=>a>0?Math.round(255*l/a):0)}pointsAt(t,e){let{deformer:n}=this,i=Float64Array.from(this.rest);return e.map(r=>(i[t]=r,n.posedAside(i)))}rank(t,e){let{deformer:n}=this;n.drive(t);let i=this.character.controls.map((o,a)=>{let l=[o.minimum,o.maximum,this.rest[a]],[c,h,d]=l.map(f=>n.withControl(a,t[a],f,e)),u=Math.max(...[[c,d],[h,d],[c,h]].map(([f,p])=>Math.hypot(...ge(f,p))));return{control:a,distance:u}}),r=i.reduce((o,{distance:a})=>Math.max(o,a),0);return i.filter(({distance:o})=>o>.001*r).sort((o,a)=>a.distance-o.distance||o.control-a.control).map(o=>({...o,share:o.distance/r}))}};function Lw(s,t,e){let n=0,i=0;for(let r=0;r<s.length;r+=3){let o=[t[r]-s[r],t[r+1]-s[r+1],t[r+2]-s[r+2]];n+=vt(o,e),i+=Math.hypot(...o)}return i>0?Math.abs(n)/i:0}function Nw(s){return s.largest??=s.weights.reduce((t,e,n)=>{let i=3*n*s.points.length,r=0;for(let o=i;o<i+3*s.points.length;o+=3)r=Math.max(r,Math.hypot(s.offsets[o],s.offsets[o+1],s.offsets[o+2]));return Math.max(t,r*s.step/Math.abs(e))},0),s.largest}var Dw=s=>Math.cbrt(Math.abs(ao(s)));var Ow=new Set(["global","composite"]),Xl=class extends Hl{constructor(t){super(t),this.rest=this.elements.rest,this.values=Float64Array.from(this.rest),this.influence=new Wl(t,this.deformer,this.rest),this.opposites=Fw(this.elements.list,this.controls.length),this.twins=Uw(this.elements.list,this.opposites),this.locks=new Set,this.pins=[],this.affected=new Map,this.dragging=null}reshape(){this.deformer.pose(this.values),this.elements.follow(this.values,!this.options.follow),this.emit("pose")}set(t){for(let[e,n]of t){this.setOne(e,n);let i=this.twins[e];this.options.symmetric&&i>=0&&this.setOne(i,this.mirrored(e,i))}this.reshape()}setOne(t,e){let{minimum:n,maximum:i}=this.controls[t];!this.locks.has(t)&&Number.isFinite(e)&&(this.values[t]=Vt(e,n,i))}mirrored(t,e,n=this.values){let i=n[t]-this.rest[t],r=(a,l)=>Math.abs(this.controls[a][l]-this.rest[a])||1,o=i<0?"minimum":"maximum";return this.rest[e]+i*r(e,o)/r(t,o)}setOption(t,e){this.options[t]=e,t==="follow"&&this.reshape(),this.emit("options")}flipOption(t){this.setOption(t,!this.options[t])}toggleLock(t){this.locks.delete(t)||this.locks.add(t),this.emit("options")}worded(t,e=this.values[t]){let{minimum:n,maximum:i}=this.controls[t];return Du(e,i-n)}meshOf(t){let e=this.character.meshes,n=e.findIndex(i=>t<i.start+i.count);return[n,t-e[n].start]}tracer(t){return this.deformer.tracer(...this.meshOf(t))}place({corners:t,shares:e}){return{corners:t,shares:e,tracers:t.map(n=>this.tracer(n))}}traced(t){return t.tracers.reduce((e,n,i)=>fe(e,ie(this.deformer.trace(n),t.shares[i])),[0,0,0])}shown(t){let{points:e}=this.deformer;return t.corners.reduce((n,i,r)=>fe(n,ie(e.subarray(3*i,3*i+3),t.shares[r])),[0,0,0])}addPin(t){let e=this.place(t);this.pins.push({...e,at:this.shown(e)}),this.emit("options")}removePin(t){this.pins=this.pins.filter(e=>e!==t),this.emit("options")}groups(t){return this.besideFreeEnds(this.unlocked(t))}besideFreeEnds(t){let e=new Set(t.flat()),n=r=>!e.has(r)&&this.values[r]!==this.controls[r].default,i=t.filter(r=>!r.some(o=>this.opposites[o].some(n)));return i.length<t.length?this.besideFreeEnds(i):i}unlocked(t){let e=[];for(let n=0;n<this.controls.length;n++){let i=this.options.symmetric?this.twins[n]:-1;if(i>=0&&i<n)continue;let r=i>n?[n,i]:[n];r.some(o=>this.locks.has(o))||this.options.symmetric&&i<0&&this.crosses(n)||(t||!this.isWide(n))&&e.push(r)}return e}isWide(t){return Ow.has(this.elements.byControl.get(t)?.category)||this.influence.isWide(t)}crosses(t){return this.influence.sidewaysOf(t,this.character.layout.planeNormal)>.5}};function Fw(s,t){let e=Array.from({length:t},()=>[]);for(let{members:n,axes:i}of s)for(let[r,o]of i.filter(a=>a.length===2).map(a=>a.map(l=>n[l].control)))e[r].includes(o)||[e[r],e[o]].forEach((a,l)=>a.push([o,r][l]));return e}function Uw(s,t){let e=new Int32Array(t.length).fill(-1),n=new Map(s.map(i=>[i.name,i]));for(let i of s){let r=n.get(i.mirror);!r||r===i||r.members.length!==i.members.length||i.members.forEach(({control:o},a)=>{let l=r.members[a].control;!i.reversed?.includes(a)&&!t[o].includes(l)&&(e[o]=l)})}return e}var ql=class extends Xl{constructor(t){super(t),this.animation=new Fl(t,this.rest),this.history=new us,this.frame=this.animation.first,this.neutral=!0,this.keys=new Map,this.constants=new Map,this.shelf=[],this.notes=[],this.arrived=this.notes,this.received=[],this.sent=this.notes,this.note=null,this.sound=null,this.given=Float64Array.from(this.rest),this.moved=new Map,this.present=null,this.looks=!1,this.show(0),this.reshape()}leave(){this.compare(!1),this.listeners.clear(),Object.assign(this,{hover:null,dragging:null,affected:new Map})}edit(t,e,n=null){let i=this.beginEdit();e(),this.endEdit(t,i,n)}beginEdit(){let t=this.looks?this.present:null;return t&&Object.assign(this,{present:null,looks:!1}),this.compare(!1),this.emit("editing"),t??Float64Array.from(this.values)}endEdit(t,e,n=null){let i=[...e.keys()].filter(o=>this.values[o]!==e[o]);if(!i.length)return;let r={...this.snapshot(),values:e};this.options.autoKey&&this.setKeys(i),this.step(t,r,n),this.emit("edited")}zero(t=this.controls.keys()){this.settleAt("Zero",[...t],e=>this.controls[e].default)}reset(t=this.controls.keys()){this.settleAt("Reset",[...t],e=>this.rest[e])}settleAt(t,e,n){let i={...this.snapshot(),values:this.beginEdit()};e.length===this.controls.length&&(this.neutral=!0,this.showBase()),this.set(e.map(o=>[o,n(o)]));let r=this.values.some((o,a)=>o!==i.values[a]);!r&&this.neutral===i.neutral||(this.options.autoKey&&r&&this.setKeys(e.filter(o=>!this.locks.has(o))),this.step(t,i),this.emit("edited"))}undo(){return this.history.undo()}redo(){return this.history.redo()}snapshot(){this.looks||this.compare(!1);let{frame:t,neutral:e,keys:n,constants:i,shelf:r,notes:o,sound:a,span:l}=this;return{frame:t,neutral:e,keys:n,constants:i,shelf:r,notes:o,sound:a,span:l,values:Float64Array.from(this.own),given:this.given}}restore({values:t,...e}){this.emit("editing"),Object.assign(this,e,{present:null,looks:!1}),this.values.set(t),this.showBase(),this.reshape(),this.emit("time")}clear(){let t=Float64Array.from(this.rest);this.restore({...this.snapshot(),neutral:!0,keys:new Map,constants:new Map,values:t,given:t})}step(t,e,n=null){let i=this.snapshot();this.history.push(t,()=>this.restore(e),()=>this.restore(i),n,[e,i]),this.emit("changed"),this.emit("time")}changed(){let{own:t,given:e}=this;return[...t.keys()].filter(n=>t[n]!==e[n])}unkeyed(){return this.changed().filter(t=>this.animation.isAnimated(t,this.keys))}go(t,e=!1){this.compare(!1);let n=this.unkeyed(),i=n.length?this.snapshot():null;return this.constants=this.allConstants(),Object.assign(this,{frame:t,neutral:e}),this.given=e?Float64Array.from(this.rest):this.animation.at(t,this).values,this.values.set(this.given),this.showBase(),this.reshape(),i?this.step(`Leave frame ${i.frame} with changes`,i):this.emit("time"),n}allConstants({keys:t,constants:e,values:n,given:i}={...this,values:this.own}){let r=([o,a])=>a!==i[o]&&!this.animation.isAnimated(o,t);return new Map([...e,...[...n.entries()].filter(r)])}key(t){this.record(`Key frame ${this.frame}`,()=>this.setKeys(t))}setKeys(t){let e=n=>this.keys.has(n)?void 0:this.options.interpolation;this.takeKeys(ts(this.keys,t.map(n=>[n,[this.frame,this.values[n],e(n)]])),this.constants)}unkey(t){let e=Br(this.keys,t.map(i=>[i,this.frame])),n=t.filter(i=>e.get(i)?.length!==this.keys.get(i)?.length);return n.length?(this.record(`Delete keys at frame ${this.frame}`,()=>{n.forEach(i=>this.values[i]=this.given[i]),this.takeKeys(e,this.constants)}),!0):!1}rekey(t,e){this.record(t,()=>this.takeKeys(e,this.constants))}put(t,e,n=null){this.record(t,()=>Object.assign(this,e),n)}record(t,e,n=null){let i=this.snapshot();e(),this.step(t,i,n)}get range(){let[t,e]=this.animation.range(this.keys),{start:n,seconds:i}=this.sound??{start:t,seconds:0};return[Math.min(t,n),Math.max(e,Math.ceil(n+i*this.animation.rate))]}get span(){return this.animation.span}set span(t){this.animation.span=t}respan(t,e){return!this.animation.isFree||!(Number.isInteger(t)&&Number.isInteger(e)&&t<e)?!1:(this.put("Set the frames",{span:[t,e]}),!0)}copy(){return this.copied=new Map(this.chosenControls.map(t=>[t,this.values[t]])),this.copied}paste(){this.copied&&this.asWritten("Paste the pose",this.copied)}flip(){this.asWritten("Flip the pose",Sm({...this.sides,crosses:t=>this.crosses(t)}))}mirror(t){this.asWritten(`Mirror the ${t}`,Am(t,this.sides))}tween(t){let e=wm(this.keys,this.chosenControls,this.frame,t);return e.length&&this.edit("Tween",()=>this.set(e),"tween"),e.length>0}get sides(){let t=Float64Array.from(this.values),{controls:e,rest:n,twins:i,opposites:r}=this;return{values:t,controls:e,rest:n,twins:i,opposites:r,sideOf:l=>this.elements.byControl.get(l)?.side,mirrored:(l,c)=>this.mirrored(l,c,t)}}asWritten(t,e){let{symmetric:n}=this.options;this.options.symmetric=!1,this.edit(t,()=>this.set(e)),this.options.symmetric=n}load(t,e,n){let i=[...e.values()].map(([[r]])=>r);this.record(t,()=>{i.length&&(this.frame=Math.min(...i)),this.given=Float64Array.from(this.values),this.takeKeys(e,n)})}takeKeys(t,e){this.compare(!1);let n=this.changed().map(i=>[i,this.values[i]]);Object.assign(this,{keys:t,constants:e,neutral:!1}),this.given=this.animation.at(this.frame,this).values,this.values.set(this.given);for(let[i,r]of n)this.values[i]=r;this.showBase(),this.reshape()}rebase(t){this.compare(!1);for(let i of this.history.states)Object.assign(i,this.rebased(i,t));let{values:e,...n}=this.rebased(this.snapshot(),t);Object.assign(this,n),this.values.set(e),this.reshape(),this.emit("time")}rebased(t,e){let n={keys:t.keys,constants:this.allConstants(t),span:t.span},i=e(n),[r,o]=[n,i].map(d=>this.animation.at(t.frame,d).values),a=d=>t.values[d]!==t.given[d]&&this.animation.isAnimated(d,t.keys),l=d=>r[d]!==o[d],c=t.given.map((d,u)=>l(u)?o[u]:d),h=t.values.map((d,u)=>l(u)&&!a(u)?o[u]:d);return{...t,...i,given:c,values:h}}compare(t){if(t===!!this.present)return;t&&this.emit("editing");let e=t?this.given:this.present;this.present=t?Float64Array.from(this.values):null,this.looks=!1,this.values.set(e),this.reshape()}get own(){return this.present??this.values}adopt(){this.edit("Take the pose of a note",()=>{})}look(t){this.compare(!1),!t.every((e,n)=>e===this.values[n])&&(this.present=Float64Array.from(this.values),this.looks=!0,this.values.set(t),this.reshape())}relayout(){this.showBase(),this.reshape(),this.emit("layout"),this.emit("changed")}atFrame(t,e){let{values:n,weights:i,locals:r}=this.animation.at(t,{keys:this.keys,constants:this.allConstants()});this.deformer.setBase(i,r);let o=e(n);return this.showBase(),this.deformer.drive(this.values),o}showBase(){let{weights:t,locals:e}=this.neutral?{weights:null,locals:null}:this.animation.clipAt(this.frame);this.deformer.setBase(t,e)}};var zr={mouse:8,touch:22},gu=60,Hs=14,kw="http://www.w3.org/2000/svg",Yl=class{constructor(t){this.sheet=t,this.size=[0,0],this.node=Xn("svg",{class:"curves",role:"img","aria-label":"Curves"}),this.node.addEventListener("pointerdown",e=>this.press(e)),new ResizeObserver(()=>this.sheet.shows==="curves"&&!this.sheet.node.hidden&&this.draw()).observe(this.node)}get session(){return this.sheet.session}get controls(){let t=[...this.sheet.keys.keys()],e=new Set(this.session.selection.size?this.session.chosenControls:[]),n=t.filter(i=>e.has(i));return n.length?n:t}draw(){let{clientWidth:t,clientHeight:e}=this.node;!this.sheet.scale||!t||(this.size=[t,e],this.node.replaceChildren(...[0,.5,1].flatMap(n=>this.level(n)),...xu(this.sheet.scale,t/gu).flatMap(n=>[Xn("line",{class:"curve-grid",x1:this.x(n),x2:this.x(n),y1:0,y2:e}),$l(n,{class:"curve-number",x:this.x(n)+3,y:e-2})]),...this.tangents.flatMap(({from:n,at:i})=>[Xn("polyline",{class:"curve-tangent",points:`${n} ${i}`}),Xn("circle",{class:"curve-tangent",cx:i[0],cy:i[1],r:3.5})]),...this.controls.flatMap(n=>this.curve(n)),Xn("line",{class:"curve-now",y1:0,y2:e}),...this.band()),this.moveNow())}moveNow(){let t=this.node.querySelector(".curve-now"),e=this.size?this.x(this.session.frame):0;t&&Zn(t,{x1:e,x2:e})}level(t){let e=this.controls.map(r=>this.session.controls[r]),n=({minimum:r,maximum:o})=>Number((r+t*(o-r)).toPrecision(3)),i=e.length>1?`${100*t} %`:e.map(n).join();return[Xn("line",{class:"curve-grid",x1:0,x2:this.size[0],y1:this.y(t),y2:this.y(t)}),$l(i,{class:"curve-number",x:2,y:this.y(t)-2})]}curve(t){let{session:e,sheet:n}=this,i=n.keys.get(t),r=e.colours[e.elements.byControl.get(t)?.side??"none"],{label:o}=e.controls[t],[[a],[l]]=[i[0],i.at(-1)],h=Se([...i.map(([f])=>f),...$r(i),...Pm(a,l)]).map(f=>this.place(t,f,du(i,f,null)).join()),d=this.place(t,l,i.at(-1)[1]),u=d[0]>this.size[0]-120;return[Xn("polyline",{class:"curve",points:h.join(" "),stroke:r}),...i.map(([f,p])=>this.keyMark(t,f,p,r,o)),$l(o,{class:"curve-name",x:d[0]+(u?-8:8),y:Math.max(12,d[1]-6),"text-anchor":u?"end":"start"})]}keyMark(t,e,n,i,r){let[o,a]=this.place(t,e,n),l=this.sheet.isPicked(t,e),c=Xn("circle",{class:l?"curve-key on":"curve-key",cx:o,cy:a,r:4.5,fill:l?"#fff":i});return c.append($l(`${r}, frame ${e}: ${n.toFixed(3)}`,{},"title")),c}x(t){let[e,n]=this.sheet.scale;return Hs+(t-e)/(n-e)*(this.size[0]-2*Hs)}y(t){return this.size[1]-Hs-t*(this.size[1]-2*Hs)}get framesPerPixel(){return(this.sheet.scale[1]-this.sheet.scale[0])/(this.size[0]-2*Hs)}valuePerPixel(t){let{minimum:e,maximum:n}=this.session.controls[t];return(n-e)/(this.size[1]-2*Hs)}place(t,e,n){let{minimum:i,maximum:r}=this.session.controls[t];return[this.x(e),this.y((n-i)/(r-i))]}get shown(){return this.controls.flatMap(t=>this.sheet.keys.get(t).map(([e,n])=>({key:[t,e],at:this.place(t,e,n)})))}nearest(t,e){let n=({at:i})=>Math.hypot(i[0]-t[0],i[1]-t[1]);return[...this.shown,...this.tangents].filter(i=>n(i)<=e).sort((i,r)=>n(i)-n(r))[0]}get tangents(){return this.controls.flatMap(t=>this.sheet.keys.get(t).flatMap(([e,n],i,r)=>[i-1,i].filter(a=>this.sheet.isPicked(t,e)&&r[a+1]&&en(r[a]??[])==="smooth").map(a=>{let l=(a<i?-1:1)*(r[a+1][0]-r[a][0])/3,c=this.place(t,e+l,n+l*ic(r,i));return{control:t,key:r[i],reach:l,from:this.place(t,e,n),at:c}})))}press(t){if(t.button||!this.size)return;let e=this.node.getBoundingClientRect(),n=[t.clientX-e.left,t.clientY-e.top],i=this.nearest(n,t.pointerType==="touch"?zr.touch:zr.mouse);i?.from?this.bending(t,i):i?this.moving(t,i.key):this.ranging(t,e,n),this.sheet.node.focus({preventScroll:!0}),t.preventDefault()}moving(t,e){let{sheet:n}=this;n.pick([e],t.shiftKey),n.draw(),n.dragging(t,i=>{let[r,o]=[i.clientX-t.clientX,i.clientY-t.clientY],a=i.shiftKey&&Math.abs(o)>Math.abs(r),l=a?0:Math.round(r*this.framesPerPixel),c=i.shiftKey&&!a?0:-o,h=Ul(l,e[1],i.altKey?n.span:null);return l||c?([d,u],f)=>[h(d),u+c*this.valuePerPixel(f)]:null})}bending(t,{control:e,key:n,from:i,at:r}){let{sheet:o,session:a}=this,[l,c]=n,{minimum:h,maximum:d}=a.controls[e],u=this.tangents.filter(m=>m.key===n).map(m=>m.reach),f=(m,g)=>(Vt(c+m*g,h,d)-c)/g,p=Math.sign(r[0]-i[0]),{keys:x}=a;o.follow(t,m=>{let[g,M]=[p*(r[0]-i[0]+m.clientX-t.clientX),i[1]-r[1]+t.clientY-m.clientY],A=p*M*this.valuePerPixel(e)/(Math.max(1,g)*this.framesPerPixel);x=ts(a.keys,[[e,[l,c,en(n),Pn(u.reduce(f,A))]]]),o.preview={keys:x,picked:o.picked},o.draw()},()=>x===a.keys||a.rekey("Bend a curve",x))}ranging(t,e,n){let{sheet:i}=this;i.selecting(t,r=>{let o=[r.clientX-e.left,r.clientY-e.top],[a,l]=[Math.min,Math.max].map(c=>[0,1].map(h=>c(n[h],o[h])));return i.range={controls:[],frames:[],corners:[a,l]},this.shown.filter(({at:c})=>c.every((h,d)=>h>=a[d]&&h<=l[d])).map(({key:c})=>c)})}band(){let[t,e]=this.sheet.range?.corners??[];return t?[Xn("rect",{class:"curve-band",x:t[0],y:t[1],width:e[0]-t[0],height:e[1]-t[1]})]:[]}};function xu([s,t],e){let n=Math.max(1,(t-s)/Math.max(1,e)),i=10**Math.floor(Math.log10(n)),r=i*([1,2,5].find(o=>o*i>=n)??10);return[...Pm(s/r,t/r)].map(o=>o*r)}function*Pm(s,t){for(let e=Math.ceil(s);e<=t;e++)yield e}function Xn(s,t){let e=document.createElementNS(kw,s);return Zn(e,t),e}function $l(s,t,e="text"){let n=Xn(e,t);return n.textContent=s,n}var Bw={linear:"dope-key",smooth:"dope-key round",stepped:"dope-key square"},Kl=class{constructor(t,e,n){this.session=t,this.say=e,this.sound=n,this.picked=new Set,this.preview=null,this.copied=null,this.rows=[],this.range=null,this.shows="rows",this.body=O("div",{class:"dope-rows",onpointerdown:i=>this.press(i)}),this.curves=new Yl(this),this.node=O("section",{class:"dope",hidden:!0,tabIndex:0,"aria-label":"Keys",onkeydown:i=>this.key(i)},this.makeHead(),this.body,this.curves.node),t.on("time",()=>this.update()),t.on("selection",()=>this.update()),t.on("options",()=>this.head.update())}toggle(t=this.node.hidden){this.node.hidden=!t,this.update()}get pickedKeys(){return[...this.picked].map(t=>t.split(" ").map(Number))}get keys(){return this.preview?.keys??this.session.keys}isPicked(t,e){return(this.preview??this).picked.has(`${t} ${e}`)}get span(){let t=this.pickedKeys.map(([,i])=>i),[e,n]=[Math.min(...t),Math.max(...t)];return e<n?[e,n]:null}makeHead(){let t=fi("Keys as",[["rows","Rows","All keys in rows"],["curves","Curves","The curves of the selected controls, or of all that have keys"]],()=>this.shows,r=>{this.shows=r,this.update()}),e=fi("How keys go to the next",Xr.map(r=>[r,is(r),`${is(r)}: the picked keys, or all, and the first key of a control from now on`]),()=>this.way,r=>this.go(r)),n=O("output",{class:"hint"}),i=r=>r.detail&&this.node.focus({preventScroll:!0});return this.head=O("div",{class:"dope-head",onclick:i},t,e,yt("Copy","Copy the picked keys (Ctrl+C)",()=>this.copy()),yt("Paste","Paste the copied keys from this frame on (Ctrl+V)",()=>this.paste()),yt("Reverse","Turn the picked keys round in time",()=>this.reverse()),yt("Delete","Delete the picked keys (Delete)",()=>this.remove()),n),this.head.update=()=>{t.update(),e.update(),n.textContent=this.counted()},this.head.update(),this.head}get way(){let t=new Set(this.pickedKeys.map(([e,n])=>en(this.session.keys.get(e).find(([i])=>i===n))));return t.size?t.size>1?null:[...t][0]:this.session.options.interpolation}counted(){if(!this.picked.size)return"Drag a key to move it (Alt scales those picked), an empty place to pick a range";let t=this.span?`frames ${this.span.join(" to ")}`:`frame ${this.pickedKeys[0][1]}`;return`${ce(this.picked.size,"key")} picked, ${t}`}update(){if(this.node.hidden)return;let{session:t}=this;if(this.shown===t.keys&&this.heard===t.sound&&!this.preview&&!this.range&&this.moveNow())return;this.shown=t.keys,this.heard=t.sound,this.scale=t.range;let e=this.picked;this.picked=new Set(this.everyKey.map(n=>n.join(" ")).filter(n=>e.has(n))),this.draw()}get asked(){return[...this.picked,this.shows,...this.session.selection].join()}moveNow(){if(this.look!==this.asked)return!1;for(let t of this.body.querySelectorAll(".dope-now"))t.style.left=this.along(this.session.frame);return this.curves.moveNow(),!0}draw(){let{session:t}=this;if(t.emit("picked"),this.look=this.asked,this.body.hidden=this.shows!=="rows",this.curves.node.style.display=this.shows==="curves"?"":"none",this.head.update(),this.shows==="curves")return this.curves.draw();let e=[...this.keys];this.rows=[{name:"All",controls:e.map(([i])=>i)},...e.map(([i])=>({name:t.controls[i].label,controls:[i]}))];let n=Me("No keys yet: K keys what is selected or changed, Auto-key every drag.");return this.body.replaceChildren(this.ruler(),...this.waveRow(),...e.length?this.rows.map(i=>this.row(i)):[n])}ruler(){let e=xu(this.scale,this.body.clientWidth/gu).map(n=>O("i",{style:{left:this.along(n)}},String(n)));return O("div",{class:"dope-row","aria-hidden":"true"},O("span"),O("div",{class:"dope-ruler"},...e))}waveRow(){if(!this.sound.isReady)return[];let t=O("div",{class:"dope-wave"},this.sound.wave(this.scale[0],this.scale[1],36));return[O("div",{class:"dope-row heard"},O("span",{},this.sound.name),t)]}row({name:t,controls:e}){let n=new Map;for(let o of e)for(let a of this.keys.get(o))re(n,a[0],()=>[]).push([o,a]);let i=[...n].map(([o,a])=>this.mark(t,o,a)),r=O("i",{class:"dope-now",style:{left:this.along(this.session.frame)}});return O("div",{class:"dope-row"},O("span",{title:t},t),O("div",{class:"dope-line"},...this.band(e),...i,r))}band(t){let{range:e}=this;if(!e||!t.some(r=>e.controls.includes(r)))return[];let[n,i]=e.frames.map(r=>this.along(r));return[O("i",{class:"dope-band",style:{left:n,width:`calc(${i} - ${n})`}})]}along(t){return ns(t,this.scale)}mark(t,e,n){let i=n.every(([a])=>this.isPicked(a,e)),r=en(n[0][1]),o=`${t}, frame ${e}${r==="linear"?"":`, ${r}`}`;return O("button",{type:"button",class:Bw[r],tabIndex:-1,style:{left:this.along(e)},title:o,"aria-label":o,"aria-pressed":String(i)})}at({clientX:t,clientY:e}){let i=[...this.body.querySelectorAll(".dope-line")].map(h=>h.getBoundingClientRect()),r=i.findIndex(({bottom:h})=>e<=h),o=r<0?i.length-1:r,[a,l]=this.scale,c=(l-a)/i[o].width;return{row:o,frame:a+(t-i[o].left)*c,perPixel:c}}press(t){if(t.button||!this.session.keys.size)return;let e=this.at(t),{controls:n}=this.rows[e.row],i=e.perPixel*(t.pointerType==="touch"?zr.touch:zr.mouse),r=kl(this.session.keys,n,[e.frame-i,e.frame+i]),o=r.reduce((l,[,c])=>Math.abs(c-e.frame)<Math.abs(l-e.frame)?c:l,1/0),a=r.filter(([,l])=>l===o);a.length?this.moving(t,e,a):this.ranging(t,e),this.node.focus({preventScroll:!0}),t.preventDefault()}pick(t,e){let n=t.map(i=>i.join(" "));!e&&!n.every(i=>this.picked.has(i))&&this.picked.clear(),n.forEach(i=>this.picked.add(i))}moving(t,e,n){this.pick(n,t.shiftKey),this.draw(),this.dragging(t,i=>{let r=Math.round((i.clientX-t.clientX)*e.perPixel),o=Ul(r,n[0][1],i.altKey?this.span:null);return r?([a,l])=>[o(a),l]:null})}dragging(t,e){let n=i=>i.ctrlKey||i.metaKey;this.follow(t,i=>{let r=e(i);this.preview=r&&this.changed(r,n(i)),this.draw()},i=>{let r=e(i);r&&this.change(n(i)?"Copy":i.altKey?"Scale":"Move",r,n(i))})}ranging(t,e){this.selecting(t,n=>{let i=this.at(n),r=this.rows.slice(Math.min(e.row,i.row),Math.max(e.row,i.row)+1).flatMap(a=>a.controls),o=[Math.min(e.frame,i.frame),Math.max(e.frame,i.frame)];return this.range={controls:r,frames:o},kl(this.session.keys,r,o)})}selecting(t,e){let n=t.shiftKey?[...this.picked]:[],i=r=>{this.picked=new Set([...n,...r.map(o=>o.join(" "))]),this.draw()};this.follow(t,r=>i(e(r)),()=>{}),i([])}follow(t,e,n){let i=new AbortController,r=l=>c=>c.pointerId===t.pointerId&&l(c),o=l=>r(c=>{i.abort(),Object.assign(this,{preview:null,range:null}),l(c),this.draw()}),{signal:a}=i;window.addEventListener("pointermove",r(e),{signal:a}),window.addEventListener("pointerup",o(n),{signal:a}),window.addEventListener("pointercancel",o(()=>{}),{signal:a})}key(t){let e={ArrowLeft:-1,ArrowRight:1},n=t.ctrlKey||t.metaKey;if(t.key==="Delete"||t.key==="Backspace")this.remove();else if(e[t.key]&&this.picked.size)this.change(n?"Copy":"Move",([i,r])=>[i+e[t.key]*(t.shiftKey?10:1),r],n);else if(n&&t.key==="a")this.pick(this.everyKey,!0);else if(n&&t.key==="c"&&this.picked.size)this.copy();else if(n&&t.key==="v"&&this.copied)this.paste();else if(t.key==="Escape"&&this.picked.size)this.picked.clear();else return;this.draw(),t.preventDefault(),t.stopPropagation()}get everyKey(){return kl(this.session.keys,[...this.session.keys.keys()])}changed(t,e){let{keys:n,controls:i}=this.session;return vm(n,this.pickedKeys,(r,o)=>{let[a,l]=t(r,o);return[a,Vt(l,i[o].minimum,i[o].maximum)]},e)}change(t,e,n=!1){let i=`${t} ${ce(this.picked.size,"key")}`,{keys:r,picked:o}=this.changed(e,n);this.picked=o,this.session.rekey(i,r)}reverse(){let{span:t}=this;t?this.change("Reverse",([e,n])=>[t[0]+t[1]-e,n]):this.say("No range of keys is picked")}remove(){let t=this.pickedKeys;t.length?this.session.rekey(`Delete ${ce(t.length,"key")}`,Br(this.session.keys,t)):this.say("No key is picked")}copy(){this.picked.size&&(this.copied=Mm(this.session.keys,this.pickedKeys)),this.say(this.picked.size?`${ce(this.copied.length,"key")} copied`:"No key is picked")}paste(){let{session:t,copied:e}=this;return e?(this.picked=new Set(e.map(([n,[i]])=>`${n} ${t.frame+i}`)),t.rekey(`Paste ${ce(e.length,"key")}`,bm(t.keys,e,t.frame))):this.say("No key is copied")}go(t){let{session:e}=this,n=this.pickedKeys.length?this.pickedKeys:this.everyKey;this.picked.size||e.setOption("interpolation",t),n.length&&e.rekey(`${is(t)}: ${ce(n.length,"key")}`,_m(t,e.keys,n)),this.draw()}};var zw=.08,Gw=300,yu=1200,Zl=class{constructor(t){this.session=t,this.context=null,this.buffer=null,this.source=null,this.waves=new Map}get rate(){return this.session.animation.rate}get start(){return this.session.sound.start}get isReady(){return!!this.buffer&&this.session.sound?.name===this.name}async read(t){this.context??=new AudioContext;try{this.buffer=await this.context.decodeAudioData(await t.arrayBuffer())}catch{throw new Error(`This browser cannot read ${t.name} as sound.`)}this.name=t.name,this.waves.clear();let{session:e}=this,n=e.sound?.name===t.name?e.sound.start:e.animation.first;e.put(`Open ${t.name}`,{sound:{name:t.name,start:n,seconds:this.buffer.duration}},"sound")}async play(t){let e=this.isReady&&await this.opened();return e?(this.from(t),()=>e.currentTime-(e.outputLatency||0)):()=>performance.now()/1e3}async opened(){let{context:t}=this;return t.state!=="running"&&await Promise.race([t.resume(),new Promise(e=>setTimeout(e,Gw))]),t.state==="running"?t:null}from(t,e=1/0){if(this.stop(),!this.isReady)return;let{context:n,buffer:i}=this,{delay:r,offset:o}=Vw(t,this.start,this.rate);o>=i.duration||(this.source=new AudioBufferSourceNode(n,{buffer:i}),this.source.connect(n.destination),this.source.start(n.currentTime+r,o,Math.min(e,i.duration-o)))}blip(t){this.isReady&&this.context.state==="running"&&t>=this.start&&this.from(t,zw)}stop(){this.source?.stop(),this.source=null}wave(t,e,n=30){let i=[t,e,n,this.start].join();return re(this.waves,i,()=>this.drawn(t,e,n))}drawn(t,e,n){let i=O("canvas",{class:"wave",width:yu,height:n,"aria-hidden":"true"}),r=i.getContext("2d"),{buffer:o,rate:a}=this,l=d=>(t+d/yu*(e-t)-this.start)/a,c=Hw(o.getChannelData(0),o.sampleRate,Array.from({length:yu+1},(d,u)=>l(u))),h=Math.max(...c,1e-6);return r.fillStyle="#6f8fb3",c.forEach((d,u)=>r.fillRect(u,n/2*(1-d/h),1,n*d/h)),i}};function Vw(s,t,e){let n=(s-t)/e;return{delay:Math.max(0,-n),offset:Math.max(0,n)}}function Hw(s,t,e){return e.slice(1).map((n,i)=>{let r=0,[o,a]=[Math.max(0,Math.floor(e[i]*t)),Math.min(s.length,Math.ceil(n*t))];for(let l=o;l<a;l++)r=Math.max(r,Math.abs(s[l]));return r})}var Jl=class{ends;constructor(t,e){this.session=t,this.say=e,this.rate=t.animation.rate,this.playing=!1,this.sound=new Zl(t),this.sheet=new Kl(t,e,this.sound),this.node=this.build(),t.on("editing",()=>this.stop()),t.on("time",()=>this.update()),t.on("options",()=>this.update()),this.update()}get frame(){return this.session.frame}build(){this.playButton=yt("▶","Play or stop (Space); picked keys: between the first and the last of them",()=>this.toggle(),{class:"play"}),this.autoButton=Nn("Auto-key","Every drag sets keys at this frame",()=>this.session.options.autoKey,()=>this.session.flipOption("autoKey")),this.sheetButton=Nn("Keys","All keys in rows: drag moves them, Ctrl-drag copies, Delete takes them away (D)",()=>!this.sheet.node.hidden,()=>this.openSheet()),this.slider=O("input",{type:"range",step:1,"aria-label":"Frame",oninput:()=>{this.go(Number(this.slider.value)),this.sound.blip(this.frame)}}),this.ticks=O("div",{class:"ticks","aria-hidden":"true"}),this.waves=O("div",{class:"waves","aria-hidden":"true"}),this.soundButton=yt("Sound…","",()=>this.openSound()),this.soundStart=O("input",{type:"number",class:"sound-start",title:"The frame at which the sound begins","aria-label":"The frame at which the sound begins",onchange:()=>this.session.put("Move the sound",{sound:{...this.session.sound,start:Math.round(Number(this.soundStart.value))}},"sound")});let t=(e,n)=>O("input",{type:"number",class:"span-end",title:e,"aria-label":e,onchange:()=>this.setSpan(n)});return this.ends=["First frame","Last frame"].map(t),this.number=O("output",{class:"frame"}),this.unkeyed=O("output",{class:"unkeyed",title:"Changed here and not keyed: they end with this frame. K keys them."}),O("footer",{class:"timeline","aria-label":"Time"},this.playButton,yt("‹","Previous key, or the frame before where there is none",()=>this.step(-1)),yt("›","Next key, or the frame after where there is none",()=>this.step(1)),this.number,this.unkeyed,this.ends[0],O("div",{class:"scrub"},this.waves,this.ticks,this.slider),this.ends[1],yt("Delete key","Take away the keys of the selected controls, or all keys, at this frame",()=>this.unkey()),this.autoButton,this.tween(),this.sheetButton,this.soundButton,this.soundStart,yt("Save animation layer","Download the keys over the clip as a USD layer",()=>this.save()))}update(){let{session:t}=this,{range:e}=t,[n,i]=e;this.number.textContent=t.neutral&&t.animation.clip?.times.length>1?"neutral":`${this.frame}`,this.number.title=t.neutral?"The pose of the layout; the time line shows the animation":"Frame",Object.assign(this.slider,{min:n,max:i,value:this.frame}),this.ends.forEach((l,c)=>{l.hidden=!t.animation.isFree,document.activeElement!==l&&(l.value=String(e[c]))}),this.slider.style.setProperty("--at",ns(this.frame,e)),this.playButton.textContent=this.playing?"■":"▶";let r=t.unkeyed().length;this.unkeyed.textContent=r?`${r} not keyed`:"",this.autoButton.update(),this.showSound(n,i);let o=new Set(t.notes.filter(({neutral:l})=>!l).map(({frame:l})=>l)),a=l=>c=>O("i",{class:l,style:{left:ns(c,e)}});this.ticks.replaceChildren(...this.keyFrames().map(a("")),...[...o].map(a("noted")))}setSpan(t){let e=this.session.range,n=this.ends.map(r=>Math.round(Number(r.value))),i=e[1]-e[0];n[0]>=n[1]&&(n[1-t]=n[t]+(t?-i:i)),this.session.respan(n[0],n[1])||this.say("A frame is a whole number"),this.ends.forEach((r,o)=>r.value=String(this.session.range[o]))}showSound(t,e){let{sound:n,session:i}=this,{name:r,start:o}=i.sound??{},a=n.isReady;this.soundButton.textContent=r?a?Lm(r):`Open ${Lm(r)} again`:"Sound…",this.soundButton.title=r?`${r}: open it again, or another`:"Open a sound of your disk; it is played in step with the frames and sent nowhere",this.soundStart.hidden=!r,r&&(this.soundStart.value=o);let l=a?n.wave(t,e):null;this.waves.firstChild!==l&&this.waves.replaceChildren(...l?[l]:[])}openSound(){return pi("audio/*,.wav,.mp3,.ogg,.m4a,.flac",this.say,({file:t})=>this.sound.read(t))}openSheet(t){this.sheet.toggle(t),this.sheetButton.update()}tween(){let t=O("input",{type:"range",class:"tween",min:-25,max:125,value:50,title:"Tween: between the keys before and after, and a little beyond","aria-label":"Tween between the keys before and after",oninput:()=>this.session.tween(Number(t.value)/100)||this.say("No control here has a key before and one after"),onchange:()=>t.value="50"});return t}keyFrames(){return Se(this.sheet.everyKey.map(([,t])=>t))}key(){this.session.looks&&this.session.adopt();let t=[...new Set([...this.chosen([]),...this.session.changed()])];t.length?this.session.key(t):this.say("Nothing to key: select a control or change one")}unkey(){let t=this.chosen([...this.session.keys.keys()]);this.session.unkey(t)||this.say(`No key at frame ${this.frame}`)}chosen(t){return this.session.selection.size?this.session.chosenControls:t}step(t){let e=this.keyFrames(),[n,i]=this.session.range,r=t>0?e.find(o=>o>this.frame):e.findLast(o=>o<this.frame);this.go(r??Vt(this.frame+t,n,i))}go(t,e=!1){let n=this.frame,i=this.session.go(t,e);i.length&&this.say(`${Nm(this.session,i)} of frame ${n} not keyed and left behind · Ctrl+Z goes back`)}toggle(){this.playing?this.stop():this.play()}stop(){this.playing&&(this.playing=!1,this.sound.stop(),this.update())}get played(){return(this.sheet.node.hidden?null:this.sheet.span)??this.session.range}async play(){let[t,e]=this.played,n=this.frame<t||this.frame>=e;(this.session.neutral||n)&&this.go(n?t:this.frame),this.playing=!0,this.update();let i=await this.sound.play(this.frame);if(!this.playing)return this.sound.stop();let r=i()-(this.frame-t)/this.rate,o=e-t+1,a=()=>{if(!this.playing)return;let l=t+Math.floor(Math.max(0,i()-r)*this.rate)%o;l<this.frame&&this.sound.from(l),l!==this.frame&&this.go(l),requestAnimationFrame(a)};return requestAnimationFrame(a)}save(){let{session:t}=this,{text:e,unwritten:n}=Ju(t);if(!e){this.say("Nothing is keyed and no pose is set: there is no animation to save");return}let i=t.fileNamed("animation.usda");Mn(i,e),t.emit("saved");let r=t.unkeyed(),o=[`Saved ${i}, keys at ${ce(this.keyFrames().length,"frame")}`,r.length?`Not keyed and not in it: ${Nm(t,r)} of frame ${this.frame}`:"",n.length?`No animation drives ${n.join(", ")}`:"",t.animation.clip?.thinned?"The clip was too long to show whole: the layer holds the frames kept":""].filter(Boolean);this.say(o.join(" · "))}},Lm=s=>s.length>18?`${s.slice(0,8)}…${s.slice(-8)}`:s;function Nm({controls:s},t){return t.length===1?s[t[0]].label:`${t.length} changes`}var Ww=16,Xw=600,jl=class{ways=[];made=[];constructor(t,e,n){this.session=t,this.view=e,this.timeline=n,e.trails=this;for(let i of["time","picked"])t.on(i,()=>t.options.trails&&e.changed("overlay"));t.on("layout",()=>this.made=[])}shown(){let{session:t,view:e}=this;if(!t.options.trails||t.trial||!e.controlsColumn)return[];this.renew();let n=e.camera.projector(e.controlsColumn);return this.ways.map(({element:i,places:r})=>({colour:t.colours[i.side],places:r.map(({handle:o,origin:a,...l})=>({...l,at:e.overlay.mapOf(i,n,a)(o)}))}))}renew(){let{session:t}=this,e=t.selectedElements.filter(o=>!o.onBoard&&t.isShown(o)).slice(0,Ww);if(t.dragging&&$n(e,this.ways.map(({element:o})=>o)))return;let[n,i]=this.timeline.played,r=[...e,t.keys,[...t.allConstants()].join(),n,i,t.options.follow];$n(r,this.made)||(this.made=r,this.ways=this.placed(e,n,i))}placed(t,e,n){let{session:i}=this,r=t.map(({members:d})=>new Set(d.flatMap(({control:u})=>(i.keys.get(u)??[]).map(([f])=>f)))),o=Math.ceil((n-e+1)*t.length/Xw)||1,a=Array.from({length:Math.floor((n-e)/o)+1},(d,u)=>e+u*o),l=r.flatMap(d=>[...d]).filter(d=>d>=e&&d<=n),c=d=>i.elements.follow(d,!i.options.follow,t),h=Se([...a,...l,n]).map(d=>i.atFrame(d,u=>(c(u),t.map(({handle:f,origin:p},x)=>({frame:d,isKey:r[x].has(d),handle:f,origin:p})))));return c(i.values),t.map((d,u)=>({element:d,places:h.map(f=>f[u])}))}};var qw=new Set(["Ctrl+z","Ctrl+Shift+z","Ctrl+y","Escape"]),Dm="string pose = ",$w=320,Om=1200,Yw=[["Drag a handle","its control; Ctrl for fine steps"],["Touch","one finger drags, two pan, pinch and turn; handles under one finger move apart, a fan of them around it: touch one of these"],["Drag the skin","best fit of the controls that act there"],["Drag empty space, Alt-drag","orbit; right or middle button pans, wheel zooms"],["Click the skin","list what acts there"],["Shift-click","add to the selection; on skin: pin (or rest a finger there)"],["Shift-drag","select handles in a box"],["Double-click a handle","reset it"],["Tab, arrow keys","go through the handles, and move them (Shift: more, Ctrl: less)"],["S  H  L","symmetry, show or hide handles, all labels"],["Hold H, B, I","hide all elements, show the pose before, show what the selection moves"],["C  P  N","the list of controls, the panel, the notes of a review"],["Double-click the skin","look at a region closely, and back"],["M","open the selected coarse element into its members, or close it"],["0  R","zero, reset the selection"],["K","key the selection and all that changed"],["1  2  3  4  F  V","front, three-quarter, side, back; F: closer, on the face or the selection, and back; V: as the shot's camera"],["Space","play"],["D","all keys in rows or as curves: drag moves (Ctrl: copies, Alt: scales those picked), a drag from an empty place picks, Space plays these, Delete takes away"],["O  T","onion skin: the keys before and after as outlines; motion trails of the selected handles on the face, a dot for each key"],["Ctrl+C, Ctrl+V","copy and paste the pose of the selection, or of all"],["/  ?","search, these gestures and keys"],["Ctrl+Z, Ctrl+Shift+Z","undo, redo"],["Esc","cancel the drag, clear the selection"]],vu=class{view;timeline;list;inspector;review;evaluation;constructor(t){this.tell=n=>this.say(n),this.scene=t,this.node=document.getElementById("app"),this.notice=O("div",{class:"notice",role:"status",hidden:!0}),this.offer=O("div",{class:"offer",role:"alertdialog","aria-label":"Work from before",hidden:!0}),this.storage=xd(),this.kept=t.characters.map(()=>null),this.roots=t.characters.map(({root:n})=>n);let e=Kw();this.reviews=e.filter(n=>!n.includes(Dm)).flatMap(n=>eo(n)),this.targets=e.filter(n=>n.includes(Dm)),this.live=this.makeLive(),this.open(0),this.live?.run();for(let n of["pagehide","beforeunload"])window.addEventListener(n,i=>this.leave(i));cm(this.shortcuts(),{h:n=>this.view.hold("bare",n),b:n=>this.session.looks||this.session.compare(n),i:n=>this.view.hold("showsInfluence",n)},n=>this.session.trial&&!qw.has(n))}open(t){this.evaluation?.running&&this.evaluation.finish(),this.timeline?.stop(),this.kept[this.index]?.autosave.flush(),this.session?.leave(),this.index=t;let{session:e,autosave:n}=this.kept[t]??=this.begin(this.scene.characters[t]);this.session=e,this.live?.follow(e),n.listen(()=>this.say("This browser has no room to keep your work: save it before you close the page")),this.view=new Pl(this.session,this.tell),this.timeline=new Jl(this.session,this.tell),this.trails=new jl(this.session,this.view,this.timeline),this.list=new yo(this.session,this.view),this.inspector=new Ll(this.session,this.view,this.timeline,this.tell),this.review=new Ol(this.session,this.view,this.timeline,this.tell,this.roots,()=>this.reviewed()),this.evaluation=new Mo(this),this.stops=new Nl(this.session,this.view),this.help=this.makeHelp(),this.view.node.append(this.evaluation.panel,this.help,this.offer,this.notice);let i=O("div",{class:"middle"},this.view.node,this.list.node,this.inspector.node,this.review.node);this.node.replaceChildren(i,new vo(this).node,this.timeline.sheet.node,this.timeline.node),this.node.className="ready",this.fold("list",!1),this.fold("review",this.session.arrived.length>0),this.fold("inspector",window.innerWidth>=Om&&!this.session.arrived.length),this.offerWork(n)}begin(t){let e=new ql(t);e.notes=e.arrived=to(this.reviews,e,this.roots),e.received=e.notes.map(({id:i})=>i);let n=()=>!!this.live?.holds(e)&&dd(e);return{session:e,autosave:new mo(e,this.storage,n)}}reviewed(){return this.scene.characters.map((e,n)=>(this.kept[n]??=this.begin(e)).session).map(e=>[e,e.notes])}makeLive(){let{live:t}=document.body.dataset;if(!t)return null;this.kept=this.scene.characters.map(n=>this.begin(n));let e=this.kept.map(({session:n})=>n);for(let n of e)n.options.autoKey=!0,n.animation.clip&&n.go(n.frame);return new Dl(e,t,this.tell)}offerWork(t){let e=t.offered;if(this.offer.hidden=!e,!e)return;let n=(o,a)=>yt(o,"",()=>{a(),t.discard(e),this.offerWork(t)}),i=()=>{pd(this.session,e.work),t.flush()},r=new Date(e.saved).toLocaleString([],{dateStyle:"medium",timeStyle:"short"});this.offer.replaceChildren(O("span",{},`Your work of ${r}: ${e.words}`),n("Restore",i),n("Discard",()=>{}))}leave(t){let e=this.kept.filter(Boolean).map(({autosave:n})=>n);e.forEach(n=>n.flush()),e.some(n=>n.isUnsaved)&&t.preventDefault()}startAfresh(t=this.index){this.kept[t]?.autosave.forget(),this.kept[t]=null,this.open(t)}fold(t,e=this[t].node.hidden){let n=["list","inspector","review"].filter(r=>r!==t),i=window.innerWidth<Om?n:n.filter(r=>r!=="list"&&t!=="list");e&&i.forEach(r=>this[r].node.hidden=!0),this[t].node.hidden=!e,this.node.classList.toggle("reviewing",!this.review.node.hidden),this.review.node.hidden&&(this.session.options.draw=!1),this.session.emit("options")}makeHelp(){let t=Yw.flatMap(([e,n])=>[O("dt",{},e),O("dd",{},n)]);return O("div",{class:"help",hidden:!0},O("h2",{},"Gestures and keys"),O("dl",{},...t))}showHelp(){this.help.hidden=!this.help.hidden}setArrangement(t){this.session.setOption("arrangement",t),this.view.home(this.view.camera.azimuth,this.view.camera.elevation)}undo(){this.sayDone("Undone","undo",this.session.undo())}redo(){this.sayDone("Redone","redo",this.session.redo())}sayDone(t,e,n){this.say(n?`${t}: ${n}`:`Nothing to ${e}`)}say(t){this.notice.textContent=t,this.notice.hidden=!1,clearTimeout(this.silence),this.silence=setTimeout(()=>this.notice.hidden=!0,Math.max(2400,70*t.length))}shortcuts(){let t=n=>()=>this.session.flipOption(n),e=bc.map(([,n,i],r)=>[r+1,()=>this.view.home(n,i)]);return{"Ctrl+z":()=>this.undo(),"Ctrl+Shift+z":()=>this.redo(),"Ctrl+y":()=>this.redo(),"Ctrl+a":()=>this.session.select(this.view.overlay.elementsIn([-1e9,-1e9,1e9,1e9])),s:t("symmetric"),h:t("handles"),c:()=>this.fold("list"),p:()=>this.fold("inspector"),n:()=>this.fold("review"),l:()=>this.session.setOption("labels",this.session.options.labels==="all"?"hover":"all"),0:()=>this.session.zero(this.session.chosenControls),r:()=>this.session.reset(this.session.chosenControls),m:()=>this.session.openOrClose()||this.say("Nothing selected has members"),k:()=>this.timeline.key(),d:()=>this.timeline.openSheet(),o:t("onion"),t:t("trails"),v:()=>this.session.character.shotCamera?this.session.flipOption("shot"):this.say("The stage has no camera, or several and no render settings that choose one"),"Ctrl+c":()=>this.session.copy(),"Ctrl+v":()=>this.session.paste(),...Object.fromEntries(e),f:()=>this.view.frameClosely()," ":()=>this.timeline.toggle(),"/":()=>{this.fold("list",!0),this.list.search.focus()},"?":()=>this.showHelp(),"Shift+?":()=>this.showHelp(),Escape:()=>this.escape()}}escape(){lm()||this.view.gestures.cancel()||(this.help.hidden?this.session.options.draw?this.review.setPen(!1):this.session.select([]):this.help.hidden=!0)}identity(){let{identity:t,layoutDigest:e}=this.session.character;return{character:t,layout:e,version:this.scene.version}}arrangeForTrial(t,e){let n={list:["target","clean"],face:["target","controls"],beside:["target","clean","controls"]},i={target:"Target",clean:"Your face",controls:t==="beside"?"Controls":"Your face"};this.node.classList.add("trial"),this.node.classList.toggle("trial-list",t==="list"),this.list.node.hidden=t!=="list",Object.assign(this.session.options,{skinDrag:!1,rearrange:!1,symmetric:!1,heat:!1,handles:t!=="list"}),this.view.stage.setTarget(e),this.session.emit("options"),this.view.setColumns(n[t],r=>i[r],()=>this.view.commonRoom($w))}endTrials({work:t,history:e,options:n}){this.node.classList.remove("trial","trial-list"),this.fold("list",!1),Object.assign(this.session.options,n),this.view.stage.setTarget(null),this.session.history=e,this.session.trial=!1,this.session.restore(t),this.session.emit("options"),this.view.setColumns(null)}},Kw=()=>JSON.parse(document.getElementById("reviews")?.textContent??"[]");function Zw(s){let t=()=>s.session.controls.map(({name:e})=>e);return{values:()=>Object.fromEntries(t().map((e,n)=>[e,s.session.values[n]])),set:e=>s.session.edit("Set",()=>s.session.set(Ln(e,s.session.controls))),pull:(e,n)=>{let i=new fs(s.session,{corners:[e,e,e],shares:[1,0,0]},null);for(let r=0;r<3;r++)i.to(n)},points:()=>Array.from(s.session.deformer.points),elements:()=>(s.view.freshen(),s.view.overlay.drawn.map(({element:e,handle:n,tracks:i,hidden:r})=>({name:e.name,controls:e.members.map(({control:o})=>s.session.controls[o].name),handle:n.slice(0,2),world:e.handle,tracks:i.map(o=>o.map(({at:a})=>a.slice(0,2))),hidden:r}))),trials:e=>Cc(e,s.session),app:s}}async function Jw(){let s=document.getElementById("scene")?.textContent;try{let t=await xm(s);window.usdrigui=Zw(new vu(t))}catch(t){let e=`The scene could not be shown: ${t.message}`;throw document.getElementById("app")?.replaceChildren(O("p",{class:"loading"},e)),t}}Jw();})();
// sources 1770e769721d4ebf0fe0e8d993661226f0508094f8be6cd6b0a7f3864cc05f31
