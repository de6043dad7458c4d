struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_7 {
member: array<u32>,
}
struct type_8 {
member: type_2,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: type_4,
member_11: type_4,
member_12: f32,
}
struct type_9 {
member: type_8,
}
struct type_12 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_9;
@group(0) @binding(2)
var<storage, read_write> global_2: type_12;
@group(0) @binding(1)
var<storage> global_3: type_7;
fn function_() {
var phi_114_: i32;
var phi_117_: u32;
var phi_115_: i32;
var phi_118_: u32;
var local: u32;
var phi_229_: i32;
var phi_232_: u32;
var phi_267_: i32;
var phi_323_: u32;
var phi_388_: u32;
var phi_449_: u32;
var phi_230_: i32;
var phi_233_: u32;
let _e24 = global;
let _e26 = arrayLength((&global_3.member));
let _e28 = arrayLength((&global_2.member));
let _e31 = global_1.member.member;
if (_e24.x < _e31.member) {
if (_e24.y < _e31.member_1) {
let _e41 = global_1.member.member.member;
let _e43 = ((_e24.y * _e41) + _e24.x);
let _e46 = global_1.member.member_1;
if (_e43 < _e46) {
let _e50 = global_1.member.member_2;
let _e51 = bitcast<i32>(_e50);
let _e52 = bitcast<i32>(_e43);
let _e54 = (_e52 * (_e51 + 1i));
phi_114_ = 0i;
phi_117_ = 0u;
loop {
let _e56 = phi_114_;
let _e58 = phi_117_;
local = _e58;
let _e59 = (_e56 <= _e51);
if _e59 {
let _e60 = (_e54 + _e56);
let _e62 = (bitcast<i32>(_e26) - 1i);
let _e64 = select(_e62, _e60, (_e60 < _e62));
let _e70 = global_3.member[bitcast<u32>(select(0i, _e64, (_e64 > 0i)))];
phi_115_ = (_e56 + 1i);
phi_118_ = (_e58 + _e70);
} else {
phi_115_ = i32();
phi_118_ = u32();
}
let _e74 = phi_115_;
let _e76 = phi_118_;
continue;
continuing {
phi_114_ = _e74;
phi_117_ = _e76;
break if !(_e59);
}
}
let _e79 = local;
if (_e79 == 0u) {
let _e83 = global_1.member.member_3;
let _e84 = bitcast<i32>(_e83);
let _e88 = ((f32(_e52) + 0.5f) / f32(_e84));
let _e91 = global_1.member.member_4;
let _e93 = f32(bitcast<i32>(_e91));
let _e95 = select(0f, _e88, (_e88 > 0f));
let _e97 = select(_e93, _e95, (_e95 < _e93));
let _e104 = select(0i, select(select(i32(_e97), i32(-2147483648), (_e97 < -2147483600f)), 2147483647i, (_e97 > 2147483500f)), (_e97 == _e97));
let _e108 = (_e104 - select(0i, 1i, (_e97 < f32(_e104))));
let _e113 = global_1.member.member_5;
let _e123 = global_1.member.member_11.member;
let _e127 = global_1.member.member_11.member_2;
let _e129 = (_e123 + (_e127 * (f32((_e52 - (_e108 * _e84))) + 0.5f)));
let _e133 = global_1.member.member_11.member_1;
let _e135 = (_e133 + (_e127 * (f32((_e108 + bitcast<i32>(_e113))) + 0.5f)));
let _e139 = ((1f + (_e129 * _e129)) + (_e135 * _e135));
let _e145 = global_1.member.member_8;
let _e153 = global_1.member.member_7;
let _e154 = bitcast<i32>(_e153);
phi_229_ = 0i;
phi_232_ = 0u;
loop {
let _e156 = phi_229_;
let _e158 = phi_232_;
let _e159 = (_e156 < _e51);
if _e159 {
let _e160 = (_e54 + _e156);
let _e162 = (bitcast<i32>(_e26) - 1i);
let _e164 = select(_e162, _e160, (_e160 < _e162));
let _e170 = global_3.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e171 = (_e158 + _e170);
let _e172 = bitcast<i32>(_e171);
if (_e172 == 0i) {
} else {
if (_e172 < 0i) {
phi_267_ = -(_e172);
} else {
phi_267_ = _e172;
}
let _e177 = phi_267_;
let _e179 = (f32(_e177) * (1f / f32((1u << bitcast<u32>((_e145 & 31u))))));
let _e182 = (select(1f, _e179, (_e179 < 1f)) * sqrt(select(0f, _e139, (_e139 > 0f))));
let _e186 = ((((_e52 * _e51) + _e156) * _e154) * 2i);
let _e190 = global_1.member.member_10.member;
let _e193 = (((_e190 * _e182) * 16777216f) + 0.5f);
let _e195 = select(-1073741800f, _e193, (_e193 > -1073741800f));
let _e197 = select(1073741800f, _e195, (_e195 < 1073741800f));
let _e204 = select(0i, select(select(i32(_e197), i32(-2147483648), (_e197 < -2147483600f)), 2147483647i, (_e197 > 2147483500f)), (_e197 == _e197));
let _e208 = (_e204 - select(0i, 1i, (_e197 < f32(_e204))));
if (_e208 == 0i) {
} else {
let _e210 = bitcast<u32>(_e208);
let _e211 = bitcast<u32>(_e186);
if (_e211 < _e28) {
let _e215 = atomicAdd((&global_2.member[_e211]), _e210);
phi_323_ = _e215;
} else {
phi_323_ = 0u;
}
let _e217 = phi_323_;
let _e224 = (bitcast<u32>((_e208 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e217 + _e210) < _e210)));
if (_e224 == 0u) {
} else {
let _e226 = (_e211 + 1u);
if (_e226 < _e28) {
let _e230 = atomicAdd((&global_2.member[_e226]), _e224);
}
}
}
if (_e154 > 1i) {
let _e236 = global_1.member.member_10.member_1;
let _e239 = (((_e236 * _e182) * 16777216f) + 0.5f);
let _e241 = select(-1073741800f, _e239, (_e239 > -1073741800f));
let _e243 = select(1073741800f, _e241, (_e241 < 1073741800f));
let _e250 = select(0i, select(select(i32(_e243), i32(-2147483648), (_e243 < -2147483600f)), 2147483647i, (_e243 > 2147483500f)), (_e243 == _e243));
let _e254 = (_e250 - select(0i, 1i, (_e243 < f32(_e250))));
if (_e254 == 0i) {
} else {
let _e256 = bitcast<u32>(_e254);
let _e257 = bitcast<u32>((_e186 + 2i));
if (_e257 < _e28) {
let _e261 = atomicAdd((&global_2.member[_e257]), _e256);
phi_388_ = _e261;
} else {
phi_388_ = 0u;
}
let _e263 = phi_388_;
let _e270 = (bitcast<u32>((_e254 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e263 + _e256) < _e256)));
if (_e270 == 0u) {
} else {
let _e272 = (_e257 + 1u);
if (_e272 < _e28) {
let _e276 = atomicAdd((&global_2.member[_e272]), _e270);
}
}
}
let _e281 = global_1.member.member_10.member_2;
let _e284 = (((_e281 * _e182) * 16777216f) + 0.5f);
let _e286 = select(-1073741800f, _e284, (_e284 > -1073741800f));
let _e288 = select(1073741800f, _e286, (_e286 < 1073741800f));
let _e295 = select(0i, select(select(i32(_e288), i32(-2147483648), (_e288 < -2147483600f)), 2147483647i, (_e288 > 2147483500f)), (_e288 == _e288));
let _e299 = (_e295 - select(0i, 1i, (_e288 < f32(_e295))));
if (_e299 == 0i) {
} else {
let _e301 = bitcast<u32>(_e299);
let _e302 = bitcast<u32>((_e186 + 4i));
if (_e302 < _e28) {
let _e306 = atomicAdd((&global_2.member[_e302]), _e301);
phi_449_ = _e306;
} else {
phi_449_ = 0u;
}
let _e308 = phi_449_;
let _e315 = (bitcast<u32>((_e299 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e308 + _e301) < _e301)));
if (_e315 == 0u) {
} else {
let _e317 = (_e302 + 1u);
if (_e317 < _e28) {
let _e321 = atomicAdd((&global_2.member[_e317]), _e315);
}
}
}
}
}
phi_230_ = (_e156 + 1i);
phi_233_ = _e171;
} else {
phi_230_ = i32();
phi_233_ = u32();
}
let _e324 = phi_230_;
let _e326 = phi_233_;
continue;
continuing {
phi_229_ = _e324;
phi_232_ = _e326;
break if !(_e159);
}
}
}
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
