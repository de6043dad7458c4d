struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_5 {
member: array<f32>,
}
struct type_8 {
member: array<u32>,
}
struct type_9 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: f32,
}
struct type_10 {
member: type_9,
}
struct type_13 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(3)
var<storage, read_write> global_1: type_13;
@group(0) @binding(0)
var<storage> global_2: type_10;
@group(0) @binding(2)
var<storage> global_3: type_8;
@group(0) @binding(1)
var<storage> global_4: type_5;
fn function_() {
var phi_144_: i32;
var phi_324_: i32;
var phi_591_: i32;
var phi_728_: i32;
var phi_729_: i32;
var phi_592_: i32;
var phi_325_: i32;
let _e27 = global;
let _e33 = arrayLength((&global_1.member));
let _e36 = global_2.member.member;
if (_e27.x < _e36.member) {
if (_e27.y < _e36.member_1) {
let _e46 = global_2.member.member.member;
let _e48 = ((_e27.y * _e46) + _e27.x);
let _e51 = global_2.member.member_1;
let _e53 = bitcast<i32>((_e48 * 3u));
let _e54 = (_e53 + 1i);
let _e56 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e58 = select(_e56, _e54, (_e54 < _e56));
let _e64 = global_3.member[bitcast<u32>(select(0i, _e58, (_e58 > 0i)))];
let _e65 = bitcast<i32>(_e64);
if (_e48 < _e51) {
let _e67 = (_e53 + 2i);
let _e69 = select(_e56, _e67, (_e67 < _e56));
let _e75 = global_3.member[bitcast<u32>(select(0i, _e69, (_e69 > 0i)))];
phi_144_ = bitcast<i32>(_e75);
} else {
phi_144_ = 0i;
}
let _e78 = phi_144_;
let _e80 = select(_e56, _e53, (_e53 < _e56));
let _e86 = global_3.member[bitcast<u32>(select(0i, _e80, (_e80 > 0i)))];
let _e89 = (bitcast<i32>(_e86) * 9i);
let _e91 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e93 = select(_e91, _e89, (_e89 < _e91));
let _e99 = global_4.member[bitcast<u32>(select(0i, _e93, (_e93 > 0i)))];
let _e100 = (_e89 + 1i);
let _e102 = select(_e91, _e100, (_e100 < _e91));
let _e108 = global_4.member[bitcast<u32>(select(0i, _e102, (_e102 > 0i)))];
let _e109 = (_e89 + 2i);
let _e111 = select(_e91, _e109, (_e109 < _e91));
let _e117 = global_4.member[bitcast<u32>(select(0i, _e111, (_e111 > 0i)))];
let _e118 = (_e89 + 3i);
let _e120 = select(_e91, _e118, (_e118 < _e91));
let _e126 = global_4.member[bitcast<u32>(select(0i, _e120, (_e120 > 0i)))];
let _e127 = (_e89 + 4i);
let _e129 = select(_e91, _e127, (_e127 < _e91));
let _e135 = global_4.member[bitcast<u32>(select(0i, _e129, (_e129 > 0i)))];
let _e136 = (_e89 + 5i);
let _e138 = select(_e91, _e136, (_e136 < _e91));
let _e144 = global_4.member[bitcast<u32>(select(0i, _e138, (_e138 > 0i)))];
let _e145 = (_e89 + 6i);
let _e147 = select(_e91, _e145, (_e145 < _e91));
let _e153 = global_4.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e154 = (_e89 + 7i);
let _e156 = select(_e91, _e154, (_e154 < _e91));
let _e162 = global_4.member[bitcast<u32>(select(0i, _e156, (_e156 > 0i)))];
let _e163 = (_e89 + 8i);
let _e165 = select(_e91, _e163, (_e163 < _e91));
let _e171 = global_4.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e174 = global_2.member.member_4;
let _e175 = (_e174 & 31u);
let _e178 = f32((1u << bitcast<u32>(_e175)));
let _e179 = (1f / _e178);
let _e182 = global_2.member.member_6;
let _e186 = f32((1u << bitcast<u32>((_e182 & 31u))));
let _e190 = global_2.member.member_2.member;
let _e191 = f32(_e190);
phi_324_ = _e65;
loop {
let _e193 = phi_324_;
let _e194 = (_e193 < (_e65 + _e78));
if _e194 {
let _e197 = ((f32(_e193) + 0.5f) * _e179);
let _e198 = (_e117 <= _e197);
let _e199 = (_e144 > _e197);
let _e200 = (_e198 && _e199);
let _e201 = (_e144 <= _e197);
let _e202 = (_e117 > _e197);
let _e203 = (_e201 && _e202);
let _e204 = select(_e126, _e99, _e200);
let _e206 = select(_e135, _e108, _e200);
let _e208 = select(_e144, _e117, _e200);
let _e214 = ((_e197 - _e208) / select(1f, (select(_e117, _e144, _e200) - _e208), (_e200 || _e203)));
let _e217 = (_e204 + ((select(_e99, _e126, _e200) - _e204) * _e214));
let _e220 = (_e206 + ((select(_e108, _e135, _e200) - _e206) * _e214));
let _e221 = (_e171 > _e197);
let _e222 = (_e201 && _e221);
let _e223 = (_e171 <= _e197);
let _e224 = (_e223 && _e199);
let _e225 = select(_e153, _e126, _e222);
let _e227 = select(_e162, _e135, _e222);
let _e229 = select(_e171, _e144, _e222);
let _e235 = ((_e197 - _e229) / select(1f, (select(_e144, _e171, _e222) - _e229), (_e222 || _e224)));
let _e238 = (_e225 + ((select(_e126, _e153, _e222) - _e225) * _e235));
let _e241 = (_e227 + ((select(_e135, _e162, _e222) - _e227) * _e235));
let _e242 = (_e223 && _e202);
let _e244 = select(_e99, _e153, _e242);
let _e246 = select(_e108, _e162, _e242);
let _e248 = select(_e117, _e171, _e242);
let _e254 = ((_e197 - _e248) / select(1f, (select(_e171, _e117, _e242) - _e248), (_e242 || (_e198 && _e221))));
let _e257 = (_e244 + ((select(_e153, _e99, _e242) - _e244) * _e254));
let _e260 = (_e246 + ((select(_e162, _e108, _e242) - _e246) * _e254));
let _e264 = select(select(_e260, _e241, _e222), _e220, _e200);
let _e266 = select(select(_e257, _e238, _e224), _e217, _e203);
let _e268 = select(select(_e260, _e241, _e224), _e220, _e203);
let _e271 = (_e264 > _e268);
if ((_e200 || _e222) || _e242) {
let _e282 = global_2.member.member_2.member_1;
let _e287 = -(((select(_e268, _e264, _e271) * _e178) - 0.5f));
let _e288 = -((f32(_e282) * _e178));
let _e290 = select(_e288, _e287, (_e287 > _e288));
let _e292 = select(0f, _e290, (_e290 < 0f));
let _e299 = select(0i, select(select(i32(_e292), i32(-2147483648), (_e292 < -2147483600f)), 2147483647i, (_e292 > 2147483500f)), (_e292 == _e292));
let _e307 = -(((select(_e268, _e264, (_e264 < _e268)) * _e178) - 0.5f));
let _e309 = select(_e288, _e307, (_e307 > _e288));
let _e311 = select(0f, _e309, (_e309 < 0f));
let _e318 = select(0i, select(select(i32(_e311), i32(-2147483648), (_e311 < -2147483600f)), 2147483647i, (_e311 > 2147483500f)), (_e311 == _e311));
let _e328 = global_2.member.member_5;
phi_591_ = -((_e318 - select(0i, 1i, (_e311 < f32(_e318)))));
loop {
let _e332 = phi_591_;
let _e333 = (_e332 < -((_e299 - select(0i, 1i, (_e292 < f32(_e299))))));
if _e333 {
let _e338 = ((((f32(_e332) + 0.5f) * _e179) - _e268) * (1f / select((_e264 - _e268), 1f, (_e264 == _e268))));
let _e340 = select(0f, _e338, (_e338 > 0f));
let _e345 = (_e266 + ((select(select(_e257, _e238, _e222), _e217, _e200) - _e266) * select(1f, _e340, (_e340 < 1f))));
let _e348 = global_2.member.member_11;
let _e352 = (_e345 / (1f + (_e348 * (_e191 - _e345))));
let _e354 = select(0f, _e352, (_e352 > 0f));
let _e356 = select(_e191, _e354, (_e354 < _e191));
let _e357 = (_e191 - 1f);
let _e359 = select(0f, _e356, (_e356 > 0f));
let _e361 = select(_e357, _e359, (_e359 < _e357));
let _e368 = select(0i, select(select(i32(_e361), i32(-2147483648), (_e361 < -2147483600f)), 2147483647i, (_e361 > 2147483500f)), (_e361 == _e361));
let _e372 = (_e368 - select(0i, 1i, (_e361 < f32(_e368))));
let _e374 = select(0f, _e186, (_e186 > 0f));
let _e376 = select(65536f, _e374, (_e374 < 65536f));
let _e383 = select(0i, select(select(i32(_e376), i32(-2147483648), (_e376 < -2147483600f)), 2147483647i, (_e376 > 2147483500f)), (_e376 == _e376));
let _e391 = (((_e356 - f32(_e372)) * _e186) + 0.5f);
let _e393 = select(0f, _e391, (_e391 > 0f));
let _e395 = select(_e186, _e393, (_e393 < _e186));
let _e402 = select(0i, select(select(i32(_e395), i32(-2147483648), (_e395 < -2147483600f)), 2147483647i, (_e395 > 2147483500f)), (_e395 == _e395));
let _e406 = (_e402 - select(0i, 1i, (_e395 < f32(_e402))));
let _e407 = ((_e383 - select(0i, 1i, (_e376 < f32(_e383)))) - _e406);
let _e415 = global_2.member.member_3;
let _e419 = bitcast<u32>(((((((_e193 >> bitcast<u32>(_e175)) - bitcast<i32>(_e328)) * bitcast<i32>(_e282)) + (_e332 >> bitcast<u32>(_e175))) * bitcast<i32>(_e415)) + _e372));
if _e271 {
phi_728_ = -(_e406);
phi_729_ = -(_e407);
} else {
phi_728_ = _e406;
phi_729_ = _e407;
}
let _e423 = phi_728_;
let _e425 = phi_729_;
if (_e425 == 0i) {
} else {
if (_e419 < _e33) {
let _e431 = atomicAdd((&global_1.member[_e419]), bitcast<u32>(_e425));
}
}
if (_e423 == 0i) {
} else {
let _e433 = (_e419 + 1u);
if (_e433 < _e33) {
let _e438 = atomicAdd((&global_1.member[_e433]), bitcast<u32>(_e423));
}
}
phi_592_ = (_e332 + 1i);
} else {
phi_592_ = i32();
}
let _e441 = phi_592_;
continue;
continuing {
phi_591_ = _e441;
break if !(_e333);
}
}
}
phi_325_ = (_e193 + 1i);
} else {
phi_325_ = i32();
}
let _e445 = phi_325_;
continue;
continuing {
phi_324_ = _e445;
break if !(_e194);
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
