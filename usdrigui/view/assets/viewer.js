"use strict";(()=>{var Fn=n=>Number(n.toPrecision(9)),Vt=(n,t,e)=>Math.min(e,Math.max(t,n)),Ce=(n,t,e)=>(1-e)*n+e*t,Ee=n=>[...new Set(n)].sort((t,e)=>t-e),wn=(n,t)=>n.length===t.length&&n.every((e,i)=>e===t[i]);function oe(n,t,e){return n.has(t)||n.set(t,e(t)),n.get(t)}function Et(n,t){let e=0;for(let i=0;i<n.length;i++)e+=n[i]*t[i];return e}function Sn(n,t,e){if(n.length===1)return t[0];let[i,s]=Qr(n,e);return t[i].map((r,o)=>Ce(r,t[i+1][o],s))}function Qr(n,t){let e=to(n,t);return[e,(t-n[e])/(n[e+1]-n[e])]}function to(n,t){let e=0;for(;e<n.length-2&&t>=n[e+1];)e++;return e}function as(n){let t=0;for(let e=1;e<n.length;e++)t+=Math.hypot(...n[e].map((i,s)=>i-n[e-1][s]));return t}var eo=["linear","smooth","stepped"],Wg=2**-7,rn=n=>n[2]??"linear",Xg=(n,t,e="linear",i=null)=>[n,t,...i!==null?[e,i]:e==="linear"?[]:[e]];function no(n,t,e,i=qg(n,t),s=n.find(([r])=>r===t)?.[3]){return[...gc(n,t),Xg(t,e,i,s)].sort(([r],[o])=>r-o)}var gc=(n,t)=>n.filter(([e])=>e!==t);function qg(n,t){let e=n.findLast(([i])=>i<=t)??n[0];return e&&rn(e)}function ju(n,t,e){let[[i,s],[r,o]]=[n[t],n[t+1]],a=rn(n[t]);if(a==="linear")return Ce(s,o,(e-i)/(r-i));let[l,c]=a==="stepped"?$g(i,r,e):[Math.max(i,Math.floor(e)),Math.min(r,Math.ceil(e))],h=u=>a==="smooth"?Yg(n,t,u):u===r?o:s;return c>l?Ce(h(l),h(c),(e-l)/(c-l)):h(l)}var io=n=>n.slice(1).flatMap(([t],e)=>rn(n[e])==="stepped"?[Qu(n[e][0],t)]:[]),Qu=(n,t)=>Math.max(n,t-Wg);function $g(n,t,e){let i=Qu(n,t);return e<=i?[n,n]:[i,t]}function Yg(n,t,e){let[[i,s],[r,o]]=[n[t],n[t+1]],a=r-i,l=(e-i)/a,[c,h]=[t,t+1].map(d=>a*xc(n,d)),u=1-l;return s*(1+2*l)*u*u+c*l*u*u+o*l*l*(3-2*l)-h*l*l*u}function xc(n,t){let[e,i,s]=[n[t-1],n[t],n[t+1]];if(i.length>3)return i[3];if(!e||!s)return 0;let[r,o]=[i[0]-e[0],s[0]-i[0]],[a,l]=[(i[1]-e[1])/r,(s[1]-i[1])/o];if(a*l<=0)return 0;let[c,h]=[r+2*o,2*r+o];return(c+h)/(c/a+h/l)}function jn({controls:n},{keys:t,constants:e,span:i=null}){let s=(r,o)=>Object.fromEntries([...r].sort(([a],[l])=>a-l).map(([a,l])=>[n[a].name,o(l)]));return{keys:s(t,r=>r.map(([o,a,...l])=>[Fn(o),Fn(a),...l])),standing:s(e,Fn),...i?{span:i}:{}}}function Qn({keys:n,standing:t,span:e},{controls:i,animation:s}){let r=s.isFree&&Kg(e)?e:null;return{keys:vc(n,i,Jg),constants:vc(t,i,Number.isFinite),span:r}}var xi=(n,t)=>jn(n,{keys:new Map,constants:t}).standing,Un=(n,t)=>vc(n,t,Number.isFinite);function vc(n,t,e){let i=new Map(t.map(({name:r},o)=>[r,o])),s=Object.entries(n??{}).filter(([r,o])=>i.has(r)&&e(o));return new Map(s.map(([r,o])=>[i.get(r),o]))}function fn(n,t=null){try{return JSON.parse(n)}catch{return t}}var Kg=n=>Array.isArray(n)&&n.length===2&&n.every(Number.isInteger)&&n[0]<n[1],Zg=n=>Array.isArray(n)&&[2,3,4].includes(n.length)&&n.slice(0,2).every(Number.isFinite)&&eo.includes(rn(n))&&Number.isFinite(n[3]??0),Jg=n=>Array.isArray(n)&&n.length>0&&n.every(Zg);var er=44;function U(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))s.startsWith("on")?i.addEventListener(s.slice(2),r):s==="class"?i.className=r:s==="style"?Object.assign(i.style,r):s.includes("-")||s==="role"||s==="for"?i.setAttribute(s,r):i[s]=r;return i.append(...e.filter(s=>s!=null)),i}var be=(...n)=>U("p",{class:"hint"},...n),tn=(...n)=>U("div",{class:"actions"},...n),vi=(n,t,e={})=>U("label",{class:"field",...e},U("span",{},n),t);function so(n,t,e){let i=U("input",{type:"range",...n,oninput:()=>e(Number(i.value))});return i.update=()=>{i.value=t(),i.style.setProperty("--at",ls(i.value,[i.min,i.max]))},i}function ro(n,t,e,i){let{label:s}=n.controls[t],r=U("input",{"aria-label":s,...e,onchange:()=>{let o=parseFloat(r.value.replace(",","."));Number.isFinite(o)&&n.edit(`Set ${s}`,()=>n.set([[t,o]]),`${i} ${t}`),r.value=n.worded(t)}});return r}var ls=(n,[t,e])=>`${100*(n-t)/(e-t)}%`;function ti(n,t){for(let[e,i]of Object.entries(t))n.setAttribute(e,String(i))}var oo=({left:n,top:t,width:e,height:i},{x:s,y:r})=>s>=n&&s<n+e&&r>=t&&r<t+i,he=(n,t)=>`${n} ${t}${n===1?"":"s"}`,cs=n=>n.charAt(0).toUpperCase()+n.slice(1);function yc(n){let t=/[_.:\- ][^_.:\- ]{1,9}$/.exec(n)??/[A-Z][a-z]{1,8}$/.exec(n);return t?t[0]:n.slice(-5)}function nr(n){let t=yc(n),e=n.slice(0,n.length-t.length);return U("span",{class:"long-name"},U("span",{class:"start"},e),U("span",{},t))}var vt=(n,t,e,i={})=>U("button",{type:"button",title:t,onclick:e,...i},n);function kn(n,t,e,i){let s=vt(n,t,i,{class:"toggle"});return s.update=()=>ti(s,{"aria-pressed":e()}),s.update(),s}function yi(n,t,e,i){let s=t.map(([o,a,l])=>vt(a,l,()=>i(o))),r=U("div",{class:"segmented",role:"group","aria-label":n},...s);return r.update=()=>{s.forEach((o,a)=>ti(o,{"aria-pressed":t[a][0]===e()}))},r.update(),r}function An(n,t,e="text/plain"){let i=URL.createObjectURL(new Blob([t],{type:e})),s=U("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function _i(n,t,e){let i=await jg(n);try{i&&await e(i)}catch(s){t(s.message)}}function jg(n){return new Promise(t=>{let e=U("input",{type:"file",accept:n});e.addEventListener("change",async()=>{let i=e.files[0];t(i?{name:i.name,file:i,text:n.startsWith("audio")?"":await i.text()}:null)}),e.addEventListener("cancel",()=>t(null)),e.click()})}function ed(n,t=1){let e=Vt(2-Math.floor(Math.log10(Math.max(t,1e-6))),2,6);return n.toFixed(e)}var Gi=32,Qg=2;function ao(n,t,e){let i=a=>Gi*Math.floor(Math.max(0,a)/Gi),s=(a,l)=>Math.min(l,Gi*Math.ceil(a/Gi)),r=[i(n[0]),i(n[1]),s(n[2],e[0]),s(n[3],e[1])];return r[0]<r[2]&&r[1]<r[3]?t&&r[0]>=t[0]&&r[1]>=t[1]&&r[2]<=t[2]&&r[3]<=t[3]&&td(t)<=Qg*td(r)?t:r:t??[0,0,1,1]}var td=([n,t,e,i])=>(e-n)*(i-t);function lo(n,[t,e,i,s]){Object.assign(n.style,{left:`${t}px`,top:`${e}px`,width:`${i-t}px`,height:`${s-e}px`})}var t0=14*Math.PI/180,_c=Math.tan(t0/2),nd=88*Math.PI/180,zn=class{right;above;towards;constructor(t,e){this.up=Vi(t);let i=Vi(ve(e,ue(this.up,Et(e,this.up))));this.front=i??e0(this.up),this.side=Bn(this.up,this.front),this.target=[0,0,0],this.distance=1,this.size=1,this.half=_c,this.turn(0,0)}turn(t,e){this.distance*=this.half/_c,this.half=_c,this.azimuth=t,this.elevation=Vt(e,-nd,nd);let i=we(ue(this.front,Math.cos(t)),ue(this.side,Math.sin(t)));this.towards=we(ue(i,Math.cos(this.elevation)),ue(this.up,Math.sin(this.elevation))),this.right=Vi(Bn(this.up,this.towards)),this.above=Bn(this.towards,this.right)}leaveShot(){this.turn(this.azimuth,this.elevation)}lookFrom(t,e,i){this.turn(Math.atan2(Et(e,this.side),Et(e,this.front)),Math.asin(Vt(Et(e,this.up),-1,1))),this.target=t,this.distance=i}lookThrough([t,e,i,s,[r,o]],{width:a,height:l}){let c=Et(ve(s,this.target),i);this.lookFrom(this.target,i,c>0?c:this.distance),this.target=ve(s,ue(i,this.distance)),Object.assign(this,{right:t,above:e,towards:i,half:Math.max(o,r*l/a)})}frame(t,e,i,s=1.06){if(!t.length)return;let r=[this.right,this.above,this.towards].map(h=>t.reduce(([u,d],f)=>[Math.min(u,Et(f,h)),Math.max(d,Et(f,h))],[1/0,-1/0]));this.target=[this.right,this.above,this.towards].reduce((h,u,d)=>we(h,ue(u,.5*(r[d][0]+r[d][1]))),[0,0,0]);let[o,a,l]=r.map(([h,u])=>u-h),c=.5*s*Math.max(a,o*i/Math.max(1,e),1e-6);this.distance=c/this.half+.5*l,this.size=Math.max(o,a,l)}zoom(t){this.leaveShot(),this.distance=Vt(this.distance*t,.02*this.size,50*this.size)}pan(t,e,i){this.leaveShot();let s=this.pixelSize(i);this.target=we(this.target,we(ue(this.right,-t*s),ue(this.above,e*s)))}pixelSize(t){return 2*this.distance*this.half/t}get position(){return we(this.target,ue(this.towards,this.distance))}get fieldDegrees(){return 2*Math.atan(this.half)*180/Math.PI}projector(t){let e=this.position,i=t.height/(2*this.half),[s,r]=[t.left+t.width/2,t.top+t.height/2],{right:o,above:a,towards:l}=this;return c=>{let h=ve(c,e),u=-Et(h,l),d=i/Math.max(u,1e-9);return[s+Et(h,o)*d,r-Et(h,a)*d,u]}}unproject(t,e,i,s){let r=2*this.half*s/t.height,o=(e-t.left-t.width/2)*r,a=-(i-t.top-t.height/2)*r,l=we(we(ue(this.right,o),ue(this.above,a)),ue(this.towards,-s));return we(this.position,l)}},we=(n,t)=>[n[0]+t[0],n[1]+t[1],n[2]+t[2]],ve=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],ue=(n,t)=>[n[0]*t,n[1]*t,n[2]*t];function Bn(n,t){return[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]]}function Vi(n){let t=Math.hypot(...n);return t>1e-12?ue(n,1/t):null}var e0=n=>Vi(Bn(Math.abs(n[0])<.9?[1,0,0]:[0,1,0],n));function Mi(n,t=[]){return["#usda 1.0",...t.length?["(",...t.map(i=>`    ${i}`),")"]:[],"",...id(n0(n)),""].join(`
`)}var hs=(n,...t)=>[`${n} = {`,"    dictionary usdrigui = {",...t.map(e=>`        ${e}`),"    }","}"];function n0(n){let t={children:new Map};for(let[e,i]of n){let s=t;for(let r of e.split("/").filter(Boolean))s.children.has(r)||s.children.set(r,{children:new Map,type:"over",metadata:"",lines:[]}),s=s.children.get(r);Object.assign(s,i)}return t}function id({children:n},t=""){return[...n].flatMap(([e,i])=>[`${t}${i.type} ${Ve(e)}${i.metadata&&" ("}`,...i.metadata?[...i.metadata.split(`
`).map(s=>`${t}    ${s}`),`${t})`]:[],`${t}{`,...i.lines.map(s=>`${t}    ${s}`),...id(i,`${t}    `),`${t}}`])}function Ve(n){return`"${n.replace(/["\\]/g,"\\$&").replace(/\n/g,"\\n")}"`}var i0=n=>n.slice(1,-1).replace(/\\(.)/g,(t,e)=>e==="n"?`
`:e);function Mc(n,t=""){return[...n.matchAll(new RegExp(`${t}("(?:[^"\\\\]|\\\\.)*"|'(?:[^'\\\\]|\\\\.)*')`,"g"))].map(([,i])=>i0(i))}var Hi=(n,t)=>Mc(t,`string ${n} = `);function sd(n){let t=i=>fn(i.replaceAll("(","[").replaceAll(")","]"));return{samples:[...n.matchAll(/^ +([-+.\de]+): (.*?)(?:;.*)?,$/gm)].map(([,i,s])=>[Number(i),t(s)]),one:t(/^[^\n=]* = ([-+.\de]+)/.exec(n)?.[1]??"")}}var me=n=>String(Fn(n)+0),us=n=>`(${[...n].map(me).join(", ")})`;var bc=24,s0=.004,rd=1-1e-7;function od(n,t){let{target:e,towards:i,right:s,distance:r}=n;return{target:e.map(ds),towards:i.map(ds),right:s.map(ds),distance:ds(r),height:ds(n.pixelSize(1)),aspect:ds(t.width/t.height)}}function wc({target:n,towards:t,right:e},[i,s]){return we(n,we(ue(e,i),ue(Bn(t,e),s)))}function ad({target:n,towards:t,right:e},i){let s=ve(i,n);return[Et(s,e),Et(s,Bn(t,e))]}var ld=(n,{towards:t,right:e})=>Et(n.towards,t)>rd&&Et(n.right,e)>rd;function co(n,t){if(n.length<3)return n;let[e,i]=[n[0],n.at(-1)],s=n.map(o=>r0(o,e,i)),r=s.indexOf(Math.max(...s));return s[r]<=t?[e,i]:[...co(n.slice(0,r+1),t).slice(0,-1),...co(n.slice(r),t)]}function r0([n,t],[e,i],[s,r]){let[o,a]=[s-e,r-i],l=o*o+a*a,c=l?Vt(((n-e)*o+(t-i)*a)/l,0,1):0;return Math.hypot(n-e-c*o,t-i-c*a)}function ir({controls:n},t){return new Map([...t.entries()].filter(([e,i])=>i!==n[e].default))}function fs({controls:n},{values:t}){return Float64Array.from(n,({default:e},i)=>t.get(i)??e)}function Sc(n,{id:t,frame:e,neutral:i,text:s,done:r,values:o,section:a,look:l,strokes:c}){return{id:t,root:n.character.root,frame:e,neutral:i,text:s,done:r,values:xi(n,o),section:a,look:l,strokes:c}}function Ac(n,{controls:t}){let{id:e,frame:i,neutral:s,text:r,done:o,values:a,section:l,look:c,strokes:h}=n??{};return typeof e=="string"&&Number.isFinite(i)&&a0(c)&&Array.isArray(h)&&h.every(o0)?{id:e,frame:i,neutral:s===!0,text:String(r??""),done:o===!0,values:Un(a,t),section:String(l??""),look:c,strokes:h}:null}function ho(n,t,e){let{root:i}=t.character,s=n.filter(r=>r.root===i||i===e[0]&&!e.includes(r.root));return sr([],s.map(r=>Ac(r,t)).filter(Boolean))}function sr(n,t){let e=new Map(n.map(i=>[i.id,i]));return t.forEach(i=>e.set(i.id,i)),[...e.values()]}var cd=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(Number.isFinite),o0=n=>Array.isArray(n)&&n.length>0&&n.every(t=>cd(t,2)),a0=n=>["target","towards","right"].every(t=>cd(n?.[t],3))&&Math.abs(Et(n.towards,n.right))<.001&&!!Vi(n.towards)&&!!Vi(n.right)&&["distance","height","aspect"].every(t=>n[t]>0&&Number.isFinite(n[t]));function hd(n){let t=new Map;for(let[i,s]of n){if(!s.length)continue;let r=`${i.character.root}/RigUIReview`;t.set(r,{type:"def Scope",lines:['uniform token purpose = "guide"']}),s.forEach((o,a)=>l0(t,`${r}/note_${a+1}`,i,o))}let[e=""]=[...t.keys()].map(i=>i.split("/")[1]);return Mi(t,[`defaultPrim = ${Ve(e)}`])}function l0(n,t,e,i){n.set(t,{type:"def Scope",metadata:[`displayName = ${Ve(Ec(i))}`,`doc = ${Ve(i.text)}`,...hs("customData",`string note = ${Ve(JSON.stringify(Sc(e,i)))}`)].join(`
`)}),n.set(`${t}/view`,{type:"def Camera",lines:c0(i.look)}),i.strokes.length&&n.set(`${t}/strokes`,{type:"def BasisCurves",lines:h0(i)})}var Ec=({frame:n,neutral:t})=>t?"Neutral pose":`Frame ${me(n)}`;function c0({target:n,towards:t,right:e,distance:i,height:s,aspect:r}){let o=Bn(t,e),a=[[e,0],[o,0],[t,0],[we(n,ue(t,i)),1]],l=bc*i/s;return[`float focalLength = ${me(l)}`,`float horizontalAperture = ${me(bc*r)}`,`float verticalAperture = ${bc}`,`float2 clippingRange = (${me(.01*i)}, ${me(100*i)})`,`matrix4d xformOp:transform = ( ${a.map(([c,h])=>us([...c,h])).join(", ")} )`,'uniform token[] xformOpOrder = ["xformOp:transform"]']}function h0({look:n,strokes:t,frame:e,neutral:i}){let s=t.map(o=>o.length>1?o:[o[0],o[0]]),r=[`    ${me(e-1)}: "invisible",`,`    ${me(e)}: "inherited",`,`    ${me(e+1)}: "invisible",`];return['uniform token type = "linear"',`int[] curveVertexCounts = [${s.map(o=>o.length).join(", ")}]`,`point3f[] points = [${s.flat().map(o=>us(wc(n,o))).join(", ")}]`,`float[] widths = [${me(s0*n.height)}] (`,'    interpolation = "constant"',")","color3f[] primvars:displayColor = [(0.871, 0.397, 0.07)] (",'    interpolation = "constant"',")",...i?[]:["token visibility.timeSamples = {",...r,"}"]]}function uo(n){let t=n.startsWith("#usda")?Hi("note",n).map(e=>fn(e)).filter(Boolean):[];if(!t.length)throw new Error("This layer holds no notes written by the viewer.");return t}var ds=n=>Fn(n)+0;var u0=Object.defineProperty,ms=(n,t)=>{for(var e in t)u0(n,e,{get:t[e],enumerable:!0})},Cc={};ms(Cc,{ANGLE_ORDER:()=>ud,ARRAY_TYPE:()=>se,EPSILON:()=>Ot,RANDOM:()=>ps,equals:()=>x0,round:()=>fo,setMatrixArrayType:()=>d0,toDegree:()=>g0,toRadian:()=>m0});var Ot=1e-6,se=typeof Float32Array<"u"?Float32Array:Array,ps=Math.random,ud="zyx";function fo(n){return n>=0?Math.round(n):n%.5===0?Math.floor(n):Math.round(n)}function d0(n){se=n}var f0=Math.PI/180,p0=180/Math.PI;function m0(n){return n*f0}function g0(n){return n*p0}function x0(n,t){var e=arguments.length>2&&arguments[2]!==void 0?arguments[2]:Ot;return Math.abs(n-t)<=e*Math.max(1,Math.abs(n),Math.abs(t))}var Be={};ms(Be,{add:()=>z0,adjoint:()=>E0,clone:()=>y0,copy:()=>_0,create:()=>dd,determinant:()=>T0,equals:()=>W0,exactEquals:()=>H0,frob:()=>B0,fromMat2d:()=>D0,fromMat4:()=>v0,fromQuat:()=>O0,fromRotation:()=>L0,fromScaling:()=>N0,fromTranslation:()=>P0,fromValues:()=>M0,identity:()=>w0,invert:()=>A0,mul:()=>X0,multiply:()=>fd,multiplyScalar:()=>G0,multiplyScalarAndAdd:()=>V0,normalFromMat4:()=>F0,projection:()=>U0,rotate:()=>R0,scale:()=>I0,set:()=>b0,str:()=>k0,sub:()=>q0,subtract:()=>pd,translate:()=>C0,transpose:()=>S0});function dd(){var n=new se(9);return se!=Float32Array&&(n[1]=0,n[2]=0,n[3]=0,n[5]=0,n[6]=0,n[7]=0),n[0]=1,n[4]=1,n[8]=1,n}function v0(n,t){return n[0]=t[0],n[1]=t[1],n[2]=t[2],n[3]=t[4],n[4]=t[5],n[5]=t[6],n[6]=t[8],n[7]=t[9],n[8]=t[10],n}function y0(n){var t=new se(9);return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t}function _0(n,t){return n[0]=t[0],n[1]=t[1],n[2]=t[2],n[3]=t[3],n[4]=t[4],n[5]=t[5],n[6]=t[6],n[7]=t[7],n[8]=t[8],n}function M0(n,t,e,i,s,r,o,a,l){var c=new se(9);return c[0]=n,c[1]=t,c[2]=e,c[3]=i,c[4]=s,c[5]=r,c[6]=o,c[7]=a,c[8]=l,c}function b0(n,t,e,i,s,r,o,a,l,c){return n[0]=t,n[1]=e,n[2]=i,n[3]=s,n[4]=r,n[5]=o,n[6]=a,n[7]=l,n[8]=c,n}function w0(n){return n[0]=1,n[1]=0,n[2]=0,n[3]=0,n[4]=1,n[5]=0,n[6]=0,n[7]=0,n[8]=1,n}function S0(n,t){if(n===t){var e=t[1],i=t[2],s=t[5];n[1]=t[3],n[2]=t[6],n[3]=e,n[5]=t[7],n[6]=i,n[7]=s}else n[0]=t[0],n[1]=t[3],n[2]=t[6],n[3]=t[1],n[4]=t[4],n[5]=t[7],n[6]=t[2],n[7]=t[5],n[8]=t[8];return n}function A0(n,t){var e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=-h*r+a*l,f=c*r-o*l,p=e*u+i*d+s*f;return p?(p=1/p,n[0]=u*p,n[1]=(-h*i+s*c)*p,n[2]=(a*i-s*o)*p,n[3]=d*p,n[4]=(h*e-s*l)*p,n[5]=(-a*e+s*r)*p,n[6]=f*p,n[7]=(-c*e+i*l)*p,n[8]=(o*e-i*r)*p,n):null}function E0(n,t){var e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return n[0]=o*h-a*c,n[1]=s*c-i*h,n[2]=i*a-s*o,n[3]=a*l-r*h,n[4]=e*h-s*l,n[5]=s*r-e*a,n[6]=r*c-o*l,n[7]=i*l-e*c,n[8]=e*o-i*r,n}function T0(n){var t=n[0],e=n[1],i=n[2],s=n[3],r=n[4],o=n[5],a=n[6],l=n[7],c=n[8];return t*(c*r-o*l)+e*(-c*s+o*a)+i*(l*s-r*a)}function fd(n,t,e){var i=t[0],s=t[1],r=t[2],o=t[3],a=t[4],l=t[5],c=t[6],h=t[7],u=t[8],d=e[0],f=e[1],p=e[2],x=e[3],m=e[4],g=e[5],_=e[6],w=e[7],y=e[8];return n[0]=d*i+f*o+p*c,n[1]=d*s+f*a+p*h,n[2]=d*r+f*l+p*u,n[3]=x*i+m*o+g*c,n[4]=x*s+m*a+g*h,n[5]=x*r+m*l+g*u,n[6]=_*i+w*o+y*c,n[7]=_*s+w*a+y*h,n[8]=_*r+w*l+y*u,n}function C0(n,t,e){var i=t[0],s=t[1],r=t[2],o=t[3],a=t[4],l=t[5],c=t[6],h=t[7],u=t[8],d=e[0],f=e[1];return n[0]=i,n[1]=s,n[2]=r,n[3]=o,n[4]=a,n[5]=l,n[6]=d*i+f*o+c,n[7]=d*s+f*a+h,n[8]=d*r+f*l+u,n}function R0(n,t,e){var i=t[0],s=t[1],r=t[2],o=t[3],a=t[4],l=t[5],c=t[6],h=t[7],u=t[8],d=Math.sin(e),f=Math.cos(e);return n[0]=f*i+d*o,n[1]=f*s+d*a,n[2]=f*r+d*l,n[3]=f*o-d*i,n[4]=f*a-d*s,n[5]=f*l-d*r,n[6]=c,n[7]=h,n[8]=u,n}function I0(n,t,e){var i=e[0],s=e[1];return n[0]=i*t[0],n[1]=i*t[1],n[2]=i*t[2],n[3]=s*t[3],n[4]=s*t[4],n[5]=s*t[5],n[6]=t[6],n[7]=t[7],n[8]=t[8],n}function P0(n,t){return n[0]=1,n[1]=0,n[2]=0,n[3]=0,n[4]=1,n[5]=0,n[6]=t[0],n[7]=t[1],n[8]=1,n}function L0(n,t){var e=Math.sin(t),i=Math.cos(t);return n[0]=i,n[1]=e,n[2]=0,n[3]=-e,n[4]=i,n[5]=0,n[6]=0,n[7]=0,n[8]=1,n}function N0(n,t){return n[0]=t[0],n[1]=0,n[2]=0,n[3]=0,n[4]=t[1],n[5]=0,n[6]=0,n[7]=0,n[8]=1,n}function D0(n,t){return n[0]=t[0],n[1]=t[1],n[2]=0,n[3]=t[2],n[4]=t[3],n[5]=0,n[6]=t[4],n[7]=t[5],n[8]=1,n}function O0(n,t){var e=t[0],i=t[1],s=t[2],r=t[3],o=e+e,a=i+i,l=s+s,c=e*o,h=i*o,u=i*a,d=s*o,f=s*a,p=s*l,x=r*o,m=r*a,g=r*l;return n[0]=1-u-p,n[3]=h-g,n[6]=d+m,n[1]=h+g,n[4]=1-c-p,n[7]=f-x,n[2]=d-m,n[5]=f+x,n[8]=1-c-u,n}function F0(n,t){var e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],x=t[13],m=t[14],g=t[15],_=e*a-i*o,w=e*l-s*o,y=e*c-r*o,E=i*l-s*a,S=i*c-r*a,v=s*c-r*l,A=h*x-u*p,L=h*m-d*p,T=h*g-f*p,I=u*m-d*x,D=u*g-f*x,F=d*g-f*m,R=_*F-w*D+y*I+E*T-S*L+v*A;return R?(R=1/R,n[0]=(a*F-l*D+c*I)*R,n[1]=(l*T-o*F-c*L)*R,n[2]=(o*D-a*T+c*A)*R,n[3]=(s*D-i*F-r*I)*R,n[4]=(e*F-s*T+r*L)*R,n[5]=(i*T-e*D-r*A)*R,n[6]=(x*v-m*S+g*E)*R,n[7]=(m*y-p*v-g*w)*R,n[8]=(p*S-x*y+g*_)*R,n):null}function U0(n,t,e){return n[0]=2/t,n[1]=0,n[2]=0,n[3]=0,n[4]=-2/e,n[5]=0,n[6]=-1,n[7]=1,n[8]=1,n}function k0(n){return"mat3("+n[0]+", "+n[1]+", "+n[2]+", "+n[3]+", "+n[4]+", "+n[5]+", "+n[6]+", "+n[7]+", "+n[8]+")"}function B0(n){return Math.sqrt(n[0]*n[0]+n[1]*n[1]+n[2]*n[2]+n[3]*n[3]+n[4]*n[4]+n[5]*n[5]+n[6]*n[6]+n[7]*n[7]+n[8]*n[8])}function z0(n,t,e){return n[0]=t[0]+e[0],n[1]=t[1]+e[1],n[2]=t[2]+e[2],n[3]=t[3]+e[3],n[4]=t[4]+e[4],n[5]=t[5]+e[5],n[6]=t[6]+e[6],n[7]=t[7]+e[7],n[8]=t[8]+e[8],n}function pd(n,t,e){return n[0]=t[0]-e[0],n[1]=t[1]-e[1],n[2]=t[2]-e[2],n[3]=t[3]-e[3],n[4]=t[4]-e[4],n[5]=t[5]-e[5],n[6]=t[6]-e[6],n[7]=t[7]-e[7],n[8]=t[8]-e[8],n}function G0(n,t,e){return n[0]=t[0]*e,n[1]=t[1]*e,n[2]=t[2]*e,n[3]=t[3]*e,n[4]=t[4]*e,n[5]=t[5]*e,n[6]=t[6]*e,n[7]=t[7]*e,n[8]=t[8]*e,n}function V0(n,t,e,i){return n[0]=t[0]+e[0]*i,n[1]=t[1]+e[1]*i,n[2]=t[2]+e[2]*i,n[3]=t[3]+e[3]*i,n[4]=t[4]+e[4]*i,n[5]=t[5]+e[5]*i,n[6]=t[6]+e[6]*i,n[7]=t[7]+e[7]*i,n[8]=t[8]+e[8]*i,n}function H0(n,t){return n[0]===t[0]&&n[1]===t[1]&&n[2]===t[2]&&n[3]===t[3]&&n[4]===t[4]&&n[5]===t[5]&&n[6]===t[6]&&n[7]===t[7]&&n[8]===t[8]}function W0(n,t){var e=n[0],i=n[1],s=n[2],r=n[3],o=n[4],a=n[5],l=n[6],c=n[7],h=n[8],u=t[0],d=t[1],f=t[2],p=t[3],x=t[4],m=t[5],g=t[6],_=t[7],w=t[8];return Math.abs(e-u)<=Ot*Math.max(1,Math.abs(e),Math.abs(u))&&Math.abs(i-d)<=Ot*Math.max(1,Math.abs(i),Math.abs(d))&&Math.abs(s-f)<=Ot*Math.max(1,Math.abs(s),Math.abs(f))&&Math.abs(r-p)<=Ot*Math.max(1,Math.abs(r),Math.abs(p))&&Math.abs(o-x)<=Ot*Math.max(1,Math.abs(o),Math.abs(x))&&Math.abs(a-m)<=Ot*Math.max(1,Math.abs(a),Math.abs(m))&&Math.abs(l-g)<=Ot*Math.max(1,Math.abs(l),Math.abs(g))&&Math.abs(c-_)<=Ot*Math.max(1,Math.abs(c),Math.abs(_))&&Math.abs(h-w)<=Ot*Math.max(1,Math.abs(h),Math.abs(w))}var X0=fd,q0=pd,En={};ms(En,{add:()=>Rx,adjoint:()=>tx,clone:()=>Y0,copy:()=>K0,create:()=>$0,decompose:()=>mx,determinant:()=>ex,equals:()=>Nx,exactEquals:()=>Lx,frob:()=>Cx,fromQuat:()=>vx,fromQuat2:()=>px,fromRotation:()=>hx,fromRotationTranslation:()=>xd,fromRotationTranslationScale:()=>gx,fromRotationTranslationScaleOrigin:()=>xx,fromScaling:()=>cx,fromTranslation:()=>lx,fromValues:()=>Z0,fromXRotation:()=>ux,fromYRotation:()=>dx,fromZRotation:()=>fx,frustum:()=>yx,getRotation:()=>_d,getScaling:()=>yd,getTranslation:()=>vd,identity:()=>md,invert:()=>Q0,lookAt:()=>Ax,mul:()=>Dx,multiply:()=>gd,multiplyScalar:()=>Ix,multiplyScalarAndAdd:()=>Px,ortho:()=>wx,orthoNO:()=>bd,orthoZO:()=>Sx,perspective:()=>_x,perspectiveFromFieldOfView:()=>bx,perspectiveNO:()=>Md,perspectiveZO:()=>Mx,rotate:()=>sx,rotateX:()=>rx,rotateY:()=>ox,rotateZ:()=>ax,scale:()=>ix,set:()=>J0,str:()=>Tx,sub:()=>Ox,subtract:()=>wd,targetTo:()=>Ex,translate:()=>nx,transpose:()=>j0});function $0(){var n=new se(16);return se!=Float32Array&&(n[1]=0,n[2]=0,n[3]=0,n[4]=0,n[6]=0,n[7]=0,n[8]=0,n[9]=0,n[11]=0,n[12]=0,n[13]=0,n[14]=0),n[0]=1,n[5]=1,n[10]=1,n[15]=1,n}function Y0(n){var t=new se(16);return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],t}function K0(n,t){return n[0]=t[0],n[1]=t[1],n[2]=t[2],n[3]=t[3],n[4]=t[4],n[5]=t[5],n[6]=t[6],n[7]=t[7],n[8]=t[8],n[9]=t[9],n[10]=t[10],n[11]=t[11],n[12]=t[12],n[13]=t[13],n[14]=t[14],n[15]=t[15],n}function Z0(n,t,e,i,s,r,o,a,l,c,h,u,d,f,p,x){var m=new se(16);return m[0]=n,m[1]=t,m[2]=e,m[3]=i,m[4]=s,m[5]=r,m[6]=o,m[7]=a,m[8]=l,m[9]=c,m[10]=h,m[11]=u,m[12]=d,m[13]=f,m[14]=p,m[15]=x,m}function J0(n,t,e,i,s,r,o,a,l,c,h,u,d,f,p,x,m){return n[0]=t,n[1]=e,n[2]=i,n[3]=s,n[4]=r,n[5]=o,n[6]=a,n[7]=l,n[8]=c,n[9]=h,n[10]=u,n[11]=d,n[12]=f,n[13]=p,n[14]=x,n[15]=m,n}function md(n){return n[0]=1,n[1]=0,n[2]=0,n[3]=0,n[4]=0,n[5]=1,n[6]=0,n[7]=0,n[8]=0,n[9]=0,n[10]=1,n[11]=0,n[12]=0,n[13]=0,n[14]=0,n[15]=1,n}function j0(n,t){if(n===t){var e=t[1],i=t[2],s=t[3],r=t[6],o=t[7],a=t[11];n[1]=t[4],n[2]=t[8],n[3]=t[12],n[4]=e,n[6]=t[9],n[7]=t[13],n[8]=i,n[9]=r,n[11]=t[14],n[12]=s,n[13]=o,n[14]=a}else n[0]=t[0],n[1]=t[4],n[2]=t[8],n[3]=t[12],n[4]=t[1],n[5]=t[5],n[6]=t[9],n[7]=t[13],n[8]=t[2],n[9]=t[6],n[10]=t[10],n[11]=t[14],n[12]=t[3],n[13]=t[7],n[14]=t[11],n[15]=t[15];return n}function Q0(n,t){var e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],x=t[13],m=t[14],g=t[15],_=e*a-i*o,w=e*l-s*o,y=e*c-r*o,E=i*l-s*a,S=i*c-r*a,v=s*c-r*l,A=h*x-u*p,L=h*m-d*p,T=h*g-f*p,I=u*m-d*x,D=u*g-f*x,F=d*g-f*m,R=_*F-w*D+y*I+E*T-S*L+v*A;return R?(R=1/R,n[0]=(a*F-l*D+c*I)*R,n[1]=(s*D-i*F-r*I)*R,n[2]=(x*v-m*S+g*E)*R,n[3]=(d*S-u*v-f*E)*R,n[4]=(l*T-o*F-c*L)*R,n[5]=(e*F-s*T+r*L)*R,n[6]=(m*y-p*v-g*w)*R,n[7]=(h*v-d*y+f*w)*R,n[8]=(o*D-a*T+c*A)*R,n[9]=(i*T-e*D-r*A)*R,n[10]=(p*S-x*y+g*_)*R,n[11]=(u*y-h*S-f*_)*R,n[12]=(a*L-o*I-l*A)*R,n[13]=(e*I-i*L+s*A)*R,n[14]=(x*w-p*E-m*_)*R,n[15]=(h*E-u*w+d*_)*R,n):null}function tx(n,t){var e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],x=t[13],m=t[14],g=t[15],_=e*a-i*o,w=e*l-s*o,y=e*c-r*o,E=i*l-s*a,S=i*c-r*a,v=s*c-r*l,A=h*x-u*p,L=h*m-d*p,T=h*g-f*p,I=u*m-d*x,D=u*g-f*x,F=d*g-f*m;return n[0]=a*F-l*D+c*I,n[1]=s*D-i*F-r*I,n[2]=x*v-m*S+g*E,n[3]=d*S-u*v-f*E,n[4]=l*T-o*F-c*L,n[5]=e*F-s*T+r*L,n[6]=m*y-p*v-g*w,n[7]=h*v-d*y+f*w,n[8]=o*D-a*T+c*A,n[9]=i*T-e*D-r*A,n[10]=p*S-x*y+g*_,n[11]=u*y-h*S-f*_,n[12]=a*L-o*I-l*A,n[13]=e*I-i*L+s*A,n[14]=x*w-p*E-m*_,n[15]=h*E-u*w+d*_,n}function ex(n){var t=n[0],e=n[1],i=n[2],s=n[3],r=n[4],o=n[5],a=n[6],l=n[7],c=n[8],h=n[9],u=n[10],d=n[11],f=n[12],p=n[13],x=n[14],m=n[15],g=t*o-e*r,_=t*a-i*r,w=e*a-i*o,y=c*p-h*f,E=c*x-u*f,S=h*x-u*p,v=t*S-e*E+i*y,A=r*S-o*E+a*y,L=c*w-h*_+u*g,T=f*w-p*_+x*g;return l*v-s*A+m*L-d*T}function gd(n,t,e){var i=t[0],s=t[1],r=t[2],o=t[3],a=t[4],l=t[5],c=t[6],h=t[7],u=t[8],d=t[9],f=t[10],p=t[11],x=t[12],m=t[13],g=t[14],_=t[15],w=e[0],y=e[1],E=e[2],S=e[3];return n[0]=w*i+y*a+E*u+S*x,n[1]=w*s+y*l+E*d+S*m,n[2]=w*r+y*c+E*f+S*g,n[3]=w*o+y*h+E*p+S*_,w=e[4],y=e[5],E=e[6],S=e[7],n[4]=w*i+y*a+E*u+S*x,n[5]=w*s+y*l+E*d+S*m,n[6]=w*r+y*c+E*f+S*g,n[7]=w*o+y*h+E*p+S*_,w=e[8],y=e[9],E=e[10],S=e[11],n[8]=w*i+y*a+E*u+S*x,n[9]=w*s+y*l+E*d+S*m,n[10]=w*r+y*c+E*f+S*g,n[11]=w*o+y*h+E*p+S*_,w=e[12],y=e[13],E=e[14],S=e[15],n[12]=w*i+y*a+E*u+S*x,n[13]=w*s+y*l+E*d+S*m,n[14]=w*r+y*c+E*f+S*g,n[15]=w*o+y*h+E*p+S*_,n}function nx(n,t,e){var i=e[0],s=e[1],r=e[2],o,a,l,c,h,u,d,f,p,x,m,g;return t===n?(n[12]=t[0]*i+t[4]*s+t[8]*r+t[12],n[13]=t[1]*i+t[5]*s+t[9]*r+t[13],n[14]=t[2]*i+t[6]*s+t[10]*r+t[14],n[15]=t[3]*i+t[7]*s+t[11]*r+t[15]):(o=t[0],a=t[1],l=t[2],c=t[3],h=t[4],u=t[5],d=t[6],f=t[7],p=t[8],x=t[9],m=t[10],g=t[11],n[0]=o,n[1]=a,n[2]=l,n[3]=c,n[4]=h,n[5]=u,n[6]=d,n[7]=f,n[8]=p,n[9]=x,n[10]=m,n[11]=g,n[12]=o*i+h*s+p*r+t[12],n[13]=a*i+u*s+x*r+t[13],n[14]=l*i+d*s+m*r+t[14],n[15]=c*i+f*s+g*r+t[15]),n}function ix(n,t,e){var i=e[0],s=e[1],r=e[2];return n[0]=t[0]*i,n[1]=t[1]*i,n[2]=t[2]*i,n[3]=t[3]*i,n[4]=t[4]*s,n[5]=t[5]*s,n[6]=t[6]*s,n[7]=t[7]*s,n[8]=t[8]*r,n[9]=t[9]*r,n[10]=t[10]*r,n[11]=t[11]*r,n[12]=t[12],n[13]=t[13],n[14]=t[14],n[15]=t[15],n}function sx(n,t,e,i){var s=i[0],r=i[1],o=i[2],a=Math.sqrt(s*s+r*r+o*o),l,c,h,u,d,f,p,x,m,g,_,w,y,E,S,v,A,L,T,I,D,F,R,k;return a<Ot?null:(a=1/a,s*=a,r*=a,o*=a,l=Math.sin(e),c=Math.cos(e),h=1-c,u=t[0],d=t[1],f=t[2],p=t[3],x=t[4],m=t[5],g=t[6],_=t[7],w=t[8],y=t[9],E=t[10],S=t[11],v=s*s*h+c,A=r*s*h+o*l,L=o*s*h-r*l,T=s*r*h-o*l,I=r*r*h+c,D=o*r*h+s*l,F=s*o*h+r*l,R=r*o*h-s*l,k=o*o*h+c,n[0]=u*v+x*A+w*L,n[1]=d*v+m*A+y*L,n[2]=f*v+g*A+E*L,n[3]=p*v+_*A+S*L,n[4]=u*T+x*I+w*D,n[5]=d*T+m*I+y*D,n[6]=f*T+g*I+E*D,n[7]=p*T+_*I+S*D,n[8]=u*F+x*R+w*k,n[9]=d*F+m*R+y*k,n[10]=f*F+g*R+E*k,n[11]=p*F+_*R+S*k,t!==n&&(n[12]=t[12],n[13]=t[13],n[14]=t[14],n[15]=t[15]),n)}function rx(n,t,e){var i=Math.sin(e),s=Math.cos(e),r=t[4],o=t[5],a=t[6],l=t[7],c=t[8],h=t[9],u=t[10],d=t[11];return t!==n&&(n[0]=t[0],n[1]=t[1],n[2]=t[2],n[3]=t[3],n[12]=t[12],n[13]=t[13],n[14]=t[14],n[15]=t[15]),n[4]=r*s+c*i,n[5]=o*s+h*i,n[6]=a*s+u*i,n[7]=l*s+d*i,n[8]=c*s-r*i,n[9]=h*s-o*i,n[10]=u*s-a*i,n[11]=d*s-l*i,n}function ox(n,t,e){var i=Math.sin(e),s=Math.cos(e),r=t[0],o=t[1],a=t[2],l=t[3],c=t[8],h=t[9],u=t[10],d=t[11];return t!==n&&(n[4]=t[4],n[5]=t[5],n[6]=t[6],n[7]=t[7],n[12]=t[12],n[13]=t[13],n[14]=t[14],n[15]=t[15]),n[0]=r*s-c*i,n[1]=o*s-h*i,n[2]=a*s-u*i,n[3]=l*s-d*i,n[8]=r*i+c*s,n[9]=o*i+h*s,n[10]=a*i+u*s,n[11]=l*i+d*s,n}function ax(n,t,e){var i=Math.sin(e),s=Math.cos(e),r=t[0],o=t[1],a=t[2],l=t[3],c=t[4],h=t[5],u=t[6],d=t[7];return t!==n&&(n[8]=t[8],n[9]=t[9],n[10]=t[10],n[11]=t[11],n[12]=t[12],n[13]=t[13],n[14]=t[14],n[15]=t[15]),n[0]=r*s+c*i,n[1]=o*s+h*i,n[2]=a*s+u*i,n[3]=l*s+d*i,n[4]=c*s-r*i,n[5]=h*s-o*i,n[6]=u*s-a*i,n[7]=d*s-l*i,n}function lx(n,t){return n[0]=1,n[1]=0,n[2]=0,n[3]=0,n[4]=0,n[5]=1,n[6]=0,n[7]=0,n[8]=0,n[9]=0,n[10]=1,n[11]=0,n[12]=t[0],n[13]=t[1],n[14]=t[2],n[15]=1,n}function cx(n,t){return n[0]=t[0],n[1]=0,n[2]=0,n[3]=0,n[4]=0,n[5]=t[1],n[6]=0,n[7]=0,n[8]=0,n[9]=0,n[10]=t[2],n[11]=0,n[12]=0,n[13]=0,n[14]=0,n[15]=1,n}function hx(n,t,e){var i=e[0],s=e[1],r=e[2],o=Math.sqrt(i*i+s*s+r*r),a,l,c;return o<Ot?null:(o=1/o,i*=o,s*=o,r*=o,a=Math.sin(t),l=Math.cos(t),c=1-l,n[0]=i*i*c+l,n[1]=s*i*c+r*a,n[2]=r*i*c-s*a,n[3]=0,n[4]=i*s*c-r*a,n[5]=s*s*c+l,n[6]=r*s*c+i*a,n[7]=0,n[8]=i*r*c+s*a,n[9]=s*r*c-i*a,n[10]=r*r*c+l,n[11]=0,n[12]=0,n[13]=0,n[14]=0,n[15]=1,n)}function ux(n,t){var e=Math.sin(t),i=Math.cos(t);return n[0]=1,n[1]=0,n[2]=0,n[3]=0,n[4]=0,n[5]=i,n[6]=e,n[7]=0,n[8]=0,n[9]=-e,n[10]=i,n[11]=0,n[12]=0,n[13]=0,n[14]=0,n[15]=1,n}function dx(n,t){var e=Math.sin(t),i=Math.cos(t);return n[0]=i,n[1]=0,n[2]=-e,n[3]=0,n[4]=0,n[5]=1,n[6]=0,n[7]=0,n[8]=e,n[9]=0,n[10]=i,n[11]=0,n[12]=0,n[13]=0,n[14]=0,n[15]=1,n}function fx(n,t){var e=Math.sin(t),i=Math.cos(t);return n[0]=i,n[1]=e,n[2]=0,n[3]=0,n[4]=-e,n[5]=i,n[6]=0,n[7]=0,n[8]=0,n[9]=0,n[10]=1,n[11]=0,n[12]=0,n[13]=0,n[14]=0,n[15]=1,n}function xd(n,t,e){var i=t[0],s=t[1],r=t[2],o=t[3],a=i+i,l=s+s,c=r+r,h=i*a,u=i*l,d=i*c,f=s*l,p=s*c,x=r*c,m=o*a,g=o*l,_=o*c;return n[0]=1-(f+x),n[1]=u+_,n[2]=d-g,n[3]=0,n[4]=u-_,n[5]=1-(h+x),n[6]=p+m,n[7]=0,n[8]=d+g,n[9]=p-m,n[10]=1-(h+f),n[11]=0,n[12]=e[0],n[13]=e[1],n[14]=e[2],n[15]=1,n}function px(n,t){var e=new se(3),i=-t[0],s=-t[1],r=-t[2],o=t[3],a=t[4],l=t[5],c=t[6],h=t[7],u=i*i+s*s+r*r+o*o;return u>0?(e[0]=(a*o+h*i+l*r-c*s)*2/u,e[1]=(l*o+h*s+c*i-a*r)*2/u,e[2]=(c*o+h*r+a*s-l*i)*2/u):(e[0]=(a*o+h*i+l*r-c*s)*2,e[1]=(l*o+h*s+c*i-a*r)*2,e[2]=(c*o+h*r+a*s-l*i)*2),xd(n,t,e),n}function vd(n,t){return n[0]=t[12],n[1]=t[13],n[2]=t[14],n}function yd(n,t){var e=t[0],i=t[1],s=t[2],r=t[4],o=t[5],a=t[6],l=t[8],c=t[9],h=t[10];return n[0]=Math.sqrt(e*e+i*i+s*s),n[1]=Math.sqrt(r*r+o*o+a*a),n[2]=Math.sqrt(l*l+c*c+h*h),n}function _d(n,t){var e=new se(3);yd(e,t);var i=1/e[0],s=1/e[1],r=1/e[2],o=t[0]*i,a=t[1]*s,l=t[2]*r,c=t[4]*i,h=t[5]*s,u=t[6]*r,d=t[8]*i,f=t[9]*s,p=t[10]*r,x=o+h+p,m=0;return x>0?(m=Math.sqrt(x+1)*2,n[3]=.25*m,n[0]=(u-f)/m,n[1]=(d-l)/m,n[2]=(a-c)/m):o>h&&o>p?(m=Math.sqrt(1+o-h-p)*2,n[3]=(u-f)/m,n[0]=.25*m,n[1]=(a+c)/m,n[2]=(d+l)/m):h>p?(m=Math.sqrt(1+h-o-p)*2,n[3]=(d-l)/m,n[0]=(a+c)/m,n[1]=.25*m,n[2]=(u+f)/m):(m=Math.sqrt(1+p-o-h)*2,n[3]=(a-c)/m,n[0]=(d+l)/m,n[1]=(u+f)/m,n[2]=.25*m),n}function mx(n,t,e,i){t[0]=i[12],t[1]=i[13],t[2]=i[14];var s=i[0],r=i[1],o=i[2],a=i[4],l=i[5],c=i[6],h=i[8],u=i[9],d=i[10];e[0]=Math.sqrt(s*s+r*r+o*o),e[1]=Math.sqrt(a*a+l*l+c*c),e[2]=Math.sqrt(h*h+u*u+d*d);var f=1/e[0],p=1/e[1],x=1/e[2],m=s*f,g=r*p,_=o*x,w=a*f,y=l*p,E=c*x,S=h*f,v=u*p,A=d*x,L=m+y+A,T=0;return L>0?(T=Math.sqrt(L+1)*2,n[3]=.25*T,n[0]=(E-v)/T,n[1]=(S-_)/T,n[2]=(g-w)/T):m>y&&m>A?(T=Math.sqrt(1+m-y-A)*2,n[3]=(E-v)/T,n[0]=.25*T,n[1]=(g+w)/T,n[2]=(S+_)/T):y>A?(T=Math.sqrt(1+y-m-A)*2,n[3]=(S-_)/T,n[0]=(g+w)/T,n[1]=.25*T,n[2]=(E+v)/T):(T=Math.sqrt(1+A-m-y)*2,n[3]=(g-w)/T,n[0]=(S+_)/T,n[1]=(E+v)/T,n[2]=.25*T),n}function gx(n,t,e,i){var s=t[0],r=t[1],o=t[2],a=t[3],l=s+s,c=r+r,h=o+o,u=s*l,d=s*c,f=s*h,p=r*c,x=r*h,m=o*h,g=a*l,_=a*c,w=a*h,y=i[0],E=i[1],S=i[2];return n[0]=(1-(p+m))*y,n[1]=(d+w)*y,n[2]=(f-_)*y,n[3]=0,n[4]=(d-w)*E,n[5]=(1-(u+m))*E,n[6]=(x+g)*E,n[7]=0,n[8]=(f+_)*S,n[9]=(x-g)*S,n[10]=(1-(u+p))*S,n[11]=0,n[12]=e[0],n[13]=e[1],n[14]=e[2],n[15]=1,n}function xx(n,t,e,i,s){var r=t[0],o=t[1],a=t[2],l=t[3],c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,x=o*h,m=o*u,g=a*u,_=l*c,w=l*h,y=l*u,E=i[0],S=i[1],v=i[2],A=s[0],L=s[1],T=s[2],I=(1-(x+g))*E,D=(f+y)*E,F=(p-w)*E,R=(f-y)*S,k=(1-(d+g))*S,W=(m+_)*S,z=(p+w)*v,tt=(m-_)*v,q=(1-(d+x))*v;return n[0]=I,n[1]=D,n[2]=F,n[3]=0,n[4]=R,n[5]=k,n[6]=W,n[7]=0,n[8]=z,n[9]=tt,n[10]=q,n[11]=0,n[12]=e[0]+A-(I*A+R*L+z*T),n[13]=e[1]+L-(D*A+k*L+tt*T),n[14]=e[2]+T-(F*A+W*L+q*T),n[15]=1,n}function vx(n,t){var e=t[0],i=t[1],s=t[2],r=t[3],o=e+e,a=i+i,l=s+s,c=e*o,h=i*o,u=i*a,d=s*o,f=s*a,p=s*l,x=r*o,m=r*a,g=r*l;return n[0]=1-u-p,n[1]=h+g,n[2]=d-m,n[3]=0,n[4]=h-g,n[5]=1-c-p,n[6]=f+x,n[7]=0,n[8]=d+m,n[9]=f-x,n[10]=1-c-u,n[11]=0,n[12]=0,n[13]=0,n[14]=0,n[15]=1,n}function yx(n,t,e,i,s,r,o){var a=1/(e-t),l=1/(s-i),c=1/(r-o);return n[0]=r*2*a,n[1]=0,n[2]=0,n[3]=0,n[4]=0,n[5]=r*2*l,n[6]=0,n[7]=0,n[8]=(e+t)*a,n[9]=(s+i)*l,n[10]=(o+r)*c,n[11]=-1,n[12]=0,n[13]=0,n[14]=o*r*2*c,n[15]=0,n}function Md(n,t,e,i,s){var r=1/Math.tan(t/2);if(n[0]=r/e,n[1]=0,n[2]=0,n[3]=0,n[4]=0,n[5]=r,n[6]=0,n[7]=0,n[8]=0,n[9]=0,n[11]=-1,n[12]=0,n[13]=0,n[15]=0,s!=null&&s!==1/0){var o=1/(i-s);n[10]=(s+i)*o,n[14]=2*s*i*o}else n[10]=-1,n[14]=-2*i;return n}var _x=Md;function Mx(n,t,e,i,s){var r=1/Math.tan(t/2);if(n[0]=r/e,n[1]=0,n[2]=0,n[3]=0,n[4]=0,n[5]=r,n[6]=0,n[7]=0,n[8]=0,n[9]=0,n[11]=-1,n[12]=0,n[13]=0,n[15]=0,s!=null&&s!==1/0){var o=1/(i-s);n[10]=s*o,n[14]=s*i*o}else n[10]=-1,n[14]=-i;return n}function bx(n,t,e,i){var s=Math.tan(t.upDegrees*Math.PI/180),r=Math.tan(t.downDegrees*Math.PI/180),o=Math.tan(t.leftDegrees*Math.PI/180),a=Math.tan(t.rightDegrees*Math.PI/180),l=2/(o+a),c=2/(s+r);return n[0]=l,n[1]=0,n[2]=0,n[3]=0,n[4]=0,n[5]=c,n[6]=0,n[7]=0,n[8]=-((o-a)*l*.5),n[9]=(s-r)*c*.5,n[10]=i/(e-i),n[11]=-1,n[12]=0,n[13]=0,n[14]=i*e/(e-i),n[15]=0,n}function bd(n,t,e,i,s,r,o){var a=1/(t-e),l=1/(i-s),c=1/(r-o);return n[0]=-2*a,n[1]=0,n[2]=0,n[3]=0,n[4]=0,n[5]=-2*l,n[6]=0,n[7]=0,n[8]=0,n[9]=0,n[10]=2*c,n[11]=0,n[12]=(t+e)*a,n[13]=(s+i)*l,n[14]=(o+r)*c,n[15]=1,n}var wx=bd;function Sx(n,t,e,i,s,r,o){var a=1/(t-e),l=1/(i-s),c=1/(r-o);return n[0]=-2*a,n[1]=0,n[2]=0,n[3]=0,n[4]=0,n[5]=-2*l,n[6]=0,n[7]=0,n[8]=0,n[9]=0,n[10]=c,n[11]=0,n[12]=(t+e)*a,n[13]=(s+i)*l,n[14]=r*c,n[15]=1,n}function Ax(n,t,e,i){var s,r,o,a,l,c,h,u,d,f,p=t[0],x=t[1],m=t[2],g=i[0],_=i[1],w=i[2],y=e[0],E=e[1],S=e[2];return Math.abs(p-y)<Ot&&Math.abs(x-E)<Ot&&Math.abs(m-S)<Ot?md(n):(h=p-y,u=x-E,d=m-S,f=1/Math.sqrt(h*h+u*u+d*d),h*=f,u*=f,d*=f,s=_*d-w*u,r=w*h-g*d,o=g*u-_*h,f=Math.sqrt(s*s+r*r+o*o),f?(f=1/f,s*=f,r*=f,o*=f):(s=0,r=0,o=0),a=u*o-d*r,l=d*s-h*o,c=h*r-u*s,f=Math.sqrt(a*a+l*l+c*c),f?(f=1/f,a*=f,l*=f,c*=f):(a=0,l=0,c=0),n[0]=s,n[1]=a,n[2]=h,n[3]=0,n[4]=r,n[5]=l,n[6]=u,n[7]=0,n[8]=o,n[9]=c,n[10]=d,n[11]=0,n[12]=-(s*p+r*x+o*m),n[13]=-(a*p+l*x+c*m),n[14]=-(h*p+u*x+d*m),n[15]=1,n)}function Ex(n,t,e,i){var s=t[0],r=t[1],o=t[2],a=i[0],l=i[1],c=i[2],h=s-e[0],u=r-e[1],d=o-e[2],f=h*h+u*u+d*d;f>0&&(f=1/Math.sqrt(f),h*=f,u*=f,d*=f);var p=l*d-c*u,x=c*h-a*d,m=a*u-l*h;return f=p*p+x*x+m*m,f>0&&(f=1/Math.sqrt(f),p*=f,x*=f,m*=f),n[0]=p,n[1]=x,n[2]=m,n[3]=0,n[4]=u*m-d*x,n[5]=d*p-h*m,n[6]=h*x-u*p,n[7]=0,n[8]=h,n[9]=u,n[10]=d,n[11]=0,n[12]=s,n[13]=r,n[14]=o,n[15]=1,n}function Tx(n){return"mat4("+n[0]+", "+n[1]+", "+n[2]+", "+n[3]+", "+n[4]+", "+n[5]+", "+n[6]+", "+n[7]+", "+n[8]+", "+n[9]+", "+n[10]+", "+n[11]+", "+n[12]+", "+n[13]+", "+n[14]+", "+n[15]+")"}function Cx(n){return Math.sqrt(n[0]*n[0]+n[1]*n[1]+n[2]*n[2]+n[3]*n[3]+n[4]*n[4]+n[5]*n[5]+n[6]*n[6]+n[7]*n[7]+n[8]*n[8]+n[9]*n[9]+n[10]*n[10]+n[11]*n[11]+n[12]*n[12]+n[13]*n[13]+n[14]*n[14]+n[15]*n[15])}function Rx(n,t,e){return n[0]=t[0]+e[0],n[1]=t[1]+e[1],n[2]=t[2]+e[2],n[3]=t[3]+e[3],n[4]=t[4]+e[4],n[5]=t[5]+e[5],n[6]=t[6]+e[6],n[7]=t[7]+e[7],n[8]=t[8]+e[8],n[9]=t[9]+e[9],n[10]=t[10]+e[10],n[11]=t[11]+e[11],n[12]=t[12]+e[12],n[13]=t[13]+e[13],n[14]=t[14]+e[14],n[15]=t[15]+e[15],n}function wd(n,t,e){return n[0]=t[0]-e[0],n[1]=t[1]-e[1],n[2]=t[2]-e[2],n[3]=t[3]-e[3],n[4]=t[4]-e[4],n[5]=t[5]-e[5],n[6]=t[6]-e[6],n[7]=t[7]-e[7],n[8]=t[8]-e[8],n[9]=t[9]-e[9],n[10]=t[10]-e[10],n[11]=t[11]-e[11],n[12]=t[12]-e[12],n[13]=t[13]-e[13],n[14]=t[14]-e[14],n[15]=t[15]-e[15],n}function Ix(n,t,e){return n[0]=t[0]*e,n[1]=t[1]*e,n[2]=t[2]*e,n[3]=t[3]*e,n[4]=t[4]*e,n[5]=t[5]*e,n[6]=t[6]*e,n[7]=t[7]*e,n[8]=t[8]*e,n[9]=t[9]*e,n[10]=t[10]*e,n[11]=t[11]*e,n[12]=t[12]*e,n[13]=t[13]*e,n[14]=t[14]*e,n[15]=t[15]*e,n}function Px(n,t,e,i){return n[0]=t[0]+e[0]*i,n[1]=t[1]+e[1]*i,n[2]=t[2]+e[2]*i,n[3]=t[3]+e[3]*i,n[4]=t[4]+e[4]*i,n[5]=t[5]+e[5]*i,n[6]=t[6]+e[6]*i,n[7]=t[7]+e[7]*i,n[8]=t[8]+e[8]*i,n[9]=t[9]+e[9]*i,n[10]=t[10]+e[10]*i,n[11]=t[11]+e[11]*i,n[12]=t[12]+e[12]*i,n[13]=t[13]+e[13]*i,n[14]=t[14]+e[14]*i,n[15]=t[15]+e[15]*i,n}function Lx(n,t){return n[0]===t[0]&&n[1]===t[1]&&n[2]===t[2]&&n[3]===t[3]&&n[4]===t[4]&&n[5]===t[5]&&n[6]===t[6]&&n[7]===t[7]&&n[8]===t[8]&&n[9]===t[9]&&n[10]===t[10]&&n[11]===t[11]&&n[12]===t[12]&&n[13]===t[13]&&n[14]===t[14]&&n[15]===t[15]}function Nx(n,t){var e=n[0],i=n[1],s=n[2],r=n[3],o=n[4],a=n[5],l=n[6],c=n[7],h=n[8],u=n[9],d=n[10],f=n[11],p=n[12],x=n[13],m=n[14],g=n[15],_=t[0],w=t[1],y=t[2],E=t[3],S=t[4],v=t[5],A=t[6],L=t[7],T=t[8],I=t[9],D=t[10],F=t[11],R=t[12],k=t[13],W=t[14],z=t[15];return Math.abs(e-_)<=Ot*Math.max(1,Math.abs(e),Math.abs(_))&&Math.abs(i-w)<=Ot*Math.max(1,Math.abs(i),Math.abs(w))&&Math.abs(s-y)<=Ot*Math.max(1,Math.abs(s),Math.abs(y))&&Math.abs(r-E)<=Ot*Math.max(1,Math.abs(r),Math.abs(E))&&Math.abs(o-S)<=Ot*Math.max(1,Math.abs(o),Math.abs(S))&&Math.abs(a-v)<=Ot*Math.max(1,Math.abs(a),Math.abs(v))&&Math.abs(l-A)<=Ot*Math.max(1,Math.abs(l),Math.abs(A))&&Math.abs(c-L)<=Ot*Math.max(1,Math.abs(c),Math.abs(L))&&Math.abs(h-T)<=Ot*Math.max(1,Math.abs(h),Math.abs(T))&&Math.abs(u-I)<=Ot*Math.max(1,Math.abs(u),Math.abs(I))&&Math.abs(d-D)<=Ot*Math.max(1,Math.abs(d),Math.abs(D))&&Math.abs(f-F)<=Ot*Math.max(1,Math.abs(f),Math.abs(F))&&Math.abs(p-R)<=Ot*Math.max(1,Math.abs(p),Math.abs(R))&&Math.abs(x-k)<=Ot*Math.max(1,Math.abs(x),Math.abs(k))&&Math.abs(m-W)<=Ot*Math.max(1,Math.abs(m),Math.abs(W))&&Math.abs(g-z)<=Ot*Math.max(1,Math.abs(g),Math.abs(z))}var Dx=gd,Ox=wd,pn={};ms(pn,{add:()=>Hv,calculateW:()=>Nv,clone:()=>zv,conjugate:()=>Uv,copy:()=>Ic,create:()=>go,dot:()=>Pc,equals:()=>Kv,exactEquals:()=>Yv,exp:()=>Bd,fromEuler:()=>kv,fromMat3:()=>Gd,fromValues:()=>Gv,getAngle:()=>Lv,getAxisAngle:()=>Pv,identity:()=>Iv,invert:()=>Fv,len:()=>qv,length:()=>Lc,lerp:()=>Xv,ln:()=>zd,mul:()=>Wv,multiply:()=>Od,normalize:()=>Dc,pow:()=>Dv,random:()=>Ov,rotateX:()=>Fd,rotateY:()=>Ud,rotateZ:()=>kd,rotationTo:()=>Zv,scale:()=>Vd,set:()=>Vv,setAxes:()=>jv,setAxisAngle:()=>Dd,slerp:()=>mo,sqlerp:()=>Jv,sqrLen:()=>$v,squaredLength:()=>Nc,str:()=>Bv});var ei={};ms(ei,{add:()=>Bx,angle:()=>ov,bezier:()=>jx,ceil:()=>zx,clone:()=>Fx,copy:()=>Ux,create:()=>Rc,cross:()=>po,dist:()=>pv,distance:()=>Cd,div:()=>fv,divide:()=>Td,dot:()=>xo,equals:()=>hv,exactEquals:()=>cv,floor:()=>Gx,forEach:()=>xv,fromValues:()=>Tc,hermite:()=>Jx,inverse:()=>Yx,len:()=>Ld,length:()=>Sd,lerp:()=>Kx,max:()=>Hx,min:()=>Vx,mul:()=>dv,multiply:()=>Ed,negate:()=>$x,normalize:()=>Pd,random:()=>Qx,rotateX:()=>iv,rotateY:()=>sv,rotateZ:()=>rv,round:()=>Wx,scale:()=>Xx,scaleAndAdd:()=>qx,set:()=>kx,slerp:()=>Zx,sqrDist:()=>mv,sqrLen:()=>gv,squaredDistance:()=>Rd,squaredLength:()=>Id,str:()=>lv,sub:()=>uv,subtract:()=>Ad,transformMat3:()=>ev,transformMat4:()=>tv,transformQuat:()=>nv,zero:()=>av});function Rc(){var n=new se(3);return se!=Float32Array&&(n[0]=0,n[1]=0,n[2]=0),n}function Fx(n){var t=new se(3);return t[0]=n[0],t[1]=n[1],t[2]=n[2],t}function Sd(n){var t=n[0],e=n[1],i=n[2];return Math.sqrt(t*t+e*e+i*i)}function Tc(n,t,e){var i=new se(3);return i[0]=n,i[1]=t,i[2]=e,i}function Ux(n,t){return n[0]=t[0],n[1]=t[1],n[2]=t[2],n}function kx(n,t,e,i){return n[0]=t,n[1]=e,n[2]=i,n}function Bx(n,t,e){return n[0]=t[0]+e[0],n[1]=t[1]+e[1],n[2]=t[2]+e[2],n}function Ad(n,t,e){return n[0]=t[0]-e[0],n[1]=t[1]-e[1],n[2]=t[2]-e[2],n}function Ed(n,t,e){return n[0]=t[0]*e[0],n[1]=t[1]*e[1],n[2]=t[2]*e[2],n}function Td(n,t,e){return n[0]=t[0]/e[0],n[1]=t[1]/e[1],n[2]=t[2]/e[2],n}function zx(n,t){return n[0]=Math.ceil(t[0]),n[1]=Math.ceil(t[1]),n[2]=Math.ceil(t[2]),n}function Gx(n,t){return n[0]=Math.floor(t[0]),n[1]=Math.floor(t[1]),n[2]=Math.floor(t[2]),n}function Vx(n,t,e){return n[0]=Math.min(t[0],e[0]),n[1]=Math.min(t[1],e[1]),n[2]=Math.min(t[2],e[2]),n}function Hx(n,t,e){return n[0]=Math.max(t[0],e[0]),n[1]=Math.max(t[1],e[1]),n[2]=Math.max(t[2],e[2]),n}function Wx(n,t){return n[0]=fo(t[0]),n[1]=fo(t[1]),n[2]=fo(t[2]),n}function Xx(n,t,e){return n[0]=t[0]*e,n[1]=t[1]*e,n[2]=t[2]*e,n}function qx(n,t,e,i){return n[0]=t[0]+e[0]*i,n[1]=t[1]+e[1]*i,n[2]=t[2]+e[2]*i,n}function Cd(n,t){var e=t[0]-n[0],i=t[1]-n[1],s=t[2]-n[2];return Math.sqrt(e*e+i*i+s*s)}function Rd(n,t){var e=t[0]-n[0],i=t[1]-n[1],s=t[2]-n[2];return e*e+i*i+s*s}function Id(n){var t=n[0],e=n[1],i=n[2];return t*t+e*e+i*i}function $x(n,t){return n[0]=-t[0],n[1]=-t[1],n[2]=-t[2],n}function Yx(n,t){return n[0]=1/t[0],n[1]=1/t[1],n[2]=1/t[2],n}function Pd(n,t){var e=t[0],i=t[1],s=t[2],r=e*e+i*i+s*s;return r>0&&(r=1/Math.sqrt(r)),n[0]=t[0]*r,n[1]=t[1]*r,n[2]=t[2]*r,n}function xo(n,t){return n[0]*t[0]+n[1]*t[1]+n[2]*t[2]}function po(n,t,e){var i=t[0],s=t[1],r=t[2],o=e[0],a=e[1],l=e[2];return n[0]=s*l-r*a,n[1]=r*o-i*l,n[2]=i*a-s*o,n}function Kx(n,t,e,i){var s=t[0],r=t[1],o=t[2];return n[0]=s+i*(e[0]-s),n[1]=r+i*(e[1]-r),n[2]=o+i*(e[2]-o),n}function Zx(n,t,e,i){var s=Math.acos(Math.min(Math.max(xo(t,e),-1),1)),r=Math.sin(s),o=Math.sin((1-i)*s)/r,a=Math.sin(i*s)/r;return n[0]=o*t[0]+a*e[0],n[1]=o*t[1]+a*e[1],n[2]=o*t[2]+a*e[2],n}function Jx(n,t,e,i,s,r){var o=r*r,a=o*(2*r-3)+1,l=o*(r-2)+r,c=o*(r-1),h=o*(3-2*r);return n[0]=t[0]*a+e[0]*l+i[0]*c+s[0]*h,n[1]=t[1]*a+e[1]*l+i[1]*c+s[1]*h,n[2]=t[2]*a+e[2]*l+i[2]*c+s[2]*h,n}function jx(n,t,e,i,s,r){var o=1-r,a=o*o,l=r*r,c=a*o,h=3*r*a,u=3*l*o,d=l*r;return n[0]=t[0]*c+e[0]*h+i[0]*u+s[0]*d,n[1]=t[1]*c+e[1]*h+i[1]*u+s[1]*d,n[2]=t[2]*c+e[2]*h+i[2]*u+s[2]*d,n}function Qx(n,t){t=t===void 0?1:t;var e=ps()*2*Math.PI,i=ps()*2-1,s=Math.sqrt(1-i*i)*t;return n[0]=Math.cos(e)*s,n[1]=Math.sin(e)*s,n[2]=i*t,n}function tv(n,t,e){var i=t[0],s=t[1],r=t[2],o=e[3]*i+e[7]*s+e[11]*r+e[15];return o=o||1,n[0]=(e[0]*i+e[4]*s+e[8]*r+e[12])/o,n[1]=(e[1]*i+e[5]*s+e[9]*r+e[13])/o,n[2]=(e[2]*i+e[6]*s+e[10]*r+e[14])/o,n}function ev(n,t,e){var i=t[0],s=t[1],r=t[2];return n[0]=i*e[0]+s*e[3]+r*e[6],n[1]=i*e[1]+s*e[4]+r*e[7],n[2]=i*e[2]+s*e[5]+r*e[8],n}function nv(n,t,e){var i=e[0],s=e[1],r=e[2],o=e[3],a=t[0],l=t[1],c=t[2],h=s*c-r*l,u=r*a-i*c,d=i*l-s*a;return h=h+h,u=u+u,d=d+d,n[0]=a+o*h+s*d-r*u,n[1]=l+o*u+r*h-i*d,n[2]=c+o*d+i*u-s*h,n}function iv(n,t,e,i){var s=[],r=[];return s[0]=t[0]-e[0],s[1]=t[1]-e[1],s[2]=t[2]-e[2],r[0]=s[0],r[1]=s[1]*Math.cos(i)-s[2]*Math.sin(i),r[2]=s[1]*Math.sin(i)+s[2]*Math.cos(i),n[0]=r[0]+e[0],n[1]=r[1]+e[1],n[2]=r[2]+e[2],n}function sv(n,t,e,i){var s=[],r=[];return s[0]=t[0]-e[0],s[1]=t[1]-e[1],s[2]=t[2]-e[2],r[0]=s[2]*Math.sin(i)+s[0]*Math.cos(i),r[1]=s[1],r[2]=s[2]*Math.cos(i)-s[0]*Math.sin(i),n[0]=r[0]+e[0],n[1]=r[1]+e[1],n[2]=r[2]+e[2],n}function rv(n,t,e,i){var s=[],r=[];return s[0]=t[0]-e[0],s[1]=t[1]-e[1],s[2]=t[2]-e[2],r[0]=s[0]*Math.cos(i)-s[1]*Math.sin(i),r[1]=s[0]*Math.sin(i)+s[1]*Math.cos(i),r[2]=s[2],n[0]=r[0]+e[0],n[1]=r[1]+e[1],n[2]=r[2]+e[2],n}function ov(n,t){var e=n[0],i=n[1],s=n[2],r=t[0],o=t[1],a=t[2],l=Math.sqrt((e*e+i*i+s*s)*(r*r+o*o+a*a)),c=l&&xo(n,t)/l;return Math.acos(Math.min(Math.max(c,-1),1))}function av(n){return n[0]=0,n[1]=0,n[2]=0,n}function lv(n){return"vec3("+n[0]+", "+n[1]+", "+n[2]+")"}function cv(n,t){return n[0]===t[0]&&n[1]===t[1]&&n[2]===t[2]}function hv(n,t){var e=n[0],i=n[1],s=n[2],r=t[0],o=t[1],a=t[2];return Math.abs(e-r)<=Ot*Math.max(1,Math.abs(e),Math.abs(r))&&Math.abs(i-o)<=Ot*Math.max(1,Math.abs(i),Math.abs(o))&&Math.abs(s-a)<=Ot*Math.max(1,Math.abs(s),Math.abs(a))}var uv=Ad,dv=Ed,fv=Td,pv=Cd,mv=Rd,Ld=Sd,gv=Id,xv=(function(){var n=Rc();return function(t,e,i,s,r,o){var a,l;for(e||(e=3),i||(i=0),s?l=Math.min(s*e+i,t.length):l=t.length,a=i;a<l;a+=e)n[0]=t[a],n[1]=t[a+1],n[2]=t[a+2],r(n,n,o),t[a]=n[0],t[a+1]=n[1],t[a+2]=n[2];return t}})();function vv(){var n=new se(4);return se!=Float32Array&&(n[0]=0,n[1]=0,n[2]=0,n[3]=0),n}function yv(n){var t=new se(4);return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t}function _v(n,t,e,i){var s=new se(4);return s[0]=n,s[1]=t,s[2]=e,s[3]=i,s}function Mv(n,t){return n[0]=t[0],n[1]=t[1],n[2]=t[2],n[3]=t[3],n}function bv(n,t,e,i,s){return n[0]=t,n[1]=e,n[2]=i,n[3]=s,n}function wv(n,t,e){return n[0]=t[0]+e[0],n[1]=t[1]+e[1],n[2]=t[2]+e[2],n[3]=t[3]+e[3],n}function Sv(n,t,e){return n[0]=t[0]*e,n[1]=t[1]*e,n[2]=t[2]*e,n[3]=t[3]*e,n}function Av(n){var t=n[0],e=n[1],i=n[2],s=n[3];return Math.sqrt(t*t+e*e+i*i+s*s)}function Ev(n){var t=n[0],e=n[1],i=n[2],s=n[3];return t*t+e*e+i*i+s*s}function Tv(n,t){var e=t[0],i=t[1],s=t[2],r=t[3],o=e*e+i*i+s*s+r*r;return o>0&&(o=1/Math.sqrt(o)),n[0]=e*o,n[1]=i*o,n[2]=s*o,n[3]=r*o,n}function Nd(n,t){return n[0]*t[0]+n[1]*t[1]+n[2]*t[2]+n[3]*t[3]}function Cv(n,t,e,i){var s=t[0],r=t[1],o=t[2],a=t[3];return n[0]=s+i*(e[0]-s),n[1]=r+i*(e[1]-r),n[2]=o+i*(e[2]-o),n[3]=a+i*(e[3]-a),n}function Rv(n,t){return n[0]===t[0]&&n[1]===t[1]&&n[2]===t[2]&&n[3]===t[3]}var GT=(function(){var n=vv();return function(t,e,i,s,r,o){var a,l;for(e||(e=4),i||(i=0),s?l=Math.min(s*e+i,t.length):l=t.length,a=i;a<l;a+=e)n[0]=t[a],n[1]=t[a+1],n[2]=t[a+2],n[3]=t[a+3],r(n,n,o),t[a]=n[0],t[a+1]=n[1],t[a+2]=n[2],t[a+3]=n[3];return t}})();function go(){var n=new se(4);return se!=Float32Array&&(n[0]=0,n[1]=0,n[2]=0),n[3]=1,n}function Iv(n){return n[0]=0,n[1]=0,n[2]=0,n[3]=1,n}function Dd(n,t,e){e=e*.5;var i=Math.sin(e);return n[0]=i*t[0],n[1]=i*t[1],n[2]=i*t[2],n[3]=Math.cos(e),n}function Pv(n,t){var e=Math.acos(t[3])*2,i=Math.sin(e/2);return i>Ot?(n[0]=t[0]/i,n[1]=t[1]/i,n[2]=t[2]/i):(n[0]=1,n[1]=0,n[2]=0),e}function Lv(n,t){var e=Pc(n,t);return Math.acos(2*e*e-1)}function Od(n,t,e){var i=t[0],s=t[1],r=t[2],o=t[3],a=e[0],l=e[1],c=e[2],h=e[3];return n[0]=i*h+o*a+s*c-r*l,n[1]=s*h+o*l+r*a-i*c,n[2]=r*h+o*c+i*l-s*a,n[3]=o*h-i*a-s*l-r*c,n}function Fd(n,t,e){e*=.5;var i=t[0],s=t[1],r=t[2],o=t[3],a=Math.sin(e),l=Math.cos(e);return n[0]=i*l+o*a,n[1]=s*l+r*a,n[2]=r*l-s*a,n[3]=o*l-i*a,n}function Ud(n,t,e){e*=.5;var i=t[0],s=t[1],r=t[2],o=t[3],a=Math.sin(e),l=Math.cos(e);return n[0]=i*l-r*a,n[1]=s*l+o*a,n[2]=r*l+i*a,n[3]=o*l-s*a,n}function kd(n,t,e){e*=.5;var i=t[0],s=t[1],r=t[2],o=t[3],a=Math.sin(e),l=Math.cos(e);return n[0]=i*l+s*a,n[1]=s*l-i*a,n[2]=r*l+o*a,n[3]=o*l-r*a,n}function Nv(n,t){var e=t[0],i=t[1],s=t[2];return n[0]=e,n[1]=i,n[2]=s,n[3]=Math.sqrt(Math.abs(1-e*e-i*i-s*s)),n}function Bd(n,t){var e=t[0],i=t[1],s=t[2],r=t[3],o=Math.sqrt(e*e+i*i+s*s),a=Math.exp(r),l=o>0?a*Math.sin(o)/o:0;return n[0]=e*l,n[1]=i*l,n[2]=s*l,n[3]=a*Math.cos(o),n}function zd(n,t){var e=t[0],i=t[1],s=t[2],r=t[3],o=Math.sqrt(e*e+i*i+s*s),a=o>0?Math.atan2(o,r)/o:0;return n[0]=e*a,n[1]=i*a,n[2]=s*a,n[3]=.5*Math.log(e*e+i*i+s*s+r*r),n}function Dv(n,t,e){return zd(n,t),Vd(n,n,e),Bd(n,n),n}function mo(n,t,e,i){var s=t[0],r=t[1],o=t[2],a=t[3],l=e[0],c=e[1],h=e[2],u=e[3],d,f,p,x,m;return f=s*l+r*c+o*h+a*u,f<0&&(f=-f,l=-l,c=-c,h=-h,u=-u),1-f>Ot?(d=Math.acos(f),p=Math.sin(d),x=Math.sin((1-i)*d)/p,m=Math.sin(i*d)/p):(x=1-i,m=i),n[0]=x*s+m*l,n[1]=x*r+m*c,n[2]=x*o+m*h,n[3]=x*a+m*u,n}function Ov(n){var t=ps(),e=ps(),i=ps(),s=Math.sqrt(1-t),r=Math.sqrt(t);return n[0]=s*Math.sin(2*Math.PI*e),n[1]=s*Math.cos(2*Math.PI*e),n[2]=r*Math.sin(2*Math.PI*i),n[3]=r*Math.cos(2*Math.PI*i),n}function Fv(n,t){var e=t[0],i=t[1],s=t[2],r=t[3],o=e*e+i*i+s*s+r*r,a=o?1/o:0;return n[0]=-e*a,n[1]=-i*a,n[2]=-s*a,n[3]=r*a,n}function Uv(n,t){return n[0]=-t[0],n[1]=-t[1],n[2]=-t[2],n[3]=t[3],n}function Gd(n,t){var e=t[0]+t[4]+t[8],i;if(e>0)i=Math.sqrt(e+1),n[3]=.5*i,i=.5/i,n[0]=(t[5]-t[7])*i,n[1]=(t[6]-t[2])*i,n[2]=(t[1]-t[3])*i;else{var s=0;t[4]>t[0]&&(s=1),t[8]>t[s*3+s]&&(s=2);var r=(s+1)%3,o=(s+2)%3;i=Math.sqrt(t[s*3+s]-t[r*3+r]-t[o*3+o]+1),n[s]=.5*i,i=.5/i,n[3]=(t[r*3+o]-t[o*3+r])*i,n[r]=(t[r*3+s]+t[s*3+r])*i,n[o]=(t[o*3+s]+t[s*3+o])*i}return n}function kv(n,t,e,i){var s=arguments.length>4&&arguments[4]!==void 0?arguments[4]:ud,r=Math.PI/360;t*=r,i*=r,e*=r;var o=Math.sin(t),a=Math.cos(t),l=Math.sin(e),c=Math.cos(e),h=Math.sin(i),u=Math.cos(i);switch(s){case"xyz":n[0]=o*c*u+a*l*h,n[1]=a*l*u-o*c*h,n[2]=a*c*h+o*l*u,n[3]=a*c*u-o*l*h;break;case"xzy":n[0]=o*c*u-a*l*h,n[1]=a*l*u-o*c*h,n[2]=a*c*h+o*l*u,n[3]=a*c*u+o*l*h;break;case"yxz":n[0]=o*c*u+a*l*h,n[1]=a*l*u-o*c*h,n[2]=a*c*h-o*l*u,n[3]=a*c*u+o*l*h;break;case"yzx":n[0]=o*c*u+a*l*h,n[1]=a*l*u+o*c*h,n[2]=a*c*h-o*l*u,n[3]=a*c*u-o*l*h;break;case"zxy":n[0]=o*c*u-a*l*h,n[1]=a*l*u+o*c*h,n[2]=a*c*h+o*l*u,n[3]=a*c*u-o*l*h;break;case"zyx":n[0]=o*c*u-a*l*h,n[1]=a*l*u+o*c*h,n[2]=a*c*h-o*l*u,n[3]=a*c*u+o*l*h;break;default:throw new Error("Unknown angle order "+s)}return n}function Bv(n){return"quat("+n[0]+", "+n[1]+", "+n[2]+", "+n[3]+")"}var zv=yv,Gv=_v,Ic=Mv,Vv=bv,Hv=wv,Wv=Od,Vd=Sv,Pc=Nd,Xv=Cv,Lc=Av,qv=Lc,Nc=Ev,$v=Nc,Dc=Tv,Yv=Rv;function Kv(n,t){return Math.abs(Nd(n,t))>=1-Ot}var Zv=(function(){var n=Rc(),t=Tc(1,0,0),e=Tc(0,1,0);return function(i,s,r){var o=xo(s,r);return o<-.999999?(po(n,t,s),Ld(n)<1e-6&&po(n,e,s),Pd(n,n),Dd(i,n,Math.PI),i):o>.999999?(i[0]=0,i[1]=0,i[2]=0,i[3]=1,i):(po(n,s,r),i[0]=n[0],i[1]=n[1],i[2]=n[2],i[3]=1+o,Dc(i,i))}})(),Jv=(function(){var n=go(),t=go();return function(e,i,s,r,o,a){return mo(n,i,o,a),mo(t,s,r,a),mo(e,n,t,2*a*(1-a)),e}})(),jv=(function(){var n=dd();return function(t,e,i,s){return n[0]=i[0],n[3]=i[1],n[6]=i[2],n[1]=s[0],n[4]=s[1],n[7]=s[2],n[2]=-e[0],n[5]=-e[1],n[8]=-e[2],Dc(t,Gd(t,n))}})(),gs={};ms(gs,{add:()=>_y,clone:()=>ty,conjugate:()=>Ay,copy:()=>Wd,create:()=>Qv,dot:()=>qd,equals:()=>Py,exactEquals:()=>Iy,fromMat4:()=>ry,fromRotation:()=>sy,fromRotationTranslation:()=>Hd,fromRotationTranslationValues:()=>ny,fromTranslation:()=>iy,fromValues:()=>ey,getDual:()=>cy,getReal:()=>ly,getTranslation:()=>dy,identity:()=>oy,invert:()=>Sy,len:()=>Ey,length:()=>$d,lerp:()=>wy,mul:()=>My,multiply:()=>Xd,normalize:()=>Cy,rotateAroundAxis:()=>yy,rotateByQuatAppend:()=>xy,rotateByQuatPrepend:()=>vy,rotateX:()=>py,rotateY:()=>my,rotateZ:()=>gy,scale:()=>by,set:()=>ay,setDual:()=>uy,setReal:()=>hy,sqrLen:()=>Ty,squaredLength:()=>vo,str:()=>Ry,translate:()=>fy});function Qv(){var n=new se(8);return se!=Float32Array&&(n[0]=0,n[1]=0,n[2]=0,n[4]=0,n[5]=0,n[6]=0,n[7]=0),n[3]=1,n}function ty(n){var t=new se(8);return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t}function ey(n,t,e,i,s,r,o,a){var l=new se(8);return l[0]=n,l[1]=t,l[2]=e,l[3]=i,l[4]=s,l[5]=r,l[6]=o,l[7]=a,l}function ny(n,t,e,i,s,r,o){var a=new se(8);a[0]=n,a[1]=t,a[2]=e,a[3]=i;var l=s*.5,c=r*.5,h=o*.5;return a[4]=l*i+c*e-h*t,a[5]=c*i+h*n-l*e,a[6]=h*i+l*t-c*n,a[7]=-l*n-c*t-h*e,a}function Hd(n,t,e){var i=e[0]*.5,s=e[1]*.5,r=e[2]*.5,o=t[0],a=t[1],l=t[2],c=t[3];return n[0]=o,n[1]=a,n[2]=l,n[3]=c,n[4]=i*c+s*l-r*a,n[5]=s*c+r*o-i*l,n[6]=r*c+i*a-s*o,n[7]=-i*o-s*a-r*l,n}function iy(n,t){return n[0]=0,n[1]=0,n[2]=0,n[3]=1,n[4]=t[0]*.5,n[5]=t[1]*.5,n[6]=t[2]*.5,n[7]=0,n}function sy(n,t){return n[0]=t[0],n[1]=t[1],n[2]=t[2],n[3]=t[3],n[4]=0,n[5]=0,n[6]=0,n[7]=0,n}function ry(n,t){var e=go();_d(e,t);var i=new se(3);return vd(i,t),Hd(n,e,i),n}function Wd(n,t){return n[0]=t[0],n[1]=t[1],n[2]=t[2],n[3]=t[3],n[4]=t[4],n[5]=t[5],n[6]=t[6],n[7]=t[7],n}function oy(n){return n[0]=0,n[1]=0,n[2]=0,n[3]=1,n[4]=0,n[5]=0,n[6]=0,n[7]=0,n}function ay(n,t,e,i,s,r,o,a,l){return n[0]=t,n[1]=e,n[2]=i,n[3]=s,n[4]=r,n[5]=o,n[6]=a,n[7]=l,n}var ly=Ic;function cy(n,t){return n[0]=t[4],n[1]=t[5],n[2]=t[6],n[3]=t[7],n}var hy=Ic;function uy(n,t){return n[4]=t[0],n[5]=t[1],n[6]=t[2],n[7]=t[3],n}function dy(n,t){var e=t[4],i=t[5],s=t[6],r=t[7],o=-t[0],a=-t[1],l=-t[2],c=t[3];return n[0]=(e*c+r*o+i*l-s*a)*2,n[1]=(i*c+r*a+s*o-e*l)*2,n[2]=(s*c+r*l+e*a-i*o)*2,n}function fy(n,t,e){var i=t[0],s=t[1],r=t[2],o=t[3],a=e[0]*.5,l=e[1]*.5,c=e[2]*.5,h=t[4],u=t[5],d=t[6],f=t[7];return n[0]=i,n[1]=s,n[2]=r,n[3]=o,n[4]=o*a+s*c-r*l+h,n[5]=o*l+r*a-i*c+u,n[6]=o*c+i*l-s*a+d,n[7]=-i*a-s*l-r*c+f,n}function py(n,t,e){var i=-t[0],s=-t[1],r=-t[2],o=t[3],a=t[4],l=t[5],c=t[6],h=t[7],u=a*o+h*i+l*r-c*s,d=l*o+h*s+c*i-a*r,f=c*o+h*r+a*s-l*i,p=h*o-a*i-l*s-c*r;return Fd(n,t,e),i=n[0],s=n[1],r=n[2],o=n[3],n[4]=u*o+p*i+d*r-f*s,n[5]=d*o+p*s+f*i-u*r,n[6]=f*o+p*r+u*s-d*i,n[7]=p*o-u*i-d*s-f*r,n}function my(n,t,e){var i=-t[0],s=-t[1],r=-t[2],o=t[3],a=t[4],l=t[5],c=t[6],h=t[7],u=a*o+h*i+l*r-c*s,d=l*o+h*s+c*i-a*r,f=c*o+h*r+a*s-l*i,p=h*o-a*i-l*s-c*r;return Ud(n,t,e),i=n[0],s=n[1],r=n[2],o=n[3],n[4]=u*o+p*i+d*r-f*s,n[5]=d*o+p*s+f*i-u*r,n[6]=f*o+p*r+u*s-d*i,n[7]=p*o-u*i-d*s-f*r,n}function gy(n,t,e){var i=-t[0],s=-t[1],r=-t[2],o=t[3],a=t[4],l=t[5],c=t[6],h=t[7],u=a*o+h*i+l*r-c*s,d=l*o+h*s+c*i-a*r,f=c*o+h*r+a*s-l*i,p=h*o-a*i-l*s-c*r;return kd(n,t,e),i=n[0],s=n[1],r=n[2],o=n[3],n[4]=u*o+p*i+d*r-f*s,n[5]=d*o+p*s+f*i-u*r,n[6]=f*o+p*r+u*s-d*i,n[7]=p*o-u*i-d*s-f*r,n}function xy(n,t,e){var i=e[0],s=e[1],r=e[2],o=e[3],a=t[0],l=t[1],c=t[2],h=t[3];return n[0]=a*o+h*i+l*r-c*s,n[1]=l*o+h*s+c*i-a*r,n[2]=c*o+h*r+a*s-l*i,n[3]=h*o-a*i-l*s-c*r,a=t[4],l=t[5],c=t[6],h=t[7],n[4]=a*o+h*i+l*r-c*s,n[5]=l*o+h*s+c*i-a*r,n[6]=c*o+h*r+a*s-l*i,n[7]=h*o-a*i-l*s-c*r,n}function vy(n,t,e){var i=t[0],s=t[1],r=t[2],o=t[3],a=e[0],l=e[1],c=e[2],h=e[3];return n[0]=i*h+o*a+s*c-r*l,n[1]=s*h+o*l+r*a-i*c,n[2]=r*h+o*c+i*l-s*a,n[3]=o*h-i*a-s*l-r*c,a=e[4],l=e[5],c=e[6],h=e[7],n[4]=i*h+o*a+s*c-r*l,n[5]=s*h+o*l+r*a-i*c,n[6]=r*h+o*c+i*l-s*a,n[7]=o*h-i*a-s*l-r*c,n}function yy(n,t,e,i){if(Math.abs(i)<Ot)return Wd(n,t);var s=Math.sqrt(e[0]*e[0]+e[1]*e[1]+e[2]*e[2]);i=i*.5;var r=Math.sin(i),o=r*e[0]/s,a=r*e[1]/s,l=r*e[2]/s,c=Math.cos(i),h=t[0],u=t[1],d=t[2],f=t[3];n[0]=h*c+f*o+u*l-d*a,n[1]=u*c+f*a+d*o-h*l,n[2]=d*c+f*l+h*a-u*o,n[3]=f*c-h*o-u*a-d*l;var p=t[4],x=t[5],m=t[6],g=t[7];return n[4]=p*c+g*o+x*l-m*a,n[5]=x*c+g*a+m*o-p*l,n[6]=m*c+g*l+p*a-x*o,n[7]=g*c-p*o-x*a-m*l,n}function _y(n,t,e){return n[0]=t[0]+e[0],n[1]=t[1]+e[1],n[2]=t[2]+e[2],n[3]=t[3]+e[3],n[4]=t[4]+e[4],n[5]=t[5]+e[5],n[6]=t[6]+e[6],n[7]=t[7]+e[7],n}function Xd(n,t,e){var i=t[0],s=t[1],r=t[2],o=t[3],a=e[4],l=e[5],c=e[6],h=e[7],u=t[4],d=t[5],f=t[6],p=t[7],x=e[0],m=e[1],g=e[2],_=e[3];return n[0]=i*_+o*x+s*g-r*m,n[1]=s*_+o*m+r*x-i*g,n[2]=r*_+o*g+i*m-s*x,n[3]=o*_-i*x-s*m-r*g,n[4]=i*h+o*a+s*c-r*l+u*_+p*x+d*g-f*m,n[5]=s*h+o*l+r*a-i*c+d*_+p*m+f*x-u*g,n[6]=r*h+o*c+i*l-s*a+f*_+p*g+u*m-d*x,n[7]=o*h-i*a-s*l-r*c+p*_-u*x-d*m-f*g,n}var My=Xd;function by(n,t,e){return n[0]=t[0]*e,n[1]=t[1]*e,n[2]=t[2]*e,n[3]=t[3]*e,n[4]=t[4]*e,n[5]=t[5]*e,n[6]=t[6]*e,n[7]=t[7]*e,n}var qd=Pc;function wy(n,t,e,i){var s=1-i;return qd(t,e)<0&&(i=-i),n[0]=t[0]*s+e[0]*i,n[1]=t[1]*s+e[1]*i,n[2]=t[2]*s+e[2]*i,n[3]=t[3]*s+e[3]*i,n[4]=t[4]*s+e[4]*i,n[5]=t[5]*s+e[5]*i,n[6]=t[6]*s+e[6]*i,n[7]=t[7]*s+e[7]*i,n}function Sy(n,t){var e=vo(t);return n[0]=-t[0]/e,n[1]=-t[1]/e,n[2]=-t[2]/e,n[3]=t[3]/e,n[4]=-t[4]/e,n[5]=-t[5]/e,n[6]=-t[6]/e,n[7]=t[7]/e,n}function Ay(n,t){return n[0]=-t[0],n[1]=-t[1],n[2]=-t[2],n[3]=t[3],n[4]=-t[4],n[5]=-t[5],n[6]=-t[6],n[7]=t[7],n}var $d=Lc,Ey=$d,vo=Nc,Ty=vo;function Cy(n,t){var e=vo(t);if(e>0){e=Math.sqrt(e);var i=t[0]/e,s=t[1]/e,r=t[2]/e,o=t[3]/e,a=t[4],l=t[5],c=t[6],h=t[7],u=i*a+s*l+r*c+o*h;n[0]=i,n[1]=s,n[2]=r,n[3]=o,n[4]=(a-i*u)/e,n[5]=(l-s*u)/e,n[6]=(c-r*u)/e,n[7]=(h-o*u)/e}return n}function Ry(n){return"quat2("+n[0]+", "+n[1]+", "+n[2]+", "+n[3]+", "+n[4]+", "+n[5]+", "+n[6]+", "+n[7]+")"}function Iy(n,t){return n[0]===t[0]&&n[1]===t[1]&&n[2]===t[2]&&n[3]===t[3]&&n[4]===t[4]&&n[5]===t[5]&&n[6]===t[6]&&n[7]===t[7]}function Py(n,t){var e=n[0],i=n[1],s=n[2],r=n[3],o=n[4],a=n[5],l=n[6],c=n[7],h=t[0],u=t[1],d=t[2],f=t[3],p=t[4],x=t[5],m=t[6],g=t[7];return Math.abs(e-h)<=Ot*Math.max(1,Math.abs(e),Math.abs(h))&&Math.abs(i-u)<=Ot*Math.max(1,Math.abs(i),Math.abs(u))&&Math.abs(s-d)<=Ot*Math.max(1,Math.abs(s),Math.abs(d))&&Math.abs(r-f)<=Ot*Math.max(1,Math.abs(r),Math.abs(f))&&Math.abs(o-p)<=Ot*Math.max(1,Math.abs(o),Math.abs(p))&&Math.abs(a-x)<=Ot*Math.max(1,Math.abs(a),Math.abs(x))&&Math.abs(l-m)<=Ot*Math.max(1,Math.abs(l),Math.abs(m))&&Math.abs(c-g)<=Ot*Math.max(1,Math.abs(c),Math.abs(g))}Cc.setMatrixArrayType(Array);var xs=En.create(),en=(n,t)=>En.multiply(En.create(),t,n),vs=n=>En.invert(En.create(),n),Mo=(n,t,e,i)=>ei.transformMat4(ei.create(),[t,e,i],n),ni=(n,t)=>Be.multiply(Be.create(),t,n),yo=n=>Be.transpose(Be.create(),n),Yd=n=>Be.fromMat4(Be.create(),n),Kd=(n,[t,e,i])=>[n[0],n[1],n[2],0,n[3],n[4],n[5],0,n[6],n[7],n[8],0,t,e,i,1];function ii(n){let t=Yd(n),e=t;for(let r=0;r<60;r++){let o=Be.invert(Be.create(),yo(e));if(!o)return{stretch:t,rotation:Be.create()};let a=e.map((c,h)=>.5*(c+o[h])),l=a.reduce((c,h,u)=>Math.max(c,Math.abs(h-e[u])),0);if(e=a,l<1e-14)break}let i=Math.sign(Be.determinant(e))||1,s=e.map(r=>r*i);return{stretch:ni(t,yo(s)),rotation:s}}function bo(n,t,e){let i=Math.hypot(n,t,e)||1e-300;return rr(pn.setAxisAngle(pn.create(),[n/i,t/i,e/i],i))}var wo=n=>pn.normalize(pn.create(),pn.fromMat3(pn.create(),n)),rr=n=>Be.fromQuat(Be.create(),n);function Zd(n){let t=wo(n),[e,i,s,r]=t[3]<0?t.map(l=>-l):t,o=Math.hypot(e,i,s),a=o<1e-12?2:2*Math.atan2(o,r)/o;return[e,i,s].map(l=>a*l)}function _o(n){let t=Yd(n),e=Be.determinant(t)<0?-1:1,[i,s]=[En.getScaling(ei.create(),n),En.getTranslation(ei.create(),n)],r=i.map(o=>e*(o||1));return{translation:s,scale:r,rotation:wo(t.map((o,a)=>o/r[Math.floor(a/3)]))}}function Jd(n,t,e){let[i,s]=[_o(n),_o(t)],r=a=>i[a].map((l,c)=>Ce(l,s[a][c],e)),o=pn.slerp(pn.create(),i.rotation,s.rotation,e);return En.fromRotationTranslationScale(En.create(),o,r("translation"),r("scale"))}function tf(n){return rf(nf(n,ys(n)))}function ef(n,t,e){return hf(n.map(i=>nf(i,t(i))),e)}function ys(n){let{animation:t,keys:e}=n,i=new Map([...n.allConstants()].filter(([s])=>!t.isAnimated(s,e)));return jn(n,{keys:e,constants:i,span:n.span})}function nf(n,t){let{animation:e}=n,i=Qn(t,n),s=Ee([...i.keys.keys(),...i.constants.keys()]),r=s.length?or(n,Ny(e,i),o=>e.at(o,i)):[];return lf(n,s,r,e.range(i.keys,i.span),t)}function sf(n){let{frame:t,neutral:e,animation:i,values:s}=n,r=e?{weights:null,locals:null}:i.clipAt(t),o=or(n,[t],()=>({...r,values:s})),a=[...n.controls.keys()],l=new Map(a.map(c=>[c,s[c]]));return rf(lf(n,a,o,[t,t],jn(n,{keys:new Map,constants:l})))}var rf=n=>({text:n.animations.size?hf([n]):"",unwritten:n.unwritten});function of(n,t){let{character:e,controls:i}=n,s=or(n,[null],()=>({values:fs(n,{values:t}),weights:null,locals:null})),{animations:r,unwritten:o}=uf(n,[...t.keys()]),a=new Set([...t.keys()].flatMap(c=>i[c].drive.channels)),l=c=>({...c,channels:c.channels.filter(h=>a.has(h)),joints:c.joints.filter(h=>c.driven.has(h))});return{animations:[...r].map(([c,h])=>({path:c,lines:df(e,l(h),s)})),unwritten:o}}function af(n,t){let e=Ly(n),i=Qn(e.find(({root:s})=>s===t.character.root)??e[0],t);if(!i.keys.size&&!i.constants.size)throw new Error("No control of this character is named in the layer.");return i}function Ly(n){let[t]=Hi("work",n);if(!n.startsWith("#usda")||!t)throw new Error("This layer was not written by the viewer.");return Fc(t)}function Fc(n){let t=fn(n);return(t?.characters??[t]).filter(Boolean).map(({root:e,keys:i={},standing:s={},span:r})=>({root:e,keys:i,standing:s,...r&&{span:r}}))}function Ny(n,t){let e=n.times(t.keys,t.span),i=[...t.keys.keys()].filter(o=>n.controls[o].drive.values.length>2);if(!i.length)return e;let s=e.map(o=>n.at(o,t).values),r=i.flatMap(o=>e.slice(1).flatMap((a,l)=>Dy(n.controls[o].drive.values,[e[l],s[l][o]],[a,s[l+1][o]])));return Ee([...e,...r])}function Dy(n,[t,e],[i,s]){return n.filter(o=>(o-e)*(o-s)<0).map(o=>t+(o-e)/(s-e)*(i-t)).filter(o=>o>t&&o<i)}function or(n,t,e){let{deformer:i,character:s}=n,r=t.map(o=>{let{values:a,weights:l,locals:c}=e(o);return i.setBase(l,c),i.drive(a),{time:o,values:Float64Array.from(a),left:l,weights:Array.from(i.weights),locals:s.joints.map((h,u)=>Array.from(i.skeletons.localAt(u,i.moves)))}});return n.showBase(),i.drive(n.values),r}function lf(n,t,e,i,s){let{character:r,animation:o}=n,{animations:a,unwritten:l}=uf(n,t),c=new Map;for(let[u,d]of a)d.made&&d.skeletons.forEach(f=>zy(c,r.skeletons[f].path,u)),Oc(c,u,{type:d.made?"def SkelAnimation":"over",lines:df(r,d,e)});for(let u of cf(r.controls,t.filter(d=>Oy(r,d,e)))){let[d,f]=r.controls[u].attribute.split(".");Oc(c,d,{type:"over",lines:By(f,u,e)})}let h=[`${r.root}/`,...r.skeletons.map(u=>`${Eo(u)}.`)];return{animations:a,unwritten:l,prims:c,range:i,rate:o.rate,own:h,work:{root:r.root,...s}}}function Oy({baseWeights:n,controls:t},e,i){let{channels:s}=t[e].drive;return i.every(({left:r})=>!r||s.every(o=>Math.abs(r[o]-n[o])<1e-5))}function cf(n,t){let e=({drive:s,kind:r},o)=>o.drive.channels.some(a=>s.channels.includes(a))||(r!=="joint"||o.kind!=="joint")&&o.drive.joints.some(a=>s.joints.includes(a)),i=t.filter(s=>n[s].attribute&&n.every((r,o)=>t.includes(o)||!e(n[s],r)));return i.length===t.length?i:cf(n,i)}function hf(n,t=[]){let[{rate:e,work:i}]=n,s=new Map(t.map(o=>[o.root,o]));for(let{work:o}of n){let{keys:a,standing:l}=s.get(o.root)??{};s.set(o.root,{...o,keys:{...o.keys,...a},standing:{...o.standing,...l}})}let r=[...s.values()];return Mi(new Map(n.flatMap(({prims:o})=>[...o])),[`defaultPrim = ${Ve(i.root.split("/")[1]??"")}`,`startTimeCode = ${me(Math.min(...n.map(({range:o})=>o[0])))}`,`endTimeCode = ${me(Math.max(...n.map(({range:o})=>o[1])))}`,`timeCodesPerSecond = ${me(e)}`,`framesPerSecond = ${me(e)}`,...hs("customLayerData",`string work = ${Ve(JSON.stringify(r.length>1?{characters:r}:r[0]))}`,`string[] own = [${n.flatMap(({own:o})=>o).map(Ve).join(", ")}]`)])}function uf({character:n,controls:t},e){let{channels:i,joints:s,skeletons:r}=n,o=r.map(Eo),a=i.map((u,d)=>Uy(n,o,u,d)),l=new Map,c=u=>oe(l,u,()=>Fy(n,o,u)),h=[];for(let u of e){let{drive:d,name:f}=t[u],p=d.channels.flatMap(x=>a[x]);p.forEach(x=>c(x).weighted=!0),d.joints.forEach(x=>c(o[s[x].skeleton]).driven.add(x)),d.channels.length&&!p.length&&h.push(f)}for(let[u,d]of l){i.forEach((p,x)=>d.weighted&&a[x].includes(u)&&d.channels.push(x)),d.channels.sort((p,x)=>jd(i[p])-jd(i[x]));let f=d.channels.map(p=>i[p].token);d.channels=d.channels.filter((p,x)=>f.indexOf(f[x])===x),d.driven.size&&(d.joints=ky(s,d))}return{animations:l,unwritten:h}}var Eo=({path:n,animation:t})=>t||`${n}/usdrigui_animation`,Fy=({skeletons:n,channels:t},e,i)=>({skeletons:[...n.keys()].filter(s=>e[s]===i),made:[...n,...t].every(({animation:s})=>s!==i),weighted:!1,driven:new Set,channels:[],joints:[]}),jd=({index:n})=>n<0?1/0:n;function Uy({meshes:n,joints:t,channels:e},i,{animation:s,index:r},o){if(s&&r>=0)return[s];let l=n.filter(({shapes:c})=>c.some(h=>h.channel===o)).flatMap(({skin:c,shapes:h})=>{if(c)return[i[t[c.joints[0]].skeleton]];let u=h.map(d=>e[d.channel]).find(d=>d.animation);return u?[u.animation]:i});return[...new Set(l)]}function ky(n,{skeletons:t,driven:e}){let i=new Map;return n.forEach(({path:s,skeleton:r},o)=>{t.includes(r)&&(!i.has(s)||e.has(o))&&i.set(s,o)}),[...i.values()]}function df(n,{channels:t,joints:e},i){let s=[];if(t.length&&(s.push(Qd("blendShapes",t.map(r=>n.channels[r].token))),s.push(...Ao("float[] blendShapeWeights",i,({weights:r})=>t.map(o=>me(r[o]))))),e.length){let r=i.map(({time:l,locals:c})=>({time:l,parts:e.map(h=>_o(c[h]))})),o=l=>c=>c.parts.map(h=>`(${h[l].map(me).join(", ")})`);s.push(Qd("joints",e.map(l=>n.joints[l].path)));let a=({rotation:[l,c,h,u]})=>`(${[u,l,c,h].map(me).join(", ")})`;s.push(...Ao("quatf[] rotations",r,l=>l.parts.map(a))),s.push(...Ao("half3[] scales",r,o("scale"))),s.push(...Ao("float3[] translations",r,o("translation")))}return s}function By(n,t,e){let i=e.map(({time:s,values:r})=>[me(s),me(r[t])]);return i.every(([,s])=>s===i[0][1])?[`double ${n} = ${i[0][1]}`]:[`double ${n}.timeSamples = {`,...i.map(([s,r])=>`    ${s}: ${r},`),"}"]}var Qd=(n,t)=>`uniform token[] ${n} = [${t.map(Ve).join(", ")}]`;function Ao(n,t,e){if(t[0].time===null)return[`${n} = [${e(t[0]).join(", ")}]`];let i=t.map(s=>`    ${me(s.time)}: [${e(s).join(", ")}],`);return[`${n}.timeSamples = {`,...i,"}"]}function zy(n,t,e){Oc(n,t,{type:"over",metadata:'prepend apiSchemas = ["SkelBindingAPI"]',lines:[`rel skel:animationSource = <${e}>`]})}function Oc(n,t,{type:e,metadata:i="",lines:s}){let r=n.get(t)??{type:"over",metadata:"",lines:[]};n.set(t,{type:e==="over"?r.type:e,metadata:i||r.metadata,lines:[...r.lines,...s]})}function pf(n,t){let e=new Set,i=new Map([["/Poses",{type:"def Scope"}]]);for(let{name:s,values:r,picture:o}of t){let{animations:a,unwritten:l}=of(n,r);l.forEach(d=>e.add(d));let c={name:s,values:xi(n,r),picture:o},h=ff("/Poses",s,i),u=[`displayName = ${Ve(s)}`,...hs("customData",`string pose = ${Ve(JSON.stringify(c))}`)].join(`
`);i.set(h,{type:"def Scope",metadata:u});for(let{path:d,lines:f}of a)i.set(ff(h,d.split("/").at(-1),i),{type:"def SkelAnimation",lines:f})}return{text:Mi(i,['defaultPrim = "Poses"']),unwritten:[...e]}}function mf(n,t){if(!n.startsWith("#usda")||!Hi("pose",n).length)throw new Error("This layer holds no poses saved by the viewer.");let e=Uc(n,t);if(!e.length)throw new Error("No control of this character is named in the poses.");return e}var Uc=(n,t)=>Hi("pose",n).map(e=>kc(JSON.parse(e),t)).filter(Boolean);function kc({name:n,values:t,picture:e},i){let s=Un(t,i.controls),r=typeof e=="string"&&e.startsWith("data:image/")?e:"";return s.size?{name:String(n),values:s,picture:r}:null}function ff(n,t,e){let i=`${n}/${t.replace(/[^A-Za-z0-9_]/g,"_").replace(/^(?=[0-9]|$)/,"_")}`,s=i;for(let r=2;e.has(s);r++)s=`${i}_${r}`;return s}function To(n){let{frame:t,neutral:e,own:i,controls:s,elements:r,moved:o,locks:a,shelf:l,notes:c,received:h,sound:u,span:d}=n,f=e?n.rest:n.given,p=[...i.keys()].filter(x=>i[x]!==f[x]);return!n.keys.size&&!n.constants.size&&!p.length&&!d&&xf(n)?null:{frame:t,neutral:e,...jn(n,n),changed:Object.fromEntries(p.map(x=>[s[x].name,i[x]])),locks:[...a].map(x=>s[x].name),shelf:l.map(x=>({...x,values:xi(n,x.values)})),notes:c.map(x=>Sc(n,x)),received:h,sound:u,moved:[...o].map(([x,m])=>[r.list[x].name,m,r.placement(r.list[x])])}}var gf=n=>!n.unkeyed().length&&xf(n),xf=({moved:n,locks:t,shelf:e,sound:i,notes:s,arrived:r})=>!n.size&&!t.size&&!e.length&&!i&&s===r;function vf(n,t){let{controls:e,elements:i}=n,s=n.snapshot(),{keys:r,constants:o,span:a}=Qn(t,n);n.locks=new Set(e.flatMap(({name:m},g)=>t.locks?.includes(m)?[g]:[]));for(let[m,g,_]of t.moved??[]){let w=i.list.find(y=>y.name===m&&y.members.length===_.members.length);!w||!Array.isArray(g)||(i.restore(w,_),n.moved.set(w.index,g))}let l=t.neutral===!0,c=Number.isFinite(t.frame)?t.frame:n.frame,h=l?Float64Array.from(n.rest):n.animation.at(c,{keys:r,constants:o}).values,u=Float64Array.from(h);Un(t.changed,e).forEach((m,g)=>u[g]=m);let d=(t.shelf??[]).map(m=>kc(m,n)).filter(Boolean),f=Gy(t.sound)?t.sound:null,p=n.notes.filter(({id:m})=>!t.received?.includes(m)),x=sr(p,(t.notes??[]).map(m=>Ac(m,n)).filter(Boolean));n.received=[...new Set([...n.received,...t.received??[]])],n.restore({frame:c,neutral:l,keys:r,constants:o,given:h,values:u,shelf:d,notes:x,sound:f,span:a}),n.step("Restore work",s),n.emit("options"),n.emit("layout")}function yf({keys:n,standing:t,changed:e,moved:i,shelf:s,notes:r,sound:o,span:a}){let l=Object.values(n??{}),c=l.reduce((u,d)=>u+d.length,0),h=Object.keys({...t,...e}).length;return[c?`${he(c,"key")} of ${he(l.length,"control")}`:"",h?`${he(h,"control")} changed without a key`:"",i?.length?`${he(i.length,"element")} moved`:"",s?.length?`${he(s.length,"pose")} on the shelf`:"",r?.length?he(r.length,"note"):"",o?`the place of ${o.name}`:"",a?`frames ${a[0]} to ${a[1]}`:""].filter(Boolean).join(", ")||"locks"}var Gy=n=>typeof n?.name=="string"&&Number.isFinite(n.start)&&n.seconds>=0;var Vy=300,Co=class{constructor(t,e,i=()=>!1){this.isElsewhere=i,this.session=t,this.storage=e,this.prefix=`usdrigui ${t.character.identity} `,this.slot=`${this.prefix}${Date.now().toString(36)}${Math.random().toString(36).slice(2,8)}`,this.stored=null,this.filed=null}listen(t){this.onfail=t;for(let e of["changed","time","options"])this.session.on(e,()=>this.schedule());this.session.on("saved",()=>this.filed=_f(this.session))}schedule(){clearTimeout(this.timer),this.timer=setTimeout(()=>this.flush(),Vy)}flush(){if(clearTimeout(this.timer),!this.storage||this.session.trial)return;let t=this.isElsewhere()?null:To(this.session),e=JSON.stringify(t);try{t?this.storage.setItem(this.slot,JSON.stringify({saved:Date.now(),work:t})):this.storage.removeItem(this.slot),this.stored=e}catch{this.failed||this.onfail?.(),this.failed=!0}}get isUnsaved(){let{session:t}=this;if(this.isElsewhere()||JSON.stringify(To(t))===this.stored)return!1;let e=_f(t);return e!=="null"&&e!==this.filed||t.notes!==t.arrived&&t.notes!==t.sent}get offered(){if(!this.storage)return null;let i=Object.keys(this.storage).filter(s=>s.startsWith(this.prefix)&&s!==this.slot).map(s=>({slot:s,...fn(this.storage.getItem(s))})).filter(({work:s})=>s).sort((s,r)=>r.saved-s.saved)[0];return i?{...i,words:yf(i.work)}:null}forget(){clearTimeout(this.timer),this.storage?.removeItem(this.slot)}discard({slot:t}){this.storage.removeItem(t)}};function Mf(){try{let{localStorage:n}=window;return n.setItem("usdrigui",""),n.removeItem("usdrigui"),n}catch{return null}}var _f=n=>JSON.stringify(To(Object.create(n,{notes:{value:n.arrived}})));var Ro=184,_s=46,bf=26,Gc=50,Bc=24,Wi=10,Hy="11.5px system-ui, sans-serif",Io=class{constructor(t){this.session=t,this.scroll=0,this.most=0,this.cells=new Map,this.headings=[],this.front=new zn(t.character.up,t.section.view)}get elements(){return this.session.elements.list.filter(t=>t.onBoard&&this.session.isShown(t))}place(t,e){if(!this.elements.length)return null;if(e>t){let o=Math.min(.32*e,this.tall(t)+Wi);return{left:0,top:e-o,width:t,height:o}}let s=Vt(.1*t,Ro,1.25*Ro),r=Math.min(Math.ceil(this.tall(s)/e),Math.max(1,Math.floor(.36*t/s)));return{left:t-r*s,top:0,width:r*s,height:e}}tall(t){let e=Math.max(1,Math.floor(t/Ro)),i=new Set(this.elements.map(({category:s})=>s)).size;return Wi+(i*Bc+this.elements.reduce((s,r)=>s+zc(r),0))/e+bf}arrange(t){if(this.rect=t,this.cells=new Map,this.headings=[],!t)return;let e=Math.max(1,Math.floor(t.width/Ro));this.room=t.width/e-_s-2.6*Wi;let i=Math.max(t.height,this.tall(t.width)),s={column:0,top:Wi},r=(a,l=a)=>(s.top+l>i&&s.column+1<e&&Object.assign(s,{column:s.column+1,top:Wi}),s.top+=a,{left:t.left+s.column*t.width/e+Wi,top:t.top+s.top-a-this.scroll}),o=null;for(let a of[...this.elements].sort(Xy)){(a.category!==o||!this.cells.size)&&this.headings.push({...r(Bc,Bc+zc(a)),text:ar(a)}),o=a.category;let l=zc(a);this.cells.set(a,{...r(l),height:l,...this.shape(a)})}this.most=Math.max(0,Math.max(0,...[...this.cells.values()].map(a=>a.top+a.height))+this.scroll-t.top-t.height);for(let a of this.cells.values())a.map=qy(a)}shape(t){let{rest:e}=this.session,{right:i,above:s}=this.front,r=t.members.map(f=>f.track),o=t.members.map((f,p)=>Sn(f.values,r[p],e[f.control])),a=f=>p=>Et(ve(p.at(-1),p[0]),[i,s][f]),l=t.axes.length>1?0:Math.atan2(a(1)(r.at(-1)),a(0)(r.at(-1))),[c,h]=[Math.cos(l),Math.sin(l)],u=f=>{let[p,x]=[Et(f,i),Et(f,s)];return[c*p+h*x,h*p-c*x]};return{points:r.flatMap((f,p)=>f.map(x=>u(ve(x,o[p])))),origin:u(o[0]),flat:u,likeness:{members:t.members,tracks:r,origins:o}}}seen(t){return[Et(t,this.front.right),-Et(t,this.front.above)]}mapOf(t){return this.cells.get(t)?.map}heldStill(t){let{tracks:e}=this.cells.get(t).likeness;return{...t,tracks:e}}handleOf(t){let{members:e,tracks:i,origins:s}=this.cells.get(t).likeness;return this.session.elements.handleAt({members:e,tracks:i},this.session.values,s)}contains(t){return!!this.rect&&oo(this.rect,t)}scrollBy(t){let e=this.scroll;return this.scroll=Vt(this.scroll+t,0,this.most),this.scroll!==e}draw(t){let{rect:e,session:i}=this;if(e){t.globalAlpha=1,t.fillStyle="rgba(36, 39, 43, 0.96)",t.fillRect(e.left,e.top,e.width,e.height),t.textAlign="left",t.font="600 10.5px system-ui, sans-serif",t.fillStyle="#979da6";for(let{left:s,top:r,text:o}of this.headings)t.fillText(o.toUpperCase(),s,r+15);t.font=Hy;for(let[s,{left:r,top:o,height:a}]of this.cells){let l=i.hover===s||i.selection.has(s.index);t.fillStyle=l?"#f4f5f7":"#b4bac2",t.fillText($y(t,s.label,this.room),r+_s+Wi,o+a/2+4)}this.most>0&&this.drawBar(t)}}drawBar(t){let{rect:e,most:i,scroll:s}=this,r=e.height*e.height/(e.height+i);t.fillStyle="rgba(255, 255, 255, 0.25)",t.fillRect(e.left+e.width-4,e.top+s/i*(e.height-r),3,r)}},ar=n=>n.category&&n.heading||"Off the face",Wy=globalThis.matchMedia?.("(pointer: coarse)").matches??!1,zc=n=>n.axes.length>1?Gc:Wy?er:bf,Xy=(n,t)=>n.rank-t.rank||+(n.category>t.category)-+(n.category<t.category)||n.index-t.index;function qy({left:n,top:t,height:e,points:i,origin:s,flat:r}){let o=x=>[Math.min(0,...i.map(m=>m[x])),Math.max(0,...i.map(m=>m[x]))],[[a,l],[c,h]]=[o(0),o(1)],u=Math.min(_s-12,e===Gc?e-14:_s),d=Math.min(u/Math.max(l-a,1e-12),(e===Gc?u:_s)/Math.max(h-c,1e-12),1e12),[f,p]=[n+_s/2-d*(a+l)/2,t+e/2-d*(c+h)/2];return x=>{let[m,g]=r(x);return[f+d*(m-s[0]),p+d*(g-s[1]),1]}}function $y(n,t,e){if(n.measureText(t).width<=e)return t;for(let i of[yc(t),""]){let s=t.length-i.length-1;for(;s>1&&n.measureText(`${t.slice(0,s)}…${i}`).width>e;)s--;if(s>1)return`${t.slice(0,s)}…${i}`}return""}var Vc=1e3,Po=class{constructor(t,e){this.session=t,this.view=e,this.search=U("input",{type:"search",class:"search",placeholder:"Search controls  ( / )","aria-label":"Search controls",oninput:()=>this.filter(),onkeydown:i=>i.key==="Escape"&&this.clearSearch()}),this.rows=t.controls.map((i,s)=>this.makeRow(i,s)),this.body=U("div",{class:"rows"},...this.sections()),this.empty=be("No control has this name."),this.empty.hidden=!0,this.node=U("section",{class:"list","aria-label":"Controls"},this.search,this.body,this.empty),t.on("pose",()=>this.updateValues()),t.on("selection",()=>this.updateMarks(!0)),t.on("hover",()=>this.updateMarks(!1)),t.on("options",()=>this.updateMarks(!1)),t.on("layout",()=>this.body.replaceChildren(...this.sections())),this.shown=new Float64Array(t.controls.length).fill(NaN),this.updateValues(),this.updateMarks(!1)}sections(){let t=new Map;return this.rows.forEach((i,s)=>{let r=this.session.elements.byControl.get(s),o=r?r.onBoard?ar(r):"":"Not in the layout";oe(t,o,()=>[]).push(i.node)}),[...t].sort(([i],[s])=>wf(i)-wf(s)).flatMap(([i,s])=>i?[U("h3",{},i),...s]:s)}makeRow(t,e){let{session:i,view:s}=this,r=i.elements.byControl.get(e),o=U("input",{type:"range",min:0,max:Vc,step:1,"aria-label":t.label,oninput:()=>{let f=t.minimum+o.value/Vc*(t.maximum-t.minimum);i.edit(`Set ${t.label}`,()=>i.set([[e,f]]),`list ${e}`)},ondblclick:()=>i.reset([e])}),a={type:"text",inputMode:"decimal",class:"number","aria-label":`${t.label}, value`,onfocus:()=>l.select()},l=ro(i,e,a,"list"),c=vt("","Lock: neither drags nor pulls change it",()=>i.toggleLock(e),{class:"lock","aria-label":`Lock ${t.label}`}),h=vt(nr(t.label),t.label===t.name?t.name:`${t.label} (${t.name})`,f=>r&&i.reveal(r,f.shiftKey?"toggle":"replace"),{class:"name",tabIndex:-1,"aria-label":t.label}),u=U("i",{class:"chip",style:{background:i.colours[r?.side??"none"]}});return{node:U("div",{class:"row","data-control":t.name,onpointerenter:()=>s.pointAt(e),onpointerleave:()=>s.pointAt(null)},u,h,o,l,c),slider:o,number:l,lock:c,index:e,element:r}}updateValues(){let{session:t,shown:e}=this;for(let{slider:i,number:s,index:r,node:o}of this.rows){let a=t.values[r];if(a===e[r])continue;e[r]=a;let{minimum:l,maximum:c}=t.controls[r],h=c-l;i.value=Vc*(a-l)/h;let u=[a,t.rest[r]].map(d=>100*(d-l)/h);i.style.setProperty("--from",`${Math.min(...u)}%`),i.style.setProperty("--at",`${Math.max(...u)}%`),document.activeElement!==s&&(s.value=t.worded(r)),o.classList.toggle("moved",a!==t.rest[r])}}updateMarks(t){let{session:e}=this,i=null;for(let{node:s,lock:r,element:o,index:a}of this.rows){let l=o!==void 0&&e.selection.has(o.index);s.classList.toggle("selected",l),s.classList.toggle("hovered",o!==void 0&&e.hover===o),ti(r,{"aria-pressed":e.locks.has(a)}),l&&(i??=s)}t&&i&&!this.node.contains(document.activeElement)&&i.scrollIntoView({block:"nearest"})}filter(){let t=this.search.value.toLowerCase().split(/\s+/).filter(Boolean),e=({index:r})=>{let{name:o,label:a,source:l}=this.session.controls[r],c=`${o} ${a} ${l}`.toLowerCase();return t.every(h=>c.includes(h))},i=0;for(let r of this.rows)r.node.hidden=!e(r),i+=r.node.hidden?0:1;this.body.classList.toggle("searching",t.length>0),this.empty.hidden=i>0;let s=this.rows.filter(r=>t.length&&!r.node.hidden&&r.element).map(r=>r.element);t.length&&this.session.select(new Set(s))}clearSearch(){this.search.value="",this.filter(),this.session.select([])}},wf=n=>n===""?0:n==="Not in the layout"?2:1;var Hc=[["Front",0,0],["¾",.7,.05],["Side",Math.PI/2,0],["Back",Math.PI,0]],Lo=class{constructor(t){this.app=t,this.groups=[this.chooser(),this.tabs(),...this.toggles(),this.looks(),t.live?.makeNode(),this.study()].filter(Boolean),this.row=U("div",{class:"bar-row"}),this.menu=U("details",{class:"menu"},U("summary",{title:"More","aria-label":"More"},"⋯"),U("div",{class:"menu-items"})),this.title=U("h1",{},t.scene.title),this.node=U("header",{class:"bar"},this.title,this.row,this.menu,this.always()),new ResizeObserver(()=>this.fit()).observe(this.node)}fit(){let t=this.menu.lastElementChild;this.row.replaceChildren(),t.replaceChildren(),this.menu.hidden=!1;for(let e of this.groups)this.row.append(e),this.row.scrollWidth>this.row.clientWidth&&t.append(e);this.menu.hidden=!t.children.length}act(t,e,i,s=t){return vt(t,e,i,{"aria-label":s})}always(){let{app:t}=this;return U("div",{class:"group"},this.act("↶","Undo (Ctrl+Z)",()=>t.undo(),"Undo"),this.act("↷","Redo (Ctrl+Shift+Z)",()=>t.redo(),"Redo"),this.act("Key","Key the selected controls and all that changed, at this frame (K)",()=>t.timeline.key()),this.panel("inspector","Panel","Selection, display, poses, layout (P)"),this.act("?","Gestures and keys (?)",()=>t.showHelp(),"Shortcuts"))}panel(t,e,i){return this.app.session.updating(kn(e,i,()=>!this.app[t].node.hidden,()=>this.app.fold(t)))}chooser(){let{scene:t,index:e}=this.app;if(t.characters.length<2)return null;let i=t.characters.map(({root:s},r)=>U("option",{value:r,selected:r===e},s));return U("select",{"aria-label":"Character",onchange:({target:s})=>this.app.open(Number(s.value))},...i)}tabs(){let{session:t}=this.app,{sections:e}=t.character.layout;if(e.length<2)return null;let i=e.map((r,o)=>[r,r.title,`Show: ${r.title} (${o+1} of ${e.length})`]),s=yi("Part",i,()=>t.section,r=>t.show(e.indexOf(r)));return t.on("section",()=>s.update()),s}toggles(){let{app:t}=this,{session:e}=t,i=(s,r,o)=>e.updating(kn(r,o,()=>e.options[s],()=>e.flipOption(s)));return[i("symmetric","Symmetry","Both sides at once (S)"),this.panel("list","List","All controls as sliders (C)"),this.panel("review","Review","Notes: words and strokes at frames, to send and to open (N)"),i("handles","Handles","Show or hide the handles (H)"),e.updating(yi("Where the controls are",[["face","On face","Controls on the face"],["beside","On copy","Controls on a copy of the face, the clean face next to it"]],()=>e.options.arrangement,s=>t.setArrangement(s))),i("rearrange","Rearrange","Drag elements to other points of the face")]}looks(){let t=([e,i,s])=>this.act(e,`View: ${e}`,()=>this.app.view.home(i,s),`View: ${e}`);return U("div",{class:"group looks"},...Hc.map(t))}study(){return"study"in document.body.dataset?this.act("Evaluate","Match target faces with three interfaces",()=>this.app.evaluation.open()):null}};var No=class{constructor(t){this.app=t,this.device="",this.rows=null,this.taken=null,this.path=0,this.pressed=null;for(let e of["pointerdown","pointermove","pointerup"])t.node.addEventListener(e,i=>this.follow(i),!0)}record(t){Object.assign(this,{rows:t,taken:null,pressed:null,last:null,path:0})}follow(t){if(!this.rows)return;let{clientX:e,clientY:i,type:s}=t;if(this.last&&(this.path+=Math.hypot(e-this.last[0],i-this.last[1])),this.last=[e,i],this.device=t.pointerType,s==="pointerdown"){let r=t.target.closest?.('[data-control] input[type="range"]');this.pressed={at:performance.now(),x:e,y:i,pixels:this.path,slider:r?.closest("[data-control]").dataset.control},this.path=0}else s==="pointerup"&&this.pressed&&this.release(e,i)}take(t){this.taken??=t.members.map(({control:e})=>this.app.session.controls[e].name).join("+")}release(t,e){let{slider:i,...s}=this.pressed,r=this.taken??i??"";r?(this.rows.push({event:"grab",control:r,...s}),this.rows.push({event:"release",control:r,at:performance.now(),x:t,y:e,pixels:this.path}),this.path=0):this.isNearHandle(s)&&this.rows.push({event:"miss",control:r,...s}),Object.assign(this,{pressed:null,taken:null})}isNearHandle({x:t,y:e}){let{view:i}=this.app,{left:s,top:r}=i.node.getBoundingClientRect();return i.session.options.handles&&i.overlay.drawn.some(({handle:o,width:a})=>Math.hypot(o[0]+s-t,o[1]+r-e)<2*a)}};var Ms=class{done=[];undone=[];push(t,e,i,s=null,r=[]){let o=performance.now(),a=this.done.at(-1);s&&a?.merge===s&&o-a.when<900?Object.assign(a,{redo:i,when:o,states:[...a.states,...r]}):this.done.push({label:t,undo:e,redo:i,merge:s,states:r,when:o}),this.done.length>200&&this.done.shift(),this.undone=[]}get states(){return[...this.done,...this.undone].flatMap(({states:t})=>t)}undo(){let t=this.done.pop();return t?(t.undo(),this.undone.push({...t,merge:null}),t.label):null}redo(){let t=this.undone.pop();return t?(t.redo(),this.done.push(t),t.label):null}};var Yy=["amateur","professional"],Wc={list:"Slider list",face:"Controls on the face",beside:"Controls on a copy beside the face"},lr=[["list","face","beside"],["face","beside","list"],["beside","list","face"],["list","beside","face"],["face","list","beside"],["beside","face","list"]],Tf=[1,2],Cf=[6,8],Ky=13,bs=Tf.length+Cf.length+1,Xc=3*(bs-1)+1,Zy=.02,Jy=.1,jy=2,Qy={overall_list:["Working with the slider list","poor","good"],overall_face:["Working with the controls on the face","poor","good"],overall_beside:["Working with the controls on a copy beside the face","poor","good"],easy:["On the face: I could make the expressions without effort","no","yes"],unexpected:["On the face: a control did something else than I thought","never","often"],cluttered:["On the face: there was too much in one place","no","yes"],placed:["On the face: a control stood where it acts","no","yes"],direct:["On the face: it felt like moving the face itself","no","yes"]};function Kc(n,t,e=null){let i=qc(n),s=If(20230806),[r,o]=e?t_(e,t):[$c(t,Ky,s),i.map(()=>[...Tf,...Cf].map(a=>$c(t,a,s)))];return i.flatMap((a,l)=>[...o[l].map((c,h)=>({block:l+1,name:a,face:`${l+1}${"abcd"[h]}`,target:c})),{block:l+1,name:a,face:"common",target:r}])}var qc=n=>lr[(n-1)%lr.length];function t_(n,t){let e=Rf(n,t),i=lr[0].map((s,r)=>[0,1,2,3].map(o=>e[r+3*o]));return[e[e.length-1],i]}function Rf(n,t){let e=r=>Float64Array.from(t.rest,(o,a)=>r.get(a)??o),i=r=>r.reduce((o,a,l)=>o+(a!==t.rest[l]?1:0),0);return n.map(e).map((r,o)=>({each:r,i:o,count:i(r)})).filter(({count:r})=>r).sort((r,o)=>r.count-o.count||r.i-o.i).map(({each:r})=>r)}function Sf(n,t){let{length:e}=Rf(n,t);return e<Xc?`${e} of the poses given move a control of this character; the evaluation needs ${Xc}.`:""}function e_({animation:n,controls:t,rest:e}){let i=(a,l)=>t.map(({minimum:c,maximum:h},u)=>Math.abs(a[u]-l[u])/(h-c||1)),s=n.times(new Map).map(a=>{let{values:l}=n.clipAt(a);return i(l,e).map((c,h)=>c>Zy?l[h]:e[h])}),r=new Set,o=s.map(a=>Math.max(...i(a,e)));for(;r.size<Xc&&Math.max(...o)>Jy;){let a=o.indexOf(Math.max(...o));r.add(a),o=o.map((l,c)=>Math.min(l,Math.max(...i(s[c],s[a]))))}return s.filter((a,l)=>r.has(l)).map(a=>new Map(a.entries()))}function n_(n,t,e=null){let i=If(20210806),s=lr[0].map(()=>$c(t,jy,i));return Kc(n,t,e).flatMap((r,o)=>{let{block:a,name:l}=r;return o%bs?[r]:[{block:a,name:l,face:"practice",target:s[a-1]},r]})}function $c(n,t,e){let i=Float64Array.from(n.rest),s=n.elements.list.filter(o=>!o.onBoard),r=[...s.length>=t?s:n.elements.list];for(let o=0;o<t&&r.length;o++){let[a]=r.splice(Math.floor(e()*r.length),1),{control:l}=a.members[Math.floor(e()*a.members.length)],{minimum:c,maximum:h}=n.controls[l],u=h>n.rest[l]?h:c;i[l]+=(.4+.6*e())*(u-n.rest[l])}return i}function If(n){let t=n;return()=>{t=t+1831565813|0;let e=Math.imul(t^t>>>15,1|t);return e=e+Math.imul(e^e>>>7,61|e)^e,((e^e>>>14)>>>0)/4294967296}}function Af(n,t,e,i=null){let s=0,r=0;for(let o=0;o<t.length;o++){let a=i&&i[o]||1;s+=((n[o]-t[o])/a)**2,r+=((e[o]-t[o])/a)**2}return r>0?s/r:0}var Ef=["participant","block","interface","trial","face","target_controls","seconds","share_of_time","edits","weight_error_squared","vertex_error_squared","question","answer","paused","face_pixels","target_pixels","window","device","level","order","targets","character","layout","version"],i_=["participant","trial","face","interface","event","seconds","control","x","y","pixels"];function s_(n,t,e={},i={}){let s=Yc(t),r=t.map((l,c)=>({block:l.block,interface:l.name,trial:c+1,face:l.face,target_controls:l.controls,seconds:l.seconds.toFixed(2),share_of_time:(s?l.seconds/s:0).toFixed(5),edits:l.edits,weight_error_squared:l.weightError.toFixed(6),vertex_error_squared:l.vertexError.toFixed(6),paused:(l.paused??0).toFixed(2),face_pixels:(l.facePixels??0).toFixed(1),target_pixels:(l.targetPixels??0).toFixed(1),window:l.window,device:l.device})),o=Object.entries(e).map(([l,c])=>({question:l,answer:Pf(c)})),a=[...r,...o].map(l=>({participant:n,...i,...l}));return`${[Ef,...a.map(l=>Ef.map(c=>l[c]??""))].map(l=>l.join(",")).join(`
`)}
`}var Yc=n=>n.reduce((t,{seconds:e})=>t+e,0);function r_(n,t){let e=t.flatMap(({face:i,name:s,events:r=[]},o)=>r.map(({event:a,at:l,control:c,x:h,y:u,pixels:d})=>[n,o+1,i,s,a,(l/1e3).toFixed(3),Pf(c),Math.round(h),Math.round(u),Math.round(d)].join(",")));return`${[i_.join(","),...e].join(`
`)}
`}var Pf=n=>typeof n=="number"?n:`"${n.replace(/"/g,'""').replace(/\s+/g," ")}"`,Do=class{constructor(t){this.app=t,this.running=null,this.trials=[],this.results=[],this.panel=U("div",{class:"evaluation",hidden:!0,role:"dialog","aria-label":"Evaluation"}),this.hand=new No(t),t.session.on("edited",()=>this.running&&this.running.edits++),t.session.on("dragging",()=>this.running&&t.session.dragging?.members&&this.hand.take(t.session.dragging))}open(){let t=U("input",{type:"number",min:1,value:1,"aria-label":"Participant number"}),e=be(),i=()=>{let d=qc(Math.max(1,Number(t.value))).map(f=>Wc[f]);e.textContent=`Order: ${d.join(" → ")}`};t.addEventListener("input",i),i();let s=U("input",{type:"checkbox"}),r=(d,f)=>U("select",{"aria-label":d},...f.map(p=>U("option",{value:p},p||"choose"))),o=r("Experience",["",...Yy]),a=this.sets(),l=r("Target faces",[...a.keys()]),c=vt("Start","",()=>{this.setting={level:o.value,targets:l.value},this.start(Math.max(1,Math.floor(Number(t.value))||1))},{class:"primary"}),h=()=>c.disabled=!s.checked||!o.value;for(let d of[s,o])d.addEventListener("change",h);h();let u=this.kept();this.show(U("h2",{},"Match the target face"),U("p",{},"Fifteen faces, five with each of three interfaces, and one to practise on before each five. Change your face until it looks like the target, then press Done. Pulling the skin, shortcuts and playback are off, so that the interfaces can be compared."),vi("Participant",t),e,vi("I animate faces as",o),vi("Target faces",l),be(this.lacking),U("label",{class:"field"},s,U("span",{},"I agree that my times, errors, answers and what my pointer does are saved under this number, without my name, and may be published. I can stop at any time.")),tn(c,u&&vt(`Go on with participant ${u.participant}`,`${u.results.length} of 15 faces are done`,()=>{this.setting=u.setting,this.start(u.participant,u.results)}),vt("Cancel","",()=>this.close())))}sets(){let{session:t,targets:e}=this.app,i=a=>a.map(({values:l})=>l),s=i(e.flatMap(a=>Uc(a,t))),r=new Map,o=(a,l)=>Sf(l,t)||r.set(a,l);return o("the poses given",s),o("the shelf",i(t.shelf)),r.set("drawn from the controls",null),o("the clip",e_(t)),this.lacking=e.length?Sf(s,t):"",r}get slot(){return`usdrigui study ${this.app.session.character.identity}`}kept(){return fn(this.app.storage?.getItem(this.slot))}keep(t){try{t?this.app.storage?.setItem(this.slot,JSON.stringify({participant:this.participant,results:t,setting:this.setting})):this.app.storage?.removeItem(this.slot)}catch{this.app.say("This browser has no room to keep the session: finish it without closing the page")}}show(...t){this.panel.replaceChildren(...t),this.panel.classList.remove("strip"),this.panel.hidden=!1}start(t,e=[]){let{session:i,timeline:s}=this.app;s.stop(),i.trial=!0,this.before={work:i.snapshot(),history:i.history,options:{...i.options}},this.participant=t,this.results=e,this.setting={...this.setting,order:qc(t).join("-"),...this.app.identity()},this.trials=n_(t,i,this.sets().get(this.setting.targets)).slice(Math.floor(e.length/bs)*(bs+1)),this.trials.splice(1,e.length%bs),this.next()}next(){let t=this.trials.shift();if(!t){this.ask();return}let{session:e}=this.app;e.history=new Ms,e.select([]),e.clear(),this.neutral=Float32Array.from(e.deformer.points),this.targetPoints=Float32Array.from(e.deformer.pose(t.target)),e.reshape(),this.app.arrangeForTrial(t.name,this.targetPoints),this.running={...t,began:performance.now(),paused:0,edits:0,events:[]},this.hand.record(this.running.events);let i=t.face==="practice"?"practice, not counted":`${this.results.length+1} of ${lr[0].length*bs}`;this.show(U("span",{class:"strip-title"},Wc[t.name]),U("span",{class:"hint"},i),vt("Done","",()=>this.done(),{class:"primary"}),vt("Pause","",s=>this.pause(s.target)),vt("Stop","",()=>this.finish())),this.panel.classList.add("strip")}pause(t){let{running:e}=this,i=performance.now();e.since&&(e.paused+=i-e.since),e.since=e.since?0:i,this.app.node.classList.toggle("paused",!!e.since),t.textContent=e.since?"Go on":"Pause"}done(){let{session:t,view:e}=this.app;this.running.since&&this.pause(U("i"));let{target:i,began:s,paused:r,events:o,...a}=this.running;this.running=null,a.face!=="practice"&&(this.results.push({...a,seconds:(performance.now()-s-r)/1e3,paused:r/1e3,facePixels:e.faceHeight(a.name==="face"?"controls":"clean"),targetPixels:e.faceHeight("target"),window:`${window.innerWidth}x${window.innerHeight}@${window.devicePixelRatio}`,device:this.hand.device,events:o.map(l=>({...l,at:l.at-s})),controls:[...i.keys()].filter(l=>i[l]!==t.rest[l]).length,weightError:Af(t.values,i,t.rest,t.controls.map(({minimum:l,maximum:c})=>c-l)),vertexError:Af(t.deformer.points,this.targetPoints,this.neutral)}),this.keep(this.results)),this.next()}finish(){this.leave(),this.results.length?this.thank({}):this.close()}leave(){this.running=null,this.hand.record(null),this.app.node.classList.remove("paused"),this.app.session.trial&&this.app.endTrials(this.before)}ask(){this.leave();let t=Object.entries(Qy).map(([s,[r,o,a]])=>{let l=[1,2,3,4,5].map(c=>U("label",{},U("input",{type:"radio",name:s,value:c,required:!0,"aria-label":`${r}: ${c} of 5`}),String(c)));return U("fieldset",{class:"question"},U("legend",{},r),U("span",{class:"hint"},o),...l,U("span",{class:"hint"},a))}),e=U("textarea",{"aria-label":"What else you would like to say",placeholder:"What else you would like to say",rows:2}),i=U("form",{class:"questions",onsubmit:s=>{s.preventDefault();let r=Object.fromEntries([...new FormData(i)].map(([o,a])=>[o,Number(a)]));this.thank(e.value.trim()?{...r,comment:e.value.trim()}:r)}},...t,e,tn(U("button",{type:"submit",class:"primary"},"Done")));this.show(U("h2",{},"How was it?"),i)}thank(t){let e=s_(this.participant,this.results,t,this.setting),i=()=>{An(`evaluation-${this.participant}.csv`,e,"text/csv"),Object.keys(t).length&&this.keep(null)};this.show(U("h2",{},"Thank you"),this.summary(),tn(vt("Save CSV","",i,{class:"primary"}),vt("Save events","",()=>An(`events-${this.participant}.csv`,r_(this.participant,this.results),"text/csv")),vt("Close","",()=>this.close())))}summary(){let t=Object.entries(Wc).map(([i,s])=>{let r=this.results.filter(c=>c.name===i),o=c=>r.length?(r.reduce((h,u)=>h+u[c],0)/r.length).toFixed(3):"–",a=Yc(r),l=[s,`${a.toFixed(0)} s`,`${Math.round(100*a/Yc(this.results))} %`,o("weightError"),o("vertexError")];return U("tr",{},...l.map(c=>U("td",{},c)))}),e=["","Time","Share","Weight error","Vertex error"].map(i=>U("th",{},i));return U("table",{},U("tr",{},...e),...t)}close(){this.panel.hidden=!0}};function Zc(n){let t=xi(n,ir(n,n.values));return`${JSON.stringify({usdrigui:"pose",root:n.character.root,values:t},null,2)}
`}function Lf(n,t){let e=fn(n,void 0);if(e===void 0)throw new Error("This is not JSON.");let i=e?.values??e;if(i===null||typeof i!="object"||Array.isArray(i))throw new Error("This JSON holds no pose.");let s=Un(i,t.controls);if(!s.size&&Object.keys(i).length)throw new Error("No control of this character is named in the pose.");return fs(t,{values:s}).entries()}var cr=256,Nf=.75;function Df({pupil:n,iris:t,white:e,radii:i}){let s=new Float32Array(3*cr);for(let r=0;r<cr;r++){let o=(r+.5)*Nf/cr,a=1-.6*bi(.75*i[1],i[1],o),l=bi(i[0]-.015,i[0]+.015,o),c=bi(i[1]-.025,i[1]+.025,o);for(let h=0;h<3;h++){let u=n[h]+l*(a*t[h]-n[h]);s[3*r+h]=(u+c*(e[h]-u))/e[h]}}return{factors:s,perRadius:cr/Nf,last:cr-1}}function Of(n,t){let e=new Uint8Array(n.length/3);for(let i=0,s=0;i<n.length;i+=3,s++)e[s]=[0,1,2].every(r=>Math.abs(t[2*n[i+r]])<3)?1:0;return e}function bi(n,t,e){let i=Vt((e-n)/(t-n),0,1);return i*i*(3-2*i)}var Bf="#1f2124",Ff=-14409441,Jc=[-.4,.52,.755],jc=[.7,-.05,.71],Ze=5,o_=.3,Uf=1/16,a_=1e-4,Qc=.5,th=254,eh=.5,hr=.001,wi=class{pixels;nearness;tiles;across;wide;high;box;size;constructor(t,e){this.canvas=t,this.pen=t.getContext("2d",{alpha:!1}),this.surface=e,this.left=0,this.top=0,this.screen=null,this.before=null,this.colours=null,this.changed=null,this.used=Uint32Array.from(new Set(e.triangles)),this.mapped=new Float64Array(7),this.view=[],this.resize(1,1,1)}resize(t,e,i){this.ratio=i,this.size=[t,e],this.wide=Math.max(1,Math.round(t*i)),this.high=Math.max(1,Math.round(e*i)),this.image=this.pen.createImageData(this.wide,this.high),this.pixels=new Int32Array(this.image.data.buffer),this.nearness=new Float32Array(this.pixels.length),this.across=(this.wide>>Ze)+1,this.tiles=new Uint8Array(this.across*((this.high>>Ze)+1)),this.box=null,this.view=[]}draw(t,e,i){let s=t.map(i),r=this.seesAgain(t,e,s);r||this.wipe();let o=[1/0,1/0,0,0];t.forEach((a,l)=>{if(!s[l])return;this.prepare(s[l],a,e),r&&this.isMuch()&&(r=!1,this.wipe()),r&&this.wipeMoved();let c=this.frameOf(a);o=this.extended(o,c),this.fill(c)}),this.show(this.cover(o)&&r)}extended(t,e){let i=c_(this.screen,this.used);return[0,1,2,3].map(s=>{let[r,o]=s<2?[Math.max,Math.min]:[Math.min,Math.max];return o(t[s],r(e[s],i[s]))})}cover(t){let{ratio:e,canvas:i,wide:s,high:r}=this,o=ao(t.map(a=>a/e),this.box,this.size);return o===this.box?!0:(this.box=o,[this.left,this.top]=[Math.round(o[0]*e),Math.round(o[1]*e)],i.width=Math.max(1,Math.min(s,Math.round(o[2]*e))-this.left),i.height=Math.max(1,Math.min(r,Math.round(o[3]*e))-this.top),lo(i,o),!1)}isMuch(){let{changed:t}=this;return t.reduce((e,i)=>e+i,0)>o_*t.length}seesAgain(t,{position:e,right:i,above:s},r){let o=r[0]?[r[0].points,r[0].colours]:[],a=[t.length,...t.flatMap(({left:c,top:h,width:u,height:d})=>[c,h,u,d]),...e,...i,...s,...o],l=t.length===1&&wn(a,this.view);return this.view=a,l}prepare(t,e,i){let{length:s}=t.points;[this.screen,this.before]=[this.before??new Float32Array(s),this.screen??new Float32Array(s)],(this.changed??=new Uint8Array(s/3)).fill(0),this.paint=t.paint,this.project(t.points,e,i),this.light(t,i)}wipe(){this.pixels.fill(Ff),this.nearness.fill(0),this.tiles.fill(1)}wipeMoved(){let{changed:t,tiles:e,across:i,wide:s,high:r,pixels:o,nearness:a}=this,{triangles:l}=this.surface;e.fill(0);for(let c=0;c<l.length;c+=3)t[l[c]]|t[l[c+1]]|t[l[c+2]]&&(this.markTiles(this.before,c),this.markTiles(this.screen,c));for(let c=0;c<e.length;c++){if(!e[c])continue;let h=c%i<<Ze,u=Math.floor(c/i)<<Ze,d=Math.min(s,h+(1<<Ze)),f=Math.min(r,u+(1<<Ze));for(let p=u;p<f;p++)o.fill(Ff,p*s+h,p*s+d),a.fill(0,p*s+h,p*s+d)}}markTiles(t,e){let{tiles:i,across:s,wide:r,high:o}=this,{triangles:a,facing:l}=this.surface,c=3*a[e],h=3*a[e+1],u=3*a[e+2],d=t[c],f=t[c+1],p=t[h],x=t[h+1],m=t[u],g=t[u+1];if(l[e/3]*((p-d)*(g-f)-(x-f)*(m-d))>0)return;let _=Math.max(0,Math.ceil(Math.min(d,p,m)))>>Ze,w=Math.min(r-1,Math.floor(Math.max(d,p,m)))>>Ze,y=Math.max(0,Math.ceil(Math.min(f,x,g)))>>Ze,E=Math.min(o-1,Math.floor(Math.max(f,x,g)))>>Ze;for(let S=y;S<=E;S++)for(let v=_;v<=w;v++)i[S*s+v]=1}isOpen(t,e,i,s){let{tiles:r,across:o}=this;for(let a=i>>Ze;a<=s>>Ze;a++)for(let l=t>>Ze;l<=e>>Ze;l++)if(r[a*o+l])return!0;return!1}show(t){let{canvas:e,left:i,top:s}=this,[r,o,a,l]=t?this.openTiles():[i,s,i+e.width,s+e.height];a>r&&this.pen.putImageData(this.image,-i,-s,r,o,a-r,l-o)}openTiles(){let{tiles:t,across:e}=this,[i,s,r,o]=[1/0,1/0,0,0];return t.forEach((a,l)=>{if(!a)return;let[c,h]=[l%e,Math.floor(l/e)];[i,s,r,o]=[Math.min(i,c),Math.min(s,h),Math.max(r,c+1),Math.max(o,h+1)]}),[i,s,r,o].map(a=>a<<Ze)}frameOf({left:t,top:e,width:i,height:s}){let{wide:r,high:o,ratio:a}=this,l=(c,h)=>Vt(Math.round(c*a),0,h);return[l(t,r),l(e,o),l(t+i,r),l(e+s,o)]}project(t,e,{position:i,right:s,above:r,towards:o,half:a}){let{screen:l,before:c,changed:h}=this,u=this.ratio*e.height/(2*a),d=this.ratio*(e.left+e.width/2)-.5,f=this.ratio*(e.top+e.height/2)-.5,[p,x,m]=i,[g,_,w]=s,[y,E,S]=r,[v,A,L]=o;for(let T=0;T<t.length;T+=3){let I=t[T]-p,D=t[T+1]-x,F=t[T+2]-m,R=-(I*v+D*A+F*L),k=R>1e-9?1/R:0,W=d+(I*g+D*_+F*w)*k*u,z=f-(I*y+D*E+F*S)*k*u;if(Math.abs(W-c[T])<Uf&&Math.abs(z-c[T+1])<Uf&&Math.abs(k-c[T+2])<=a_*k){l[T]=c[T],l[T+1]=c[T+1],l[T+2]=c[T+2];continue}l[T]=W,l[T+1]=z,l[T+2]=k,h[T/3]=1}}light({points:t,normals:e,paint:i,colours:s},{position:r,right:o,above:a,towards:l}){let c=this.colours??=new Float32Array(t.length),{changed:h}=this,[u,d,f]=o,[p,x,m]=a,[g,_,w]=l;for(let y=0,E=0;y<t.length;y+=3,E+=4){let S=Math.sqrt(e[y]*e[y]+e[y+1]*e[y+1]+e[y+2]*e[y+2]),v=S>0?1/S:0,A=v*(e[y]*u+e[y+1]*d+e[y+2]*f),L=v*(e[y]*p+e[y+1]*x+e[y+2]*m),T=v*(e[y]*g+e[y+1]*_+e[y+2]*w);T<.1&&h_(e,t,y,v,r)&&(A=-A,L=-L,T=-T);let I=Math.max(0,A*Jc[0]+L*Jc[1]+T*Jc[2]),D=Math.max(0,A*jc[0]+L*jc[1]+T*jc[2]),F=.5+.5*L,R=1-Math.abs(T),k=R*R*R*.035,W=s[y],z=s[y+1],tt=s[y+2];i[E]>2&&([W,z,tt]=f_(i[E]/255,[W,z,tt])),W=Qc+th*Math.min(1,W*Math.sqrt(.2*F+.8*I+.2*D)+k),z=Qc+th*Math.min(1,z*Math.sqrt(.21*F+.77*I+.22*D)+k),tt=Qc+th*Math.min(1,tt*Math.sqrt(.23*F+.73*I+.26*D)+k),!(Math.abs(c[y]-W)<eh&&Math.abs(c[y+1]-z)<eh&&Math.abs(c[y+2]-tt)<eh)&&(c[y]=W,c[y+1]=z,c[y+2]=tt,h[y/3]=1)}}fill(t){let{screen:e}=this,{triangles:i,facing:s,eyes:r,texturing:o}=this.surface,a=o?.on,[l,c,h,u]=t;for(let d=0,f=0;d<i.length;d+=3,f++){let p=3*i[d],x=3*i[d+1],m=3*i[d+2],g=e[x]-e[p],_=e[x+1]-e[p+1],w=e[m]-e[p],y=e[m+1]-e[p+1],E=g*y-_*w;if(s[f]*E>0||E===0||e[p+2]===0||e[x+2]===0||e[m+2]===0)continue;let S=Math.max(l,Math.ceil(Math.min(e[p],e[x],e[m]))),v=Math.min(h-1,Math.floor(Math.max(e[p],e[x],e[m])));if(S>v)continue;let A=Math.max(c,Math.ceil(Math.min(e[p+1],e[x+1],e[m+1]))),L=Math.min(u-1,Math.floor(Math.max(e[p+1],e[x+1],e[m+1])));A>L||!this.isOpen(S,v,A,L)||(r[f]?this.eye(p,x,m,1/E,S,v,A,L):this.triangle(p,x,m,1/E,S,v,A,L,a?.[f]?d:-1))}}triangle(t,e,i,s,r,o,a,l,c){let{screen:h,colours:u,pixels:d,nearness:f,wide:p}=this,x=h[t],m=h[t+1],g=(h[i+1]-m)*s,_=(x-h[i])*s,w=(m-h[e+1])*s,y=(h[e]-x)*s,E=h[t+2],S=h[e+2]-E,v=h[i+2]-E,A=g*S+w*v,L=_*S+y*v,T=256*u[t],I=256*u[e]-T,D=256*u[i]-T,F=g*I+w*D,R=_*I+y*D,k=256*u[t+1],W=256*u[e+1]-k,z=256*u[i+1]-k,tt=g*W+w*z,q=_*W+y*z,Q=256*u[t+2],et=256*u[e+2]-Q,_t=256*u[i+2]-Q,Dt=g*et+w*_t,K=_*et+y*_t,pt=tt|0,yt=((Dt|0)<<16)+(F|0)|0,{mapped:St}=this;c>=0&&this.mapping(t,e,i,c,g,_,w,y);let ht=t,It=e,ae=i,Ct=0;h[It+1]<h[ht+1]&&(Ct=ht,ht=It,It=Ct),h[ae+1]<h[It+1]&&(Ct=It,It=ae,ae=Ct),h[It+1]<h[ht+1]&&(Ct=ht,ht=It,It=Ct);let $t=h[ht],Kt=h[ht+1],Bt=h[It],ge=h[It+1],_e=h[ae],Fe=h[ae+1],le=(_e-$t)/(Fe-Kt),dn=(Bt-$t)/(ge-Kt),Se=(_e-Bt)/(Fe-ge),$e=$t+(ge-Kt)*le<Bt;for(let fe=a;fe<=l;fe++){let Ye=$t+(fe-Kt)*le,O=fe<ge?$t+(fe-Kt)*dn:Bt+(fe-ge)*Se,Ue=Math.max(r,Math.ceil(($e?Ye:O)-hr)),ie=Math.min(o,Math.floor(($e?O:Ye)+hr));if(!(Ue<=ie))continue;let Qt=Ue-x,rt=fe-m,pe=E+Qt*A+rt*L,Rt=k+Qt*tt+rt*q|0,Lt=(Q+Qt*Dt+rt*K<<16)+(T+Qt*F+rt*R|0)|0;if(c>=0){let C=St[0]+Qt*St[1]+rt*St[2]|0,M=St[3]+Qt*St[4]+rt*St[5]|0;this.texturedRow(fe*p+Ue,fe*p+ie,pe,A,Rt,pt,Lt,yt,C,St[1]|0,M,St[4]|0,St[6]);continue}for(let C=fe*p+Ue,M=fe*p+ie;C<=M;C++)pe>f[C]&&(f[C]=pe,d[C]=-16777216|Lt>>>8&16711935|Rt&65280),pe+=A,Rt=Rt+pt|0,Lt=Lt+yt|0}}mapping(t,e,i,s,r,o,a,l){let{mapped:c,paint:h}=this,{corners:u,places:d,width:f,height:p}=this.surface.texturing,x=2*u[s],m=2*u[s+1],g=2*u[s+2];for(let w=0;w<2;w++){let y=65536*(w?p:f),E=y*d[x+w],S=y*d[m+w]-E,v=y*d[g+w]-E;c[3*w]=E,c[3*w+1]=r*S+a*v,c[3*w+2]=o*S+l*v}let _=h[4*t/3]+h[4*e/3]+h[4*i/3];c[6]=_>8?Math.round(255*.85*bi(.01,.2,_/765)):0}texturedRow(t,e,i,s,r,o,a,l,c,h,u,d,f){let{pixels:p,nearness:x}=this,{texels:m,width:g}=this.surface.texturing;for(;t<=e;t++){if(i>x[t]){let _=m[(u>>16)*g+(c>>16)];if(_<0){x[t]=i,f&&(_=l_(_,f));let w=(_>>16&255)*(a>>>16)&16711680,y=(_>>8&255)*r>>8&65280;p[t]=-16777216|w|y|(_&255)*(a&65535)>>16}}i+=s,r=r+o|0,a=a+l|0,c=c+h|0,u=u+d|0}}eye(t,e,i,s,r,o,a,l){let{screen:c,colours:h,pixels:u,nearness:d,surface:f}=this,{gaze:p,tints:x}=f,{factors:m,perRadius:g,last:_}=x,[w,y,E]=[2*t/3,2*e/3,2*i/3],S=(c[i+1]-c[t+1])*s,v=(c[t]-c[i])*s,A=(c[t+1]-c[e+1])*s,L=(c[e]-c[t])*s;for(let T=a;T<=l;T++){let I=(r-c[t])*S+(T-c[t+1])*v,D=(r-c[t])*A+(T-c[t+1])*L;for(let F=r,R=T*this.wide+r;F<=o;F++,R++,I+=S,D+=A){let k=1-I-D;if(k<-hr||I<-hr||D<-hr)continue;let W=k*c[t+2]+I*c[e+2]+D*c[i+2];if(W<=d[R])continue;d[R]=W;let z=k*p[w]+I*p[y]+D*p[E],tt=k*p[w+1]+I*p[y+1]+D*p[E+1],q=3*Math.min(_,Math.floor(Math.sqrt(z*z+tt*tt)*g)),Q=m[q]*(k*h[t]+I*h[e]+D*h[i]),et=m[q+1]*(k*h[t+1]+I*h[e+1]+D*h[i+1]),_t=m[q+2]*(k*h[t+2]+I*h[e+2]+D*h[i+2]);u[R]=-16777216|_t<<16|et<<8|Q}}}};function l_(n,t){let e=i=>((n>>i&255)*(255-t)+255*t)/255;return-16777216|e(16)<<16|e(8)<<8|e(0)}function c_(n,t){let e=new Float64Array([1/0,1/0,-1/0,-1/0]);for(let i=0;i<t.length;i++){let s=n[3*t[i]],r=n[3*t[i]+1];s<e[0]&&(e[0]=s),r<e[1]&&(e[1]=r),s>=e[2]&&(e[2]=s+1),r>=e[3]&&(e[3]=r+1)}return e}function h_(n,t,e,i,s){let r=t[e]-s[0],o=t[e+1]-s[1],a=t[e+2]-s[2];return i*(n[e]*r+n[e+1]*o+n[e+2]*a)>.3*Math.sqrt(r*r+o*o+a*a)}var kf=[.2,.24,.62],u_=[.78,.2,.44],d_=[1,.82,.3];function f_(n,t){let e=.85*bi(.01,.2,n),i=bi(0,.5,n),s=bi(.45,1,n);return t.map((r,o)=>{let a=kf[o]+i*(u_[o]-kf[o]);return r+e*(a+s*(d_[o]-a)-r)})}var Gn=112,p_=2;function zf(n,t){let{character:e,section:i,elements:s}=n,r=new zn(e.up,i.view),a=s.list.filter(m=>n.isShown(m)&&!m.onBoard).map(({restPoint:m})=>m);r.frame(a.length?a:[...m_(t.skin.points)],Gn,Gn,1.35);let l=new wi(U("canvas"),t);l.resize(Gn,Gn,p_),t.refresh();let c={...t.skin,paint:new Uint8Array(t.skin.paint.length)};l.draw([{left:0,top:0,width:Gn,height:Gn}],r,()=>c);let h=U("canvas",{width:Gn,height:Gn}),u=h.getContext("2d"),[d,f,p,x]=l.box;return u.fillStyle=Bf,u.fillRect(0,0,Gn,Gn),u.drawImage(l.canvas,d,f,p-d,x-f),h.toDataURL("image/jpeg",.85)}function*m_(n){for(let t=0;t<n.length;t+=3)yield n.subarray(t,t+3)}var Oo=class{constructor(t,e,i){this.session=t,this.view=e,this.say=i,this.share=1,this.grid=U("div",{class:"shelf"}),this.saving=vt("Save shelf","Download the poses as a USD layer",()=>this.save()),this.node=U("div",{},this.grid,this.amount(),tn(vt("Keep pose","Put the pose of the selection, or of all controls, on the shelf",()=>this.keep()),this.saving,vt("Open…","Add the poses of a layer saved before",()=>this.open()))),t.on("time",()=>this.update()),this.update()}amount(){let t=so({min:0,max:100,title:"How far a click goes from the present pose to the kept one","aria-label":"Share of the pose"},()=>100*this.share,e=>{this.share=e/100,t.update()});return t.update(),vi("Share",t)}update(){let{shelf:t}=this.session;if(this.shown===t)return;this.shown=t,this.saving.disabled=!t.length;let e=be("No poses yet. Keep the present one; a click on its picture gives it back.");this.grid.replaceChildren(...t.length?t.map(i=>this.item(i)):[e])}item(t){let e=U("input",{type:"text",value:t.name,"aria-label":`Name of the pose ${t.name}`,onchange:()=>this.put("Rename a pose",this.session.shelf.map(s=>s===t?{...t,name:e.value||t.name}:s))}),i=`${t.name}: ${he(t.values.size,"control")}`;return U("div",{class:"pose"},vt(t.picture?U("img",{src:t.picture,alt:""}):null,i,()=>this.take(t),{class:"pose-picture","aria-label":`Take the pose ${t.name}`}),e,vt("×","Take it off the shelf",()=>this.put("Take a pose off the shelf",this.session.shelf.filter(s=>s!==t)),{class:"pose-away","aria-label":`Take ${t.name} off the shelf`}))}put(t,e){this.session.put(t,{shelf:e})}keep(){let{session:t}=this,e=zf(t,this.view.stage),i=g_(`pose ${t.shelf.length+1}`,t.shelf);this.put("Keep a pose",[...t.shelf,{name:i,values:t.copy(),picture:e}])}take({name:t,values:e}){let{session:i}=this,s=new Set(i.selection.size?i.chosenControls:[]),r=[...e].filter(([a])=>s.has(a)),o=(r.length?r:[...e]).map(([a,l])=>[a,i.values[a]+this.share*(l-i.values[a])]);i.asWritten(`Pose ${t}`,o)}save(){this.session.save("poses.usda",pf(this.session,this.session.shelf),this.say)}open(){return _i(".usda,.usd",this.say,({name:t,text:e})=>{let i=mf(e,this.session);this.put(`Open ${t}`,[...this.session.shelf,...i]),this.say(`${he(i.length,"pose")} added`)})}};function g_(n,t){let e=new Set(t.map(i=>i.name));for(let i=2,s=n;;s=`${n} (${i++})`)if(!e.has(s))return s}var Fo=class{constructor(t,e){this.session=t,this.others=e,this.seen=[];let i=0,s=[t,...e].flatMap(({character:r})=>{let o=i;return i+=r.pointCount,r.meshes.map(a=>({...a,start:o+a.start}))});this.character={...t.character,meshes:s,pointCount:i},this.points=new Float32Array(3*i),t.deformer.points=this.points.subarray(0,t.deformer.points.length),t.showBase(),t.reshape(),this.follow()}follow(){let{session:{character:t,frame:e,neutral:i,deformer:s},others:r,points:o}=this,a=[e,i,...r.flatMap(({keys:h,constants:u})=>[h,u])];if(wn(a,this.seen))return;this.seen=a;let l=vs(Gf(t,e))??xs,c=s.points.length;for(let h of r){let{values:u,weights:d,locals:f}=i?{values:h.rest,weights:null,locals:null}:h.animation.at(e,{keys:h.keys,constants:h.allConstants()});h.deformer.setBase(d,f);let p=h.deformer.pose(u);o.set(p,c),ei.forEach(o,3,c,p.length/3,ei.transformMat4,en(Gf(h.character,e),l)),c+=p.length}}},Gf=({toWorld:n,timeCodes:t},e)=>n[Vt(Math.round(e-(t?.[0]??e)),0,n.length-1)];var ur=24,x_=2,v_=4,Uo=.02,y_=1.02,__=.25,M_=6,Wf=1e-9;function Xf(n,t,e,i,s){let r=n.members.map(({values:l},c)=>b_(l,n.tracks[c],h=>s(h).slice(0,2))),o=A_(n.axes.map(l=>w_(n,l,r,t,e))),a=o.map(({ends:l})=>sh(l,c=>i[c]));return{axes:o,start:a,current:a}}function qf(n,t,e){let i=n.axes.map((h,u)=>u).filter(h=>n.axes[h].follows),[s,r,o]=[n.axes,n.start,n.current].map(h=>i.map(u=>h[u])),a=s.reduce((h,u,d)=>oh(h,rh(u,r[d])),[t,e]),l=s.length>2?R_(s,r,o,a):T_(s,r,o,a);n.current=[...n.start],i.forEach((h,u)=>n.current[h]=l[u]);let c=new Map;return s.forEach(({ends:h},u)=>h.forEach(d=>c.set(d.control,ih(d,l[u])))),c}function ko(n,t,e,i,s,r){let o=Yf(n,n.axes[t],i,s),a=sh(o,l=>r[l])+e;return o.map(l=>[l.control,ih(l,a)])}function $f({axes:n},t){let e=n.map(({points:r,follows:o})=>{let a=Si(r.at(-1),r[0]),l=Math.hypot(...a);return o&&l?(a[0]*t[0]+a[1]*t[1])/l:0}),i=e.map(Math.abs),s=i.indexOf(Math.max(...i));return[s,e[s]<0?-1:1]}var Yf=(n,t,e,i)=>t.map((s,r)=>S_(n.members[s].control,t.length>1?2*r-1:0,e,i));function b_(n,t,e){let i=t.map((o,a)=>({value:n[a],point:o,at:e(o)})),s=[i[0]],r=(o,a,l)=>{let c=o.point.map((d,f)=>Ce(d,a.point[f],.5)),h={value:Ce(o.value,a.value,.5),point:c,at:e(c)},u=h.at.map((d,f)=>d-Ce(o.at[f],a.at[f],.5));!l||Math.hypot(...u)<=__?s.push(a):(r(o,h,l-1),r(h,a,l-1))};return i.slice(1).forEach((o,a)=>r(i[a],o,M_)),{values:s.map(({value:o})=>o),points:s.map(({at:o})=>o)}}function w_(n,t,e,i,s){let r=Yf(n,t,i,s),o=sh(r,d=>s[d]),a=r.flatMap((d,f)=>e[t[f]].values.map(p=>d.sign*Kf(d,p))),l=[o,...r.flatMap(({sign:d})=>[0,d]),...a].sort((d,f)=>d-f),c=l.filter((d,f)=>f+1===l.length||l[f+1]-d>Wf),h=(d,f)=>Sn(e[t[d]].values,e[t[d]].points,f),u=d=>(f,p,x)=>oh(f,Si(h(x,ih(p,d)),h(x,p.base)));return{ends:r,base:o,at:c,points:c.map(d=>r.reduce(u(d),[0,0])),follows:!0}}function S_(n,t,e,i){let{minimum:s,default:r,maximum:o}=e[n],a=i[n];return t===0?{control:n,sign:1,off:s,far:o,base:a}:{control:n,sign:t,off:r,far:Bo(e[n]),base:a}}var Bo=({minimum:n,default:t,maximum:e})=>e-t>=t-n?e:n;function ih({sign:n,off:t,far:e,base:i},s){let r=Vt(n*s,0,1),o=Ce(t,e,r);return Math.abs(o-i)<=1e-12*Math.abs(e-t)?i:o}var Kf=({off:n,far:t},e)=>t===n?0:Vt((e-n)/(t-n),0,1),sh=(n,t)=>n.reduce((e,i)=>e+i.sign*Kf(i,t(i.control)),0);function A_(n){let t=n.map(({points:r})=>as(r)),e=Math.max(...t),i=(r,o)=>t[r]>=o/4;if(e>=ur/4)return n.map((r,o)=>({...r,follows:i(o,ur)}));if(n.length===1)return[E_(n[0])];if(e<1)return n.map(r=>({...r,follows:!1}));let s=([r,o])=>[r*ur/e,o*ur/e];return n.map((r,o)=>({...r,points:r.points.map(s),follows:i(o,e)}))}function E_(n){let t=Si(n.points.at(-1),n.points[0]),e=Math.hypot(...t),[i,s]=e>=1?[t[0]/e,t[1]/e]:[0,-1],r=n.at.map(o=>ur*(o-n.base)/(n.at.at(-1)-n.at[0]));return{...n,points:r.map(o=>[o*i,o*s])}}var Vf={ends:[],base:0,at:[0,1],points:[[0,0],[0,0]]};function T_(n,t,e,i){if(n.length===2)return nh(n,t,e,i).at;let[s=Vf]=n;return nh([s,Vf],[...t,0,0],[...e,0,0],i).at.slice(0,n.length)}function nh([n,t],e,i,s){let r=n.at.slice(1).map((c,h)=>t.at.slice(1).map((u,d)=>C_(n,t,h,d,e,s))),a=r.flat().reduce((c,h)=>h.away<c.away?h:c),l=r[to(n.at,i[0])][to(t.at,i[1])];for(let c=Hf(r,l);c!==l;c=Hf(r,l))l=c;return l.away>x_*a.away+v_?a:l}function Hf(n,t){return n.slice(Math.max(0,t.i-1),t.i+2).flatMap(i=>i.slice(Math.max(0,t.j-1),t.j+2)).reduce((i,s)=>s.away<i.away?s:i,t)}function C_(n,t,e,i,s,r){let o=[...Si(n.points[e+1],n.points[e]),Uo*(n.at[e+1]-n.at[e]),0],a=[...Si(t.points[i+1],t.points[i]),0,Uo*(t.at[i+1]-t.at[i])],c=[...Si(oh(n.points[e],t.points[i]),r),Uo*(n.at[e]-s[0]),Uo*(t.at[i]-s[1])],[h,u,d,f,p]=[Et(o,o),Et(a,a),Et(o,a),Et(c,o),Et(c,a)],x=Math.max(h*u-d*d,1e-300),m=[[(d*p-u*f)/x,(d*f-h*p)/x],[-f/h,0],[-(f+d)/h,1],[0,-p/u],[1,-(p+d)/u]],g={away:1/0};for(let _ of m){let[w,y]=_.map(S=>Vt(S,0,1)),E=Math.hypot(...c.map((S,v)=>S+w*o[v]+y*a[v]));E<g.away&&(g={away:E,i:e,j:i,at:[Ce(n.at[e],n.at[e+1],w),Ce(t.at[i],t.at[i+1],y)]})}return g}function R_(n,t,e,i){let s=(c,h)=>Math.abs(e[c]-n[c].base)>Wf&&e[c]>n[c].base===h,r=n.filter((c,h)=>s(h,!0)||s(h,!1)).length,o=c=>c.filter(({i:h,arm:u})=>s(h,u.at.at(-1)>n[h].base)).length===r,a=I_(n),l={away:1/0,set:e};for(let c of[...a.filter(o),...a.filter(h=>!o(h))]){let h=c.map(({i:m})=>m),d=n.filter((m,g)=>!h.includes(g)).reduce((m,g)=>Si(m,rh(g,g.base)),i),f=c.map(({i:m,arm:g})=>Vt(e[m],g.at[0],g.at.at(-1))),p=nh(c.map(({arm:m})=>m),h.map(m=>t[m]),f,d);if(p.away*y_+1e-6>=l.away)continue;let x=n.map((m,g)=>h.includes(g)?p.at[h.indexOf(g)]:m.base);l={away:p.away,set:x}}return l.set}function I_(n){let e=n.flatMap((s,r)=>P_(s).map(o=>({i:r,arm:o,angle:L_(o,rh(s,s.base))}))).sort((s,r)=>s.angle-r.angle);return e.map((s,r)=>[s,e[(r+1)%e.length]]).filter(([s,r])=>s.i!==r.i&&(r.angle-s.angle+2*Math.PI)%(2*Math.PI)<Math.PI)}function P_(n){let t=n.at.map(s=>Math.abs(s-n.base)),e=t.indexOf(Math.min(...t)),i=(s,r)=>({at:n.at.slice(s,r),points:n.points.slice(s,r)});return[i(0,e+1),i(e)].filter(({at:s})=>s.length>1)}function L_(n,t){let i=n.points.map(s=>Si(s,t)).reduce((s,r)=>Et(r,r)>Et(s,s)?r:s);return Math.atan2(i[1],i[0])}var rh=(n,t)=>Sn(n.at,n.points,t),oh=(n,t)=>[n[0]+t[0],n[1]+t[1]],Si=(n,t)=>[n[0]-t[0],n[1]-t[1]];var N_=.01,Jf=.5,D_=3,O_=.15,F_=2,U_=1e3,jf=1e-9;function Qf({model:n,start:t,now:e,targets:i,groups:s,towards:r,locality:o}){let a=p=>ep(i.map((x,m)=>x-p[m]),r),l=null,c=null,h=null,u=[Float64Array.from(e)];for(let p=0;p<F_;p++){let x=n.linearise(u[p]);if(c??=H_(n,s,x,o),!c.length)return new Map;l=W_(n,x,t,u[p],a(x.at),c,r),h=h?zo(l,fr(l,h.held,h.rest)):K_(l),u.push(B_(n,t,c,k_(l,h).x))}let d=[...G_(n,t,c)?[]:[t],...u.slice(1)],f=ip(d,p=>V_(l,c,t,p,a(n.linearise(p).at)));return new Map(s.flat().map(p=>[p,f[p]]))}function k_(n,{held:t,rest:e}){let[i,s]=[e.subarray(0,3),.5*Jf*dr(n.right.subarray(0,3))],r=Math.min(1,s/Math.max(dr(i),1e-30)),o={...n,right:n.right.map((a,l)=>a+(l<3?r:1)*e[l])};return zo(o,fr(o,t,e))}function B_(n,t,e,i){let s=Float64Array.from(t);return e.forEach((r,o)=>{for(let a of r){let l=Vt(t[a]+i[o],n.minimum(a),n.maximum(a));s[a]=z_(n,a,l)?n.off(a):l}}),s}var z_=(n,t,e)=>n.opposites(t).length>0&&Math.abs(e-n.off(t))<=jf*(n.maximum(t)-n.minimum(t));function G_(n,t,e){let i=s=>t[s]!==n.off(s);return e.flat().some(s=>i(s)&&n.opposites(s).some(i))}function V_({ridge:n},t,e,i,s){return Et(s,s)+t.reduce((r,[o],a)=>r+n[a]*(i[o]-e[o])**2,0)}function tp(n,t,e,i){let s=new Float64Array(i),r=e.map(o=>{let a=t.motion(o);return a.forEach((l,c)=>s[c]+=l),Math.hypot(a[0],a[1],a[2])*(n.maximum(o)-n.minimum(o))});return{column:s,paths:r}}function H_(n,t,e,i){let s=t.map(l=>Math.max(...tp(n,e,l,e.at.length).paths)),r=i*s.reduce((l,c)=>Math.max(l,c),0),o=t.filter((l,c)=>s[c]>0&&s[c]>=r),a=new Set(o.flat().flatMap(l=>n.opposites(l)));return t.filter(l=>o.includes(l)||l.some(c=>a.has(c)))}var ah=(n,t)=>Math.max(...t.map(e=>n.maximum(e)-n.minimum(e)));function ep(n,t){let e=t?(1-O_)*Et(t,n):0;return Float64Array.from(n,(i,s)=>e&&s<3?i-e*t[s]:i)}function W_(n,t,e,i,s,r,o){let a=r.map(f=>tp(n,t,f,t.at.length)),l=a.map(({column:f})=>ep(f,o)),c=Float64Array.from(s);r.forEach(([f],p)=>{for(let x=0;x<c.length;x++)c[x]+=l[p][x]*(i[f]-e[f])});let h=Math.max(...a.flatMap(({paths:f})=>f)),u=r.map((f,p)=>q_(n,f,a[p].paths)*(h/ah(n,f))**2),d=$_(n,r,e);return{columns:l,right:c,ridge:u,...d,sparse:X_(n,r,l,c,d),pairs:Y_(n,r)}}function X_(n,t,e,i,{lower:s,upper:r}){let o=(l,c)=>{let h=Et(l,i);return(h>0?r[c]>0:s[c]<0)?Math.abs(h)*ah(n,t[c]):0},a=Math.max(...e.map(o));return t.map(l=>Jf*a/ah(n,l))}function q_(n,t,e){return t.reduce((i,s,r)=>{let o=Math.min(1,e[r]/Math.max(n.peak(s),1e-30));return i+N_*(1+D_*(1-o)**2)},0)}function $_(n,t,e){let i=(a,l)=>a.map(c=>n[l](c)-e[c]),s=t.map(a=>Math.max(...i(a,"minimum"))),r=t.map(a=>Math.min(...i(a,"maximum"))),o=t.map((a,l)=>n.opposites(a[0]).length?n.off(a[0])===n.minimum(a[0])?s[l]=Math.min(...i(a,"off")):r[l]=Math.max(...i(a,"off")):0);return{lower:s,upper:r,off:o}}function Y_(n,t){let e=new Map;t.forEach((s,r)=>s.forEach(o=>e.set(o,r)));let i=[];return t.forEach((s,r)=>{let o=new Set;for(let a of s)for(let l of n.opposites(a))o.add(e.get(l));for(let a of o)a>r&&i.push([r,a])}),i}function K_(n){let t=fr(n,[],null),e=zo(n,t),i=U_;for(let s=[t];s.length&&i>0;){let r=s.pop();if(r.cost>=e.cost)continue;let o=J_(n,r.x);o?s.push(...o.map(a=>fr(n,[...r.held,a],r.rest)).sort((a,l)=>l.cost-a.cost)):e=r,i-=2*n.columns.length}return e}function zo(n,t){let e=np(n,t.x);if(!e.length)return t;let i=e.map(([s,r])=>lh(n,t.x,s)<lh(n,t.x,r)?s:r);return zo(n,fr(n,[...t.held,...i],t.rest))}function fr(n,t,e){let[i,s]=[[...n.lower],[...n.upper]];for(let o of t)i[o]=s[o]=n.off[o];let r=j_({...n,lower:i,upper:s},e);return{held:t,...r,cost:sM(n,r.x)}}var lh=({columns:n,off:t},e,i)=>Math.abs(e[i]-t[i])*Math.sqrt(Et(n[i],n[i])),Z_=({lower:n,upper:t,off:e},i,s)=>Math.abs(i[s]-e[s])>jf*(t[s]-n[s]),np=(n,t)=>n.pairs.filter(e=>e.every(i=>Z_(n,t,i)));function J_(n,t){let e=i=>Math.min(...i.map(s=>lh(n,t,s)));return ip(np(n,t),i=>-e(i))}function ip(n,t){let[e,i]=[void 0,1/0];for(let s of n){let r=t(s);r<i&&([e,i]=[s,r])}return e}function j_(n,t=null){let e=Q_(n),{rows:i,right:s}=e,r=t??new Float64Array(i),o=Zf(e,r),a=1e-12*(dr(s)+dr(o.gradient));for(let l=0;l<100&&dr(o.gradient)>a;l++){let c=iM(tM(e,o.free),o.gradient.map(h=>-h));r=eM(e,r,c,o),o=Zf(e,r)}return{x:o.x,rest:r}}function Q_({columns:n,right:t,ridge:e,sparse:i,lower:s,upper:r}){let o=t.length,a=new Float64Array(n.length*o);for(let c=0,h=0;c<n.length;c++)for(let u=0;u<o;u++,h++)a[h]=n[c][u];let l=i?Float64Array.from(i,c=>.5*c):new Float64Array(n.length);return{rows:o,columns:a,right:t,slack:l,ridge:Float64Array.from(e),lower:Float64Array.from(s),upper:Float64Array.from(r)}}function sp({rows:n,columns:t,ridge:e},i){let s=new Float64Array(e.length);for(let r=0,o=0;r<s.length;r++){let a=0;for(let l=0;l<n;l++,o++)a+=t[o]*i[l];s[r]=a}return s}function Zf(n,t){let{rows:e,columns:i,right:s,slack:r,ridge:o,lower:a,upper:l}=n,c=sp(n,t),h=new Float64Array(c.length),u=new Float64Array(e),d=[];for(let f=0;f<e;f++)u[f]=t[f]-s[f];for(let f=0;f<h.length;f++){let p=rp(c[f],r[f])/o[f];if(h[f]=Vt(p,a[f],l[f]),h[f]===p&&p!==0&&l[f]>a[f]&&d.push(f),h[f]!==0)for(let x=0;x<e;x++)u[x]+=i[f*e+x]*h[f]}return{x:h,gradient:u,along:c,free:d}}function tM({rows:n,columns:t,ridge:e},i){let s=Array.from({length:n},()=>new Float64Array(n));s.forEach((r,o)=>r[o]=1);for(let r of i){let o=r*n;for(let a=0;a<n;a++){let l=s[a],c=t[o+a]/e[r];for(let h=0;h<=a;h++)l[h]+=c*t[o+h]}}return s}function eM(n,t,e,{along:i,gradient:s}){let r=sp(n,e),o=[Et(t,e)-Et(n.right,e),Et(e,e)],a=.1*Math.abs(Et(s,e)),[l,c,h]=[0,1/0,1];for(let u=0;u<=40;u++){let d=o[0]+h*o[1]+nM(n,i,r,h);if(Math.abs(d)<=a)break;d>0?c=h:l=h,h=c<1/0?(l+c)/2:2*h}return t.map((u,d)=>u+h*e[d])}function nM({slack:n,ridge:t,lower:e,upper:i},s,r,o){let a=0;for(let l=0;l<r.length;l++)a+=r[l]*Vt(rp(s[l]+o*r[l],n[l])/t[l],e[l],i[l]);return a}function iM(n,t){let e=t.length,i=n.map(r=>Float64Array.from(r));for(let r=0;r<e;r++){for(let a=0;a<r;a++)for(let l=r;l<e;l++)i[l][r]-=i[l][a]*i[r][a];let o=Math.sqrt(Math.max(i[r][r],1e-300));for(let a=r;a<e;a++)i[a][r]/=o}let s=Float64Array.from(t);for(let r=0;r<e;r++){for(let o=0;o<r;o++)s[r]-=i[r][o]*s[o];s[r]/=i[r][r]}for(let r=e-1;r>=0;r--){for(let o=r+1;o<e;o++)s[r]-=i[o][r]*s[o];s[r]/=i[r][r]}return s}function sM({columns:n,right:t,ridge:e,sparse:i},s){let r=t.map((a,l)=>n.reduce((c,h,u)=>c-h[l]*s[u],a)),o=Et(r,r);for(let a=0;a<s.length;a++)o+=(e[a]*Math.abs(s[a])+(i?.[a]??0))*Math.abs(s[a]);return o}var rp=(n,t)=>Math.sign(n)*Math.max(0,Math.abs(n)-t),dr=n=>Math.sqrt(Et(n,n));var ch=.001,ws=class{constructor(t,e,i){this.session=t,this.towards=i,this.start=Float64Array.from(t.values),this.places=[t.place(e),...t.pins],this.origin=t.shown(this.places[0]),this.controls=t.controls}to(t){let{session:e}=this,i=[t,...e.pins.map(a=>a.at)].flat(),s=a=>Qf({model:this,start:this.start,now:e.values,targets:i,groups:a,towards:this.towards,locality:e.options.locality}),r=s(e.groups(!1)),o=r.size?r:s(e.groups(!0));e.affected=this.changes(o),e.set(o)}get acts(){let{motion:t}=this.linearise(this.session.values);return this.session.groups(!0).flat().some(e=>Math.hypot(...t(e).slice(0,3))>0)}changes(t){let e=new Map;for(let[i,s]of t){let r=Math.abs(s-this.start[i])/(this.maximum(i)-this.minimum(i));r>.005&&e.set(i,r)}return e}minimum(t){return this.opposites(t).length?Math.min(this.off(t),Bo(this.controls[t])):this.controls[t].minimum}maximum(t){return this.opposites(t).length?Math.max(this.off(t),Bo(this.controls[t])):this.controls[t].maximum}opposites(t){return this.session.opposites[t]}off(t){return this.controls[t].default}peak(t){return this.session.influence.peak(t)}linearise(t){let{deformer:e}=this.session,i=()=>this.places.flatMap(o=>this.session.traced(o));e.drive(t);let s=i();return{at:s,motion:o=>{let a=this.maximum(o)-this.minimum(o),c=(this.maximum(o)-t[o]>=ch*a?ch:-ch)*a;return e.withControl(o,t[o],t[o]+c,i).map((u,d)=>(u-s[d])/c)}}}};var rM=3,oM=.1,aM=500,Go=class{constructor(t){this.view=t,this.session=t.session,this.active=null,this.pending=null,this.reach=0,this.fingers=new Map;let e=t.surface,i={pointerdown:this.press,pointermove:this.move,pointerup:this.release,pointercancel:this.lose,pointerleave:this.leave,dblclick:this.doubleClick};for(let[s,r]of Object.entries(i))e.addEventListener(s,o=>r.call(this,o));e.addEventListener("contextmenu",s=>s.preventDefault()),e.addEventListener("wheel",s=>this.wheel(s),{passive:!1})}press(t){let e=this.view.locate(t);if(t.pointerType==="touch"){if(this.active?.isOfPen)return;if(this.fingers.set(t.pointerId,e),this.fingers.size===2)return this.beginTwo()}if(this.active)return;this.view.surface.focus({preventScroll:!0}),this.view.surface.setPointerCapture(t.pointerId),this.view.freshen(),this.reach=t.pointerType==="touch"?er/2:0;let{pointerId:i,pointerType:s}=t;this.active={pointer:i,isOfPen:s==="pen",start:e,last:e,hand:e,moved:!1,...this.chooseGesture(t,e)},this.active.begin?.(),clearTimeout(this.holding),s!=="mouse"&&this.active.hold&&(this.holding=setTimeout(()=>this.hold(i),aM)),t.preventDefault()}hold(t){this.flush();let{active:e}=this;e?.pointer!==t||e.moved||(e.hold(),Object.assign(e,{grab:null,drag:null,drop:null,click:null,undo:null}))}move(t){let e=this.view.locate(t);if(this.fingers.has(t.pointerId)&&this.fingers.set(t.pointerId,e),this.active?.isOfTwo)return this.active.stale=!0,this.view.request();if(this.active&&this.active.pointer!==t.pointerId)return;t.pointerType!=="touch"&&(this.reach=0);let i=this.session.options.draw&&this.active?t.getCoalescedEvents?.()??[]:[],s=[...this.pending?.trail??[],...(i.length?i:[t]).map(r=>this.view.locate(r))];return this.pending={at:e,trail:s,fine:t.ctrlKey||t.metaKey},this.view.request()}beginTwo(){this.cancel(),this.pending=null,this.active={isOfTwo:!0,...this.grip()}}grip(){let[t,e]=[...this.fingers.values()];return{x:(t.x+e.x)/2,y:(t.y+e.y)/2,apart:Math.hypot(e.x-t.x,e.y-t.y)||1,angle:Math.atan2(e.y-t.y,e.x-t.x)}}moveTwo(){if(this.fingers.size<2||!this.active.stale)return;let{camera:t,columns:[{left:e,top:i,width:s,height:r}]}=this.view,[o,a]=[this.active,this.grip()],l=a.apart/o.apart;t.zoom(1/l);let c=(u,d,f)=>u-f-l*(d-f);t.pan(c(a.x,o.x,e+s/2),c(a.y,o.y,i+r/2),r);let h=Math.atan2(Math.sin(a.angle-o.angle),Math.cos(a.angle-o.angle));t.turn(t.azimuth+h,t.elevation),Object.assign(this.active,a,{stale:!1}),this.view.changed("camera")}lose(t){this.fingers.delete(t.pointerId),this.cancel()}flush(){if(this.active?.isOfTwo&&this.moveTwo(),!this.pending)return;let{at:t,trail:e,fine:i}=this.pending;this.pending=null,this.active?this.dragTo(t,i,e):this.hover(t)}dragTo(t,e,i){let{active:s}=this,r=e?oM:1,o=[t.x-s.last.x,t.y-s.last.y];s.hand={...t,x:s.hand.x+r*o[0],y:s.hand.y+r*o[1]},s.last=t,!(!s.moved&&Math.hypot(t.x-s.start.x,t.y-s.start.y)<rM)&&(s.moved||s.grab?.(),s.moved=!0,s.drag?.(s.hand,o,t,i))}release(t){if(this.active?.isOfTwo&&this.moveTwo(),this.fingers.delete(t.pointerId),this.active?.isOfTwo&&(this.active=null),!this.active||this.active.pointer!==t.pointerId)return;this.move(t),this.flush();let{active:e}=this;this.active=null,e.moved?e.drop?.(e.last):e.click?.(),this.session.quiet||=e.moved,this.setDragging(null),this.view.changed("pose")}cancel(){let{active:t}=this;return this.active=null,t?.undo?.(),this.setDragging(null),t!==null}leave(){this.active||this.session.setHover(null)}doubleClick(t){let e=this.view.locate(t),i=this.view.elementAt(e),s=i?null:this.view.pick(e);i?this.session.reset(i.members.map(({control:r})=>r)):s&&this.view.dive(s)}wheel(t){return t.preventDefault(),this.view.overlay.dock.contains(this.view.locate(t))?this.scroll(t.deltaY):(this.view.camera.zoom(Math.exp(.0012*Vt(t.deltaY,-300,300))),this.view.changed("camera"))}scroll(t){let{view:e}=this;e.overlay.dock.scrollBy(t)&&(e.arrange(),e.changed("overlay"))}hover(t){if(this.session.options.draw&&t.column)return this.session.setHover(null),this.view.setCursor("crosshair");let{overlay:e}=this.view;this.view.controlsAt(t)&&t.column&&!this.reach&&e.point(t.x,t.y)&&this.view.changed("overlay");let i=this.view.elementAt(t);this.session.setHover(i);let s=!i&&t.column?.kind!=="target"&&this.view.pick(t);return this.view.setCursor(i?"grab":s&&this.session.options.skinDrag?"crosshair":"default")}chooseGesture(t,e){let{view:i,session:s}=this;if(t.button===1||t.button===2)return this.panning();if(s.options.draw&&e.column&&e.column===i.controlsColumn&&!t.altKey)return i.review.drawing(e);let{reach:r}=this,o=i.controlsAt(e)?i.overlay.badgeAt(e.x,e.y,r?r/2:void 0):null;if(o)return{click:()=>s.openOrClose([o])};if(r&&e.column&&i.overlay.isAmbiguous(e.x,e.y,r))return this.opening(e);let a=i.elementAt(e,r);if(!a&&i.overlay.dock.contains(e))return{drag:(h,[,u])=>this.scroll(-u)};if(t.altKey||!(a||e.column)||e.column?.kind==="target")return this.orbiting();if(a&&s.options.rearrange)return i.rearranging.gesture(a);if(a)return t.shiftKey?{click:()=>s.select([a],"toggle")}:this.handling(a);let l=i.controlsAt(e)?i.overlay.pinAt(e.x,e.y,r):null;if(l)return{click:()=>s.removePin(l)};let c=s.options.skinDrag?i.pick(e):null;return t.shiftKey?this.marquee(c,e):c&&!s.options.rearrange?this.pulling(c,e):this.orbiting()}orbiting(){let{camera:t}=this.view;return{drag:(e,[i,s])=>{t.turn(t.azimuth-.008*i,t.elevation+.008*s),this.view.changed("camera")},click:()=>this.session.select([])}}panning(){let{camera:t}=this.view;return{drag:(e,[i,s])=>{t.pan(i,s,this.view.columns[0].height),this.view.changed("camera")}}}opening(t){return{begin:()=>{this.view.overlay.point(t.x,t.y,er),this.view.changed("overlay"),this.view.say("Several handles lay under the finger: drag the one you mean")}}}handling(t){let{session:e,view:i}=this,s=null,r=null;return{begin:()=>{e.selection.has(t.index)||e.select([t]),e.emit("editing"),this.setDragging(t),i.setCursor("grabbing")},grab:()=>{r=e.beginEdit(),s=i.beginDrag(t)},drag:o=>{let a=qf(s,o.x-this.active.start.x,o.y-this.active.start.y);e.set(this.withSelection(t,s,a,r))},drop:()=>e.endEdit(`Drag ${t.label}`,r),undo:()=>this.takeBack(r)}}withSelection(t,e,i,s){let{controls:r,rest:o,selectedElements:a}=this.session,l=new Map(i);for(let c of a.filter(h=>h!==t))c.axes.slice(0,e.axes.length).forEach((h,u)=>{let d=e.current[u]-e.start[u],f=d?ko(c,u,d,r,o,s):[];f.some(([p])=>l.has(p))||f.forEach(([p,x])=>l.set(p,x))});return l}pulling(t,e){let{session:i,view:s}=this,r=null,o=null;return{grab:()=>{o=i.beginEdit(),r=new ws(i,t,s.camera.towards),this.setDragging("skin"),s.setCursor(r.acts?"grabbing":"not-allowed"),r.acts||s.say("No control that is free moves the skin here")},drag:a=>{let{column:l}=e,c=s.camera.unproject(l,e.x,e.y,t.depth),h=s.camera.unproject(l,a.x,a.y,t.depth);r.to(we(r.origin,ve(h,c)))},drop:()=>{r.acts&&o.every((a,l)=>a===i.values[l])&&s.say("No control that is free moves the skin here that way"),i.endEdit("Pull the skin",o)},click:()=>s.showInfluences(t),hold:()=>{i.addPin(t),s.say("Pinned: pulls leave this point. A tap on the pin takes it out")},undo:()=>this.takeBack(o)}}marquee(t,e){let{session:i,view:s}=this,r=o=>[e.x,e.y,o.x,o.y];return{drag:(o,a,l)=>{s.overlay.marquee=r(l),s.changed("overlay")},drop:o=>{s.overlay.marquee=null,i.select(s.overlay.elementsIn(r(o)),"add")},click:()=>t&&i.addPin(t),undo:()=>s.overlay.marquee=null}}takeBack(t){t&&this.session.set([...t.entries()])}setDragging(t){Object.assign(this.session,{dragging:t,affected:new Map}),this.session.emit("dragging")}};function Ho(n){let t=n.meshes.filter(s=>s.visible),e=new Uint32Array(t.reduce((s,r)=>s+r.triangles.length,0)),i=0;for(let s of t)for(let r of s.triangles)e[i++]=s.start+r;return e}function op({meshes:n,texture:t,pointCount:e}){if(!t||!n.some(c=>c.texture))return null;let i=new Array(2*e).fill(NaN),[s,r,o]=[[],[],[]],a=new Map,l=(c,h,u)=>{if(Number.isNaN(i[2*c])&&([i[2*c],i[2*c+1]]=[h,u]),i[2*c]===h&&i[2*c+1]===u)return c;let d=`${c} ${h} ${u}`;return oe(a,d,()=>(s.push(c),i.push(h,u),e+s.length-1))};for(let{start:c,triangles:h,visible:u,texture:d}of n){if(!u)continue;let f=h.length/3;h.forEach((p,x)=>{let m=Math.floor(x/3),g=d?d.images[m]:-1;if(x%3===0&&o.push(g<0?0:1),g<0)r.push(l(c+p,-1,-1));else{let[_,w,y,E]=t.boxes[g],[S,v]=[0,3*f].map(A=>d.uv[A+x%3*f+m]/65535);r.push(l(c+p,(_+.5+S*(y-1))/t.width,(w+.5+(1-v)*(E-1))/t.height))}})}return{...t,corners:Uint32Array.from(r),doubles:s,places:Float32Array.from(i),on:Uint8Array.from(o)}}function hh(n,t,e,i=new n.constructor(n.length+t*e.length)){return i===n||(i.set(n),e.forEach((s,r)=>{for(let o=0;o<t;o++)i[n.length+t*r+o]=n[t*s+o]})),i}function ap(n){let t=new Float32Array(3*n.pointCount),e=new Float32Array(2*n.pointCount).fill(9);for(let i of n.meshes)i.colours.forEach((s,r)=>t[3*i.start+r]=s/255),i.gaze&&e.set(i.gaze,2*i.start);return{colours:t,gaze:e}}function lp(n,t){let e=lM(t,n.pointCount),i=new Map;for(let s of n.meshes)for(let r=0;r<s.count;r++){if(!e[s.start+r])continue;let o=`${s.path} ${s.points.subarray(3*r,3*r+3).join()}`;oe(i,o,()=>[]).push(s.start+r)}return[...i.values()].filter(s=>s.length>1)}function lM(n,t){let e=new Uint8Array(t);for(let i of cp(n,t))e[Math.floor(i/t)]=e[i%t]=1;return e}function cp(n,t){let e=new Map;for(let i=0;i<n.length;i+=3)for(let s=0;s<3;s++){let[r,o]=[n[i+s],n[i+(s+1)%3]];Vo(e,Math.min(r,o)*t+Math.max(r,o))}return[...e].filter(([,i])=>i===1).map(([i])=>i)}var Vo=(n,t,e=1)=>n.set(t,(n.get(t)??0)+e);function Wo(n,t,e,i){i.fill(0),cM(n,t,i),hM(e,i)}function cM(n,t,e){for(let i=0;i<t.length;i+=3){let s=3*t[i],r=3*t[i+1],o=3*t[i+2],a=n[r]-n[s],l=n[r+1]-n[s+1],c=n[r+2]-n[s+2],h=n[o]-n[s],u=n[o+1]-n[s+1],d=n[o+2]-n[s+2],f=l*d-c*u,p=c*h-a*d,x=a*u-l*h;e[s]+=f,e[s+1]+=p,e[s+2]+=x,e[r]+=f,e[r+1]+=p,e[r+2]+=x,e[o]+=f,e[o+1]+=p,e[o+2]+=x}}function hM(n,t){for(let e of n)for(let i=0;i<3;i++){let s=0;for(let r of e)s+=t[3*r+i];for(let r of e)t[3*r+i]=s}}function hp(n,t){let e=uM(t,n.length/3),i=new Map,s=new Map;for(let a=0;a<t.length;a+=3){let l=e[t[a]];Vo(i,l),Vo(s,l,dM(n,t,a,3*l))}let r=fM(t,e,n.length/3),o=new Int8Array(t.length/3);for(let a=0;a<o.length;a++){let l=e[t[3*a]],c=(r.get(l)??0)<.08*i.get(l);o[a]=c?Math.sign(s.get(l)):0}return o}function uM(n,t){let e=Uint32Array.from({length:t},(s,r)=>r),i=s=>{for(;e[s]!==s;)s=e[s]=e[e[s]];return s};for(let s=0;s<n.length;s+=3)e[i(n[s+1])]=i(n[s]),e[i(n[s+2])]=i(n[s]);return e.map((s,r)=>i(r))}function dM(n,t,e,i){let[s,r,o]=[0,1,2].map(a=>[0,1,2].map(l=>n[3*t[e+a]+l]-n[i+l]));return Et(s,Bn(r,o))}function fM(n,t,e){let i=new Map;for(let s of cp(n,e))Vo(i,t[s%e]);return i}function up(n,t,e,i,s,r,o=t){let a=i.position,l=mM(n,i,a,s),c=0;for(let h=0,u=0;h<t.length;h+=3,u++){let[d,f,p]=[t[h],t[h+1],t[h+2]];l[d]&l[f]&l[p]||e[u]!==0&&e[u]*pM(n,3*d,3*f,3*p,a)<=0||(r[c++]=o[h],r[c++]=o[h+1],r[c++]=o[h+2])}return c}function pM(n,t,e,i,s){let r=n[t],o=n[t+1],a=n[t+2],l=n[e]-r,c=n[e+1]-o,h=n[e+2]-a,u=n[i]-r,d=n[i+1]-o,f=n[i+2]-a;return(c*f-h*d)*(s[0]-r)+(h*u-l*f)*(s[1]-o)+(l*d-c*u)*(s[2]-a)}function mM(n,{right:t,above:e,towards:i,half:s},r,o){let a=new Uint8Array(n.length/3);for(let l=0,c=0;l<a.length;l++,c+=3){let h=n[c]-r[0],u=n[c+1]-r[1],d=n[c+2]-r[2],f=-(h*i[0]+u*i[1]+d*i[2]),p=h*t[0]+u*t[1]+d*t[2],x=h*e[0]+u*e[1]+d*e[2],[m,g]=[f*s*o,f*s];a[l]=(p>m?1:0)|(p<-m?2:0)|(x>g?4:0)|(x<-g?8:0)|(f<=0?16:0)}return a}var gM=[240,169,75],xM=[88,166,255],vM=160,yM=26,_M=.004,Xo=class{constructor(t){this.view=t,this.node=U("canvas",{class:"onion","aria-hidden":"true",hidden:!0}),this.drawn=[],this.painter=null}follow(){let t=this.wanted();wn(t,this.drawn)||(this.node.hidden=!0,this.drawn=[],clearTimeout(this.timer),t.length&&(this.timer=setTimeout(()=>this.draw(),vM)))}wanted(){let{session:t,camera:e,controlsColumn:i}=this.view;if(!t.options.onion||!i||t.neutral||!t.keys.size)return[];let{left:s,top:r,width:o,height:a}=i;return[t.frame,t.keys,t.constants,[...t.selection].join(),e.azimuth,e.elevation,e.distance,...e.target,s,r,o,a]}draw(){let{view:t}=this,{width:e,height:i}=t;if(this.drawn=this.wanted(),!this.drawn.length)return;this.painter??=new wi(U("canvas"),t.stage),this.painter.resize(e,i,1);let s=new ImageData(Math.max(1,Math.round(e)),Math.max(1,Math.round(i))),{before:r,after:o}=MM(t.session),a=this.outlineAt(t.session.frame);r!==null&&dp(this.outlineAt(r),a,gM,s),o!==null&&dp(this.outlineAt(o),a,xM,s),Object.assign(this.node,{width:s.width,height:s.height,hidden:!1}),this.node.getContext("2d").putImageData(s,0,0)}outlineAt(t){let{view:e,painter:i}=this,{deformer:s}=e.session,r=e.stage.withPoints(e.session.atFrame(t,l=>s.posedAside(l)));s.updateMaps();let o=new Float32Array(r.length);Wo(r,e.stage.triangles,e.stage.welded,o);let a={...e.stage.skin,points:r,normals:o,paint:new Uint8Array(4*r.length/3)};return i.draw([e.controlsColumn],e.camera,()=>a),bM(i)}};function MM({keys:n,frame:t,selection:e,chosenControls:i}){let s=new Set(e.size?i:[]),r=[...n].filter(([a])=>s.has(a)),o=Ee((r.length?r:[...n]).flatMap(([,a])=>a.map(([l])=>l)));return{before:o.findLast(a=>a<t)??null,after:o.find(a=>a>t)??null}}function bM({pixels:n,nearness:t,wide:e}){let i=new Float32Array(n.length);for(let r=0;r<i.length;r++){let o=n[r];i[r]=.3*(o&255)+.59*(o>>8&255)+.11*(o>>16&255)}let s=new Uint8Array(n.length);for(let r=e+1;r<s.length-e-1;r++){let o=Math.abs(i[r+1]-i[r-1])+Math.abs(i[r+e]-i[r-e]),a=Math.max(Math.abs(t[r+1]-t[r]),Math.abs(t[r+e]-t[r])),l=Math.max(o/yM,a/(_M*Math.max(t[r],1e-12)))-1;l>0&&(s[r]=210*Math.min(1,l))}return s}function dp(n,t,[e,i,s],{data:r,width:o}){for(let a=o+1;a<n.length-o-1;a++)n[a]<=r[4*a+3]||t[a]||t[a-1]||t[a+1]||t[a-o]||t[a+o]||(r[4*a]=e,r[4*a+1]=i,r[4*a+2]=s,r[4*a+3]=n[a])}function wM(n,t,e=()=>!1){let i=n.map(([r,o])=>[r,o]),s=n.map((r,o)=>e(o));for(let r=0;r<160;r++)if(!SM(i,s,t*1.02))return i;return AM(i,n,s,t)}function SM(n,t,e){let i=!1;for(let s=0;s<n.length;s++)for(let r=0;r<s;r++){if(t[s]&&t[r])continue;let[o,a]=[n[s][0]-n[r][0],n[s][1]-n[r][1]],l=Math.hypot(o,a);if(l>=e)continue;i=!0;let c=2.4*(s+1),[h,u]=l>1e-6?[o/l,a/l]:[Math.cos(c),Math.sin(c)],d=(e-l)*(t[s]||t[r]?1:.5);t[s]||(n[s]=[n[s][0]+d*h,n[s][1]+d*u]),t[r]||(n[r]=[n[r][0]-d*h,n[r][1]-d*u])}return i}function AM(n,t,e,i){let s=n.filter((l,c)=>!e[c]),r=fp(s),o=r>0?Math.max(1,i/r):1,a=[0,1].map(l=>s.reduce((c,h)=>c+h[l],0)/Math.max(1,s.length));return n.map((l,c)=>e[c]?t[c]:l.map((h,u)=>a[u]+o*(h-a[u])))}function fp(n){let t=1/0;return n.forEach(([e,i],s)=>n.slice(0,s).forEach(([r,o])=>t=Math.min(t,Math.hypot(e-r,i-o)))),t}function pp(n,t,e,i=-1){let s=7*e,r=([l,c])=>Math.hypot(l-t[0],c-t[1]),o=n.map((l,c)=>c).filter(l=>r(n[l])<s+2*e);if(fp(o.filter(l=>r(n[l])<s).map(l=>n[l]))>=e)return null;let a=wM(o.map(l=>n[l]),e,l=>o[l]===i||r(n[o[l]])>s);return new Map(o.map((l,c)=>[l,[a[c][0]-n[l][0],a[c][1]-n[l][1]]]))}var mp=11,EM=22,gp=30,TM=8,CM=2,uh=6,qo=class{constructor(t){this.session=t,this.drawn=[],this.enlarged=1,this.leftward=0,this.dock=new Io(t),this.lens=null,this.look="",this.magnifications=new Map}arrange(t,e,i){let{session:s}=this,r=e.projector(t),o=1/e.pixelSize(t.height),a=Vt(s.elements.width*o,mp,EM);this.enlarged=a/(s.elements.width*o);let l=new Map(this.drawn.map(p=>[p.element,p]));i&&(this.magnifications=new Map);let{azimuth:c,elevation:h,distance:u,target:d}=e,f=[c,h,u,...d,t.left,t.width,t.height].join();f!==this.look&&(this.lens=null),this.look=f,this.drawn=s.elements.list.filter(p=>s.isShown(p)&&(!p.onBoard||this.dock.mapOf(p))).map(p=>{if(p.onBoard)return this.docked(p);let x=i&&this.facesAway(p,e);return this.arranged(p,r,x?()=>!0:i,a,l.get(p))}),this.pinned=s.pins.map(p=>r(s.shown(p))),this.column=t,this.leftward=Math.sign(Et(s.character.layout.planeNormal,e.right)),this.lens&&this.shift()}mapOf(t,e,i=t.origin){let s=e(i),r=oe(this.magnifications,t,()=>IM(t.tracks.map(l=>l.map(e)))),[o,a]=this.lens?.offsets.get(t)??[0,0];return l=>{let[c,h,u]=e(l);return[s[0]+r*(c-s[0])+o,s[1]+r*(h-s[1])+a,u]}}draggable(t,e){let i=this.dock.mapOf(t);return t.onBoard&&i?[this.dock.heldStill(t),i]:[t,this.mapOf(t,e)]}docked(t){let e=this.dock.mapOf(t),{tracks:i}=this.dock.heldStill(t),s=t.members.map((d,f)=>this.screenTrack(d,i[f],e,()=>!1)),r=this.dock.handleOf(t),o=t.members[0],a=e(Sn(o.values,i[0],this.session.rest[o.control])),[l,c]=[e(r),mp+1],h=c/(this.session.elements.width*this.enlarged),u=t.glyph&&t.glyph.points.map(d=>{let[f,p]=this.dock.seen(d);return[l[0]+h*f,l[1]+h*p,1]});return{element:t,handle:l,tracks:s,width:c,hidden:!1,corners:u,origin:a}}point(t,e,i=null){let{lens:s}=this;if(s&&Math.hypot(t-s.at[0],e-s.at[1])<CM*s.apart&&(i??0)<=s.apart)return!1;let r=this.drawn.filter(x=>!x.element.onBoard&&this.isReachable(x)),o=i??(r[0]?.width??0)+2,a=x=>Math.hypot(x.handle[0]-t,x.handle[1]-e),l=r.reduce((x,m)=>x&&a(x)<=a(m)?x:m,null),c=l&&a(l)<=l.width/2?r.indexOf(l):-1,h=c<0?null:r[c].handle,u=this.closeLens();if(!this.session.options.handles)return u;let d=r.map(({handle:x})=>x),f=pp(d.map((x,m)=>m===c?h:x),[t,e],o,c);if(!f)return u;let p=new Map([...f].map(([x,[m,g]])=>{let[_,w]=x===c?[h[0]-d[x][0],h[1]-d[x][1]]:[0,0];return[r[x].element,[m+_,g+w]]}));return this.lens={offsets:p,at:[t,e],apart:o},this.shift(),!0}closeLens(){return this.lens?(this.shift(-1),this.lens=null,!0):!1}shift(t=1){let{offsets:e}=this.lens;for(let i of this.drawn){let[s,r]=e.get(i.element)??[0,0];if(!s&&!r)continue;let o=([a,l,c])=>[a+t*s,l+t*r,c];i.home=t>0?i.handle:null,i.handle=o(i.handle),i.origin=o(i.origin),i.corners=i.corners&&i.corners.map(o),i.tracks=i.tracks.map(a=>a.map(({at:l,covered:c})=>({at:o(l),covered:c})))}}isReachable({handle:t,hidden:e}){return t[2]>0&&(!e||this.session.options.occlusion==="overlay")}facesAway(t,{towards:e}){let{occlusion:i}=this.session.options;return i!=="overlay"&&!t.onBoard&&Et(t.normal,e)<-.2}arranged(t,e,i,s,r){let o=this.lens;this.lens=null;let a=this.mapOf(t,e);this.lens=o;let l=a(t.handle),c=t.tracks.map((p,x)=>{let m=i?null:r?.tracks[x];return this.screenTrack(t.members[x],p,a,(g,_)=>i?.(g)??m?.[_]?.covered??!1)}),h=i?i(l)&&RM(c):r?.hidden??!1,u=e(t.handle),d=([p,x,m])=>[p+l[0]-u[0],x+l[1]-u[1],m],f=t.glyph&&t.outline.map(p=>d(e(p)));return{element:t,handle:l,tracks:c,width:s,hidden:h,corners:f,origin:e(t.origin)}}screenTrack(t,e,i,s){let{minimum:r,maximum:o}=this.session.controls[t.control],a=t.values.filter(h=>h>r&&h<o),l=[r,...a,o];return l.flatMap((h,u)=>{let d=l[u+1];return d===void 0?[h]:[0,1,2,3].map(f=>h+f/4*(d-h))}).map((h,u)=>{let d=i(Sn(t.values,e,h));return{at:d,covered:s(d,u)}})}badgeOf({element:t,handle:e,width:i}){let{session:s}=this;return t.inner.length||s.levels.coarseOf(t).length&&(s.hover===t||s.selection.has(t.index))?[e[0]+i/2+4,e[1]+i/2+4]:null}badgeAt(t,e,i=uh+2){return this.session.options.handles?this.drawn.filter(r=>this.isReachable(r)).find(r=>{let o=this.badgeOf(r);return o&&Math.hypot(o[0]-t,o[1]-e)<=i})?.element??null:null}elementAt(t,e,i=0){let{session:s,dock:r}=this;if(!s.options.handles)return null;let o=r.contains({x:t,y:e}),a=null;for(let l of this.drawn){let{element:c,handle:h,width:u}=l;if(!this.isReachable(l)||c.onBoard!==o)continue;let d=Math.hypot(h[0]-t,h[1]-e);d<=Math.max(i,u/2+4)&&(!a||d<a.off)&&(a={element:c,off:d})}return a?.element??null}isAmbiguous(t,e,i){return!this.session.options.handles||this.lens&&this.lens.apart>=2*i?!1:this.drawn.filter(r=>!r.element.onBoard&&this.isReachable(r)&&Math.hypot(r.handle[0]-t,r.handle[1]-e)<=i).length>1}pinAt(t,e,i=0){let s=(this.pinned??[]).findIndex(r=>Math.hypot(r[0]+5-t,r[1]-15-e)<Math.max(9,i));return s<0?null:this.session.pins[s]}elementsIn([t,e,i,s]){let r=([a,l])=>a>=Math.min(t,i)&&a<=Math.max(t,i)&&l>=Math.min(e,s)&&l<=Math.max(e,s),o=this.session.options.occlusion==="overlay";return this.drawn.filter(a=>r(a.handle)&&(o||!a.hidden)).map(a=>a.element)}};function RM(n){let t=n.flat();return t.filter(({covered:e})=>e).length>.6*t.length}function IM(n){let t=Math.max(...n.map(e=>as(e.map(i=>i.slice(0,2)))));return t<gp/TM?1:Math.max(1,gp/t)}var PM="#5fd6ff",dh=.22,$o=40,Ko=class extends qo{constructor(t,e){super(e),this.canvas=t,this.pen=t.getContext("2d"),this.marquee=null,this.placing=null}resize(t,e,i){this.ratio=i,this.width=t,this.height=e,this.box=null}draw(t=[],e=[]){let{pen:i,session:s}=this;if(this.cover(t,e),i.clearRect(0,0,this.width,this.height),s.options.handles&&this.column){this.clipTo(this.column);let r=this.drawn.filter(({element:o})=>!o.onBoard).sort((o,a)=>a.handle[2]-o.handle[2]);this.drawElements(r),e.forEach(o=>this.drawTrail(o)),s.options.labels==="all"&&this.drawLabels(r),i.restore(),this.dock.rect&&this.drawDock()}this.drawPins(),t.forEach(r=>this.drawStroke(r)),this.drawPlacing(),this.marquee&&this.drawMarquee(this.marquee)}cover(t,e){let{canvas:i,pen:s,ratio:r}=this,o=ao(this.reach(t,e),this.box,[this.width,this.height]);o!==this.box&&(this.box=o,i.width=Math.round((o[2]-o[0])*r),i.height=Math.round((o[3]-o[1])*r),lo(i,o),s.setTransform(r,0,0,r,-o[0]*r,-o[1]*r))}reach(t,e){let{session:i,dock:s}=this;if(t.length||this.marquee||this.placing||i.options.labels==="all")return[0,0,this.width,this.height];let r=i.options.handles?this.drawn:[],o=i.options.handles&&s.rect,a=o?[[o.left,o.top],[o.left+o.width,o.top+o.height]]:[],[l,c,h,u]=[1/0,1/0,-1/0,-1/0],d=([f,p])=>{f<l&&(l=f),f>h&&(h=f),p<c&&(c=p),p>u&&(u=p)};[...a,...this.pinned??[],...e.flatMap(({places:f})=>f.map(({at:p})=>p))].forEach(d);for(let{element:f,handle:p,home:x,tracks:m,origin:g,corners:_}of r){let w=(E,S)=>([v,A])=>d([E[0]+S*(v-E[0]),E[1]+S*(A-E[1])]),y=w(g,f.axes.length>1?2:1);m.forEach(E=>E.forEach(({at:S})=>y(S))),_?.forEach(w(p,1.3*this.enlarged)),d(p),x&&d(x)}return[l-$o,c-$o,h+$o,u+$o]}drawElements(t){for(let e of["drawLeader","drawTracks","drawHandle","drawBadge"])t.forEach(i=>this[e](i))}drawDock(){this.clipTo(this.dock.rect),this.dock.draw(this.pen),this.drawElements(this.drawn.filter(({element:t})=>t.onBoard)),this.pen.restore()}drawLeader({element:t,home:e,handle:i,hidden:s}){!e||Math.hypot(e[0]-i[0],e[1]-i[1])<3||(this.pen.globalAlpha=.5*this.strength(t,s),si(this.pen,[e,i]),He(this.pen,1,"#f4f5f7"))}drawBadge(t){let e=this.badgeOf(t);if(!e)return;let{pen:i}=this,s=this.strength(t.element,t.hidden);if(s<.3)return;let[r,o]=e,[a,l]=[[[r-3,o],[r+3,o]],[[r,o-3],[r,o+3]]];i.globalAlpha=s,Yo(i,e,uh,"#f4f5f7"),si(i,a,...t.element.inner.length?[l]:[]),He(i,1.6,"#16181b"),i.globalAlpha=1}clipTo({left:t,top:e,width:i,height:s}){this.pen.save(),this.pen.beginPath(),this.pen.rect(t,e,i,s),this.pen.clip()}strength(t,e){let{session:i}=this,{opacity:s,fade:r,occlusion:o}=i.options,a=i.dragging,l=i.selection.has(t.index)||i.hover===t||this.affectedShare(t)>0,c=s;return r&&a&&a!==t&&!l&&(c*=.18),e&&o!=="overlay"&&(c*=o==="ghost"?.2:0),c}affectedShare(t){return t.members.reduce((e,{control:i})=>Math.max(e,this.session.affected.get(i)??0),0)}colour(t){return this.affectedShare(t)>0&&this.session.dragging==="skin"?PM:this.session.colours[t.side]}drawTracks(t){let{element:e,tracks:i}=t,{pen:s,session:r}=this,o=r.selection.has(e.index)||r.hover===e,a=this.colour(e);e.axes.length>1&&this.drawPatch(t,a,o),Object.assign(s,{lineCap:"round",lineJoin:"round"});let l=this.strength(e,!1)<dh;i.forEach(c=>{l||this.strokeRuns(e,c,"#14161a",o?5.5:4,.55),this.strokeRuns(e,c,a,o?3:1.9,.95)}),i.forEach(c=>this.drawEnd(e,c.at(-1),a)),s.globalAlpha=1}strokeRuns(t,e,i,s,r){let{pen:o}=this,a=0;for(;a+1<e.length;){let l=e[a].covered&&e[a+1].covered;o.globalAlpha=r*this.strength(t,l);let c=[e[a].at];do c.push(e[++a].at);while(a+1<e.length&&(e[a].covered&&e[a+1].covered)===l);si(o,c),o.globalAlpha>0&&He(o,s,i)}}drawEnd(t,{at:e,covered:i},s){this.pen.globalAlpha=.9*this.strength(t,i),Yo(this.pen,e,2.2,s)}drawPatch({element:t,tracks:e,origin:i,hidden:s},r,o){let{pen:a}=this,l=t.axes.map(u=>{let d=e[u.at(-1)].at(-1).at;return[u.length>1?e[u[0]].at(-1).at:e[u[0]][0].at,d].map(p=>[p[0]-i[0],p[1]-i[1]])});a.globalAlpha=(o?.3:.16)*this.strength(t,s),a.fillStyle=r;let c=l.length>2?DM(l):l,h=l.length>2?c.length:1;for(let u=0;u<h;u++){let[d,f]=[c[u],c[(u+1)%c.length]];h>1&&OM(d[1],f[1])>Math.PI+1e-6||(si(a,[[0,0],[1,0],[1,1],[0,1]].map(([p,x])=>[0,1].map(m=>i[m]+d[p][m]+f[x][m]))),a.fill())}}drawHandle(t){let{element:e,handle:i,width:s,hidden:r}=t,{pen:o,session:a}=this,l=this.strength(e,r);if(l<=0||i[2]<=0)return;let[c,h]=i,u=a.hover===e,d=a.selection.has(e.index),f=e.members.some(({control:_})=>a.values[_]!==a.rest[_]),p=e.members.every(({control:_})=>a.locks.has(_)),x=s/2*(u?1.22:1);o.globalAlpha=l;let m=f?this.colour(e):"#2a2d32",g=d?"#ffffff":this.colour(e);e.glyph?this.drawGlyph(t,m,g,(d?2.6:1.8)+(f?.8:0),u?1.22:1):(o.beginPath(),fh(o,e.axes.length,c,h,x),l>=dh&&He(o,4,"rgba(15, 17, 20, 0.75)"),o.fillStyle=m,o.fill(),!f&&l>=dh&&this.fillHalf(e,c,h,x),He(o,d?2.6:1.8,g)),p&&LM(o,c,h,x*.5,f?"#16181b":this.colour(e)),(u||d)&&this.drawHalo(e,c,h,x+4.5,d&&!u?.35:.7),o.globalAlpha=1}fillHalf(t,e,i,s){let r={left:this.leftward,right:-this.leftward}[t.side];if(!r)return;let{pen:o}=this;o.save(),o.clip(),o.fillStyle=this.session.colours[t.side],o.fillRect(r>0?e:e-2*s,i-2*s,2*s,4*s),o.restore(),o.beginPath(),fh(o,t.axes.length,e,i,s)}drawGlyph({element:t,handle:e,corners:i},s,r,o,a){let{pen:l}=this,{parts:c,closed:h}=t.glyph,u=this.enlarged*a,d=x=>[0,1].map(m=>e[m]+u*(i[x][m]-e[m])),f=c.map(x=>{let m=new Path2D;for(let[g,_]of x.map(d))m.lineTo(g,_);return h&&m.closePath(),m}),p=(x,m)=>f.forEach(g=>He(l,x,m,g));if(p(h?2*o+2:o+2.2,"rgba(15, 17, 20, 0.75)"),p(h?2*o:o,r),!!h){l.fillStyle=s;for(let x of f)l.fill(x);p(.7,s)}}drawHalo(t,e,i,s,r){let{pen:o}=this;o.globalAlpha=r,o.beginPath(),fh(o,t.axes.length,e,i,s),He(o,1.4,"#ffffff")}drawLabels(t){let{pen:e}=this,i=[];e.font="11px system-ui, sans-serif",e.textAlign="left";for(let{element:s,handle:r,width:o,hidden:a}of[...t].reverse()){let l=this.strength(s,a);if(l<.3||s.onBoard)continue;let c=s.label,h=[r[0]+o/2+5,r[1]-7,e.measureText(c).width+10,14];i.some(u=>NM(h,u))||(i.push(h),e.globalAlpha=.72*l,e.fillStyle="#17191c",e.fillRect(...h),e.globalAlpha=l,e.fillStyle=this.session.colours[s.side],e.fillRect(h[0],h[1],3,h[3]),e.fillStyle="#f4f5f7",e.fillText(c,h[0]+6,h[1]+11))}e.globalAlpha=1}drawPins(){let{pen:t}=this;for(let[e,i,s]of this.pinned??[])s<=0||(si(t,[[e,i],[e+5,i-13]]),He(t,3.5,"#14161a"),He(t,1.6,"#f2f3f5"),Yo(t,[e+5.5,i-15],4.5,"#f08c4b"),t.stroke())}drawPlacing(){if(!this.placing)return;let{pen:t}=this,{from:e,to:i,free:s,refused:r}=this.placing;t.setLineDash([4,4]),si(t,[e,i]),He(t,1.5,r?this.session.colours.right:s?"#9aa0a8":"#7ee787"),t.setLineDash([]),t.beginPath(),t.arc(i[0],i[1],8,0,7),t.stroke()}drawTrail({colour:t,places:e}){let{pen:i,session:s}=this,r=e.filter(({at:c})=>c[2]>0),o=r.findLast(({frame:c})=>c<=s.frame);Object.assign(i,{globalAlpha:1,lineCap:"round",lineJoin:"round"}),si(i,r.map(({at:c})=>c)),He(i,4,"#14161a"),He(i,2,t);let[a,l]=[!1,!0].map(c=>r.filter(({isKey:h})=>h===c));for(let c of[...a,...l,...o?[o]:[]]){let[h,u]=c===o?[4.5,"#ffffff"]:c.isKey?[4,"#f0a94b"]:[1.5,"#f4f5f7"];Yo(i,c.at,h,u),h>2&&He(i,1.5,"#14161a")}}drawMarquee([t,e,i,s]){let{pen:r}=this;r.fillStyle="rgba(120, 170, 255, 0.12)",r.strokeStyle="rgba(150, 190, 255, 0.9)",r.lineWidth=1,r.fillRect(t,e,i-t,s-e),r.strokeRect(t+.5,e+.5,i-t,s-e)}drawStroke(t){let{pen:e}=this;Object.assign(e,{lineCap:"round",lineJoin:"round"}),si(e,[...t,t.at(-1)]),He(e,5.5,"#14161a"),He(e,3,"#f0a94b")}};function si(n,...t){n.beginPath();for(let e of t)e.forEach(([i,s],r)=>r?n.lineTo(i,s):n.moveTo(i,s))}function He(n,t,e,i=null){Object.assign(n,{lineWidth:t,strokeStyle:e}),i?n.stroke(i):n.stroke()}function Yo(n,t,e,i){n.beginPath(),n.arc(t[0],t[1],e,0,7),n.fillStyle=i,n.fill()}function fh(n,t,e,i,s){if(t===1)n.arc(e,i,s,0,7);else{let r=t===2?4:3,o=s*(t===2?1.25:1.4);for(let a=0;a<r;a++){let l=-Math.PI/2+2*Math.PI*a/r;n.lineTo(e+o*Math.cos(l),i+o*Math.sin(l))}}n.closePath()}function LM(n,t,e,i,s){si(n,[[t-i,e-i],[t+i,e+i]],[[t+i,e-i],[t-i,e+i]]),He(n,1.8,s)}var NM=(n,t)=>n[0]<t[0]+t[2]&&t[0]<n[0]+n[2]&&n[1]<t[1]+t[3]&&t[1]<n[1]+n[3],Zo=([n,t])=>Math.atan2(t,n),DM=n=>[...n].sort((t,e)=>Zo(t[1])-Zo(e[1])),OM=(n,t)=>(Zo(t)-Zo(n)+2*Math.PI)%(2*Math.PI);var Jo=class{constructor(t,e){this.points=t,this.triangles=e,this.screen=new Float32Array(t.length),this.invalidate()}invalidate(){this.column=null,this.depths=null}project(t,e){if(this.column===e)return;let{points:i,screen:s}=this,r=t.position,{right:o,above:a,towards:l,half:c}=t,h=e.height/(2*c),u=e.left+e.width/2,d=e.top+e.height/2;for(let f=0;f<i.length;f+=3){let p=i[f]-r[0],x=i[f+1]-r[1],m=i[f+2]-r[2],g=-(p*l[0]+x*l[1]+m*l[2]),_=g>1e-9?h/g:NaN;s[f]=u+(p*o[0]+x*o[1]+m*o[2])*_,s[f+1]=d-(p*a[0]+x*a[1]+m*a[2])*_,s[f+2]=g}this.column=e,this.depths=null}pick(t,e,i,s){this.project(t,e);let{screen:r,triangles:o}=this,a=null;for(let l=0;l<o.length;l+=3){let c=3*o[l],h=3*o[l+1],u=3*o[l+2],d=r[c]-i,f=r[h]-i,p=r[u]-i;if(d>0&&f>0&&p>0||d<0&&f<0&&p<0)continue;let x=r[c+1]-s,m=r[h+1]-s,g=r[u+1]-s,_=f*g-m*p,w=p*x-g*d,y=d*m-x*f;if(!(_>=0&&w>=0&&y>=0||_<=0&&w<=0&&y<=0))continue;let E=_+w+y;if(E===0)continue;let S=E/(_/r[c+2]+w/r[h+2]+y/r[u+2]);(a===null||S<a.depth)&&(a={triangle:l,depth:S,on:[_/E,w/E,y/E]})}return a&&this.hit(a)}hit({triangle:t,depth:e,on:i}){let s=Array.from(this.triangles.subarray(t,t+3)),r=i.map((a,l)=>a*e/this.screen[3*s[l]+2]),o=s[r.indexOf(Math.max(...r))];return{corners:s,shares:r,depth:e,nearest:o}}depthGrid(t,e){if(this.project(t,e),this.depths)return this.depths;let i=Math.ceil(e.width/3)+1,s=Math.ceil(e.height/3)+1,r=new Float32Array(i*s).fill(1/0),{screen:o,triangles:a}=this;for(let l=0;l<a.length;l+=3)FM(r,i,s,o,3*a[l],3*a[l+1],3*a[l+2],e);return this.depths={grid:r,wide:i,high:s},this.depths}hides(t,e,[i,s,r],o){let{grid:a,wide:l,high:c}=this.depthGrid(t,e),h=Math.round((i-e.left)/3),u=Math.round((s-e.top)/3);return h<0||u<0||h>=l||u>=c?!1:a[u*l+h]<r-o}};function FM(n,t,e,i,s,r,o,a){let l=(i[s]-a.left)/3,c=(i[s+1]-a.top)/3,h=(i[r]-a.left)/3,u=(i[r+1]-a.top)/3,d=(i[o]-a.left)/3,f=(i[o+1]-a.top)/3,p=(h-l)*(f-c)-(u-c)*(d-l);if(!(Math.abs(p)>1e-9))return;let x=Math.max(0,Math.ceil(Math.min(l,h,d))),m=Math.min(t-1,Math.floor(Math.max(l,h,d))),g=Math.max(0,Math.ceil(Math.min(c,u,f))),_=Math.min(e-1,Math.floor(Math.max(c,u,f)));for(let w=g;w<=_;w++)for(let y=x;y<=m;y++){let E=((h-y)*(f-w)-(u-w)*(d-y))/p,S=((d-y)*(c-w)-(f-w)*(l-y))/p,v=1-E-S;if(E<0||S<0||v<0)continue;let A=E*i[s+2]+S*i[r+2]+v*i[o+2],L=w*t+y;A<n[L]&&(n[L]=A)}}var xp="/RigUICorrections/",UM={type:"def Scope",metadata:'prepend apiSchemas = ["RigUICorrectionAPI"]'},kM=3,jo=class{constructor(t){this.view=t,this.session=t.session,this.moved=t.session.moved}gesture(t){let{view:e,session:i}=this,{overlay:s}=e,r=s.drawn.find(l=>l.element===t).handle,o=null,a=()=>{s.placing=null,e.changed("overlay")};return{begin:()=>i.select([t]),drag:(l,c,h)=>{o=h.column===e.controlsColumn?e.pick(h):null;let u=o!==null&&!this.holds(t,o.nearest);s.placing={from:r,to:[h.x,h.y],free:!o,refused:u},e.changed("overlay")},drop:()=>{a(),o&&!this.holds(t,o.nearest)?e.say(`${t.label} does not move this point: drop it on the coloured area`):o?this.moveToSkin(t,o.nearest):this.moveBeside(t)},undo:a}}holds(t,e){return t.members.every(({control:i})=>this.session.influence.ofControl(i)[e]>=kM)}moveToSkin(t,e){let i=this.session.options.symmetric?this.mirrorOf(t):null,s=i&&this.partnerOf(e);this.change(`Move ${t.label}`,[t,i].filter(Boolean),()=>{this.anchor(t,e),i&&this.anchor(i,s)})}anchor(t,e){let[i,s]=this.session.meshOf(e);this.session.elements.reanchor(t,i,s,this.session.character.layout.leastTrack);let{meshes:r,metresPerUnit:o,up:a}=this.session.character,l=this.pointsAt(this.session.controls.map(c=>c.default));this.moved.set(t.index,['uniform token rigUI:correction:place = "point"',Ss("uniform point3f rigUI:correction:position",us(l(e))),Ss("uniform vector3f rigUI:correction:up",us(a)),Ss("uniform double rigUI:correction:metersPerUnit",me(o)),Ss("rel rigUI:correction:prim",`<${r[i].path}>`),Ss("uniform int rigUI:correction:pointIndex",s)])}moveBeside(t){this.change(`Move ${t.label} beside the face`,[t],()=>{this.session.elements.putBeside(t),this.moved.set(t.index,['uniform token rigUI:correction:place = "board"'])})}change(t,e,i){let{session:s}=this,r=()=>e.map(c=>[c,s.elements.placement(c),this.moved.get(c.index)]),o=c=>{for(let[h,u,d]of c)s.elements.restore(h,u),d?this.moved.set(h.index,d):this.moved.delete(h.index);s.relayout()},a=r();i();let l=r();s.history.push(t,()=>o(a),()=>o(l)),s.relayout()}mirrorOf(t){let e=this.session.elements.list.find(i=>i.name===t.mirror);return e&&e!==t?e:null}partnerOf(t){let{character:e,rest:i}=this.session,{planeOrigin:s,planeNormal:r}=e.layout,o=this.pointsAt(i),a=ve(o(t),ue(r,2*Et(ve(o(t),s),r))),{start:l,count:c}=e.meshes[this.session.meshOf(t)[0]],h=[1/0,t];for(let u=l;u<l+c;u++){let d=ve(o(u),a);Et(d,d)<h[0]&&(h=[Et(d,d),u])}return h[1]}pointsAt(t){let e=this.session.deformer.posedAside(t);return i=>e.subarray(3*i,3*i+3)}corrections(){let{character:t,controls:e,elements:i}=this.session,s=new Map;s.set(t.root+xp,{type:"def Scope"});for(let[r,o]of this.moved)for(let{control:a}of i.list[r].members){let{name:l}=e[a],c=t.root+xp+l.replace(/\W|^(?=\d)/g,"_");for(;s.has(c);)c+="_";s.set(c,{...UM,lines:[Ss("uniform string rigUI:correction:control",Ve(l)),...o]})}return Mi(s)}},Ss=(n,t)=>`${n} = ${t}`;/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var Bp=0,Gh=1,zp=2;var Dr=1,Gp=2,qs=3,Fi=0,Qe=1,Mn=2,ts=0,$s=1,Vh=2,Hh=3,Wh=4,Vp=5;var es=100,Hp=101,Wp=102,Xp=103,qp=104,$p=200,Yp=201,Kp=202,Zp=203,Xh=204,qh=205,Jp=206,jp=207,Qp=208,tm=209,em=210,nm=211,im=212,sm=213,rm=214,Ma=0,ba=1,wa=2,Bs=3,Sa=4,Aa=5,Ea=6,Ta=7,$h=0,om=1,am=2,$n=0,Yh=1,Kh=2,Zh=3,Jh=4,jh=5,Qh=6,tu=7;var eu=300,ns=301,Ys=302,Qa=303,tl=304,Ca=1e3,Hn=1001,Ra=1002,De=1003,lm=1004;var Or=1005;var Oe=1006,el=1007;var Pn=1008;var un=1009,nu=1010,iu=1011,Ks=1012,nl=1013,Ln=1014,Nn=1015,Dn=1016,il=1017,sl=1018,is=1020,su=35902,ru=35899,ou=1021,au=1022,On=1023,ui=1026,fi=1027,lu=1028,rl=1029,Ui=1030,ol=1031;var al=1033,Fr=33776,Ur=33777,kr=33778,Br=33779,ll=35840,cl=35841,hl=35842,ul=35843,dl=36196,fl=37492,pl=37496,ml=37488,gl=37489,zr=37490,xl=37491,vl=37808,yl=37809,_l=37810,Ml=37811,bl=37812,wl=37813,Sl=37814,Al=37815,El=37816,Tl=37817,Cl=37818,Rl=37819,Il=37820,Pl=37821,Ll=36492,Nl=36494,Dl=36495,Ol=36283,Fl=36284,Gr=36285,Ul=36286;var yr=2300,Ia=2301,ya=2302,Oh=2303,Fh=2400,Uh=2401,kh=2402;var cm=3200;var cu=0,hm=1,pi="",ln="srgb",Zi="srgb-linear",_r="linear",ee="srgb";var _a=7680;var um=519,dm=512,fm=513,pm=514,hu=515,mm=516,gm=517,uu=518,du=519,xm=35044,fu=35048;var pu="300 es",gn=2e3,Mr=2001;function BM(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function zM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function br(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function vm(){let n=br("canvas");return n.style.display="block",n}var vp={},zs=null;function mu(...n){let t="THREE."+n.shift();zs?zs("log",t,...n):console.log(t,...n)}function ym(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Nt(...n){n=ym(n);let t="THREE."+n.shift();if(zs)zs("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function Ft(...n){n=ym(n);let t="THREE."+n.shift();if(zs)zs("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function vr(...n){let t=n.join(" ");t in vp||(vp[t]=!0,Nt(...n))}function _m(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Mm={[Ma]:Ma,[wa]:Ea,[Sa]:Sa,[Bs]:Aa,[ba]:ba,[Ea]:wa,[Ta]:Ta,[Aa]:Bs},Wn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},We=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var ph=Math.PI/180,Pa=180/Math.PI;function Vr(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(We[n&255]+We[n>>8&255]+We[n>>16&255]+We[n>>24&255]+"-"+We[t&255]+We[t>>8&255]+"-"+We[t>>16&15|64]+We[t>>24&255]+"-"+We[e&63|128]+We[e>>8&255]+"-"+We[e>>16&255]+We[e>>24&255]+We[i&255]+We[i>>8&255]+We[i>>16&255]+We[i>>24&255]).toLowerCase()}function Yt(n,t,e){return Math.max(t,Math.min(e,n))}function GM(n,t){return(n%t+t)%t}function mh(n,t,e){return(1-e)*n+e*t}function bm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function gu(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function VM(n,t){if(t.constructor===Float32Array)return n;let e=gu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function HM(n,t){if(t.constructor===Float32Array)return n;let e=gu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var jt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Yt(this.x,t.x,e.x),this.y=Yt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Yt(this.x,t,e),this.y=Yt(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Yt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Yt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Xn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(u!==x||l!==d||c!==f||h!==p){let m=l*d+c*f+h*p+u*x;m<0&&(d=-d,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let _=Math.acos(m),w=Math.sin(_);g=Math.sin(g*_)/w,a=Math.sin(a*_)/w,l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+x*a}else{l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+x*a;let _=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=_,c*=_,h*=_,u*=_}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*u+l*f-c*d,t[e+1]=l*p+h*d+c*u-a*f,t[e+2]=c*p+h*f+a*d-l*u,t[e+3]=h*p-a*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),u=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:Nt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=i+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>u){let f=2*Math.sqrt(1+i-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-i-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Yt(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(yp.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(yp.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),h=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+l*c+o*u-a*h,this.y=i+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Yt(this.x,t.x,e.x),this.y=Yt(this.y,t.y,e.y),this.z=Yt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Yt(this.x,t,e),this.y=Yt(this.y,t,e),this.z=Yt(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Yt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return gh.copy(this).projectOnVector(t),this.sub(gh)}reflect(t){return this.sub(gh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Yt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},gh=new X,yp=new Xn,Ut=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],u=i[7],d=i[2],f=i[5],p=i[8],x=s[0],m=s[3],g=s[6],_=s[1],w=s[4],y=s[7],E=s[2],S=s[5],v=s[8];return r[0]=o*x+a*_+l*E,r[3]=o*m+a*w+l*S,r[6]=o*g+a*y+l*v,r[1]=c*x+h*_+u*E,r[4]=c*m+h*w+u*S,r[7]=c*g+h*y+u*v,r[2]=d*x+f*_+p*E,r[5]=d*m+f*w+p*S,r[8]=d*g+f*y+p*v,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=e*u+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=u*x,t[1]=(s*c-h*i)*x,t[2]=(a*i-s*o)*x,t[3]=d*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(i*l-c*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return vr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(xh.makeScale(t,e)),this}rotate(t){return vr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(xh.makeRotation(-t)),this}translate(t,e){return vr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(xh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},xh=new Ut,_p=new Ut().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Mp=new Ut().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function WM(){let n={enabled:!0,workingColorSpace:Zi,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===ee&&(s.r=hi(s.r),s.g=hi(s.g),s.b=hi(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===ee&&(s.r=ks(s.r),s.g=ks(s.g),s.b=ks(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===pi?_r:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Zi]:{primaries:t,whitePoint:i,transfer:_r,toXYZ:_p,fromXYZ:Mp,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ln},outputColorSpaceConfig:{drawingBufferColorSpace:ln}},[ln]:{primaries:t,whitePoint:i,transfer:ee,toXYZ:_p,fromXYZ:Mp,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ln}}}),n}var Wt=WM();function hi(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ks(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var As,La=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{As===void 0&&(As=br("canvas")),As.width=t.width,As.height=t.height;let s=As.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=As}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=br("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=hi(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(hi(e[i]/255)*255):e[i]=hi(e[i]);return{data:e,width:t.width,height:t.height}}else return Nt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},XM=0,Gs=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:XM++}),this.uuid=Vr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(vh(s[o].image)):r.push(vh(s[o]))}else r=vh(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function vh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?La.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Nt("Texture: Unable to serialize Texture."),{})}var qM=0,yh=new X,nn=class n extends Wn{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Hn,s=Hn,r=Oe,o=Pn,a=On,l=un,c=n.DEFAULT_ANISOTROPY,h=pi){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:qM++}),this.uuid=Vr(),this.name="",this.source=new Gs(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new jt(0,0),this.repeat=new jt(1,1),this.center=new jt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ut,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(yh).x}get height(){return this.source.getSize(yh).y}get depth(){return this.source.getSize(yh).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Nt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Nt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==eu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ca:t.x=t.x-Math.floor(t.x);break;case Hn:t.x=t.x<0?0:1;break;case Ra:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ca:t.y=t.y-Math.floor(t.y);break;case Hn:t.y=t.y<0?0:1;break;case Ra:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};nn.DEFAULT_IMAGE=null;nn.DEFAULT_MAPPING=eu;nn.DEFAULT_ANISOTROPY=1;var ye=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,y=(f+1)/2,E=(g+1)/2,S=(h+d)/4,v=(u+x)/4,A=(p+m)/4;return w>y&&w>E?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=S/i,r=v/i):y>E?y<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),i=S/s,r=A/s):E<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),i=v/r,s=A/r),this.set(i,s,r,e),this}let _=Math.sqrt((m-p)*(m-p)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(_)<.001&&(_=1),this.x=(m-p)/_,this.y=(u-x)/_,this.z=(d-h)/_,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Yt(this.x,t.x,e.x),this.y=Yt(this.y,t.y,e.y),this.z=Yt(this.z,t.z,e.z),this.w=Yt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Yt(this.x,t,e),this.y=Yt(this.y,t,e),this.z=Yt(this.z,t,e),this.w=Yt(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Yt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Na=class extends Wn{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Oe,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new ye(0,0,t,e),this.scissorTest=!1,this.viewport=new ye(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new nn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Oe,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Gs(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},cn=class extends Na{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},wr=class extends nn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=De,this.minFilter=De,this.wrapR=Hn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Da=class extends nn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=De,this.minFilter=De,this.wrapR=Hn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Me=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,h,u,d,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,h,u,d,f,p,x,m)}set(t,e,i,s,r,o,a,l,c,h,u,d,f,p,x,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Es.setFromMatrixColumn(t,0).length(),r=1/Es.setFromMatrixColumn(t,1).length(),o=1/Es.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+p*c,e[5]=d-x*c,e[9]=-a*l,e[2]=x-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d+x*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=x+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d-x*a,e[4]=-o*u,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=x-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=p*c-f,e[8]=d*c+x,e[1]=l*u,e[5]=x*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=x-d*u,e[8]=p*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*u+p,e[10]=d-x*u}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+x,e[5]=o*h,e[9]=f*u-p,e[2]=p*u-f,e[6]=a*h,e[10]=x*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose($M,t,YM)}lookAt(t,e,i){let s=this.elements;return on.subVectors(t,e),on.lengthSq()===0&&(on.z=1),on.normalize(),Ai.crossVectors(i,on),Ai.lengthSq()===0&&(Math.abs(i.z)===1?on.x+=1e-4:on.z+=1e-4,on.normalize(),Ai.crossVectors(i,on)),Ai.normalize(),Qo.crossVectors(on,Ai),s[0]=Ai.x,s[4]=Qo.x,s[8]=on.x,s[1]=Ai.y,s[5]=Qo.y,s[9]=on.y,s[2]=Ai.z,s[6]=Qo.z,s[10]=on.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],u=i[5],d=i[9],f=i[13],p=i[2],x=i[6],m=i[10],g=i[14],_=i[3],w=i[7],y=i[11],E=i[15],S=s[0],v=s[4],A=s[8],L=s[12],T=s[1],I=s[5],D=s[9],F=s[13],R=s[2],k=s[6],W=s[10],z=s[14],tt=s[3],q=s[7],Q=s[11],et=s[15];return r[0]=o*S+a*T+l*R+c*tt,r[4]=o*v+a*I+l*k+c*q,r[8]=o*A+a*D+l*W+c*Q,r[12]=o*L+a*F+l*z+c*et,r[1]=h*S+u*T+d*R+f*tt,r[5]=h*v+u*I+d*k+f*q,r[9]=h*A+u*D+d*W+f*Q,r[13]=h*L+u*F+d*z+f*et,r[2]=p*S+x*T+m*R+g*tt,r[6]=p*v+x*I+m*k+g*q,r[10]=p*A+x*D+m*W+g*Q,r[14]=p*L+x*F+m*z+g*et,r[3]=_*S+w*T+y*R+E*tt,r[7]=_*v+w*I+y*k+E*q,r[11]=_*A+w*D+y*W+E*Q,r[15]=_*L+w*F+y*z+E*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],p=t[3],x=t[7],m=t[11],g=t[15],_=l*f-c*d,w=a*f-c*u,y=a*d-l*u,E=o*f-c*h,S=o*d-l*h,v=o*u-a*h;return e*(x*_-m*w+g*y)-i*(p*_-m*E+g*S)+s*(p*w-x*E+g*v)-r*(p*y-x*S+m*v)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],x=t[13],m=t[14],g=t[15],_=e*a-i*o,w=e*l-s*o,y=e*c-r*o,E=i*l-s*a,S=i*c-r*a,v=s*c-r*l,A=h*x-u*p,L=h*m-d*p,T=h*g-f*p,I=u*m-d*x,D=u*g-f*x,F=d*g-f*m,R=_*F-w*D+y*I+E*T-S*L+v*A;if(R===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let k=1/R;return t[0]=(a*F-l*D+c*I)*k,t[1]=(s*D-i*F-r*I)*k,t[2]=(x*v-m*S+g*E)*k,t[3]=(d*S-u*v-f*E)*k,t[4]=(l*T-o*F-c*L)*k,t[5]=(e*F-s*T+r*L)*k,t[6]=(m*y-p*v-g*w)*k,t[7]=(h*v-d*y+f*w)*k,t[8]=(o*D-a*T+c*A)*k,t[9]=(i*T-e*D-r*A)*k,t[10]=(p*S-x*y+g*_)*k,t[11]=(u*y-h*S-f*_)*k,t[12]=(a*L-o*I-l*A)*k,t[13]=(e*I-i*L+s*A)*k,t[14]=(x*w-p*E-m*_)*k,t[15]=(h*E-u*w+d*_)*k,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,x=o*h,m=o*u,g=a*u,_=l*c,w=l*h,y=l*u,E=i.x,S=i.y,v=i.z;return s[0]=(1-(x+g))*E,s[1]=(f+y)*E,s[2]=(p-w)*E,s[3]=0,s[4]=(f-y)*S,s[5]=(1-(d+g))*S,s[6]=(m+_)*S,s[7]=0,s[8]=(p+w)*v,s[9]=(m-_)*v,s[10]=(1-(d+x))*v,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Es.set(s[0],s[1],s[2]).length(),a=Es.set(s[4],s[5],s[6]).length(),l=Es.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Tn.copy(this);let c=1/o,h=1/a,u=1/l;return Tn.elements[0]*=c,Tn.elements[1]*=c,Tn.elements[2]*=c,Tn.elements[4]*=h,Tn.elements[5]*=h,Tn.elements[6]*=h,Tn.elements[8]*=u,Tn.elements[9]*=u,Tn.elements[10]*=u,e.setFromRotationMatrix(Tn),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=gn,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===gn)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Mr)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=gn,l=!1){let c=this.elements,h=2/(e-t),u=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===gn)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===Mr)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Es=new X,Tn=new Me,$M=new X(0,0,0),YM=new X(1,1,1),Ai=new X,Qo=new X,on=new X,bp=new Me,wp=new Xn,Pi=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Yt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Yt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Yt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Yt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Yt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Yt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Nt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return bp.makeRotationFromQuaternion(t),this.setFromRotationMatrix(bp,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return wp.setFromEuler(this),this.setFromQuaternion(wp,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Pi.DEFAULT_ORDER="XYZ";var Sr=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},KM=0,Sp=new X,Ts=new Xn,ri=new Me,ta=new X,pr=new X,ZM=new X,JM=new Xn,Ap=new X(1,0,0),Ep=new X(0,1,0),Tp=new X(0,0,1),Cp={type:"added"},jM={type:"removed"},Cs={type:"childadded",child:null},_h={type:"childremoved",child:null},vn=class n extends Wn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:KM++}),this.uuid=Vr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new X,e=new Pi,i=new Xn,s=new X(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Me},normalMatrix:{value:new Ut}}),this.matrix=new Me,this.matrixWorld=new Me,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Sr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Ts.setFromAxisAngle(t,e),this.quaternion.multiply(Ts),this}rotateOnWorldAxis(t,e){return Ts.setFromAxisAngle(t,e),this.quaternion.premultiply(Ts),this}rotateX(t){return this.rotateOnAxis(Ap,t)}rotateY(t){return this.rotateOnAxis(Ep,t)}rotateZ(t){return this.rotateOnAxis(Tp,t)}translateOnAxis(t,e){return Sp.copy(t).applyQuaternion(this.quaternion),this.position.add(Sp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Ap,t)}translateY(t){return this.translateOnAxis(Ep,t)}translateZ(t){return this.translateOnAxis(Tp,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ri.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?ta.copy(t):ta.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),pr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ri.lookAt(pr,ta,this.up):ri.lookAt(ta,pr,this.up),this.quaternion.setFromRotationMatrix(ri),s&&(ri.extractRotation(s.matrixWorld),Ts.setFromRotationMatrix(ri),this.quaternion.premultiply(Ts.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Ft("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Cp),Cs.child=t,this.dispatchEvent(Cs),Cs.child=null):Ft("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(jM),_h.child=t,this.dispatchEvent(_h),_h.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ri.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ri.multiply(t.parent.matrixWorld)),t.applyMatrix4(ri),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Cp),Cs.child=t,this.dispatchEvent(Cs),Cs.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(pr,t,ZM),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(pr,JM,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};vn.DEFAULT_UP=new X(0,1,0);vn.DEFAULT_MATRIX_AUTO_UPDATE=!0;vn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ki=class extends vn{constructor(){super(),this.isGroup=!0,this.type="Group"}},QM={type:"move"},Vs=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ki,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ki,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ki,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,i),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(QM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Ki;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},wm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ei={h:0,s:0,l:0},ea={h:0,s:0,l:0};function Mh(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Jt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ln){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Wt.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Wt.workingColorSpace){return this.r=t,this.g=e,this.b=i,Wt.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Wt.workingColorSpace){if(t=GM(t,1),e=Yt(e,0,1),i=Yt(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Mh(o,r,t+1/3),this.g=Mh(o,r,t),this.b=Mh(o,r,t-1/3)}return Wt.colorSpaceToWorking(this,s),this}setStyle(t,e=ln){function i(r){r!==void 0&&parseFloat(r)<1&&Nt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Nt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Nt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ln){let i=wm[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Nt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=hi(t.r),this.g=hi(t.g),this.b=hi(t.b),this}copyLinearToSRGB(t){return this.r=ks(t.r),this.g=ks(t.g),this.b=ks(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ln){return Wt.workingToColorSpace(Xe.copy(this),t),Math.round(Yt(Xe.r*255,0,255))*65536+Math.round(Yt(Xe.g*255,0,255))*256+Math.round(Yt(Xe.b*255,0,255))}getHexString(t=ln){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Wt.workingColorSpace){Wt.workingToColorSpace(Xe.copy(this),e);let i=Xe.r,s=Xe.g,r=Xe.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Wt.workingColorSpace){return Wt.workingToColorSpace(Xe.copy(this),e),t.r=Xe.r,t.g=Xe.g,t.b=Xe.b,t}getStyle(t=ln){Wt.workingToColorSpace(Xe.copy(this),t);let e=Xe.r,i=Xe.g,s=Xe.b;return t!==ln?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Ei),this.setHSL(Ei.h+t,Ei.s+e,Ei.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Ei),t.getHSL(ea);let i=mh(Ei.h,ea.h,e),s=mh(Ei.s,ea.s,e),r=mh(Ei.l,ea.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Xe=new Jt;Jt.NAMES=wm;var Ar=class extends vn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Pi,this.environmentIntensity=1,this.environmentRotation=new Pi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Cn=new X,oi=new X,bh=new X,ai=new X,Rs=new X,Is=new X,Rp=new X,wh=new X,Sh=new X,Ah=new X,Eh=new ye,Th=new ye,Ch=new ye,Ii=class n{constructor(t=new X,e=new X,i=new X){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Cn.subVectors(t,e),s.cross(Cn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Cn.subVectors(s,e),oi.subVectors(i,e),bh.subVectors(t,e);let o=Cn.dot(Cn),a=Cn.dot(oi),l=Cn.dot(bh),c=oi.dot(oi),h=oi.dot(bh),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,ai)===null?!1:ai.x>=0&&ai.y>=0&&ai.x+ai.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,ai)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ai.x),l.addScaledVector(o,ai.y),l.addScaledVector(a,ai.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Eh.setScalar(0),Th.setScalar(0),Ch.setScalar(0),Eh.fromBufferAttribute(t,e),Th.fromBufferAttribute(t,i),Ch.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Eh,r.x),o.addScaledVector(Th,r.y),o.addScaledVector(Ch,r.z),o}static isFrontFacing(t,e,i,s){return Cn.subVectors(i,e),oi.subVectors(t,e),Cn.cross(oi).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Cn.subVectors(this.c,this.b),oi.subVectors(this.a,this.b),Cn.cross(oi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Rs.subVectors(s,i),Is.subVectors(r,i),wh.subVectors(t,i);let l=Rs.dot(wh),c=Is.dot(wh);if(l<=0&&c<=0)return e.copy(i);Sh.subVectors(t,s);let h=Rs.dot(Sh),u=Is.dot(Sh);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(i).addScaledVector(Rs,o);Ah.subVectors(t,r);let f=Rs.dot(Ah),p=Is.dot(Ah);if(p>=0&&f<=p)return e.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(Is,a);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return Rp.subVectors(r,s),a=(u-h)/(u-h+(f-p)),e.copy(s).addScaledVector(Rp,a);let g=1/(m+x+d);return o=x*g,a=d*g,e.copy(i).addScaledVector(Rs,o).addScaledVector(Is,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Li=class{constructor(t=new X(1/0,1/0,1/0),e=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Rn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Rn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Rn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Rn):Rn.fromBufferAttribute(r,o),Rn.applyMatrix4(t.matrixWorld),this.expandByPoint(Rn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),na.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),na.copy(i.boundingBox)),na.applyMatrix4(t.matrixWorld),this.union(na)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Rn),Rn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(mr),ia.subVectors(this.max,mr),Ps.subVectors(t.a,mr),Ls.subVectors(t.b,mr),Ns.subVectors(t.c,mr),Ti.subVectors(Ls,Ps),Ci.subVectors(Ns,Ls),Xi.subVectors(Ps,Ns);let e=[0,-Ti.z,Ti.y,0,-Ci.z,Ci.y,0,-Xi.z,Xi.y,Ti.z,0,-Ti.x,Ci.z,0,-Ci.x,Xi.z,0,-Xi.x,-Ti.y,Ti.x,0,-Ci.y,Ci.x,0,-Xi.y,Xi.x,0];return!Rh(e,Ps,Ls,Ns,ia)||(e=[1,0,0,0,1,0,0,0,1],!Rh(e,Ps,Ls,Ns,ia))?!1:(sa.crossVectors(Ti,Ci),e=[sa.x,sa.y,sa.z],Rh(e,Ps,Ls,Ns,ia))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Rn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Rn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(li[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),li[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),li[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),li[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),li[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),li[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),li[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),li[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(li),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},li=[new X,new X,new X,new X,new X,new X,new X,new X],Rn=new X,na=new Li,Ps=new X,Ls=new X,Ns=new X,Ti=new X,Ci=new X,Xi=new X,mr=new X,ia=new X,sa=new X,qi=new X;function Rh(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){qi.fromArray(n,r);let a=s.x*Math.abs(qi.x)+s.y*Math.abs(qi.y)+s.z*Math.abs(qi.z),l=t.dot(qi),c=e.dot(qi),h=i.dot(qi);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Te=new X,ra=new jt,t1=0,je=class extends Wn{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:t1++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=xm,this.updateRanges=[],this.gpuType=Nn,this.version=0,this._normalizationScale=t!==void 0?gu(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)ra.fromBufferAttribute(this,e),ra.applyMatrix3(t),this.setXY(e,ra.x,ra.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Te.fromBufferAttribute(this,e),Te.applyMatrix3(t),this.setXYZ(e,Te.x,Te.y,Te.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Te.fromBufferAttribute(this,e),Te.applyMatrix4(t),this.setXYZ(e,Te.x,Te.y,Te.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Te.fromBufferAttribute(this,e),Te.applyNormalMatrix(t),this.setXYZ(e,Te.x,Te.y,Te.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Te.fromBufferAttribute(this,e),Te.transformDirection(t),this.setXYZ(e,Te.x,Te.y,Te.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):VM(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):HM(t,this.array)}};var Er=class extends je{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Tr=class extends je{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var xn=class extends je{constructor(t,e,i){super(new Float32Array(t),e,i)}},e1=new Li,gr=new X,Ih=new X,Hs=class{constructor(t=new X,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):e1.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;gr.subVectors(t,this.center);let e=gr.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(gr,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Ih.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(gr.copy(t.center).add(Ih)),this.expandByPoint(gr.copy(t.center).sub(Ih))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},n1=0,mn=new Me,Ph=new vn,Ds=new X,an=new Li,xr=new Li,Ne=new X,qn=class n extends Wn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:n1++}),this.uuid=Vr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(BM(t)?Tr:Er)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Ut().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return mn.makeRotationFromQuaternion(t),this.applyMatrix4(mn),this}rotateX(t){return mn.makeRotationX(t),this.applyMatrix4(mn),this}rotateY(t){return mn.makeRotationY(t),this.applyMatrix4(mn),this}rotateZ(t){return mn.makeRotationZ(t),this.applyMatrix4(mn),this}translate(t,e,i){return mn.makeTranslation(t,e,i),this.applyMatrix4(mn),this}scale(t,e,i){return mn.makeScale(t,e,i),this.applyMatrix4(mn),this}lookAt(t){return Ph.lookAt(t),Ph.updateMatrix(),this.applyMatrix4(Ph.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ds).negate(),this.translate(Ds.x,Ds.y,Ds.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new xn(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Nt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Li);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ft("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];an.setFromBufferAttribute(r),this.morphTargetsRelative?(Ne.addVectors(this.boundingBox.min,an.min),this.boundingBox.expandByPoint(Ne),Ne.addVectors(this.boundingBox.max,an.max),this.boundingBox.expandByPoint(Ne)):(this.boundingBox.expandByPoint(an.min),this.boundingBox.expandByPoint(an.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ft('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Hs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ft("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(t){let i=this.boundingSphere.center;if(an.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];xr.setFromBufferAttribute(a),this.morphTargetsRelative?(Ne.addVectors(an.min,xr.min),an.expandByPoint(Ne),Ne.addVectors(an.max,xr.max),an.expandByPoint(Ne)):(an.expandByPoint(xr.min),an.expandByPoint(xr.max))}an.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Ne.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Ne));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Ne.fromBufferAttribute(a,c),l&&(Ds.fromBufferAttribute(t,c),Ne.add(Ds)),s=Math.max(s,i.distanceToSquared(Ne))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ft('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Ft("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new je(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let L=0;L<i.count;L++)a[L]=new X,l[L]=new X;let h=new X,u=new X,d=new X,f=new jt,p=new jt,x=new jt,m=new X,g=new X;function _(L,T,I){c[L]=c[T]=c[I]=1,h.fromBufferAttribute(i,L),u.fromBufferAttribute(i,T),d.fromBufferAttribute(i,I),f.fromBufferAttribute(r,L),p.fromBufferAttribute(r,T),x.fromBufferAttribute(r,I),u.sub(h),d.sub(h),p.sub(f),x.sub(f);let D=1/(p.x*x.y-x.x*p.y);isFinite(D)&&(m.copy(u).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(D),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(D),a[L].add(m),a[T].add(m),a[I].add(m),l[L].add(g),l[T].add(g),l[I].add(g))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let L=0,T=w.length;L<T;++L){let I=w[L],D=I.start,F=I.count;for(let R=D,k=D+F;R<k;R+=3)_(t.getX(R+0),t.getX(R+1),t.getX(R+2))}let y=new X,E=new X,S=new X,v=new X;function A(L){S.fromBufferAttribute(s,L),v.copy(S);let T=a[L];y.copy(T),y.sub(S.multiplyScalar(S.dot(T))).normalize(),E.crossVectors(v,T);let D=E.dot(l[L])<0?-1:1;o.setXYZW(L,y.x,y.y,y.z,D)}for(let L=0,T=i.count;L<T;++L)c[L]&&A(L);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new je(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new X,r=new X,o=new X,a=new X,l=new X,c=new X,h=new X,u=new X;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),x=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,m),a.add(h),l.add(h),c.add(h),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Ne.fromBufferAttribute(t,e),Ne.normalize(),t.setXYZ(e,Ne.x,Ne.y,Ne.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*h;for(let g=0;g<h;g++)d[p++]=c[f++]}return new je(d,h,u)}if(this.index===null)return Nt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Lh=new X,i1=new X,s1=new Ut,In=class{constructor(t=new X(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Lh.subVectors(i,e).cross(i1.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Lh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||s1.getNormalMatrix(t),s=this.coplanarPoint(Lh).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},r1=0,Ji=class extends Wn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:r1++}),this.uuid=Vr(),this.name="",this.type="Material",this.blending=$s,this.side=Fi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Xh,this.blendDst=qh,this.blendEquation=es,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Jt(0,0,0),this.blendAlpha=0,this.depthFunc=Bs,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=um,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=_a,this.stencilZFail=_a,this.stencilZPass=_a,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Nt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Nt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Jt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new In().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new jt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new jt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var ci=new X,Nh=new X,oa=new X,aa=new X,Oa=class{constructor(t=new X,e=new X(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ci)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ci.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ci.copy(this.origin).addScaledVector(this.direction,e),ci.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Nh.copy(t).add(e).multiplyScalar(.5),oa.copy(e).sub(t).normalize(),aa.copy(this.origin).sub(Nh);let r=t.distanceTo(e)*.5,o=-this.direction.dot(oa),a=aa.dot(this.direction),l=-aa.dot(oa),c=aa.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let x=1/h;u*=x,d*=x,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Nh).addScaledVector(oa,d),f}intersectSphere(t,e){if(t.radius<0)return null;ci.subVectors(t.center,this.origin);let i=ci.dot(this.direction),s=ci.dot(ci)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,ci)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,x=e.y-o.y,m=e.z-o.z,g=i.x-o.x,_=i.y-o.y,w=i.z-o.z,y=Math.abs(l),E=Math.abs(c),S=Math.abs(h),v,A,L,T,I,D,F,R,k,W,z,tt;if(y>=E&&y>=S?(L=l,D=u,k=p,tt=g,l>=0?(v=c,A=h,T=d,I=f,F=x,R=m,W=_,z=w):(v=h,A=c,T=f,I=d,F=m,R=x,W=w,z=_)):E>=S?(L=c,D=d,k=x,tt=_,c>=0?(v=h,A=l,T=f,I=u,F=m,R=p,W=w,z=g):(v=l,A=h,T=u,I=f,F=p,R=m,W=g,z=w)):(L=h,D=f,k=m,tt=w,h>=0?(v=l,A=c,T=u,I=d,F=p,R=x,W=g,z=_):(v=c,A=l,T=d,I=u,F=x,R=p,W=_,z=g)),L===0)return null;let q=v/L,Q=A/L,et=1/L,_t=T-q*D,Dt=I-Q*D,K=F-q*k,pt=R-Q*k,yt=W-q*tt,St=z-Q*tt,ht=yt*pt-St*K,It=_t*St-Dt*yt,ae=K*Dt-pt*_t;if(s){if(ht<0||It<0||ae<0)return null}else if((ht<0||It<0||ae<0)&&(ht>0||It>0||ae>0))return null;let Ct=ht+It+ae;if(Ct===0)return null;let $t=et*(ht*D+It*k+ae*tt);return(Ct>0?$t<0:$t>0)?null:this.at($t/Ct,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Fa=class extends Ji{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Jt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pi,this.combine=$h,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Ip=new Me,$i=new Oa,la=new Hs,Pp=new X,ca=new X,ha=new X,ua=new X,Dh=new X,da=new X,Lp=new X,fa=new X,yn=class extends vn{constructor(t=new qn,e=new Fa){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){da.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Dh.fromBufferAttribute(u,t),o?da.addScaledVector(Dh,h):da.addScaledVector(Dh.sub(e),h))}e.add(da)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),la.copy(i.boundingSphere),la.applyMatrix4(r),$i.copy(t.ray).recast(t.near),!(la.containsPoint($i.origin)===!1&&($i.intersectSphere(la,Pp)===null||$i.origin.distanceToSquared(Pp)>(t.far-t.near)**2))&&(Ip.copy(r).invert(),$i.copy(t.ray).applyMatrix4(Ip),!(i.boundingBox!==null&&$i.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,$i)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),w=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let y=_,E=w;y<E;y+=3){let S=a.getX(y),v=a.getX(y+1),A=a.getX(y+2);s=pa(this,g,t,i,c,h,u,S,v,A),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let _=a.getX(m),w=a.getX(m+1),y=a.getX(m+2);s=pa(this,o,t,i,c,h,u,_,w,y),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),w=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let y=_,E=w;y<E;y+=3){let S=y,v=y+1,A=y+2;s=pa(this,g,t,i,c,h,u,S,v,A),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let _=m,w=m+1,y=m+2;s=pa(this,o,t,i,c,h,u,_,w,y),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function o1(n,t,e,i,s,r,o,a){let l;if(t.side===Qe?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Fi,a),l===null)return null;fa.copy(a),fa.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(fa);return c<e.near||c>e.far?null:{distance:c,point:fa.clone(),object:n}}function pa(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,ca),n.getVertexPosition(l,ha),n.getVertexPosition(c,ua);let h=o1(n,t,e,i,ca,ha,ua,Lp);if(h){let u=new X;Ii.getBarycoord(Lp,ca,ha,ua,u),s&&(h.uv=Ii.getInterpolatedAttribute(s,a,l,c,u,new jt)),r&&(h.uv1=Ii.getInterpolatedAttribute(r,a,l,c,u,new jt)),o&&(h.normal=Ii.getInterpolatedAttribute(o,a,l,c,u,new X),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new X,materialIndex:0};Ii.getNormal(ca,ha,ua,d.normal),h.face=d,h.barycoord=u}return h}var ji=class extends nn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=De,h=De,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Yi=new Hs,a1=new jt(.5,.5),ma=new X,Qi=class{constructor(t=new In,e=new In,i=new In,s=new In,r=new In,o=new In){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=gn,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],x=r[9],m=r[10],g=r[11],_=r[12],w=r[13],y=r[14],E=r[15];if(s[0].setComponents(c-o,f-h,g-p,E-_).normalize(),s[1].setComponents(c+o,f+h,g+p,E+_).normalize(),s[2].setComponents(c+a,f+u,g+x,E+w).normalize(),s[3].setComponents(c-a,f-u,g-x,E-w).normalize(),i)s[4].setComponents(l,d,m,y).normalize(),s[5].setComponents(c-l,f-d,g-m,E-y).normalize();else if(s[4].setComponents(c-l,f-d,g-m,E-y).normalize(),e===gn)s[5].setComponents(c+l,f+d,g+m,E+y).normalize();else if(e===Mr)s[5].setComponents(l,d,m,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Yi.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Yi.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Yi)}intersectsSprite(t){Yi.center.set(0,0,0);let e=a1.distanceTo(t.center);return Yi.radius=.7071067811865476+e,Yi.applyMatrix4(t.matrixWorld),this.intersectsSphere(Yi)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(ma.x=s.normal.x>0?t.max.x:t.min.x,ma.y=s.normal.y>0?t.max.y:t.min.y,ma.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ma)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Np=new Me,Ua=class n{constructor(){this.coordinateSystem=gn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Np.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Qi),i[s].setFromProjectionMatrix(Np,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Qi),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Cr=class extends nn{constructor(t=[],e=ns,i,s,r,o,a,l,c,h){super(t,e,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var di=class extends nn{constructor(t,e,i=Ln,s,r,o,a=De,l=De,c,h=ui,u=1){if(h!==ui&&h!==fi)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Gs(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Rr=class extends di{constructor(t,e=Ln,i=ns,s,r,o=De,a=De,l,c=ui){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Ir=class extends nn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Ws=class n extends qn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new xn(c,3)),this.setAttribute("normal",new xn(h,3)),this.setAttribute("uv",new xn(u,2));function p(x,m,g,_,w,y,E,S,v,A,L){let T=y/v,I=E/A,D=y/2,F=E/2,R=S/2,k=v+1,W=A+1,z=0,tt=0,q=new X;for(let Q=0;Q<W;Q++){let et=Q*I-F;for(let _t=0;_t<k;_t++){let Dt=_t*T-D;q[x]=Dt*_,q[m]=et*w,q[g]=R,c.push(q.x,q.y,q.z),q[x]=0,q[m]=0,q[g]=S>0?1:-1,h.push(q.x,q.y,q.z),u.push(_t/v),u.push(1-Q/A),z+=1}}for(let Q=0;Q<A;Q++)for(let et=0;et<v;et++){let _t=d+et+k*Q,Dt=d+et+k*(Q+1),K=d+(et+1)+k*(Q+1),pt=d+(et+1)+k*Q;l.push(_t,Dt,pt),l.push(Dt,K,pt),tt+=6}a.addGroup(f,tt,L),f+=tt,d+=z}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Pr=class n extends qn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,f=[],p=[],x=[],m=[];for(let g=0;g<h;g++){let _=g*d-o;for(let w=0;w<c;w++){let y=w*u-r;p.push(y,-_,0),x.push(0,0,1),m.push(w/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let _=0;_<a;_++){let w=_+c*g,y=_+c*(g+1),E=_+1+c*(g+1),S=_+1+c*g;f.push(w,y,S),f.push(y,E,S)}this.setIndex(f),this.setAttribute("position",new xn(p,3)),this.setAttribute("normal",new xn(x,3)),this.setAttribute("uv",new xn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};function ss(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Dp(s))s.isRenderTargetTexture?(Nt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Dp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function qe(n){let t={};for(let e=0;e<n.length;e++){let i=ss(n[e]);for(let s in i)t[s]=i[s]}return t}function Dp(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function l1(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function xu(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Wt.workingColorSpace}var Sm={clone:ss,merge:qe},c1=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,h1=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,_n=class extends Ji{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=c1,this.fragmentShader=h1,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=ss(t.uniforms),this.uniformsGroups=l1(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new Jt().setHex(s.value);break;case"v2":this.uniforms[i].value=new jt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new X().fromArray(s.value);break;case"v4":this.uniforms[i].value=new ye().fromArray(s.value);break;case"m3":this.uniforms[i].value=new Ut().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Me().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},ka=class extends _n{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ba=class extends Ji{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=cm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},za=class extends Ji{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Os(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function ga(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ni=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ga=class extends Ni{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Fh,endingEnd:Fh}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Uh:r=t,a=2*e-i;break;case kh:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Uh:o=t,l=2*i-e;break;case kh:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),x=p*p,m=x*p,g=-d*m+2*d*x-d*p,_=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*p+1,w=(-1-f)*m+(1.5+f)*x+.5*p,y=f*m-f*x;for(let E=0;E!==a;++E)r[E]=g*o[h+E]+_*o[c+E]+w*o[l+E]+y*o[u+E];return r}},Va=class extends Ni{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(i-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Ha=class extends Ni{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Wa=class extends Ni{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(i-e)/(s-e),x=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=f*d+p*2,_=u[g],w=u[g+1],y=t*d+p*2,E=h[y],S=h[y+1],v=d1(i,e,_,E,s);r[p]=Am(v,x,w,S,m)}return r}};function Am(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function u1(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function d1(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=Am(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=u1(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var hn=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Os(e,this.TimeBufferType),this.values=Os(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Os(t.times,Array),values:Os(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),ga(t.settings)&&(i.settings={inTangents:Os(t.settings.inTangents,Array),outTangents:Os(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Ha(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Va(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ga(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Wa(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case yr:e=this.InterpolantFactoryMethodDiscrete;break;case Ia:e=this.InterpolantFactoryMethodLinear;break;case ya:e=this.InterpolantFactoryMethodSmooth;break;case Oh:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Nt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return yr;case this.InterpolantFactoryMethodLinear:return Ia;case this.InterpolantFactoryMethodSmooth:return ya;case this.InterpolantFactoryMethodBezier:return Oh}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;ga(this.settings)&&(Op(this.settings.inTangents,t),Op(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;ga(this.settings)&&(Fp(this.settings.inTangents,t),Fp(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Ft("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Ft("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Ft("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){Ft("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&zM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Ft("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===ya,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*i,d=u-i,f=u+i;for(let p=0;p!==i;++p){let x=e[u+p];if(x!==e[d+p]||x!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,ga(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Op(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Fp(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}hn.prototype.ValueTypeName="";hn.prototype.TimeBufferType=Float32Array;hn.prototype.ValueBufferType=Float32Array;hn.prototype.DefaultInterpolation=Ia;var Di=class extends hn{constructor(t,e,i){super(t,e,i)}};Di.prototype.ValueTypeName="bool";Di.prototype.ValueBufferType=Array;Di.prototype.DefaultInterpolation=yr;Di.prototype.InterpolantFactoryMethodLinear=void 0;Di.prototype.InterpolantFactoryMethodSmooth=void 0;var Xa=class extends hn{constructor(t,e,i,s){super(t,e,i,s)}};Xa.prototype.ValueTypeName="color";var qa=class extends hn{constructor(t,e,i,s){super(t,e,i,s)}};qa.prototype.ValueTypeName="number";var $a=class extends Ni{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Xn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Lr=class extends hn{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new $a(this.times,this.values,this.getValueSize(),t)}};Lr.prototype.ValueTypeName="quaternion";Lr.prototype.InterpolantFactoryMethodSmooth=void 0;var Oi=class extends hn{constructor(t,e,i){super(t,e,i)}};Oi.prototype.ValueTypeName="string";Oi.prototype.ValueBufferType=Array;Oi.prototype.DefaultInterpolation=yr;Oi.prototype.InterpolantFactoryMethodLinear=void 0;Oi.prototype.InterpolantFactoryMethodSmooth=void 0;var Ya=class extends hn{constructor(t,e,i,s){super(t,e,i,s)}};Ya.prototype.ValueTypeName="vector";var Ka=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Em=new Ka,Za=class{constructor(t){this.manager=t!==void 0?t:Em,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Za.DEFAULT_MATERIAL_NAME="__DEFAULT";var xa=new X,va=new Xn,Vn=new X,Nr=class extends vn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Me,this.projectionMatrix=new Me,this.projectionMatrixInverse=new Me,this.coordinateSystem=gn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(xa,va,Vn),Vn.x===1&&Vn.y===1&&Vn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(xa,va,Vn.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(xa,va,Vn),Vn.x===1&&Vn.y===1&&Vn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(xa,va,Vn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ri=new X,Up=new jt,kp=new jt,Je=class extends Nr{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Pa*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ph*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Pa*2*Math.atan(Math.tan(ph*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Ri.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ri.x,Ri.y).multiplyScalar(-t/Ri.z),Ri.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ri.x,Ri.y).multiplyScalar(-t/Ri.z)}getViewSize(t,e){return this.getViewBounds(t,Up,kp),e.subVectors(kp,Up)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ph*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ja=class extends Nr{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var Fs=-90,Us=1,Xs=class extends vn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Je(Fs,Us,t,e);s.layers=this.layers,this.add(s);let r=new Je(Fs,Us,t,e);r.layers=this.layers,this.add(r);let o=new Je(Fs,Us,t,e);o.layers=this.layers,this.add(o);let a=new Je(Fs,Us,t,e);a.layers=this.layers,this.add(a);let l=new Je(Fs,Us,t,e);l.layers=this.layers,this.add(l);let c=new Je(Fs,Us,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===gn)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Mr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},ja=class extends Je{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var vu="\\[\\]\\.:\\/",f1=new RegExp("["+vu+"]","g"),yu="[^"+vu+"]",p1="[^"+vu.replace("\\.","")+"]",m1=/((?:WC+[\/:])*)/.source.replace("WC",yu),g1=/(WCOD+)?/.source.replace("WCOD",p1),x1=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",yu),v1=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",yu),y1=new RegExp("^"+m1+g1+x1+v1+"$"),_1=["material","materials","bones","map"],Bh=class{constructor(t,e,i){let s=i||de.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},de=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(f1,"")}static parseTrackName(t){let e=y1.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);_1.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Nt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){Ft("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Ft("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Ft("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Ft("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Ft("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){Ft("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){Ft("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;Ft("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Ft("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Ft("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};de.Composite=Bh;de.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};de.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};de.prototype.GetterByBindingType=[de.prototype._getValue_direct,de.prototype._getValue_array,de.prototype._getValue_arrayElement,de.prototype._getValue_toArray];de.prototype.SetterByBindingTypeAndVersioning=[[de.prototype._setValue_direct,de.prototype._setValue_direct_setNeedsUpdate,de.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[de.prototype._setValue_array,de.prototype._setValue_array_setNeedsUpdate,de.prototype._setValue_array_setMatrixWorldNeedsUpdate],[de.prototype._setValue_arrayElement,de.prototype._setValue_arrayElement_setNeedsUpdate,de.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[de.prototype._setValue_fromArray,de.prototype._setValue_fromArray_setNeedsUpdate,de.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var CC=new Float32Array(1);var zh=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};function _u(n,t,e,i){let s=M1(i);switch(e){case ou:return n*t;case lu:return n*t/s.components*s.byteLength;case rl:return n*t/s.components*s.byteLength;case Ui:return n*t*2/s.components*s.byteLength;case ol:return n*t*2/s.components*s.byteLength;case au:return n*t*3/s.components*s.byteLength;case On:return n*t*4/s.components*s.byteLength;case al:return n*t*4/s.components*s.byteLength;case Fr:case Ur:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case kr:case Br:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case cl:case ul:return Math.max(n,16)*Math.max(t,8)/4;case ll:case hl:return Math.max(n,8)*Math.max(t,8)/2;case dl:case fl:case ml:case gl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case pl:case zr:case xl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case vl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case yl:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case _l:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Ml:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case bl:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case wl:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Sl:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Al:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case El:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Tl:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Cl:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Rl:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Il:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Pl:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Ll:case Nl:case Dl:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Ol:case Fl:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Gr:case Ul:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function M1(n){switch(n){case un:case nu:return{byteLength:1,components:1};case Ks:case iu:case Dn:return{byteLength:2,components:1};case il:case sl:return{byteLength:2,components:4};case Ln:case nl:case Nn:return{byteLength:4,components:1};case su:case ru:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Nt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Ym(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function w1(n){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],x=u[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let x=u[f];n.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var S1=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,A1=`#ifdef USE_ALPHAHASH
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
#endif`,E1=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,T1=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,C1=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,R1=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,I1=`#ifdef USE_AOMAP
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
#endif`,P1=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,L1=`#ifdef USE_BATCHING
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
#endif`,N1=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,D1=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,O1=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,F1=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,U1=`#ifdef USE_IRIDESCENCE
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
#endif`,k1=`#ifdef USE_BUMPMAP
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
#endif`,B1=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,z1=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,G1=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,V1=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,H1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,W1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,X1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,q1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,$1=`#define PI 3.141592653589793
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
} // validated`,Y1=`vec3 transformedNormal = objectNormal;
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
#endif`,K1=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Z1=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,J1=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,j1=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Q1="gl_FragColor = linearToOutputTexel( gl_FragColor );",tb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,eb=`#ifdef USE_ENVMAP
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
#endif`,nb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ib=`#ifdef USE_ENVMAP
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
#endif`,sb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,rb=`#ifdef USE_ENVMAP
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
#endif`,ob=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,ab=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,lb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,cb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,hb=`#ifdef USE_GRADIENTMAP
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
}`,ub=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,db=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,fb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,pb=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,mb=`#ifdef USE_ENVMAP
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
#endif`,gb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,xb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,vb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,yb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,_b=`PhysicalMaterial material;
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
#endif`,Mb=`uniform sampler2D dfgLUT;
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
}`,bb=`
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
#endif`,wb=`#if defined( RE_IndirectDiffuse )
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
#endif`,Sb=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Ab=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Eb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Tb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Cb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Rb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ib=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Pb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Lb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Nb=`#if defined( USE_POINTS_UV )
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
#endif`,Db=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Ob=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Fb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Ub=`#if defined( USE_MORPHCOLORS )
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
#endif`,kb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Bb=`#ifdef USE_MORPHTARGETS
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
#endif`,zb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Gb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Vb=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Hb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Wb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Xb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,qb=`#ifdef USE_NORMALMAP
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
#endif`,$b=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Yb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Kb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Zb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Jb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,jb=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Qb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,tw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,ew=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,nw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,iw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,sw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,rw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,ow=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,aw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,lw=`float getShadowMask() {
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
}`,cw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,hw=`#ifdef USE_SKINNING
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
#endif`,uw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,dw=`#ifdef USE_SKINNING
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
#endif`,fw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,pw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,mw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,gw=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,xw=`#ifdef USE_TRANSMISSION
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
#endif`,vw=`#ifdef USE_TRANSMISSION
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
#endif`,yw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,_w=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Mw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,bw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,ww=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Sw=`uniform sampler2D t2D;
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
}`,Aw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Ew=`uniform float backgroundBlurriness;
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
}`,Tw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Cw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Rw=`#include <common>
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
}`,Iw=`#if DEPTH_PACKING == 3200
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
}`,Pw=`#define DISTANCE
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
}`,Lw=`#define DISTANCE
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
}`,Nw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Dw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ow=`uniform float scale;
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
}`,Fw=`uniform vec3 diffuse;
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
}`,Uw=`#include <common>
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
}`,kw=`uniform vec3 diffuse;
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
}`,Bw=`#define LAMBERT
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
}`,zw=`#define LAMBERT
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
}`,Gw=`#define MATCAP
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
}`,Vw=`#define MATCAP
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
}`,Hw=`#define NORMAL
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
}`,Ww=`#define NORMAL
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
}`,Xw=`#define PHONG
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
}`,qw=`#define PHONG
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
}`,$w=`#define STANDARD
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
}`,Yw=`#define STANDARD
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
}`,Kw=`#define TOON
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
}`,Zw=`#define TOON
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
}`,Jw=`uniform float size;
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
}`,jw=`uniform vec3 diffuse;
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
}`,Qw=`#include <common>
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
}`,tS=`uniform vec3 color;
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
}`,eS=`uniform float rotation;
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
}`,nS=`uniform vec3 diffuse;
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
}`,Ht={alphahash_fragment:S1,alphahash_pars_fragment:A1,alphamap_fragment:E1,alphamap_pars_fragment:T1,alphatest_fragment:C1,alphatest_pars_fragment:R1,aomap_fragment:I1,aomap_pars_fragment:P1,batching_pars_vertex:L1,batching_vertex:N1,begin_vertex:D1,beginnormal_vertex:O1,bsdfs:F1,iridescence_fragment:U1,bumpmap_pars_fragment:k1,clipping_planes_fragment:B1,clipping_planes_pars_fragment:z1,clipping_planes_pars_vertex:G1,clipping_planes_vertex:V1,color_fragment:H1,color_pars_fragment:W1,color_pars_vertex:X1,color_vertex:q1,common:$1,defaultnormal_vertex:Y1,displacementmap_pars_vertex:K1,displacementmap_vertex:Z1,emissivemap_fragment:J1,emissivemap_pars_fragment:j1,colorspace_fragment:Q1,colorspace_pars_fragment:tb,envmap_fragment:eb,envmap_common_pars_fragment:nb,envmap_pars_fragment:ib,envmap_pars_vertex:sb,envmap_physical_pars_fragment:mb,envmap_vertex:rb,fog_vertex:ob,fog_pars_vertex:ab,fog_fragment:lb,fog_pars_fragment:cb,gradientmap_pars_fragment:hb,lightmap_pars_fragment:ub,lights_lambert_fragment:db,lights_lambert_pars_fragment:fb,lights_pars_begin:pb,lights_toon_fragment:gb,lights_toon_pars_fragment:xb,lights_phong_fragment:vb,lights_phong_pars_fragment:yb,lights_physical_fragment:_b,lights_physical_pars_fragment:Mb,lights_fragment_begin:bb,lights_fragment_maps:wb,lights_fragment_end:Sb,lightprobes_pars_fragment:Ab,logdepthbuf_fragment:Eb,logdepthbuf_pars_fragment:Tb,logdepthbuf_pars_vertex:Cb,logdepthbuf_vertex:Rb,map_fragment:Ib,map_pars_fragment:Pb,map_particle_fragment:Lb,map_particle_pars_fragment:Nb,metalnessmap_fragment:Db,metalnessmap_pars_fragment:Ob,morphinstance_vertex:Fb,morphcolor_vertex:Ub,morphnormal_vertex:kb,morphtarget_pars_vertex:Bb,morphtarget_vertex:zb,normal_fragment_begin:Gb,normal_fragment_maps:Vb,normal_pars_fragment:Hb,normal_pars_vertex:Wb,normal_vertex:Xb,normalmap_pars_fragment:qb,clearcoat_normal_fragment_begin:$b,clearcoat_normal_fragment_maps:Yb,clearcoat_pars_fragment:Kb,iridescence_pars_fragment:Zb,opaque_fragment:Jb,packing:jb,premultiplied_alpha_fragment:Qb,project_vertex:tw,dithering_fragment:ew,dithering_pars_fragment:nw,roughnessmap_fragment:iw,roughnessmap_pars_fragment:sw,shadowmap_pars_fragment:rw,shadowmap_pars_vertex:ow,shadowmap_vertex:aw,shadowmask_pars_fragment:lw,skinbase_vertex:cw,skinning_pars_vertex:hw,skinning_vertex:uw,skinnormal_vertex:dw,specularmap_fragment:fw,specularmap_pars_fragment:pw,tonemapping_fragment:mw,tonemapping_pars_fragment:gw,transmission_fragment:xw,transmission_pars_fragment:vw,uv_pars_fragment:yw,uv_pars_vertex:_w,uv_vertex:Mw,worldpos_vertex:bw,background_vert:ww,background_frag:Sw,backgroundCube_vert:Aw,backgroundCube_frag:Ew,cube_vert:Tw,cube_frag:Cw,depth_vert:Rw,depth_frag:Iw,distance_vert:Pw,distance_frag:Lw,equirect_vert:Nw,equirect_frag:Dw,linedashed_vert:Ow,linedashed_frag:Fw,meshbasic_vert:Uw,meshbasic_frag:kw,meshlambert_vert:Bw,meshlambert_frag:zw,meshmatcap_vert:Gw,meshmatcap_frag:Vw,meshnormal_vert:Hw,meshnormal_frag:Ww,meshphong_vert:Xw,meshphong_frag:qw,meshphysical_vert:$w,meshphysical_frag:Yw,meshtoon_vert:Kw,meshtoon_frag:Zw,points_vert:Jw,points_frag:jw,shadow_vert:Qw,shadow_frag:tS,sprite_vert:eS,sprite_frag:nS},gt={common:{diffuse:{value:new Jt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ut},alphaMap:{value:null},alphaMapTransform:{value:new Ut},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ut}},envmap:{envMap:{value:null},envMapRotation:{value:new Ut},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ut}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ut}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ut},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ut},normalScale:{value:new jt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ut},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ut}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ut}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ut}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Jt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Jt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ut},alphaTest:{value:0},uvTransform:{value:new Ut}},sprite:{diffuse:{value:new Jt(16777215)},opacity:{value:1},center:{value:new jt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ut},alphaMap:{value:null},alphaMapTransform:{value:new Ut},alphaTest:{value:0}}},Kn={basic:{uniforms:qe([gt.common,gt.specularmap,gt.envmap,gt.aomap,gt.lightmap,gt.fog]),vertexShader:Ht.meshbasic_vert,fragmentShader:Ht.meshbasic_frag},lambert:{uniforms:qe([gt.common,gt.specularmap,gt.envmap,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.fog,gt.lights,{emissive:{value:new Jt(0)},envMapIntensity:{value:1}}]),vertexShader:Ht.meshlambert_vert,fragmentShader:Ht.meshlambert_frag},phong:{uniforms:qe([gt.common,gt.specularmap,gt.envmap,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.fog,gt.lights,{emissive:{value:new Jt(0)},specular:{value:new Jt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Ht.meshphong_vert,fragmentShader:Ht.meshphong_frag},standard:{uniforms:qe([gt.common,gt.envmap,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.roughnessmap,gt.metalnessmap,gt.fog,gt.lights,{emissive:{value:new Jt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Ht.meshphysical_vert,fragmentShader:Ht.meshphysical_frag},toon:{uniforms:qe([gt.common,gt.aomap,gt.lightmap,gt.emissivemap,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.gradientmap,gt.fog,gt.lights,{emissive:{value:new Jt(0)}}]),vertexShader:Ht.meshtoon_vert,fragmentShader:Ht.meshtoon_frag},matcap:{uniforms:qe([gt.common,gt.bumpmap,gt.normalmap,gt.displacementmap,gt.fog,{matcap:{value:null}}]),vertexShader:Ht.meshmatcap_vert,fragmentShader:Ht.meshmatcap_frag},points:{uniforms:qe([gt.points,gt.fog]),vertexShader:Ht.points_vert,fragmentShader:Ht.points_frag},dashed:{uniforms:qe([gt.common,gt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Ht.linedashed_vert,fragmentShader:Ht.linedashed_frag},depth:{uniforms:qe([gt.common,gt.displacementmap]),vertexShader:Ht.depth_vert,fragmentShader:Ht.depth_frag},normal:{uniforms:qe([gt.common,gt.bumpmap,gt.normalmap,gt.displacementmap,{opacity:{value:1}}]),vertexShader:Ht.meshnormal_vert,fragmentShader:Ht.meshnormal_frag},sprite:{uniforms:qe([gt.sprite,gt.fog]),vertexShader:Ht.sprite_vert,fragmentShader:Ht.sprite_frag},background:{uniforms:{uvTransform:{value:new Ut},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Ht.background_vert,fragmentShader:Ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ut}},vertexShader:Ht.backgroundCube_vert,fragmentShader:Ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Ht.cube_vert,fragmentShader:Ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Ht.equirect_vert,fragmentShader:Ht.equirect_frag},distance:{uniforms:qe([gt.common,gt.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Ht.distance_vert,fragmentShader:Ht.distance_frag},shadow:{uniforms:qe([gt.lights,gt.fog,{color:{value:new Jt(0)},opacity:{value:1}}]),vertexShader:Ht.shadow_vert,fragmentShader:Ht.shadow_frag}};Kn.physical={uniforms:qe([Kn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ut},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ut},clearcoatNormalScale:{value:new jt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ut},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ut},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ut},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ut},sheen:{value:0},sheenColor:{value:new Jt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ut},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ut},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ut},transmissionSamplerSize:{value:new jt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ut},attenuationDistance:{value:0},attenuationColor:{value:new Jt(0)},specularColor:{value:new Jt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ut},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ut},anisotropyVector:{value:new jt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ut}}]),vertexShader:Ht.meshphysical_vert,fragmentShader:Ht.meshphysical_frag};var kl={r:0,b:0,g:0},iS=new Me,Km=new Ut;Km.set(-1,0,0,0,1,0,0,0,1);function sS(n,t,e,i,s,r){let o=new Jt(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(_){let w=_.isScene===!0?_.background:null;if(w&&w.isTexture){let y=_.backgroundBlurriness>0;w=t.get(w,y)}return w}function p(_){let w=!1,y=f(_);y===null?m(o,a):y&&y.isColor&&(m(y,1),w=!0);let E=n.xr.getEnvironmentBlendMode();E==="additive"?e.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(_,w){let y=f(w);y&&y.isCubeTexture?(c===void 0&&(c=new yn(new Ws(1,1,1),new _n({name:"BackgroundCubeMaterial",uniforms:ss(Kn.backgroundCube.uniforms),vertexShader:Kn.backgroundCube.vertexShader,fragmentShader:Kn.backgroundCube.fragmentShader,side:Qe,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,S,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=y,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(iS.makeRotationFromEuler(w.backgroundRotation)).transpose(),y.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Km),c.material.toneMapped=Wt.getTransfer(y.colorSpace)!==ee,(h!==y||u!==y.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=y,u=y.version,d=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):y&&y.isTexture&&(l===void 0&&(l=new yn(new Pr(2,2),new _n({name:"BackgroundMaterial",uniforms:ss(Kn.background.uniforms),vertexShader:Kn.background.vertexShader,fragmentShader:Kn.background.fragmentShader,side:Fi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=y,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=Wt.getTransfer(y.colorSpace)!==ee,y.matrixAutoUpdate===!0&&y.updateMatrix(),l.material.uniforms.uvTransform.value.copy(y.matrix),(h!==y||u!==y.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,h=y,u=y.version,d=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function m(_,w){_.getRGB(kl,xu(n)),e.buffers.color.setClear(kl.r,kl.g,kl.b,w,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,w=1){o.set(_),a=w,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,m(o,a)},render:p,addToRenderList:x,dispose:g}}function rS(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(I,D,F,R,k){let W=!1,z=u(I,R,F,D);r!==z&&(r=z,c(r.object)),W=f(I,R,F,k),W&&p(I,R,F,k),k!==null&&t.update(k,n.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,y(I,D,F,R),k!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(k).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function h(I){return n.deleteVertexArray(I)}function u(I,D,F,R){let k=R.wireframe===!0,W=i[D.id];W===void 0&&(W={},i[D.id]=W);let z=I.isInstancedMesh===!0?I.id:0,tt=W[z];tt===void 0&&(tt={},W[z]=tt);let q=tt[F.id];q===void 0&&(q={},tt[F.id]=q);let Q=q[k];return Q===void 0&&(Q=d(l()),q[k]=Q),Q}function d(I){let D=[],F=[],R=[];for(let k=0;k<e;k++)D[k]=0,F[k]=0,R[k]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:F,attributeDivisors:R,object:I,attributes:{},index:null}}function f(I,D,F,R){let k=r.attributes,W=D.attributes,z=0,tt=F.getAttributes();for(let q in tt)if(tt[q].location>=0){let et=k[q],_t=W[q];if(_t===void 0&&(q==="instanceMatrix"&&I.instanceMatrix&&(_t=I.instanceMatrix),q==="instanceColor"&&I.instanceColor&&(_t=I.instanceColor)),et===void 0||et.attribute!==_t||_t&&et.data!==_t.data)return!0;z++}return r.attributesNum!==z||r.index!==R}function p(I,D,F,R){let k={},W=D.attributes,z=0,tt=F.getAttributes();for(let q in tt)if(tt[q].location>=0){let et=W[q];et===void 0&&(q==="instanceMatrix"&&I.instanceMatrix&&(et=I.instanceMatrix),q==="instanceColor"&&I.instanceColor&&(et=I.instanceColor));let _t={};_t.attribute=et,et&&et.data&&(_t.data=et.data),k[q]=_t,z++}r.attributes=k,r.attributesNum=z,r.index=R}function x(){let I=r.newAttributes;for(let D=0,F=I.length;D<F;D++)I[D]=0}function m(I){g(I,0)}function g(I,D){let F=r.newAttributes,R=r.enabledAttributes,k=r.attributeDivisors;F[I]=1,R[I]===0&&(n.enableVertexAttribArray(I),R[I]=1),k[I]!==D&&(n.vertexAttribDivisor(I,D),k[I]=D)}function _(){let I=r.newAttributes,D=r.enabledAttributes;for(let F=0,R=D.length;F<R;F++)D[F]!==I[F]&&(n.disableVertexAttribArray(F),D[F]=0)}function w(I,D,F,R,k,W,z){z===!0?n.vertexAttribIPointer(I,D,F,k,W):n.vertexAttribPointer(I,D,F,R,k,W)}function y(I,D,F,R){x();let k=R.attributes,W=F.getAttributes(),z=D.defaultAttributeValues;for(let tt in W){let q=W[tt];if(q.location>=0){let Q=k[tt];if(Q===void 0&&(tt==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),tt==="instanceColor"&&I.instanceColor&&(Q=I.instanceColor)),Q!==void 0){let et=Q.normalized,_t=Q.itemSize,Dt=t.get(Q);if(Dt===void 0)continue;let K=Dt.buffer,pt=Dt.type,yt=Dt.bytesPerElement,St=pt===n.INT||pt===n.UNSIGNED_INT||Q.gpuType===nl;if(Q.isInterleavedBufferAttribute){let ht=Q.data,It=ht.isInterleavedBuffer===!0?ht.stride:ht.itemSize,ae=Q.offset;if(ht.isInstancedInterleavedBuffer||ht.isInstancedBufferAttribute){for(let Ct=0;Ct<q.locationSize;Ct++)g(q.location+Ct,ht.meshPerAttribute);I.isInstancedMesh!==!0&&R._maxInstanceCount===void 0&&(R._maxInstanceCount=ht.meshPerAttribute*ht.count)}else for(let Ct=0;Ct<q.locationSize;Ct++)m(q.location+Ct);n.bindBuffer(n.ARRAY_BUFFER,K);for(let Ct=0;Ct<q.locationSize;Ct++)w(q.location+Ct,_t/q.locationSize,pt,et,It*yt,(ae+_t/q.locationSize*Ct)*yt,St)}else{if(Q.isInstancedBufferAttribute){for(let ht=0;ht<q.locationSize;ht++)g(q.location+ht,Q.meshPerAttribute);I.isInstancedMesh!==!0&&R._maxInstanceCount===void 0&&(R._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let ht=0;ht<q.locationSize;ht++)m(q.location+ht);n.bindBuffer(n.ARRAY_BUFFER,K);for(let ht=0;ht<q.locationSize;ht++)w(q.location+ht,_t/q.locationSize,pt,et,_t*yt,_t/q.locationSize*ht*yt,St)}}else if(z!==void 0){let et=z[tt];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv(q.location,et);break;case 3:n.vertexAttrib3fv(q.location,et);break;case 4:n.vertexAttrib4fv(q.location,et);break;default:n.vertexAttrib1fv(q.location,et)}}}}_()}function E(){L();for(let I in i){let D=i[I];for(let F in D){let R=D[F];for(let k in R){let W=R[k];for(let z in W)h(W[z].object),delete W[z];delete R[k]}}delete i[I]}}function S(I){if(i[I.id]===void 0)return;let D=i[I.id];for(let F in D){let R=D[F];for(let k in R){let W=R[k];for(let z in W)h(W[z].object),delete W[z];delete R[k]}}delete i[I.id]}function v(I){for(let D in i){let F=i[D];for(let R in F){let k=F[R];if(k[I.id]===void 0)continue;let W=k[I.id];for(let z in W)h(W[z].object),delete W[z];delete k[I.id]}}}function A(I){for(let D in i){let F=i[D],R=I.isInstancedMesh===!0?I.id:0,k=F[R];if(k!==void 0){for(let W in k){let z=k[W];for(let tt in z)h(z[tt].object),delete z[tt];delete k[W]}delete F[R],Object.keys(F).length===0&&delete i[D]}}}function L(){T(),o=!0,r!==s&&(r=s,c(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:L,resetDefaultState:T,dispose:E,releaseStatesOfGeometry:S,releaseStatesOfObject:A,releaseStatesOfProgram:v,initAttributes:x,enableAttribute:m,disableUnusedAttributes:_}}function oS(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),e.update(c,i,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function aS(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let v=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==On&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let A=v===Dn&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(v!==un&&v!==Nn&&!A&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Nt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Nt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Nt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),y=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),E=n.getParameter(n.MAX_SAMPLES),S=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:_,maxVaryings:w,maxFragmentUniforms:y,maxSamples:E,samples:S}}function lS(n){let t=this,e=null,i=0,s=!1,r=!1,o=new In,a=new Ut,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||i!==0||s;return s=d,i=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,x=u.clipIntersection,m=u.clipShadows,g=n.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let _=r?0:i,w=_*4,y=g.clippingState||null;l.value=y,y=h(p,d,w,f);for(let E=0;E!==w;++E)y[E]=e[E];g.clippingState=y,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,d,f,p){let x=u!==null?u.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=f+x*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(m===null||m.length<g)&&(m=new Float32Array(g));for(let w=0,y=f;w!==x;++w,y+=4)o.copy(u[w]).applyMatrix4(_,a),o.normal.toArray(m,y),m[y+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}var Xr=class extends cn{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Cr(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Ws(5,5,5),r=new _n({name:"CubemapFromEquirect",uniforms:ss(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Qe,blending:ts});r.uniforms.tEquirect.value=e;let o=new yn(s,r),a=e.minFilter;return e.minFilter===Pn&&(e.minFilter=Oe),new Xs(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Tm=256,cS=3,hS=20,Zm=256,Jm=16,uS=3,dS=new X,fS=new Jt,zl=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Xs(1,10,null),this._boxMesh=new yn(new Ws(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=dS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(fS));let m=new Xs(i,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Im(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Rm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Tm,bm(t))}_fromTexture(t,e){t.mapping===ns||t.mapping===Ys?this._setSize(t.image.length===0?Tm:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Cm(t,!1,!1),i=Math.log2(t)-cS;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Cm(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===ns||t.mapping===Ys?(this._cubemapMaterial===null&&(this._cubemapMaterial=Im()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Rm()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=pS(),this._integrationMaterial=mS());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Jm);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-uS)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Zm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=gS());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Cm(n,t,e){return new Xr(n,{minFilter:Pn,generateMipmaps:t,type:Dn,colorSpace:Zi,depthBuffer:e})}function qr(n,t,e){return new _n({name:n,uniforms:t,vertexShader:Ht.cube_vert,fragmentShader:e,side:Qe,blending:ts,depthTest:!1,depthWrite:!1})}function pS(){return qr("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Zm}u

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
	`)}function mS(){return qr("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Jm}},`

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
	`)}function gS(){return qr("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${hS}
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
	`)}function Rm(){return qr("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Im(){return qr("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function xS(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Qa||f===tl)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new Xr(p.height);return x.fromEquirectangularTexture(n,d),t.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Qa||f===tl,x=f===ns||f===Ys;if(p||x){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new zl(n)),m=p?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let _=d.image;return p&&_&&_.height>0||x&&_&&l(_)?(i===null&&(i=new zl(n)),m=p?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===Qa?d.mapping=ns:f===tl&&(d.mapping=Ys),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function vS(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&vr("WebGLRenderer: "+i+" extension not supported."),s}}}function yS(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(p){let x=p.attributes;for(let m in x)t.update(x[m],n.ARRAY_BUFFER)}function u(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let _=x!==null?x.array.length:m.array.length/3-1,w=m.count>=65535?Tr:Er,y=new w(Math.ceil(_/3)*6,1),E=y.array;if(x!==null){let v=x.array;g=x.version;for(let A=0,L=0;A<_;A+=3){let T=v[A+0],I=v[A+1],D=v[A+2];E[L++]=T,E[L++]=I,E[L++]=I,E[L++]=D,E[L++]=D,E[L++]=T}}else{g=m.version;for(let v=0,A=0;v<_;v+=3){let L=v+0,T=v+1,I=v+2;E[A++]=L,E[A++]=T,E[A++]=T,E[A++]=I,E[A++]=I,E[A++]=L}}y.version=g;let S=r.get(p);S&&t.remove(S),r.set(p,y)}function d(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function _S(n,t,e){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){n.drawElements(i,d,r,u*o),e.update(d,i,1)}function c(u,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,u*o,f),e.update(d,i,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,u,0,f);let x=0;for(let m=0;m<f;m++)x+=d[m];e.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function MS(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:Ft("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function bS(n,t,e){let i=new WeakMap,s=new ye;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=i.get(a);if(d===void 0||d.count!==u){let L=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",L)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],w=0;f===!0&&(w=1),p===!0&&(w=2),x===!0&&(w=3);let y=a.attributes.position.count*w,E=1;y>t.maxTextureSize&&(E=Math.ceil(y/t.maxTextureSize),y=t.maxTextureSize);let S=new Float32Array(y*E*4*u),v=new wr(S,y,E,u);v.type=Nn,v.needsUpdate=!0;let A=w*4;for(let T=0;T<u;T++){let I=m[T],D=g[T],F=_[T],R=y*E*4*T;for(let k=0;k<I.count;k++){let W=k*A;f===!0&&(s.fromBufferAttribute(I,k),S[R+W+0]=s.x,S[R+W+1]=s.y,S[R+W+2]=s.z,S[R+W+3]=0),p===!0&&(s.fromBufferAttribute(D,k),S[R+W+4]=s.x,S[R+W+5]=s.y,S[R+W+6]=s.z,S[R+W+7]=0),x===!0&&(s.fromBufferAttribute(F,k),S[R+W+8]=s.x,S[R+W+9]=s.y,S[R+W+10]=s.z,S[R+W+11]=F.itemSize===4?s.w:1)}}d={count:u,texture:v,size:new jt(y,E)},i.set(a,d),a.addEventListener("dispose",L)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function wS(n,t,e,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var SS={[Yh]:"LINEAR_TONE_MAPPING",[Kh]:"REINHARD_TONE_MAPPING",[Zh]:"CINEON_TONE_MAPPING",[Jh]:"ACES_FILMIC_TONE_MAPPING",[Qh]:"AGX_TONE_MAPPING",[tu]:"NEUTRAL_TONE_MAPPING",[jh]:"CUSTOM_TONE_MAPPING"};function AS(n,t,e,i,s,r){let o=new cn(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new qn;h.setAttribute("position",new xn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new xn([0,2,0,0,2,0],2));let u=new ka({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new yn(h,u),f=new Ja(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,_=null,w=[],y=!1;this.setSize=function(E,S){o.setSize(E,S),a!==null&&a.setSize(E,S),l!==null&&l.setSize(E,S);for(let v=0;v<w.length;v++){let A=w[v];A.setSize&&A.setSize(E,S)}},this.setEffects=function(E){w=E,y=w.length>0&&w[0].isRenderPass===!0;let S=o.width,v=o.height;w.length>0&&a===null&&(a=new cn(S,v,{type:Dn,depthBuffer:!1,stencilBuffer:!1}),l=new cn(S,v,{type:Dn,depthBuffer:!1,stencilBuffer:!1}));let A=s===!0&&w.some(L=>L.needsDepthTexture===!0);A!==(o.depthTexture!==null)&&(A===!0&&c===null&&(c=new di(S,v),r===!0&&(c.format=fi,c.type=is)),o.dispose(),o.depthTexture=A?c:null,o.resolveDepthBuffer=A,o.storeMultisampledDepthBuffer=A);for(let L=0;L<w.length;L++){let T=w[L];T.setSize&&T.setSize(S,v),A&&T.needsDepthTexture===!0&&T.setDepthTexture&&T.setDepthTexture(c)}},this.begin=function(E,S){if(m||E.toneMapping===$n&&w.length===0)return!1;if(_=S,S!==null){let v=S.width,A=S.height;(o.width!==v||o.height!==A)&&this.setSize(v,A)}return y===!1&&E.setRenderTarget(o),g=E.toneMapping,E.toneMapping=$n,!0},this.hasRenderPass=function(){return y},this.end=function(E,S){E.toneMapping=g,m=!0;let v=o,A=a;for(let L=0;L<w.length;L++){let T=w[L];T.enabled!==!1&&(T.render(E,A,v,S),T.needsSwap!==!1&&(v=A,A=A===a?l:a))}if(p!==E.outputColorSpace||x!==E.toneMapping){p=E.outputColorSpace,x=E.toneMapping,u.defines={},Wt.getTransfer(p)===ee&&(u.defines.SRGB_TRANSFER="");let L=SS[x];L&&(u.defines[L]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=v.texture,E.setRenderTarget(_),E.render(d,f),_=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var jm=new nn,Qm=new di(1,1),tg=new Rr(1),eg=new wr,ng=new Da,ig=new Cr,Pm=[],Lm=[],Nm=new Float32Array(16),Dm=new Float32Array(9),Om=new Float32Array(4);function Js(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Pm[s];if(r===void 0&&(r=new Float32Array(s),Pm[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Re(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Ie(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Vl(n,t){let e=Lm[t];e===void 0&&(e=new Int32Array(t),Lm[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function ES(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function TS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Re(e,t))return;n.uniform2fv(this.addr,t),Ie(e,t)}}function CS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Re(e,t))return;n.uniform3fv(this.addr,t),Ie(e,t)}}function RS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Re(e,t))return;n.uniform4fv(this.addr,t),Ie(e,t)}}function IS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Re(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Ie(e,t)}else{if(Re(e,i))return;Om.set(i),n.uniformMatrix2fv(this.addr,!1,Om),Ie(e,i)}}function PS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Re(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Ie(e,t)}else{if(Re(e,i))return;Dm.set(i),n.uniformMatrix3fv(this.addr,!1,Dm),Ie(e,i)}}function LS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Re(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Ie(e,t)}else{if(Re(e,i))return;Nm.set(i),n.uniformMatrix4fv(this.addr,!1,Nm),Ie(e,i)}}function NS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function DS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Re(e,t))return;n.uniform2iv(this.addr,t),Ie(e,t)}}function OS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Re(e,t))return;n.uniform3iv(this.addr,t),Ie(e,t)}}function FS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Re(e,t))return;n.uniform4iv(this.addr,t),Ie(e,t)}}function US(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function kS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Re(e,t))return;n.uniform2uiv(this.addr,t),Ie(e,t)}}function BS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Re(e,t))return;n.uniform3uiv(this.addr,t),Ie(e,t)}}function zS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Re(e,t))return;n.uniform4uiv(this.addr,t),Ie(e,t)}}function Hl(n){return n.version===0&&(n.compareFunction=du,n.needsUpdate=!0),n}function GS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Hl(Qm):r=jm,e.setTexture2D(t||r,s)}function VS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||ng,s)}function HS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Hl(tg):r=ig,e.setTextureCube(t||r,s)}function WS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||eg,s)}function XS(n){switch(n){case 5126:return ES;case 35664:return TS;case 35665:return CS;case 35666:return RS;case 35674:return IS;case 35675:return PS;case 35676:return LS;case 5124:case 35670:return NS;case 35667:case 35671:return DS;case 35668:case 35672:return OS;case 35669:case 35673:return FS;case 5125:return US;case 36294:return kS;case 36295:return BS;case 36296:return zS;case 35678:case 36198:case 36298:case 36306:case 35682:return GS;case 35679:case 36299:case 36307:return VS;case 35680:case 36300:case 36308:case 36293:return HS;case 36289:case 36303:case 36311:case 36292:return WS}}function qS(n,t){n.uniform1fv(this.addr,t)}function $S(n,t){let e=Js(t,this.size,2);n.uniform2fv(this.addr,e)}function YS(n,t){let e=Js(t,this.size,3);n.uniform3fv(this.addr,e)}function KS(n,t){let e=Js(t,this.size,4);n.uniform4fv(this.addr,e)}function ZS(n,t){let e=Js(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function JS(n,t){let e=Js(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function jS(n,t){let e=Js(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function QS(n,t){n.uniform1iv(this.addr,t)}function tA(n,t){n.uniform2iv(this.addr,t)}function eA(n,t){n.uniform3iv(this.addr,t)}function nA(n,t){n.uniform4iv(this.addr,t)}function iA(n,t){n.uniform1uiv(this.addr,t)}function sA(n,t){n.uniform2uiv(this.addr,t)}function rA(n,t){n.uniform3uiv(this.addr,t)}function oA(n,t){n.uniform4uiv(this.addr,t)}function aA(n,t,e){let i=this.cache,s=t.length,r=Vl(e,s);Re(i,r)||(n.uniform1iv(this.addr,r),Ie(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Hl(Qm):o=jm;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function lA(n,t,e){let i=this.cache,s=t.length,r=Vl(e,s);Re(i,r)||(n.uniform1iv(this.addr,r),Ie(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||ng,r[o])}function cA(n,t,e){let i=this.cache,s=t.length,r=Vl(e,s);Re(i,r)||(n.uniform1iv(this.addr,r),Ie(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Hl(tg):o=ig;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function hA(n,t,e){let i=this.cache,s=t.length,r=Vl(e,s);Re(i,r)||(n.uniform1iv(this.addr,r),Ie(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||eg,r[o])}function uA(n){switch(n){case 5126:return qS;case 35664:return $S;case 35665:return YS;case 35666:return KS;case 35674:return ZS;case 35675:return JS;case 35676:return jS;case 5124:case 35670:return QS;case 35667:case 35671:return tA;case 35668:case 35672:return eA;case 35669:case 35673:return nA;case 5125:return iA;case 36294:return sA;case 36295:return rA;case 36296:return oA;case 35678:case 36198:case 36298:case 36306:case 35682:return aA;case 35679:case 36299:case 36307:return lA;case 35680:case 36300:case 36308:case 36293:return cA;case 36289:case 36303:case 36311:case 36292:return hA}}var wu=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=XS(e.type)}},Su=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=uA(e.type)}},Au=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Mu=/(\w+)(\])?(\[|\.)?/g;function Fm(n,t){n.seq.push(t),n.map[t.id]=t}function dA(n,t,e){let i=n.name,s=i.length;for(Mu.lastIndex=0;;){let r=Mu.exec(i),o=Mu.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Fm(e,c===void 0?new wu(a,n,t):new Su(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new Au(a),Fm(e,u)),e=u}}}var Zs=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);dA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Um(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var fA=37297,pA=0;function mA(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var km=new Ut;function gA(n){Wt._getMatrix(km,Wt.workingColorSpace,n);let t=`mat3( ${km.elements.map(e=>e.toFixed(4))} )`;switch(Wt.getTransfer(n)){case _r:return[t,"LinearTransferOETF"];case ee:return[t,"sRGBTransferOETF"];default:return Nt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Bm(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+mA(n.getShaderSource(t),a)}else return r}function xA(n,t){let e=gA(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var vA={[Yh]:"Linear",[Kh]:"Reinhard",[Zh]:"Cineon",[Jh]:"ACESFilmic",[Qh]:"AgX",[tu]:"Neutral",[jh]:"Custom"};function yA(n,t){let e=vA[t];return e===void 0?(Nt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Bl=new X;function _A(){Wt.getLuminanceCoefficients(Bl);let n=Bl.x.toFixed(4),t=Bl.y.toFixed(4),e=Bl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function MA(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Wr).join(`
`)}function bA(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function wA(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Wr(n){return n!==""}function zm(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Gm(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var SA=/^[ \t]*#include +<([\w\d./]+)>/gm;function Eu(n){return n.replace(SA,AA)}function AA(n,t){let e=Ht[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Eu(e)}var EA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Vm(n){return n.replace(EA,TA)}function TA(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Hm(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var CA={[Dr]:"SHADOWMAP_TYPE_PCF",[qs]:"SHADOWMAP_TYPE_VSM"};function RA(n){return CA[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var IA={[Ys]:"ENVMAP_MODE_REFRACTION"};function PA(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":IA[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var LA={[$h]:"ENVMAP_BLENDING_MULTIPLY",[om]:"ENVMAP_BLENDING_MIX",[am]:"ENVMAP_BLENDING_ADD"};function NA(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":LA[n.combine]||"ENVMAP_BLENDING_NONE"}function DA(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=RA(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=PA(e),u=NA(e),d=MA(e),f=bA(r),p=s.createProgram(),x,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Wr).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Wr).join(`
`),m.length>0&&(m+=`
`)):(x=[Hm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Wr).join(`
`),m=[Hm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==$n?"#define TONE_MAPPING":"",e.toneMapping!==$n?Ht.tonemapping_pars_fragment:"",e.toneMapping!==$n?yA("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Ht.colorspace_pars_fragment,xA("linearToOutputTexel",e.outputColorSpace),_A(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Wr).join(`
`)),o=Eu(o),o=zm(o,e),o=Gm(o,e),a=Eu(a),a=zm(a,e),a=Gm(a,e),o=Vm(o),a=Vm(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",e.glslVersion===pu?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===pu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let _=g+x+o,w=g+m+a,y=Um(s,s.VERTEX_SHADER,_),E=Um(s,s.FRAGMENT_SHADER,w);s.attachShader(p,y),s.attachShader(p,E),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function S(T){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(p)||"",D=s.getShaderInfoLog(y)||"",F=s.getShaderInfoLog(E)||"",R=I.trim(),k=D.trim(),W=F.trim(),z=!0,tt=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,y,E);else{let q=Bm(s,y,"vertex"),Q=Bm(s,E,"fragment");Ft("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+T.name+`
Material Type: `+T.type+`

Program Info Log: `+R+`
`+q+`
`+Q)}else R!==""?Nt("WebGLProgram: Program Info Log:",R):(k===""||W==="")&&(tt=!1);tt&&(T.diagnostics={runnable:z,programLog:R,vertexShader:{log:k,prefix:x},fragmentShader:{log:W,prefix:m}})}s.deleteShader(y),s.deleteShader(E),v=new Zs(s,p),A=wA(s,p)}let v;this.getUniforms=function(){return v===void 0&&S(this),v};let A;this.getAttributes=function(){return A===void 0&&S(this),A};let L=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return L===!1&&(L=s.getProgramParameter(p,fA)),L},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=pA++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=y,this.fragmentShader=E,this}var OA=0,Tu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Cu(t),e.set(t,i)),i}},Cu=class{constructor(t){this.id=OA++,this.code=t,this.usedTimes=0}};function FA(n){return n===Ui||n===zr||n===Gr}function UA(n,t,e,i,s,r){let o=new Sr,a=new Tu,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,A,L,T,I,D){let F=T.fog,R=I.geometry,k=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?T.environment:null,W=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,z=t.get(v.envMap||k,W),tt=d[v.type],q=i.precision;v.precision!==null&&(q=i.getMaxPrecision(v.precision),q!==v.precision&&Nt("WebGLProgram.getParameters:",v.precision,"not supported, using",q,"instead."));let Q=R.morphAttributes.position||R.morphAttributes.normal||R.morphAttributes.color,et=Q!==void 0?Q.length:0,_t=0;R.morphAttributes.position!==void 0&&(_t=1),R.morphAttributes.normal!==void 0&&(_t=2),R.morphAttributes.color!==void 0&&(_t=3);let Dt,K,pt,yt;if(tt){let mt=Kn[tt];Dt=mt.vertexShader,K=mt.fragmentShader}else{Dt=v.vertexShader,K=v.fragmentShader;let mt=a.getVertexShaderStage(v),ne=a.getFragmentShaderStage(v);a.update(v,mt,ne),pt=mt.id,yt=ne.id}let St=n.getRenderTarget(),ht=n.state.buffers.depth.getReversed(),It=I.isInstancedMesh===!0,ae=I.isBatchedMesh===!0,Ct=!!v.map,$t=!!v.matcap,Kt=!!z,Bt=Kt&&z.isPMREMTexture===!0,ge=!!v.aoMap,_e=!!v.lightMap,Fe=!!v.bumpMap&&v.wireframe===!1,le=!!v.normalMap,dn=!!v.displacementMap,Se=!!v.emissiveMap,$e=!!v.metalnessMap,fe=!!v.roughnessMap,Ye=v.anisotropy>0,O=v.clearcoat>0,Ue=v.diffuseRoughness>0,ie=v.dispersion>0,Qt=v.retroreflectivity>0,rt=v.iridescence>0,pe=v.sheen>0,Rt=v.transmission>0,Lt=Ye&&!!v.anisotropyMap,C=O&&!!v.clearcoatMap,M=O&&!!v.clearcoatNormalMap,G=O&&!!v.clearcoatRoughnessMap,nt=Ue&&!!v.diffuseRoughnessMap,j=rt&&!!v.iridescenceMap,ot=rt&&!!v.iridescenceThicknessMap,dt=pe&&!!v.sheenColorMap,Y=pe&&!!v.sheenRoughnessMap,Z=!!v.specularMap,lt=!!v.specularColorMap,P=!!v.specularIntensityMap,J=Rt&&!!v.transmissionMap,$=Rt&&!!v.thicknessMap,ct=!!v.gradientMap,st=!!v.alphaMap,at=v.alphaTest>0,Tt=!!v.alphaHash,Gt=!!v.extensions,it=$n;v.toneMapped&&(St===null||St.isXRRenderTarget===!0)&&(it=n.toneMapping);let Pt=Bt?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,zt={shaderID:tt,shaderType:v.type,shaderName:v.name,vertexShader:Dt,fragmentShader:K,defines:v.defines,customVertexShaderID:pt,customFragmentShaderID:yt,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:q,batching:ae,batchingColor:ae&&I._colorsTexture!==null,instancing:It,instancingColor:It&&I.instanceColor!==null,instancingMorph:It&&I.morphTexture!==null,outputColorSpace:St===null?n.outputColorSpace:St.isXRRenderTarget===!0?St.texture.colorSpace:Wt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Ct,matcap:$t,envMap:Kt,envMapMode:Kt&&z.mapping,envMapPMREM:Bt,envMapMaxLod:Bt?Pt.length-1:null,envMapSize:Bt?Pt[0].width:null,aoMap:ge,lightMap:_e,bumpMap:Fe,normalMap:le,displacementMap:dn,emissiveMap:Se,normalMapObjectSpace:le&&v.normalMapType===hm,normalMapTangentSpace:le&&v.normalMapType===cu,packedNormalMap:le&&v.normalMapType===cu&&FA(v.normalMap.format),metalnessMap:$e,roughnessMap:fe,anisotropy:Ye,anisotropyMap:Lt,clearcoat:O,clearcoatMap:C,clearcoatNormalMap:M,clearcoatRoughnessMap:G,diffuseRoughness:Ue,diffuseRoughnessMap:nt,dispersion:ie,retroreflection:Qt,iridescence:rt,iridescenceMap:j,iridescenceThicknessMap:ot,sheen:pe,sheenColorMap:dt,sheenRoughnessMap:Y,specularMap:Z,specularColorMap:lt,specularIntensityMap:P,transmission:Rt,transmissionMap:J,thicknessMap:$,gradientMap:ct,opaque:v.transparent===!1&&v.blending===$s&&v.alphaToCoverage===!1,alphaMap:st,alphaTest:at,alphaHash:Tt,combine:v.combine,mapUv:Ct&&f(v.map.channel),aoMapUv:ge&&f(v.aoMap.channel),lightMapUv:_e&&f(v.lightMap.channel),bumpMapUv:Fe&&f(v.bumpMap.channel),normalMapUv:le&&f(v.normalMap.channel),displacementMapUv:dn&&f(v.displacementMap.channel),emissiveMapUv:Se&&f(v.emissiveMap.channel),metalnessMapUv:$e&&f(v.metalnessMap.channel),roughnessMapUv:fe&&f(v.roughnessMap.channel),anisotropyMapUv:Lt&&f(v.anisotropyMap.channel),clearcoatMapUv:C&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:G&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:nt&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:j&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:ot&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:dt&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:Y&&f(v.sheenRoughnessMap.channel),specularMapUv:Z&&f(v.specularMap.channel),specularColorMapUv:lt&&f(v.specularColorMap.channel),specularIntensityMapUv:P&&f(v.specularIntensityMap.channel),transmissionMapUv:J&&f(v.transmissionMap.channel),thicknessMapUv:$&&f(v.thicknessMap.channel),alphaMapUv:st&&f(v.alphaMap.channel),vertexTangents:!!R.attributes.tangent&&(le||Ye),vertexNormals:!!R.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!R.attributes.color&&R.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!R.attributes.uv&&(Ct||st),fog:!!F,useFog:v.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||R.attributes.normal===void 0&&le===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:ht,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:R.attributes.position!==void 0,morphTargets:R.morphAttributes.position!==void 0,morphNormals:R.morphAttributes.normal!==void 0,morphColors:R.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:_t,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:D.filter(mt=>mt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&L.length>0,shadowMapType:n.shadowMap.type,toneMapping:it,decodeVideoTexture:Ct&&v.map.isVideoTexture===!0&&Wt.getTransfer(v.map.colorSpace)===ee,decodeVideoTextureEmissive:Se&&v.emissiveMap.isVideoTexture===!0&&Wt.getTransfer(v.emissiveMap.colorSpace)===ee,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Mn,flipSided:v.side===Qe,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Gt&&v.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Gt&&v.extensions.multiDraw===!0||ae)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return zt.vertexUv1s=l.has(1),zt.vertexUv2s=l.has(2),zt.vertexUv3s=l.has(3),l.clear(),zt}function x(v){let A=[];if(v.shaderID?A.push(v.shaderID):(A.push(v.customVertexShaderID),A.push(v.customFragmentShaderID)),v.defines!==void 0)for(let L in v.defines)A.push(L),A.push(v.defines[L]);return v.isRawShaderMaterial===!1&&(m(A,v),g(A,v),A.push(n.outputColorSpace)),A.push(v.customProgramCacheKey),A.join()}function m(v,A){v.push(A.precision),v.push(A.outputColorSpace),v.push(A.envMapMode),v.push(A.envMapPMREM),v.push(A.envMapMaxLod),v.push(A.envMapSize),v.push(A.mapUv),v.push(A.alphaMapUv),v.push(A.lightMapUv),v.push(A.aoMapUv),v.push(A.bumpMapUv),v.push(A.normalMapUv),v.push(A.displacementMapUv),v.push(A.emissiveMapUv),v.push(A.metalnessMapUv),v.push(A.roughnessMapUv),v.push(A.anisotropyMapUv),v.push(A.clearcoatMapUv),v.push(A.clearcoatNormalMapUv),v.push(A.clearcoatRoughnessMapUv),v.push(A.diffuseRoughnessMapUv),v.push(A.iridescenceMapUv),v.push(A.iridescenceThicknessMapUv),v.push(A.sheenColorMapUv),v.push(A.sheenRoughnessMapUv),v.push(A.specularMapUv),v.push(A.specularColorMapUv),v.push(A.specularIntensityMapUv),v.push(A.transmissionMapUv),v.push(A.thicknessMapUv),v.push(A.combine),v.push(A.fogExp2),v.push(A.sizeAttenuation),v.push(A.morphTargetsCount),v.push(A.numSunLights),v.push(A.numDirLights),v.push(A.numPointLights),v.push(A.numSpotLights),v.push(A.numSpotLightMaps),v.push(A.numHemiLights),v.push(A.numRectAreaLights),v.push(A.numSunLightShadows),v.push(A.numDirLightShadows),v.push(A.numPointLightShadows),v.push(A.numSpotLightShadows),v.push(A.numSpotLightShadowsWithMaps),v.push(A.numLightProbes),v.push(A.numLightProbeGrids),v.push(A.shadowMapType),v.push(A.toneMapping),v.push(A.numClippingPlanes),v.push(A.numClipIntersection),v.push(A.depthPacking)}function g(v,A){o.disableAll(),A.instancing&&o.enable(0),A.instancingColor&&o.enable(1),A.instancingMorph&&o.enable(2),A.matcap&&o.enable(3),A.envMap&&o.enable(4),A.normalMapObjectSpace&&o.enable(5),A.normalMapTangentSpace&&o.enable(6),A.clearcoat&&o.enable(7),A.iridescence&&o.enable(8),A.alphaTest&&o.enable(9),A.vertexColors&&o.enable(10),A.vertexAlphas&&o.enable(11),A.vertexUv1s&&o.enable(12),A.vertexUv2s&&o.enable(13),A.vertexUv3s&&o.enable(14),A.vertexTangents&&o.enable(15),A.anisotropy&&o.enable(16),A.alphaHash&&o.enable(17),A.batching&&o.enable(18),A.dispersion&&o.enable(19),A.retroreflection&&o.enable(24),A.diffuseRoughness&&o.enable(25),A.batchingColor&&o.enable(20),A.gradientMap&&o.enable(21),A.packedNormalMap&&o.enable(22),A.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),A.fog&&o.enable(0),A.useFog&&o.enable(1),A.flatShading&&o.enable(2),A.logarithmicDepthBuffer&&o.enable(3),A.reversedDepthBuffer&&o.enable(4),A.skinning&&o.enable(5),A.morphTargets&&o.enable(6),A.morphNormals&&o.enable(7),A.morphColors&&o.enable(8),A.premultipliedAlpha&&o.enable(9),A.shadowMapEnabled&&o.enable(10),A.doubleSided&&o.enable(11),A.flipSided&&o.enable(12),A.useDepthPacking&&o.enable(13),A.dithering&&o.enable(14),A.transmission&&o.enable(15),A.sheen&&o.enable(16),A.opaque&&o.enable(17),A.pointsUvs&&o.enable(18),A.decodeVideoTexture&&o.enable(19),A.decodeVideoTextureEmissive&&o.enable(20),A.alphaToCoverage&&o.enable(21),A.numLightProbeGrids>0&&o.enable(22),A.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function _(v){let A=d[v.type],L;if(A){let T=Kn[A];L=Sm.clone(T.uniforms)}else L=v.uniforms;return L}function w(v,A){let L=h.get(A);return L!==void 0?++L.usedTimes:(L=new DA(n,A,v,s),c.push(L),h.set(A,L)),L}function y(v){if(--v.usedTimes===0){let A=c.indexOf(v);c[A]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function E(v){a.remove(v)}function S(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:_,acquireProgram:w,releaseProgram:y,releaseShaderCache:E,programs:c,dispose:S}}function kA(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function BA(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Wm(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Xm(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,m,g){let _=n[t];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:g},n[t]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=x,_.renderOrder=d.renderOrder,_.z=m,_.group=g),t++,_}function l(d,f,p,x,m,g,_){_.reversedDepth===!0&&(m=-m);let w=a(d,f,p,x,m,g);p.transmission>0?i.push(w):p.transparent===!0?s.push(w):e.push(w)}function c(d,f,p,x,m,g){let _=a(d,f,p,x,m,g);p.transmission>0?i.unshift(_):p.transparent===!0?s.unshift(_):e.unshift(_)}function h(d,f){e.length>1&&e.sort(d||BA),i.length>1&&i.sort(f||Wm),s.length>1&&s.sort(f||Wm)}function u(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function zA(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Xm,n.set(i,[o])):s>=r.length?(o=new Xm,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function GA(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new X,color:new Jt};break;case"SpotLight":e={position:new X,direction:new X,color:new Jt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new X,color:new Jt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new X,skyColor:new Jt,groundColor:new Jt};break;case"RectAreaLight":e={color:new Jt,position:new X,halfWidth:new X,halfHeight:new X};break}return n[t.id]=e,e}}}function VA(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new jt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new jt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new jt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var HA=0;function WA(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function XA(n){let t=new GA,e=VA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new X);let s=new X,r=new Me,o=new Me;function a(c){let h=0,u=0,d=0;for(let D=0;D<9;D++)i.probe[D].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,_=0,w=0,y=0,E=0,S=0,v=0,A=0,L=0,T=0;c.sort(WA);for(let D=0,F=c.length;D<F;D++){let R=c[D],k=R.color,W=R.intensity,z=R.distance,tt=null;if(R.shadow&&R.shadow.map&&(R.shadow.map.texture.format===Ui?tt=R.shadow.map.texture:tt=R.shadow.map.depthTexture||R.shadow.map.texture),R.isAmbientLight)h+=k.r*W,u+=k.g*W,d+=k.b*W;else if(R.isLightProbe){for(let q=0;q<9;q++)i.probe[q].addScaledVector(R.sh.coefficients[q],W);T++}else if(R.isSunLight){let q=t.get(R);if(q.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let Q=R.shadow,et=e.get(R);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=et,i.sunShadowMap[p]=tt;let _t=Q.getViewportCount();for(let Dt=0;Dt<_t;Dt++)i.sunShadowMatrix[x+Dt]=Q.getMatrix(Dt),i.sunShadowCascade[x+Dt]=Q._cascadeData[Dt];x+=_t,p++}i.sun[f]=q,f++}else if(R.isDirectionalLight){let q=t.get(R);if(q.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let Q=R.shadow,et=e.get(R);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,i.directionalShadow[m]=et,i.directionalShadowMap[m]=tt,i.directionalShadowMatrix[m]=R.shadow.matrix,E++}i.directional[m]=q,m++}else if(R.isSpotLight){let q=t.get(R);q.position.setFromMatrixPosition(R.matrixWorld),q.color.copy(k).multiplyScalar(W),q.distance=z,q.coneCos=Math.cos(R.angle),q.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),q.decay=R.decay,i.spot[_]=q;let Q=R.shadow;if(R.map&&(i.spotLightMap[A]=R.map,A++,Q.updateMatrices(R),R.castShadow&&L++),i.spotLightMatrix[_]=Q.matrix,R.castShadow){let et=e.get(R);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,i.spotShadow[_]=et,i.spotShadowMap[_]=tt,v++}_++}else if(R.isRectAreaLight){let q=t.get(R);q.color.copy(k).multiplyScalar(W),q.halfWidth.set(R.width*.5,0,0),q.halfHeight.set(0,R.height*.5,0),i.rectArea[w]=q,w++}else if(R.isPointLight){let q=t.get(R);if(q.color.copy(R.color).multiplyScalar(R.intensity),q.distance=R.distance,q.decay=R.decay,R.castShadow){let Q=R.shadow,et=e.get(R);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,et.shadowCameraNear=Q.camera.near,et.shadowCameraFar=Q.camera.far,i.pointShadow[g]=et,i.pointShadowMap[g]=tt,i.pointShadowMatrix[g]=R.shadow.matrix,S++}i.point[g]=q,g++}else if(R.isHemisphereLight){let q=t.get(R);q.skyColor.copy(R.color).multiplyScalar(W),q.groundColor.copy(R.groundColor).multiplyScalar(W),i.hemi[y]=q,y++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=gt.LTC_FLOAT_1,i.rectAreaLTC2=gt.LTC_FLOAT_2):(i.rectAreaLTC1=gt.LTC_HALF_1,i.rectAreaLTC2=gt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=d;let I=i.hash;(I.sunLength!==f||I.directionalLength!==m||I.pointLength!==g||I.spotLength!==_||I.rectAreaLength!==w||I.hemiLength!==y||I.numSunShadows!==p||I.numDirectionalShadows!==E||I.numPointShadows!==S||I.numSpotShadows!==v||I.numSpotMaps!==A||I.numLightProbes!==T)&&(i.sun.length=f,i.directional.length=m,i.spot.length=_,i.rectArea.length=w,i.point.length=g,i.hemi.length=y,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=E,i.directionalShadowMap.length=E,i.directionalShadowMatrix.length=E,i.pointShadow.length=S,i.pointShadowMap.length=S,i.pointShadowMatrix.length=S,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+A-L,i.spotLightMap.length=A,i.numSpotLightShadowsWithMaps=L,i.numLightProbes=T,I.sunLength=f,I.directionalLength=m,I.pointLength=g,I.spotLength=_,I.rectAreaLength=w,I.hemiLength=y,I.numSunShadows=p,I.numDirectionalShadows=E,I.numPointShadows=S,I.numSpotShadows=v,I.numSpotMaps=A,I.numLightProbes=T,i.version=HA++)}function l(c,h){let u=0,d=0,f=0,p=0,x=0,m=0,g=h.matrixWorldInverse;for(let _=0,w=c.length;_<w;_++){let y=c[_];if(y.isSunLight){let E=i.sun[u];E.direction.setFromMatrixPosition(y.matrixWorld),E.direction.transformDirection(g),u++}else if(y.isDirectionalLight){let E=i.directional[d];E.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(g),d++}else if(y.isSpotLight){let E=i.spot[p];E.position.setFromMatrixPosition(y.matrixWorld),E.position.applyMatrix4(g),E.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(g),p++}else if(y.isRectAreaLight){let E=i.rectArea[x];E.position.setFromMatrixPosition(y.matrixWorld),E.position.applyMatrix4(g),o.identity(),r.copy(y.matrixWorld),r.premultiply(g),o.extractRotation(r),E.halfWidth.set(y.width*.5,0,0),E.halfHeight.set(0,y.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),x++}else if(y.isPointLight){let E=i.point[f];E.position.setFromMatrixPosition(y.matrixWorld),E.position.applyMatrix4(g),f++}else if(y.isHemisphereLight){let E=i.hemi[m];E.direction.setFromMatrixPosition(y.matrixWorld),E.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function qm(n){let t=new XA(n),e=[],i=[],s=[];function r(u){h.camera=u,e.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){i.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function qA(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new qm(n),t.set(s,[a])):r>=o.length?(a=new qm(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var $A=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,YA=`uniform sampler2D shadow_pass;
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
}`,KA=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],ZA=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],$m=new Me,Hr=new X,bu=new X;function JA(n,t,e){let i=new Qi,s=new jt,r=new jt,o=new ye,a=new Ba,l=new za,c={},h=e.maxTextureSize,u={[Fi]:Qe,[Qe]:Fi,[Mn]:Mn},d=new _n({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new jt},radius:{value:4}},vertexShader:$A,fragmentShader:YA}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new qn;p.setAttribute("position",new je(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new yn(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Dr;let g=this.type;this.render=function(S,v,A){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||S.length===0)return;this.type===Gp&&(Nt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Dr);let L=n.getRenderTarget(),T=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),D=n.state;D.setBlending(ts),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let F=g!==this.type;F&&v.traverse(function(R){R.material&&(Array.isArray(R.material)?R.material.forEach(k=>k.needsUpdate=!0):R.material.needsUpdate=!0)});for(let R=0,k=S.length;R<k;R++){let W=S[R],z=W.shadow;if(z===void 0){Nt("WebGLShadowMap:",W,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let tt=z.getFrameExtents();s.multiply(tt),r.copy(z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/tt.x),s.x=r.x*tt.x,z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/tt.y),s.y=r.y*tt.y,z.mapSize.y=r.y));let q=n.state.buffers.depth.getReversed();if(z.camera._reversedDepth=q,z.map===null||F===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===qs){if(W.isPointLight){Nt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new cn(s.x,s.y,{format:Ui,type:Dn,minFilter:Oe,magFilter:Oe,generateMipmaps:!1}),z.map.texture.name=W.name+".shadowMap",z.map.depthTexture=new di(s.x,s.y,Nn),z.map.depthTexture.name=W.name+".shadowMapDepth",z.map.depthTexture.format=ui,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=De,z.map.depthTexture.magFilter=De}else W.isPointLight?(z.map=new Xr(s.x),z.map.depthTexture=new Rr(s.x,Ln)):(z.map=new cn(s.x,s.y),z.map.depthTexture=new di(s.x,s.y,Ln)),z.map.depthTexture.name=W.name+".shadowMap",z.map.depthTexture.format=ui,this.type===Dr?(z.map.depthTexture.compareFunction=q?uu:hu,z.map.depthTexture.minFilter=Oe,z.map.depthTexture.magFilter=Oe):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=De,z.map.depthTexture.magFilter=De);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let Q=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();W.isPointLight!==!0&&z.updateMatrices(W,A);let et=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:A.layers;for(let _t=0;_t<Q;_t++){let Dt=z.getCamera(_t);if(W.isPointLight){let K=z.camera,pt=z.matrix,yt=W.distance||K.far;yt!==K.far&&(K.far=yt,K.updateProjectionMatrix()),Hr.setFromMatrixPosition(W.matrixWorld),K.position.copy(Hr),bu.copy(K.position),bu.add(KA[_t]),K.up.copy(ZA[_t]),K.lookAt(bu),K.updateMatrixWorld(),pt.makeTranslation(-Hr.x,-Hr.y,-Hr.z),$m.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),z._frustum.setFromProjectionMatrix($m,K.coordinateSystem,K.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)n.setRenderTarget(z.map,_t),n.clear();else{_t===0&&(n.setRenderTarget(z.map),n.clear());let K=z.getViewport(_t);o.set(r.x*K.x,r.y*K.y,r.x*K.z,r.y*K.w),D.viewport(o)}i=z.getFrustum(_t),y(v,A,Dt,W,et,this.type)}z.isPointLightShadow!==!0&&this.type===qs&&_(z,A),z.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(L,T,I)};function _(S,v){let A=t.update(x);d.defines.VSM_SAMPLES!==S.blurSamples&&(d.defines.VSM_SAMPLES=S.blurSamples,f.defines.VSM_SAMPLES=S.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),S.mapPass===null?S.mapPass=new cn(s.x,s.y,{format:Ui,type:Dn}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),d.uniforms.shadow_pass.value=S.map.depthTexture,d.uniforms.resolution.value.set(S.map.width,S.map.height),d.uniforms.radius.value=S.radius,n.setRenderTarget(S.mapPass),n.clear(),n.renderBufferDirect(v,null,A,d,x,null),f.uniforms.shadow_pass.value=S.mapPass.texture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,n.setRenderTarget(S.map),n.clear(),n.renderBufferDirect(v,null,A,f,x,null)}function w(S,v,A,L){let T=null,I=A.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(I!==void 0)T=I;else if(T=A.isPointLight===!0?l:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let D=T.uuid,F=v.uuid,R=c[D];R===void 0&&(R={},c[D]=R);let k=R[F];k===void 0&&(k=T.clone(),R[F]=k,v.addEventListener("dispose",E)),T=k}if(T.visible=v.visible,T.wireframe=v.wireframe,L===qs?T.side=v.shadowSide!==null?v.shadowSide:v.side:T.side=v.shadowSide!==null?v.shadowSide:u[v.side],T.alphaMap=v.alphaMap,T.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,T.map=v.map,T.clipShadows=v.clipShadows,T.clippingPlanes=v.clippingPlanes,T.clipIntersection=v.clipIntersection,T.displacementMap=v.displacementMap,T.displacementScale=v.displacementScale,T.displacementBias=v.displacementBias,T.wireframeLinewidth=v.wireframeLinewidth,T.linewidth=v.linewidth,A.isPointLight===!0&&T.isMeshDistanceMaterial===!0){let D=n.properties.get(T);D.light=A}return T}function y(S,v,A,L,T,I){if(S.visible===!1)return;if(S.layers.test(T)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&I===qs)&&(!S.frustumCulled||S.intersectsFrustum(i))){S.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,S.matrixWorld);let R=t.update(S),k=S.material;if(Array.isArray(k)){let W=R.groups;for(let z=0,tt=W.length;z<tt;z++){let q=W[z],Q=k[q.materialIndex];if(Q&&Q.visible){let et=w(S,Q,L,I);S.onBeforeShadow(n,S,v,A,R,et,q),n.renderBufferDirect(A,null,R,et,S,q),S.onAfterShadow(n,S,v,A,R,et,q)}}}else if(k.visible){let W=w(S,k,L,I);S.onBeforeShadow(n,S,v,A,R,W,null),n.renderBufferDirect(A,null,R,W,S,null),S.onAfterShadow(n,S,v,A,R,W,null)}}let F=S.children;for(let R=0,k=F.length;R<k;R++)y(F[R],v,A,L,T,I)}function E(S){S.target.removeEventListener("dispose",E);for(let A in c){let L=c[A],T=S.target.uuid;T in L&&(L[T].dispose(),delete L[T])}}}function jA(n,t){function e(){let P=!1,J=new ye,$=null,ct=new ye(0,0,0,0);return{setMask:function(st){$!==st&&!P&&(n.colorMask(st,st,st,st),$=st)},setLocked:function(st){P=st},setClear:function(st,at,Tt,Gt,it){it===!0&&(st*=Gt,at*=Gt,Tt*=Gt),J.set(st,at,Tt,Gt),ct.equals(J)===!1&&(n.clearColor(st,at,Tt,Gt),ct.copy(J))},reset:function(){P=!1,$=null,ct.set(-1,0,0,0)}}}function i(){let P=!1,J=!1,$=null,ct=null,st=null;return{setReversed:function(at){if(J!==at){let Tt=t.get("EXT_clip_control");at?Tt.clipControlEXT(Tt.LOWER_LEFT_EXT,Tt.ZERO_TO_ONE_EXT):Tt.clipControlEXT(Tt.LOWER_LEFT_EXT,Tt.NEGATIVE_ONE_TO_ONE_EXT),J=at;let Gt=st;st=null,this.setClear(Gt)}},getReversed:function(){return J},setTest:function(at){at?ht(n.DEPTH_TEST):It(n.DEPTH_TEST)},setMask:function(at){$!==at&&!P&&(n.depthMask(at),$=at)},setFunc:function(at){if(J&&(at=Mm[at]),ct!==at){switch(at){case Ma:n.depthFunc(n.NEVER);break;case ba:n.depthFunc(n.ALWAYS);break;case wa:n.depthFunc(n.LESS);break;case Bs:n.depthFunc(n.LEQUAL);break;case Sa:n.depthFunc(n.EQUAL);break;case Aa:n.depthFunc(n.GEQUAL);break;case Ea:n.depthFunc(n.GREATER);break;case Ta:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}ct=at}},setLocked:function(at){P=at},setClear:function(at){st!==at&&(st=at,J&&(at=1-at),n.clearDepth(at))},reset:function(){P=!1,$=null,ct=null,st=null,J=!1}}}function s(){let P=!1,J=null,$=null,ct=null,st=null,at=null,Tt=null,Gt=null,it=null;return{setTest:function(Pt){P||(Pt?ht(n.STENCIL_TEST):It(n.STENCIL_TEST))},setMask:function(Pt){J!==Pt&&!P&&(n.stencilMask(Pt),J=Pt)},setFunc:function(Pt,zt,mt){($!==Pt||ct!==zt||st!==mt)&&(n.stencilFunc(Pt,zt,mt),$=Pt,ct=zt,st=mt)},setOp:function(Pt,zt,mt){(at!==Pt||Tt!==zt||Gt!==mt)&&(n.stencilOp(Pt,zt,mt),at=Pt,Tt=zt,Gt=mt)},setLocked:function(Pt){P=Pt},setClear:function(Pt){it!==Pt&&(n.clearStencil(Pt),it=Pt)},reset:function(){P=!1,J=null,$=null,ct=null,st=null,at=null,Tt=null,Gt=null,it=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],x=null,m=!1,g=null,_=null,w=null,y=null,E=null,S=null,v=null,A=new Jt(0,0,0),L=0,T=!1,I=null,D=null,F=null,R=null,k=null,W=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,tt=0,q=n.getParameter(n.VERSION);q.indexOf("WebGL")!==-1?(tt=parseFloat(/^WebGL (\d)/.exec(q)[1]),z=tt>=1):q.indexOf("OpenGL ES")!==-1&&(tt=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),z=tt>=2);let Q=null,et={},_t=n.getParameter(n.SCISSOR_BOX),Dt=n.getParameter(n.VIEWPORT),K=new ye().fromArray(_t),pt=new ye().fromArray(Dt);function yt(P,J,$,ct){let st=new Uint8Array(4),at=n.createTexture();n.bindTexture(P,at),n.texParameteri(P,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(P,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Tt=0;Tt<$;Tt++)P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY?n.texImage3D(J,0,n.RGBA,1,1,ct,0,n.RGBA,n.UNSIGNED_BYTE,st):n.texImage2D(J+Tt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,st);return at}let St={};St[n.TEXTURE_2D]=yt(n.TEXTURE_2D,n.TEXTURE_2D,1),St[n.TEXTURE_CUBE_MAP]=yt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),St[n.TEXTURE_2D_ARRAY]=yt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),St[n.TEXTURE_3D]=yt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ht(n.DEPTH_TEST),o.setFunc(Bs),Fe(!1),le(Gh),ht(n.CULL_FACE),ge(ts);function ht(P){h[P]!==!0&&(n.enable(P),h[P]=!0)}function It(P){h[P]!==!1&&(n.disable(P),h[P]=!1)}function ae(P,J){return d[P]!==J?(n.bindFramebuffer(P,J),d[P]=J,P===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=J),P===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=J),!0):!1}function Ct(P,J){let $=p,ct=!1;if(P){$=f.get(J),$===void 0&&($=[],f.set(J,$));let st=P.textures;if($.length!==st.length||$[0]!==n.COLOR_ATTACHMENT0){for(let at=0,Tt=st.length;at<Tt;at++)$[at]=n.COLOR_ATTACHMENT0+at;$.length=st.length,ct=!0}}else $[0]!==n.BACK&&($[0]=n.BACK,ct=!0);ct&&n.drawBuffers($)}function $t(P){return x!==P?(n.useProgram(P),x=P,!0):!1}let Kt={[es]:n.FUNC_ADD,[Hp]:n.FUNC_SUBTRACT,[Wp]:n.FUNC_REVERSE_SUBTRACT};Kt[Xp]=n.MIN,Kt[qp]=n.MAX;let Bt={[$p]:n.ZERO,[Yp]:n.ONE,[Kp]:n.SRC_COLOR,[Xh]:n.SRC_ALPHA,[em]:n.SRC_ALPHA_SATURATE,[Qp]:n.DST_COLOR,[Jp]:n.DST_ALPHA,[Zp]:n.ONE_MINUS_SRC_COLOR,[qh]:n.ONE_MINUS_SRC_ALPHA,[tm]:n.ONE_MINUS_DST_COLOR,[jp]:n.ONE_MINUS_DST_ALPHA,[nm]:n.CONSTANT_COLOR,[im]:n.ONE_MINUS_CONSTANT_COLOR,[sm]:n.CONSTANT_ALPHA,[rm]:n.ONE_MINUS_CONSTANT_ALPHA};function ge(P,J,$,ct,st,at,Tt,Gt,it,Pt){if(P===ts){m===!0&&(It(n.BLEND),m=!1);return}if(m===!1&&(ht(n.BLEND),m=!0),P!==Vp){if(P!==g||Pt!==T){if((_!==es||E!==es)&&(n.blendEquation(n.FUNC_ADD),_=es,E=es),Pt)switch(P){case $s:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Vh:n.blendFunc(n.ONE,n.ONE);break;case Hh:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Wh:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Ft("WebGLState: Invalid blending: ",P);break}else switch(P){case $s:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Vh:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Hh:Ft("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Wh:Ft("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ft("WebGLState: Invalid blending: ",P);break}w=null,y=null,S=null,v=null,A.set(0,0,0),L=0,g=P,T=Pt}return}st=st||J,at=at||$,Tt=Tt||ct,(J!==_||st!==E)&&(n.blendEquationSeparate(Kt[J],Kt[st]),_=J,E=st),($!==w||ct!==y||at!==S||Tt!==v)&&(n.blendFuncSeparate(Bt[$],Bt[ct],Bt[at],Bt[Tt]),w=$,y=ct,S=at,v=Tt),(Gt.equals(A)===!1||it!==L)&&(n.blendColor(Gt.r,Gt.g,Gt.b,it),A.copy(Gt),L=it),g=P,T=!1}function _e(P,J){P.side===Mn?It(n.CULL_FACE):ht(n.CULL_FACE);let $=P.side===Qe;J&&($=!$),Fe($),P.blending===$s&&P.transparent===!1?ge(ts):ge(P.blending,P.blendEquation,P.blendSrc,P.blendDst,P.blendEquationAlpha,P.blendSrcAlpha,P.blendDstAlpha,P.blendColor,P.blendAlpha,P.premultipliedAlpha),o.setFunc(P.depthFunc),o.setTest(P.depthTest),o.setMask(P.depthWrite),r.setMask(P.colorWrite);let ct=P.stencilWrite;a.setTest(ct),ct&&(a.setMask(P.stencilWriteMask),a.setFunc(P.stencilFunc,P.stencilRef,P.stencilFuncMask),a.setOp(P.stencilFail,P.stencilZFail,P.stencilZPass)),Se(P.polygonOffset,P.polygonOffsetFactor,P.polygonOffsetUnits),P.alphaToCoverage===!0?ht(n.SAMPLE_ALPHA_TO_COVERAGE):It(n.SAMPLE_ALPHA_TO_COVERAGE)}function Fe(P){I!==P&&(P?n.frontFace(n.CW):n.frontFace(n.CCW),I=P)}function le(P){P!==Bp?(ht(n.CULL_FACE),P!==D&&(P===Gh?n.cullFace(n.BACK):P===zp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):It(n.CULL_FACE),D=P}function dn(P){P!==F&&(z&&n.lineWidth(P),F=P)}function Se(P,J,$){P?(ht(n.POLYGON_OFFSET_FILL),(R!==J||k!==$)&&(R=J,k=$,o.getReversed()&&(J=-J,$=-$),n.polygonOffset(J,$))):It(n.POLYGON_OFFSET_FILL)}function $e(P){P?ht(n.SCISSOR_TEST):It(n.SCISSOR_TEST)}function fe(P){P===void 0&&(P=n.TEXTURE0+W-1),Q!==P&&(n.activeTexture(P),Q=P)}function Ye(P,J,$){$===void 0&&(Q===null?$=n.TEXTURE0+W-1:$=Q);let ct=et[$];ct===void 0&&(ct={type:void 0,texture:void 0},et[$]=ct),(ct.type!==P||ct.texture!==J)&&(Q!==$&&(n.activeTexture($),Q=$),n.bindTexture(P,J||St[P]),ct.type=P,ct.texture=J)}function O(){let P=et[Q];P!==void 0&&P.type!==void 0&&(n.bindTexture(P.type,null),P.type=void 0,P.texture=void 0)}function Ue(){try{n.compressedTexImage2D(...arguments)}catch(P){Ft("WebGLState:",P)}}function ie(){try{n.compressedTexImage3D(...arguments)}catch(P){Ft("WebGLState:",P)}}function Qt(){try{n.texSubImage2D(...arguments)}catch(P){Ft("WebGLState:",P)}}function rt(){try{n.texSubImage3D(...arguments)}catch(P){Ft("WebGLState:",P)}}function pe(){try{n.compressedTexSubImage2D(...arguments)}catch(P){Ft("WebGLState:",P)}}function Rt(){try{n.compressedTexSubImage3D(...arguments)}catch(P){Ft("WebGLState:",P)}}function Lt(){try{n.texStorage2D(...arguments)}catch(P){Ft("WebGLState:",P)}}function C(){try{n.texStorage3D(...arguments)}catch(P){Ft("WebGLState:",P)}}function M(){try{n.texImage2D(...arguments)}catch(P){Ft("WebGLState:",P)}}function G(){try{n.texImage3D(...arguments)}catch(P){Ft("WebGLState:",P)}}function nt(P){return u[P]!==void 0?u[P]:n.getParameter(P)}function j(P,J){u[P]!==J&&(n.pixelStorei(P,J),u[P]=J)}function ot(P){K.equals(P)===!1&&(n.scissor(P.x,P.y,P.z,P.w),K.copy(P))}function dt(P){pt.equals(P)===!1&&(n.viewport(P.x,P.y,P.z,P.w),pt.copy(P))}function Y(P,J){let $=c.get(J);$===void 0&&($=new WeakMap,c.set(J,$));let ct=$.get(P);ct===void 0&&(ct=n.getUniformBlockIndex(J,P.name),n.uniformBlockBinding(J,ct,ct),$.set(P,ct))}function Z(P,J,$){let st=c.get(J).get(P);l[st]!==$&&(n.bindBufferBase(n.UNIFORM_BUFFER,st,$),l[st]=$)}function lt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,et={},d={},l={},f=new WeakMap,p=[],x=null,m=!1,g=null,_=null,w=null,y=null,E=null,S=null,v=null,A=new Jt(0,0,0),L=0,T=!1,I=null,D=null,F=null,R=null,k=null,K.set(0,0,n.canvas.width,n.canvas.height),pt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ht,disable:It,bindFramebuffer:ae,drawBuffers:Ct,useProgram:$t,setBlending:ge,setMaterial:_e,setFlipSided:Fe,setCullFace:le,setLineWidth:dn,setPolygonOffset:Se,setScissorTest:$e,activeTexture:fe,bindTexture:Ye,unbindTexture:O,compressedTexImage2D:Ue,compressedTexImage3D:ie,texImage2D:M,texImage3D:G,pixelStorei:j,getParameter:nt,updateUBOMapping:Y,uniformBlockBinding:Z,texStorage2D:Lt,texStorage3D:C,texSubImage2D:Qt,texSubImage3D:rt,compressedTexSubImage2D:pe,compressedTexSubImage3D:Rt,scissor:ot,viewport:dt,reset:lt}}function QA(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new jt,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(C=>p.delete(C)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(C,M){return m?new OffscreenCanvas(C,M):br("canvas")}function _(C,M,G){let nt=1,j=Lt(C);if((j.width>G||j.height>G)&&(nt=G/Math.max(j.width,j.height)),nt<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let ot=Math.floor(nt*j.width),dt=Math.floor(nt*j.height);d===void 0&&(d=g(ot,dt));let Y=M?g(ot,dt):d;return Y.width=ot,Y.height=dt,Y.getContext("2d").drawImage(C,0,0,ot,dt),Nt("WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+ot+"x"+dt+")."),Y}else return"data"in C&&Nt("WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),C;return C}function w(C){return C.generateMipmaps}function y(C){n.generateMipmap(C)}function E(C){return C.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?n.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function S(C,M,G,nt,j,ot=!1){if(C!==null){if(n[C]!==void 0)return n[C];Nt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let dt;nt&&(dt=t.get("EXT_texture_norm16"),dt||Nt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Y=M;if(M===n.RED&&(G===n.FLOAT&&(Y=n.R32F),G===n.HALF_FLOAT&&(Y=n.R16F),G===n.UNSIGNED_BYTE&&(Y=n.R8),G===n.UNSIGNED_SHORT&&dt&&(Y=dt.R16_EXT),G===n.SHORT&&dt&&(Y=dt.R16_SNORM_EXT)),M===n.RED_INTEGER&&(G===n.UNSIGNED_BYTE&&(Y=n.R8UI),G===n.UNSIGNED_SHORT&&(Y=n.R16UI),G===n.UNSIGNED_INT&&(Y=n.R32UI),G===n.BYTE&&(Y=n.R8I),G===n.SHORT&&(Y=n.R16I),G===n.INT&&(Y=n.R32I)),M===n.RG&&(G===n.FLOAT&&(Y=n.RG32F),G===n.HALF_FLOAT&&(Y=n.RG16F),G===n.UNSIGNED_BYTE&&(Y=n.RG8),G===n.UNSIGNED_SHORT&&dt&&(Y=dt.RG16_EXT),G===n.SHORT&&dt&&(Y=dt.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(G===n.UNSIGNED_BYTE&&(Y=n.RG8UI),G===n.UNSIGNED_SHORT&&(Y=n.RG16UI),G===n.UNSIGNED_INT&&(Y=n.RG32UI),G===n.BYTE&&(Y=n.RG8I),G===n.SHORT&&(Y=n.RG16I),G===n.INT&&(Y=n.RG32I)),M===n.RGB_INTEGER&&(G===n.UNSIGNED_BYTE&&(Y=n.RGB8UI),G===n.UNSIGNED_SHORT&&(Y=n.RGB16UI),G===n.UNSIGNED_INT&&(Y=n.RGB32UI),G===n.BYTE&&(Y=n.RGB8I),G===n.SHORT&&(Y=n.RGB16I),G===n.INT&&(Y=n.RGB32I)),M===n.RGBA_INTEGER&&(G===n.UNSIGNED_BYTE&&(Y=n.RGBA8UI),G===n.UNSIGNED_SHORT&&(Y=n.RGBA16UI),G===n.UNSIGNED_INT&&(Y=n.RGBA32UI),G===n.BYTE&&(Y=n.RGBA8I),G===n.SHORT&&(Y=n.RGBA16I),G===n.INT&&(Y=n.RGBA32I)),M===n.RGB&&(G===n.UNSIGNED_SHORT&&dt&&(Y=dt.RGB16_EXT),G===n.SHORT&&dt&&(Y=dt.RGB16_SNORM_EXT),G===n.UNSIGNED_INT_5_9_9_9_REV&&(Y=n.RGB9_E5),G===n.UNSIGNED_INT_10F_11F_11F_REV&&(Y=n.R11F_G11F_B10F)),M===n.RGBA){let Z=ot?_r:Wt.getTransfer(j);G===n.FLOAT&&(Y=n.RGBA32F),G===n.HALF_FLOAT&&(Y=n.RGBA16F),G===n.UNSIGNED_BYTE&&(Y=Z===ee?n.SRGB8_ALPHA8:n.RGBA8),G===n.UNSIGNED_SHORT&&dt&&(Y=dt.RGBA16_EXT),G===n.SHORT&&dt&&(Y=dt.RGBA16_SNORM_EXT),G===n.UNSIGNED_SHORT_4_4_4_4&&(Y=n.RGBA4),G===n.UNSIGNED_SHORT_5_5_5_1&&(Y=n.RGB5_A1)}return(Y===n.R16F||Y===n.R32F||Y===n.RG16F||Y===n.RG32F||Y===n.RGBA16F||Y===n.RGBA32F)&&t.get("EXT_color_buffer_float"),Y}function v(C,M){let G;return C?M===null||M===Ln||M===is?G=n.DEPTH24_STENCIL8:M===Nn?G=n.DEPTH32F_STENCIL8:M===Ks&&(G=n.DEPTH24_STENCIL8,Nt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Ln||M===is?G=n.DEPTH_COMPONENT24:M===Nn?G=n.DEPTH_COMPONENT32F:M===Ks&&(G=n.DEPTH_COMPONENT16),G}function A(C,M){return w(C)===!0||C.isFramebufferTexture&&C.minFilter!==De&&C.minFilter!==Oe?Math.log2(Math.max(M.width,M.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?M.mipmaps.length:1}function L(C){let M=new WeakRef(C);i.get(C).__ref=M,p.add(M),x.register(C,M,M)}function T(C){let M=i.get(C).__ref;M!==void 0&&(p.delete(M),x.unregister(M))}function I(C){F(C.target)}function D(C){R(C.target)}function F(C){C.removeEventListener("dispose",I),T(C),W(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&u.delete(C)}function R(C){C.removeEventListener("dispose",D),T(C),tt(C)}function k(){for(let C of p){let M=C.deref();M!==void 0&&(M.isRenderTarget===!0?R(M):F(M))}p.clear(),u.clear()}function W(C){let M=i.get(C);if(M.__webglInit===void 0)return;let G=C.source,nt=f.get(G);if(nt){let j=nt[M.__cacheKey];j.usedTimes--,j.usedTimes===0&&z(C),Object.keys(nt).length===0&&f.delete(G)}i.remove(C)}function z(C){let M=i.get(C);n.deleteTexture(M.__webglTexture);let G=C.source,nt=f.get(G);delete nt[M.__cacheKey],o.memory.textures--}function tt(C){let M=i.get(C);M.__depthDisposeCallback&&M.__depthDisposeCallback();let G=C.depthTexture;if(G&&G.renderTarget===C&&F(G),C.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(M.__webglFramebuffer[j]))for(let ot=0;ot<M.__webglFramebuffer[j].length;ot++)n.deleteFramebuffer(M.__webglFramebuffer[j][ot]);else n.deleteFramebuffer(M.__webglFramebuffer[j]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[j])}else{if(Array.isArray(M.__webglFramebuffer))for(let j=0;j<M.__webglFramebuffer.length;j++)n.deleteFramebuffer(M.__webglFramebuffer[j]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let j=0;j<M.__webglColorRenderbuffer.length;j++)M.__webglColorRenderbuffer[j]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[j]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let nt=C.textures;for(let j=0,ot=nt.length;j<ot;j++){let dt=i.get(nt[j]);dt.__webglTexture&&(n.deleteTexture(dt.__webglTexture),o.memory.textures--),i.remove(nt[j])}i.remove(C)}let q=0;function Q(){q=0}function et(){return q}function _t(C){q=C}function Dt(){let C=q;return C>=s.maxTextures&&Nt("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,C}function K(C){let M=[];return M.push(C.wrapS),M.push(C.wrapT),M.push(C.wrapR||0),M.push(C.magFilter),M.push(C.minFilter),M.push(C.anisotropy),M.push(C.internalFormat),M.push(C.format),M.push(C.type),M.push(C.generateMipmaps),M.push(C.mipmapsAutoUpdate),M.push(C.premultiplyAlpha),M.push(C.flipY),M.push(C.unpackAlignment),M.push(C.colorSpace),M.join()}function pt(C,M){let G=i.get(C);if(C.isVideoTexture&&pe(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&G.__version!==C.version){let nt=C.image;if(nt===null)Nt("WebGLRenderer: Texture marked for update but no image data found.");else if(nt.complete===!1)Nt("WebGLRenderer: Texture marked for update but image is incomplete");else{_e(G,C,M);return}}else C.isExternalTexture&&(G.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,G.__webglTexture,n.TEXTURE0+M)}function yt(C,M){let G=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&G.__version!==C.version){_e(G,C,M);return}else C.isExternalTexture&&(G.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,G.__webglTexture,n.TEXTURE0+M)}function St(C,M){let G=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&G.__version!==C.version){_e(G,C,M);return}e.bindTexture(n.TEXTURE_3D,G.__webglTexture,n.TEXTURE0+M)}function ht(C,M){let G=i.get(C);if(C.version>0&&G.__version!==C.version){Fe(G,C,M);return}e.bindTexture(n.TEXTURE_CUBE_MAP,G.__webglTexture,n.TEXTURE0+M)}let It={[Ca]:n.REPEAT,[Hn]:n.CLAMP_TO_EDGE,[Ra]:n.MIRRORED_REPEAT},ae={[De]:n.NEAREST,[lm]:n.NEAREST_MIPMAP_NEAREST,[Or]:n.NEAREST_MIPMAP_LINEAR,[Oe]:n.LINEAR,[el]:n.LINEAR_MIPMAP_NEAREST,[Pn]:n.LINEAR_MIPMAP_LINEAR},Ct={[dm]:n.NEVER,[du]:n.ALWAYS,[fm]:n.LESS,[hu]:n.LEQUAL,[pm]:n.EQUAL,[uu]:n.GEQUAL,[mm]:n.GREATER,[gm]:n.NOTEQUAL};function $t(C,M){if(M.type===Nn&&t.has("OES_texture_float_linear")===!1&&(M.magFilter===Oe||M.magFilter===el||M.magFilter===Or||M.magFilter===Pn||M.minFilter===Oe||M.minFilter===el||M.minFilter===Or||M.minFilter===Pn)&&Nt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(C,n.TEXTURE_WRAP_S,It[M.wrapS]),n.texParameteri(C,n.TEXTURE_WRAP_T,It[M.wrapT]),(C===n.TEXTURE_3D||C===n.TEXTURE_2D_ARRAY)&&n.texParameteri(C,n.TEXTURE_WRAP_R,It[M.wrapR]),n.texParameteri(C,n.TEXTURE_MAG_FILTER,ae[M.magFilter]),n.texParameteri(C,n.TEXTURE_MIN_FILTER,ae[M.minFilter]),M.compareFunction&&(n.texParameteri(C,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(C,n.TEXTURE_COMPARE_FUNC,Ct[M.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===De||M.minFilter!==Or&&M.minFilter!==Pn||M.type===Nn&&t.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let G=t.get("EXT_texture_filter_anisotropic");n.texParameterf(C,G.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function Kt(C,M){let G=!1;C.__webglInit===void 0&&(C.__webglInit=!0,M.addEventListener("dispose",I),L(M));let nt=M.source,j=f.get(nt);j===void 0&&(j={},f.set(nt,j));let ot=K(M);if(ot!==C.__cacheKey){j[ot]===void 0&&(j[ot]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,G=!0),j[ot].usedTimes++;let dt=j[C.__cacheKey];dt!==void 0&&(j[C.__cacheKey].usedTimes--,dt.usedTimes===0&&z(M)),C.__cacheKey=ot,C.__webglTexture=j[ot].texture}return G}function Bt(C,M,G){return Math.floor(Math.floor(C/G)/M)}function ge(C,M,G,nt){let ot=C.updateRanges;if(ot.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,G,nt,M.data);else{ot.sort((P,J)=>P.start-J.start);let dt=0;for(let P=1;P<ot.length;P++){let J=ot[dt],$=ot[P],ct=J.start+J.count,st=Bt($.start,M.width,4),at=Bt(J.start,M.width,4);$.start<=ct+1&&st===at&&Bt($.start+$.count-1,M.width,4)===st?J.count=Math.max(J.count,$.start+$.count-J.start):(++dt,ot[dt]=$)}ot.length=dt+1;let Y=e.getParameter(n.UNPACK_ROW_LENGTH),Z=e.getParameter(n.UNPACK_SKIP_PIXELS),lt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let P=0,J=ot.length;P<J;P++){let $=ot[P],ct=Math.floor($.start/4),st=Math.ceil($.count/4),at=ct%M.width,Tt=Math.floor(ct/M.width),Gt=st,it=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,at),e.pixelStorei(n.UNPACK_SKIP_ROWS,Tt),e.texSubImage2D(n.TEXTURE_2D,0,at,Tt,Gt,it,G,nt,M.data)}C.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,Y),e.pixelStorei(n.UNPACK_SKIP_PIXELS,Z),e.pixelStorei(n.UNPACK_SKIP_ROWS,lt)}}function _e(C,M,G){let nt=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(nt=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(nt=n.TEXTURE_3D);let j=Kt(C,M),ot=M.source;e.bindTexture(nt,C.__webglTexture,n.TEXTURE0+G);let dt=i.get(ot);if(ot.version!==dt.__version||j===!0){if(e.activeTexture(n.TEXTURE0+G),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let it=Wt.getPrimaries(Wt.workingColorSpace),Pt=M.colorSpace===pi?null:Wt.getPrimaries(M.colorSpace),zt=M.colorSpace===pi||it===Pt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,zt)}e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let Z=_(M.image,!1,s.maxTextureSize);Z=Rt(M,Z);let lt=r.convert(M.format,M.colorSpace),P=r.convert(M.type),J=S(M.internalFormat,lt,P,M.normalized,M.colorSpace,M.isVideoTexture);$t(nt,M);let $,ct=M.mipmaps,st=M.isVideoTexture!==!0,at=dt.__version===void 0||j===!0,Tt=ot.dataReady,Gt=A(M,Z);if(M.isDepthTexture)J=v(M.format===fi,M.type),at&&(st?e.texStorage2D(n.TEXTURE_2D,1,J,Z.width,Z.height):e.texImage2D(n.TEXTURE_2D,0,J,Z.width,Z.height,0,lt,P,null));else if(M.isDataTexture)if(ct.length>0){st&&at&&e.texStorage2D(n.TEXTURE_2D,Gt,J,ct[0].width,ct[0].height);for(let it=0,Pt=ct.length;it<Pt;it++)$=ct[it],st?Tt&&e.texSubImage2D(n.TEXTURE_2D,it,0,0,$.width,$.height,lt,P,$.data):e.texImage2D(n.TEXTURE_2D,it,J,$.width,$.height,0,lt,P,$.data);M.generateMipmaps=!1}else st?(at&&e.texStorage2D(n.TEXTURE_2D,Gt,J,Z.width,Z.height),Tt&&ge(M,Z,lt,P)):e.texImage2D(n.TEXTURE_2D,0,J,Z.width,Z.height,0,lt,P,Z.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){st&&at&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Gt,J,ct[0].width,ct[0].height,Z.depth);for(let it=0,Pt=ct.length;it<Pt;it++)if($=ct[it],M.format!==On)if(lt!==null)if(st){if(Tt)if(M.layerUpdates.size>0){let zt=_u($.width,$.height,M.format,M.type);for(let mt of M.layerUpdates){let ne=$.data.subarray(mt*zt/$.data.BYTES_PER_ELEMENT,(mt+1)*zt/$.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,it,0,0,mt,$.width,$.height,1,lt,ne)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,it,0,0,0,$.width,$.height,Z.depth,lt,$.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,it,J,$.width,$.height,Z.depth,0,$.data,0,0);else Nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else st?Tt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,it,0,0,0,$.width,$.height,Z.depth,lt,P,$.data):e.texImage3D(n.TEXTURE_2D_ARRAY,it,J,$.width,$.height,Z.depth,0,lt,P,$.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{st&&at&&e.texStorage2D(n.TEXTURE_2D,Gt,J,ct[0].width,ct[0].height);for(let it=0,Pt=ct.length;it<Pt;it++)$=ct[it],M.format!==On?lt!==null?st?Tt&&e.compressedTexSubImage2D(n.TEXTURE_2D,it,0,0,$.width,$.height,lt,$.data):e.compressedTexImage2D(n.TEXTURE_2D,it,J,$.width,$.height,0,$.data):Nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):st?Tt&&e.texSubImage2D(n.TEXTURE_2D,it,0,0,$.width,$.height,lt,P,$.data):e.texImage2D(n.TEXTURE_2D,it,J,$.width,$.height,0,lt,P,$.data)}else if(M.isDataArrayTexture)if(st){if(at&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Gt,J,Z.width,Z.height,Z.depth),Tt)if(M.layerUpdates.size>0){let it=_u(Z.width,Z.height,M.format,M.type);for(let Pt of M.layerUpdates){let zt=Z.data.subarray(Pt*it/Z.data.BYTES_PER_ELEMENT,(Pt+1)*it/Z.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Pt,Z.width,Z.height,1,lt,P,zt)}M.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,Z.width,Z.height,Z.depth,lt,P,Z.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,J,Z.width,Z.height,Z.depth,0,lt,P,Z.data);else if(M.isData3DTexture)st?(at&&e.texStorage3D(n.TEXTURE_3D,Gt,J,Z.width,Z.height,Z.depth),Tt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,Z.width,Z.height,Z.depth,lt,P,Z.data)):e.texImage3D(n.TEXTURE_3D,0,J,Z.width,Z.height,Z.depth,0,lt,P,Z.data);else if(M.isFramebufferTexture){if(at)if(st)e.texStorage2D(n.TEXTURE_2D,Gt,J,Z.width,Z.height);else{let it=Z.width,Pt=Z.height;for(let zt=0;zt<Gt;zt++)e.texImage2D(n.TEXTURE_2D,zt,J,it,Pt,0,lt,P,null),it>>=1,Pt>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let it=n.canvas;if(it.hasAttribute("layoutsubtree")||it.setAttribute("layoutsubtree","true"),Z.parentNode!==it){it.appendChild(Z),u.add(M),it.onpaint=Pt=>{let zt=Pt.changedElements;for(let mt of u)zt.includes(mt.image)&&(mt.needsUpdate=!0)},it.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,Z);else{let zt=n.RGBA,mt=n.RGBA,ne=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,zt,mt,ne,Z)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(ct.length>0){if(st&&at){let it=Lt(ct[0]);e.texStorage2D(n.TEXTURE_2D,Gt,J,it.width,it.height)}for(let it=0,Pt=ct.length;it<Pt;it++)$=ct[it],st?Tt&&e.texSubImage2D(n.TEXTURE_2D,it,0,0,lt,P,$):e.texImage2D(n.TEXTURE_2D,it,J,lt,P,$);M.generateMipmaps=!1}else if(st){if(at){let it=Lt(Z);e.texStorage2D(n.TEXTURE_2D,Gt,J,it.width,it.height)}Tt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,lt,P,Z)}else e.texImage2D(n.TEXTURE_2D,0,J,lt,P,Z);w(M)&&M.mipmapsAutoUpdate===!0&&y(nt),dt.__version=ot.version,M.onUpdate&&M.onUpdate(M)}C.__version=M.version}function Fe(C,M,G){if(M.image.length!==6)return;let nt=Kt(C,M),j=M.source;e.bindTexture(n.TEXTURE_CUBE_MAP,C.__webglTexture,n.TEXTURE0+G);let ot=i.get(j);if(j.version!==ot.__version||nt===!0){e.activeTexture(n.TEXTURE0+G);let dt=Wt.getPrimaries(Wt.workingColorSpace),Y=M.colorSpace===pi?null:Wt.getPrimaries(M.colorSpace),Z=M.colorSpace===pi||dt===Y?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Z);let lt=M.isCompressedTexture||M.image[0].isCompressedTexture,P=M.image[0]&&M.image[0].isDataTexture,J=[];for(let mt=0;mt<6;mt++)!lt&&!P?J[mt]=_(M.image[mt],!0,s.maxCubemapSize):J[mt]=P?M.image[mt].image:M.image[mt],J[mt]=Rt(M,J[mt]);let $=J[0],ct=r.convert(M.format,M.colorSpace),st=r.convert(M.type),at=S(M.internalFormat,ct,st,M.normalized,M.colorSpace),Tt=M.isVideoTexture!==!0,Gt=ot.__version===void 0||nt===!0,it=j.dataReady,Pt=A(M,$);$t(n.TEXTURE_CUBE_MAP,M);let zt;if(M.isDepthTexture){if(at=v(M.format===fi,M.type),Gt)if(Tt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,at,$.width,$.height);else for(let mt=0;mt<6;mt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,at,$.width,$.height,0,ct,st,null)}else if(lt){Tt&&Gt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Pt,at,$.width,$.height);for(let mt=0;mt<6;mt++){zt=J[mt].mipmaps;for(let ne=0;ne<zt.length;ne++){let Pe=zt[ne];M.format!==On?ct!==null?Tt?it&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ne,0,0,Pe.width,Pe.height,ct,Pe.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ne,at,Pe.width,Pe.height,0,Pe.data):Nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Tt?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ne,0,0,Pe.width,Pe.height,ct,st,Pe.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ne,at,Pe.width,Pe.height,0,ct,st,Pe.data)}}}else{if(zt=M.mipmaps,Tt&&Gt){zt.length>0&&Pt++;let mt=Lt(J[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Pt,at,mt.width,mt.height)}for(let mt=0;mt<6;mt++)if(P){Tt?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,0,0,J[mt].width,J[mt].height,ct,st,J[mt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,at,J[mt].width,J[mt].height,0,ct,st,J[mt].data);for(let ne=0;ne<zt.length;ne++){let mi=zt[ne].image[mt].image;Tt?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ne+1,0,0,mi.width,mi.height,ct,st,mi.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ne+1,at,mi.width,mi.height,0,ct,st,mi.data)}}else{Tt?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,0,0,ct,st,J[mt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+mt,0,at,ct,st,J[mt]);for(let ne=0;ne<zt.length;ne++){let Pe=zt[ne];Tt?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ne+1,0,0,ct,st,Pe.image[mt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+mt,ne+1,at,ct,st,Pe.image[mt])}}}w(M)&&M.mipmapsAutoUpdate===!0&&y(n.TEXTURE_CUBE_MAP),ot.__version=j.version,M.onUpdate&&M.onUpdate(M)}C.__version=M.version}function le(C,M,G,nt,j,ot){let dt=r.convert(G.format,G.colorSpace),Y=r.convert(G.type),Z=S(G.internalFormat,dt,Y,G.normalized,G.colorSpace),lt=i.get(M),P=i.get(G);if(P.__renderTarget=M,!lt.__hasExternalTextures){let J=Math.max(1,M.width>>ot),$=Math.max(1,M.height>>ot);j===n.TEXTURE_3D||j===n.TEXTURE_2D_ARRAY?e.texImage3D(j,ot,Z,J,$,M.depth,0,dt,Y,null):e.texImage2D(j,ot,Z,J,$,0,dt,Y,null)}e.bindFramebuffer(n.FRAMEBUFFER,C),rt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,nt,j,P.__webglTexture,0,Qt(M)):(j===n.TEXTURE_2D||j>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,nt,j,P.__webglTexture,ot),e.bindFramebuffer(n.FRAMEBUFFER,null)}function dn(C,M,G){if(n.bindRenderbuffer(n.RENDERBUFFER,C),M.depthBuffer){let nt=M.depthTexture,j=nt&&nt.isDepthTexture?nt.type:null,ot=v(M.stencilBuffer,j),dt=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;rt(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Qt(M),ot,M.width,M.height):G?n.renderbufferStorageMultisample(n.RENDERBUFFER,Qt(M),ot,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,ot,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,dt,n.RENDERBUFFER,C)}else{let nt=M.textures;for(let j=0;j<nt.length;j++){let ot=nt[j],dt=r.convert(ot.format,ot.colorSpace),Y=r.convert(ot.type),Z=S(ot.internalFormat,dt,Y,ot.normalized,ot.colorSpace);rt(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Qt(M),Z,M.width,M.height):G?n.renderbufferStorageMultisample(n.RENDERBUFFER,Qt(M),Z,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,Z,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Se(C,M,G){let nt=M.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,C),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let j=i.get(M.depthTexture);j.__renderTarget=M;let ot=nt?M.depthTexture.image[0]:M.depthTexture.image;(!j.__webglTexture||ot.width!==M.width||ot.height!==M.height)&&(ot.width=M.width,ot.height=M.height,M.depthTexture.needsUpdate=!0),nt?ht(M.depthTexture,0):pt(M.depthTexture,0);let dt=j.__webglTexture,Y=Qt(M),Z=nt?n.TEXTURE_CUBE_MAP_POSITIVE_X+G:n.TEXTURE_2D,lt=M.depthTexture.format===fi?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===ui)rt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,lt,Z,dt,0,Y):n.framebufferTexture2D(n.FRAMEBUFFER,lt,Z,dt,0);else if(M.depthTexture.format===fi)rt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,lt,Z,dt,0,Y):n.framebufferTexture2D(n.FRAMEBUFFER,lt,Z,dt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function $e(C){let M=i.get(C),G=C.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==C.depthTexture){let nt=C.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),nt){let j=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,nt.removeEventListener("dispose",j)};nt.addEventListener("dispose",j),M.__depthDisposeCallback=j}M.__boundDepthTexture=nt}if(C.depthTexture&&!M.__autoAllocateDepthBuffer)if(G)for(let nt=0;nt<6;nt++)Se(M.__webglFramebuffer[nt],C,nt);else C.texture.mipmaps.length>0?Se(M.__webglFramebuffer[0],C,0):Se(M.__webglFramebuffer,C,0);else if(G){M.__webglDepthbuffer=[];for(let nt=0;nt<6;nt++)if(e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[nt]),M.__webglDepthbuffer[nt]===void 0)M.__webglDepthbuffer[nt]=n.createRenderbuffer(),dn(M.__webglDepthbuffer[nt],C,!1);else{let j=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ot=M.__webglDepthbuffer[nt];n.bindRenderbuffer(n.RENDERBUFFER,ot),n.framebufferRenderbuffer(n.FRAMEBUFFER,j,n.RENDERBUFFER,ot)}}else if(C.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),dn(M.__webglDepthbuffer,C,!1);else{let j=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ot=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ot),n.framebufferRenderbuffer(n.FRAMEBUFFER,j,n.RENDERBUFFER,ot)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function fe(C,M,G){let nt=i.get(C);M!==void 0&&le(nt.__webglFramebuffer,C,C.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),G!==void 0&&$e(C)}function Ye(C){let M=C.texture,G=i.get(C),nt=i.get(M);C.addEventListener("dispose",D),L(C);let j=C.textures,ot=C.isWebGLCubeRenderTarget===!0,dt=j.length>1;if(dt||(nt.__webglTexture===void 0&&(nt.__webglTexture=n.createTexture()),nt.__version=M.version,o.memory.textures++),ot){G.__webglFramebuffer=[];for(let Y=0;Y<6;Y++)if(M.mipmaps.length>0){G.__webglFramebuffer[Y]=[];for(let Z=0;Z<M.mipmaps.length;Z++)G.__webglFramebuffer[Y][Z]=n.createFramebuffer()}else G.__webglFramebuffer[Y]=n.createFramebuffer()}else{if(M.mipmaps.length>0){G.__webglFramebuffer=[];for(let Y=0;Y<M.mipmaps.length;Y++)G.__webglFramebuffer[Y]=n.createFramebuffer()}else G.__webglFramebuffer=n.createFramebuffer();if(dt)for(let Y=0,Z=j.length;Y<Z;Y++){let lt=i.get(j[Y]);lt.__webglTexture===void 0&&(lt.__webglTexture=n.createTexture(),o.memory.textures++)}if(C.samples>0&&rt(C)===!1){G.__webglMultisampledFramebuffer=n.createFramebuffer(),G.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,G.__webglMultisampledFramebuffer);for(let Y=0;Y<j.length;Y++){let Z=j[Y];G.__webglColorRenderbuffer[Y]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,G.__webglColorRenderbuffer[Y]);let lt=r.convert(Z.format,Z.colorSpace),P=r.convert(Z.type),J=S(Z.internalFormat,lt,P,Z.normalized,Z.colorSpace,C.isXRRenderTarget===!0),$=Qt(C);n.renderbufferStorageMultisample(n.RENDERBUFFER,$,J,C.width,C.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Y,n.RENDERBUFFER,G.__webglColorRenderbuffer[Y])}n.bindRenderbuffer(n.RENDERBUFFER,null),C.depthBuffer&&(G.__webglDepthRenderbuffer=n.createRenderbuffer(),dn(G.__webglDepthRenderbuffer,C,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ot){e.bindTexture(n.TEXTURE_CUBE_MAP,nt.__webglTexture),$t(n.TEXTURE_CUBE_MAP,M);for(let Y=0;Y<6;Y++)if(M.mipmaps.length>0)for(let Z=0;Z<M.mipmaps.length;Z++)le(G.__webglFramebuffer[Y][Z],C,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Y,Z);else le(G.__webglFramebuffer[Y],C,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Y,0);w(M)?y(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}else if(dt){for(let Y=0,Z=j.length;Y<Z;Y++){let lt=j[Y],P=i.get(lt),J=n.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(J=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(J,P.__webglTexture),$t(J,lt),le(G.__webglFramebuffer,C,lt,n.COLOR_ATTACHMENT0+Y,J,0),w(lt)&&y(J)}e.unbindTexture()}else{let Y=n.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(Y=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(Y,nt.__webglTexture),$t(Y,M),M.mipmaps.length>0)for(let Z=0;Z<M.mipmaps.length;Z++)le(G.__webglFramebuffer[Z],C,M,n.COLOR_ATTACHMENT0,Y,Z);else le(G.__webglFramebuffer,C,M,n.COLOR_ATTACHMENT0,Y,0);w(M)?y(Y):M.mipmaps.length>0&&n.texParameteri(Y,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}C.depthBuffer&&$e(C)}function O(C){let M=C.textures;for(let G=0,nt=M.length;G<nt;G++){let j=M[G];if(w(j)&&j.mipmapsAutoUpdate===!0){let ot=E(C),dt=i.get(j).__webglTexture;e.bindTexture(ot,dt),y(ot),e.unbindTexture()}}}let Ue=[];function ie(C){if(C.samples>0){if(rt(C)===!1){let M=C.textures,G=C.width,nt=C.height,j=n.COLOR_BUFFER_BIT,ot=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,dt=i.get(C),Y=M.length>1;if(Y)for(let lt=0;lt<M.length;lt++)e.bindFramebuffer(n.FRAMEBUFFER,dt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+lt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,dt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+lt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,dt.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,dt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,dt.__webglFramebuffer);for(let lt=0;lt<M.length;lt++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(j|=n.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(j|=n.STENCIL_BUFFER_BIT)),Y){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,dt.__webglColorRenderbuffer[lt]);let P=i.get(M[lt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,P,0)}n.blitFramebuffer(0,0,G,nt,0,0,G,nt,j,n.NEAREST),l===!0&&(Ue.length=0,Ue.push(n.COLOR_ATTACHMENT0+lt),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Ue.push(ot),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ue))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),Y)for(let lt=0;lt<M.length;lt++){e.bindFramebuffer(n.FRAMEBUFFER,dt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+lt,n.RENDERBUFFER,dt.__webglColorRenderbuffer[lt]);let P=i.get(M[lt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,dt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+lt,n.TEXTURE_2D,P,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,dt.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let M=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function Qt(C){return Math.min(s.maxSamples,C.samples)}function rt(C){let M=i.get(C);return C.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function pe(C){let M=o.render.frame;h.get(C)!==M&&(h.set(C,M),C.update())}function Rt(C,M){let G=C.colorSpace,nt=C.format,j=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||G!==Zi&&G!==pi&&(Wt.getTransfer(G)===ee?(nt!==On||j!==un)&&Nt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ft("WebGLTextures: Unsupported texture color space:",G)),M}function Lt(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=Dt,this.resetTextureUnits=Q,this.getTextureUnits=et,this.setTextureUnits=_t,this.setTexture2D=pt,this.setTexture2DArray=yt,this.setTexture3D=St,this.setTextureCube=ht,this.rebindTextures=fe,this.setupRenderTarget=Ye,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=ie,this.setupDepthRenderbuffer=$e,this.setupFrameBufferTexture=le,this.useMultisampledRTT=rt,this.dispose=k}function tE(n,t){function e(i,s=pi){let r,o=Wt.getTransfer(s);if(i===un)return n.UNSIGNED_BYTE;if(i===il)return n.UNSIGNED_SHORT_4_4_4_4;if(i===sl)return n.UNSIGNED_SHORT_5_5_5_1;if(i===su)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===ru)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===nu)return n.BYTE;if(i===iu)return n.SHORT;if(i===Ks)return n.UNSIGNED_SHORT;if(i===nl)return n.INT;if(i===Ln)return n.UNSIGNED_INT;if(i===Nn)return n.FLOAT;if(i===Dn)return n.HALF_FLOAT;if(i===ou)return n.ALPHA;if(i===au)return n.RGB;if(i===On)return n.RGBA;if(i===ui)return n.DEPTH_COMPONENT;if(i===fi)return n.DEPTH_STENCIL;if(i===lu)return n.RED;if(i===rl)return n.RED_INTEGER;if(i===Ui)return n.RG;if(i===ol)return n.RG_INTEGER;if(i===al)return n.RGBA_INTEGER;if(i===Fr||i===Ur||i===kr||i===Br)if(o===ee)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Fr)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ur)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===kr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Br)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Fr)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ur)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===kr)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Br)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ll||i===cl||i===hl||i===ul)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===ll)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===cl)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===hl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ul)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===dl||i===fl||i===pl||i===ml||i===gl||i===zr||i===xl)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===dl||i===fl)return o===ee?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===pl)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===ml)return r.COMPRESSED_R11_EAC;if(i===gl)return r.COMPRESSED_SIGNED_R11_EAC;if(i===zr)return r.COMPRESSED_RG11_EAC;if(i===xl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===vl||i===yl||i===_l||i===Ml||i===bl||i===wl||i===Sl||i===Al||i===El||i===Tl||i===Cl||i===Rl||i===Il||i===Pl)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===vl)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===yl)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===_l)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Ml)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===bl)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===wl)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Sl)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Al)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===El)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Tl)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Cl)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Rl)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Il)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Pl)return o===ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ll||i===Nl||i===Dl)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Ll)return o===ee?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Nl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Dl)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Ol||i===Fl||i===Gr||i===Ul)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Ol)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Fl)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Gr)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Ul)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===is?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var eE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,nE=`
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

}`,Ru=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Ir(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new _n({vertexShader:eE,fragmentShader:nE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new yn(new Pr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Iu=class extends Wn{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new Ru,g={},_=e.getContextAttributes(),w=null,y=null,E=[],S=[],v=new jt,A=null,L=null,T=new Je;T.viewport=new ye;let I=new Je;I.viewport=new ye;let D=[T,I],F=new ja,R=null,k=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let pt=E[K];return pt===void 0&&(pt=new Vs,E[K]=pt),pt.getTargetRaySpace()},this.getControllerGrip=function(K){let pt=E[K];return pt===void 0&&(pt=new Vs,E[K]=pt),pt.getGripSpace()},this.getHand=function(K){let pt=E[K];return pt===void 0&&(pt=new Vs,E[K]=pt),pt.getHandSpace()};function W(K){let pt=S.indexOf(K.inputSource);if(pt===-1)return;let yt=E[pt];yt!==void 0&&(yt.update(K.inputSource,K.frame,c||o),yt.dispatchEvent({type:K.type,data:K.inputSource}))}function z(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",tt);for(let K=0;K<E.length;K++){let pt=S[K];pt!==null&&(S[K]=null,E[K].disconnect(pt))}R=null,k=null,m.reset();for(let K in g)delete g[K];if(t.setRenderTarget(w),f=null,d=null,u=null,s=null,y=null,Dt.stop(),i.isPresenting=!1,t.setPixelRatio(A),t.setSize(v.width,v.height,!1),L!==null){let K=L.camera;K.fov=L.fov,K.zoom=L.zoom,K.updateProjectionMatrix(),L=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){r=K,i.isPresenting===!0&&Nt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){a=K,i.isPresenting===!0&&Nt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(K){c=K},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(K){if(s=K,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",z),s.addEventListener("inputsourceschange",tt),_.xrCompatible!==!0&&await e.makeXRCompatible(),A=t.getPixelRatio(),t.getSize(v),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let yt=null,St=null,ht=null;_.depth&&(ht=_.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,yt=_.stencil?fi:ui,St=_.stencil?is:Ln);let It={colorFormat:e.RGBA8,depthFormat:ht,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(It),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),y=new cn(d.textureWidth,d.textureHeight,{format:On,type:un,depthTexture:new di(d.textureWidth,d.textureHeight,St,void 0,void 0,void 0,void 0,void 0,void 0,yt),stencilBuffer:_.stencil,colorSpace:t.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let yt={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,yt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),y=new cn(f.framebufferWidth,f.framebufferHeight,{format:On,type:un,colorSpace:t.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Dt.setContext(s),Dt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function tt(K){for(let pt=0;pt<K.removed.length;pt++){let yt=K.removed[pt],St=S.indexOf(yt);St>=0&&(S[St]=null,E[St].disconnect(yt))}for(let pt=0;pt<K.added.length;pt++){let yt=K.added[pt],St=S.indexOf(yt);if(St===-1){for(let It=0;It<E.length;It++)if(It>=S.length){S.push(yt),St=It;break}else if(S[It]===null){S[It]=yt,St=It;break}if(St===-1)break}let ht=E[St];ht&&ht.connect(yt)}}function q(K,pt){pt===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(pt.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(s===null)return;let pt=K.near,yt=K.far;m.texture!==null&&(m.depthNear>0&&(pt=m.depthNear),m.depthFar>0&&(yt=m.depthFar)),F.near=I.near=T.near=pt,F.far=I.far=T.far=yt,(R!==F.near||k!==F.far)&&(s.updateRenderState({depthNear:F.near,depthFar:F.far}),R=F.near,k=F.far),F.layers.mask=K.layers.mask|6,T.layers.mask=F.layers.mask&-5,I.layers.mask=F.layers.mask&-3;let St=K.parent,ht=F.cameras;q(F,St);for(let It=0;It<ht.length;It++)q(ht[It],St);F.projectionMatrix.copy(T.projectionMatrix),F.projectionMatrixInverse.copy(T.projectionMatrixInverse),L===null&&K.isPerspectiveCamera&&(L={camera:K,fov:K.fov,zoom:K.zoom}),Q(K,F,St)};function Q(K,pt,yt){yt===null?K.matrix.copy(pt.matrixWorld):(K.matrix.copy(yt.matrixWorld),K.matrix.invert(),K.matrix.multiply(pt.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(pt.projectionMatrix),K.projectionMatrixInverse.copy(pt.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=Pa*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return F},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(K){l=K,d!==null&&(d.fixedFoveation=K),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=K)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(F)},this.getCameraTexture=function(K){return g[K]};let et=null;function _t(K,pt){if(h=pt.getViewerPose(c||o),p=pt,h!==null){let yt=h.views;f!==null&&(t.setRenderTargetFramebuffer(y,f.framebuffer),t.setRenderTarget(y));let St=!1;yt.length!==F.cameras.length&&(F.cameras.length=0,St=!0);for(let Ct=0;Ct<yt.length;Ct++){let $t=yt[Ct],Kt=null;if(f!==null)Kt=f.getViewport($t);else{let ge=u.getViewSubImage(d,$t);Kt=ge.viewport,Ct===0&&(t.setRenderTargetTextures(y,ge.colorTexture,ge.depthStencilTexture),t.setRenderTarget(y))}let Bt=D[Ct];Bt===void 0&&(Bt=new Je,Bt.layers.enable(Ct),Bt.viewport=new ye,D[Ct]=Bt),Bt.matrix.fromArray($t.transform.matrix),Bt.matrix.decompose(Bt.position,Bt.quaternion,Bt.scale),Bt.projectionMatrix.fromArray($t.projectionMatrix),Bt.projectionMatrixInverse.copy(Bt.projectionMatrix).invert(),Bt.viewport.set(Kt.x,Kt.y,Kt.width,Kt.height),Ct===0&&(F.matrix.copy(Bt.matrix),F.matrix.decompose(F.position,F.quaternion,F.scale)),St===!0&&F.cameras.push(Bt)}let ht=s.enabledFeatures;if(ht&&ht.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=i.getBinding();let Ct=u.getDepthInformation(yt[0]);Ct&&Ct.isValid&&Ct.texture&&m.init(Ct,s.renderState)}if(ht&&ht.includes("camera-access")&&x){t.state.unbindTexture(),u=i.getBinding();for(let Ct=0;Ct<yt.length;Ct++){let $t=yt[Ct].camera;if($t){let Kt=g[$t];Kt||(Kt=new Ir,g[$t]=Kt);let Bt=u.getCameraImage($t);Kt.sourceTexture=Bt}}}}for(let yt=0;yt<E.length;yt++){let St=S[yt],ht=E[yt];St!==null&&ht!==void 0&&ht.update(St,pt,c||o)}et&&et(K,pt),pt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:pt}),p=null}let Dt=new Ym;Dt.setAnimationLoop(_t),this.setAnimationLoop=function(K){et=K},this.dispose=function(){}}},iE=new Me,sg=new Ut;sg.set(-1,0,0,0,1,0,0,0,1);function sE(n,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,xu(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,_,w,y){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,y)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,_,w):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Qe&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Qe&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let _=t.get(g),w=_.envMap,y=_.envMapRotation;w&&(m.envMap.value=w,m.envMapRotation.value.setFromMatrix4(iE.makeRotationFromEuler(y)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(sg),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,_,w){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*_,m.scale.value=w*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,_){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Qe&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=_.texture,m.transmissionSamplerSize.value.set(_.width,_.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let _=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(_.matrixWorld),m.nearDistance.value=_.shadow.camera.near,m.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function rE(n,t,e,i){let s={},r={};function o(_,w){let y=w.program;i.uniformBlockBinding(_,y,s[_.id])}function a(_,w){let y=s[_.id];y===void 0&&(p(_),y=l(_),s[_.id]=y,_.addEventListener("dispose",m));let E=w.program;i.updateUBOMapping(_,E);let S=t.render.frame;r[_.id]!==S&&(c(_),r[_.id]=S)}function l(_){let w=n.createBuffer(),y=_.__size,E=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,y,E),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(_){let w=s[_.id],y=_.uniforms,E=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let S=0,v=y.length;S<v;S++){let A=y[S];if(Array.isArray(A))for(let L=0,T=A.length;L<T;L++)h(A[L],S,L,E);else h(A,S,0,E)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(_,w,y,E){if(d(_,w,y,E)===!0){let S=_.__offset,v=_.value;if(Array.isArray(v)){let A=0;for(let L=0;L<v.length;L++){let T=v[L],I=x(T,!0);u(T,_.__data,A),A+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else u(v,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,S,_.__data)}}function u(_,w,y){typeof _=="number"||typeof _=="boolean"?w[y]=_:_.isMatrix3?(w[y]=_.elements[0],w[y+1]=_.elements[1],w[y+2]=_.elements[2],w[y+3]=0,w[y+4]=_.elements[3],w[y+5]=_.elements[4],w[y+6]=_.elements[5],w[y+7]=0,w[y+8]=_.elements[6],w[y+9]=_.elements[7],w[y+10]=_.elements[8],w[y+11]=0):ArrayBuffer.isView(_)?w.set(_.subarray(0,w.length-y),y):_.toArray(w,y)}function d(_,w,y,E){let S=_.value,v=w+"_"+y;if(Array.isArray(S)){E[v]===void 0&&(E[v]=[]);let A=E[v],L=!1;for(let T=0;T<S.length;T++)f(S[T],A,T)===!0&&(L=!0);return L}return f(S,E,v)}function f(_,w,y){if(w[y]===void 0)return typeof _=="number"||typeof _=="boolean"?w[y]=_:ArrayBuffer.isView(_)?w[y]=_.slice():w[y]=_.clone(),!0;{let E=w[y];if(typeof _=="number"||typeof _=="boolean"){if(E!==_)return w[y]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(E.equals(_)===!1)return E.copy(_),!0}}return!1}function p(_){let w=_.uniforms,y=0,E=16;for(let v=0,A=w.length;v<A;v++){let L=Array.isArray(w[v])?w[v]:[w[v]];for(let T=0,I=L.length;T<I;T++){let D=L[T],F=Array.isArray(D.value)?D.value:[D.value],R=Array.isArray(w[v])||Array.isArray(D.value),k=y;for(let z=0,tt=F.length;z<tt;z++){let q=F[z],Q=x(q,R),et=y%E,_t=et%Q.boundary,Dt=et+_t;y+=_t,Dt!==0&&E-Dt<Q.storage&&(y+=E-Dt),z===0&&(k=y),y+=Q.storage}let W=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new W((y-k)/Float32Array.BYTES_PER_ELEMENT),D.__offset=k}}let S=y%E;return S>0&&(y+=E-S),_.__size=y,_.__cache={},this}function x(_,w){let y={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(y.boundary=4,y.storage=4):_.isVector2?(y.boundary=8,y.storage=8):_.isVector3||_.isColor?(y.boundary=16,y.storage=12):_.isVector4?(y.boundary=16,y.storage=16):_.isMatrix3?(y.boundary=16,y.storage=48):_.isMatrix4?(y.boundary=16,y.storage=64):_.isTexture?Nt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(y.boundary=16,y.storage=_.byteLength):Nt("WebGLRenderer: Unsupported uniform value type.",_),w===!0&&(y.boundary=16,y.storage=Math.ceil(y.storage/16)*16),y}function m(_){let w=_.target;w.removeEventListener("dispose",m),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function g(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:g}}var oE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Yn=null;function aE(){return Yn===null&&(Yn=new ji(oE,16,16,Ui,Dn),Yn.name="DFG_LUT",Yn.minFilter=Oe,Yn.magFilter=Oe,Yn.wrapS=Hn,Yn.wrapT=Hn,Yn.generateMipmaps=!1,Yn.needsUpdate=!0),Yn}var Gl=class{constructor(t={}){let{canvas:e=vm(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=un}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let x=f,m=new Set([al,ol,rl]),g=new Set([un,Ln,Ks,is,il,sl]),_=new Uint32Array(4),w=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},E=null,S=null,v=[],A=[],L=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=$n,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let T=this,I=!1,D=null,F=null,R=null,k=null;this._outputColorSpace=ln;let W=0,z=0,tt=null,q=-1,Q=null,et=new ye,_t=new ye,Dt=null,K=new Jt(0),pt=0,yt=e.width,St=e.height,ht=1,It=null,ae=null,Ct=new ye(0,0,yt,St),$t=new ye(0,0,yt,St),Kt=!1,Bt=new Qi,ge=new Ua,_e=!1,Fe=!1,le=new Me,dn=new X,Se=new ye,$e={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},fe=!1;function Ye(){return tt===null?ht:1}let O=i;function Ue(b,N){return e.getContext(b,N)}let ie,Qt,rt,pe,Rt,Lt,C,M,G,nt,j,ot,dt,Y,Z,lt,P,J,$,ct,st,at,Tt;try{let b={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Pt,!1),e.addEventListener("webglcontextrestored",zt,!1),e.addEventListener("webglcontextcreationerror",mt,!1),O===null){let N="webgl2";if(O=Ue(N,b),O===null)throw Ue(N)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Gt()}catch(b){throw e.removeEventListener("webglcontextlost",Pt,!1),e.removeEventListener("webglcontextrestored",zt,!1),e.removeEventListener("webglcontextcreationerror",mt,!1),Ft("WebGLRenderer: "+b.message),b}function Gt(){ie=new vS(O),ie.init(),st=new tE(O,ie),Qt=new aS(O,ie,t,st),rt=new jA(O,ie),Qt.reversedDepthBuffer&&d&&rt.buffers.depth.setReversed(!0),F=O.createFramebuffer(),R=O.createFramebuffer(),k=O.createFramebuffer(),pe=new MS(O),Rt=new kA,Lt=new QA(O,ie,rt,Rt,Qt,st,pe),C=new xS(T),M=new w1(O),at=new rS(O,M),G=new yS(O,M,pe,at),nt=new wS(O,G,M,at,pe),J=new bS(O,Qt,Lt),Z=new lS(Rt),j=new UA(T,C,ie,Qt,at,Z),ot=new sE(T,Rt),dt=new zA,Y=new qA(ie),P=new sS(T,C,rt,nt,p,l),lt=new JA(T,nt,Qt),Tt=new rE(O,pe,Qt,rt),$=new oS(O,ie,pe),ct=new _S(O,ie,pe),pe.programs=j.programs,T.capabilities=Qt,T.extensions=ie,T.properties=Rt,T.renderLists=dt,T.shadowMap=lt,T.state=rt,T.info=pe}x!==un&&(L=new AS(x,e.width,e.height,a,s,r));let it=new Iu(T,O);this.xr=it,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let b=ie.get("WEBGL_lose_context");b&&b.loseContext()},this.forceContextRestore=function(){let b=ie.get("WEBGL_lose_context");b&&b.restoreContext()},this.getPixelRatio=function(){return ht},this.setPixelRatio=function(b){b!==void 0&&(ht=b,this.setSize(yt,St,!1))},this.getSize=function(b){return b.set(yt,St)},this.setSize=function(b,N,H=!0){if(it.isPresenting){Nt("WebGLRenderer: Can't change size while VR device is presenting.");return}yt=b,St=N,e.width=Math.floor(b*ht),e.height=Math.floor(N*ht),H===!0&&(e.style.width=b+"px",e.style.height=N+"px"),L!==null&&L.setSize(e.width,e.height),this.setViewport(0,0,b,N)},this.getDrawingBufferSize=function(b){return b.set(yt*ht,St*ht).floor()},this.setDrawingBufferSize=function(b,N,H){yt=b,St=N,ht=H,e.width=Math.floor(b*H),e.height=Math.floor(N*H),this.setViewport(0,0,b,N)},this.setEffects=function(b){if(x===un){Ft("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(b){for(let N=0;N<b.length;N++)if(b[N].isOutputPass===!0){Nt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}L.setEffects(b||[])},this.getCurrentViewport=function(b){return b.copy(et)},this.getViewport=function(b){return b.copy(Ct)},this.setViewport=function(b,N,H,B){b.isVector4?Ct.set(b.x,b.y,b.z,b.w):Ct.set(b,N,H,B),rt.viewport(et.copy(Ct).multiplyScalar(Ye()).round())},this.getScissor=function(b){return b.copy($t)},this.setScissor=function(b,N,H,B){b.isVector4?$t.set(b.x,b.y,b.z,b.w):$t.set(b,N,H,B),rt.scissor(_t.copy($t).multiplyScalar(Ye()).round())},this.getScissorTest=function(){return Kt},this.setScissorTest=function(b){rt.setScissorTest(Kt=b)},this.setOpaqueSort=function(b){It=b},this.setTransparentSort=function(b){ae=b},this.getClearColor=function(b){return b.copy(P.getClearColor())},this.setClearColor=function(){P.setClearColor(...arguments)},this.getClearAlpha=function(){return P.getClearAlpha()},this.setClearAlpha=function(){P.setClearAlpha(...arguments)},this.clear=function(b=!0,N=!0,H=!0){let B=0;if(b){let V=!1;if(tt!==null){let ft=tt.texture.format;V=m.has(ft)}if(V){let ft=tt.texture.type,Mt=g.has(ft),ut=P.getClearColor(),xt=P.getClearAlpha(),At=ut.r,kt=ut.g,Xt=ut.b;Mt?(_[0]=At,_[1]=kt,_[2]=Xt,_[3]=xt,O.clearBufferuiv(O.COLOR,0,_)):(w[0]=At,w[1]=kt,w[2]=Xt,w[3]=xt,O.clearBufferiv(O.COLOR,0,w))}else B|=O.COLOR_BUFFER_BIT}N&&(B|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),H&&(B|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),B!==0&&O.clear(B)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(b){b.setRenderer(this),D=b},this.dispose=function(){e.removeEventListener("webglcontextlost",Pt,!1),e.removeEventListener("webglcontextrestored",zt,!1),e.removeEventListener("webglcontextcreationerror",mt,!1),P.dispose(),dt.dispose(),Y.dispose(),Lt.dispose(),Rt.dispose(),C.dispose(),nt.dispose(),G.dispose(),at.dispose(),Tt.dispose(),j.dispose(),it.dispose(),it.removeEventListener("sessionstart",Vu),it.removeEventListener("sessionend",Hu),ki.stop()};function Pt(b){b.preventDefault(),mu("WebGLRenderer: Context Lost."),I=!0}function zt(){mu("WebGLRenderer: Context Restored."),I=!1;let b=pe.autoReset,N=lt.enabled,H=lt.autoUpdate,B=lt.needsUpdate,V=lt.type;Gt(),pe.autoReset=b,lt.enabled=N,lt.autoUpdate=H,lt.needsUpdate=B,lt.type=V}function mt(b){Ft("WebGLRenderer: A WebGL context could not be created. Reason: ",b.statusMessage)}function ne(b){let N=b.target;N.removeEventListener("dispose",ne),Pe(N)}function Pe(b){mi(b),Rt.remove(b)}function mi(b){let N=Rt.get(b).programs;N!==void 0&&(N.forEach(function(H){j.releaseProgram(H)}),b.isShaderMaterial&&j.releaseShaderCache(b))}this.renderBufferDirect=function(b,N,H,B,V,ft){N===null&&(N=$e);let Mt=V.isMesh&&V.matrixWorld.determinantAffine()<0,ut=Gg(b,N,H,B,V);rt.setMaterial(B,Mt);let xt=H.index,At=1;if(B.wireframe===!0){if(xt=G.getWireframeAttribute(H),xt===void 0)return;At=2}let kt=H.drawRange,Xt=H.attributes.position,bt=kt.start*At,qt=(kt.start+kt.count)*At;ft!==null&&(bt=Math.max(bt,ft.start*At),qt=Math.min(qt,(ft.start+ft.count)*At)),xt!==null?(bt=Math.max(bt,0),qt=Math.min(qt,xt.count)):Xt!=null&&(bt=Math.max(bt,0),qt=Math.min(qt,Xt.count));let Ae=qt-bt;if(Ae<0||Ae===1/0)return;at.setup(V,B,ut,H,xt);let ce,re=$;if(xt!==null&&(ce=M.get(xt),re=ct,re.setIndex(ce)),V.isMesh)B.wireframe===!0?(rt.setLineWidth(B.wireframeLinewidth*Ye()),re.setMode(O.LINES)):re.setMode(O.TRIANGLES);else if(V.isLine){let ze=B.linewidth;ze===void 0&&(ze=1),rt.setLineWidth(ze*Ye()),V.isLineSegments?re.setMode(O.LINES):V.isLineLoop?re.setMode(O.LINE_LOOP):re.setMode(O.LINE_STRIP)}else V.isPoints?re.setMode(O.POINTS):V.isSprite&&re.setMode(O.TRIANGLES);if(V.isBatchedMesh)if(ie.get("WEBGL_multi_draw"))re.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{let ze=V._multiDrawStarts,wt=V._multiDrawCounts,Ke=V._multiDrawCount,te=xt?M.get(xt).bytesPerElement:1,Bi=Rt.get(B).currentProgram.getUniforms();for(let Ge=0;Ge<Ke;Ge++)Bi.setValue(O,"_gl_DrawID",Ge),re.render(ze[Ge]/te,wt[Ge])}else if(V.isInstancedMesh)re.renderInstances(bt,Ae,V.count);else if(H.isInstancedBufferGeometry){let ze=H._maxInstanceCount!==void 0?H._maxInstanceCount:1/0,wt=Math.min(H.instanceCount,ze);re.renderInstances(bt,Ae,wt)}else re.render(bt,Ae)};function Gu(b,N,H,B){D!==null&&b.isNodeMaterial&&D.setObject(B,b),_e===!0&&Z.setState(b,H,!1),b.transparent===!0&&b.side===Mn&&b.forceSinglePass===!1?(b.side=Qe,b.needsUpdate=!0,tr(b,N,B),b.side=Fi,b.needsUpdate=!0,tr(b,N,B),b.side=Mn):tr(b,N,B)}this.compile=function(b,N,H=null){H===null&&(H=b),D!==null&&D.renderStart(b,N,H),S=Y.get(H),S.init(N),A.push(S),H.traverseVisible(function(V){V.isLight&&V.layers.test(N.layers)&&(S.pushLight(V),V.castShadow&&S.pushShadow(V))}),b!==H&&b.traverseVisible(function(V){V.isLight&&V.layers.test(N.layers)&&(S.pushLight(V),V.castShadow&&S.pushShadow(V))}),S.setupLights(),D!==null&&D.updateLights(S.state.lightsArray),Fe=this.localClippingEnabled,_e=Z.init(this.clippingPlanes,Fe),_e===!0&&Z.setGlobalState(this.clippingPlanes,N),D!==null&&lt.render(S.state.shadowsArray,H,N);let B=new Set;return b.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;let ft=V.material;if(ft)if(Array.isArray(ft))for(let Mt=0;Mt<ft.length;Mt++){let ut=ft[Mt];Gu(ut,H,N,V),B.add(ut)}else Gu(ft,H,N,V),B.add(ft)}),S=A.pop(),D!==null&&D.renderEnd(),B},this.compileAsync=function(b,N,H=null){let B=this.compile(b,N,H);return new Promise(V=>{function ft(){if(B.forEach(function(Mt){let xt=Rt.get(Mt).currentProgram;(xt===void 0||xt.isReady())&&B.delete(Mt)}),B.size===0){V(b);return}setTimeout(ft,10)}ie.get("KHR_parallel_shader_compile")!==null?ft():setTimeout(ft,10)})};let pc=null;function Bg(b){pc&&pc(b)}function Vu(){ki.stop()}function Hu(){ki.start()}let ki=new Ym;ki.setAnimationLoop(Bg),typeof self<"u"&&ki.setContext(self),this.setAnimationLoop=function(b){pc=b,it.setAnimationLoop(b),b===null?ki.stop():ki.start()},it.addEventListener("sessionstart",Vu),it.addEventListener("sessionend",Hu),this.render=function(b,N){if(N!==void 0&&N.isCamera!==!0){Ft("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;D!==null&&D.renderStart(b,N);let H=it.enabled===!0&&it.isPresenting===!0,B=L!==null&&(tt===null||H)&&L.begin(T,tt);if(b.matrixWorldAutoUpdate===!0&&b.updateMatrixWorld(),N.parent===null&&N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),it.enabled===!0&&it.isPresenting===!0&&(L===null||L.isCompositing()===!1)&&(it.cameraAutoUpdate===!0&&it.updateCamera(N),N=it.getCamera()),b.isScene===!0&&b.onBeforeRender(T,b,N,tt),S=Y.get(b,A.length),S.init(N),S.state.textureUnits=Lt.getTextureUnits(),A.push(S),le.multiplyMatrices(N.projectionMatrix,N.matrixWorldInverse),N.isArrayCamera?ge.setFromArrayCamera(N):Bt.setFromProjectionMatrix(le,gn,N.reversedDepth),Fe=this.localClippingEnabled,_e=Z.init(this.clippingPlanes,Fe),E=dt.get(b,v.length),E.init(),v.push(E),this.info.render.frame++,it.enabled===!0&&it.isPresenting===!0){let Mt=T.xr.getDepthSensingMesh();Mt!==null&&mc(Mt,N,-1/0,T.sortObjects)}mc(b,N,0,T.sortObjects),E.finish(),D!==null&&D.updateLights(S.state.lightsArray),T.sortObjects===!0&&E.sort(It,ae),fe=it.enabled===!1||it.isPresenting===!1||it.hasDepthSensing()===!1,fe&&P.addToRenderList(E,b),this.info.autoReset===!0&&this.info.reset(),_e===!0&&Z.beginShadows();let V=S.state.shadowsArray;if(lt.render(V,b,N),_e===!0&&Z.endShadows(),(B&&L.hasRenderPass())===!1){let Mt=E.opaque,ut=E.transmissive;if(S.setupLights(),N.isArrayCamera){let xt=N.cameras;if(ut.length>0)for(let At=0,kt=xt.length;At<kt;At++){let Xt=xt[At];Xu(Mt,ut,b,Xt)}fe&&P.render(b);for(let At=0,kt=xt.length;At<kt;At++){let Xt=xt[At];Wu(E,b,Xt,Xt.viewport)}}else ut.length>0&&Xu(Mt,ut,b,N),fe&&P.render(b),Wu(E,b,N)}tt!==null&&z===0&&(Lt.updateMultisampleRenderTarget(tt),Lt.updateRenderTargetMipmap(tt)),B&&L.end(T),b.isScene===!0&&b.onAfterRender(T,b,N),at.resetDefaultState(),q=-1,Q=null,A.pop(),A.length>0?(S=A[A.length-1],Lt.setTextureUnits(S.state.textureUnits),_e===!0&&Z.setGlobalState(T.clippingPlanes,S.state.camera)):S=null,v.pop(),v.length>0?E=v[v.length-1]:E=null,D!==null&&D.renderEnd()};function mc(b,N,H,B){if(b.visible===!1)return;if(b.layers.test(N.layers)){if(b.isGroup)H=b.renderOrder;else if(b.isLOD)b.autoUpdate===!0&&b.update(N);else if(b.isLight)S.pushLight(b),b.castShadow&&S.pushShadow(b);else if(b.isSprite){let Mt=N.isArrayCamera?ge:Bt;if(!b.frustumCulled||b.intersectsFrustum(Mt)){B&&Se.setFromMatrixPosition(b.matrixWorld).applyMatrix4(le);let ut=nt.update(b),xt=b.material;xt.visible&&E.push(b,ut,xt,H,Se.z,null,N)}}else if(b.isMesh||b.isLine||b.isPoints){let Mt=N.isArrayCamera?ge:Bt;if(!b.frustumCulled||b.intersectsFrustum(Mt)){let ut=nt.update(b),xt=b.material;if(B&&(b.boundingSphere!==void 0?(b.boundingSphere===null&&b.computeBoundingSphere(),Se.copy(b.boundingSphere.center)):(ut.boundingSphere===null&&ut.computeBoundingSphere(),Se.copy(ut.boundingSphere.center)),Se.applyMatrix4(b.matrixWorld).applyMatrix4(le)),Array.isArray(xt)){let At=ut.groups;for(let kt=0,Xt=At.length;kt<Xt;kt++){let bt=At[kt],qt=xt[bt.materialIndex];qt&&qt.visible&&E.push(b,ut,qt,H,Se.z,bt,N)}}else xt.visible&&E.push(b,ut,xt,H,Se.z,null,N)}}}let ft=b.children;for(let Mt=0,ut=ft.length;Mt<ut;Mt++)mc(ft[Mt],N,H,B)}function Wu(b,N,H,B){let{opaque:V,transmissive:ft,transparent:Mt}=b;S.setupLightsView(H),_e===!0&&Z.setGlobalState(T.clippingPlanes,H),B&&rt.viewport(et.copy(B)),V.length>0&&Jr(V,N,H),ft.length>0&&Jr(ft,N,H),Mt.length>0&&Jr(Mt,N,H),rt.buffers.depth.setTest(!0),rt.buffers.depth.setMask(!0),rt.buffers.color.setMask(!0),rt.setPolygonOffset(!1)}function Xu(b,N,H,B){if((H.isScene===!0?H.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[B.id]===void 0){let bt=ie.has("EXT_color_buffer_half_float")||ie.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[B.id]=new cn(1,1,{generateMipmaps:!0,type:bt?Dn:un,minFilter:Pn,samples:Math.max(4,Qt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Wt.workingColorSpace})}let ft=S.state.transmissionRenderTarget[B.id],Mt=B.viewport||et;ft.setSize(Mt.z*T.transmissionResolutionScale,Mt.w*T.transmissionResolutionScale);let ut=T.getRenderTarget(),xt=T.getActiveCubeFace(),At=T.getActiveMipmapLevel();T.setRenderTarget(ft),T.getClearColor(K),pt=T.getClearAlpha(),pt<1&&T.setClearColor(16777215,.5),T.clear(),fe&&P.render(H);let kt=T.toneMapping;T.toneMapping=$n;let Xt=B.viewport;if(B.viewport!==void 0&&(B.viewport=void 0),S.setupLightsView(B),_e===!0&&Z.setGlobalState(T.clippingPlanes,B),Jr(b,H,B),Lt.updateMultisampleRenderTarget(ft),Lt.updateRenderTargetMipmap(ft),ie.has("WEBGL_multisampled_render_to_texture")===!1){let bt=!1;for(let qt=0,Ae=N.length;qt<Ae;qt++){let ce=N[qt],{object:re,geometry:ze,material:wt,group:Ke}=ce;if(wt.side===Mn&&re.layers.test(B.layers)){let te=wt.side;wt.side=Qe,wt.needsUpdate=!0,qu(re,H,B,ze,wt,Ke),wt.side=te,wt.needsUpdate=!0,bt=!0}}bt===!0&&(Lt.updateMultisampleRenderTarget(ft),Lt.updateRenderTargetMipmap(ft))}T.setRenderTarget(ut,xt,At),T.setClearColor(K,pt),Xt!==void 0&&(B.viewport=Xt),T.toneMapping=kt}function Jr(b,N,H){let B=N.isScene===!0?N.overrideMaterial:null;for(let V=0,ft=b.length;V<ft;V++){let Mt=b[V],{object:ut,geometry:xt,group:At}=Mt,kt=Mt.material;kt.allowOverride===!0&&B!==null&&(kt=B),ut.layers.test(H.layers)&&qu(ut,N,H,xt,kt,At)}}function qu(b,N,H,B,V,ft){D!==null&&V.isNodeMaterial&&D.setObject(b,V),b.onBeforeRender(T,N,H,B,V,ft),b.modelViewMatrix.multiplyMatrices(H.matrixWorldInverse,b.matrixWorld),b.normalMatrix.getNormalMatrix(b.modelViewMatrix),V.onBeforeRender(T,N,H,B,b,ft),V.transparent===!0&&V.side===Mn&&V.forceSinglePass===!1?(V.side=Qe,V.needsUpdate=!0,T.renderBufferDirect(H,N,B,V,b,ft),V.side=Fi,V.needsUpdate=!0,T.renderBufferDirect(H,N,B,V,b,ft),V.side=Mn):T.renderBufferDirect(H,N,B,V,b,ft),b.onAfterRender(T,N,H,B,V,ft)}function $u(b){let N=0;for(let H of b)H.texture!==null&&N++;return N}function tr(b,N,H){N.isScene!==!0&&(N=$e);let B=Rt.get(b),V=S.state.lights,ft=S.state.shadowsArray,Mt=V.state.version,ut=j.getParameters(b,V.state,ft,N,H,S.state.lightProbeGridArray),xt=j.getProgramCacheKey(ut),At=B.programs;B.environment=b.isMeshStandardMaterial||b.isMeshLambertMaterial||b.isMeshPhongMaterial?N.environment:null,B.fog=N.fog;let kt=b.isMeshStandardMaterial||b.isMeshLambertMaterial&&!b.envMap||b.isMeshPhongMaterial&&!b.envMap;B.envMap=C.get(b.envMap||B.environment,kt),B.envMapRotation=B.environment!==null&&b.envMap===null?N.environmentRotation:b.envMapRotation,At===void 0&&(b.addEventListener("dispose",ne),At=new Map,B.programs=At,B.programVariants=new Map);let Xt=At.get(xt);if(Xt!==void 0){if(B.currentProgram===Xt&&B.lightsStateVersion===Mt)return Ku(b,ut),Xt}else ut.uniforms=j.getUniforms(b),D!==null&&b.isNodeMaterial&&D.build(b,H,ut),b.onBeforeCompile(ut,T),Xt=j.acquireProgram(ut,xt),At.set(xt,Xt),B.uniforms=ut.uniforms;let bt=B.uniforms;return(!b.isShaderMaterial&&!b.isRawShaderMaterial||b.clipping===!0)&&(bt.clippingPlanes=Z.uniform),Ku(b,ut),B.needsLights=Hg(b),B.lightsStateVersion=Mt,B.needsLights&&(bt.ambientLightColor.value=V.state.ambient,bt.lightProbe.value=V.state.probe,bt.sunLights.value=V.state.sun,bt.sunLightShadows.value=V.state.sunShadow,bt.directionalLights.value=V.state.directional,bt.directionalLightShadows.value=V.state.directionalShadow,bt.spotLights.value=V.state.spot,bt.spotLightShadows.value=V.state.spotShadow,bt.rectAreaLights.value=V.state.rectArea,bt.ltc_1.value=V.state.rectAreaLTC1,bt.ltc_2.value=V.state.rectAreaLTC2,bt.pointLights.value=V.state.point,bt.pointLightShadows.value=V.state.pointShadow,bt.hemisphereLights.value=V.state.hemi,bt.sunShadowMatrix.value=V.state.sunShadowMatrix,bt.sunShadowCascade.value=V.state.sunShadowCascade,bt.directionalShadowMatrix.value=V.state.directionalShadowMatrix,bt.spotLightMatrix.value=V.state.spotLightMatrix,bt.spotLightMap.value=V.state.spotLightMap,bt.pointShadowMatrix.value=V.state.pointShadowMatrix),B.numLightProbeGrids=$u(S.state.lightProbeGridArray),B.currentProgram=Xt,B.uniformsList=null,Xt}function zg(b,N,H,B,V){let ft=Rt.get(b),Mt=ft.currentProgram.id+","+B+","+V,ut=ft.programVariants.get(Mt);return ut===void 0?(ut=tr(b,N,H),ft.programVariants.set(Mt,ut)):(ft.currentProgram=ut,ft.uniformsList=null,ft.outputColorSpace=B,ft.toneMapping=V),ut}function Yu(b){if(b.uniformsList===null){let N=b.currentProgram.getUniforms();b.uniformsList=Zs.seqWithValue(N.seq,b.uniforms)}return b.uniformsList}function Ku(b,N){let H=Rt.get(b);H.outputColorSpace=N.outputColorSpace,H.batching=N.batching,H.batchingColor=N.batchingColor,H.instancing=N.instancing,H.instancingColor=N.instancingColor,H.instancingMorph=N.instancingMorph,H.skinning=N.skinning,H.morphTargets=N.morphTargets,H.morphNormals=N.morphNormals,H.morphColors=N.morphColors,H.morphTargetsCount=N.morphTargetsCount,H.numClippingPlanes=N.numClippingPlanes,H.numIntersection=N.numClipIntersection,H.vertexAlphas=N.vertexAlphas,H.vertexTangents=N.vertexTangents,H.toneMapping=N.toneMapping}function Gg(b,N,H,B,V){N.isScene!==!0&&(N=$e),Lt.resetTextureUnits();let ft=N.fog,Mt=B.isMeshStandardMaterial||B.isMeshLambertMaterial||B.isMeshPhongMaterial?N.environment:null,ut=tt===null?T.outputColorSpace:tt.isXRRenderTarget===!0?tt.texture.colorSpace:Wt.workingColorSpace,xt=B.isMeshStandardMaterial||B.isMeshLambertMaterial&&!B.envMap||B.isMeshPhongMaterial&&!B.envMap,At=C.get(B.envMap||Mt,xt),kt=B.vertexColors===!0&&!!H.attributes.color&&H.attributes.color.itemSize===4,Xt=!!H.attributes.tangent&&(!!B.normalMap||B.anisotropy>0),bt=!!H.morphAttributes.position,qt=!!H.morphAttributes.normal,Ae=!!H.morphAttributes.color,ce=$n;B.toneMapped&&(tt===null||tt.isXRRenderTarget===!0)&&(ce=T.toneMapping);let re=H.morphAttributes.position||H.morphAttributes.normal||H.morphAttributes.color,ze=re!==void 0?re.length:0,wt=Rt.get(B),Ke=S.state.lights;if(_e===!0&&(Fe===!0||b!==Q)){let xe=b===Q&&B.id===q;Z.setState(B,b,xe)}let te=!1,Bi=!1;B.version===wt.__version?wt.needsLights&&wt.lightsStateVersion!==Ke.state.version||V.isBatchedMesh&&wt.batching===!1||!V.isBatchedMesh&&wt.batching===!0||V.isBatchedMesh&&wt.batchingColor===!0&&V._colorsTexture===null||V.isBatchedMesh&&wt.batchingColor===!1&&V._colorsTexture!==null||V.isInstancedMesh&&wt.instancing===!1||!V.isInstancedMesh&&wt.instancing===!0||V.isSkinnedMesh&&wt.skinning===!1||!V.isSkinnedMesh&&wt.skinning===!0||V.isInstancedMesh&&wt.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&wt.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&wt.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&wt.instancingMorph===!1&&V.morphTexture!==null||wt.envMap!==At||B.fog===!0&&wt.fog!==ft||wt.numClippingPlanes!==void 0&&(wt.numClippingPlanes!==Z.numPlanes||wt.numIntersection!==Z.numIntersection)||wt.vertexAlphas!==kt||wt.vertexTangents!==Xt||wt.morphTargets!==bt||wt.morphNormals!==qt||wt.morphColors!==Ae||wt.morphTargetsCount!==ze||wt.numLightProbeGrids!==$u(S.state.lightProbeGridArray)?te=!0:(wt.outputColorSpace!==ut||wt.toneMapping!==ce)&&(Bi=!0):(te=!0,wt.__version=B.version);let Ge=wt.currentProgram;(te===!0||Bi===!0)&&(Ge=Bi===!0?zg(B,N,V,ut,ce):tr(B,N,V),D&&B.isNodeMaterial&&D.onUpdateProgram(B,Ge,wt));let jr=!1,gi=!1,zi=!1,Zt=Ge.getUniforms(),ke=wt.uniforms;if(rt.useProgram(Ge.program)&&(jr=!0,gi=!0,zi=!0),B.id!==q&&(q=B.id,gi=!0),jr||Q!==b){rt.buffers.depth.getReversed()&&b.reversedDepth!==!0&&(b._reversedDepth=!0,b.updateProjectionMatrix()),Zt.setValue(O,"projectionMatrix",b.projectionMatrix),Zt.setValue(O,"viewMatrix",b.matrixWorldInverse);let Le=Zt.map.cameraPosition;Le!==void 0&&Le.setValue(O,dn.setFromMatrixPosition(b.matrixWorld)),Qt.logarithmicDepthBuffer&&Zt.setValue(O,"logDepthBufFC",2/(Math.log(b.far+1)/Math.LN2)),(B.isMeshPhongMaterial||B.isMeshToonMaterial||B.isMeshLambertMaterial||B.isMeshBasicMaterial||B.isMeshStandardMaterial||B.isShaderMaterial)&&Zt.setValue(O,"isOrthographic",b.isOrthographicCamera===!0),Q!==b&&(Q=b,gi=!0,zi=!0)}if(wt.needsLights&&(Ke.state.sunShadowMap.length>0&&Zt.setValue(O,"sunShadowMap",Ke.state.sunShadowMap,Lt),Ke.state.directionalShadowMap.length>0&&Zt.setValue(O,"directionalShadowMap",Ke.state.directionalShadowMap,Lt),Ke.state.spotShadowMap.length>0&&Zt.setValue(O,"spotShadowMap",Ke.state.spotShadowMap,Lt),Ke.state.pointShadowMap.length>0&&Zt.setValue(O,"pointShadowMap",Ke.state.pointShadowMap,Lt)),V.isSkinnedMesh){Zt.setOptional(O,V,"bindMatrix"),Zt.setOptional(O,V,"bindMatrixInverse");let xe=V.skeleton;xe&&(xe.boneTexture===null&&xe.computeBoneTexture(),Zt.setValue(O,"boneTexture",xe.boneTexture,Lt))}V.isBatchedMesh&&(Zt.setOptional(O,V,"batchingTexture"),Zt.setValue(O,"batchingTexture",V._matricesTexture,Lt),Zt.setOptional(O,V,"batchingIdTexture"),Zt.setValue(O,"batchingIdTexture",V._indirectTexture,Lt),Zt.setOptional(O,V,"batchingColorTexture"),V._colorsTexture!==null&&Zt.setValue(O,"batchingColorTexture",V._colorsTexture,Lt));let bn=H.morphAttributes;if((bn.position!==void 0||bn.normal!==void 0||bn.color!==void 0)&&J.update(V,H,Ge),(gi||wt.receiveShadow!==V.receiveShadow)&&(wt.receiveShadow=V.receiveShadow,Zt.setValue(O,"receiveShadow",V.receiveShadow)),(B.isMeshStandardMaterial||B.isMeshLambertMaterial||B.isMeshPhongMaterial)&&B.envMap===null&&N.environment!==null&&(ke.envMapIntensity.value=N.environmentIntensity),ke.dfgLUT!==void 0&&(ke.dfgLUT.value=aE()),gi){if(Zt.setValue(O,"toneMappingExposure",T.toneMappingExposure),wt.needsLights&&Vg(ke,zi),ft&&B.fog===!0&&ot.refreshFogUniforms(ke,ft),ot.refreshMaterialUniforms(ke,B,ht,St,S.state.transmissionRenderTarget[b.id]),wt.needsLights&&wt.numLightProbeGrids>0){let xe=y,Le=0;for(let Jn of S.state.lightProbeGridArray)Jn.texture!==null&&(xe.textures[Le]=Jn.texture,xe.min[Le]=Jn.boundingBox.min,xe.max[Le]=Jn.boundingBox.max,xe.resolution[Le]=Jn.resolution,Le++);for(let Jn in xe)xe[Jn].length=Le;ke.probesSH.value=xe.textures,ke.probesMin.value=xe.min,ke.probesMax.value=xe.max,ke.probesResolution.value=xe.resolution}Zs.upload(O,Yu(wt),ke,Lt)}if(B.isShaderMaterial&&B.uniformsNeedUpdate===!0&&(Zs.upload(O,Yu(wt),ke,Lt),B.uniformsNeedUpdate=!1),B.isSpriteMaterial&&Zt.setValue(O,"center",V.center),Zt.setValue(O,"modelViewMatrix",V.modelViewMatrix),Zt.setValue(O,"normalMatrix",V.normalMatrix),Zt.setValue(O,"modelMatrix",V.matrixWorld),B.uniformsGroups!==void 0){let xe=B.uniformsGroups;for(let Le=0,Jn=xe.length;Le<Jn;Le++){let Ju=xe[Le];Tt.update(Ju,Ge),Tt.bind(Ju,Ge)}}return Ge}function Vg(b,N){b.ambientLightColor.needsUpdate=N,b.lightProbe.needsUpdate=N,b.sunLights.needsUpdate=N,b.sunLightShadows.needsUpdate=N,b.directionalLights.needsUpdate=N,b.directionalLightShadows.needsUpdate=N,b.pointLights.needsUpdate=N,b.pointLightShadows.needsUpdate=N,b.spotLights.needsUpdate=N,b.spotLightShadows.needsUpdate=N,b.rectAreaLights.needsUpdate=N,b.hemisphereLights.needsUpdate=N}function Hg(b){return b.isMeshLambertMaterial||b.isMeshToonMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isShadowMaterial||b.isShaderMaterial&&b.lights===!0}this.getActiveCubeFace=function(){return W},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return tt},this.setRenderTargetTextures=function(b,N,H){let B=Rt.get(b);B.__autoAllocateDepthBuffer=b.resolveDepthBuffer===!1,B.__autoAllocateDepthBuffer===!1&&(B.__useRenderToTexture=!1),Rt.get(b.texture).__webglTexture=N,Rt.get(b.depthTexture).__webglTexture=B.__autoAllocateDepthBuffer?void 0:H,B.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(b,N){let H=Rt.get(b);H.__webglFramebuffer=N,H.__useDefaultFramebuffer=N===void 0},this.setRenderTarget=function(b,N=0,H=0){tt=b,W=N,z=H;let B=null,V=!1,ft=!1;if(b){let ut=Rt.get(b);if(ut.__useDefaultFramebuffer!==void 0){rt.bindFramebuffer(O.FRAMEBUFFER,ut.__webglFramebuffer),et.copy(b.viewport),_t.copy(b.scissor),Dt=b.scissorTest,rt.viewport(et),rt.scissor(_t),rt.setScissorTest(Dt),q=-1;return}else if(ut.__webglFramebuffer===void 0)Lt.setupRenderTarget(b);else if(ut.__hasExternalTextures)Lt.rebindTextures(b,Rt.get(b.texture).__webglTexture,Rt.get(b.depthTexture).__webglTexture);else if(b.depthBuffer){let kt=b.depthTexture;if(ut.__boundDepthTexture!==kt){if(kt!==null&&Rt.has(kt)&&(b.width!==kt.image.width||b.height!==kt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Lt.setupDepthRenderbuffer(b)}}let xt=b.texture;(xt.isData3DTexture||xt.isDataArrayTexture||xt.isCompressedArrayTexture)&&(ft=!0);let At=Rt.get(b).__webglFramebuffer;b.isWebGLCubeRenderTarget?(Array.isArray(At[N])?B=At[N][H]:B=At[N],V=!0):b.samples>0&&Lt.useMultisampledRTT(b)===!1?B=Rt.get(b).__webglMultisampledFramebuffer:Array.isArray(At)?B=At[H]:B=At,et.copy(b.viewport),_t.copy(b.scissor),Dt=b.scissorTest}else et.copy(Ct).multiplyScalar(ht).floor(),_t.copy($t).multiplyScalar(ht).floor(),Dt=Kt;if(H!==0&&(B=F),rt.bindFramebuffer(O.FRAMEBUFFER,B)&&rt.drawBuffers(b,B),rt.viewport(et),rt.scissor(_t),rt.setScissorTest(Dt),V){let ut=Rt.get(b.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+N,ut.__webglTexture,H)}else if(ft){let ut=N;for(let xt=0;xt<b.textures.length;xt++){let At=Rt.get(b.textures[xt]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+xt,At.__webglTexture,H,ut)}}else if(b!==null&&H!==0){let ut=Rt.get(b.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ut.__webglTexture,H)}q=-1};function Zu(b){let N=Rt.get(b);return(N.__readFormat!==b.format||N.__readType!==b.type)&&(N.__readFormat=b.format,N.__readType=b.type,N.__formatReadable=Qt.textureFormatReadable(b.format),N.__typeReadable=Qt.textureTypeReadable(b.type)),N}this.readRenderTargetPixels=function(b,N,H,B,V,ft,Mt,ut=0){if(!(b&&b.isWebGLRenderTarget)){Ft("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let xt=Rt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&Mt!==void 0&&(xt=xt[Mt],Array.isArray(xt)&&(xt=xt[0])),xt){rt.bindFramebuffer(O.FRAMEBUFFER,xt);try{let At=b.textures[ut],kt=At.format,Xt=At.type;b.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ut);let bt=Zu(At);if(bt.__formatReadable===!1){Ft("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(bt.__typeReadable===!1){Ft("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}N>=0&&N<=b.width-B&&H>=0&&H<=b.height-V&&O.readPixels(N,H,B,V,st.convert(kt),st.convert(Xt),ft)}finally{let At=tt!==null?Rt.get(tt).__webglFramebuffer:null;rt.bindFramebuffer(O.FRAMEBUFFER,At)}}},this.readRenderTargetPixelsAsync=async function(b,N,H,B,V,ft,Mt,ut=0){if(!(b&&b.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let xt=Rt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&Mt!==void 0&&(xt=xt[Mt],Array.isArray(xt)&&(xt=xt[0])),xt)if(N>=0&&N<=b.width-B&&H>=0&&H<=b.height-V){rt.bindFramebuffer(O.FRAMEBUFFER,xt);let At=b.textures[ut],kt=At.format,Xt=At.type;b.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ut);let bt=Zu(At);if(bt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(bt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let qt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,qt),O.bufferData(O.PIXEL_PACK_BUFFER,ft.byteLength,O.STREAM_READ),O.readPixels(N,H,B,V,st.convert(kt),st.convert(Xt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let Ae=tt!==null?Rt.get(tt).__webglFramebuffer:null;rt.bindFramebuffer(O.FRAMEBUFFER,Ae);let ce=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await _m(O,ce,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,qt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,ft),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(qt),O.deleteSync(ce),ft}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(b,N=null,H=0){let B=Math.pow(2,-H),V=Math.floor(b.image.width*B),ft=Math.floor(b.image.height*B),Mt=N!==null?N.x:0,ut=N!==null?N.y:0;Lt.setTexture2D(b,0),O.copyTexSubImage2D(O.TEXTURE_2D,H,0,0,Mt,ut,V,ft),rt.unbindTexture()},this.copyTextureToTexture=function(b,N,H=null,B=null,V=0,ft=0){let Mt,ut,xt,At,kt,Xt,bt,qt,Ae,ce=b.isCompressedTexture?b.mipmaps[ft]:b.image;if(H!==null)Mt=H.max.x-H.min.x,ut=H.max.y-H.min.y,xt=H.isBox3?H.max.z-H.min.z:1,At=H.min.x,kt=H.min.y,Xt=H.isBox3?H.min.z:0;else{let Zt=Math.pow(2,-V);Mt=Math.floor(ce.width*Zt),ut=Math.floor(ce.height*Zt),b.isDataArrayTexture?xt=ce.depth:b.isData3DTexture?xt=Math.floor(ce.depth*Zt):xt=1,At=0,kt=0,Xt=0}B!==null?(bt=B.x,qt=B.y,Ae=B.z):(bt=0,qt=0,Ae=0);let re=st.convert(N.format),ze=st.convert(N.type),wt;N.isData3DTexture?(Lt.setTexture3D(N,0),wt=O.TEXTURE_3D):N.isDataArrayTexture||N.isCompressedArrayTexture?(Lt.setTexture2DArray(N,0),wt=O.TEXTURE_2D_ARRAY):(Lt.setTexture2D(N,0),wt=O.TEXTURE_2D),rt.activeTexture(O.TEXTURE0),rt.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,N.flipY),rt.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,N.premultiplyAlpha),rt.pixelStorei(O.UNPACK_ALIGNMENT,N.unpackAlignment);let Ke=rt.getParameter(O.UNPACK_ROW_LENGTH),te=rt.getParameter(O.UNPACK_IMAGE_HEIGHT),Bi=rt.getParameter(O.UNPACK_SKIP_PIXELS),Ge=rt.getParameter(O.UNPACK_SKIP_ROWS),jr=rt.getParameter(O.UNPACK_SKIP_IMAGES);rt.pixelStorei(O.UNPACK_ROW_LENGTH,ce.width),rt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,ce.height),rt.pixelStorei(O.UNPACK_SKIP_PIXELS,At),rt.pixelStorei(O.UNPACK_SKIP_ROWS,kt),rt.pixelStorei(O.UNPACK_SKIP_IMAGES,Xt);let gi=b.isDataArrayTexture||b.isData3DTexture,zi=N.isDataArrayTexture||N.isData3DTexture;if(b.isDepthTexture){let Zt=Rt.get(b),ke=Rt.get(N),bn=Rt.get(Zt.__renderTarget),xe=Rt.get(ke.__renderTarget);rt.bindFramebuffer(O.READ_FRAMEBUFFER,bn.__webglFramebuffer),rt.bindFramebuffer(O.DRAW_FRAMEBUFFER,xe.__webglFramebuffer);for(let Le=0;Le<xt;Le++)gi&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Rt.get(b).__webglTexture,V,Xt+Le),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Rt.get(N).__webglTexture,ft,Ae+Le)),O.blitFramebuffer(At,kt,At+Mt,kt+ut,bt,qt,bt+Mt,qt+ut,O.DEPTH_BUFFER_BIT,O.NEAREST);rt.bindFramebuffer(O.READ_FRAMEBUFFER,null),rt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(V!==0||b.isRenderTargetTexture||Rt.has(b)){let Zt=Rt.get(b),ke=Rt.get(N);rt.bindFramebuffer(O.READ_FRAMEBUFFER,R),rt.bindFramebuffer(O.DRAW_FRAMEBUFFER,k);for(let bn=0;bn<xt;bn++)gi?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Zt.__webglTexture,V,Xt+bn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Zt.__webglTexture,V),zi?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ke.__webglTexture,ft,Ae+bn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ke.__webglTexture,ft),V!==0?O.blitFramebuffer(At,kt,At+Mt,kt+ut,bt,qt,bt+Mt,qt+ut,O.COLOR_BUFFER_BIT,O.NEAREST):zi?O.copyTexSubImage3D(wt,ft,bt,qt,Ae+bn,At,kt,Mt,ut):O.copyTexSubImage2D(wt,ft,bt,qt,At,kt,Mt,ut);rt.bindFramebuffer(O.READ_FRAMEBUFFER,null),rt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else zi?b.isDataTexture||b.isData3DTexture?O.texSubImage3D(wt,ft,bt,qt,Ae,Mt,ut,xt,re,ze,ce.data):N.isCompressedArrayTexture?O.compressedTexSubImage3D(wt,ft,bt,qt,Ae,Mt,ut,xt,re,ce.data):O.texSubImage3D(wt,ft,bt,qt,Ae,Mt,ut,xt,re,ze,ce):b.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,ft,bt,qt,Mt,ut,re,ze,ce.data):b.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,ft,bt,qt,ce.width,ce.height,re,ce.data):O.texSubImage2D(O.TEXTURE_2D,ft,bt,qt,Mt,ut,re,ze,ce);rt.pixelStorei(O.UNPACK_ROW_LENGTH,Ke),rt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,te),rt.pixelStorei(O.UNPACK_SKIP_PIXELS,Bi),rt.pixelStorei(O.UNPACK_SKIP_ROWS,Ge),rt.pixelStorei(O.UNPACK_SKIP_IMAGES,jr),ft===0&&N.generateMipmaps===!0&&N.mipmapsAutoUpdate===!0&&O.generateMipmap(wt),rt.unbindTexture()},this.initRenderTarget=function(b){Rt.get(b).__webglFramebuffer===void 0&&Lt.setupRenderTarget(b)},this.initTexture=function(b){b.isCubeTexture?Lt.setTextureCube(b,0):b.isData3DTexture?Lt.setTexture3D(b,0):b.isDataArrayTexture||b.isCompressedArrayTexture?Lt.setTexture2DArray(b,0):Lt.setTexture2D(b,0),rt.unbindTexture()},this.resetState=function(){W=0,z=0,tt=null,rt.reset(),at.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return gn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Wt._getDrawingBufferColorSpace(t),e.unpackColorSpace=Wt._getUnpackColorSpace()}};Wt.enabled=!1;var cE=2040100,hE=`
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
  }`,uE=`
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
  }`,dE=/swiftshader|llvmpipe|softpipe|software|basic render/i;function rg(n,t){let e={antialias:!1,powerPreference:"high-performance",failIfMajorPerformanceCaveat:!t},i=n.getContext("webgl2",e);return!i||t||!dE.test(fE(i))?i:(i.getExtension("WEBGL_lose_context")?.loseContext(),null)}function fE(n){let t=n.getParameter(n.RENDERER),e=t==="WebKit WebGL"&&n.getExtension("WEBGL_debug_renderer_info");return e?n.getParameter(e.UNMASKED_RENDERER_WEBGL):t}var Wl=class{constructor(t,e,i){this.canvas=t,this.surface=e,this.renderer=new Gl({canvas:t,context:i}),this.renderer.setClearColor(cE),this.renderer.outputColorSpace=Zi,this.renderer.autoClear=!1,this.camera=new Je,this.size={width:1,height:1},this.tints=pE(e.tints),this.skinTexture=e.texturing&&mE(e.texturing),this.known=new Map}resize(t,e,i){this.renderer.setPixelRatio(i),this.renderer.setSize(t,e,!1),this.size={width:t,height:e}}draw(t,e,i){let{renderer:s,camera:r,size:o}=this;s.setScissorTest(!0),r.fov=e.fieldDegrees,r.near=Math.max(e.distance-6*e.size,.01*e.distance),r.far=e.distance+60*e.size,r.position.fromArray(e.position),r.up.fromArray(e.above),r.lookAt(new X().fromArray(e.target)),r.updateMatrixWorld();let a=Math.max(...t.map(({width:c,height:h})=>c/h)),l=new Map([...new Set(t.map(i))].filter(Boolean).map(c=>[c,this.sent(c,e,a)]));this.forget(l);for(let c of t){let h=l.get(i(c)),u=o.height-c.top-c.height;s.setViewport(c.left,u,c.width,c.height),s.setScissor(c.left,u,c.width,c.height),r.aspect=c.width/c.height,r.updateProjectionMatrix(),s.clear(),h&&s.render(h.scene,r)}}sent(t,e,i){this.known.has(t)||this.known.set(t,gE(t,this.surface,this.tints,this.skinTexture));let s=this.known.get(t),{attributes:r,index:o}=s.geometry,{triangles:a,facing:l,texturing:c}=this.surface,h=(d,f)=>{hh(f,d.itemSize,c?.doubles??[],d.array),d.needsUpdate=!0};s.seen.shape!==t.changes.shape&&(h(r.position,t.points),h(r.normal,t.normals)),s.seen.paint!==t.changes.paint&&h(r.paint,t.paint),s.seen={...t.changes};let u=up(t.points,a,l,e,i,o.array,c?.corners);return o.clearUpdateRanges(),o.addUpdateRange(0,u),o.needsUpdate=!0,s.geometry.setDrawRange(0,u),s}forget(t){for(let[e,{geometry:i,material:s}]of this.known)t.has(e)||(i.dispose(),s.dispose(),this.known.delete(e))}};function pE({factors:n,perRadius:t,last:e}){let i=Uint8Array.from({length:4*(e+1)},(r,o)=>Math.round(255*Math.min(1,n[3*(o>>2)+(o&3)]??1))),s=new ji(i,e+1,1);return s.magFilter=Oe,s.needsUpdate=!0,{texture:s,perRadius:t/(e+1)}}function mE({texels:n,width:t,height:e}){let i=new ji(new Uint8Array(n.buffer),t,e);return Object.assign(i,{magFilter:Oe,minFilter:Pn,generateMipmaps:!0,needsUpdate:!0}),i}function gE(n,{triangles:t,gaze:e,texturing:i},s,r){let o=(f,p)=>i?.doubles.length?hh(f,p,i.doubles):f,a=new qn,l=(f,p,x=!1)=>new je(f,p,x).setUsage(fu);a.setIndex(l(new Uint32Array(t.length),1));let c={position:l(o(n.points,3),3),normal:l(o(n.normals,3),3),paint:l(o(n.paint,4),4,!0),own:new je(o(n.colours,3),3),gaze:new je(o(e,2),2),...i&&{place:new je(i.places,2)}};for(let[f,p]of Object.entries(c))a.setAttribute(f,p);let h=new _n({vertexShader:hE,fragmentShader:uE,side:Mn,defines:i?{TEXTURED:1}:{},uniforms:{tints:{value:s.texture},perRadius:{value:s.perRadius},skin:{value:r}}}),u=new yn(a,h);u.frustumCulled=!1;let d=new Ar;return d.matrixWorldAutoUpdate=!1,d.add(u),{scene:d,geometry:a,material:h,seen:{...n.changes}}}var xE=[.8,.95,1.08],Xl=class{drawer;constructor(t,e,i=null){this.node=U("div",{class:"skin"}),this.onlost=null,this.triangles=Ho(t),this.welded=lp(t,this.triangles),this.facing=hp(e,this.triangles);let{colours:s,gaze:r}=ap(t);this.gaze=r,this.eyes=Of(this.triangles,r),this.tints=Df(t.eye),this.texturing=op(t),this.skin=og(e,s),this.target=null,this.size=[1,1,1],this.open(i)}open(t){let e=U("canvas"),i=t==="canvas"?null:rg(e,t==="webgl");this.drawer=i?new Wl(e,this,i):new wi(U("canvas"),this),this.drawnBy=i?"graphics card":"processor",i&&e.addEventListener("webglcontextlost",()=>this.loseCard()),this.node.replaceChildren(this.drawer.canvas)}loseCard(){this.open("canvas"),this.resize(...this.size),this.onlost?.()}refresh(t=this.skin){Wo(t.points,this.triangles,this.welded,t.normals),t.changes.shape++}paint(t){let{paint:e,changes:i}=this.skin;if(!(!t&&!this.heated)){this.heated=t!==null;for(let s=0,r=0;r<e.length;s++,r+=4)e[r]=t?t[s]:0;i.paint++}}withPoints(t){let e=this.skin.points.slice();return e.set(t),e}setTarget(t){this.target=t&&og(this.withPoints(t),this.skin.colours.map((e,i)=>Math.min(1,e*xE[i%3]))),this.target&&this.refresh(this.target)}resize(t,e,i){this.size=[t,e,i],this.drawer.resize(t,e,i)}draw(t,e){this.drawer.draw(t,e,({kind:i})=>i==="target"?this.target:this.skin)}};function og(n,t){return{points:n,normals:new Float32Array(n.length),paint:new Uint8Array(4*n.length/3),colours:t,changes:{shape:0,paint:0}}}var vE=45,ag=180,yE=7e5,lg=2,_E=15e4,ql=class{ratio;closeness;constructor(t,e,i){this.say=i,this.session=t;let s=U("canvas",{class:"marks"});this.tip=U("div",{class:"tip",hidden:!0}),this.sides=[U("div",{class:"side-tag",style:{left:"14px"}}),U("div",{class:"side-tag"})],this.captions=U("div",{class:"captions"}),this.surface=U("div",{class:"surface",tabIndex:0,role:"application","aria-label":"Face: drag handles or skin"}),this.cast=new Fo(t,e),this.stage=new Xl(this.cast.character,this.cast.points,ME()),this.stage.onlost=()=>this.changed("camera"),this.onion=new Xo(this),this.node=U("div",{class:"view"},this.stage.node,this.onion.node,s,this.surface,this.captions,...this.sides,this.tip),this.overlay=new Ko(s,t),this.camera=new zn(t.character.up,t.section.view),this.picker=new Jo(t.deformer.points,Ho(t.character)),this.rearranging=new jo(this),this.gestures=new Go(this),this.kinds=null,this.closeLook=null,this.showsInfluence=!1,this.bare=!1,this.onInfluences=null,this.review=null,this.trails=null,this.shotLook=null,this.columns=[],this.stale=new Set(["pose","camera","overlay"]),this.fineness=1,this.drawn=0,this.listen(),new ResizeObserver(()=>this.resize()).observe(this.node)}beginDrag(t){let{session:e}=this,[i,s]=this.overlay.draggable(t,this.camera.projector(this.controlsColumn));return Xf(i,e.controls,e.rest,e.values,s)}listen(){let{session:t}=this;t.on("pose",()=>this.changed("pose"));for(let e of["selection","hover","dragging"])t.on(e,()=>this.changed("overlay"));for(let e of["options","layout"])t.on(e,()=>this.arrange());t.on("time",()=>t.options.shot&&this.changed("camera")),t.on("section",()=>{let{up:e}=t.character;this.camera=new zn(e,t.section.view),this.overlay.dock.front=new zn(e,t.section.view),t.emit("selection"),t.emit("options"),this.home()});for(let e of["hover","selection","options","dragging"])t.on(e,()=>this.repaint=!0)}changed(t){this.stale.add(t),this.request()}request(){this.scheduled??=requestAnimationFrame(t=>{this.scheduled=null,this.frame(t)})}resize(){let{clientWidth:t,clientHeight:e}=this.node;if(!t||!e)return;let i=!this.columns.length;this.width=t,this.height=e,this.ratio=Math.min(2,window.devicePixelRatio||1),this.stage.resize(this.width,this.height,this.ratio*this.fineness),this.overlay.resize(this.width,this.height,this.ratio),this.arrange(),i&&this.home()}arrange(){if(!this.width)return;let{arrangement:t,handles:e}=this.session.options,{dock:i}=this.overlay,s=this.kinds??(t==="beside"&&e?["controls","clean"]:["controls"]),r=s.includes("controls")?i.place(this.width,this.height):null;i.arrange(r);let[o,a]=r&&r.width<this.width?[r.left,this.height]:[this.width,r?r.top:this.height],[l,c]=this.roomOf?.()??[1/0,1/0],h=Math.floor(Math.min(l,o/s.length)),u=Math.min(a,c),d=Math.floor((o-h*s.length)/2),f={controls:"Controls",clean:"Clean face",target:"Target"};this.columns=s.map((p,x)=>({kind:p,left:d+x*h,top:0,width:h,height:u})),this.controlsColumn=this.columns.find(p=>p.kind==="controls")??null,this.captions.replaceChildren(...(s.length>1?s:[]).map((p,x)=>U("span",{style:{left:`${d+x*h}px`,width:`${h}px`}},this.captionOf?.(p)??f[p]))),this.sides.forEach(p=>p.style.bottom=`${this.height-a+12}px`),this.sides[1].style.right=`${this.width-o+14}px`,this.picker.invalidate(),this.changed("camera")}setColumns(t,e=null,i=null){this.kinds=t,this.roomOf=i,this.captionOf=e,this.arrange(),this.home()}commonRoom(t){let e=this.node.parentElement?.clientWidth??this.width,i=this.overlay.dock.place(e,this.height),s=i&&i.width<e;return[Math.min((s?i.left:e)/3,(e-t)/2),i&&!s?i.top:this.height]}faceHeight(t){let e=this.columns.find(s=>s.kind===t);if(!e)return 0;let i=this.session.section.frame.map(s=>this.camera.projector(e)(s)[1]);return Math.max(...i)-Math.min(...i)}home(t=0,e=0){this.camera.turn(t,e);let i=this.columns[0]??{width:1,height:1};this.camera.frame(this.session.section.frame,i.width,i.height),this.closeness=this.camera.distance,this.changed("camera")}shownElements(){return this.session.elements.list.filter(t=>this.session.isShown(t))}lookAs({target:t,towards:e,distance:i,aspect:s}){let{width:r,height:o}=this.controlsColumn??this.columns[0];this.camera.lookFrom([...t],e,i*Math.max(1,s*o/r)),this.changed("camera")}frameClosely(){let{session:t,camera:e}=this,i=()=>JSON.stringify([e.target,e.towards,e.distance,[...t.selection]]);if(this.closeLook?.where===i()){let{target:d,towards:f,distance:p}=this.closeLook.before;e.lookFrom(d,f,p),this.closeLook=null,this.changed("camera");return}let{target:s,towards:r,distance:o}=e,a=this.shownElements().filter(d=>!d.onBoard),l=t.selectedElements.filter(d=>!d.onBoard),c=l.length?l:a,h=this.columns[0],u=c.flatMap(d=>d.tracks.flat());e.frame(u,h.width,h.height,l.length?3:1.2),this.closeLook={where:i(),before:{target:s,towards:r,distance:o}},this.changed("camera")}locate(t){let e=this.surface.getBoundingClientRect(),i={x:t.clientX-e.left,y:t.clientY-e.top};return{...i,column:this.overlay.dock.contains(i)?null:this.columns.find(s=>oo(s,i))??null}}controlsAt(t){return this.overlay.dock.contains(t)||t.column!==null&&t.column===this.controlsColumn}elementAt(t,e=0){return this.controlsAt(t)?this.overlay.elementAt(t.x,t.y,e):null}dive(t){let{camera:e}=this;return e.distance<.7*this.closeness?this.home(e.azimuth,e.elevation):(e.target=this.session.shown(t),e.zoom(.4),this.changed("camera"))}pick({x:t,y:e,column:i}){return i?this.picker.pick(this.camera,i,t,e):null}freshen(){this.gestures.flush(),this.stale.size&&this.drawNow()}frame(t){this.gestures.flush(),this.pace(t),(this.stale.size||this.repaint)&&this.drawNow()}lookThroughShot(){let{camera:t,session:e}=this,{shotCamera:i,timeCodes:s}=e.character,r=()=>[t.half,t.distance,...t.target,...t.towards].join();if(!e.options.shot)this.shotLook=null;else if(this.shotLook&&this.shotLook!==r())e.setOption("shot",!1);else{let o=Math.round(e.frame-(s?.[0]??e.frame));t.lookThrough(i[Vt(o,0,i.length-1)],this.columns[0]),this.shotLook=r()}}drawNow(){let{stale:t}=this;t.has("camera")&&this.lookThroughShot(),this.repaint&&this.paint(),t.has("pose")&&(this.cast.follow(),this.stage.refresh()),(t.has("pose")||t.has("camera"))&&this.picker.invalidate();let e=t.has("pose")||t.has("camera")||this.repaint;this.repaint=!1;let i=t.has("camera");t.clear(),e&&(this.stage.draw(this.columns,this.camera),this.drawn++),this.arrangeOverlay(i),this.overlay.draw(this.review?.lines(),this.trails?.shown()),this.onion.follow(),this.placeTip(),this.nameSides()}arrangeOverlay(t){let e=this.controlsColumn;if(!e)return;let{session:i,camera:s,picker:r}=this,o=.8*i.elements.width,a=i.dragging!==null&&!t,c=i.options.occlusion==="overlay"?()=>!1:a?null:h=>r.hides(s,e,h,o);this.overlay.arrange(e,s,c)}pace(t){let e=this.stale.has("pose")||this.stale.has("camera")||this.repaint;e&&this.fineness>this.brisk&&this.setFineness(this.brisk),e&&this.lastFrame&&t-this.lastFrame<400?(this.average=.8*(this.average??0)+.2*(t-this.lastFrame),this.average>vE&&this.fineness>.5&&this.setFineness(this.fineness-.25)):this.average=0,this.lastFrame=e?t:null,clearTimeout(this.settling),this.fineness!==this.finest&&(this.settling=setTimeout(()=>this.sharpen(),ag))}get brisk(){if(this.stage.drawnBy!=="processor")return 1;let t=Math.sqrt(yE/(this.width*this.height));return Math.min(1,Math.floor(Gi*t)/Gi/this.ratio)}get finest(){return this.stage.drawnBy==="processor"&&this.ratio<lg&&this.stage.triangles.length<=3*_E?lg:1}sharpen(){this.gestures.active?this.settling=setTimeout(()=>this.sharpen(),ag):(this.setFineness(this.finest),this.drawNow())}setFineness(t){this.fineness=t,this.average=0,this.stage.resize(this.width,this.height,this.ratio*t),this.stale.add("camera")}paint(){let{session:t}=this,e=t.dragging!==null,i=this.showsInfluence?[...t.selectedElements,t.hover].filter(Boolean):t.hover&&!t.quiet?[t.hover]:[],s=this.pointedControl??i.flatMap(a=>a.members.map(({control:l})=>l)),r=Array.isArray(s)?s:[s],o=t.options.heat&&!e&&r.length;this.stage.paint(o?t.influence.ofControls(r):null)}hold(t,e){this[t]=e;for(let{style:i}of[this.overlay.canvas,this.tip])i.visibility=this.bare?"hidden":"";this.repaint=!0,this.request()}pointAt(t){this.pointedControl=t===null?null:[t],this.repaint=!0,this.request()}placeTip(){let{hover:t,dragging:e,controls:i}=this.session,s=e&&e!=="skin"?e:t,r=s&&this.overlay.drawn.find(u=>u.element===s);if(this.tip.hidden=!r||!this.session.options.handles,this.tip.hidden)return;let o=s.members.map(({control:u})=>U("div",{},U("b",{},this.session.worded(u)),` ${i[u].label}`)),a=U("div",{class:"tip-side",style:{borderColor:this.session.colours[s.side]}},js(s.side));this.tip.replaceChildren(...js(s.side)?[a]:[],...o);let[l,c]=r.handle,h=l+230>this.width;this.tip.style.transform=`translate(${Math.round(h?l-18:l+18)}px, ${Math.round(c-12)}px) translateX(${h?-100:0}%)`}nameSides(){let t=this.session.character.layout.planeNormal,e=Et(t,this.camera.right),i=Math.abs(e)<.25?[null,null]:e>0?["right","left"]:["left","right"];this.sides.forEach((s,r)=>{let o=i[r];s.hidden=!o||!this.session.options.handles,o&&(s.textContent=r===0?`◂ Character’s ${o}`:`Character’s ${o} ▸`,s.style.borderColor=this.session.colours[o])})}setCursor(t){this.surface.style.cursor=t}showInfluences(t){this.onInfluences?.(t)}};function ME(){let n=new URLSearchParams(window.location.hash.slice(1)).get("draw");return n==="webgl"||n==="canvas"?n:null}function js(n){return{left:"Character’s left",right:"Character’s right",middle:"Middle",none:""}[n]}var bE=12,$l=class{constructor(t,e,i,s){this.session=t,this.view=e,this.timeline=i,this.say=s,this.numbers=[],this.chosen=U("div",{class:"chosen"}),this.ranked=U("div",{class:"ranked"}),this.influences=rs("Acts here",this.ranked,!1),this.influences.hidden=!0,this.node=U("aside",{class:"inspector","aria-label":"Inspector"},rs("Selection",this.chosen),this.influences,rs("Display",this.display()),rs("Pulling the skin",this.pulling(),!1),rs("Pose",this.poses()),rs("Shelf",new Oo(t,e,s).node),this.layoutSection()),e.onInfluences=r=>this.showInfluences(r),t.on("selection",()=>{this.choosing||(this.influences.hidden=!0),this.showSelection()}),t.on("pose",()=>this.updateNumbers()),this.showSelection()}showSelection(){let{session:t}=this,e=t.selectedElements;if(this.numbers=[],!e.length){this.chosen.replaceChildren(be("Drag a handle, or pull the skin. Click the skin to see what acts there; shift-drag selects."));return}this.chosen.replaceChildren(...e.slice(0,8).map(i=>this.elementCard(i)),...e.length>8?[be(`and ${e.length-8} more`)]:[],tn(vt("Zero","Selected controls to their defaults (0)",()=>t.zero(t.chosenControls)),vt("Reset","Selected controls to the base pose (R)",()=>t.reset(t.chosenControls)),vt("Hide","Hide the selected elements",()=>t.hide(t.selectedElements)),vt("Key","Key the selected controls and all that changed, at this frame (K)",()=>this.timeline.key()))),this.updateNumbers()}elementCard(t){let e=[js(t.side),t.onBoard?ar(t):""].filter(Boolean).join(" · ");return U("div",{class:"card",style:{borderLeftColor:this.session.colours[t.side]}},U("div",{class:"card-title"},t.label),e?be(e):null,this.levelButton(t),...t.members.map(({control:i})=>this.numberRow(i)),t.reason?be(`${cs(t.reason)}.`):null)}levelButton(t){let e=this.session.levels.coarseOf(t);if(!e.length)return null;let[i,s]=t.inner.length?[`Open: ${t.inner.length} members`,"Show its members in its place (M)"]:[`Close ${e.map(r=>r.label).join(", ")}`,"Show it again in place of its members (M)"];return vt(i,s,()=>this.session.openOrClose([t]),{class:"level"})}numberRow(t){let{session:e}=this,i=e.controls[t],{minimum:s,maximum:r}=i,o=ro(e,t,{type:"number",step:(r-s)/100,min:s,max:r},"number");this.numbers.push({input:o,index:t});let a=`${e.worded(t,s)} … ${e.worded(t,r)}`;return U("label",{class:"number-row",title:`${i.name}: ${a}`},nr(i.label),o)}updateNumbers(){for(let{input:t,index:e}of this.numbers)document.activeElement!==t&&(t.value=this.session.worded(e))}showInfluences(t){let{session:e,view:i}=this,s=e.place(t),r=e.influence.rank(e.values,()=>e.traced(s));e.deformer.drive(e.values),this.influences.hidden=!1,this.influences.open=!0,this.ranked.replaceChildren(...r.length?[]:[be("No control moves this point.")],...r.slice(0,bE).map(({control:o,share:a})=>{let{label:l,name:c}=e.controls[o],h=e.elements.byControl.get(o),u=Math.round(100*a),d=p=>{this.choosing=!0,h&&e.select([h],p.shiftKey?"toggle":"replace"),this.choosing=!1},f=vt(nr(l),l,d,{class:"ranked-row","aria-label":l,"data-control":c,onpointerenter:()=>i.pointAt(o),onpointerleave:()=>i.pointAt(null)});return f.prepend(U("i",{style:{width:`${u}%`,background:e.colours[h?.side??"none"]}})),f.append(U("small",{},`${u} %`)),f})),this.influences.scrollIntoView({block:"nearest"})}option(t,e,i){let{session:s}=this,r=yi(i,e,()=>s.options[t],o=>s.setOption(t,o));return U("div",{class:"field"},U("span",{},i),s.updating(r))}check(t,e,i){let{session:s}=this,r=U("input",{type:"checkbox",onchange:()=>s.setOption(t,r.checked)});return r.update=()=>r.checked=s.options[t],U("label",{class:"check",title:i},s.updating(r),e)}slide(t,e,i,s,r){let{session:o}=this,a={min:s,max:r,step:(r-s)/100,"aria-label":e},l=so(a,()=>o.options[t],c=>o.setOption(t,c));return vi(e,o.updating(l),{title:i})}display(){let{session:t}=this,e=vt("Show hidden elements","",()=>t.showAll());return e.update=()=>e.hidden=!t.hidden.size,U("div",{},this.option("occlusion",[["overlay","Overlay","Draw everything on top"],["ghost","Ghost","Draw what the face covers faintly"],["hide","Depth","Do not draw what the face covers"]],"Covered"),this.option("labels",[["hover","Hover","Name the handle under the pointer"],["all","All","Name every handle (L)"]],"Labels"),this.slide("opacity","Opacity","How strongly handles and tracks are drawn",.1,1),this.check("fade","Fade the others while dragging"),this.check("heat","Show the area of influence","Heat map of the hovered or selected control"),this.check("onion","Onion skin","The keys before and after as outlines, amber and blue (O)"),this.check("trails","Motion trails","The ways of the selected handles on the face through the frames that play, a dot for each key (T)"),this.session.character.shotCamera&&this.check("shot","The shot's camera","Look as the camera of the stage does, frame by frame, until you turn, move or zoom (V)"),this.check("follow","Elements follow the skin","Off: they stay where they are at rest"),t.updating(e),t.updating(this.drawnBy()))}drawnBy(){let t=be("Drawn by the processor: this browser has no WebGL, or only one in software.");return t.update=()=>t.hidden=this.view.stage.drawnBy!=="processor",t}pulling(){let{session:t}=this,e=U("div",{class:"field"});return e.update=()=>{let i=vt("Remove all","",()=>{t.pins=[],t.emit("options")});e.replaceChildren(U("span",{},`Pins: ${t.pins.length}`),t.pins.length?i:"")},U("div",{},this.check("skinDrag","The skin can be pulled"),this.slide("locality","Locality","Controls that matter less than this at the grabbed point stay as they are",.01,.6),t.updating(e),be("Shift-click the skin to pin it; click a pin to take it out."))}poses(){let{session:t,say:e}=this;return tn(vt("Zero all","Every control to its default",()=>t.zero()),vt("Reset all","Every control to the pose of the layout",()=>t.reset()),vt("Copy","Keep the values of the selection, or of all controls",()=>t.copy()),vt("Paste","Give the controls the values that were kept",()=>t.paste()),vt("Flip","The pose seen in a mirror",()=>t.flip()),vt("Left to right","The pose of the character’s left on its right, too",()=>t.mirror("left")),vt("Right to left","The pose of the character’s right on its left, too",()=>t.mirror("right")),vt("Copy JSON","The pose to the clipboard",()=>this.copy()),vt("Save JSON","Download the pose",()=>t.save("pose.json",{text:Zc(t)})),vt("Save pose layer","Download the pose as a USD layer",()=>t.save("pose.usda",sf(t),e)),vt("Load…","A pose or layer saved before",()=>_i(".json,.usda,.usd",e,({text:i})=>this.load(i))))}async copy(){try{await navigator.clipboard.writeText(Zc(this.session)),this.say("Pose copied")}catch{this.say("The browser does not let this page write to the clipboard: use Save JSON")}}load(t){let{session:e}=this,{keys:i,constants:s}=t.startsWith("#usda")?af(t,e):{keys:new Map,constants:Lf(t,e)};i.size?e.load("Load keys",i,s):e.edit("Load pose",()=>e.set(s)),this.say("Pose loaded")}layoutSection(){let{session:t}=this,e=rs("Layout",this.layout(),!1),i=!1;return t.on("options",()=>{let{rearrange:s}=t.options;s&&!i&&(e.open=!0,e.scrollIntoView()),i=s}),e}layout(){let{session:t,view:e}=this,{layout:i}=t.character,s=be();s.update=()=>{let c=e.rearranging.moved.size;s.textContent=c?`${he(c,"element")} moved`:"Drag an element to another point of the face, or off it.",o.disabled=!c};let r=kn("Rearrange","Drag elements to other points of the face",()=>t.options.rearrange,()=>t.flipOption("rearrange")),o=vt("Save corrections","Download the changes for `usdrigui process --corrections`: they hold for every later version",()=>An(t.fileNamed("corrections.usda"),e.rearranging.corrections())),a=[`${i.elements.length} elements, ${t.controls.length} controls`,i.leftOff.length?`${i.leftOff.length} left off`:null].filter(Boolean),l=i.leftOff.map(([c,,h])=>U("li",{},U("b",{},c),` ${h}`));return U("div",{},tn(t.updating(r),o),t.updating(s),be(a.join(" · ")),l.length?U("details",{class:"left-off"},U("summary",{},"Left off"),U("ul",{},...l)):null)}};function rs(n,t,e=!0){return U("details",{class:"section",open:e},U("summary",{},n),t)}var wE=.02,cg={ArrowRight:[1,0],ArrowLeft:[-1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},SE=300,Yl=class{constructor(t,e){this.session=t,this.view=e,this.nodes=t.elements.list.map(i=>this.makeStop(i)),e.node.append(U("div",{class:"stops",role:"group","aria-label":"Elements on the face"},...this.nodes)),t.on("pose",()=>this.speakSoon()),t.on("options",()=>this.leaveOut()),this.leaveOut(),this.speak()}makeStop(t){let{session:e}=this,i=js(t.side);return U("div",{role:"slider",tabIndex:0,"aria-label":i?`${t.label}, ${i}`:t.label,"data-element":t.name,onfocus:()=>{e.select([t]),e.setHover(t)},onblur:()=>e.setHover(null),onkeydown:s=>this.key(s,t)})}leaveOut(){this.nodes.forEach((t,e)=>t.hidden=!this.session.isShown(this.session.elements.list[e]))}speakSoon(){let t=this.nodes.indexOf(document.activeElement);t>=0&&this.speak([t]),clearTimeout(this.resting),this.resting=setTimeout(()=>this.speak(),SE)}speak(t=this.nodes.keys()){for(let e of t){let i=this.session.elements.list[e],[s]=i.members,{minimum:r,maximum:o}=this.session.controls[s.control],a=i.members.map(({control:l})=>`${this.session.controls[l].label} ${this.session.worded(l)}`);ti(this.nodes[e],{"aria-valuemin":r,"aria-valuemax":o,"aria-valuenow":this.session.values[s.control],"aria-valuetext":a.join(", ")})}}key(t,e){let i=t.shiftKey?5:t.ctrlKey||t.metaKey?.1:1;if(cg[t.key]){let[s,r]=this.along(e,cg[t.key]);this.nudge(e,s,r*wE*i)}else if(t.key==="Home"||t.key==="End")this.nudge(e,0,t.key==="Home"?-1/0:1/0);else return;t.preventDefault(),t.stopPropagation()}along(t,[e,i]){return t.axes.length===1?[0,e-i]:$f(this.view.beginDrag(t),[e,i])}nudge(t,e,i){let{session:s}=this,r=ko(t,e,i,s.controls,s.rest,s.values);s.edit(`Nudge ${t.label}`,()=>s.set(r),`nudge ${t.index}`)}},hg="input[type=text], input[type=number], input[type=search], textarea";function ug(){let n=document.activeElement;return!(n instanceof HTMLElement)||!n.matches(hg)?!1:(n.blur(),!0)}var AE=250;function dg(n,t={},e=i=>i===""){let i=new Map,s=o=>!o.target.matches(hg);document.addEventListener("keydown",o=>{let a=o.target,l=[o.ctrlKey||o.metaKey?"Ctrl+":"",o.shiftKey?"Shift+":"",o.key.length===1?o.key.toLowerCase():o.key].join("");if(!s(o)&&l!=="Escape"||e(l))return;if(t[l]){!o.repeat&&!i.has(l)&&i.set(l,performance.now()),o.repeat||t[l](!0),o.preventDefault();return}let c=n[l];c&&(a.matches("button, summary, a")&&(l===" "||l==="Enter")||c()!==!1&&o.preventDefault())});let r=o=>{let a=i.get(o);a!==void 0&&(i.delete(o),t[o](!1),performance.now()-a<AE&&n[o]?.())};document.addEventListener("keyup",o=>r(o.key.toLowerCase())),window.addEventListener("blur",()=>[...i.keys()].forEach(r))}function Yr(n,t,e){let i=[],s=(c,h,u,d)=>$r(u,h)?d:$r(d,h)||$r(u,d)?u:(i.push(c),u??d),r=fg(n.keys,t.keys,e.keys,(c,...h)=>{let[u,d,f]=h.map(m=>new Map((m??[]).map(g=>[g[0],g]))),x=Ee([...u.keys(),...d.keys(),...f.keys()]).map(m=>s([c,m],u.get(m),d.get(m),f.get(m))).filter(Boolean);return x.length?x:void 0}),o=fg(n.standing,t.standing,e.standing,(c,...h)=>s([c,null],...h)),a=s(["frames",null],n.span,t.span,e.span),l={keys:r,standing:o,...a&&{span:a}};return{work:l,conflicts:i,taken:Lu(t,l)}}var Pu={keys:{},standing:{}};function Lu(n,t){let e=i=>pg(n[i],t[i]).filter(s=>!$r(n[i][s],t[i][s]));return[...new Set([...e("keys"),...e("standing"),...$r(n.span,t.span)?[]:["frames"]])]}function fg(n,t,e,i){let s=pg(n,t,e).map(r=>[r,i(r,n[r],t[r],e[r])]);return Object.fromEntries(s.filter(([,r])=>r!==void 0))}var pg=(...n)=>[...new Set(n.flatMap(Object.keys))].sort(),$r=(n,t)=>JSON.stringify(n)===JSON.stringify(t);var EE=1e-5;function mg(n,t,{changed:e,names:i,written:s}){let{controls:r,animation:o}=n,a=Qn(t,n),l=new Map(a.keys),c=new Map(a.constants),h=Object.fromEntries(Object.entries(e).map(([f,p])=>[f,sd(p)])),u=new Map,d=f=>oe(u,f,()=>or(n,[f],p=>o.at(p,a))[0]);return r.forEach(({attribute:f,minimum:p,maximum:x},m)=>{let{samples:g,one:_}=h[f]??{samples:[],one:null},w=f in h&&s.includes(f),y=(l.get(m)??[]).filter(([T])=>!w||_!==null||g.some(([I])=>I===T)),E=!g.length&&_!==null,S=o.isAnimated(m,l),v=y.length?y.map(([T])=>T):o.range(a.keys,a.span),A=[...TE(n,m,h,i,d),...E&&S?v.map(T=>[T,_]):g],L=([T,I])=>I!==null&&Math.abs(I-d(T).values[m])>EE*(x-p);l.set(m,A.filter(L).reduce((T,I)=>no(T,...I),y)),E&&!S?c.set(m,_):w&&!g.length&&c.delete(m)}),{...a,keys:new Map([...l].filter(([,f])=>f.length)),constants:c}}function TE({animation:n,controls:t,character:{channels:e,joints:i,skeletons:s}},r,o,a,l){let{reading:c}=t[r];if(!c)return[];let[h,u]=c.rises?.[0]??[],d=i[c.joint];if(!d&&t.some(({reading:g})=>g?.rises?.[0][0]===h&&g.rises.length<c.rises.length))return[];let{token:f,index:p,animation:x}=d?{token:d.path,animation:Eo(s[d.skeleton])}:e[h];return Object.entries(o).filter(([g])=>g.endsWith(`${x}.${d?"rotations":"blendShapeWeights"}`)).flatMap(([g,{samples:_}])=>{let w=Mc(a[g.replace(/\w+$/,d?"joints":"blendShapes")]??"");return _.map(([y,E])=>{let{values:S,weights:v,locals:A}=l(y),L=E?.[w.length?w.indexOf(f):p],[T,I,D,F]=d&&L||[],R=k=>n.turned(c,k);return[y,S[r]+(d?R(rr([I,D,F,T]))-R(ii(A[c.joint]).rotation):((L??NaN)-v[h])/u)]})})}var CE=300,RE=3,gg={open:"reading",saved:"saved",unsaved:"saving",lost:"link lost: save before you close"},IE={saved:"Every change is in this layer",lost:"The command that serves this page has ended; the browser keeps your work, and Save animation layer downloads it"},Kl=class{constructor(t,e,i,s="edit"){this.sessions=t,this.name=e,this.say=i,this.address=s,this.base=new Map,this.others=[],this.asked=[],this.revision="",this.changed=!1,this.isAhead=!1,this.waited=0,this.state="open",this.refusal=""}makeNode(){return this.words=U("output",{class:"link",role:"status"}),this.button=vt("Take theirs","What was changed here and elsewhere is as here now",()=>this.takeTheirs(),{hidden:!0}),this.tell(this.state),U("div",{class:"group live"},this.words,this.button)}follow(t){for(let e of["changed","time"])t.on(e,()=>this.changed=!0)}async run(){await this.turn(),setTimeout(()=>this.run(),CE)}async turn(){if(!this.isBusy)try{let t=this.waited++%RE===0;this.changed&&this.revision&&(t||!this.refusal)?await this.push():t&&await this.pull()}catch(t){if(!(t instanceof TypeError))throw t;this.tell("lost")}}get isBusy(){return this.sessions.some(({dragging:t,trial:e})=>t||e)}holds(t){return this.state==="saved"&&this.agrees(t)}agrees(t,e=ys(t)){return!Lu(this.baseOf(t),e).length}async push(){this.changed=!1;let t=new Map(this.sessions.map(s=>[s,ys(s)]));if(!this.isAhead&&this.sessions.every(s=>this.agrees(s,t.get(s)))){this.tell();return}this.refusal||this.tell("unsaved");let e=ef(this.sessions,s=>t.get(s),this.others),i=await this.send("PUT",{"If-Match":this.revision},e);i.status===412?(this.changed=!0,await this.pull()):i.ok?(this.revision=i.headers.get("ETag")??"",this.isAhead=!1,this.base=t,this.tell()):(this.changed=!0,await this.refuse(i))}async refuse(t){let e=t.status===404?gg.lost:(await t.text()).trim();e!==this.refusal&&this.say(`${this.name}: ${e}`),this.tell("refused",e)}takeTheirs(){this.asked.splice(0).forEach(({session:t,here:e,there:i})=>xg(t,e,i)),this.changed=!0,this.tell()}async pull(){let t=await this.send("GET",{"If-None-Match":this.revision});if(t.status===304)this.tell();else if(t.ok){let e=await t.text();if(this.isBusy)return;let i=!this.revision;this.revision=t.headers.get("ETag")??"",this.take(e,i)}else await this.refuse(t)}take(t,e){if(!t){e||this.say(`${this.name} is gone: the next change writes it anew`),this.base.clear(),this.tell("saved");return}let i=JSON.parse(t);this.isAhead=Object.keys(i.changed).length>0,this.others=Fc(i.work);for(let s of this.sessions){let r=this.others.find(({root:a})=>a===s.character.root)??Pu,o=this.others.length?r:this.baseOf(s);this.merge(s,jn(s,mg(s,o,i)),e);for(let{name:a}of s.controls)delete r.keys[a],delete r.standing[a]}this.tell()}merge(t,e,i){let s=this.baseOf(t),r=ys(t),{work:o,conflicts:a,taken:l}=Yr(s,r,e);l.length&&(xg(t,s,e),i||this.say(`${this.name} changed elsewhere: ${vg(l.map(c=>yg(t,c)))}`)),this.base.set(t,e),this.changed||=this.isAhead||!this.agrees(t),a.length&&(this.say(`Changed here and elsewhere, as here now: ${vg(a.map(c=>PE(t,c)))}`),this.asked.push({session:t,conflicts:a,here:o,there:Yr(s,e,r).work}))}baseOf(t){return this.base.get(t)??Pu}send(t,e,i){return fetch(this.address,{method:t,headers:e,body:i,cache:"no-store",credentials:"omit",redirect:"error"})}tell(t=this.changed?"unsaved":"saved",e=""){this.asked=this.asked.filter(({session:i,here:s,there:r})=>Yr(s,ys(i),r).taken.length),Object.assign(this,{state:t,refusal:e}),this.words&&(this.words.textContent=`${this.name}: ${e||gg[t]}`,this.words.title=IE[t]??"",this.words.classList.toggle("wrong",["lost","refused"].includes(t)),this.button.hidden=!this.asked.length)}},xg=(n,t,e)=>n.rebase(i=>Qn(Yr(t,jn(n,i),e).work,n)),vg=n=>n.length>4?`${n.slice(0,3).join(", ")} and ${n.length-3} more`:n.join(", "),yg=({controls:n},t)=>n.find(e=>e.name===t)?.label??t,PE=(n,[t,e])=>`${yg(n,t)}${e===null?"":` at frame ${e}`}`;var LE=.7,Zl=class{constructor(t,e,i,s,r,o){this.session=t,this.view=e,this.timeline=i,this.say=s,this.roots=r,this.partsOf=o,e.review=this,this.line=null,this.shown=[],this.list=U("div",{class:"notes"}),this.pen=kn("Draw","Draw on the view: two fingers, the wheel and other buttons still move it",()=>t.options.draw,()=>this.setPen()),this.back=vt("Take back","Take away the last stroke of this note",()=>this.takeBack()),this.saving=vt("Save review","Download the notes as a small USD layer, to send",()=>this.save()),this.node=U("aside",{class:"review","aria-label":"Review"},tn(vt("Add note","A note on the frame, the pose and the view shown now",()=>this.write()),this.pen,this.back,this.saving,vt("Open…","Add the notes of a review that somebody sent",()=>this.open())),this.list);for(let a of["time","options","editing"])t.on(a,()=>this.update());this.update()}get chosen(){return this.session.notes.find(({id:t})=>t===this.session.note)??null}isHere({frame:t,neutral:e}){return t===this.session.frame&&e===this.session.neutral}get seen(){let{chosen:t}=this;return t&&this.isHere(t)&&ld(t.look,this.view.camera)?t:null}lines(){let{view:t,seen:e,line:i}=this;if(!t.controlsColumn)return[];let s=t.camera.projector(t.controlsColumn);return[...e?.strokes.map(o=>[e.look,o])??[],...i?[[i.look,i.pairs]]:[]].map(([o,a])=>a.map(l=>s(wc(o,l))))}setPen(t=!this.session.options.draw){this.session.setOption("draw",t)}note(t={}){let{session:e}=this,{frame:i,neutral:s,values:r,section:o}=e;return{id:crypto.getRandomValues(new Uint32Array(2)).join("-"),frame:i,neutral:s,text:"",done:!1,values:ir(e,r),section:o.title,look:this.look(),strokes:[],...t}}look(){return this.view.camera.leaveShot(),this.view.changed("camera"),od(this.view.camera,this.view.controlsColumn)}add(t,e){this.session.note=e.id,this.session.put(t,{notes:[...this.session.notes,e]})}write(){this.add("Add a note",this.note()),this.list.querySelector(".chosen textarea")?.focus()}change(t,e,i,s=null){this.session.put(t,{notes:this.session.notes.map(r=>r.id===e.id?{...r,...i}:r)},s)}remove(t){this.session.put("Take away a note",{notes:this.session.notes.filter(({id:e})=>e!==t.id)})}drawing(t){let{view:e,seen:i}=this,{camera:s,controlsColumn:r}=e,o=i?.look??this.look(),a=Et(ve(s.position,o.target),s.towards),l=h=>{this.line.pairs.push(...h.map(({x:u,y:d})=>ad(o,s.unproject(r,u,d,a)))),e.changed("overlay")},c=()=>{let h=co(this.line.pairs,LE*s.pixelSize(r.height)).map(u=>u.map(d=>Number(d.toPrecision(6))));this.line=null,i?this.change("Draw",i,{strokes:[...i.strokes,h]}):this.add("Draw",this.note({look:o,strokes:[h]}))};return{begin:()=>{this.line={look:o,pairs:[]},l([t])},drag:(h,u,d,f)=>l(f),drop:c,click:c,undo:()=>{this.line=null,e.changed("overlay")}}}takeBack(){let{chosen:t}=this;t?.strokes.length&&this.change("Take back a stroke",t,{strokes:t.strokes.slice(0,-1)})}show(t){let{session:e,view:i}=this,{sections:s}=e.character.layout,r=s.findIndex(({title:o})=>o===t.section);r>=0&&s[r]!==e.section&&e.show(r),this.timeline.stop(),this.isHere(t)||this.timeline.go(t.frame,t.neutral),i.lookAs(t.look),e.note=t.id,e.look(fs(e,t)),e.emit("options")}update(){let{session:t,chosen:e}=this;this.pen.update(),this.back.disabled=!e?.strokes.length,this.saving.disabled=!t.notes.length;let i=[t.notes,t.note,e&&this.isHere(e),t.looks];if(wn(i,this.shown)||(this.shown=i,this.view.changed("overlay"),this.typing))return;let s=be("No notes yet. Pose the face or turn the view, then draw on it or add a note. Send the saved file back: `usdrigui view LAYER --review FILE` opens it.");this.list.replaceChildren(...t.notes.length?t.notes.map((r,o)=>this.item(r,o)):[s])}item(t,e){let i=t.id===this.session.note,s=t.strokes.length?`, ${he(t.strokes.length,"stroke")}`:"",r=U("input",{type:"checkbox",checked:t.done,"aria-label":`Note ${e+1} is done`,title:"Done",onchange:()=>this.change("Tick a note",t,{done:r.checked})}),o=U("textarea",{value:t.text,rows:i?3:1,placeholder:"Comment","aria-label":`Comment of note ${e+1}`,oninput:()=>this.type(t,o.value)});return U("div",{class:`note${i?" chosen":""}${t.done?" done":""}`,"data-note":t.id},U("div",{class:"note-head"},vt(`${e+1} · ${Ec(t)}${s}`,"Go to its frame, view and pose",()=>this.show(t),{class:"note-go"}),r,vt("×","Take this note away",()=>this.remove(t),{class:"note-away","aria-label":`Take note ${e+1} away`})),o,i?this.poseActions(t):null)}type(t,e){this.typing=!0,this.change("Write a comment",t,{text:e},`comment ${t.id}`),this.typing=!1}poseActions(t){let{session:e}=this;return e.looks?tn(vt("Take this pose","Set the controls to the pose of the note",()=>e.adopt())):this.isHere(t)?tn(vt("Set pose","Give the note the pose shown now",()=>this.change("Give a note the pose",t,{values:ir(e,e.values)}))):null}save(){An("review.usda",hd(this.partsOf()));for(let[t]of this.partsOf())t.sent=t.notes;this.say(`Saved review.usda, ${he(this.session.notes.length,"note")}`)}open(){return _i(".usda",this.say,({name:t,text:e})=>{let i=ho(uo(e),this.session,this.roots);if(!i.length)throw new Error("The notes are of another character.");this.session.received=[...new Set([...this.session.received,...i.map(({id:s})=>s)])],this.session.put(`Open ${t}`,{notes:sr(this.session.notes,i)}),this.say(`${he(i.length,"note")} opened`)})}};var NE=.0003662109375,DE={u1:Uint8Array,u2:Uint16Array,i2:Int16Array,u4:Uint32Array,i4:Int32Array,f4:Float32Array,f8:Float64Array};async function _g(n){let t=Uint8Array.from(atob(n),l=>l.charCodeAt(0)),e=new Blob([t]).stream().pipeThrough(new DecompressionStream("deflate")),i=new Uint8Array(await new Response(e).arrayBuffer()),s=new DataView(i.buffer).getUint32(0,!0),r=JSON.parse(new TextDecoder().decode(i.subarray(4,4+s))),o=i.subarray(4+s);r.characters.forEach(l=>FE(l,o));let a=await OE((r.images??[]).map(l=>sn(l,o)));for(let l of r.characters)l.texture=a;return r}async function OE(n){if(!n.length||typeof createImageBitmap>"u")return null;let t=await Promise.all(n.map(l=>createImageBitmap(new Blob([l]),{colorSpaceConversion:"none"}))),e=Math.max(...t.flatMap(({width:l,height:c})=>[l,c])),i=Math.ceil(Math.sqrt(t.length)),[s,r]=[i*e,Math.ceil(t.length/i)*e],o=Object.assign(document.createElement("canvas"),{width:s,height:r}).getContext("2d"),a=t.map((l,c)=>[c%i*e,Math.floor(c/i)*e,l.width,l.height]);return t.forEach((l,c)=>o.drawImage(l,a[c][0],a[c][1])),{width:s,height:r,boxes:a,texels:new Int32Array(o.getImageData(0,0,s,r).data.buffer)}}function FE(n,t){n.bind=sn(n.bind,t),n.base=sn(n.base,t);let e=0;for(let i of n.meshes){if(i.points=kE(sn(i.points,t),i.low,i.step),i.count=i.points.length/3,i.start=e,e+=i.count,i.triangles=sn(i.triangles,t),i.texture)for(let s of["uv","images"])i.texture[s]=sn(i.texture[s],t);i.colours=sn(i.colours,t),i.gaze=i.gaze&&Float32Array.from(sn(i.gaze,t),s=>s*NE);for(let s of i.shapes)s.points=sn(s.points,t),s.offsets=sn(s.offsets,t);i.skin&&UE(i.skin,t)}n.pointCount=e,n.shotCamera=n.shotCamera?.map(i=>[0,3,6,9,12].map(s=>i.slice(s,s+3))),n.clip&&(n.clip.weights=sn(n.clip.weights,t),n.clip.locals=sn(n.clip.locals,t))}function UE(n,t){let[e,i]=n.joints.shape;n.rows=e,n.width=i,n.joints=sn(n.joints,t);let s=sn(n.weights,t);n.weights=new Float64Array(s.length);for(let r=0;r<e;r++){let o=s.subarray(r*i,(r+1)*i).reduce((l,c)=>l+c,0),a=Math.abs(o-65535)<=i?o:65535;for(let l=r*i;l<(r+1)*i;l++)n.weights[l]=s[l]/a}}function sn(n,t){let e=DE[n.kind],i=e.BYTES_PER_ELEMENT,s=n.shape.reduce((a,l)=>a*l,1),r=new Uint8Array(s*i);for(let a=0;a<i;a++){let l=n.at+a*s;for(let c=0;c<s;c++)r[c*i+a]=t[l+c]}let o=new e(r.buffer);if(n.sum)for(let a=1;a<s;a++)o[a]+=o[a-1];return o}var kE=(n,t,e)=>Float32Array.from(n,(i,s)=>t[s%3]+i*e[s%3]);var BE=[1,48],zE=24,GE=1e-6,Jl=class{constructor(t,e){this.character=t,this.controls=t.controls,this.clip=t.clip,this.rest=e;let[i,s,r]=t.timeCodes??[...BE,zE];this.rate=this.clip?.framesPerSecond||r;let o=this.clip&&this.clip.times.length>1?this.clip.times:[i,s];this.first=Math.floor(o[0]),this.last=Math.max(this.first+1,Math.ceil(o.at(-1))),this.span=null,this.readings=this.controls.map(({reading:a})=>this.clip&&a),this.moving=this.readings.map(a=>a!==null&&this.isMoved(a)),this.recent=new Map}isMoved({rises:t,joint:e}){let{weights:i,locals:s,times:r}=this.clip,o=(a,l,c,h)=>{for(let u=c;u<c+h;u++)for(let d=1;d<r.length;d++)if(Math.abs(a[d*l+u]-a[u])>GE)return!0;return!1};return t?o(i,this.character.channels.length,t[0][0],1):o(s,16*this.character.joints.length,16*e,11)}isAnimated(t,e){return e.has(t)||this.moving[t]}at(t,{keys:e,constants:i}){let{values:s,weights:r,locals:o}=this.clipAt(t),a=Float64Array.from(s);for(let[l,c]of i)this.isAnimated(l,e)||(a[l]=c);for(let[l,c]of e)a[l]=Nu(c,t,this.moving[l]?h=>this.clipAt(h).values[l]:null);return{values:a,weights:r,locals:o}}get isFree(){return!(this.clip?.times.length>1)}range(t,e=this.span){let i=[...t.values()].flatMap(o=>[o[0][0],o.at(-1)[0]]),[s,r]=e??[this.first,this.last];return[Math.min(s,...i.map(Math.floor)),Math.max(r,...i.map(Math.ceil))]}times(t,e=this.span){let[i,s]=this.range(t,e),r=new Set(this.clip?.times??[]);for(let o=i;o<=s;o++)r.add(o);for(let[o,a]of t){for(let[l]of a)r.add(l);for(let l of io(a))r.add(l);this.moving[o]&&r.add(a[0][0]-1).add(a.at(-1)[0]+1)}return Ee(r)}clipAt(t){return this.clip?oe(this.recent,t,()=>(this.recent.size>=4&&this.recent.delete(this.recent.keys().next().value),this.readClip(t))):{values:this.rest,weights:null,locals:null}}readClip(t){let e=this.weightsAt(t),i=this.localsAt(t),s=new Map,r=Float64Array.from(this.controls,(o,a)=>{let l=this.readings[a];if(!l)return o.default;let{rises:c,joint:h}=l,u=c?(e[c[0][0]]-this.character.baseWeights[c[0][0]])/c[0][1]:this.turned(l,ii(i.subarray(16*h,16*h+16)).rotation);if(!c){let d=s.get(h)??[0,0,0];s.set(h,d.map((f,p)=>f+u*l.turn[p]))}return o.default+u});this.readings.forEach((o,a)=>{let l=r[a]-this.controls[a].default;o?.rises?.forEach(([c,h])=>e[c]-=l*h)});for(let[o,a]of s)VE(i.subarray(16*o,16*o+16),a);return{values:r,weights:e,locals:i}}turned({joint:t,turn:e},i){let s=ii(this.character.base.subarray(16*t,16*t+16)).rotation,r=Zd(ni(i,yo(s)));return Et(r,e)/Et(e,e)}weightsAt(t){let{low:e,high:i,share:s}=this.between(t),r=this.character.channels.length,{weights:o}=this.clip;return Float64Array.from({length:r},(a,l)=>Ce(o[e*r+l],o[i*r+l],s))}localsAt(t){let{low:e,high:i,share:s}=this.between(t),r=16*this.character.joints.length,o=l=>this.clip.locals.subarray(l*r,(l+1)*r),a=Float64Array.from(o(e));if(s===0)return a;for(let l=0;l<r;l+=16){let[c,h]=[o(e),o(i)].map(u=>u.subarray(l,l+16));c.some((u,d)=>u!==h[d])&&a.set(Jd(c,h,s),l)}return a}between(t){let{times:e}=this.clip,i=Math.max(0,e.findLastIndex(o=>o<=t)),s=Math.min(i+1,e.length-1),r=s>i?Math.max(0,(t-e[i])/(e[s]-e[i])):0;return{low:i,high:s,share:r}}};function Nu(n,t,e){let i=n.findIndex(([a])=>a>=t);if(i>0)return ju(n,i-1,t);let[s,r]=i===0?n[0]:n.at(-1),o=Math.abs(t-s);return!e||o===0?r:o>=1?e(t):Ce(r,e(s+Math.sign(t-s)),o)}function VE(n,t){let{stretch:e,rotation:i}=ii(n),s=bo(...t.map(o=>-o)),r=ni(e,ni(s,i));for(let o=0;o<3;o++)n.set(r.slice(3*o,3*o+3),4*o)}var Mg=1e6,Du=(n,t)=>t.flatMap(([e,i])=>(n.get(e)??[]).filter(([s])=>s===i).map(s=>[e,s]));function bg(n,t,e,i=!1){let s=Du(n,t).map(([r,o])=>{let[a,l]=e(o,r),c=(e([o[0]+Mg,o[1]],r)[0]-a)/Mg;return[r,[a,l,rn(o),o.length>3&&c?o[3]/c:null]]});return{keys:os(i?n:Kr(n,t),s),picked:new Set(s.map(([r,[o]])=>`${r} ${o}`))}}function os(n,t){let e=new Map(n);for(let[i,s]of t)e.set(i,no(e.get(i)??[],...s));return e}function jl(n,t,e){if(!e)return s=>s+n;let i=t-e[0]>e[1]-t?e[0]:e[1];return s=>Math.round(i+(s-i)*(t+n-i)/(t-i))}function Kr(n,t){let e=new Map(n);for(let[i,s]of t){let r=gc(e.get(i)??[],s);r.length?e.set(i,r):e.delete(i)}return e}var wg=(n,t,e)=>os(t,Du(t,e).map(([i,[s,r]])=>[i,[s,r,n,null]]));function Sg(n,t){let e=Math.min(...t.map(([,i])=>i));return Du(n,t).map(([i,s])=>[i,[s[0]-e,...s.slice(1)]])}var Ag=(n,t,e)=>os(n,t.map(([i,[s,r,o="linear",a=null]])=>[i,[e+s,r,o,a]])),Ql=(n,t,[e,i]=[-1/0,1/0])=>t.flatMap(s=>(n.get(s)??[]).filter(([r])=>r>=e&&r<=i).map(([r])=>[s,r]));function Eg(n,t,e,i){return t.flatMap(s=>{let r=n.get(s)??[],[o,a]=[r.findLast(([l])=>l<e),r.find(([l])=>l>e)];return o&&a?[[s,o[1]+i*(a[1]-o[1])]]:[]})}function Tg({values:n,controls:t,rest:e,twins:i,opposites:s,crosses:r,mirrored:o}){return t.flatMap(({minimum:a,maximum:l},c)=>{if(i[c]>=0)return[[c,o(i[c],c)]];if(!r(c))return[];let[h]=s[c];return h!==void 0&&r(h)?[[c,o(h,c)]]:a<e[c]&&l>e[c]?[[c,2*e[c]-n[c]]]:[]})}function Cg(n,{twins:t,sideOf:e,mirrored:i}){return[...t.entries()].filter(([s,r])=>r>=0&&e(s)===n).map(([s,r])=>[r,i(s,r)])}var HE=1e-8,tc=class{constructor(t){this.joints=t.joints,this.count=this.joints.length,this.toRoot=t.skeletons.map(e=>e.toRoot.flat()),this.unbind=this.joints.map((e,i)=>vs(t.bind.subarray(16*i,16*i+16))),this.restLocals=t.base,this.locals=t.base,this.factors=new Map,this.whole=[...this.joints.keys()]}setBase(t){this.locals=t??this.restLocals,this.factors.clear()}chainOf(t){let e=new Set;for(let i of t)for(;i>=0&&!e.has(i);i=this.joints[i].parent)e.add(i);return Ee(e)}skinning(t,e=this.whole){let i=new Array(this.count),s=new Array(this.count);for(let r of e){let o=this.localAt(r,t),a=this.joints[r].parent;i[r]=a<0?o:en(o,i[a]),s[r]=en(this.unbind[r]??xs,i[r])}return s}localAt(t,e){let i=this.locals.subarray(16*t,16*t+16),s=9*t;if(e.subarray(s,s+9).every(h=>h===0))return i;let{stretch:r,rotation:o}=oe(this.factors,t,()=>ii(i)),a=bo(e[s],e[s+1],e[s+2]),l=ni(ni(r,a),o),c=Array.from(i);for(let h=0;h<3;h++){let u=Math.exp(e[s+6+h]);for(let d=0;d<3;d++)c[4*h+d]=u*l[3*h+d];c[12+h]+=e[s+3+h]}return c}rowMap(t,e,i,s){let r=t.dualQuaternion?qE(t,e,s??Rg(i)):XE(t,e,i),o=this.toRoot[this.joints[t.joints[0]].skeleton];return en(en(t.bind,r),o)}maps(t,e,i){let s=Fu(t),r=this.toRoot[this.joints[t.joints[0]].skeleton];if(t.sumsToOne&&s.every(l=>WE(e[l],e[s[0]],i)))return Ou([en(en(t.bind,e[s[0]]),r)]);if(t.sumsToOne&&!t.dualQuaternion)return this.linearMaps(t,e,s,r);let o=t.dualQuaternion?Rg(e):null,a=[];for(let l=0;l<t.rows;l++)a.push(this.rowMap(t,l,e,o));return Ou(a)}linearMaps(t,e,i,s){let r=new Float64Array(12*this.count),o=Ou(i.map(l=>en(en(t.bind,e[l]),s)));i.forEach((l,c)=>r.set(o.subarray(12*c,12*c+12),12*l));let a=new Float64Array(12*t.rows);for(let l=0,c=0;l<t.rows;l++)for(let h=c+t.width;c<h;c++){let u=t.weights[c];if(u===0)continue;let d=12*t.joints[c];for(let f=0;f<12;f++)a[12*l+f]+=u*r[d+f]}return a}};function Ig(n){n.bind=n.geomBind.flat(),n.sumsToOne=!0;for(let t=0;t<n.rows&&n.sumsToOne;t++){let e=0;for(let i=t*n.width;i<(t+1)*n.width;i++)e+=n.weights[i];n.sumsToOne=Math.abs(e-1)<=1e-6}}function Fu(n){return n.used??=Ee(n.joints.filter((t,e)=>n.weights[e]!==0)),n.used}function WE(n,t,e){for(let i=0;i<15;i++)if(Math.abs(n[i]-t[i])>HE*(i>11?e:1))return!1;return!0}function Ou(n){let t=new Float64Array(12*n.length);return n.forEach((e,i)=>{for(let s=0;s<4;s++)t.set([e[4*s],e[4*s+1],e[4*s+2]],12*i+3*s)}),t}function XE(n,t,e){let i=new Array(16).fill(0);for(let s=t*n.width;s<(t+1)*n.width;s++){let r=n.weights[s];if(r===0)continue;let o=e[n.joints[s]];for(let a=0;a<16;a++)i[a]+=r*o[a]}return i[15]=1,i}function Rg(n){return n.map(t=>{let{stretch:e,rotation:i}=ii(t);return{stretch:e,dual:gs.fromRotationTranslation(gs.create(),wo(i),t.slice(12,15))}})}function qE(n,t,e){let i=t*n.width,s=i;for(let l=i;l<i+n.width;l++)n.weights[l]>n.weights[s]&&(s=l);let r=e[n.joints[s]].dual,o=new Array(9).fill(0),a=new Array(8).fill(0);for(let l=i;l<i+n.width;l++){let c=n.weights[l];if(c===0)continue;let h=e[n.joints[l]],u=pn.dot(h.dual,r)<0?-c:c;for(let d=0;d<9;d++)o[d]+=c*h.stretch[d];for(let d=0;d<8;d++)a[d]+=u*h.dual[d]}return gs.normalize(a,a),Kd(ni(o,rr(a)),gs.getTranslation([0,0,0],a))}var ec=class{constructor(t){this.character=t,this.controls=t.controls,this.baseWeights=Float64Array.from(t.baseWeights),this.weights=new Float64Array(t.channels.length),this.moves=new Float64Array(9*t.joints.length),this.skeletons=new tc(t),this.points=new Float32Array(3*t.pointCount);for(let e of t.meshes)YE(e);this.jointsAt=null}setBase(t,e){this.baseWeights=Float64Array.from(t??this.character.baseWeights),this.skeletons.setBase(e),this.jointsAt=null}drive(t){this.weights.set(this.baseWeights),this.moves.fill(0);for(let e=0;e<this.controls.length;e++)t[e]!==this.controls[e].default&&this.addDrive(e,t[e])}addDrive(t,e,i=1){let{drive:s}=this.controls[t],[r,o]=Qr(s.values,e),a=(l,c)=>i*Ce(l[r][c],l[r+1][c],o);s.channels.forEach((l,c)=>this.weights[l]+=a(s.weights,c)),s.joints.forEach((l,c)=>{[s.rotations,s.translations,s.scales].forEach((h,u)=>{for(let d=0;d<3;d++){let f=9*l+3*u+d;this.moves[f]=$E(this.moves[f]+i*Ce(h[r][c][d],h[r+1][c][d],o))}})})}pose(t){this.drive(t),this.updateMaps();for(let e of this.character.meshes)e.visible&&this.poseMesh(e);return this.points}posedAside(t){let e=this.points;this.points=new Float32Array(e.length);let i=this.pose(t);return this.points=e,i}updateMaps(){let{jointsAt:t,moves:e}=this;if(t&&e.every((s,r)=>s===t[r]))return;let i=this.skeletons.skinning(e);for(let s of this.character.meshes)s.skin&&(s.maps=this.skeletons.maps(s.skin,i,s.size)),s.plain=s.maps.length===12&&Pg(s.maps);this.jointsAt=e.slice()}poseMesh(t){let e=this.points.subarray(3*t.start,3*(t.start+t.count)),i=t.plain?e:t.blended??=new Float32Array(t.points.length);i.set(t.points);for(let s of t.shapes){let r=this.weights[s.channel];r!==0&&KE(s,r,i)}t.plain||ZE(i,t.maps,e)}tracer(t,e,i=-1){let s=this.character.meshes[t],r=[];for(let a of s.shapes){let l=a.points.indexOf(e);l>=0&&r.push({shape:a,row:l})}let o={mesh:s,point:e,shapes:r,row:0,chain:[],skin:s.skin};if(s.skin&&i>=0)o.skin={...s.skin,joints:Uint16Array.of(i),weights:Float64Array.of(1),rows:1,width:1},o.chain=this.skeletons.chainOf([i]);else if(s.skin){o.row=s.skin.rows===1?0:e;let a=o.row*s.skin.width,l=s.skin.joints.subarray(a,a+s.skin.width);o.chain=this.skeletons.chainOf(l.filter((c,h)=>s.skin.weights[a+h]!==0))}return o}trace(t,e=this.traceMap(t)){let[i,s,r]=this.traceBlend(t);return Mo(e,i,s,r)}traceBlend({mesh:t,point:e,shapes:i}){let s=Array.from(t.points.subarray(3*e,3*e+3));for(let{shape:r,row:o}of i){let a=this.weights[r.channel];a!==0&&Lg(r,a,(l,c)=>{let h=3*(l*r.points.length+o);for(let u=0;u<3;u++)s[u]+=c*r.step*r.offsets[h+u]})}return s}traceMap({mesh:t,skin:e,row:i,chain:s}){return e?this.skeletons.rowMap(e,i,this.skeletons.skinning(this.moves,s)):t.root}withControl(t,e,i,s){let{drive:r}=this.controls[t],o=r.channels.map(c=>this.weights[c]),a=r.joints.map(c=>this.moves.slice(9*c,9*c+9));this.addDrive(t,e,-1),this.addDrive(t,i);let l=s();return r.channels.forEach((c,h)=>this.weights[c]=o[h]),r.joints.forEach((c,h)=>this.moves.set(a[h],9*c)),l}},$E=n=>Math.abs(n)<1e-14?0:n;function YE(n){n.root=n.toRoot.flat(),n.size=n.points.reduce((t,e)=>Math.max(t,Math.abs(e)),1e-30),n.maps=Float64Array.from([0,1,2,3].flatMap(t=>n.root.slice(4*t,4*t+3))),n.plain=Pg(n.maps),n.skin&&(Ig(n.skin),Fu(n.skin));for(let t of n.shapes)t.nodes=Ee([...t.weights,0]),t.zero=t.nodes.indexOf(0)}function Pg(n){return[1,0,0,0,1,0,0,0,1,0,0,0].every((t,e)=>Math.abs(n[e]-t)<1e-12)}function Lg(n,t,e){if(n.weights.length===1){e(0,t);return}let[i,s]=Qr(n.nodes,t);for(let[r,o]of[[i,1-s],[i+1,s]])r!==n.zero&&o!==0&&e(r>n.zero?r-1:r,o)}function KE(n,t,e){let{points:i,offsets:s,step:r}=n,o=i.length;Lg(n,t,(a,l)=>{let c=l*r,h=3*a*o;for(let u=0;u<o;u++,h+=3){let d=3*i[u];e[d]+=c*s[h],e[d+1]+=c*s[h+1],e[d+2]+=c*s[h+2]}})}function ZE(n,t,e){let i=t.length===12?0:12;for(let s=0,r=0;s<n.length;s+=3,r+=i){let o=n[s],a=n[s+1],l=n[s+2];e[s]=o*t[r]+a*t[r+3]+l*t[r+6]+t[r+9],e[s+1]=o*t[r+1]+a*t[r+4]+l*t[r+7]+t[r+10],e[s+2]=o*t[r+2]+a*t[r+5]+l*t[r+8]+t[r+11]}}var nc=class{width;constructor(t,e){this.deformer=e,this.rest=JE(t),this.list=t.layout.elements.map((i,s)=>({...i,index:s})),this.byControl=new Map;for(let i of this.list){for(let s of i.members)this.claim(s.control,i);this.prepare(i)}}claim(t,e){this.byControl.get(t)?.inner.includes(e.name)||this.byControl.set(t,e)}prepare(t){let{deformer:e}=this,{held:i,deforms:s,joint:r}=t.follows[t.onBoard?"board":"character"],o=e.tracer(t.mesh,t.point,r);Object.assign(t,{held:i,deforms:s,carrier:o,tracer:e.tracer(t.mesh,t.point)}),e.setBase(null,null),e.drive(this.rest),t.restMap=e.traceMap(o),t.restPoint=e.trace(o,t.restMap),t.restInverse=vs(t.restMap),t.enlarged=t.members.some(a=>a.magnification!==1)}follow(t,e=!1,i=this.list){this.deformer.drive(t);for(let s of i)this.followOne(s,t,e||!s.deforms)}followOne(t,e,i){let{carrier:s,restInverse:r,restPoint:o}=t,[a,l]=this.without(t.held,e,()=>{let d=this.deformer.traceMap(s);return[d,this.deformer.trace(s,d)]}),c=r?en(r,a):xs,h=i?Mo(c,...o):l;t.tracks=t.members.map(d=>d.track.map(f=>Ng(f,o,c,h)));let u=t.members.map((d,f)=>Sn(d.values,t.tracks[f],this.rest[d.control]));if(t.origin=u[0],t.handle=i||t.enlarged?this.handleAt(t,e,u):this.deformer.trace(s),t.glyph){let d=i||!r?c:en(r,this.deformer.traceMap(s));t.outline=t.glyph.points.map(f=>Ng(f,[0,0,0],d,t.handle))}}handleAt(t,e,i){let s=(r,o,a)=>we(r,ve(Sn(o.values,t.tracks[a],e[o.control]),i[a]));return t.members.reduce(s,i[0])}paths(t){let{deformer:e,rest:i}=this,s=e.trace(t.tracer);return t.members.map(({control:r,values:o,magnification:a})=>o.map(l=>{let c=e.withControl(r,i[r],l,()=>e.trace(t.tracer));return we(s,ue(ve(c,s),a))}))}without(t,e,i){return t.reduce((r,o)=>e[o]===this.rest[o]?r:()=>this.deformer.withControl(o,e[o],this.rest[o],r),i)()}reanchor(t,e,i,s){Object.assign(t,{mesh:e,point:i,onBoard:!1,category:""}),t.tracer=this.deformer.tracer(e,i),this.deformer.setBase(null,null),this.deformer.drive(this.rest),t.position=this.deformer.trace(t.tracer);for(let a of t.members)a.magnification=1;let r=this.paths(t);t.members.forEach((a,l)=>a.magnification=jE(r[l],s*this.width));let o=this.paths(t);t.members.forEach((a,l)=>a.track=o[l].map(c=>[...c])),this.prepare(t)}putBeside(t){Object.assign(t,{onBoard:!0,category:t.boardCategory}),this.prepare(t)}placement(t){let{mesh:e,point:i,onBoard:s,category:r,position:o}=t,a=t.members.map(({track:l,magnification:c})=>({track:l,magnification:c}));return{mesh:e,point:i,onBoard:s,category:r,position:o,members:a}}restore(t,{members:e,...i}){Object.assign(t,i),t.members.forEach((s,r)=>Object.assign(s,e[r])),this.prepare(t)}};function JE(n){let t=n.layout.baseValues;return Float64Array.from(n.controls,(e,i)=>t[i]??e.default)}function jE(n,t){let e=as(n);return e>0&&e<t?t/e:1}function Ng(n,t,e,i){let[s,r,o]=ve(n,t);return[0,1,2].map(a=>i[a]+s*e[a]+r*e[4+a]+o*e[8+a])}var ic=class{constructor(t){this.named=new Map(t.map(e=>[e.name,e])),this.holders=new Map;for(let e of t)for(let i of e.inner)oe(this.holders,i,()=>[]).push(e.name);this.opened=new Set}coarseOf(t){return t.inner.length?[t]:(this.holders.get(t.name)??[]).map(e=>this.named.get(e))}shows(t){if(this.opened.has(t.name))return!1;let e=this.holders.get(t.name);return!e||e.some(i=>this.opened.has(i))}toggle(t,e){for(let i of t)for(let s of[i.name,i.mirror])this.named.get(s)?.inner.length&&this.opened[e?"add":"delete"](s)}};var QE={arrangement:"face",handles:!0,labels:"hover",opacity:.9,fade:!0,occlusion:"ghost",follow:!0,heat:!0,symmetric:!1,rearrange:!1,autoKey:!1,draw:!1,onion:!1,trails:!1,shot:!1,interpolation:"linear",locality:.1,skinDrag:!0},sc=class{section;within;constructor(t){this.character=t,this.controls=t.controls,this.deformer=new ec(t),this.elements=new nc(t,this.deformer),this.levels=new ic(this.elements.list),this.colours=t.layout.colours,this.options={...QE},this.selection=new Set,this.hidden=new Set,this.hover=null,this.quiet=!1,this.listeners=new Map}on(t,e){oe(this.listeners,t,()=>new Set).add(e)}fileNamed(t){return`${this.character.root.split("/").at(-1)||"character"}.${t}`}save(t,{text:e,unwritten:i=[]},s=r=>r){e&&An(this.fileNamed(t),e),this.emit("saved"),i.length&&s(`No animation drives ${i.join(", ")}`)}updating(t){for(let e of["options","layout"])this.on(e,()=>t.update());return t.update(),t}emit(t){this.listeners.get(t)?.forEach(e=>e())}select(t,e="replace"){e==="replace"&&this.selection.clear();for(let i of t)e==="toggle"&&this.selection.has(i.index)?this.selection.delete(i.index):this.selection.add(i.index);this.emit("selection")}get selectedElements(){return[...this.selection].map(t=>this.elements.list[t])}get chosenControls(){let t=this.selectedElements.flatMap(e=>e.members.map(i=>i.control));return t.length?t:[...this.controls.keys()]}setHover(t){this.hover!==t&&(this.hover=t,this.quiet=!1,this.emit("hover"))}hide(t){t.forEach(e=>this.hidden.add(e.index)),this.selection.clear(),this.emit("selection"),this.emit("options")}showAll(){this.hidden.clear(),this.emit("options")}show(t){this.section=this.character.layout.sections[t],this.within=new Set(this.section.elements),this.elements.width=this.section.handleWidth,this.selection.clear(),this.emit("section")}isShown(t){return this.within.has(t.name)&&!this.hidden.has(t.index)&&this.levels.shows(t)}openOrClose(t=this.selectedElements){let e=t.filter(s=>s.inner.length),i=t.flatMap(s=>s.inner.length?[]:this.levels.coarseOf(s));return!e.length&&!i.length?!1:(this.levels.toggle(e,!0),this.levels.toggle(e.length?[]:i,!1),this.select(this.elements.list.filter(s=>this.isShown(s)&&this.replaced(s,e,i))),this.emit("options"),!0)}reveal(t,e){let i=this.character.layout.sections.findIndex(({elements:s})=>s.includes(t.name));i>=0&&!this.within.has(t.name)&&this.show(i),this.levels.shows(t)||(this.levels.toggle(this.levels.coarseOf(t).slice(0,1),!t.inner.length),this.emit("options")),this.select([t],e)}replaced(t,e,i){return e.length?e.some(({inner:s})=>s.includes(t.name)):i.includes(t)}};var tT=64,rc=class{constructor(t,e,i){this.character=t,this.deformer=e,this.rest=i,this.known=new Map,this.peaks=new Map,this.sideways=new Map}peak(t){return oe(this.peaks,t,()=>this.longest(t))}longest(t){let{drive:e,minimum:i,maximum:s}=this.character.controls[t];if(e.joints.length)return this.ofControl(t),this.peaks.get(t);let r=s-i,o=l=>{let c=e.values.slice(1).map((h,u)=>Math.abs((e.weights[u+1][l]-e.weights[u][l])/(h-e.values[u])));return r*Math.max(...c)},a=new Map(e.channels.map((l,c)=>[l,o(c)]));return Math.max(0,...this.character.meshes.flatMap(l=>l.shapes.filter(({channel:c})=>a.has(c)).map(c=>a.get(c.channel)*nT(c)*iT(l.maps))))}sidewaysOf(t,e){return oe(this.sideways,t,()=>{let{minimum:i,maximum:s}=this.character.controls[t],[r,...o]=this.pointsAt(t,[this.rest[t],i,s]);return Math.max(...o.map(a=>eT(r,a,e)))})}isWide(t){if(!this.character.controls[t].drive.joints.length)return!1;let e=this.ofControl(t);return e.filter(i=>i>tT).length>.5*e.length}ofControl(t){return oe(this.known,t,()=>this.measure(t))}ofControls(t){let e=t.map(i=>this.ofControl(i));return e.length===1?e[0]:e[0].map((i,s)=>e.reduce((r,o)=>Math.max(r,o[s]),i))}measure(t){let e=this.character.controls[t],i=[...new Set([e.minimum,e.maximum])].filter(l=>l!==this.rest[t]),[s,...r]=this.pointsAt(t,[this.rest[t],...i]),o=new Float32Array(s.length/3);for(let l of r)for(let c=0,h=0;c<o.length;c++,h+=3)o[c]=Math.max(o[c],Math.hypot(l[h]-s[h],l[h+1]-s[h+1],l[h+2]-s[h+2]));let a=o.reduce((l,c)=>Math.max(l,c),0);return e.drive.joints.length&&this.peaks.set(t,a),Uint8Array.from(o,l=>a>0?Math.round(255*l/a):0)}pointsAt(t,e){let{deformer:i}=this,s=Float64Array.from(this.rest);return e.map(r=>(s[t]=r,i.posedAside(s)))}rank(t,e){let{deformer:i}=this;i.drive(t);let s=this.character.controls.map((o,a)=>{let l=[o.minimum,o.maximum,this.rest[a]],[c,h,u]=l.map(f=>i.withControl(a,t[a],f,e)),d=Math.max(...[[c,u],[h,u],[c,h]].map(([f,p])=>Math.hypot(...ve(f,p))));return{control:a,distance:d}}),r=s.reduce((o,{distance:a})=>Math.max(o,a),0);return s.filter(({distance:o})=>o>.001*r).sort((o,a)=>a.distance-o.distance||o.control-a.control).map(o=>({...o,share:o.distance/r}))}};function eT(n,t,e){let i=0,s=0;for(let r=0;r<n.length;r+=3){let o=[t[r]-n[r],t[r+1]-n[r+1],t[r+2]-n[r+2]];i+=Et(o,e),s+=Math.hypot(...o)}return s>0?Math.abs(i)/s:0}function nT(n){return n.largest??=n.weights.reduce((t,e,i)=>{let s=3*i*n.points.length,r=0;for(let o=s;o<s+3*n.points.length;o+=3)r=Math.max(r,Math.hypot(n.offsets[o],n.offsets[o+1],n.offsets[o+2]));return Math.max(t,r*n.step/Math.abs(e))},0),n.largest}var iT=n=>Math.cbrt(Math.abs(Be.determinant(n)));var sT=new Set(["global","composite"]),oc=class extends sc{constructor(t){super(t),this.rest=this.elements.rest,this.values=Float64Array.from(this.rest),this.influence=new rc(t,this.deformer,this.rest),this.opposites=rT(this.elements.list,this.controls.length),this.twins=oT(this.elements.list,this.opposites),this.locks=new Set,this.pins=[],this.affected=new Map,this.dragging=null}reshape(){this.deformer.pose(this.values),this.elements.follow(this.values,!this.options.follow),this.emit("pose")}set(t){for(let[e,i]of t){this.setOne(e,i);let s=this.twins[e];this.options.symmetric&&s>=0&&this.setOne(s,this.mirrored(e,s))}this.reshape()}setOne(t,e){let{minimum:i,maximum:s}=this.controls[t];!this.locks.has(t)&&Number.isFinite(e)&&(this.values[t]=Vt(e,i,s))}mirrored(t,e,i=this.values){let s=i[t]-this.rest[t],r=(a,l)=>Math.abs(this.controls[a][l]-this.rest[a])||1,o=s<0?"minimum":"maximum";return this.rest[e]+s*r(e,o)/r(t,o)}setOption(t,e){this.options[t]=e,t==="follow"&&this.reshape(),this.emit("options")}flipOption(t){this.setOption(t,!this.options[t])}toggleLock(t){this.locks.delete(t)||this.locks.add(t),this.emit("options")}worded(t,e=this.values[t]){let{minimum:i,maximum:s}=this.controls[t];return ed(e,s-i)}meshOf(t){let e=this.character.meshes,i=e.findIndex(s=>t<s.start+s.count);return[i,t-e[i].start]}tracer(t){return this.deformer.tracer(...this.meshOf(t))}place({corners:t,shares:e}){return{corners:t,shares:e,tracers:t.map(i=>this.tracer(i))}}traced(t){return t.tracers.reduce((e,i,s)=>we(e,ue(this.deformer.trace(i),t.shares[s])),[0,0,0])}shown(t){let{points:e}=this.deformer;return t.corners.reduce((i,s,r)=>we(i,ue(e.subarray(3*s,3*s+3),t.shares[r])),[0,0,0])}addPin(t){let e=this.place(t);this.pins.push({...e,at:this.shown(e)}),this.emit("options")}removePin(t){this.pins=this.pins.filter(e=>e!==t),this.emit("options")}groups(t){return this.besideFreeEnds(this.unlocked(t))}besideFreeEnds(t){let e=new Set(t.flat()),i=r=>!e.has(r)&&this.values[r]!==this.controls[r].default,s=t.filter(r=>!r.some(o=>this.opposites[o].some(i)));return s.length<t.length?this.besideFreeEnds(s):s}unlocked(t){let e=[];for(let i=0;i<this.controls.length;i++){let s=this.options.symmetric?this.twins[i]:-1;if(s>=0&&s<i)continue;let r=s>i?[i,s]:[i];r.some(o=>this.locks.has(o))||this.options.symmetric&&s<0&&this.crosses(i)||(t||!this.isWide(i))&&e.push(r)}return e}isWide(t){return sT.has(this.elements.byControl.get(t)?.category)||this.influence.isWide(t)}crosses(t){return this.influence.sidewaysOf(t,this.character.layout.planeNormal)>.5}};function rT(n,t){let e=Array.from({length:t},()=>[]);for(let{members:i,axes:s}of n)for(let[r,o]of s.filter(a=>a.length===2).map(a=>a.map(l=>i[l].control)))e[r].includes(o)||[e[r],e[o]].forEach((a,l)=>a.push([o,r][l]));return e}function oT(n,t){let e=new Int32Array(t.length).fill(-1),i=new Map(n.map(s=>[s.name,s]));for(let s of n){let r=i.get(s.mirror);!r||r===s||r.members.length!==s.members.length||s.members.forEach(({control:o},a)=>{let l=r.members[a].control;!s.reversed?.includes(a)&&!t[o].includes(l)&&(e[o]=l)})}return e}var ac=class extends oc{constructor(t){super(t),this.animation=new Jl(t,this.rest),this.history=new Ms,this.frame=this.animation.first,this.neutral=!0,this.keys=new Map,this.constants=new Map,this.shelf=[],this.notes=[],this.arrived=this.notes,this.received=[],this.sent=this.notes,this.note=null,this.sound=null,this.given=Float64Array.from(this.rest),this.moved=new Map,this.present=null,this.looks=!1,this.show(0),this.reshape()}leave(){this.compare(!1),this.listeners.clear(),Object.assign(this,{hover:null,dragging:null,affected:new Map})}edit(t,e,i=null){let s=this.beginEdit();e(),this.endEdit(t,s,i)}beginEdit(){let t=this.looks?this.present:null;return t&&Object.assign(this,{present:null,looks:!1}),this.compare(!1),this.emit("editing"),t??Float64Array.from(this.values)}endEdit(t,e,i=null){let s=[...e.keys()].filter(o=>this.values[o]!==e[o]);if(!s.length)return;let r={...this.snapshot(),values:e};this.options.autoKey&&this.setKeys(s),this.step(t,r,i),this.emit("edited")}zero(t=this.controls.keys()){this.settleAt("Zero",[...t],e=>this.controls[e].default)}reset(t=this.controls.keys()){this.settleAt("Reset",[...t],e=>this.rest[e])}settleAt(t,e,i){let s={...this.snapshot(),values:this.beginEdit()};e.length===this.controls.length&&(this.neutral=!0,this.showBase()),this.set(e.map(o=>[o,i(o)]));let r=this.values.some((o,a)=>o!==s.values[a]);!r&&this.neutral===s.neutral||(this.options.autoKey&&r&&this.setKeys(e.filter(o=>!this.locks.has(o))),this.step(t,s),this.emit("edited"))}undo(){return this.history.undo()}redo(){return this.history.redo()}snapshot(){this.looks||this.compare(!1);let{frame:t,neutral:e,keys:i,constants:s,shelf:r,notes:o,sound:a,span:l}=this;return{frame:t,neutral:e,keys:i,constants:s,shelf:r,notes:o,sound:a,span:l,values:Float64Array.from(this.own),given:this.given}}restore({values:t,...e}){this.emit("editing"),Object.assign(this,e,{present:null,looks:!1}),this.values.set(t),this.showBase(),this.reshape(),this.emit("time")}clear(){let t=Float64Array.from(this.rest);this.restore({...this.snapshot(),neutral:!0,keys:new Map,constants:new Map,values:t,given:t})}step(t,e,i=null){let s=this.snapshot();this.history.push(t,()=>this.restore(e),()=>this.restore(s),i,[e,s]),this.emit("changed"),this.emit("time")}changed(){let{own:t,given:e}=this;return[...t.keys()].filter(i=>t[i]!==e[i])}unkeyed(){return this.changed().filter(t=>this.animation.isAnimated(t,this.keys))}go(t,e=!1){this.compare(!1);let i=this.unkeyed(),s=i.length?this.snapshot():null;return this.constants=this.allConstants(),Object.assign(this,{frame:t,neutral:e}),this.given=e?Float64Array.from(this.rest):this.animation.at(t,this).values,this.values.set(this.given),this.showBase(),this.reshape(),s?this.step(`Leave frame ${s.frame} with changes`,s):this.emit("time"),i}allConstants({keys:t,constants:e,values:i,given:s}={...this,values:this.own}){let r=([o,a])=>a!==s[o]&&!this.animation.isAnimated(o,t);return new Map([...e,...[...i.entries()].filter(r)])}key(t){this.record(`Key frame ${this.frame}`,()=>this.setKeys(t))}setKeys(t){let e=i=>this.keys.has(i)?void 0:this.options.interpolation;this.takeKeys(os(this.keys,t.map(i=>[i,[this.frame,this.values[i],e(i)]])),this.constants)}unkey(t){let e=Kr(this.keys,t.map(s=>[s,this.frame])),i=t.filter(s=>e.get(s)?.length!==this.keys.get(s)?.length);return i.length?(this.record(`Delete keys at frame ${this.frame}`,()=>{i.forEach(s=>this.values[s]=this.given[s]),this.takeKeys(e,this.constants)}),!0):!1}rekey(t,e){this.record(t,()=>this.takeKeys(e,this.constants))}put(t,e,i=null){this.record(t,()=>Object.assign(this,e),i)}record(t,e,i=null){let s=this.snapshot();e(),this.step(t,s,i)}get range(){let[t,e]=this.animation.range(this.keys),{start:i,seconds:s}=this.sound??{start:t,seconds:0};return[Math.min(t,i),Math.max(e,Math.ceil(i+s*this.animation.rate))]}get span(){return this.animation.span}set span(t){this.animation.span=t}respan(t,e){return!this.animation.isFree||!(Number.isInteger(t)&&Number.isInteger(e)&&t<e)?!1:(this.put("Set the frames",{span:[t,e]}),!0)}copy(){return this.copied=new Map(this.chosenControls.map(t=>[t,this.values[t]])),this.copied}paste(){this.copied&&this.asWritten("Paste the pose",this.copied)}flip(){this.asWritten("Flip the pose",Tg({...this.sides,crosses:t=>this.crosses(t)}))}mirror(t){this.asWritten(`Mirror the ${t}`,Cg(t,this.sides))}tween(t){let e=Eg(this.keys,this.chosenControls,this.frame,t);return e.length&&this.edit("Tween",()=>this.set(e),"tween"),e.length>0}get sides(){let t=Float64Array.from(this.values),{controls:e,rest:i,twins:s,opposites:r}=this;return{values:t,controls:e,rest:i,twins:s,opposites:r,sideOf:l=>this.elements.byControl.get(l)?.side,mirrored:(l,c)=>this.mirrored(l,c,t)}}asWritten(t,e){let{symmetric:i}=this.options;this.options.symmetric=!1,this.edit(t,()=>this.set(e)),this.options.symmetric=i}load(t,e,i){let s=[...e.values()].map(([[r]])=>r);this.record(t,()=>{s.length&&(this.frame=Math.min(...s)),this.given=Float64Array.from(this.values),this.takeKeys(e,i)})}takeKeys(t,e){this.compare(!1);let i=this.changed().map(s=>[s,this.values[s]]);Object.assign(this,{keys:t,constants:e,neutral:!1}),this.given=this.animation.at(this.frame,this).values,this.values.set(this.given);for(let[s,r]of i)this.values[s]=r;this.showBase(),this.reshape()}rebase(t){this.compare(!1);for(let s of this.history.states)Object.assign(s,this.rebased(s,t));let{values:e,...i}=this.rebased(this.snapshot(),t);Object.assign(this,i),this.values.set(e),this.reshape(),this.emit("time")}rebased(t,e){let i={keys:t.keys,constants:this.allConstants(t),span:t.span},s=e(i),[r,o]=[i,s].map(u=>this.animation.at(t.frame,u).values),a=u=>t.values[u]!==t.given[u]&&this.animation.isAnimated(u,t.keys),l=u=>r[u]!==o[u],c=t.given.map((u,d)=>l(d)?o[d]:u),h=t.values.map((u,d)=>l(d)&&!a(d)?o[d]:u);return{...t,...s,given:c,values:h}}compare(t){if(t===!!this.present)return;t&&this.emit("editing");let e=t?this.given:this.present;this.present=t?Float64Array.from(this.values):null,this.looks=!1,this.values.set(e),this.reshape()}get own(){return this.present??this.values}adopt(){this.edit("Take the pose of a note",()=>{})}look(t){this.compare(!1),!t.every((e,i)=>e===this.values[i])&&(this.present=Float64Array.from(this.values),this.looks=!0,this.values.set(t),this.reshape())}relayout(){this.showBase(),this.reshape(),this.emit("layout"),this.emit("changed")}atFrame(t,e){let{values:i,weights:s,locals:r}=this.animation.at(t,{keys:this.keys,constants:this.allConstants()});this.deformer.setBase(s,r);let o=e(i);return this.showBase(),this.deformer.drive(this.values),o}showBase(){let{weights:t,locals:e}=this.neutral?{weights:null,locals:null}:this.animation.clipAt(this.frame);this.deformer.setBase(t,e)}};var Zr={mouse:8,touch:22},Uu=60,Qs=14,aT="http://www.w3.org/2000/svg",cc=class{constructor(t){this.sheet=t,this.size=[0,0],this.node=Zn("svg",{class:"curves",role:"img","aria-label":"Curves"}),this.node.addEventListener("pointerdown",e=>this.press(e)),new ResizeObserver(()=>this.sheet.shows==="curves"&&!this.sheet.node.hidden&&this.draw()).observe(this.node)}get session(){return this.sheet.session}get controls(){let t=[...this.sheet.keys.keys()],e=new Set(this.session.selection.size?this.session.chosenControls:[]),i=t.filter(s=>e.has(s));return i.length?i:t}draw(){let{clientWidth:t,clientHeight:e}=this.node;!this.sheet.scale||!t||(this.size=[t,e],this.node.replaceChildren(...[0,.5,1].flatMap(i=>this.level(i)),...ku(this.sheet.scale,t/Uu).flatMap(i=>[Zn("line",{class:"curve-grid",x1:this.x(i),x2:this.x(i),y1:0,y2:e}),lc(i,{class:"curve-number",x:this.x(i)+3,y:e-2})]),...this.tangents.flatMap(({from:i,at:s})=>[Zn("polyline",{class:"curve-tangent",points:`${i} ${s}`}),Zn("circle",{class:"curve-tangent",cx:s[0],cy:s[1],r:3.5})]),...this.controls.flatMap(i=>this.curve(i)),Zn("line",{class:"curve-now",y1:0,y2:e}),...this.band()),this.moveNow())}moveNow(){let t=this.node.querySelector(".curve-now"),e=this.size?this.x(this.session.frame):0;t&&ti(t,{x1:e,x2:e})}level(t){let e=this.controls.map(r=>this.session.controls[r]),i=({minimum:r,maximum:o})=>Number((r+t*(o-r)).toPrecision(3)),s=e.length>1?`${100*t} %`:e.map(i).join();return[Zn("line",{class:"curve-grid",x1:0,x2:this.size[0],y1:this.y(t),y2:this.y(t)}),lc(s,{class:"curve-number",x:2,y:this.y(t)-2})]}curve(t){let{session:e,sheet:i}=this,s=i.keys.get(t),r=e.colours[e.elements.byControl.get(t)?.side??"none"],{label:o}=e.controls[t],[[a],[l]]=[s[0],s.at(-1)],h=Ee([...s.map(([f])=>f),...io(s),...Dg(a,l)]).map(f=>this.place(t,f,Nu(s,f,null)).join()),u=this.place(t,l,s.at(-1)[1]),d=u[0]>this.size[0]-120;return[Zn("polyline",{class:"curve",points:h.join(" "),stroke:r}),...s.map(([f,p])=>this.keyMark(t,f,p,r,o)),lc(o,{class:"curve-name",x:u[0]+(d?-8:8),y:Math.max(12,u[1]-6),"text-anchor":d?"end":"start"})]}keyMark(t,e,i,s,r){let[o,a]=this.place(t,e,i),l=this.sheet.isPicked(t,e),c=Zn("circle",{class:l?"curve-key on":"curve-key",cx:o,cy:a,r:4.5,fill:l?"#fff":s});return c.append(lc(`${r}, frame ${e}: ${i.toFixed(3)}`,{},"title")),c}x(t){let[e,i]=this.sheet.scale;return Qs+(t-e)/(i-e)*(this.size[0]-2*Qs)}y(t){return this.size[1]-Qs-t*(this.size[1]-2*Qs)}get framesPerPixel(){return(this.sheet.scale[1]-this.sheet.scale[0])/(this.size[0]-2*Qs)}valuePerPixel(t){let{minimum:e,maximum:i}=this.session.controls[t];return(i-e)/(this.size[1]-2*Qs)}place(t,e,i){let{minimum:s,maximum:r}=this.session.controls[t];return[this.x(e),this.y((i-s)/(r-s))]}get shown(){return this.controls.flatMap(t=>this.sheet.keys.get(t).map(([e,i])=>({key:[t,e],at:this.place(t,e,i)})))}nearest(t,e){let i=({at:s})=>Math.hypot(s[0]-t[0],s[1]-t[1]);return[...this.shown,...this.tangents].filter(s=>i(s)<=e).sort((s,r)=>i(s)-i(r))[0]}get tangents(){return this.controls.flatMap(t=>this.sheet.keys.get(t).flatMap(([e,i],s,r)=>[s-1,s].filter(a=>this.sheet.isPicked(t,e)&&r[a+1]&&rn(r[a]??[])==="smooth").map(a=>{let l=(a<s?-1:1)*(r[a+1][0]-r[a][0])/3,c=this.place(t,e+l,i+l*xc(r,s));return{control:t,key:r[s],reach:l,from:this.place(t,e,i),at:c}})))}press(t){if(t.button||!this.size)return;let e=this.node.getBoundingClientRect(),i=[t.clientX-e.left,t.clientY-e.top],s=this.nearest(i,t.pointerType==="touch"?Zr.touch:Zr.mouse);s?.from?this.bending(t,s):s?this.moving(t,s.key):this.ranging(t,e,i),this.sheet.node.focus({preventScroll:!0}),t.preventDefault()}moving(t,e){let{sheet:i}=this;i.pick([e],t.shiftKey),i.draw(),i.dragging(t,s=>{let[r,o]=[s.clientX-t.clientX,s.clientY-t.clientY],a=s.shiftKey&&Math.abs(o)>Math.abs(r),l=a?0:Math.round(r*this.framesPerPixel),c=s.shiftKey&&!a?0:-o,h=jl(l,e[1],s.altKey?i.span:null);return l||c?([u,d],f)=>[h(u),d+c*this.valuePerPixel(f)]:null})}bending(t,{control:e,key:i,from:s,at:r}){let{sheet:o,session:a}=this,[l,c]=i,{minimum:h,maximum:u}=a.controls[e],d=this.tangents.filter(m=>m.key===i).map(m=>m.reach),f=(m,g)=>(Vt(c+m*g,h,u)-c)/g,p=Math.sign(r[0]-s[0]),{keys:x}=a;o.follow(t,m=>{let[g,_]=[p*(r[0]-s[0]+m.clientX-t.clientX),s[1]-r[1]+t.clientY-m.clientY],w=p*_*this.valuePerPixel(e)/(Math.max(1,g)*this.framesPerPixel);x=os(a.keys,[[e,[l,c,rn(i),Fn(d.reduce(f,w))]]]),o.preview={keys:x,picked:o.picked},o.draw()},()=>x===a.keys||a.rekey("Bend a curve",x))}ranging(t,e,i){let{sheet:s}=this;s.selecting(t,r=>{let o=[r.clientX-e.left,r.clientY-e.top],[a,l]=[Math.min,Math.max].map(c=>[0,1].map(h=>c(i[h],o[h])));return s.range={controls:[],frames:[],corners:[a,l]},this.shown.filter(({at:c})=>c.every((h,u)=>h>=a[u]&&h<=l[u])).map(({key:c})=>c)})}band(){let[t,e]=this.sheet.range?.corners??[];return t?[Zn("rect",{class:"curve-band",x:t[0],y:t[1],width:e[0]-t[0],height:e[1]-t[1]})]:[]}};function ku([n,t],e){let i=Math.max(1,(t-n)/Math.max(1,e)),s=10**Math.floor(Math.log10(i)),r=s*([1,2,5].find(o=>o*s>=i)??10);return[...Dg(n/r,t/r)].map(o=>o*r)}function*Dg(n,t){for(let e=Math.ceil(n);e<=t;e++)yield e}function Zn(n,t){let e=document.createElementNS(aT,n);return ti(e,t),e}function lc(n,t,e="text"){let i=Zn(e,t);return i.textContent=n,i}var lT={linear:"dope-key",smooth:"dope-key round",stepped:"dope-key square"},hc=class{constructor(t,e,i){this.session=t,this.say=e,this.sound=i,this.picked=new Set,this.preview=null,this.copied=null,this.rows=[],this.range=null,this.shows="rows",this.body=U("div",{class:"dope-rows",onpointerdown:s=>this.press(s)}),this.curves=new cc(this),this.node=U("section",{class:"dope",hidden:!0,tabIndex:0,"aria-label":"Keys",onkeydown:s=>this.key(s)},this.makeHead(),this.body,this.curves.node),t.on("time",()=>this.update()),t.on("selection",()=>this.update()),t.on("options",()=>this.head.update())}toggle(t=this.node.hidden){this.node.hidden=!t,this.update()}get pickedKeys(){return[...this.picked].map(t=>t.split(" ").map(Number))}get keys(){return this.preview?.keys??this.session.keys}isPicked(t,e){return(this.preview??this).picked.has(`${t} ${e}`)}get span(){let t=this.pickedKeys.map(([,s])=>s),[e,i]=[Math.min(...t),Math.max(...t)];return e<i?[e,i]:null}makeHead(){let t=yi("Keys as",[["rows","Rows","All keys in rows"],["curves","Curves","The curves of the selected controls, or of all that have keys"]],()=>this.shows,r=>{this.shows=r,this.update()}),e=yi("How keys go to the next",eo.map(r=>[r,cs(r),`${cs(r)}: the picked keys, or all, and the first key of a control from now on`]),()=>this.way,r=>this.go(r)),i=U("output",{class:"hint"}),s=r=>r.detail&&this.node.focus({preventScroll:!0});return this.head=U("div",{class:"dope-head",onclick:s},t,e,vt("Copy","Copy the picked keys (Ctrl+C)",()=>this.copy()),vt("Paste","Paste the copied keys from this frame on (Ctrl+V)",()=>this.paste()),vt("Reverse","Turn the picked keys round in time",()=>this.reverse()),vt("Delete","Delete the picked keys (Delete)",()=>this.remove()),i),this.head.update=()=>{t.update(),e.update(),i.textContent=this.counted()},this.head.update(),this.head}get way(){let t=new Set(this.pickedKeys.map(([e,i])=>rn(this.session.keys.get(e).find(([s])=>s===i))));return t.size?t.size>1?null:[...t][0]:this.session.options.interpolation}counted(){if(!this.picked.size)return"Drag a key to move it (Alt scales those picked), an empty place to pick a range";let t=this.span?`frames ${this.span.join(" to ")}`:`frame ${this.pickedKeys[0][1]}`;return`${he(this.picked.size,"key")} picked, ${t}`}update(){if(this.node.hidden)return;let{session:t}=this;if(this.shown===t.keys&&this.heard===t.sound&&!this.preview&&!this.range&&this.moveNow())return;this.shown=t.keys,this.heard=t.sound,this.scale=t.range;let e=this.picked;this.picked=new Set(this.everyKey.map(i=>i.join(" ")).filter(i=>e.has(i))),this.draw()}get asked(){return[...this.picked,this.shows,...this.session.selection].join()}moveNow(){if(this.look!==this.asked)return!1;for(let t of this.body.querySelectorAll(".dope-now"))t.style.left=this.along(this.session.frame);return this.curves.moveNow(),!0}draw(){let{session:t}=this;if(t.emit("picked"),this.look=this.asked,this.body.hidden=this.shows!=="rows",this.curves.node.style.display=this.shows==="curves"?"":"none",this.head.update(),this.shows==="curves")return this.curves.draw();let e=[...this.keys];this.rows=[{name:"All",controls:e.map(([s])=>s)},...e.map(([s])=>({name:t.controls[s].label,controls:[s]}))];let i=be("No keys yet: K keys what is selected or changed, Auto-key every drag.");return this.body.replaceChildren(this.ruler(),...this.waveRow(),...e.length?this.rows.map(s=>this.row(s)):[i])}ruler(){let e=ku(this.scale,this.body.clientWidth/Uu).map(i=>U("i",{style:{left:this.along(i)}},String(i)));return U("div",{class:"dope-row","aria-hidden":"true"},U("span"),U("div",{class:"dope-ruler"},...e))}waveRow(){if(!this.sound.isReady)return[];let t=U("div",{class:"dope-wave"},this.sound.wave(this.scale[0],this.scale[1],36));return[U("div",{class:"dope-row heard"},U("span",{},this.sound.name),t)]}row({name:t,controls:e}){let i=new Map;for(let o of e)for(let a of this.keys.get(o))oe(i,a[0],()=>[]).push([o,a]);let s=[...i].map(([o,a])=>this.mark(t,o,a)),r=U("i",{class:"dope-now",style:{left:this.along(this.session.frame)}});return U("div",{class:"dope-row"},U("span",{title:t},t),U("div",{class:"dope-line"},...this.band(e),...s,r))}band(t){let{range:e}=this;if(!e||!t.some(r=>e.controls.includes(r)))return[];let[i,s]=e.frames.map(r=>this.along(r));return[U("i",{class:"dope-band",style:{left:i,width:`calc(${s} - ${i})`}})]}along(t){return ls(t,this.scale)}mark(t,e,i){let s=i.every(([a])=>this.isPicked(a,e)),r=rn(i[0][1]),o=`${t}, frame ${e}${r==="linear"?"":`, ${r}`}`;return U("button",{type:"button",class:lT[r],tabIndex:-1,style:{left:this.along(e)},title:o,"aria-label":o,"aria-pressed":String(s)})}at({clientX:t,clientY:e}){let s=[...this.body.querySelectorAll(".dope-line")].map(h=>h.getBoundingClientRect()),r=s.findIndex(({bottom:h})=>e<=h),o=r<0?s.length-1:r,[a,l]=this.scale,c=(l-a)/s[o].width;return{row:o,frame:a+(t-s[o].left)*c,perPixel:c}}press(t){if(t.button||!this.session.keys.size)return;let e=this.at(t),{controls:i}=this.rows[e.row],s=e.perPixel*(t.pointerType==="touch"?Zr.touch:Zr.mouse),r=Ql(this.session.keys,i,[e.frame-s,e.frame+s]),o=r.reduce((l,[,c])=>Math.abs(c-e.frame)<Math.abs(l-e.frame)?c:l,1/0),a=r.filter(([,l])=>l===o);a.length?this.moving(t,e,a):this.ranging(t,e),this.node.focus({preventScroll:!0}),t.preventDefault()}pick(t,e){let i=t.map(s=>s.join(" "));!e&&!i.every(s=>this.picked.has(s))&&this.picked.clear(),i.forEach(s=>this.picked.add(s))}moving(t,e,i){this.pick(i,t.shiftKey),this.draw(),this.dragging(t,s=>{let r=Math.round((s.clientX-t.clientX)*e.perPixel),o=jl(r,i[0][1],s.altKey?this.span:null);return r?([a,l])=>[o(a),l]:null})}dragging(t,e){let i=s=>s.ctrlKey||s.metaKey;this.follow(t,s=>{let r=e(s);this.preview=r&&this.changed(r,i(s)),this.draw()},s=>{let r=e(s);r&&this.change(i(s)?"Copy":s.altKey?"Scale":"Move",r,i(s))})}ranging(t,e){this.selecting(t,i=>{let s=this.at(i),r=this.rows.slice(Math.min(e.row,s.row),Math.max(e.row,s.row)+1).flatMap(a=>a.controls),o=[Math.min(e.frame,s.frame),Math.max(e.frame,s.frame)];return this.range={controls:r,frames:o},Ql(this.session.keys,r,o)})}selecting(t,e){let i=t.shiftKey?[...this.picked]:[],s=r=>{this.picked=new Set([...i,...r.map(o=>o.join(" "))]),this.draw()};this.follow(t,r=>s(e(r)),()=>{}),s([])}follow(t,e,i){let s=new AbortController,r=l=>c=>c.pointerId===t.pointerId&&l(c),o=l=>r(c=>{s.abort(),Object.assign(this,{preview:null,range:null}),l(c),this.draw()}),{signal:a}=s;window.addEventListener("pointermove",r(e),{signal:a}),window.addEventListener("pointerup",o(i),{signal:a}),window.addEventListener("pointercancel",o(()=>{}),{signal:a})}key(t){let e={ArrowLeft:-1,ArrowRight:1},i=t.ctrlKey||t.metaKey;if(t.key==="Delete"||t.key==="Backspace")this.remove();else if(e[t.key]&&this.picked.size)this.change(i?"Copy":"Move",([s,r])=>[s+e[t.key]*(t.shiftKey?10:1),r],i);else if(i&&t.key==="a")this.pick(this.everyKey,!0);else if(i&&t.key==="c"&&this.picked.size)this.copy();else if(i&&t.key==="v"&&this.copied)this.paste();else if(t.key==="Escape"&&this.picked.size)this.picked.clear();else return;this.draw(),t.preventDefault(),t.stopPropagation()}get everyKey(){return Ql(this.session.keys,[...this.session.keys.keys()])}changed(t,e){let{keys:i,controls:s}=this.session;return bg(i,this.pickedKeys,(r,o)=>{let[a,l]=t(r,o);return[a,Vt(l,s[o].minimum,s[o].maximum)]},e)}change(t,e,i=!1){let s=`${t} ${he(this.picked.size,"key")}`,{keys:r,picked:o}=this.changed(e,i);this.picked=o,this.session.rekey(s,r)}reverse(){let{span:t}=this;t?this.change("Reverse",([e,i])=>[t[0]+t[1]-e,i]):this.say("No range of keys is picked")}remove(){let t=this.pickedKeys;t.length?this.session.rekey(`Delete ${he(t.length,"key")}`,Kr(this.session.keys,t)):this.say("No key is picked")}copy(){this.picked.size&&(this.copied=Sg(this.session.keys,this.pickedKeys)),this.say(this.picked.size?`${he(this.copied.length,"key")} copied`:"No key is picked")}paste(){let{session:t,copied:e}=this;return e?(this.picked=new Set(e.map(([i,[s]])=>`${i} ${t.frame+s}`)),t.rekey(`Paste ${he(e.length,"key")}`,Ag(t.keys,e,t.frame))):this.say("No key is copied")}go(t){let{session:e}=this,i=this.pickedKeys.length?this.pickedKeys:this.everyKey;this.picked.size||e.setOption("interpolation",t),i.length&&e.rekey(`${cs(t)}: ${he(i.length,"key")}`,wg(t,e.keys,i)),this.draw()}};var cT=.08,hT=300,Bu=1200,uc=class{constructor(t){this.session=t,this.context=null,this.buffer=null,this.source=null,this.waves=new Map}get rate(){return this.session.animation.rate}get start(){return this.session.sound.start}get isReady(){return!!this.buffer&&this.session.sound?.name===this.name}async read(t){this.context??=new AudioContext;try{this.buffer=await this.context.decodeAudioData(await t.arrayBuffer())}catch{throw new Error(`This browser cannot read ${t.name} as sound.`)}this.name=t.name,this.waves.clear();let{session:e}=this,i=e.sound?.name===t.name?e.sound.start:e.animation.first;e.put(`Open ${t.name}`,{sound:{name:t.name,start:i,seconds:this.buffer.duration}},"sound")}async play(t){let e=this.isReady&&await this.opened();return e?(this.from(t),()=>e.currentTime-(e.outputLatency||0)):()=>performance.now()/1e3}async opened(){let{context:t}=this;return t.state!=="running"&&await Promise.race([t.resume(),new Promise(e=>setTimeout(e,hT))]),t.state==="running"?t:null}from(t,e=1/0){if(this.stop(),!this.isReady)return;let{context:i,buffer:s}=this,{delay:r,offset:o}=uT(t,this.start,this.rate);o>=s.duration||(this.source=new AudioBufferSourceNode(i,{buffer:s}),this.source.connect(i.destination),this.source.start(i.currentTime+r,o,Math.min(e,s.duration-o)))}blip(t){this.isReady&&this.context.state==="running"&&t>=this.start&&this.from(t,cT)}stop(){this.source?.stop(),this.source=null}wave(t,e,i=30){let s=[t,e,i,this.start].join();return oe(this.waves,s,()=>this.drawn(t,e,i))}drawn(t,e,i){let s=U("canvas",{class:"wave",width:Bu,height:i,"aria-hidden":"true"}),r=s.getContext("2d"),{buffer:o,rate:a}=this,l=u=>(t+u/Bu*(e-t)-this.start)/a,c=dT(o.getChannelData(0),o.sampleRate,Array.from({length:Bu+1},(u,d)=>l(d))),h=Math.max(...c,1e-6);return r.fillStyle="#6f8fb3",c.forEach((u,d)=>r.fillRect(d,i/2*(1-u/h),1,i*u/h)),s}};function uT(n,t,e){let i=(n-t)/e;return{delay:Math.max(0,-i),offset:Math.max(0,i)}}function dT(n,t,e){return e.slice(1).map((i,s)=>{let r=0,[o,a]=[Math.max(0,Math.floor(e[s]*t)),Math.min(n.length,Math.ceil(i*t))];for(let l=o;l<a;l++)r=Math.max(r,Math.abs(n[l]));return r})}var dc=class{ends;constructor(t,e){this.session=t,this.say=e,this.rate=t.animation.rate,this.playing=!1,this.sound=new uc(t),this.sheet=new hc(t,e,this.sound),this.node=this.build(),t.on("editing",()=>this.stop()),t.on("time",()=>this.update()),t.on("options",()=>this.update()),this.update()}get frame(){return this.session.frame}build(){this.playButton=vt("▶","Play or stop (Space); picked keys: between the first and the last of them",()=>this.toggle(),{class:"play"}),this.autoButton=kn("Auto-key","Every drag sets keys at this frame",()=>this.session.options.autoKey,()=>this.session.flipOption("autoKey")),this.sheetButton=kn("Keys","All keys in rows: drag moves them, Ctrl-drag copies, Delete takes them away (D)",()=>!this.sheet.node.hidden,()=>this.openSheet()),this.slider=U("input",{type:"range",step:1,"aria-label":"Frame",oninput:()=>{this.go(Number(this.slider.value)),this.sound.blip(this.frame)}}),this.ticks=U("div",{class:"ticks","aria-hidden":"true"}),this.waves=U("div",{class:"waves","aria-hidden":"true"}),this.soundButton=vt("Sound…","",()=>this.openSound()),this.soundStart=U("input",{type:"number",class:"sound-start",title:"The frame at which the sound begins","aria-label":"The frame at which the sound begins",onchange:()=>this.session.put("Move the sound",{sound:{...this.session.sound,start:Math.round(Number(this.soundStart.value))}},"sound")});let t=(e,i)=>U("input",{type:"number",class:"span-end",title:e,"aria-label":e,onchange:()=>this.setSpan(i)});return this.ends=["First frame","Last frame"].map(t),this.number=U("output",{class:"frame"}),this.unkeyed=U("output",{class:"unkeyed",title:"Changed here and not keyed: they end with this frame. K keys them."}),U("footer",{class:"timeline","aria-label":"Time"},this.playButton,vt("‹","Previous key, or the frame before where there is none",()=>this.step(-1)),vt("›","Next key, or the frame after where there is none",()=>this.step(1)),this.number,this.unkeyed,this.ends[0],U("div",{class:"scrub"},this.waves,this.ticks,this.slider),this.ends[1],vt("Delete key","Take away the keys of the selected controls, or all keys, at this frame",()=>this.unkey()),this.autoButton,this.tween(),this.sheetButton,this.soundButton,this.soundStart,vt("Save animation layer","Download the keys over the clip as a USD layer",()=>this.save()))}update(){let{session:t}=this,{range:e}=t,[i,s]=e;this.number.textContent=t.neutral&&t.animation.clip?.times.length>1?"neutral":`${this.frame}`,this.number.title=t.neutral?"The pose of the layout; the time line shows the animation":"Frame",Object.assign(this.slider,{min:i,max:s,value:this.frame}),this.ends.forEach((l,c)=>{l.hidden=!t.animation.isFree,document.activeElement!==l&&(l.value=String(e[c]))}),this.slider.style.setProperty("--at",ls(this.frame,e)),this.playButton.textContent=this.playing?"■":"▶";let r=t.unkeyed().length;this.unkeyed.textContent=r?`${r} not keyed`:"",this.autoButton.update(),this.showSound(i,s);let o=new Set(t.notes.filter(({neutral:l})=>!l).map(({frame:l})=>l)),a=l=>c=>U("i",{class:l,style:{left:ls(c,e)}});this.ticks.replaceChildren(...this.keyFrames().map(a("")),...[...o].map(a("noted")))}setSpan(t){let e=this.session.range,i=this.ends.map(r=>Math.round(Number(r.value))),s=e[1]-e[0];i[0]>=i[1]&&(i[1-t]=i[t]+(t?-s:s)),this.session.respan(i[0],i[1])||this.say("A frame is a whole number"),this.ends.forEach((r,o)=>r.value=String(this.session.range[o]))}showSound(t,e){let{sound:i,session:s}=this,{name:r,start:o}=s.sound??{},a=i.isReady;this.soundButton.textContent=r?a?Og(r):`Open ${Og(r)} again`:"Sound…",this.soundButton.title=r?`${r}: open it again, or another`:"Open a sound of your disk; it is played in step with the frames and sent nowhere",this.soundStart.hidden=!r,r&&(this.soundStart.value=o);let l=a?i.wave(t,e):null;this.waves.firstChild!==l&&this.waves.replaceChildren(...l?[l]:[])}openSound(){return _i("audio/*,.wav,.mp3,.ogg,.m4a,.flac",this.say,({file:t})=>this.sound.read(t))}openSheet(t){this.sheet.toggle(t),this.sheetButton.update()}tween(){let t=U("input",{type:"range",class:"tween",min:-25,max:125,value:50,title:"Tween: between the keys before and after, and a little beyond","aria-label":"Tween between the keys before and after",oninput:()=>this.session.tween(Number(t.value)/100)||this.say("No control here has a key before and one after"),onchange:()=>t.value="50"});return t}keyFrames(){return Ee(this.sheet.everyKey.map(([,t])=>t))}key(){this.session.looks&&this.session.adopt();let t=[...new Set([...this.chosen([]),...this.session.changed()])];t.length?this.session.key(t):this.say("Nothing to key: select a control or change one")}unkey(){let t=this.chosen([...this.session.keys.keys()]);this.session.unkey(t)||this.say(`No key at frame ${this.frame}`)}chosen(t){return this.session.selection.size?this.session.chosenControls:t}step(t){let e=this.keyFrames(),[i,s]=this.session.range,r=t>0?e.find(o=>o>this.frame):e.findLast(o=>o<this.frame);this.go(r??Vt(this.frame+t,i,s))}go(t,e=!1){let i=this.frame,s=this.session.go(t,e);s.length&&this.say(`${Fg(this.session,s)} of frame ${i} not keyed and left behind · Ctrl+Z goes back`)}toggle(){this.playing?this.stop():this.play()}stop(){this.playing&&(this.playing=!1,this.sound.stop(),this.update())}get played(){return(this.sheet.node.hidden?null:this.sheet.span)??this.session.range}async play(){let[t,e]=this.played,i=this.frame<t||this.frame>=e;(this.session.neutral||i)&&this.go(i?t:this.frame),this.playing=!0,this.update();let s=await this.sound.play(this.frame);if(!this.playing)return this.sound.stop();let r=s()-(this.frame-t)/this.rate,o=e-t+1,a=()=>{if(!this.playing)return;let l=t+Math.floor(Math.max(0,s()-r)*this.rate)%o;l<this.frame&&this.sound.from(l),l!==this.frame&&this.go(l),requestAnimationFrame(a)};return requestAnimationFrame(a)}save(){let{session:t}=this,{text:e,unwritten:i}=tf(t);if(!e){this.say("Nothing is keyed and no pose is set: there is no animation to save");return}let s=t.fileNamed("animation.usda");An(s,e),t.emit("saved");let r=t.unkeyed(),o=[`Saved ${s}, keys at ${he(this.keyFrames().length,"frame")}`,r.length?`Not keyed and not in it: ${Fg(t,r)} of frame ${this.frame}`:"",i.length?`No animation drives ${i.join(", ")}`:"",t.animation.clip?.thinned?"The clip was too long to show whole: the layer holds the frames kept":""].filter(Boolean);this.say(o.join(" · "))}},Og=n=>n.length>18?`${n.slice(0,8)}…${n.slice(-8)}`:n;function Fg({controls:n},t){return t.length===1?n[t[0]].label:`${t.length} changes`}var fT=16,pT=600,fc=class{ways=[];made=[];constructor(t,e,i){this.session=t,this.view=e,this.timeline=i,e.trails=this;for(let s of["time","picked"])t.on(s,()=>t.options.trails&&e.changed("overlay"));t.on("layout",()=>this.made=[])}shown(){let{session:t,view:e}=this;if(!t.options.trails||t.trial||!e.controlsColumn)return[];this.renew();let i=e.camera.projector(e.controlsColumn);return this.ways.map(({element:s,places:r})=>({colour:t.colours[s.side],places:r.map(({handle:o,origin:a,...l})=>({...l,at:e.overlay.mapOf(s,i,a)(o)}))}))}renew(){let{session:t}=this,e=t.selectedElements.filter(o=>!o.onBoard&&t.isShown(o)).slice(0,fT);if(t.dragging&&wn(e,this.ways.map(({element:o})=>o)))return;let[i,s]=this.timeline.played,r=[...e,t.keys,[...t.allConstants()].join(),i,s,t.options.follow];wn(r,this.made)||(this.made=r,this.ways=this.placed(e,i,s))}placed(t,e,i){let{session:s}=this,r=t.map(({members:u})=>new Set(u.flatMap(({control:d})=>(s.keys.get(d)??[]).map(([f])=>f)))),o=Math.ceil((i-e+1)*t.length/pT)||1,a=Array.from({length:Math.floor((i-e)/o)+1},(u,d)=>e+d*o),l=r.flatMap(u=>[...u]).filter(u=>u>=e&&u<=i),c=u=>s.elements.follow(u,!s.options.follow,t),h=Ee([...a,...l,i]).map(u=>s.atFrame(u,d=>(c(d),t.map(({handle:f,origin:p},x)=>({frame:u,isKey:r[x].has(u),handle:f,origin:p})))));return c(s.values),t.map((u,d)=>({element:u,places:h.map(f=>f[d])}))}};var mT=new Set(["Ctrl+z","Ctrl+Shift+z","Ctrl+y","Escape"]),Ug="string pose = ",gT=320,kg=1200,xT=[["Drag a handle","its control; Ctrl for fine steps"],["Touch","one finger drags, two pan, pinch and turn; handles under one finger move apart, a fan of them around it: touch one of these"],["Drag the skin","best fit of the controls that act there"],["Drag empty space, Alt-drag","orbit; right or middle button pans, wheel zooms"],["Click the skin","list what acts there"],["Shift-click","add to the selection; on skin: pin (or rest a finger there)"],["Shift-drag","select handles in a box"],["Double-click a handle","reset it"],["Tab, arrow keys","go through the handles, and move them (Shift: more, Ctrl: less)"],["S  H  L","symmetry, show or hide handles, all labels"],["Hold H, B, I","hide all elements, show the pose before, show what the selection moves"],["C  P  N","the list of controls, the panel, the notes of a review"],["Double-click the skin","look at a region closely, and back"],["M","open the selected coarse element into its members, or close it"],["0  R","zero, reset the selection"],["K","key the selection and all that changed"],["1  2  3  4  F  V","front, three-quarter, side, back; F: closer, on the face or the selection, and back; V: as the shot's camera"],["Space","play"],["D","all keys in rows or as curves: drag moves (Ctrl: copies, Alt: scales those picked), a drag from an empty place picks, Space plays these, Delete takes away"],["O  T","onion skin: the keys before and after as outlines; motion trails of the selected handles on the face, a dot for each key"],["Ctrl+C, Ctrl+V","copy and paste the pose of the selection, or of all"],["/  ?","search, these gestures and keys"],["Ctrl+Z, Ctrl+Shift+Z","undo, redo"],["Esc","cancel the drag, clear the selection"]],zu=class{view;timeline;list;inspector;review;evaluation;constructor(t){this.tell=i=>this.say(i),this.scene=t,this.node=document.getElementById("app"),this.notice=U("div",{class:"notice",role:"status",hidden:!0}),this.offer=U("div",{class:"offer",role:"alertdialog","aria-label":"Work from before",hidden:!0}),this.storage=Mf(),this.kept=t.characters.map(()=>null),this.roots=t.characters.map(({root:i})=>i);let e=vT();this.reviews=e.filter(i=>!i.includes(Ug)).flatMap(i=>uo(i)),this.targets=e.filter(i=>i.includes(Ug)),this.live=this.makeLive(),this.open(0),this.live?.run();for(let i of["pagehide","beforeunload"])window.addEventListener(i,s=>this.leave(s));dg(this.shortcuts(),{h:i=>this.view.hold("bare",i),b:i=>this.session.looks||this.session.compare(i),i:i=>this.view.hold("showsInfluence",i)},i=>this.session.trial&&!mT.has(i))}open(t){this.evaluation?.running&&this.evaluation.finish(),this.timeline?.stop(),this.kept[this.index]?.autosave.flush(),this.session?.leave(),this.index=t;let{session:e,autosave:i}=this.kept[t]??=this.begin(this.scene.characters[t]);this.session=e,this.live?.follow(e),i.listen(()=>this.say("This browser has no room to keep your work: save it before you close the page")),this.view=new ql(this.session,this.sessions.filter(r=>r!==e),this.tell),this.timeline=new dc(this.session,this.tell),this.trails=new fc(this.session,this.view,this.timeline),this.list=new Po(this.session,this.view),this.inspector=new $l(this.session,this.view,this.timeline,this.tell),this.review=new Zl(this.session,this.view,this.timeline,this.tell,this.roots,()=>this.reviewed()),this.evaluation=new Do(this),this.stops=new Yl(this.session,this.view),this.help=this.makeHelp(),this.view.node.append(this.evaluation.panel,this.help,this.offer,this.notice);let s=U("div",{class:"middle"},this.view.node,this.list.node,this.inspector.node,this.review.node);this.node.replaceChildren(s,new Lo(this).node,this.timeline.sheet.node,this.timeline.node),this.node.className="ready",this.fold("list",!1),this.fold("review",this.session.arrived.length>0),this.fold("inspector",window.innerWidth>=kg&&!this.session.arrived.length),this.offerWork(i)}begin(t){let e=new ac(t);e.notes=e.arrived=ho(this.reviews,e,this.roots),e.received=e.notes.map(({id:s})=>s);let i=()=>!!this.live?.holds(e)&&gf(e);return{session:e,autosave:new Co(e,this.storage,i)}}get sessions(){return this.scene.characters.map((t,e)=>(this.kept[e]??=this.begin(t)).session)}reviewed(){return this.sessions.map(t=>[t,t.notes])}makeLive(){let{live:t}=document.body.dataset;if(!t)return null;this.kept=this.scene.characters.map(i=>this.begin(i));let e=this.kept.map(({session:i})=>i);for(let i of e)i.options.autoKey=!0,i.animation.clip&&i.go(i.frame);return new Kl(e,t,this.tell)}offerWork(t){let e=t.offered;if(this.offer.hidden=!e,!e)return;let i=(o,a)=>vt(o,"",()=>{a(),t.discard(e),this.offerWork(t)}),s=()=>{vf(this.session,e.work),t.flush()},r=new Date(e.saved).toLocaleString([],{dateStyle:"medium",timeStyle:"short"});this.offer.replaceChildren(U("span",{},`Your work of ${r}: ${e.words}`),i("Restore",s),i("Discard",()=>{}))}leave(t){let e=this.kept.filter(Boolean).map(({autosave:i})=>i);e.forEach(i=>i.flush()),e.some(i=>i.isUnsaved)&&t.preventDefault()}startAfresh(t=this.index){this.kept[t]?.autosave.forget(),this.kept[t]=null,this.open(t)}fold(t,e=this[t].node.hidden){let i=["list","inspector","review"].filter(r=>r!==t),s=window.innerWidth<kg?i:i.filter(r=>r!=="list"&&t!=="list");e&&s.forEach(r=>this[r].node.hidden=!0),this[t].node.hidden=!e,this.node.classList.toggle("reviewing",!this.review.node.hidden),this.review.node.hidden&&(this.session.options.draw=!1),this.session.emit("options")}makeHelp(){let t=xT.flatMap(([e,i])=>[U("dt",{},e),U("dd",{},i)]);return U("div",{class:"help",hidden:!0},U("h2",{},"Gestures and keys"),U("dl",{},...t))}showHelp(){this.help.hidden=!this.help.hidden}setArrangement(t){this.session.setOption("arrangement",t),this.view.home(this.view.camera.azimuth,this.view.camera.elevation)}undo(){this.sayDone("Undone","undo",this.session.undo())}redo(){this.sayDone("Redone","redo",this.session.redo())}sayDone(t,e,i){this.say(i?`${t}: ${i}`:`Nothing to ${e}`)}say(t){this.notice.textContent=t,this.notice.hidden=!1,clearTimeout(this.silence),this.silence=setTimeout(()=>this.notice.hidden=!0,Math.max(2400,70*t.length))}shortcuts(){let t=i=>()=>this.session.flipOption(i),e=Hc.map(([,i,s],r)=>[r+1,()=>this.view.home(i,s)]);return{"Ctrl+z":()=>this.undo(),"Ctrl+Shift+z":()=>this.redo(),"Ctrl+y":()=>this.redo(),"Ctrl+a":()=>this.session.select(this.view.overlay.elementsIn([-1e9,-1e9,1e9,1e9])),s:t("symmetric"),h:t("handles"),c:()=>this.fold("list"),p:()=>this.fold("inspector"),n:()=>this.fold("review"),l:()=>this.session.setOption("labels",this.session.options.labels==="all"?"hover":"all"),0:()=>this.session.zero(this.session.chosenControls),r:()=>this.session.reset(this.session.chosenControls),m:()=>this.session.openOrClose()||this.say("Nothing selected has members"),k:()=>this.timeline.key(),d:()=>this.timeline.openSheet(),o:t("onion"),t:t("trails"),v:()=>this.session.character.shotCamera?this.session.flipOption("shot"):this.say("The stage has no camera, or several and no render settings that choose one"),"Ctrl+c":()=>this.session.copy(),"Ctrl+v":()=>this.session.paste(),...Object.fromEntries(e),f:()=>this.view.frameClosely()," ":()=>this.timeline.toggle(),"/":()=>{this.fold("list",!0),this.list.search.focus()},"?":()=>this.showHelp(),"Shift+?":()=>this.showHelp(),Escape:()=>this.escape()}}escape(){ug()||this.view.gestures.cancel()||(this.help.hidden?this.session.options.draw?this.review.setPen(!1):this.session.select([]):this.help.hidden=!0)}identity(){let{identity:t,layoutDigest:e}=this.session.character;return{character:t,layout:e,version:this.scene.version}}arrangeForTrial(t,e){let i={list:["target","clean"],face:["target","controls"],beside:["target","clean","controls"]},s={target:"Target",clean:"Your face",controls:t==="beside"?"Controls":"Your face"};this.node.classList.add("trial"),this.node.classList.toggle("trial-list",t==="list"),this.list.node.hidden=t!=="list",Object.assign(this.session.options,{skinDrag:!1,rearrange:!1,symmetric:!1,heat:!1,handles:t!=="list"}),this.view.stage.setTarget(e),this.session.emit("options"),this.view.setColumns(i[t],r=>s[r],()=>this.view.commonRoom(gT))}endTrials({work:t,history:e,options:i}){this.node.classList.remove("trial","trial-list"),this.fold("list",!1),Object.assign(this.session.options,i),this.view.stage.setTarget(null),this.session.history=e,this.session.trial=!1,this.session.restore(t),this.session.emit("options"),this.view.setColumns(null)}},vT=()=>JSON.parse(document.getElementById("reviews")?.textContent??"[]");function yT(n){let t=()=>n.session.controls.map(({name:e})=>e);return{values:()=>Object.fromEntries(t().map((e,i)=>[e,n.session.values[i]])),set:e=>n.session.edit("Set",()=>n.session.set(Un(e,n.session.controls))),pull:(e,i)=>{let s=new ws(n.session,{corners:[e,e,e],shares:[1,0,0]},null);for(let r=0;r<3;r++)s.to(i)},points:()=>Array.from(n.session.deformer.points),elements:()=>(n.view.freshen(),n.view.overlay.drawn.map(({element:e,handle:i,tracks:s,hidden:r})=>({name:e.name,controls:e.members.map(({control:o})=>n.session.controls[o].name),handle:i.slice(0,2),world:e.handle,tracks:s.map(o=>o.map(({at:a})=>a.slice(0,2))),hidden:r}))),trials:e=>Kc(e,n.session),app:n}}async function _T(){let n=document.getElementById("scene")?.textContent;try{let t=await _g(n);window.usdrigui=yT(new zu(t))}catch(t){let e=`The scene could not be shown: ${t.message}`;throw document.getElementById("app")?.replaceChildren(U("p",{class:"loading"},e)),t}}_T();})();
// sources 950b2a2d3ab95391eb49e25e6058b3812b19d2606a0204831bd0eb9a86429407
