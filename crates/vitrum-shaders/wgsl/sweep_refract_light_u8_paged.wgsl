struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_3 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_4 {
member: u32,
member_1: u32,
}
struct type_6 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_7 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_8 {
member: type_7,
member_1: f32,
}
struct type_10 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: type_7,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_11 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_12 {
member: type_7,
member_1: type_7,
}
struct type_13 {
member: type_4,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_14 {
member: type_7,
member_1: f32,
member_2: f32,
}
struct type_15 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: u32,
member_4: type_4,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_4,
member_18: type_13,
member_19: type_7,
member_20: type_14,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_17 {
member: type_8,
member_1: type_7,
}
struct type_18 {
member: type_17,
member_1: type_17,
}
struct type_19 {
member: type_8,
member_1: u32,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_7,
member_8: type_7,
member_9: type_7,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_21 {
member: type_2,
member_1: u32,
member_2: type_3,
member_3: type_4,
member_4: type_4,
member_5: u32,
member_6: u32,
member_7: type_6,
member_8: type_10,
member_9: type_10,
member_10: type_11,
member_11: type_12,
member_12: type_15,
member_13: type_6,
member_14: type_16,
member_15: type_18,
member_16: type_19,
member_17: type_19,
member_18: type_19,
member_19: type_19,
member_20: type_7,
member_21: f32,
member_22: f32,
member_23: type_20,
}
struct type_22 {
member: type_21,
}
struct type_24 {
member: array<u32>,
}
struct type_26 {
member: array<f32>,
}
struct type_29 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_32 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_33 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_34 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: f32,
member_5: f32,
member_6: vec3<f32>,
}
struct type_35 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(1)
var<storage> global_2: type_24;
@group(0) @binding(4)
var<storage> global_3: type_24;
@group(0) @binding(6)
var<storage, read_write> global_4: type_26;
@group(0) @binding(3)
var<storage> global_5: type_24;
@group(0) @binding(5)
var<storage> global_6: type_26;
fn function_() {
var local: f32;
var local_1: f32;
var local_2: type_29;
var local_3: vec3<f32>;
var local_4: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var local_8: type_29;
var local_9: vec3<f32>;
var local_10: type_29;
var local_11: vec3<f32>;
var local_12: f32;
var local_13: f32;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var local_17: f32;
var local_18: f32;
var local_19: f32;
var local_20: f32;
var local_21: f32;
var local_22: f32;
var local_23: f32;
var local_24: f32;
var local_25: f32;
var local_26: type_29;
var local_27: vec3<f32>;
var phi_905_: bool;
var phi_1085_: bool;
var phi_1088_: bool;
var phi_1272_: bool;
var phi_1595_: u32;
var phi_7186_: type_32;
var phi_7889_: type_33;
var phi_8779_: type_7;
var phi_12507_: type_35;
var phi_13826_: type_34;
var phi_13839_: vec3<f32>;
var phi_13840_: f32;
var phi_16512_: type_34;
var phi_16664_: vec3<f32>;
var phi_16665_: f32;
let _e159 = global;
let _e162 = arrayLength((&global_2.member));
let _e167 = arrayLength((&global_3.member));
let _e169 = arrayLength((&global_6.member));
let _e174 = global_1.member.member_2;
let _e177 = global_1.member.member;
let _e185 = (_e159.x + _e174.member);
let _e187 = (_e159.y + _e174.member_1);
if (_e185 < _e174.member_2) {
if (_e187 < _e174.member_3) {
let _e190 = (_e177.member * _e177.member_1);
let _e192 = ((_e187 * _e177.member) + _e185);
let _e193 = bitcast<i32>(_e192);
let _e195 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e197 = select(_e195, _e193, (_e193 < _e195));
let _e203 = global_4.member[bitcast<u32>(select(0i, _e197, (_e197 > 0i)))];
let _e204 = (_e190 + _e192);
let _e205 = bitcast<i32>(_e204);
let _e207 = select(_e195, _e205, (_e205 < _e195));
let _e213 = global_4.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e215 = ((2u * _e190) + _e192);
let _e216 = bitcast<i32>(_e215);
let _e218 = select(_e195, _e216, (_e216 < _e195));
let _e224 = global_4.member[bitcast<u32>(select(0i, _e218, (_e218 > 0i)))];
let _e226 = ((3u * _e190) + _e192);
let _e227 = bitcast<i32>(_e226);
let _e229 = select(_e195, _e227, (_e227 < _e195));
let _e235 = global_4.member[bitcast<u32>(select(0i, _e229, (_e229 > 0i)))];
let _e237 = ((4u * _e190) + _e192);
let _e238 = bitcast<i32>(_e237);
let _e240 = select(_e195, _e238, (_e238 < _e195));
let _e246 = global_4.member[bitcast<u32>(select(0i, _e240, (_e240 > 0i)))];
let _e248 = ((5u * _e190) + _e192);
let _e249 = bitcast<i32>(_e248);
let _e251 = select(_e195, _e249, (_e249 < _e195));
let _e257 = global_4.member[bitcast<u32>(select(0i, _e251, (_e251 > 0i)))];
let _e259 = ((6u * _e190) + _e192);
let _e260 = bitcast<i32>(_e259);
let _e262 = select(_e195, _e260, (_e260 < _e195));
let _e268 = global_4.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
let _e270 = ((7u * _e190) + _e192);
let _e271 = bitcast<i32>(_e270);
let _e273 = select(_e195, _e271, (_e271 < _e195));
let _e279 = global_4.member[bitcast<u32>(select(0i, _e273, (_e273 > 0i)))];
let _e281 = ((8u * _e190) + _e192);
let _e282 = bitcast<i32>(_e281);
let _e284 = select(_e195, _e282, (_e282 < _e195));
let _e290 = global_4.member[bitcast<u32>(select(0i, _e284, (_e284 > 0i)))];
let _e295 = global_1.member.member_10.member;
let _e299 = global_1.member.member_10.member_1;
let _e300 = (_e295 * _e299);
if (_e169 >= (_e300 * 4u)) {
let _e304 = bitcast<i32>((_e187 * _e295));
let _e306 = bitcast<i32>(_e185);
let _e311 = global_6.member[bitcast<u32>((_e304 + _e306))];
let _e317 = global_6.member[bitcast<u32>(((bitcast<i32>(_e300) + _e304) + _e306))];
let _e318 = f32(_e306);
let _e320 = f32(bitcast<i32>(_e187));
let _e326 = global_1.member.member_7.member;
let _e330 = global_1.member.member_10.member_8;
let _e331 = (_e326 - _e330);
let _e335 = global_1.member.member_10.member_2;
let _e339 = global_1.member.member_10.member_6;
let _e346 = global_1.member.member_10.member_4;
let _e348 = ((_e335 + (_e339 * _e331)) + (((_e318 - _e311) + 0.5f) * _e346));
let _e352 = global_1.member.member_10.member_3;
let _e356 = global_1.member.member_10.member_7;
let _e361 = ((_e352 + (_e356 * _e331)) + (((_e320 - _e317) + 0.5f) * _e346));
let _e365 = global_1.member.member_7.member_1;
let _e366 = (_e365 - _e330);
let _e371 = ((_e335 + (_e339 * _e366)) + ((_e318 + 0.5f) * _e346));
let _e376 = ((_e352 + (_e356 * _e366)) + ((_e320 + 0.5f) * _e346));
let _e382 = global_1.member.member_8.member.member;
let _e390 = (((_e382.member * _e382.member) + (_e382.member_1 * _e382.member_1)) + (_e382.member_2 * _e382.member_2));
let _e393 = sqrt(select(0f, _e390, (_e390 > 0f)));
let _e394 = ((1.5f * _e346) * _e393);
let _e398 = (select(1f, _e394, (_e394 < 1f)) + (1f / 64f));
let _e400 = select(_e398, 0.5f, (0.5f > _e398));
let _e404 = global_1.member.member_7.member_2;
let _e407 = (_e404 / select(1e-6f, _e257, (_e257 > 1e-6f)));
let _e411 = (_e371 + (_e235 * _e407));
let _e412 = (_e376 + (_e246 * _e407));
let _e413 = (_e365 + (_e257 * _e407));
let _e417 = global_1.member.member_8.member;
let _e428 = ((((_e417.member.member * _e348) + (_e417.member.member_1 * _e361)) + (_e417.member.member_2 * _e326)) + _e417.member_1);
let _e432 = global_1.member.member_8.member_1;
let _e443 = ((((_e432.member.member * _e348) + (_e432.member.member_1 * _e361)) + (_e432.member.member_2 * _e326)) + _e432.member_1);
let _e447 = global_1.member.member_8.member_2;
let _e458 = ((((_e447.member.member * _e348) + (_e447.member.member_1 * _e361)) + (_e447.member.member_2 * _e326)) + _e447.member_1);
let _e464 = ((((_e417.member.member * _e371) + (_e417.member.member_1 * _e376)) + (_e417.member.member_2 * _e365)) + _e417.member_1);
let _e470 = ((((_e432.member.member * _e371) + (_e432.member.member_1 * _e376)) + (_e432.member.member_2 * _e365)) + _e432.member_1);
let _e476 = ((((_e447.member.member * _e371) + (_e447.member.member_1 * _e376)) + (_e447.member.member_2 * _e365)) + _e447.member_1);
let _e482 = global_1.member.member_8.member_3.member;
let _e483 = (_e482 - 1f);
let _e492 = global_1.member.member_8.member_3.member_1;
let _e493 = (_e492 - 1f);
let _e502 = global_1.member.member_8.member_3.member_2;
let _e503 = (_e502 - 1f);
let _e517 = (((((((_e428 >= 0f) && (_e428 <= _e483)) && (_e443 >= 0f)) && (_e443 <= _e493)) && (_e458 >= 0f)) && (_e458 <= _e503)) && ((((((_e464 >= 0f) && (_e464 <= _e483)) && (_e470 >= 0f)) && (_e470 <= _e493)) && (_e476 >= 0f)) && (_e476 <= _e503)));
let _e526 = ((((_e177.member_2 == 1u) || (_e177.member_2 == 5u)) || (_e177.member_2 == 6u)) || ((_e177.member_2 == 2u) || (_e177.member_2 == 7u)));
if _e526 {
let _e527 = (_e400 - 0.5f);
let _e528 = (_e400 + 0.5f);
let _e530 = (_e482 - _e528);
let _e534 = (_e492 - _e528);
let _e539 = (_e502 - _e528);
let _e542 = ((((_e428 >= _e527) && (_e428 <= _e530)) && ((_e443 >= _e527) && (_e443 <= _e534))) && ((_e458 >= _e527) && (_e458 <= _e539)));
let _e545 = global_1.member.member_1;
let _e547 = ((_e545 & 16u) == 0u);
if _e547 {
phi_905_ = _e542;
} else {
let _e552 = global_1.member.member_16.member;
let _e564 = -((_e400 / _e393));
let _e569 = global_1.member.member_16.member_1;
let _e575 = global_1.member.member_17.member;
let _e591 = global_1.member.member_17.member_1;
let _e598 = global_1.member.member_18.member;
let _e614 = global_1.member.member_18.member_1;
let _e621 = global_1.member.member_19.member;
let _e637 = global_1.member.member_19.member_1;
phi_905_ = (_e542 && (((((((((_e552.member.member * _e348) + (_e552.member.member_1 * _e361)) + (_e552.member.member_2 * _e326)) + _e552.member_1) <= _e564) || (_e569 == 0u)) && ((((((_e575.member.member * _e348) + (_e575.member.member_1 * _e361)) + (_e575.member.member_2 * _e326)) + _e575.member_1) <= _e564) || (_e591 == 0u))) && ((((((_e598.member.member * _e348) + (_e598.member.member_1 * _e361)) + (_e598.member.member_2 * _e326)) + _e598.member_1) <= _e564) || (_e614 == 0u))) && ((((((_e621.member.member * _e348) + (_e621.member.member_1 * _e361)) + (_e621.member.member_2 * _e326)) + _e621.member_1) <= _e564) || (_e637 == 0u))));
}
let _e643 = phi_905_;
let _e647 = (_e371 + (_e371 - _e348));
let _e648 = (_e376 + (_e376 - _e361));
let _e649 = (_e365 + (_e365 - _e326));
let _e655 = ((((_e417.member.member * _e647) + (_e417.member.member_1 * _e648)) + (_e417.member.member_2 * _e649)) + _e417.member_1);
let _e661 = ((((_e432.member.member * _e647) + (_e432.member.member_1 * _e648)) + (_e432.member.member_2 * _e649)) + _e432.member_1);
let _e667 = ((((_e447.member.member * _e647) + (_e447.member.member_1 * _e648)) + (_e447.member.member_2 * _e649)) + _e447.member_1);
let _e678 = ((((_e655 >= _e527) && (_e655 <= _e530)) && ((_e661 >= _e527) && (_e661 <= _e534))) && ((_e667 >= _e527) && (_e667 <= _e539)));
if _e547 {
phi_1085_ = _e678;
} else {
let _e683 = global_1.member.member_16.member;
let _e695 = -((_e400 / _e393));
let _e700 = global_1.member.member_16.member_1;
let _e706 = global_1.member.member_17.member;
let _e722 = global_1.member.member_17.member_1;
let _e729 = global_1.member.member_18.member;
let _e745 = global_1.member.member_18.member_1;
let _e752 = global_1.member.member_19.member;
let _e768 = global_1.member.member_19.member_1;
phi_1085_ = (_e678 && (((((((((_e683.member.member * _e647) + (_e683.member.member_1 * _e648)) + (_e683.member.member_2 * _e649)) + _e683.member_1) <= _e695) || (_e700 == 0u)) && ((((((_e706.member.member * _e647) + (_e706.member.member_1 * _e648)) + (_e706.member.member_2 * _e649)) + _e706.member_1) <= _e695) || (_e722 == 0u))) && ((((((_e729.member.member * _e647) + (_e729.member.member_1 * _e648)) + (_e729.member.member_2 * _e649)) + _e729.member_1) <= _e695) || (_e745 == 0u))) && ((((((_e752.member.member * _e647) + (_e752.member.member_1 * _e648)) + (_e752.member.member_2 * _e649)) + _e752.member_1) <= _e695) || (_e768 == 0u))));
}
let _e774 = phi_1085_;
phi_1088_ = (_e517 && (_e643 && _e774));
} else {
phi_1088_ = _e517;
}
let _e778 = phi_1088_;
let _e785 = ((((_e417.member.member * _e411) + (_e417.member.member_1 * _e412)) + (_e417.member.member_2 * _e413)) + _e417.member_1);
let _e791 = ((((_e432.member.member * _e411) + (_e432.member.member_1 * _e412)) + (_e432.member.member_2 * _e413)) + _e432.member_1);
let _e797 = ((((_e447.member.member * _e411) + (_e447.member.member_1 * _e412)) + (_e447.member.member_2 * _e413)) + _e447.member_1);
let _e798 = (_e400 - 0.5f);
let _e799 = (_e400 + 0.5f);
let _e813 = ((((_e785 >= _e798) && (_e785 <= (_e482 - _e799))) && ((_e791 >= _e798) && (_e791 <= (_e492 - _e799)))) && ((_e797 >= _e798) && (_e797 <= (_e502 - _e799))));
let _e816 = global_1.member.member_1;
if ((_e816 & 16u) == 0u) {
phi_1272_ = _e813;
} else {
let _e823 = global_1.member.member_16.member;
let _e835 = -((_e400 / _e393));
let _e840 = global_1.member.member_16.member_1;
let _e846 = global_1.member.member_17.member;
let _e862 = global_1.member.member_17.member_1;
let _e869 = global_1.member.member_18.member;
let _e885 = global_1.member.member_18.member_1;
let _e892 = global_1.member.member_19.member;
let _e908 = global_1.member.member_19.member_1;
phi_1272_ = (_e813 && (((((((((_e823.member.member * _e411) + (_e823.member.member_1 * _e412)) + (_e823.member.member_2 * _e413)) + _e823.member_1) <= _e835) || (_e840 == 0u)) && ((((((_e846.member.member * _e411) + (_e846.member.member_1 * _e412)) + (_e846.member.member_2 * _e413)) + _e846.member_1) <= _e835) || (_e862 == 0u))) && ((((((_e869.member.member * _e411) + (_e869.member.member_1 * _e412)) + (_e869.member.member_2 * _e413)) + _e869.member_1) <= _e835) || (_e885 == 0u))) && ((((((_e892.member.member * _e411) + (_e892.member.member_1 * _e412)) + (_e892.member.member_2 * _e413)) + _e892.member_1) <= _e835) || (_e908 == 0u))));
}
let _e914 = phi_1272_;
let _e921 = global_1.member.member_8.member_4;
let _e922 = (_e482 - 0.5f);
let _e924 = select(-0.5f, _e464, (_e464 > -0.5f));
let _e926 = select(_e922, _e924, (_e924 < _e922));
let _e927 = (_e492 - 0.5f);
let _e929 = select(-0.5f, _e470, (_e470 > -0.5f));
let _e931 = select(_e927, _e929, (_e929 < _e927));
let _e932 = (_e502 - 0.5f);
let _e934 = select(-0.5f, _e476, (_e476 > -0.5f));
let _e936 = select(_e932, _e934, (_e934 < _e932));
let _e942 = bitcast<f32>((bitcast<u32>((_e464 - _e428)) & 2147483647u));
let _e945 = bitcast<f32>((bitcast<u32>((_e470 - _e443)) & 2147483647u));
let _e947 = select(_e945, _e942, (_e942 > _e945));
let _e950 = bitcast<f32>((bitcast<u32>((_e476 - _e458)) & 2147483647u));
let _e959 = bitcast<f32>((bitcast<u32>((_e464 - _e926)) & 2147483647u));
let _e962 = bitcast<f32>((bitcast<u32>((_e470 - _e931)) & 2147483647u));
let _e964 = select(_e962, _e959, (_e959 > _e962));
let _e967 = bitcast<f32>((bitcast<u32>((_e476 - _e936)) & 2147483647u));
let _e971 = (_e926 + 0.5f);
let _e973 = select(0f, _e971, (_e971 > 0f));
let _e975 = select(_e483, _e973, (_e973 < _e483));
let _e982 = select(0i, select(select(i32(_e975), i32(-2147483648), (_e975 < -2147483600f)), 2147483647i, (_e975 > 2147483500f)), (_e975 == _e975));
let _e990 = global_1.member.member_8.member_12;
let _e991 = (_e990 & 31u);
let _e994 = (_e931 + 0.5f);
let _e996 = select(0f, _e994, (_e994 > 0f));
let _e998 = select(_e493, _e996, (_e996 < _e493));
let _e1005 = select(0i, select(select(i32(_e998), i32(-2147483648), (_e998 < -2147483600f)), 2147483647i, (_e998 > 2147483500f)), (_e998 == _e998));
let _e1012 = (_e936 + 0.5f);
let _e1014 = select(0f, _e1012, (_e1012 > 0f));
let _e1016 = select(_e503, _e1014, (_e1014 < _e503));
let _e1023 = select(0i, select(select(i32(_e1016), i32(-2147483648), (_e1016 < -2147483600f)), 2147483647i, (_e1016 > 2147483500f)), (_e1016 == _e1016));
let _e1034 = global_1.member.member_8.member_9.member;
let _e1040 = global_1.member.member_8.member_9.member_1;
let _e1045 = global_1.member.member_8.member_10;
let _e1051 = ((bitcast<i32>(_e1045) + ((_e982 - select(0i, 1i, (_e975 < f32(_e982)))) >> bitcast<u32>(_e991))) + (bitcast<i32>(_e1034) * (((_e1005 - select(0i, 1i, (_e998 < f32(_e1005)))) >> bitcast<u32>(_e991)) + (bitcast<i32>(_e1040) * ((_e1023 - select(0i, 1i, (_e1016 < f32(_e1023)))) >> bitcast<u32>(_e991))))));
let _e1053 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1055 = select(_e1053, _e1051, (_e1051 < _e1053));
let _e1061 = global_5.member[bitcast<u32>(select(0i, _e1055, (_e1055 > 0i)))];
phi_1595_ = select(select(7u, 3u, (_e778 && (!(_e526) || _e914))), 1u, (((_e816 & 64u) != 0u) || ((((select(_e950, _e947, (_e947 > _e950)) <= _e921) && ((select(_e967, _e964, (_e964 > _e967)) > _e921) || (_e1061 != 0u))) && true) && ((_e816 & 32u) != 0u))));
} else {
phi_1595_ = 7u;
}
let _e1074 = phi_1595_;
if (_e1074 > 1u) {
let _e1079 = bitcast<i32>(((_e187 * _e295) + _e185));
let _e1082 = (bitcast<i32>(_e169) - 1i);
let _e1084 = select(_e1082, _e1079, (_e1079 < _e1082));
let _e1090 = global_6.member[bitcast<u32>(select(0i, _e1084, (_e1084 > 0i)))];
let _e1091 = (bitcast<i32>(_e300) + _e1079);
let _e1093 = select(_e1082, _e1091, (_e1091 < _e1082));
let _e1099 = global_6.member[bitcast<u32>(select(0i, _e1093, (_e1093 > 0i)))];
let _e1101 = f32(bitcast<i32>(_e185));
let _e1103 = f32(bitcast<i32>(_e187));
let _e1109 = global_1.member.member_7.member;
let _e1113 = global_1.member.member_10.member_8;
let _e1114 = (_e1109 - _e1113);
let _e1118 = global_1.member.member_10.member_2;
let _e1122 = global_1.member.member_10.member_6;
let _e1129 = global_1.member.member_10.member_4;
let _e1131 = ((_e1118 + (_e1122 * _e1114)) + (((_e1101 - _e1090) + 0.5f) * _e1129));
let _e1135 = global_1.member.member_10.member_3;
let _e1139 = global_1.member.member_10.member_7;
let _e1144 = ((_e1135 + (_e1139 * _e1114)) + (((_e1103 - _e1099) + 0.5f) * _e1129));
let _e1148 = global_1.member.member_7.member_1;
let _e1149 = (_e1148 - _e1113);
let _e1154 = ((_e1118 + (_e1122 * _e1149)) + ((_e1101 + 0.5f) * _e1129));
let _e1159 = ((_e1135 + (_e1139 * _e1149)) + ((_e1103 + 0.5f) * _e1129));
let _e1163 = global_1.member.member_8.member;
let _e1174 = ((((_e1163.member.member * _e1131) + (_e1163.member.member_1 * _e1144)) + (_e1163.member.member_2 * _e1109)) + _e1163.member_1);
let _e1178 = global_1.member.member_8.member_1;
let _e1189 = ((((_e1178.member.member * _e1131) + (_e1178.member.member_1 * _e1144)) + (_e1178.member.member_2 * _e1109)) + _e1178.member_1);
let _e1193 = global_1.member.member_8.member_2;
let _e1204 = ((((_e1193.member.member * _e1131) + (_e1193.member.member_1 * _e1144)) + (_e1193.member.member_2 * _e1109)) + _e1193.member_1);
let _e1210 = ((((_e1163.member.member * _e1154) + (_e1163.member.member_1 * _e1159)) + (_e1163.member.member_2 * _e1148)) + _e1163.member_1);
let _e1216 = ((((_e1178.member.member * _e1154) + (_e1178.member.member_1 * _e1159)) + (_e1178.member.member_2 * _e1148)) + _e1178.member_1);
let _e1222 = ((((_e1193.member.member * _e1154) + (_e1193.member.member_1 * _e1159)) + (_e1193.member.member_2 * _e1148)) + _e1193.member_1);
let _e1224 = (_e177.member_2 == 5u);
let _e1230 = ((_e177.member_2 == 2u) || (_e177.member_2 == 7u));
let _e1231 = ((((_e177.member_2 == 1u) || _e1224) || (_e177.member_2 == 6u)) || _e1230);
if _e1231 {
let _e1236 = global_1.member.member_8.member_3.member;
let _e1237 = (_e1236 - 0.5f);
let _e1239 = select(-0.5f, _e1210, (_e1210 > -0.5f));
let _e1241 = select(_e1237, _e1239, (_e1239 < _e1237));
let _e1246 = global_1.member.member_8.member_3.member_1;
let _e1247 = (_e1246 - 0.5f);
let _e1249 = select(-0.5f, _e1216, (_e1216 > -0.5f));
let _e1251 = select(_e1247, _e1249, (_e1249 < _e1247));
let _e1256 = global_1.member.member_8.member_3.member_2;
let _e1257 = (_e1256 - 0.5f);
let _e1259 = select(-0.5f, _e1222, (_e1222 > -0.5f));
let _e1261 = select(_e1257, _e1259, (_e1259 < _e1257));
let _e1263 = select(-1f, _e1241, (_e1241 > -1f));
let _e1265 = select(_e1236, _e1263, (_e1263 < _e1236));
let _e1272 = select(0i, select(select(i32(_e1265), i32(-2147483648), (_e1265 < -2147483600f)), 2147483647i, (_e1265 > 2147483500f)), (_e1265 == _e1265));
let _e1276 = (_e1272 - select(0i, 1i, (_e1265 < f32(_e1272))));
let _e1278 = select(-1f, _e1251, (_e1251 > -1f));
let _e1280 = select(_e1246, _e1278, (_e1278 < _e1246));
let _e1287 = select(0i, select(select(i32(_e1280), i32(-2147483648), (_e1280 < -2147483600f)), 2147483647i, (_e1280 > 2147483500f)), (_e1280 == _e1280));
let _e1291 = (_e1287 - select(0i, 1i, (_e1280 < f32(_e1287))));
let _e1293 = select(-1f, _e1261, (_e1261 > -1f));
let _e1295 = select(_e1256, _e1293, (_e1293 < _e1256));
let _e1302 = select(0i, select(select(i32(_e1295), i32(-2147483648), (_e1295 < -2147483600f)), 2147483647i, (_e1295 > 2147483500f)), (_e1295 == _e1295));
let _e1306 = (_e1302 - select(0i, 1i, (_e1295 < f32(_e1302))));
let _e1310 = global_1.member.member_8.member_7;
let _e1314 = global_1.member.member_8.member_8;
let _e1315 = (_e1276 + 1i);
let _e1316 = (_e1291 + 1i);
let _e1317 = (_e1306 + 1i);
let _e1322 = global_1.member.member_8.member_11.member;
let _e1328 = global_1.member.member_8.member_11.member_1;
let _e1339 = ((_e1315 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1322) * ((_e1316 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1328) * (_e1317 >> bitcast<u32>(4i))))));
let _e1341 = (bitcast<i32>(_e162) - 1i);
let _e1343 = select(_e1341, _e1339, (_e1339 < _e1341));
let _e1349 = global_2.member[bitcast<u32>(select(0i, _e1343, (_e1343 > 0i)))];
let _e1351 = (_e1315 & 15i);
let _e1354 = ((_e1316 & 15i) * _e1310);
let _e1356 = (bitcast<i32>(_e1349) + ((_e1317 & 15i) * _e1314));
let _e1357 = (_e1354 + _e1310);
let _e1359 = (_e1354 + (2i * _e1310));
let _e1361 = (_e1354 + (3i * _e1310));
let _e1362 = (_e1356 + _e1314);
let _e1364 = (_e1356 + (2i * _e1314));
let _e1366 = (_e1356 + (3i * _e1314));
local_26 = type_29(array<i32, 4>(_e1351, _e1351, _e1351, _e1351), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_27 = vec3<f32>((_e1241 - f32(_e1276)), (_e1251 - f32(_e1291)), (_e1261 - f32(_e1306)));
let _e1380 = local_26.member[0u];
let _e1381 = ((_e1362 + _e1357) + _e1380);
let _e1383 = (_e1381 >> bitcast<u32>(2i));
let _e1386 = bitcast<u32>(((_e1381 & 3i) * 8i));
let _e1388 = select(_e1341, _e1383, (_e1383 < _e1341));
let _e1393 = global_2.member[bitcast<u32>(select(0i, _e1388, (_e1388 > 0i)))];
let _e1397 = (_e1383 + 1i);
let _e1399 = select(_e1341, _e1397, (_e1397 < _e1341));
let _e1404 = global_2.member[bitcast<u32>(select(0i, _e1399, (_e1399 > 0i)))];
let _e1411 = ((_e1393 >> bitcast<u32>((_e1386 & 31u))) | ((_e1404 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1386) & 31u))));
let _e1414 = local_26.member_1[0u];
let _e1420 = f32(bitcast<i32>(((_e1411 >> bitcast<u32>((_e1414 & 31u))) & 255u)));
let _e1423 = local_26.member_1[1u];
let _e1429 = f32(bitcast<i32>(((_e1411 >> bitcast<u32>((_e1423 & 31u))) & 255u)));
let _e1432 = local_26.member_1[2u];
let _e1438 = f32(bitcast<i32>(((_e1411 >> bitcast<u32>((_e1432 & 31u))) & 255u)));
let _e1441 = local_26.member_1[3u];
let _e1448 = local_27[0u];
let _e1451 = (_e1420 + ((_e1429 - _e1420) * _e1448));
let _e1452 = local_27[0u];
let _e1455 = (_e1429 + ((_e1438 - _e1429) * _e1452));
let _e1456 = local_27[0u];
let _e1459 = (_e1438 + ((f32(bitcast<i32>(((_e1411 >> bitcast<u32>((_e1441 & 31u))) & 255u))) - _e1438) * _e1456));
let _e1461 = local_26.member[0u];
let _e1462 = ((_e1362 + _e1359) + _e1461);
let _e1464 = (_e1462 >> bitcast<u32>(2i));
let _e1467 = bitcast<u32>(((_e1462 & 3i) * 8i));
let _e1469 = select(_e1341, _e1464, (_e1464 < _e1341));
let _e1474 = global_2.member[bitcast<u32>(select(0i, _e1469, (_e1469 > 0i)))];
let _e1478 = (_e1464 + 1i);
let _e1480 = select(_e1341, _e1478, (_e1478 < _e1341));
let _e1485 = global_2.member[bitcast<u32>(select(0i, _e1480, (_e1480 > 0i)))];
let _e1492 = ((_e1474 >> bitcast<u32>((_e1467 & 31u))) | ((_e1485 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1467) & 31u))));
let _e1493 = local_26.member_1[0u];
let _e1499 = f32(bitcast<i32>(((_e1492 >> bitcast<u32>((_e1493 & 31u))) & 255u)));
let _e1500 = local_26.member_1[1u];
let _e1506 = f32(bitcast<i32>(((_e1492 >> bitcast<u32>((_e1500 & 31u))) & 255u)));
let _e1507 = local_26.member_1[2u];
let _e1513 = f32(bitcast<i32>(((_e1492 >> bitcast<u32>((_e1507 & 31u))) & 255u)));
let _e1514 = local_26.member_1[3u];
let _e1521 = local_27[0u];
let _e1525 = local_27[0u];
let _e1528 = (_e1506 + ((_e1513 - _e1506) * _e1525));
let _e1529 = local_27[0u];
let _e1534 = local_26.member[0u];
let _e1535 = ((_e1364 + _e1357) + _e1534);
let _e1537 = (_e1535 >> bitcast<u32>(2i));
let _e1540 = bitcast<u32>(((_e1535 & 3i) * 8i));
let _e1542 = select(_e1341, _e1537, (_e1537 < _e1341));
let _e1547 = global_2.member[bitcast<u32>(select(0i, _e1542, (_e1542 > 0i)))];
let _e1551 = (_e1537 + 1i);
let _e1553 = select(_e1341, _e1551, (_e1551 < _e1341));
let _e1558 = global_2.member[bitcast<u32>(select(0i, _e1553, (_e1553 > 0i)))];
let _e1565 = ((_e1547 >> bitcast<u32>((_e1540 & 31u))) | ((_e1558 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1540) & 31u))));
let _e1566 = local_26.member_1[0u];
let _e1572 = f32(bitcast<i32>(((_e1565 >> bitcast<u32>((_e1566 & 31u))) & 255u)));
let _e1573 = local_26.member_1[1u];
let _e1579 = f32(bitcast<i32>(((_e1565 >> bitcast<u32>((_e1573 & 31u))) & 255u)));
let _e1580 = local_26.member_1[2u];
let _e1586 = f32(bitcast<i32>(((_e1565 >> bitcast<u32>((_e1580 & 31u))) & 255u)));
let _e1587 = local_26.member_1[3u];
let _e1594 = local_27[0u];
let _e1597 = (_e1572 + ((_e1579 - _e1572) * _e1594));
let _e1598 = local_27[0u];
let _e1601 = (_e1579 + ((_e1586 - _e1579) * _e1598));
let _e1602 = local_27[0u];
let _e1605 = (_e1586 + ((f32(bitcast<i32>(((_e1565 >> bitcast<u32>((_e1587 & 31u))) & 255u))) - _e1586) * _e1602));
let _e1607 = local_26.member[0u];
let _e1608 = ((_e1364 + _e1359) + _e1607);
let _e1610 = (_e1608 >> bitcast<u32>(2i));
let _e1613 = bitcast<u32>(((_e1608 & 3i) * 8i));
let _e1615 = select(_e1341, _e1610, (_e1610 < _e1341));
let _e1620 = global_2.member[bitcast<u32>(select(0i, _e1615, (_e1615 > 0i)))];
let _e1624 = (_e1610 + 1i);
let _e1626 = select(_e1341, _e1624, (_e1624 < _e1341));
let _e1631 = global_2.member[bitcast<u32>(select(0i, _e1626, (_e1626 > 0i)))];
let _e1638 = ((_e1620 >> bitcast<u32>((_e1613 & 31u))) | ((_e1631 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1613) & 31u))));
let _e1639 = local_26.member_1[0u];
let _e1645 = f32(bitcast<i32>(((_e1638 >> bitcast<u32>((_e1639 & 31u))) & 255u)));
let _e1646 = local_26.member_1[1u];
let _e1652 = f32(bitcast<i32>(((_e1638 >> bitcast<u32>((_e1646 & 31u))) & 255u)));
let _e1653 = local_26.member_1[2u];
let _e1659 = f32(bitcast<i32>(((_e1638 >> bitcast<u32>((_e1653 & 31u))) & 255u)));
let _e1660 = local_26.member_1[3u];
let _e1667 = local_27[0u];
let _e1671 = local_27[0u];
let _e1674 = (_e1652 + ((_e1659 - _e1652) * _e1671));
let _e1675 = local_27[0u];
let _e1680 = local_26.member[0u];
let _e1681 = ((_e1362 + _e1354) + _e1680);
let _e1683 = (_e1681 >> bitcast<u32>(2i));
let _e1686 = bitcast<u32>(((_e1681 & 3i) * 8i));
let _e1688 = select(_e1341, _e1683, (_e1683 < _e1341));
let _e1693 = global_2.member[bitcast<u32>(select(0i, _e1688, (_e1688 > 0i)))];
let _e1697 = (_e1683 + 1i);
let _e1699 = select(_e1341, _e1697, (_e1697 < _e1341));
let _e1704 = global_2.member[bitcast<u32>(select(0i, _e1699, (_e1699 > 0i)))];
let _e1711 = ((_e1693 >> bitcast<u32>((_e1686 & 31u))) | ((_e1704 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1686) & 31u))));
let _e1712 = local_26.member_1[1u];
let _e1718 = f32(bitcast<i32>(((_e1711 >> bitcast<u32>((_e1712 & 31u))) & 255u)));
let _e1719 = local_26.member_1[2u];
let _e1726 = local_27[0u];
let _e1729 = (_e1718 + ((f32(bitcast<i32>(((_e1711 >> bitcast<u32>((_e1719 & 31u))) & 255u))) - _e1718) * _e1726));
let _e1731 = local_26.member[0u];
let _e1732 = ((_e1362 + _e1361) + _e1731);
let _e1734 = (_e1732 >> bitcast<u32>(2i));
let _e1737 = bitcast<u32>(((_e1732 & 3i) * 8i));
let _e1739 = select(_e1341, _e1734, (_e1734 < _e1341));
let _e1744 = global_2.member[bitcast<u32>(select(0i, _e1739, (_e1739 > 0i)))];
let _e1748 = (_e1734 + 1i);
let _e1750 = select(_e1341, _e1748, (_e1748 < _e1341));
let _e1755 = global_2.member[bitcast<u32>(select(0i, _e1750, (_e1750 > 0i)))];
let _e1762 = ((_e1744 >> bitcast<u32>((_e1737 & 31u))) | ((_e1755 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1737) & 31u))));
let _e1763 = local_26.member_1[1u];
let _e1769 = f32(bitcast<i32>(((_e1762 >> bitcast<u32>((_e1763 & 31u))) & 255u)));
let _e1770 = local_26.member_1[2u];
let _e1777 = local_27[0u];
let _e1782 = local_26.member[0u];
let _e1783 = ((_e1364 + _e1354) + _e1782);
let _e1785 = (_e1783 >> bitcast<u32>(2i));
let _e1788 = bitcast<u32>(((_e1783 & 3i) * 8i));
let _e1790 = select(_e1341, _e1785, (_e1785 < _e1341));
let _e1795 = global_2.member[bitcast<u32>(select(0i, _e1790, (_e1790 > 0i)))];
let _e1799 = (_e1785 + 1i);
let _e1801 = select(_e1341, _e1799, (_e1799 < _e1341));
let _e1806 = global_2.member[bitcast<u32>(select(0i, _e1801, (_e1801 > 0i)))];
let _e1813 = ((_e1795 >> bitcast<u32>((_e1788 & 31u))) | ((_e1806 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1788) & 31u))));
let _e1814 = local_26.member_1[1u];
let _e1820 = f32(bitcast<i32>(((_e1813 >> bitcast<u32>((_e1814 & 31u))) & 255u)));
let _e1821 = local_26.member_1[2u];
let _e1828 = local_27[0u];
let _e1831 = (_e1820 + ((f32(bitcast<i32>(((_e1813 >> bitcast<u32>((_e1821 & 31u))) & 255u))) - _e1820) * _e1828));
let _e1833 = local_26.member[0u];
let _e1834 = ((_e1364 + _e1361) + _e1833);
let _e1836 = (_e1834 >> bitcast<u32>(2i));
let _e1839 = bitcast<u32>(((_e1834 & 3i) * 8i));
let _e1841 = select(_e1341, _e1836, (_e1836 < _e1341));
let _e1846 = global_2.member[bitcast<u32>(select(0i, _e1841, (_e1841 > 0i)))];
let _e1850 = (_e1836 + 1i);
let _e1852 = select(_e1341, _e1850, (_e1850 < _e1341));
let _e1857 = global_2.member[bitcast<u32>(select(0i, _e1852, (_e1852 > 0i)))];
let _e1864 = ((_e1846 >> bitcast<u32>((_e1839 & 31u))) | ((_e1857 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1839) & 31u))));
let _e1865 = local_26.member_1[1u];
let _e1871 = f32(bitcast<i32>(((_e1864 >> bitcast<u32>((_e1865 & 31u))) & 255u)));
let _e1872 = local_26.member_1[2u];
let _e1879 = local_27[0u];
let _e1884 = local_26.member[0u];
let _e1885 = ((_e1356 + _e1357) + _e1884);
let _e1887 = (_e1885 >> bitcast<u32>(2i));
let _e1890 = bitcast<u32>(((_e1885 & 3i) * 8i));
let _e1892 = select(_e1341, _e1887, (_e1887 < _e1341));
let _e1897 = global_2.member[bitcast<u32>(select(0i, _e1892, (_e1892 > 0i)))];
let _e1901 = (_e1887 + 1i);
let _e1903 = select(_e1341, _e1901, (_e1901 < _e1341));
let _e1908 = global_2.member[bitcast<u32>(select(0i, _e1903, (_e1903 > 0i)))];
let _e1915 = ((_e1897 >> bitcast<u32>((_e1890 & 31u))) | ((_e1908 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1890) & 31u))));
let _e1916 = local_26.member_1[1u];
let _e1922 = f32(bitcast<i32>(((_e1915 >> bitcast<u32>((_e1916 & 31u))) & 255u)));
let _e1923 = local_26.member_1[2u];
let _e1930 = local_27[0u];
let _e1933 = (_e1922 + ((f32(bitcast<i32>(((_e1915 >> bitcast<u32>((_e1923 & 31u))) & 255u))) - _e1922) * _e1930));
let _e1935 = local_26.member[0u];
let _e1936 = ((_e1366 + _e1357) + _e1935);
let _e1938 = (_e1936 >> bitcast<u32>(2i));
let _e1941 = bitcast<u32>(((_e1936 & 3i) * 8i));
let _e1943 = select(_e1341, _e1938, (_e1938 < _e1341));
let _e1948 = global_2.member[bitcast<u32>(select(0i, _e1943, (_e1943 > 0i)))];
let _e1952 = (_e1938 + 1i);
let _e1954 = select(_e1341, _e1952, (_e1952 < _e1341));
let _e1959 = global_2.member[bitcast<u32>(select(0i, _e1954, (_e1954 > 0i)))];
let _e1966 = ((_e1948 >> bitcast<u32>((_e1941 & 31u))) | ((_e1959 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1941) & 31u))));
let _e1967 = local_26.member_1[1u];
let _e1973 = f32(bitcast<i32>(((_e1966 >> bitcast<u32>((_e1967 & 31u))) & 255u)));
let _e1974 = local_26.member_1[2u];
let _e1981 = local_27[0u];
let _e1984 = (_e1973 + ((f32(bitcast<i32>(((_e1966 >> bitcast<u32>((_e1974 & 31u))) & 255u))) - _e1973) * _e1981));
let _e1986 = local_26.member[0u];
let _e1987 = ((_e1356 + _e1359) + _e1986);
let _e1989 = (_e1987 >> bitcast<u32>(2i));
let _e1992 = bitcast<u32>(((_e1987 & 3i) * 8i));
let _e1994 = select(_e1341, _e1989, (_e1989 < _e1341));
let _e1999 = global_2.member[bitcast<u32>(select(0i, _e1994, (_e1994 > 0i)))];
let _e2003 = (_e1989 + 1i);
let _e2005 = select(_e1341, _e2003, (_e2003 < _e1341));
let _e2010 = global_2.member[bitcast<u32>(select(0i, _e2005, (_e2005 > 0i)))];
let _e2017 = ((_e1999 >> bitcast<u32>((_e1992 & 31u))) | ((_e2010 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1992) & 31u))));
let _e2018 = local_26.member_1[1u];
let _e2024 = f32(bitcast<i32>(((_e2017 >> bitcast<u32>((_e2018 & 31u))) & 255u)));
let _e2025 = local_26.member_1[2u];
let _e2032 = local_27[0u];
let _e2037 = local_26.member[0u];
let _e2038 = ((_e1366 + _e1359) + _e2037);
let _e2040 = (_e2038 >> bitcast<u32>(2i));
let _e2043 = bitcast<u32>(((_e2038 & 3i) * 8i));
let _e2045 = select(_e1341, _e2040, (_e2040 < _e1341));
let _e2050 = global_2.member[bitcast<u32>(select(0i, _e2045, (_e2045 > 0i)))];
let _e2054 = (_e2040 + 1i);
let _e2056 = select(_e1341, _e2054, (_e2054 < _e1341));
let _e2061 = global_2.member[bitcast<u32>(select(0i, _e2056, (_e2056 > 0i)))];
let _e2068 = ((_e2050 >> bitcast<u32>((_e2043 & 31u))) | ((_e2061 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2043) & 31u))));
let _e2069 = local_26.member_1[1u];
let _e2075 = f32(bitcast<i32>(((_e2068 >> bitcast<u32>((_e2069 & 31u))) & 255u)));
let _e2076 = local_26.member_1[2u];
let _e2083 = local_27[0u];
let _e2088 = local_27[1u];
let _e2091 = (_e1455 + ((_e1528 - _e1455) * _e2088));
let _e2092 = local_27[1u];
let _e2095 = (_e1601 + ((_e1674 - _e1601) * _e2092));
let _e2096 = local_27[1u];
let _e2099 = (_e1451 + (((_e1499 + ((_e1506 - _e1499) * _e1521)) - _e1451) * _e2096));
let _e2100 = local_27[1u];
let _e2105 = local_27[2u];
let _e2109 = local_27[1u];
let _e2112 = (_e1459 + (((_e1513 + ((f32(bitcast<i32>(((_e1492 >> bitcast<u32>((_e1514 & 31u))) & 255u))) - _e1513) * _e1529)) - _e1459) * _e2109));
let _e2113 = local_27[1u];
let _e2117 = local_27[2u];
let _e2121 = local_27[1u];
let _e2124 = (_e1729 + ((_e1455 - _e1729) * _e2121));
let _e2125 = local_27[1u];
let _e2129 = local_27[2u];
let _e2133 = local_27[1u];
let _e2136 = (_e1528 + (((_e1769 + ((f32(bitcast<i32>(((_e1762 >> bitcast<u32>((_e1770 & 31u))) & 255u))) - _e1769) * _e1777)) - _e1528) * _e2133));
let _e2137 = local_27[1u];
let _e2141 = local_27[2u];
let _e2145 = local_27[1u];
let _e2148 = (_e1933 + (((_e2024 + ((f32(bitcast<i32>(((_e2017 >> bitcast<u32>((_e2025 & 31u))) & 255u))) - _e2024) * _e2032)) - _e1933) * _e2145));
let _e2149 = local_27[2u];
let _e2153 = local_27[1u];
let _e2157 = local_27[2u];
let _e2161 = local_27[2u];
let _e2168 = global_1.member.member_8.member_6;
let _e2172 = global_1.member.member_8.member_5;
let _e2174 = (((_e2091 + ((_e2095 - _e2091) * _e2161)) - _e2168) * _e2172);
let _e2175 = -(1e9f);
let _e2177 = select(_e2175, _e2174, (_e2174 > _e2175));
let _e2179 = select(1e9f, _e2177, (_e2177 < 1e9f));
let _e2181 = (((_e2099 + (((_e1597 + (((_e1645 + ((_e1652 - _e1645) * _e1667)) - _e1597) * _e2100)) - _e2099) * _e2105)) - _e2168) * _e2172);
let _e2183 = select(_e2175, _e2181, (_e2181 > _e2175));
let _e2185 = select(1e9f, _e2183, (_e2183 < 1e9f));
let _e2187 = (((_e2112 + (((_e1605 + (((_e1659 + ((f32(bitcast<i32>(((_e1638 >> bitcast<u32>((_e1660 & 31u))) & 255u))) - _e1659) * _e1675)) - _e1605) * _e2113)) - _e2112) * _e2117)) - _e2168) * _e2172);
let _e2189 = select(_e2175, _e2187, (_e2187 > _e2175));
let _e2191 = select(1e9f, _e2189, (_e2189 < 1e9f));
let _e2193 = (((_e2124 + (((_e1831 + ((_e1601 - _e1831) * _e2125)) - _e2124) * _e2129)) - _e2168) * _e2172);
let _e2195 = select(_e2175, _e2193, (_e2193 > _e2175));
let _e2197 = select(1e9f, _e2195, (_e2195 < 1e9f));
let _e2199 = (((_e2136 + (((_e1674 + (((_e1871 + ((f32(bitcast<i32>(((_e1864 >> bitcast<u32>((_e1872 & 31u))) & 255u))) - _e1871) * _e1879)) - _e1674) * _e2137)) - _e2136) * _e2141)) - _e2168) * _e2172);
let _e2201 = select(_e2175, _e2199, (_e2199 > _e2175));
let _e2203 = select(1e9f, _e2201, (_e2201 < 1e9f));
let _e2205 = (((_e2148 + ((_e2091 - _e2148) * _e2149)) - _e2168) * _e2172);
let _e2207 = select(_e2175, _e2205, (_e2205 > _e2175));
let _e2209 = select(1e9f, _e2207, (_e2207 < 1e9f));
let _e2211 = (((_e2095 + (((_e1984 + (((_e2075 + ((f32(bitcast<i32>(((_e2068 >> bitcast<u32>((_e2076 & 31u))) & 255u))) - _e2075) * _e2083)) - _e1984) * _e2153)) - _e2095) * _e2157)) - _e2168) * _e2172);
let _e2213 = select(_e2175, _e2211, (_e2211 > _e2175));
let _e2215 = select(1e9f, _e2213, (_e2213 < 1e9f));
local_24 = _e2179;
let _e2216 = local_24;
local_25 = _e2216;
let _e2217 = local_25;
let _e2219 = (bitcast<i32>(_e167) - 1i);
let _e2221 = select(_e2219, 263197i, (263197i < _e2219));
let _e2226 = global_3.member[bitcast<u32>(select(0i, _e2221, (_e2221 > 0i)))];
let _e2227 = bitcast<f32>(_e2226);
let _e2229 = select(_e2219, 263198i, (263198i < _e2219));
let _e2232 = bitcast<u32>(select(0i, _e2229, (_e2229 > 0i)));
let _e2234 = global_3.member[_e2232];
let _e2235 = bitcast<f32>(_e2234);
let _e2237 = select(_e2219, 263199i, (263199i < _e2219));
let _e2242 = global_3.member[bitcast<u32>(select(0i, _e2237, (_e2237 > 0i)))];
let _e2243 = bitcast<f32>(_e2242);
let _e2245 = ((_e2217 - _e2227) * _e2235);
let _e2247 = select(0f, _e2245, (_e2245 > 0f));
let _e2250 = local_25;
let _e2252 = select(_e2219, 263200i, (263200i < _e2219));
let _e2257 = global_3.member[bitcast<u32>(select(0i, _e2252, (_e2252 > 0i)))];
let _e2258 = bitcast<f32>(_e2257);
let _e2260 = select(_e2219, 263201i, (263201i < _e2219));
let _e2265 = global_3.member[bitcast<u32>(select(0i, _e2260, (_e2260 > 0i)))];
let _e2266 = bitcast<f32>(_e2265);
let _e2268 = select(_e2219, 263202i, (263202i < _e2219));
let _e2273 = global_3.member[bitcast<u32>(select(0i, _e2268, (_e2268 > 0i)))];
let _e2274 = bitcast<f32>(_e2273);
let _e2276 = ((_e2250 - _e2258) * _e2266);
let _e2278 = select(0f, _e2276, (_e2276 > 0f));
let _e2282 = local_25;
let _e2284 = select(_e2219, 263203i, (263203i < _e2219));
let _e2289 = global_3.member[bitcast<u32>(select(0i, _e2284, (_e2284 > 0i)))];
let _e2290 = bitcast<f32>(_e2289);
let _e2292 = select(_e2219, 263204i, (263204i < _e2219));
let _e2297 = global_3.member[bitcast<u32>(select(0i, _e2292, (_e2292 > 0i)))];
let _e2298 = bitcast<f32>(_e2297);
let _e2300 = select(_e2219, 263205i, (263205i < _e2219));
let _e2305 = global_3.member[bitcast<u32>(select(0i, _e2300, (_e2300 > 0i)))];
let _e2306 = bitcast<f32>(_e2305);
let _e2308 = ((_e2282 - _e2290) * _e2298);
let _e2310 = select(0f, _e2308, (_e2308 > 0f));
let _e2313 = local_25;
let _e2315 = select(_e2219, 263206i, (263206i < _e2219));
let _e2320 = global_3.member[bitcast<u32>(select(0i, _e2315, (_e2315 > 0i)))];
let _e2321 = bitcast<f32>(_e2320);
let _e2323 = select(_e2219, 263207i, (263207i < _e2219));
let _e2328 = global_3.member[bitcast<u32>(select(0i, _e2323, (_e2323 > 0i)))];
let _e2329 = bitcast<f32>(_e2328);
let _e2331 = select(_e2219, 263208i, (263208i < _e2219));
let _e2336 = global_3.member[bitcast<u32>(select(0i, _e2331, (_e2331 > 0i)))];
let _e2337 = bitcast<f32>(_e2336);
let _e2339 = ((_e2313 - _e2321) * _e2329);
let _e2341 = select(0f, _e2339, (_e2339 > 0f));
let _e2345 = ((select(_e2243, _e2247, (_e2247 < _e2243)) + select(_e2274, _e2278, (_e2278 < _e2274))) + (select(_e2306, _e2310, (_e2310 < _e2306)) + select(_e2337, _e2341, (_e2341 < _e2337))));
let _e2347 = select(0f, _e2345, (_e2345 > 0f));
let _e2349 = select(1023f, _e2347, (_e2347 < 1023f));
let _e2356 = select(0i, select(select(i32(_e2349), i32(-2147483648), (_e2349 < -2147483600f)), 2147483647i, (_e2349 > 2147483500f)), (_e2349 == _e2349));
let _e2360 = (_e2356 - select(0i, 1i, (_e2349 < f32(_e2356))));
let _e2361 = (262147i + _e2360);
let _e2363 = select(_e2219, _e2361, (_e2361 < _e2219));
let _e2369 = global_3.member[bitcast<u32>(select(0i, _e2363, (_e2363 > 0i)))];
let _e2379 = select(_e2219, 262146i, (262146i < _e2219));
let _e2385 = global_3.member[bitcast<u32>(select(0i, _e2379, (_e2379 > 0i)))];
let _e2386 = bitcast<f32>(_e2385);
let _e2387 = (f32((bitcast<i32>((_e2369 & 4095u)) - 2048i)) * _e2386);
let _e2389 = select(_e2219, 262144i, (262144i < _e2219));
let _e2395 = global_3.member[bitcast<u32>(select(0i, _e2389, (_e2389 > 0i)))];
let _e2396 = bitcast<f32>(_e2395);
let _e2398 = select(_e2219, 262145i, (262145i < _e2219));
let _e2404 = global_3.member[bitcast<u32>(select(0i, _e2398, (_e2398 > 0i)))];
let _e2405 = bitcast<f32>(_e2404);
let _e2411 = ((_e2396 + (f32(bitcast<i32>((_e2369 >> bitcast<u32>(12u)))) * _e2405)) + (_e2387 * (_e2345 - f32(_e2360))));
let _e2414 = global_3.member[_e2232];
let _e2416 = local_24;
let _e2419 = local_24;
let _e2422 = local_24;
let _e2426 = select(_e2219, 263209i, (263209i < _e2219));
let _e2432 = global_3.member[bitcast<u32>(select(0i, _e2426, (_e2426 > 0i)))];
let _e2434 = local_24;
let _e2437 = select(_e2219, 263210i, (263210i < _e2219));
let _e2443 = global_3.member[bitcast<u32>(select(0i, _e2437, (_e2437 > 0i)))];
let _e2445 = local_24;
let _e2449 = (_e2387 * select(0f, select(select(select(bitcast<f32>(_e2414), _e2266, (_e2416 >= _e2258)), _e2298, (_e2419 >= _e2290)), _e2329, (_e2422 >= _e2321)), ((_e2434 >= bitcast<f32>(_e2432)) && (_e2445 <= bitcast<f32>(_e2443)))));
if _e1230 {
let _e2456 = ((0.5f * (_e2191 - _e2185)) * _e2449);
let _e2457 = ((0.5f * (_e2203 - _e2197)) * _e2449);
let _e2458 = ((0.5f * (_e2215 - _e2209)) * _e2449);
phi_7186_ = type_32(_e2411, vec3<f32>(_e2456, _e2457, _e2458), vec3<f32>((_e2456 * _e2411), (_e2457 * _e2411), (_e2458 * _e2411)));
} else {
local_22 = _e2185;
let _e2465 = local_22;
local_23 = _e2465;
let _e2466 = local_23;
let _e2468 = ((_e2466 - _e2227) * _e2235);
let _e2470 = select(0f, _e2468, (_e2468 > 0f));
let _e2473 = local_23;
let _e2475 = ((_e2473 - _e2258) * _e2266);
let _e2477 = select(0f, _e2475, (_e2475 > 0f));
let _e2481 = local_23;
let _e2483 = ((_e2481 - _e2290) * _e2298);
let _e2485 = select(0f, _e2483, (_e2483 > 0f));
let _e2488 = local_23;
let _e2490 = ((_e2488 - _e2321) * _e2329);
let _e2492 = select(0f, _e2490, (_e2490 > 0f));
let _e2496 = ((select(_e2243, _e2470, (_e2470 < _e2243)) + select(_e2274, _e2477, (_e2477 < _e2274))) + (select(_e2306, _e2485, (_e2485 < _e2306)) + select(_e2337, _e2492, (_e2492 < _e2337))));
let _e2498 = select(0f, _e2496, (_e2496 > 0f));
let _e2500 = select(1023f, _e2498, (_e2498 < 1023f));
let _e2507 = select(0i, select(select(i32(_e2500), i32(-2147483648), (_e2500 < -2147483600f)), 2147483647i, (_e2500 > 2147483500f)), (_e2500 == _e2500));
let _e2511 = (_e2507 - select(0i, 1i, (_e2500 < f32(_e2507))));
let _e2512 = (262147i + _e2511);
let _e2514 = select(_e2219, _e2512, (_e2512 < _e2219));
let _e2520 = global_3.member[bitcast<u32>(select(0i, _e2514, (_e2514 > 0i)))];
let _e2535 = ((_e2396 + (f32(bitcast<i32>((_e2520 >> bitcast<u32>(12u)))) * _e2405)) + ((f32((bitcast<i32>((_e2520 & 4095u)) - 2048i)) * _e2386) * (_e2496 - f32(_e2511))));
local_20 = _e2191;
let _e2536 = local_20;
local_21 = _e2536;
let _e2537 = local_21;
let _e2539 = ((_e2537 - _e2227) * _e2235);
let _e2541 = select(0f, _e2539, (_e2539 > 0f));
let _e2544 = local_21;
let _e2546 = ((_e2544 - _e2258) * _e2266);
let _e2548 = select(0f, _e2546, (_e2546 > 0f));
let _e2552 = local_21;
let _e2554 = ((_e2552 - _e2290) * _e2298);
let _e2556 = select(0f, _e2554, (_e2554 > 0f));
let _e2559 = local_21;
let _e2561 = ((_e2559 - _e2321) * _e2329);
let _e2563 = select(0f, _e2561, (_e2561 > 0f));
let _e2567 = ((select(_e2243, _e2541, (_e2541 < _e2243)) + select(_e2274, _e2548, (_e2548 < _e2274))) + (select(_e2306, _e2556, (_e2556 < _e2306)) + select(_e2337, _e2563, (_e2563 < _e2337))));
let _e2569 = select(0f, _e2567, (_e2567 > 0f));
let _e2571 = select(1023f, _e2569, (_e2569 < 1023f));
let _e2578 = select(0i, select(select(i32(_e2571), i32(-2147483648), (_e2571 < -2147483600f)), 2147483647i, (_e2571 > 2147483500f)), (_e2571 == _e2571));
let _e2582 = (_e2578 - select(0i, 1i, (_e2571 < f32(_e2578))));
let _e2583 = (262147i + _e2582);
let _e2585 = select(_e2219, _e2583, (_e2583 < _e2219));
let _e2591 = global_3.member[bitcast<u32>(select(0i, _e2585, (_e2585 > 0i)))];
let _e2606 = ((_e2396 + (f32(bitcast<i32>((_e2591 >> bitcast<u32>(12u)))) * _e2405)) + ((f32((bitcast<i32>((_e2591 & 4095u)) - 2048i)) * _e2386) * (_e2567 - f32(_e2582))));
local_18 = _e2197;
let _e2607 = local_18;
local_19 = _e2607;
let _e2608 = local_19;
let _e2610 = ((_e2608 - _e2227) * _e2235);
let _e2612 = select(0f, _e2610, (_e2610 > 0f));
let _e2615 = local_19;
let _e2617 = ((_e2615 - _e2258) * _e2266);
let _e2619 = select(0f, _e2617, (_e2617 > 0f));
let _e2623 = local_19;
let _e2625 = ((_e2623 - _e2290) * _e2298);
let _e2627 = select(0f, _e2625, (_e2625 > 0f));
let _e2630 = local_19;
let _e2632 = ((_e2630 - _e2321) * _e2329);
let _e2634 = select(0f, _e2632, (_e2632 > 0f));
let _e2638 = ((select(_e2243, _e2612, (_e2612 < _e2243)) + select(_e2274, _e2619, (_e2619 < _e2274))) + (select(_e2306, _e2627, (_e2627 < _e2306)) + select(_e2337, _e2634, (_e2634 < _e2337))));
let _e2640 = select(0f, _e2638, (_e2638 > 0f));
let _e2642 = select(1023f, _e2640, (_e2640 < 1023f));
let _e2649 = select(0i, select(select(i32(_e2642), i32(-2147483648), (_e2642 < -2147483600f)), 2147483647i, (_e2642 > 2147483500f)), (_e2642 == _e2642));
let _e2653 = (_e2649 - select(0i, 1i, (_e2642 < f32(_e2649))));
let _e2654 = (262147i + _e2653);
let _e2656 = select(_e2219, _e2654, (_e2654 < _e2219));
let _e2662 = global_3.member[bitcast<u32>(select(0i, _e2656, (_e2656 > 0i)))];
let _e2677 = ((_e2396 + (f32(bitcast<i32>((_e2662 >> bitcast<u32>(12u)))) * _e2405)) + ((f32((bitcast<i32>((_e2662 & 4095u)) - 2048i)) * _e2386) * (_e2638 - f32(_e2653))));
local_16 = _e2203;
let _e2678 = local_16;
local_17 = _e2678;
let _e2679 = local_17;
let _e2681 = ((_e2679 - _e2227) * _e2235);
let _e2683 = select(0f, _e2681, (_e2681 > 0f));
let _e2686 = local_17;
let _e2688 = ((_e2686 - _e2258) * _e2266);
let _e2690 = select(0f, _e2688, (_e2688 > 0f));
let _e2694 = local_17;
let _e2696 = ((_e2694 - _e2290) * _e2298);
let _e2698 = select(0f, _e2696, (_e2696 > 0f));
let _e2701 = local_17;
let _e2703 = ((_e2701 - _e2321) * _e2329);
let _e2705 = select(0f, _e2703, (_e2703 > 0f));
let _e2709 = ((select(_e2243, _e2683, (_e2683 < _e2243)) + select(_e2274, _e2690, (_e2690 < _e2274))) + (select(_e2306, _e2698, (_e2698 < _e2306)) + select(_e2337, _e2705, (_e2705 < _e2337))));
let _e2711 = select(0f, _e2709, (_e2709 > 0f));
let _e2713 = select(1023f, _e2711, (_e2711 < 1023f));
let _e2720 = select(0i, select(select(i32(_e2713), i32(-2147483648), (_e2713 < -2147483600f)), 2147483647i, (_e2713 > 2147483500f)), (_e2713 == _e2713));
let _e2724 = (_e2720 - select(0i, 1i, (_e2713 < f32(_e2720))));
let _e2725 = (262147i + _e2724);
let _e2727 = select(_e2219, _e2725, (_e2725 < _e2219));
let _e2733 = global_3.member[bitcast<u32>(select(0i, _e2727, (_e2727 > 0i)))];
let _e2748 = ((_e2396 + (f32(bitcast<i32>((_e2733 >> bitcast<u32>(12u)))) * _e2405)) + ((f32((bitcast<i32>((_e2733 & 4095u)) - 2048i)) * _e2386) * (_e2709 - f32(_e2724))));
local_14 = _e2209;
let _e2749 = local_14;
local_15 = _e2749;
let _e2750 = local_15;
let _e2752 = ((_e2750 - _e2227) * _e2235);
let _e2754 = select(0f, _e2752, (_e2752 > 0f));
let _e2757 = local_15;
let _e2759 = ((_e2757 - _e2258) * _e2266);
let _e2761 = select(0f, _e2759, (_e2759 > 0f));
let _e2765 = local_15;
let _e2767 = ((_e2765 - _e2290) * _e2298);
let _e2769 = select(0f, _e2767, (_e2767 > 0f));
let _e2772 = local_15;
let _e2774 = ((_e2772 - _e2321) * _e2329);
let _e2776 = select(0f, _e2774, (_e2774 > 0f));
let _e2780 = ((select(_e2243, _e2754, (_e2754 < _e2243)) + select(_e2274, _e2761, (_e2761 < _e2274))) + (select(_e2306, _e2769, (_e2769 < _e2306)) + select(_e2337, _e2776, (_e2776 < _e2337))));
let _e2782 = select(0f, _e2780, (_e2780 > 0f));
let _e2784 = select(1023f, _e2782, (_e2782 < 1023f));
let _e2791 = select(0i, select(select(i32(_e2784), i32(-2147483648), (_e2784 < -2147483600f)), 2147483647i, (_e2784 > 2147483500f)), (_e2784 == _e2784));
let _e2795 = (_e2791 - select(0i, 1i, (_e2784 < f32(_e2791))));
let _e2796 = (262147i + _e2795);
let _e2798 = select(_e2219, _e2796, (_e2796 < _e2219));
let _e2804 = global_3.member[bitcast<u32>(select(0i, _e2798, (_e2798 > 0i)))];
let _e2819 = ((_e2396 + (f32(bitcast<i32>((_e2804 >> bitcast<u32>(12u)))) * _e2405)) + ((f32((bitcast<i32>((_e2804 & 4095u)) - 2048i)) * _e2386) * (_e2780 - f32(_e2795))));
local_12 = _e2215;
let _e2820 = local_12;
local_13 = _e2820;
let _e2821 = local_13;
let _e2823 = ((_e2821 - _e2227) * _e2235);
let _e2825 = select(0f, _e2823, (_e2823 > 0f));
let _e2828 = local_13;
let _e2830 = ((_e2828 - _e2258) * _e2266);
let _e2832 = select(0f, _e2830, (_e2830 > 0f));
let _e2836 = local_13;
let _e2838 = ((_e2836 - _e2290) * _e2298);
let _e2840 = select(0f, _e2838, (_e2838 > 0f));
let _e2843 = local_13;
let _e2845 = ((_e2843 - _e2321) * _e2329);
let _e2847 = select(0f, _e2845, (_e2845 > 0f));
let _e2851 = ((select(_e2243, _e2825, (_e2825 < _e2243)) + select(_e2274, _e2832, (_e2832 < _e2274))) + (select(_e2306, _e2840, (_e2840 < _e2306)) + select(_e2337, _e2847, (_e2847 < _e2337))));
let _e2853 = select(0f, _e2851, (_e2851 > 0f));
let _e2855 = select(1023f, _e2853, (_e2853 < 1023f));
let _e2862 = select(0i, select(select(i32(_e2855), i32(-2147483648), (_e2855 < -2147483600f)), 2147483647i, (_e2855 > 2147483500f)), (_e2855 == _e2855));
let _e2866 = (_e2862 - select(0i, 1i, (_e2855 < f32(_e2862))));
let _e2867 = (262147i + _e2866);
let _e2869 = select(_e2219, _e2867, (_e2867 < _e2219));
let _e2875 = global_3.member[bitcast<u32>(select(0i, _e2869, (_e2869 > 0i)))];
let _e2890 = ((_e2396 + (f32(bitcast<i32>((_e2875 >> bitcast<u32>(12u)))) * _e2405)) + ((f32((bitcast<i32>((_e2875 & 4095u)) - 2048i)) * _e2386) * (_e2851 - f32(_e2866))));
let _e2891 = (_e2606 - _e2535);
let _e2893 = (_e2748 - _e2677);
let _e2895 = (_e2890 - _e2819);
phi_7186_ = type_32(_e2411, vec3<f32>((0.5f * _e2891), (0.5f * _e2893), (0.5f * _e2895)), vec3<f32>((0.25f * (_e2891 * (_e2606 + _e2535))), (0.25f * (_e2893 * (_e2748 + _e2677))), (0.25f * (_e2895 * (_e2890 + _e2819)))));
}
let _e2910 = phi_7186_;
let _e2925 = select(0f, 1f, ((((((_e1210 >= -0.5f) && (_e1210 <= _e1237)) && (_e1216 >= -0.5f)) && (_e1216 <= _e1247)) && (_e1222 >= -0.5f)) && (_e1222 <= _e1257)));
let _e2927 = (0.5f * (_e2191 - _e2185));
let _e2929 = (0.5f * (_e2203 - _e2197));
let _e2931 = (0.5f * (_e2215 - _e2209));
let _e2937 = global_1.member.member_8.member.member.member;
let _e2943 = global_1.member.member_8.member.member.member_1;
let _e2949 = global_1.member.member_8.member.member.member_2;
let _e2955 = global_1.member.member_8.member_1.member.member;
let _e2961 = global_1.member.member_8.member_1.member.member_1;
let _e2967 = global_1.member.member_8.member_1.member.member_2;
let _e2973 = global_1.member.member_8.member_2.member.member;
let _e2979 = global_1.member.member_8.member_2.member.member_1;
let _e2985 = global_1.member.member_8.member_2.member.member_2;
phi_7889_ = type_33(_e2179, vec3<f32>(((((_e2937 * _e2927) + (_e2955 * _e2929)) + (_e2973 * _e2931)) * _e2925), ((((_e2943 * _e2927) + (_e2961 * _e2929)) + (_e2979 * _e2931)) * _e2925), ((((_e2949 * _e2927) + (_e2967 * _e2929)) + (_e2985 * _e2931)) * _e2925)), _e2910.member, vec3<f32>(((((_e2937 * _e2910.member_2.x) + (_e2955 * _e2910.member_2.y)) + (_e2973 * _e2910.member_2.z)) * _e2925), ((((_e2943 * _e2910.member_2.x) + (_e2961 * _e2910.member_2.y)) + (_e2979 * _e2910.member_2.z)) * _e2925), ((((_e2949 * _e2910.member_2.x) + (_e2967 * _e2910.member_2.y)) + (_e2985 * _e2910.member_2.z)) * _e2925)), vec3<f32>(((((_e2937 * _e2910.member_1.x) + (_e2955 * _e2910.member_1.y)) + (_e2973 * _e2910.member_1.z)) * _e2925), ((((_e2943 * _e2910.member_1.x) + (_e2961 * _e2910.member_1.y)) + (_e2979 * _e2910.member_1.z)) * _e2925), ((((_e2949 * _e2910.member_1.x) + (_e2967 * _e2910.member_1.y)) + (_e2985 * _e2910.member_1.z)) * _e2925)));
} else {
let _e3054 = global_1.member.member_8.member_3.member;
let _e3055 = (_e3054 - 0.5f);
let _e3057 = select(-0.5f, _e1210, (_e1210 > -0.5f));
let _e3059 = select(_e3055, _e3057, (_e3057 < _e3055));
let _e3064 = global_1.member.member_8.member_3.member_1;
let _e3065 = (_e3064 - 0.5f);
let _e3067 = select(-0.5f, _e1216, (_e1216 > -0.5f));
let _e3069 = select(_e3065, _e3067, (_e3067 < _e3065));
let _e3074 = global_1.member.member_8.member_3.member_2;
let _e3075 = (_e3074 - 0.5f);
let _e3077 = select(-0.5f, _e1222, (_e1222 > -0.5f));
let _e3079 = select(_e3075, _e3077, (_e3077 < _e3075));
let _e3081 = select(-1f, _e3059, (_e3059 > -1f));
let _e3083 = select(_e3054, _e3081, (_e3081 < _e3054));
let _e3090 = select(0i, select(select(i32(_e3083), i32(-2147483648), (_e3083 < -2147483600f)), 2147483647i, (_e3083 > 2147483500f)), (_e3083 == _e3083));
let _e3094 = (_e3090 - select(0i, 1i, (_e3083 < f32(_e3090))));
let _e3096 = select(-1f, _e3069, (_e3069 > -1f));
let _e3098 = select(_e3064, _e3096, (_e3096 < _e3064));
let _e3105 = select(0i, select(select(i32(_e3098), i32(-2147483648), (_e3098 < -2147483600f)), 2147483647i, (_e3098 > 2147483500f)), (_e3098 == _e3098));
let _e3109 = (_e3105 - select(0i, 1i, (_e3098 < f32(_e3105))));
let _e3111 = select(-1f, _e3079, (_e3079 > -1f));
let _e3113 = select(_e3074, _e3111, (_e3111 < _e3074));
let _e3120 = select(0i, select(select(i32(_e3113), i32(-2147483648), (_e3113 < -2147483600f)), 2147483647i, (_e3113 > 2147483500f)), (_e3113 == _e3113));
let _e3124 = (_e3120 - select(0i, 1i, (_e3113 < f32(_e3120))));
let _e3128 = global_1.member.member_8.member_7;
let _e3132 = global_1.member.member_8.member_8;
let _e3133 = (_e3094 + 1i);
let _e3134 = (_e3109 + 1i);
let _e3135 = (_e3124 + 1i);
let _e3140 = global_1.member.member_8.member_11.member;
let _e3146 = global_1.member.member_8.member_11.member_1;
let _e3157 = ((_e3133 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3140) * ((_e3134 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3146) * (_e3135 >> bitcast<u32>(4i))))));
let _e3159 = (bitcast<i32>(_e162) - 1i);
let _e3161 = select(_e3159, _e3157, (_e3157 < _e3159));
let _e3167 = global_2.member[bitcast<u32>(select(0i, _e3161, (_e3161 > 0i)))];
let _e3169 = (_e3133 & 15i);
let _e3172 = ((_e3134 & 15i) * _e3128);
let _e3174 = (bitcast<i32>(_e3167) + ((_e3135 & 15i) * _e3132));
let _e3175 = (_e3172 + _e3128);
let _e3177 = (_e3172 + (2i * _e3128));
let _e3178 = (_e3174 + _e3132);
let _e3180 = (_e3174 + (2i * _e3132));
local_10 = type_29(array<i32, 4>(_e3169, _e3169, _e3169, _e3169), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_11 = vec3<f32>((_e3059 - f32(_e3094)), (_e3069 - f32(_e3109)), (_e3079 - f32(_e3124)));
let _e3194 = local_10.member[0u];
let _e3195 = ((_e3178 + _e3175) + _e3194);
let _e3197 = (_e3195 >> bitcast<u32>(2i));
let _e3200 = bitcast<u32>(((_e3195 & 3i) * 8i));
let _e3202 = select(_e3159, _e3197, (_e3197 < _e3159));
let _e3207 = global_2.member[bitcast<u32>(select(0i, _e3202, (_e3202 > 0i)))];
let _e3211 = (_e3197 + 1i);
let _e3213 = select(_e3159, _e3211, (_e3211 < _e3159));
let _e3218 = global_2.member[bitcast<u32>(select(0i, _e3213, (_e3213 > 0i)))];
let _e3225 = ((_e3207 >> bitcast<u32>((_e3200 & 31u))) | ((_e3218 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3200) & 31u))));
let _e3228 = local_10.member_1[1u];
let _e3234 = f32(bitcast<i32>(((_e3225 >> bitcast<u32>((_e3228 & 31u))) & 255u)));
let _e3237 = local_10.member_1[2u];
let _e3244 = local_11[0u];
let _e3247 = (_e3234 + ((f32(bitcast<i32>(((_e3225 >> bitcast<u32>((_e3237 & 31u))) & 255u))) - _e3234) * _e3244));
let _e3249 = local_10.member[0u];
let _e3250 = ((_e3178 + _e3177) + _e3249);
let _e3252 = (_e3250 >> bitcast<u32>(2i));
let _e3255 = bitcast<u32>(((_e3250 & 3i) * 8i));
let _e3257 = select(_e3159, _e3252, (_e3252 < _e3159));
let _e3262 = global_2.member[bitcast<u32>(select(0i, _e3257, (_e3257 > 0i)))];
let _e3266 = (_e3252 + 1i);
let _e3268 = select(_e3159, _e3266, (_e3266 < _e3159));
let _e3273 = global_2.member[bitcast<u32>(select(0i, _e3268, (_e3268 > 0i)))];
let _e3280 = ((_e3262 >> bitcast<u32>((_e3255 & 31u))) | ((_e3273 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3255) & 31u))));
let _e3281 = local_10.member_1[1u];
let _e3287 = f32(bitcast<i32>(((_e3280 >> bitcast<u32>((_e3281 & 31u))) & 255u)));
let _e3288 = local_10.member_1[2u];
let _e3295 = local_11[0u];
let _e3300 = local_11[1u];
let _e3303 = (_e3247 + (((_e3287 + ((f32(bitcast<i32>(((_e3280 >> bitcast<u32>((_e3288 & 31u))) & 255u))) - _e3287) * _e3295)) - _e3247) * _e3300));
let _e3305 = local_10.member[0u];
let _e3306 = ((_e3180 + _e3175) + _e3305);
let _e3308 = (_e3306 >> bitcast<u32>(2i));
let _e3311 = bitcast<u32>(((_e3306 & 3i) * 8i));
let _e3313 = select(_e3159, _e3308, (_e3308 < _e3159));
let _e3318 = global_2.member[bitcast<u32>(select(0i, _e3313, (_e3313 > 0i)))];
let _e3322 = (_e3308 + 1i);
let _e3324 = select(_e3159, _e3322, (_e3322 < _e3159));
let _e3329 = global_2.member[bitcast<u32>(select(0i, _e3324, (_e3324 > 0i)))];
let _e3336 = ((_e3318 >> bitcast<u32>((_e3311 & 31u))) | ((_e3329 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3311) & 31u))));
let _e3337 = local_10.member_1[1u];
let _e3343 = f32(bitcast<i32>(((_e3336 >> bitcast<u32>((_e3337 & 31u))) & 255u)));
let _e3344 = local_10.member_1[2u];
let _e3351 = local_11[0u];
let _e3354 = (_e3343 + ((f32(bitcast<i32>(((_e3336 >> bitcast<u32>((_e3344 & 31u))) & 255u))) - _e3343) * _e3351));
let _e3356 = local_10.member[0u];
let _e3357 = ((_e3180 + _e3177) + _e3356);
let _e3359 = (_e3357 >> bitcast<u32>(2i));
let _e3362 = bitcast<u32>(((_e3357 & 3i) * 8i));
let _e3364 = select(_e3159, _e3359, (_e3359 < _e3159));
let _e3369 = global_2.member[bitcast<u32>(select(0i, _e3364, (_e3364 > 0i)))];
let _e3373 = (_e3359 + 1i);
let _e3375 = select(_e3159, _e3373, (_e3373 < _e3159));
let _e3380 = global_2.member[bitcast<u32>(select(0i, _e3375, (_e3375 > 0i)))];
let _e3387 = ((_e3369 >> bitcast<u32>((_e3362 & 31u))) | ((_e3380 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3362) & 31u))));
let _e3388 = local_10.member_1[1u];
let _e3394 = f32(bitcast<i32>(((_e3387 >> bitcast<u32>((_e3388 & 31u))) & 255u)));
let _e3395 = local_10.member_1[2u];
let _e3402 = local_11[0u];
let _e3406 = local_11[1u];
let _e3411 = local_11[2u];
let _e3418 = global_1.member.member_8.member_6;
let _e3422 = global_1.member.member_8.member_5;
let _e3424 = (((_e3303 + (((_e3354 + (((_e3394 + ((f32(bitcast<i32>(((_e3387 >> bitcast<u32>((_e3395 & 31u))) & 255u))) - _e3394) * _e3402)) - _e3354) * _e3406)) - _e3303) * _e3411)) - _e3418) * _e3422);
let _e3425 = -(1e9f);
let _e3427 = select(_e3425, _e3424, (_e3424 > _e3425));
phi_7889_ = type_33(select(1e9f, _e3427, (_e3427 < 1e9f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e3432 = phi_7889_;
let _e3437 = global_1.member.member_8.member_3.member;
let _e3438 = (_e3437 - 0.5f);
let _e3440 = select(-0.5f, _e1174, (_e1174 > -0.5f));
let _e3442 = select(_e3438, _e3440, (_e3440 < _e3438));
let _e3447 = global_1.member.member_8.member_3.member_1;
let _e3448 = (_e3447 - 0.5f);
let _e3450 = select(-0.5f, _e1189, (_e1189 > -0.5f));
let _e3452 = select(_e3448, _e3450, (_e3450 < _e3448));
let _e3457 = global_1.member.member_8.member_3.member_2;
let _e3458 = (_e3457 - 0.5f);
let _e3460 = select(-0.5f, _e1204, (_e1204 > -0.5f));
let _e3462 = select(_e3458, _e3460, (_e3460 < _e3458));
let _e3464 = select(-1f, _e3442, (_e3442 > -1f));
let _e3466 = select(_e3437, _e3464, (_e3464 < _e3437));
let _e3473 = select(0i, select(select(i32(_e3466), i32(-2147483648), (_e3466 < -2147483600f)), 2147483647i, (_e3466 > 2147483500f)), (_e3466 == _e3466));
let _e3477 = (_e3473 - select(0i, 1i, (_e3466 < f32(_e3473))));
let _e3479 = select(-1f, _e3452, (_e3452 > -1f));
let _e3481 = select(_e3447, _e3479, (_e3479 < _e3447));
let _e3488 = select(0i, select(select(i32(_e3481), i32(-2147483648), (_e3481 < -2147483600f)), 2147483647i, (_e3481 > 2147483500f)), (_e3481 == _e3481));
let _e3492 = (_e3488 - select(0i, 1i, (_e3481 < f32(_e3488))));
let _e3494 = select(-1f, _e3462, (_e3462 > -1f));
let _e3496 = select(_e3457, _e3494, (_e3494 < _e3457));
let _e3503 = select(0i, select(select(i32(_e3496), i32(-2147483648), (_e3496 < -2147483600f)), 2147483647i, (_e3496 > 2147483500f)), (_e3496 == _e3496));
let _e3507 = (_e3503 - select(0i, 1i, (_e3496 < f32(_e3503))));
let _e3511 = global_1.member.member_8.member_7;
let _e3515 = global_1.member.member_8.member_8;
let _e3516 = (_e3477 + 1i);
let _e3517 = (_e3492 + 1i);
let _e3518 = (_e3507 + 1i);
let _e3523 = global_1.member.member_8.member_11.member;
let _e3524 = bitcast<i32>(_e3523);
let _e3529 = global_1.member.member_8.member_11.member_1;
let _e3530 = bitcast<i32>(_e3529);
let _e3540 = ((_e3516 >> bitcast<u32>(4i)) + (_e3524 * ((_e3517 >> bitcast<u32>(4i)) + (_e3530 * (_e3518 >> bitcast<u32>(4i))))));
let _e3542 = (bitcast<i32>(_e162) - 1i);
let _e3544 = select(_e3542, _e3540, (_e3540 < _e3542));
let _e3550 = global_2.member[bitcast<u32>(select(0i, _e3544, (_e3544 > 0i)))];
let _e3552 = (_e3516 & 15i);
let _e3555 = ((_e3517 & 15i) * _e3511);
let _e3557 = (bitcast<i32>(_e3550) + ((_e3518 & 15i) * _e3515));
let _e3558 = (_e3555 + _e3511);
let _e3559 = (2i * _e3511);
let _e3560 = (_e3555 + _e3559);
let _e3561 = (_e3557 + _e3515);
let _e3562 = (2i * _e3515);
let _e3563 = (_e3557 + _e3562);
local_8 = type_29(array<i32, 4>(_e3552, _e3552, _e3552, _e3552), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_9 = vec3<f32>((_e3442 - f32(_e3477)), (_e3452 - f32(_e3492)), (_e3462 - f32(_e3507)));
let _e3577 = local_8.member[0u];
let _e3578 = ((_e3561 + _e3558) + _e3577);
let _e3580 = (_e3578 >> bitcast<u32>(2i));
let _e3583 = bitcast<u32>(((_e3578 & 3i) * 8i));
let _e3585 = select(_e3542, _e3580, (_e3580 < _e3542));
let _e3590 = global_2.member[bitcast<u32>(select(0i, _e3585, (_e3585 > 0i)))];
let _e3594 = (_e3580 + 1i);
let _e3596 = select(_e3542, _e3594, (_e3594 < _e3542));
let _e3601 = global_2.member[bitcast<u32>(select(0i, _e3596, (_e3596 > 0i)))];
let _e3608 = ((_e3590 >> bitcast<u32>((_e3583 & 31u))) | ((_e3601 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3583) & 31u))));
let _e3611 = local_8.member_1[1u];
let _e3617 = f32(bitcast<i32>(((_e3608 >> bitcast<u32>((_e3611 & 31u))) & 255u)));
let _e3620 = local_8.member_1[2u];
let _e3627 = local_9[0u];
let _e3630 = (_e3617 + ((f32(bitcast<i32>(((_e3608 >> bitcast<u32>((_e3620 & 31u))) & 255u))) - _e3617) * _e3627));
let _e3632 = local_8.member[0u];
let _e3633 = ((_e3561 + _e3560) + _e3632);
let _e3635 = (_e3633 >> bitcast<u32>(2i));
let _e3638 = bitcast<u32>(((_e3633 & 3i) * 8i));
let _e3640 = select(_e3542, _e3635, (_e3635 < _e3542));
let _e3645 = global_2.member[bitcast<u32>(select(0i, _e3640, (_e3640 > 0i)))];
let _e3649 = (_e3635 + 1i);
let _e3651 = select(_e3542, _e3649, (_e3649 < _e3542));
let _e3656 = global_2.member[bitcast<u32>(select(0i, _e3651, (_e3651 > 0i)))];
let _e3663 = ((_e3645 >> bitcast<u32>((_e3638 & 31u))) | ((_e3656 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3638) & 31u))));
let _e3664 = local_8.member_1[1u];
let _e3670 = f32(bitcast<i32>(((_e3663 >> bitcast<u32>((_e3664 & 31u))) & 255u)));
let _e3671 = local_8.member_1[2u];
let _e3678 = local_9[0u];
let _e3683 = local_9[1u];
let _e3686 = (_e3630 + (((_e3670 + ((f32(bitcast<i32>(((_e3663 >> bitcast<u32>((_e3671 & 31u))) & 255u))) - _e3670) * _e3678)) - _e3630) * _e3683));
let _e3688 = local_8.member[0u];
let _e3689 = ((_e3563 + _e3558) + _e3688);
let _e3691 = (_e3689 >> bitcast<u32>(2i));
let _e3694 = bitcast<u32>(((_e3689 & 3i) * 8i));
let _e3696 = select(_e3542, _e3691, (_e3691 < _e3542));
let _e3701 = global_2.member[bitcast<u32>(select(0i, _e3696, (_e3696 > 0i)))];
let _e3705 = (_e3691 + 1i);
let _e3707 = select(_e3542, _e3705, (_e3705 < _e3542));
let _e3712 = global_2.member[bitcast<u32>(select(0i, _e3707, (_e3707 > 0i)))];
let _e3719 = ((_e3701 >> bitcast<u32>((_e3694 & 31u))) | ((_e3712 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3694) & 31u))));
let _e3720 = local_8.member_1[1u];
let _e3726 = f32(bitcast<i32>(((_e3719 >> bitcast<u32>((_e3720 & 31u))) & 255u)));
let _e3727 = local_8.member_1[2u];
let _e3734 = local_9[0u];
let _e3737 = (_e3726 + ((f32(bitcast<i32>(((_e3719 >> bitcast<u32>((_e3727 & 31u))) & 255u))) - _e3726) * _e3734));
let _e3739 = local_8.member[0u];
let _e3740 = ((_e3563 + _e3560) + _e3739);
let _e3742 = (_e3740 >> bitcast<u32>(2i));
let _e3745 = bitcast<u32>(((_e3740 & 3i) * 8i));
let _e3747 = select(_e3542, _e3742, (_e3742 < _e3542));
let _e3752 = global_2.member[bitcast<u32>(select(0i, _e3747, (_e3747 > 0i)))];
let _e3756 = (_e3742 + 1i);
let _e3758 = select(_e3542, _e3756, (_e3756 < _e3542));
let _e3763 = global_2.member[bitcast<u32>(select(0i, _e3758, (_e3758 > 0i)))];
let _e3770 = ((_e3752 >> bitcast<u32>((_e3745 & 31u))) | ((_e3763 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3745) & 31u))));
let _e3771 = local_8.member_1[1u];
let _e3777 = f32(bitcast<i32>(((_e3770 >> bitcast<u32>((_e3771 & 31u))) & 255u)));
let _e3778 = local_8.member_1[2u];
let _e3785 = local_9[0u];
let _e3789 = local_9[1u];
let _e3794 = local_9[2u];
let _e3801 = global_1.member.member_8.member_6;
let _e3805 = global_1.member.member_8.member_5;
let _e3807 = (((_e3686 + (((_e3737 + (((_e3777 + ((f32(bitcast<i32>(((_e3770 >> bitcast<u32>((_e3778 & 31u))) & 255u))) - _e3777) * _e3785)) - _e3737) * _e3789)) - _e3686) * _e3794)) - _e3801) * _e3805);
let _e3808 = -(1e9f);
let _e3810 = select(_e3808, _e3807, (_e3807 > _e3808));
let _e3812 = select(1e9f, _e3810, (_e3810 < 1e9f));
let _e3815 = global_1.member.member_1;
let _e3817 = ((_e3815 & 16u) == 0u);
if _e3817 {
phi_8779_ = type_7(1f, 1f, 1f);
} else {
let _e3821 = global_1.member.member_16.member;
let _e3832 = ((((_e3821.member.member * _e1131) + (_e3821.member.member_1 * _e1144)) + (_e3821.member.member_2 * _e1109)) + _e3821.member_1);
let _e3838 = ((((_e3821.member.member * _e1154) + (_e3821.member.member_1 * _e1159)) + (_e3821.member.member_2 * _e1148)) + _e3821.member_1);
let _e3840 = select(_e3838, _e3832, (_e3832 < _e3838));
let _e3842 = select(_e3838, _e3832, (_e3832 > _e3838));
let _e3844 = (_e3842 - _e3840);
let _e3847 = (-(_e3840) / select(1e-30f, _e3844, (_e3844 > 1e-30f)));
let _e3849 = select(0f, _e3847, (_e3847 > 0f));
let _e3855 = select(select(select(1f, _e3849, (_e3849 < 1f)), 1f, (_e3842 <= 0f)), 0f, (_e3840 > 0f));
let _e3860 = global_1.member.member_16.member_1;
let _e3861 = (_e3860 != 0u);
let _e3871 = global_1.member.member_17.member;
let _e3882 = ((((_e3871.member.member * _e1131) + (_e3871.member.member_1 * _e1144)) + (_e3871.member.member_2 * _e1109)) + _e3871.member_1);
let _e3888 = ((((_e3871.member.member * _e1154) + (_e3871.member.member_1 * _e1159)) + (_e3871.member.member_2 * _e1148)) + _e3871.member_1);
let _e3890 = select(_e3888, _e3882, (_e3882 < _e3888));
let _e3892 = select(_e3888, _e3882, (_e3882 > _e3888));
let _e3894 = (_e3892 - _e3890);
let _e3897 = (-(_e3890) / select(1e-30f, _e3894, (_e3894 > 1e-30f)));
let _e3899 = select(0f, _e3897, (_e3897 > 0f));
let _e3905 = select(select(select(1f, _e3899, (_e3899 < 1f)), 1f, (_e3892 <= 0f)), 0f, (_e3890 > 0f));
let _e3910 = global_1.member.member_17.member_1;
let _e3911 = (_e3910 != 0u);
let _e3921 = global_1.member.member_18.member;
let _e3932 = ((((_e3921.member.member * _e1131) + (_e3921.member.member_1 * _e1144)) + (_e3921.member.member_2 * _e1109)) + _e3921.member_1);
let _e3938 = ((((_e3921.member.member * _e1154) + (_e3921.member.member_1 * _e1159)) + (_e3921.member.member_2 * _e1148)) + _e3921.member_1);
let _e3940 = select(_e3938, _e3932, (_e3932 < _e3938));
let _e3942 = select(_e3938, _e3932, (_e3932 > _e3938));
let _e3944 = (_e3942 - _e3940);
let _e3947 = (-(_e3940) / select(1e-30f, _e3944, (_e3944 > 1e-30f)));
let _e3949 = select(0f, _e3947, (_e3947 > 0f));
let _e3955 = select(select(select(1f, _e3949, (_e3949 < 1f)), 1f, (_e3942 <= 0f)), 0f, (_e3940 > 0f));
let _e3960 = global_1.member.member_18.member_1;
let _e3961 = (_e3960 != 0u);
let _e3971 = global_1.member.member_19.member;
let _e3982 = ((((_e3971.member.member * _e1131) + (_e3971.member.member_1 * _e1144)) + (_e3971.member.member_2 * _e1109)) + _e3971.member_1);
let _e3988 = ((((_e3971.member.member * _e1154) + (_e3971.member.member_1 * _e1159)) + (_e3971.member.member_2 * _e1148)) + _e3971.member_1);
let _e3990 = select(_e3988, _e3982, (_e3982 < _e3988));
let _e3992 = select(_e3988, _e3982, (_e3982 > _e3988));
let _e3994 = (_e3992 - _e3990);
let _e3997 = (-(_e3990) / select(1e-30f, _e3994, (_e3994 > 1e-30f)));
let _e3999 = select(0f, _e3997, (_e3997 > 0f));
let _e4005 = select(select(select(1f, _e3999, (_e3999 < 1f)), 1f, (_e3992 <= 0f)), 0f, (_e3990 > 0f));
let _e4010 = global_1.member.member_19.member_1;
let _e4011 = (_e4010 != 0u);
phi_8779_ = type_7(((((1f * _e3855) * _e3905) * _e3955) * _e4005), ((((1f * select(1f, _e3855, _e3861)) * select(1f, _e3905, _e3911)) * select(1f, _e3955, _e3961)) * select(1f, _e4005, _e4011)), ((((1f * select(1f, 0f, (_e3861 && (_e3838 > 0f)))) * select(1f, 0f, (_e3911 && (_e3888 > 0f)))) * select(1f, 0f, (_e3961 && (_e3938 > 0f)))) * select(1f, 0f, (_e4011 && (_e3988 > 0f)))));
}
let _e4020 = phi_8779_;
let _e4021 = (_e1210 - _e1174);
let _e4025 = (bitcast<f32>((bitcast<u32>(_e4021) & 2147483647u)) < 1e-12f);
let _e4027 = (1f / select(_e4021, 1f, _e4025));
let _e4028 = (-0.5f - _e1174);
let _e4029 = (_e4028 * _e4027);
let _e4031 = ((_e3438 - _e1174) * _e4027);
let _e4037 = select(_e4031, _e4029, (_e4029 < _e4031));
let _e4039 = select(0f, _e4037, (_e4037 > 0f));
let _e4042 = select(select(1f, _e4039, (_e4039 < 1f)), select(2f, 0f, ((_e1174 >= -0.5f) && (_e1174 <= _e3438))), _e4025);
let _e4044 = select(_e4031, _e4029, (_e4029 > _e4031));
let _e4046 = select(0f, _e4044, (_e4044 > 0f));
let _e4049 = select(select(1f, _e4046, (_e4046 < 1f)), 1f, _e4025);
let _e4050 = (_e1216 - _e1189);
let _e4054 = (bitcast<f32>((bitcast<u32>(_e4050) & 2147483647u)) < 1e-12f);
let _e4056 = (1f / select(_e4050, 1f, _e4054));
let _e4057 = (-0.5f - _e1189);
let _e4058 = (_e4057 * _e4056);
let _e4060 = ((_e3448 - _e1189) * _e4056);
let _e4066 = select(_e4060, _e4058, (_e4058 < _e4060));
let _e4068 = select(0f, _e4066, (_e4066 > 0f));
let _e4071 = select(select(1f, _e4068, (_e4068 < 1f)), select(2f, 0f, ((_e1189 >= -0.5f) && (_e1189 <= _e3448))), _e4054);
let _e4073 = select(_e4060, _e4058, (_e4058 > _e4060));
let _e4075 = select(0f, _e4073, (_e4073 > 0f));
let _e4078 = select(select(1f, _e4075, (_e4075 < 1f)), 1f, _e4054);
let _e4079 = (_e1222 - _e1204);
let _e4083 = (bitcast<f32>((bitcast<u32>(_e4079) & 2147483647u)) < 1e-12f);
let _e4085 = (1f / select(_e4079, 1f, _e4083));
let _e4086 = (-0.5f - _e1204);
let _e4087 = (_e4086 * _e4085);
let _e4089 = ((_e3458 - _e1204) * _e4085);
let _e4095 = select(_e4089, _e4087, (_e4087 < _e4089));
let _e4097 = select(0f, _e4095, (_e4095 > 0f));
let _e4100 = select(select(1f, _e4097, (_e4097 < 1f)), select(2f, 0f, ((_e1204 >= -0.5f) && (_e1204 <= _e3458))), _e4083);
let _e4102 = select(_e4089, _e4087, (_e4087 > _e4089));
let _e4104 = select(0f, _e4102, (_e4102 > 0f));
let _e4107 = select(select(1f, _e4104, (_e4104 < 1f)), 1f, _e4083);
let _e4109 = select(_e4078, _e4049, (_e4049 < _e4078));
let _e4113 = select(_e4071, _e4042, (_e4042 > _e4071));
let _e4116 = (select(_e4107, _e4109, (_e4109 < _e4107)) - select(_e4100, _e4113, (_e4113 > _e4100)));
let _e4119 = (_e1154 - _e1131);
let _e4120 = (_e1159 - _e1144);
let _e4121 = (_e1148 - _e1109);
let _e4126 = (((_e4119 * _e4119) + (_e4120 * _e4120)) + (_e4121 * _e4121));
let _e4134 = global_1.member.member_7.member_3;
let _e4135 = ((sqrt(select(0f, _e4126, (_e4126 > 0f))) * select(0f, _e4116, (_e4116 > 0f))) * _e4134);
if (((_e177.member_2 == 3u) || (_e177.member_2 == 4u)) || _e1224) {
local_7 = _e3812;
let _e4141 = local_7;
let _e4143 = (bitcast<i32>(_e167) - 1i);
let _e4145 = select(_e4143, 263171i, (263171i < _e4143));
let _e4150 = global_3.member[bitcast<u32>(select(0i, _e4145, (_e4145 > 0i)))];
let _e4151 = bitcast<f32>(_e4150);
let _e4153 = select(_e4143, 263172i, (263172i < _e4143));
let _e4158 = global_3.member[bitcast<u32>(select(0i, _e4153, (_e4153 > 0i)))];
let _e4159 = bitcast<f32>(_e4158);
let _e4161 = select(_e4143, 263173i, (263173i < _e4143));
let _e4166 = global_3.member[bitcast<u32>(select(0i, _e4161, (_e4161 > 0i)))];
let _e4167 = bitcast<f32>(_e4166);
let _e4169 = ((_e4141 - _e4151) * _e4159);
let _e4171 = select(0f, _e4169, (_e4169 > 0f));
let _e4174 = local_7;
let _e4176 = select(_e4143, 263174i, (263174i < _e4143));
let _e4181 = global_3.member[bitcast<u32>(select(0i, _e4176, (_e4176 > 0i)))];
let _e4182 = bitcast<f32>(_e4181);
let _e4184 = select(_e4143, 263175i, (263175i < _e4143));
let _e4189 = global_3.member[bitcast<u32>(select(0i, _e4184, (_e4184 > 0i)))];
let _e4190 = bitcast<f32>(_e4189);
let _e4192 = select(_e4143, 263176i, (263176i < _e4143));
let _e4197 = global_3.member[bitcast<u32>(select(0i, _e4192, (_e4192 > 0i)))];
let _e4198 = bitcast<f32>(_e4197);
let _e4200 = ((_e4174 - _e4182) * _e4190);
let _e4202 = select(0f, _e4200, (_e4200 > 0f));
let _e4206 = local_7;
let _e4208 = select(_e4143, 263177i, (263177i < _e4143));
let _e4213 = global_3.member[bitcast<u32>(select(0i, _e4208, (_e4208 > 0i)))];
let _e4214 = bitcast<f32>(_e4213);
let _e4216 = select(_e4143, 263178i, (263178i < _e4143));
let _e4221 = global_3.member[bitcast<u32>(select(0i, _e4216, (_e4216 > 0i)))];
let _e4222 = bitcast<f32>(_e4221);
let _e4224 = select(_e4143, 263179i, (263179i < _e4143));
let _e4229 = global_3.member[bitcast<u32>(select(0i, _e4224, (_e4224 > 0i)))];
let _e4230 = bitcast<f32>(_e4229);
let _e4232 = ((_e4206 - _e4214) * _e4222);
let _e4234 = select(0f, _e4232, (_e4232 > 0f));
let _e4237 = local_7;
let _e4239 = select(_e4143, 263180i, (263180i < _e4143));
let _e4244 = global_3.member[bitcast<u32>(select(0i, _e4239, (_e4239 > 0i)))];
let _e4245 = bitcast<f32>(_e4244);
let _e4247 = select(_e4143, 263181i, (263181i < _e4143));
let _e4252 = global_3.member[bitcast<u32>(select(0i, _e4247, (_e4247 > 0i)))];
let _e4253 = bitcast<f32>(_e4252);
let _e4255 = select(_e4143, 263182i, (263182i < _e4143));
let _e4260 = global_3.member[bitcast<u32>(select(0i, _e4255, (_e4255 > 0i)))];
let _e4261 = bitcast<f32>(_e4260);
let _e4263 = ((_e4237 - _e4245) * _e4253);
let _e4265 = select(0f, _e4263, (_e4263 > 0f));
let _e4270 = local_7;
let _e4272 = select(_e4143, 263183i, (263183i < _e4143));
let _e4277 = global_3.member[bitcast<u32>(select(0i, _e4272, (_e4272 > 0i)))];
let _e4278 = bitcast<f32>(_e4277);
let _e4280 = select(_e4143, 263184i, (263184i < _e4143));
let _e4285 = global_3.member[bitcast<u32>(select(0i, _e4280, (_e4280 > 0i)))];
let _e4286 = bitcast<f32>(_e4285);
let _e4288 = select(_e4143, 263185i, (263185i < _e4143));
let _e4293 = global_3.member[bitcast<u32>(select(0i, _e4288, (_e4288 > 0i)))];
let _e4294 = bitcast<f32>(_e4293);
let _e4296 = ((_e4270 - _e4278) * _e4286);
let _e4298 = select(0f, _e4296, (_e4296 > 0f));
let _e4301 = local_7;
let _e4303 = select(_e4143, 263186i, (263186i < _e4143));
let _e4308 = global_3.member[bitcast<u32>(select(0i, _e4303, (_e4303 > 0i)))];
let _e4309 = bitcast<f32>(_e4308);
let _e4311 = select(_e4143, 263187i, (263187i < _e4143));
let _e4316 = global_3.member[bitcast<u32>(select(0i, _e4311, (_e4311 > 0i)))];
let _e4317 = bitcast<f32>(_e4316);
let _e4319 = select(_e4143, 263188i, (263188i < _e4143));
let _e4324 = global_3.member[bitcast<u32>(select(0i, _e4319, (_e4319 > 0i)))];
let _e4325 = bitcast<f32>(_e4324);
let _e4327 = ((_e4301 - _e4309) * _e4317);
let _e4329 = select(0f, _e4327, (_e4327 > 0f));
let _e4333 = local_7;
let _e4335 = select(_e4143, 263189i, (263189i < _e4143));
let _e4340 = global_3.member[bitcast<u32>(select(0i, _e4335, (_e4335 > 0i)))];
let _e4341 = bitcast<f32>(_e4340);
let _e4343 = select(_e4143, 263190i, (263190i < _e4143));
let _e4348 = global_3.member[bitcast<u32>(select(0i, _e4343, (_e4343 > 0i)))];
let _e4349 = bitcast<f32>(_e4348);
let _e4351 = select(_e4143, 263191i, (263191i < _e4143));
let _e4356 = global_3.member[bitcast<u32>(select(0i, _e4351, (_e4351 > 0i)))];
let _e4357 = bitcast<f32>(_e4356);
let _e4359 = ((_e4333 - _e4341) * _e4349);
let _e4361 = select(0f, _e4359, (_e4359 > 0f));
let _e4364 = local_7;
let _e4366 = select(_e4143, 263192i, (263192i < _e4143));
let _e4371 = global_3.member[bitcast<u32>(select(0i, _e4366, (_e4366 > 0i)))];
let _e4372 = bitcast<f32>(_e4371);
let _e4374 = select(_e4143, 263193i, (263193i < _e4143));
let _e4379 = global_3.member[bitcast<u32>(select(0i, _e4374, (_e4374 > 0i)))];
let _e4380 = bitcast<f32>(_e4379);
let _e4382 = select(_e4143, 263194i, (263194i < _e4143));
let _e4387 = global_3.member[bitcast<u32>(select(0i, _e4382, (_e4382 > 0i)))];
let _e4388 = bitcast<f32>(_e4387);
let _e4390 = ((_e4364 - _e4372) * _e4380);
let _e4392 = select(0f, _e4390, (_e4390 > 0f));
let _e4397 = (((select(_e4167, _e4171, (_e4171 < _e4167)) + select(_e4198, _e4202, (_e4202 < _e4198))) + (select(_e4230, _e4234, (_e4234 < _e4230)) + select(_e4261, _e4265, (_e4265 < _e4261)))) + ((select(_e4294, _e4298, (_e4298 < _e4294)) + select(_e4325, _e4329, (_e4329 < _e4325))) + (select(_e4357, _e4361, (_e4361 < _e4357)) + select(_e4388, _e4392, (_e4392 < _e4388)))));
local_6 = _e3432.member;
let _e4398 = local_6;
let _e4400 = ((_e4398 - _e4151) * _e4159);
let _e4402 = select(0f, _e4400, (_e4400 > 0f));
let _e4405 = local_6;
let _e4407 = ((_e4405 - _e4182) * _e4190);
let _e4409 = select(0f, _e4407, (_e4407 > 0f));
let _e4413 = local_6;
let _e4415 = ((_e4413 - _e4214) * _e4222);
let _e4417 = select(0f, _e4415, (_e4415 > 0f));
let _e4420 = local_6;
let _e4422 = ((_e4420 - _e4245) * _e4253);
let _e4424 = select(0f, _e4422, (_e4422 > 0f));
let _e4429 = local_6;
let _e4431 = ((_e4429 - _e4278) * _e4286);
let _e4433 = select(0f, _e4431, (_e4431 > 0f));
let _e4436 = local_6;
let _e4438 = ((_e4436 - _e4309) * _e4317);
let _e4440 = select(0f, _e4438, (_e4438 > 0f));
let _e4444 = local_6;
let _e4446 = ((_e4444 - _e4341) * _e4349);
let _e4448 = select(0f, _e4446, (_e4446 > 0f));
let _e4451 = local_6;
let _e4453 = ((_e4451 - _e4372) * _e4380);
let _e4455 = select(0f, _e4453, (_e4453 > 0f));
let _e4460 = (((select(_e4167, _e4402, (_e4402 < _e4167)) + select(_e4198, _e4409, (_e4409 < _e4198))) + (select(_e4230, _e4417, (_e4417 < _e4230)) + select(_e4261, _e4424, (_e4424 < _e4261)))) + ((select(_e4294, _e4433, (_e4433 < _e4294)) + select(_e4325, _e4440, (_e4440 < _e4325))) + (select(_e4357, _e4448, (_e4448 < _e4357)) + select(_e4388, _e4455, (_e4455 < _e4388)))));
let _e4461 = (255f - 1f);
let _e4463 = select(0f, _e4397, (_e4397 > 0f));
let _e4465 = select(_e4461, _e4463, (_e4463 < _e4461));
let _e4472 = select(0i, select(select(i32(_e4465), i32(-2147483648), (_e4465 < -2147483600f)), 2147483647i, (_e4465 > 2147483500f)), (_e4465 == _e4465));
let _e4476 = (_e4472 - select(0i, 1i, (_e4465 < f32(_e4472))));
let _e4478 = select(0f, _e4460, (_e4460 > 0f));
let _e4480 = select(_e4461, _e4478, (_e4478 < _e4461));
let _e4487 = select(0i, select(select(i32(_e4480), i32(-2147483648), (_e4480 < -2147483600f)), 2147483647i, (_e4480 > 2147483500f)), (_e4480 == _e4480));
let _e4491 = (_e4487 - select(0i, 1i, (_e4480 < f32(_e4487))));
let _e4493 = select(_e4143, 263195i, (263195i < _e4143));
let _e4499 = global_3.member[bitcast<u32>(select(0i, _e4493, (_e4493 > 0i)))];
let _e4500 = bitcast<f32>(_e4499);
let _e4502 = select(_e4143, 263196i, (263196i < _e4143));
let _e4508 = global_3.member[bitcast<u32>(select(0i, _e4502, (_e4502 > 0i)))];
let _e4509 = bitcast<f32>(_e4508);
let _e4510 = (_e3432.member - _e3812);
let _e4516 = (1f / select(_e4510, 1f, (bitcast<f32>((bitcast<u32>(_e4510) & 2147483647u)) < 1e-20f)));
let _e4522 = ((select(_e4500, _e3432.member, (_e3432.member < _e4500)) - select(_e4500, _e3812, (_e3812 < _e4500))) * _e4516);
let _e4528 = ((select(_e4509, _e3432.member, (_e3432.member > _e4509)) - select(_e4509, _e3812, (_e3812 > _e4509))) * _e4516);
let _e4531 = (((_e4476 * 256i) + _e4491) * 4i);
let _e4535 = (_e4460 - f32(_e4491));
let _e4539 = select(_e4143, _e4531, (_e4531 < _e4143));
let _e4545 = global_3.member[bitcast<u32>(select(0i, _e4539, (_e4539 > 0i)))];
let _e4546 = (_e4531 + 4i);
let _e4548 = select(_e4143, _e4546, (_e4546 < _e4143));
let _e4554 = global_3.member[bitcast<u32>(select(0i, _e4548, (_e4548 > 0i)))];
let _e4555 = (_e4531 + 1024i);
let _e4557 = select(_e4143, _e4555, (_e4555 < _e4143));
let _e4563 = global_3.member[bitcast<u32>(select(0i, _e4557, (_e4557 > 0i)))];
let _e4564 = (_e4531 + 1028i);
let _e4566 = select(_e4143, _e4564, (_e4564 < _e4143));
let _e4572 = global_3.member[bitcast<u32>(select(0i, _e4566, (_e4566 > 0i)))];
let _e4574 = select(_e4143, 0i, (0i < _e4143));
let _e4580 = global_3.member[bitcast<u32>(select(0i, _e4574, (_e4574 > 0i)))];
let _e4582 = select(_e4143, 262140i, (262140i < _e4143));
let _e4588 = global_3.member[bitcast<u32>(select(0i, _e4582, (_e4582 > 0i)))];
let _e4593 = (bitcast<f32>(((_e4545 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4601 = (_e4593 + (((bitcast<f32>(((_e4554 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4593) * _e4535));
let _e4606 = (bitcast<f32>(((_e4563 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4632 = (((_e4601 + (((_e4606 + (((bitcast<f32>(((_e4572 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4606) * _e4535)) - _e4601) * (_e4397 - f32(_e4476)))) * (1f - (_e4522 + _e4528))) + (((bitcast<f32>(((_e4580 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4522) + ((bitcast<f32>(((_e4588 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4528)));
let _e4636 = -((_e4632 * (_e4135 * _e4020.member)));
let _e4638 = select(-87f, _e4636, (_e4636 > -87f));
let _e4640 = select(88f, _e4638, (_e4638 < 88f));
let _e4642 = ((_e4640 * 1.442695f) + 0.5f);
let _e4644 = select(-127f, _e4642, (_e4642 > -127f));
let _e4646 = select(128f, _e4644, (_e4644 < 128f));
let _e4653 = select(0i, select(select(i32(_e4646), i32(-2147483648), (_e4646 < -2147483600f)), 2147483647i, (_e4646 > 2147483500f)), (_e4646 == _e4646));
let _e4657 = (_e4653 - select(0i, 1i, (_e4646 < f32(_e4653))));
let _e4658 = f32(_e4657);
let _e4662 = ((_e4640 - (_e4658 * 0.6933594f)) - (_e4658 * -2.1219444e-4f));
let _e4682 = ((1f + (_e4662 * (1f + (_e4662 * (0.5f + (_e4662 * (0.16666667f + (_e4662 * (0.041666668f + (_e4662 * (0.008333334f + (_e4662 * (0.001388889f + (_e4662 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4657 + 127i)) << bitcast<u32>(23i))));
let _e4683 = (1f - _e4682);
phi_12507_ = type_35(_e4682, _e4683, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e4683 / select(1e-12f, _e4632, (_e4632 > 1e-12f))))));
} else {
local_5 = _e3812;
let _e4691 = local_5;
let _e4693 = (bitcast<i32>(_e167) - 1i);
let _e4695 = select(_e4693, 263171i, (263171i < _e4693));
let _e4700 = global_3.member[bitcast<u32>(select(0i, _e4695, (_e4695 > 0i)))];
let _e4701 = bitcast<f32>(_e4700);
let _e4703 = select(_e4693, 263172i, (263172i < _e4693));
let _e4708 = global_3.member[bitcast<u32>(select(0i, _e4703, (_e4703 > 0i)))];
let _e4709 = bitcast<f32>(_e4708);
let _e4711 = select(_e4693, 263173i, (263173i < _e4693));
let _e4716 = global_3.member[bitcast<u32>(select(0i, _e4711, (_e4711 > 0i)))];
let _e4717 = bitcast<f32>(_e4716);
let _e4719 = ((_e4691 - _e4701) * _e4709);
let _e4721 = select(0f, _e4719, (_e4719 > 0f));
let _e4724 = local_5;
let _e4726 = select(_e4693, 263174i, (263174i < _e4693));
let _e4731 = global_3.member[bitcast<u32>(select(0i, _e4726, (_e4726 > 0i)))];
let _e4732 = bitcast<f32>(_e4731);
let _e4734 = select(_e4693, 263175i, (263175i < _e4693));
let _e4739 = global_3.member[bitcast<u32>(select(0i, _e4734, (_e4734 > 0i)))];
let _e4740 = bitcast<f32>(_e4739);
let _e4742 = select(_e4693, 263176i, (263176i < _e4693));
let _e4747 = global_3.member[bitcast<u32>(select(0i, _e4742, (_e4742 > 0i)))];
let _e4748 = bitcast<f32>(_e4747);
let _e4750 = ((_e4724 - _e4732) * _e4740);
let _e4752 = select(0f, _e4750, (_e4750 > 0f));
let _e4756 = local_5;
let _e4758 = select(_e4693, 263177i, (263177i < _e4693));
let _e4763 = global_3.member[bitcast<u32>(select(0i, _e4758, (_e4758 > 0i)))];
let _e4764 = bitcast<f32>(_e4763);
let _e4766 = select(_e4693, 263178i, (263178i < _e4693));
let _e4771 = global_3.member[bitcast<u32>(select(0i, _e4766, (_e4766 > 0i)))];
let _e4772 = bitcast<f32>(_e4771);
let _e4774 = select(_e4693, 263179i, (263179i < _e4693));
let _e4779 = global_3.member[bitcast<u32>(select(0i, _e4774, (_e4774 > 0i)))];
let _e4780 = bitcast<f32>(_e4779);
let _e4782 = ((_e4756 - _e4764) * _e4772);
let _e4784 = select(0f, _e4782, (_e4782 > 0f));
let _e4787 = local_5;
let _e4789 = select(_e4693, 263180i, (263180i < _e4693));
let _e4794 = global_3.member[bitcast<u32>(select(0i, _e4789, (_e4789 > 0i)))];
let _e4795 = bitcast<f32>(_e4794);
let _e4797 = select(_e4693, 263181i, (263181i < _e4693));
let _e4802 = global_3.member[bitcast<u32>(select(0i, _e4797, (_e4797 > 0i)))];
let _e4803 = bitcast<f32>(_e4802);
let _e4805 = select(_e4693, 263182i, (263182i < _e4693));
let _e4810 = global_3.member[bitcast<u32>(select(0i, _e4805, (_e4805 > 0i)))];
let _e4811 = bitcast<f32>(_e4810);
let _e4813 = ((_e4787 - _e4795) * _e4803);
let _e4815 = select(0f, _e4813, (_e4813 > 0f));
let _e4820 = local_5;
let _e4822 = select(_e4693, 263183i, (263183i < _e4693));
let _e4827 = global_3.member[bitcast<u32>(select(0i, _e4822, (_e4822 > 0i)))];
let _e4828 = bitcast<f32>(_e4827);
let _e4830 = select(_e4693, 263184i, (263184i < _e4693));
let _e4835 = global_3.member[bitcast<u32>(select(0i, _e4830, (_e4830 > 0i)))];
let _e4836 = bitcast<f32>(_e4835);
let _e4838 = select(_e4693, 263185i, (263185i < _e4693));
let _e4843 = global_3.member[bitcast<u32>(select(0i, _e4838, (_e4838 > 0i)))];
let _e4844 = bitcast<f32>(_e4843);
let _e4846 = ((_e4820 - _e4828) * _e4836);
let _e4848 = select(0f, _e4846, (_e4846 > 0f));
let _e4851 = local_5;
let _e4853 = select(_e4693, 263186i, (263186i < _e4693));
let _e4858 = global_3.member[bitcast<u32>(select(0i, _e4853, (_e4853 > 0i)))];
let _e4859 = bitcast<f32>(_e4858);
let _e4861 = select(_e4693, 263187i, (263187i < _e4693));
let _e4866 = global_3.member[bitcast<u32>(select(0i, _e4861, (_e4861 > 0i)))];
let _e4867 = bitcast<f32>(_e4866);
let _e4869 = select(_e4693, 263188i, (263188i < _e4693));
let _e4874 = global_3.member[bitcast<u32>(select(0i, _e4869, (_e4869 > 0i)))];
let _e4875 = bitcast<f32>(_e4874);
let _e4877 = ((_e4851 - _e4859) * _e4867);
let _e4879 = select(0f, _e4877, (_e4877 > 0f));
let _e4883 = local_5;
let _e4885 = select(_e4693, 263189i, (263189i < _e4693));
let _e4890 = global_3.member[bitcast<u32>(select(0i, _e4885, (_e4885 > 0i)))];
let _e4891 = bitcast<f32>(_e4890);
let _e4893 = select(_e4693, 263190i, (263190i < _e4693));
let _e4898 = global_3.member[bitcast<u32>(select(0i, _e4893, (_e4893 > 0i)))];
let _e4899 = bitcast<f32>(_e4898);
let _e4901 = select(_e4693, 263191i, (263191i < _e4693));
let _e4906 = global_3.member[bitcast<u32>(select(0i, _e4901, (_e4901 > 0i)))];
let _e4907 = bitcast<f32>(_e4906);
let _e4909 = ((_e4883 - _e4891) * _e4899);
let _e4911 = select(0f, _e4909, (_e4909 > 0f));
let _e4914 = local_5;
let _e4916 = select(_e4693, 263192i, (263192i < _e4693));
let _e4921 = global_3.member[bitcast<u32>(select(0i, _e4916, (_e4916 > 0i)))];
let _e4922 = bitcast<f32>(_e4921);
let _e4924 = select(_e4693, 263193i, (263193i < _e4693));
let _e4929 = global_3.member[bitcast<u32>(select(0i, _e4924, (_e4924 > 0i)))];
let _e4930 = bitcast<f32>(_e4929);
let _e4932 = select(_e4693, 263194i, (263194i < _e4693));
let _e4937 = global_3.member[bitcast<u32>(select(0i, _e4932, (_e4932 > 0i)))];
let _e4938 = bitcast<f32>(_e4937);
let _e4940 = ((_e4914 - _e4922) * _e4930);
let _e4942 = select(0f, _e4940, (_e4940 > 0f));
let _e4947 = (((select(_e4717, _e4721, (_e4721 < _e4717)) + select(_e4748, _e4752, (_e4752 < _e4748))) + (select(_e4780, _e4784, (_e4784 < _e4780)) + select(_e4811, _e4815, (_e4815 < _e4811)))) + ((select(_e4844, _e4848, (_e4848 < _e4844)) + select(_e4875, _e4879, (_e4879 < _e4875))) + (select(_e4907, _e4911, (_e4911 < _e4907)) + select(_e4938, _e4942, (_e4942 < _e4938)))));
local_4 = _e3432.member;
let _e4948 = local_4;
let _e4950 = ((_e4948 - _e4701) * _e4709);
let _e4952 = select(0f, _e4950, (_e4950 > 0f));
let _e4955 = local_4;
let _e4957 = ((_e4955 - _e4732) * _e4740);
let _e4959 = select(0f, _e4957, (_e4957 > 0f));
let _e4963 = local_4;
let _e4965 = ((_e4963 - _e4764) * _e4772);
let _e4967 = select(0f, _e4965, (_e4965 > 0f));
let _e4970 = local_4;
let _e4972 = ((_e4970 - _e4795) * _e4803);
let _e4974 = select(0f, _e4972, (_e4972 > 0f));
let _e4979 = local_4;
let _e4981 = ((_e4979 - _e4828) * _e4836);
let _e4983 = select(0f, _e4981, (_e4981 > 0f));
let _e4986 = local_4;
let _e4988 = ((_e4986 - _e4859) * _e4867);
let _e4990 = select(0f, _e4988, (_e4988 > 0f));
let _e4994 = local_4;
let _e4996 = ((_e4994 - _e4891) * _e4899);
let _e4998 = select(0f, _e4996, (_e4996 > 0f));
let _e5001 = local_4;
let _e5003 = ((_e5001 - _e4922) * _e4930);
let _e5005 = select(0f, _e5003, (_e5003 > 0f));
let _e5010 = (((select(_e4717, _e4952, (_e4952 < _e4717)) + select(_e4748, _e4959, (_e4959 < _e4748))) + (select(_e4780, _e4967, (_e4967 < _e4780)) + select(_e4811, _e4974, (_e4974 < _e4811)))) + ((select(_e4844, _e4983, (_e4983 < _e4844)) + select(_e4875, _e4990, (_e4990 < _e4875))) + (select(_e4907, _e4998, (_e4998 < _e4907)) + select(_e4938, _e5005, (_e5005 < _e4938)))));
let _e5011 = (255f - 1f);
let _e5013 = select(0f, _e4947, (_e4947 > 0f));
let _e5015 = select(_e5011, _e5013, (_e5013 < _e5011));
let _e5022 = select(0i, select(select(i32(_e5015), i32(-2147483648), (_e5015 < -2147483600f)), 2147483647i, (_e5015 > 2147483500f)), (_e5015 == _e5015));
let _e5026 = (_e5022 - select(0i, 1i, (_e5015 < f32(_e5022))));
let _e5028 = select(0f, _e5010, (_e5010 > 0f));
let _e5030 = select(_e5011, _e5028, (_e5028 < _e5011));
let _e5037 = select(0i, select(select(i32(_e5030), i32(-2147483648), (_e5030 < -2147483600f)), 2147483647i, (_e5030 > 2147483500f)), (_e5030 == _e5030));
let _e5041 = (_e5037 - select(0i, 1i, (_e5030 < f32(_e5037))));
let _e5043 = select(_e4693, 263195i, (263195i < _e4693));
let _e5049 = global_3.member[bitcast<u32>(select(0i, _e5043, (_e5043 > 0i)))];
let _e5050 = bitcast<f32>(_e5049);
let _e5052 = select(_e4693, 263196i, (263196i < _e4693));
let _e5058 = global_3.member[bitcast<u32>(select(0i, _e5052, (_e5052 > 0i)))];
let _e5059 = bitcast<f32>(_e5058);
let _e5060 = (_e3432.member - _e3812);
let _e5066 = (1f / select(_e5060, 1f, (bitcast<f32>((bitcast<u32>(_e5060) & 2147483647u)) < 1e-20f)));
let _e5072 = ((select(_e5050, _e3432.member, (_e3432.member < _e5050)) - select(_e5050, _e3812, (_e3812 < _e5050))) * _e5066);
let _e5078 = ((select(_e5059, _e3432.member, (_e3432.member > _e5059)) - select(_e5059, _e3812, (_e3812 > _e5059))) * _e5066);
let _e5081 = (((_e5026 * 256i) + _e5041) * 4i);
let _e5083 = (_e4947 - f32(_e5026));
let _e5085 = (_e5010 - f32(_e5041));
let _e5087 = (1f - (_e5072 + _e5078));
let _e5089 = select(_e4693, _e5081, (_e5081 < _e4693));
let _e5095 = global_3.member[bitcast<u32>(select(0i, _e5089, (_e5089 > 0i)))];
let _e5096 = (_e5081 + 4i);
let _e5098 = select(_e4693, _e5096, (_e5096 < _e4693));
let _e5104 = global_3.member[bitcast<u32>(select(0i, _e5098, (_e5098 > 0i)))];
let _e5105 = (_e5081 + 1024i);
let _e5107 = select(_e4693, _e5105, (_e5105 < _e4693));
let _e5113 = global_3.member[bitcast<u32>(select(0i, _e5107, (_e5107 > 0i)))];
let _e5114 = (_e5081 + 1028i);
let _e5116 = select(_e4693, _e5114, (_e5114 < _e4693));
let _e5122 = global_3.member[bitcast<u32>(select(0i, _e5116, (_e5116 > 0i)))];
let _e5124 = select(_e4693, 0i, (0i < _e4693));
let _e5130 = global_3.member[bitcast<u32>(select(0i, _e5124, (_e5124 > 0i)))];
let _e5132 = select(_e4693, 262140i, (262140i < _e4693));
let _e5138 = global_3.member[bitcast<u32>(select(0i, _e5132, (_e5132 > 0i)))];
let _e5143 = (bitcast<f32>(((_e5095 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5151 = (_e5143 + (((bitcast<f32>(((_e5104 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5143) * _e5085));
let _e5156 = (bitcast<f32>(((_e5113 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5182 = (((_e5151 + (((_e5156 + (((bitcast<f32>(((_e5122 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5156) * _e5085)) - _e5151) * _e5083)) * _e5087) + (((bitcast<f32>(((_e5130 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5072) + ((bitcast<f32>(((_e5138 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5078)));
let _e5199 = (bitcast<f32>((((_e5095 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5207 = (_e5199 + (((bitcast<f32>((((_e5104 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5199) * _e5085));
let _e5212 = (bitcast<f32>((((_e5113 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5239 = (_e5081 + 1i);
let _e5241 = select(_e4693, _e5239, (_e5239 < _e4693));
let _e5247 = global_3.member[bitcast<u32>(select(0i, _e5241, (_e5241 > 0i)))];
let _e5248 = (_e5081 + 5i);
let _e5250 = select(_e4693, _e5248, (_e5248 < _e4693));
let _e5256 = global_3.member[bitcast<u32>(select(0i, _e5250, (_e5250 > 0i)))];
let _e5257 = (_e5081 + 1025i);
let _e5259 = select(_e4693, _e5257, (_e5257 < _e4693));
let _e5265 = global_3.member[bitcast<u32>(select(0i, _e5259, (_e5259 > 0i)))];
let _e5266 = (_e5081 + 1029i);
let _e5268 = select(_e4693, _e5266, (_e5266 < _e4693));
let _e5274 = global_3.member[bitcast<u32>(select(0i, _e5268, (_e5268 > 0i)))];
let _e5276 = select(_e4693, 1i, (1i < _e4693));
let _e5282 = global_3.member[bitcast<u32>(select(0i, _e5276, (_e5276 > 0i)))];
let _e5284 = select(_e4693, 262141i, (262141i < _e4693));
let _e5290 = global_3.member[bitcast<u32>(select(0i, _e5284, (_e5284 > 0i)))];
let _e5295 = (bitcast<f32>(((_e5247 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5303 = (_e5295 + (((bitcast<f32>(((_e5256 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5295) * _e5085));
let _e5308 = (bitcast<f32>(((_e5265 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5351 = (bitcast<f32>((((_e5247 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5359 = (_e5351 + (((bitcast<f32>((((_e5256 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5351) * _e5085));
let _e5364 = (bitcast<f32>((((_e5265 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5394 = (_e4135 * _e4020.member_1);
let _e5396 = -(((((_e5207 + (((_e5212 + (((bitcast<f32>((((_e5122 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5212) * _e5085)) - _e5207) * _e5083)) * _e5087) + (((bitcast<f32>((((_e5130 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5072) + ((bitcast<f32>((((_e5138 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5078))) * _e5394));
let _e5398 = select(-87f, _e5396, (_e5396 > -87f));
let _e5400 = select(88f, _e5398, (_e5398 < 88f));
let _e5402 = ((_e5400 * 1.442695f) + 0.5f);
let _e5404 = select(-127f, _e5402, (_e5402 > -127f));
let _e5406 = select(128f, _e5404, (_e5404 < 128f));
let _e5413 = select(0i, select(select(i32(_e5406), i32(-2147483648), (_e5406 < -2147483600f)), 2147483647i, (_e5406 > 2147483500f)), (_e5406 == _e5406));
let _e5417 = (_e5413 - select(0i, 1i, (_e5406 < f32(_e5413))));
let _e5418 = f32(_e5417);
let _e5422 = ((_e5400 - (_e5418 * 0.6933594f)) - (_e5418 * -2.1219444e-4f));
let _e5444 = -(((((_e5303 + (((_e5308 + (((bitcast<f32>(((_e5274 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5308) * _e5085)) - _e5303) * _e5083)) * _e5087) + (((bitcast<f32>(((_e5282 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5072) + ((bitcast<f32>(((_e5290 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5078))) * _e5394));
let _e5446 = select(-87f, _e5444, (_e5444 > -87f));
let _e5448 = select(88f, _e5446, (_e5446 < 88f));
let _e5450 = ((_e5448 * 1.442695f) + 0.5f);
let _e5452 = select(-127f, _e5450, (_e5450 > -127f));
let _e5454 = select(128f, _e5452, (_e5452 < 128f));
let _e5461 = select(0i, select(select(i32(_e5454), i32(-2147483648), (_e5454 < -2147483600f)), 2147483647i, (_e5454 > 2147483500f)), (_e5454 == _e5454));
let _e5465 = (_e5461 - select(0i, 1i, (_e5454 < f32(_e5461))));
let _e5466 = f32(_e5465);
let _e5470 = ((_e5448 - (_e5466 * 0.6933594f)) - (_e5466 * -2.1219444e-4f));
let _e5492 = -(((((_e5359 + (((_e5364 + (((bitcast<f32>((((_e5274 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5364) * _e5085)) - _e5359) * _e5083)) * _e5087) + (((bitcast<f32>((((_e5282 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5072) + ((bitcast<f32>((((_e5290 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5078))) * _e5394));
let _e5494 = select(-87f, _e5492, (_e5492 > -87f));
let _e5496 = select(88f, _e5494, (_e5494 < 88f));
let _e5498 = ((_e5496 * 1.442695f) + 0.5f);
let _e5500 = select(-127f, _e5498, (_e5498 > -127f));
let _e5502 = select(128f, _e5500, (_e5500 < 128f));
let _e5509 = select(0i, select(select(i32(_e5502), i32(-2147483648), (_e5502 < -2147483600f)), 2147483647i, (_e5502 > 2147483500f)), (_e5502 == _e5502));
let _e5513 = (_e5509 - select(0i, 1i, (_e5502 < f32(_e5509))));
let _e5514 = f32(_e5513);
let _e5518 = ((_e5496 - (_e5514 * 0.6933594f)) - (_e5514 * -2.1219444e-4f));
let _e5541 = -((_e5182 * (_e4135 * _e4020.member)));
let _e5543 = select(-87f, _e5541, (_e5541 > -87f));
let _e5545 = select(88f, _e5543, (_e5543 < 88f));
let _e5547 = ((_e5545 * 1.442695f) + 0.5f);
let _e5549 = select(-127f, _e5547, (_e5547 > -127f));
let _e5551 = select(128f, _e5549, (_e5549 < 128f));
let _e5558 = select(0i, select(select(i32(_e5551), i32(-2147483648), (_e5551 < -2147483600f)), 2147483647i, (_e5551 > 2147483500f)), (_e5551 == _e5551));
let _e5562 = (_e5558 - select(0i, 1i, (_e5551 < f32(_e5558))));
let _e5563 = f32(_e5562);
let _e5567 = ((_e5545 - (_e5563 * 0.6933594f)) - (_e5563 * -2.1219444e-4f));
let _e5587 = ((1f + (_e5567 * (1f + (_e5567 * (0.5f + (_e5567 * (0.16666667f + (_e5567 * (0.041666668f + (_e5567 * (0.008333334f + (_e5567 * (0.001388889f + (_e5567 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5562 + 127i)) << bitcast<u32>(23i))));
let _e5588 = (1f - _e5587);
phi_12507_ = type_35(_e5587, _e5588, vec3<f32>(((1f + (_e5422 * (1f + (_e5422 * (0.5f + (_e5422 * (0.16666667f + (_e5422 * (0.041666668f + (_e5422 * (0.008333334f + (_e5422 * (0.001388889f + (_e5422 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5417 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e5470 * (1f + (_e5470 * (0.5f + (_e5470 * (0.16666667f + (_e5470 * (0.041666668f + (_e5470 * (0.008333334f + (_e5470 * (0.001388889f + (_e5470 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5465 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e5518 * (1f + (_e5518 * (0.5f + (_e5518 * (0.16666667f + (_e5518 * (0.041666668f + (_e5518 * (0.008333334f + (_e5518 * (0.001388889f + (_e5518 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5513 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e5588 / select(1e-12f, _e5182, (_e5182 > 1e-12f))))));
}
let _e5596 = phi_12507_;
if _e1231 {
let _e5601 = global_1.member.member_8.member.member;
let _e5609 = global_1.member.member_8.member_1.member;
let _e5617 = global_1.member.member_8.member_2.member;
let _e5621 = (-0.5f - _e1210);
let _e5622 = -(_e4028);
let _e5625 = (_e4028 - _e5621);
let _e5626 = (_e5621 - _e4028);
let _e5628 = select(_e5626, _e5625, (_e5625 > _e5626));
let _e5631 = (select(_e5622, _e4028, (_e4028 > _e5622)) / select(1e-30f, _e5628, (_e5628 > 1e-30f)));
let _e5633 = (_e5621 < 0f);
let _e5635 = select(0f, select(2f, _e5631, _e5633), (_e4028 > 0f));
let _e5636 = (_e5621 > 0f);
let _e5639 = select(2f, select(0f, _e5631, (_e4028 < 0f)), _e5636);
let _e5640 = (_e4028 > -1e30f);
let _e5644 = ((_e5635 > -1f) || ((_e5635 == -1f) && _e5640));
let _e5645 = (_e5639 < 2f);
let _e5646 = select(-1f, _e5635, _e5644);
let _e5650 = select(2f, _e5639, _e5645);
let _e5654 = select(-1e30f, _e4028, _e5640);
let _e5655 = (_e5621 > -1e30f);
let _e5656 = select(-1e30f, _e5621, _e5655);
let _e5660 = (_e1174 - _e3438);
let _e5661 = (_e1210 - _e3438);
let _e5662 = -(_e5660);
let _e5665 = (_e5660 - _e5661);
let _e5666 = (_e5661 - _e5660);
let _e5668 = select(_e5666, _e5665, (_e5665 > _e5666));
let _e5671 = (select(_e5662, _e5660, (_e5660 > _e5662)) / select(1e-30f, _e5668, (_e5668 > 1e-30f)));
let _e5673 = (_e5661 < 0f);
let _e5675 = select(0f, select(2f, _e5671, _e5673), (_e5660 > 0f));
let _e5676 = (_e5661 > 0f);
let _e5679 = select(2f, select(0f, _e5671, (_e5660 < 0f)), _e5676);
let _e5680 = (_e5660 > _e5654);
let _e5684 = ((_e5675 > _e5646) || ((_e5675 == _e5646) && _e5680));
let _e5685 = (_e5679 < _e5650);
let _e5686 = select(_e5646, _e5675, _e5684);
let _e5690 = select(_e5650, _e5679, _e5685);
let _e5694 = select(_e5654, _e5660, _e5680);
let _e5695 = (_e5661 > _e5656);
let _e5696 = select(_e5656, _e5661, _e5695);
let _e5700 = (-0.5f - _e1216);
let _e5701 = -(_e4057);
let _e5704 = (_e4057 - _e5700);
let _e5705 = (_e5700 - _e4057);
let _e5707 = select(_e5705, _e5704, (_e5704 > _e5705));
let _e5710 = (select(_e5701, _e4057, (_e4057 > _e5701)) / select(1e-30f, _e5707, (_e5707 > 1e-30f)));
let _e5712 = (_e5700 < 0f);
let _e5714 = select(0f, select(2f, _e5710, _e5712), (_e4057 > 0f));
let _e5715 = (_e5700 > 0f);
let _e5718 = select(2f, select(0f, _e5710, (_e4057 < 0f)), _e5715);
let _e5719 = (_e4057 > _e5694);
let _e5723 = ((_e5714 > _e5686) || ((_e5714 == _e5686) && _e5719));
let _e5724 = (_e5718 < _e5690);
let _e5725 = select(_e5686, _e5714, _e5723);
let _e5729 = select(_e5690, _e5718, _e5724);
let _e5733 = select(_e5694, _e4057, _e5719);
let _e5734 = (_e5700 > _e5696);
let _e5735 = select(_e5696, _e5700, _e5734);
let _e5739 = (_e1189 - _e3448);
let _e5740 = (_e1216 - _e3448);
let _e5741 = -(_e5739);
let _e5744 = (_e5739 - _e5740);
let _e5745 = (_e5740 - _e5739);
let _e5747 = select(_e5745, _e5744, (_e5744 > _e5745));
let _e5750 = (select(_e5741, _e5739, (_e5739 > _e5741)) / select(1e-30f, _e5747, (_e5747 > 1e-30f)));
let _e5752 = (_e5740 < 0f);
let _e5754 = select(0f, select(2f, _e5750, _e5752), (_e5739 > 0f));
let _e5755 = (_e5740 > 0f);
let _e5758 = select(2f, select(0f, _e5750, (_e5739 < 0f)), _e5755);
let _e5759 = (_e5739 > _e5733);
let _e5763 = ((_e5754 > _e5725) || ((_e5754 == _e5725) && _e5759));
let _e5764 = (_e5758 < _e5729);
let _e5765 = select(_e5725, _e5754, _e5763);
let _e5769 = select(_e5729, _e5758, _e5764);
let _e5773 = select(_e5733, _e5739, _e5759);
let _e5774 = (_e5740 > _e5735);
let _e5775 = select(_e5735, _e5740, _e5774);
let _e5779 = (-0.5f - _e1222);
let _e5780 = -(_e4086);
let _e5783 = (_e4086 - _e5779);
let _e5784 = (_e5779 - _e4086);
let _e5786 = select(_e5784, _e5783, (_e5783 > _e5784));
let _e5789 = (select(_e5780, _e4086, (_e4086 > _e5780)) / select(1e-30f, _e5786, (_e5786 > 1e-30f)));
let _e5791 = (_e5779 < 0f);
let _e5793 = select(0f, select(2f, _e5789, _e5791), (_e4086 > 0f));
let _e5794 = (_e5779 > 0f);
let _e5797 = select(2f, select(0f, _e5789, (_e4086 < 0f)), _e5794);
let _e5798 = (_e4086 > _e5773);
let _e5802 = ((_e5793 > _e5765) || ((_e5793 == _e5765) && _e5798));
let _e5803 = (_e5797 < _e5769);
let _e5804 = select(_e5765, _e5793, _e5802);
let _e5808 = select(_e5769, _e5797, _e5803);
let _e5812 = select(_e5773, _e4086, _e5798);
let _e5813 = (_e5779 > _e5775);
let _e5814 = select(_e5775, _e5779, _e5813);
let _e5818 = (_e1204 - _e3458);
let _e5819 = (_e1222 - _e3458);
let _e5820 = -(_e5818);
let _e5823 = (_e5818 - _e5819);
let _e5824 = (_e5819 - _e5818);
let _e5826 = select(_e5824, _e5823, (_e5823 > _e5824));
let _e5829 = (select(_e5820, _e5818, (_e5818 > _e5820)) / select(1e-30f, _e5826, (_e5826 > 1e-30f)));
let _e5831 = (_e5819 < 0f);
let _e5833 = select(0f, select(2f, _e5829, _e5831), (_e5818 > 0f));
let _e5834 = (_e5819 > 0f);
let _e5837 = select(2f, select(0f, _e5829, (_e5818 < 0f)), _e5834);
let _e5838 = (_e5818 > _e5812);
let _e5842 = ((_e5833 > _e5804) || ((_e5833 == _e5804) && _e5838));
let _e5843 = (_e5837 < _e5808);
let _e5844 = select(_e5804, _e5833, _e5842);
let _e5845 = select(select(select(select(select(select(0f, _e5601.member, _e5644), _e5601.member, _e5684), _e5609.member, _e5723), _e5609.member, _e5763), _e5617.member, _e5802), _e5617.member, _e5842);
let _e5846 = select(select(select(select(select(select(0f, _e5601.member_1, _e5644), _e5601.member_1, _e5684), _e5609.member_1, _e5723), _e5609.member_1, _e5763), _e5617.member_1, _e5802), _e5617.member_1, _e5842);
let _e5847 = select(select(select(select(select(select(1f, _e5601.member_2, _e5644), _e5601.member_2, _e5684), _e5609.member_2, _e5723), _e5609.member_2, _e5763), _e5617.member_2, _e5802), _e5617.member_2, _e5842);
let _e5849 = select(_e5808, _e5837, _e5843);
let _e5850 = select(select(select(select(select(select(0f, _e5601.member, _e5645), _e5601.member, _e5685), _e5609.member, _e5724), _e5609.member, _e5764), _e5617.member, _e5803), _e5617.member, _e5843);
let _e5851 = select(select(select(select(select(select(0f, _e5601.member_1, _e5645), _e5601.member_1, _e5685), _e5609.member_1, _e5724), _e5609.member_1, _e5764), _e5617.member_1, _e5803), _e5617.member_1, _e5843);
let _e5852 = select(select(select(select(select(select(1f, _e5601.member_2, _e5645), _e5601.member_2, _e5685), _e5609.member_2, _e5724), _e5609.member_2, _e5764), _e5617.member_2, _e5803), _e5617.member_2, _e5843);
let _e5854 = select(_e5812, _e5818, _e5838);
let _e5855 = (_e5819 > _e5814);
let _e5856 = select(_e5814, _e5819, _e5855);
let _e5857 = select(select(select(select(select(select(0f, _e5601.member, _e5640), _e5601.member, _e5680), _e5609.member, _e5719), _e5609.member, _e5759), _e5617.member, _e5798), _e5617.member, _e5838);
let _e5858 = select(select(select(select(select(select(0f, _e5601.member_1, _e5640), _e5601.member_1, _e5680), _e5609.member_1, _e5719), _e5609.member_1, _e5759), _e5617.member_1, _e5798), _e5617.member_1, _e5838);
let _e5859 = select(select(select(select(select(select(1f, _e5601.member_2, _e5640), _e5601.member_2, _e5680), _e5609.member_2, _e5719), _e5609.member_2, _e5759), _e5617.member_2, _e5798), _e5617.member_2, _e5838);
if _e3817 {
phi_13826_ = type_34(_e5844, vec3<f32>(_e5845, _e5846, _e5847), _e5849, vec3<f32>(_e5850, _e5851, _e5852), _e5854, _e5856, vec3<f32>(_e5857, _e5858, _e5859));
} else {
let _e5866 = (((_e5601.member * _e5601.member) + (_e5601.member_1 * _e5601.member_1)) + (_e5601.member_2 * _e5601.member_2));
let _e5869 = sqrt(select(0f, _e5866, (_e5866 > 0f)));
let _e5873 = global_1.member.member_16.member_1;
let _e5874 = (_e5873 != 0u);
let _e5878 = global_1.member.member_16.member;
let _e5898 = select(-1e6f, (((((_e5878.member.member * _e1131) + (_e5878.member.member_1 * _e1144)) + (_e5878.member.member_2 * _e1109)) + _e5878.member_1) * _e5869), _e5874);
let _e5899 = select(-1e6f, (((((_e5878.member.member * _e1154) + (_e5878.member.member_1 * _e1159)) + (_e5878.member.member_2 * _e1148)) + _e5878.member_1) * _e5869), _e5874);
let _e5904 = global_1.member.member_16.member.member;
let _e5908 = -(_e5898);
let _e5911 = (_e5898 - _e5899);
let _e5912 = (_e5899 - _e5898);
let _e5914 = select(_e5912, _e5911, (_e5911 > _e5912));
let _e5917 = (select(_e5908, _e5898, (_e5898 > _e5908)) / select(1e-30f, _e5914, (_e5914 > 1e-30f)));
let _e5921 = select(0f, select(2f, _e5917, (_e5899 < 0f)), (_e5898 > 0f));
let _e5925 = select(2f, select(0f, _e5917, (_e5898 < 0f)), (_e5899 > 0f));
let _e5926 = (_e5898 > _e5854);
let _e5930 = ((_e5921 > _e5844) || ((_e5921 == _e5844) && _e5926));
let _e5931 = (_e5925 < _e5849);
let _e5932 = select(_e5844, _e5921, _e5930);
let _e5936 = select(_e5849, _e5925, _e5931);
let _e5940 = select(_e5854, _e5898, _e5926);
let _e5942 = select(_e5856, _e5899, (_e5899 > _e5856));
let _e5949 = global_1.member.member_17.member_1;
let _e5950 = (_e5949 != 0u);
let _e5954 = global_1.member.member_17.member;
let _e5974 = select(-1e6f, (((((_e5954.member.member * _e1131) + (_e5954.member.member_1 * _e1144)) + (_e5954.member.member_2 * _e1109)) + _e5954.member_1) * _e5869), _e5950);
let _e5975 = select(-1e6f, (((((_e5954.member.member * _e1154) + (_e5954.member.member_1 * _e1159)) + (_e5954.member.member_2 * _e1148)) + _e5954.member_1) * _e5869), _e5950);
let _e5980 = global_1.member.member_17.member.member;
let _e5984 = -(_e5974);
let _e5987 = (_e5974 - _e5975);
let _e5988 = (_e5975 - _e5974);
let _e5990 = select(_e5988, _e5987, (_e5987 > _e5988));
let _e5993 = (select(_e5984, _e5974, (_e5974 > _e5984)) / select(1e-30f, _e5990, (_e5990 > 1e-30f)));
let _e5997 = select(0f, select(2f, _e5993, (_e5975 < 0f)), (_e5974 > 0f));
let _e6001 = select(2f, select(0f, _e5993, (_e5974 < 0f)), (_e5975 > 0f));
let _e6002 = (_e5974 > _e5940);
let _e6006 = ((_e5997 > _e5932) || ((_e5997 == _e5932) && _e6002));
let _e6007 = (_e6001 < _e5936);
let _e6008 = select(_e5932, _e5997, _e6006);
let _e6012 = select(_e5936, _e6001, _e6007);
let _e6016 = select(_e5940, _e5974, _e6002);
let _e6018 = select(_e5942, _e5975, (_e5975 > _e5942));
let _e6025 = global_1.member.member_18.member_1;
let _e6026 = (_e6025 != 0u);
let _e6030 = global_1.member.member_18.member;
let _e6050 = select(-1e6f, (((((_e6030.member.member * _e1131) + (_e6030.member.member_1 * _e1144)) + (_e6030.member.member_2 * _e1109)) + _e6030.member_1) * _e5869), _e6026);
let _e6051 = select(-1e6f, (((((_e6030.member.member * _e1154) + (_e6030.member.member_1 * _e1159)) + (_e6030.member.member_2 * _e1148)) + _e6030.member_1) * _e5869), _e6026);
let _e6056 = global_1.member.member_18.member.member;
let _e6060 = -(_e6050);
let _e6063 = (_e6050 - _e6051);
let _e6064 = (_e6051 - _e6050);
let _e6066 = select(_e6064, _e6063, (_e6063 > _e6064));
let _e6069 = (select(_e6060, _e6050, (_e6050 > _e6060)) / select(1e-30f, _e6066, (_e6066 > 1e-30f)));
let _e6073 = select(0f, select(2f, _e6069, (_e6051 < 0f)), (_e6050 > 0f));
let _e6077 = select(2f, select(0f, _e6069, (_e6050 < 0f)), (_e6051 > 0f));
let _e6078 = (_e6050 > _e6016);
let _e6082 = ((_e6073 > _e6008) || ((_e6073 == _e6008) && _e6078));
let _e6083 = (_e6077 < _e6012);
let _e6084 = select(_e6008, _e6073, _e6082);
let _e6088 = select(_e6012, _e6077, _e6083);
let _e6092 = select(_e6016, _e6050, _e6078);
let _e6094 = select(_e6018, _e6051, (_e6051 > _e6018));
let _e6101 = global_1.member.member_19.member_1;
let _e6102 = (_e6101 != 0u);
let _e6106 = global_1.member.member_19.member;
let _e6126 = select(-1e6f, (((((_e6106.member.member * _e1131) + (_e6106.member.member_1 * _e1144)) + (_e6106.member.member_2 * _e1109)) + _e6106.member_1) * _e5869), _e6102);
let _e6127 = select(-1e6f, (((((_e6106.member.member * _e1154) + (_e6106.member.member_1 * _e1159)) + (_e6106.member.member_2 * _e1148)) + _e6106.member_1) * _e5869), _e6102);
let _e6132 = global_1.member.member_19.member.member;
let _e6136 = -(_e6126);
let _e6139 = (_e6126 - _e6127);
let _e6140 = (_e6127 - _e6126);
let _e6142 = select(_e6140, _e6139, (_e6139 > _e6140));
let _e6145 = (select(_e6136, _e6126, (_e6126 > _e6136)) / select(1e-30f, _e6142, (_e6142 > 1e-30f)));
let _e6149 = select(0f, select(2f, _e6145, (_e6127 < 0f)), (_e6126 > 0f));
let _e6153 = select(2f, select(0f, _e6145, (_e6126 < 0f)), (_e6127 > 0f));
let _e6154 = (_e6126 > _e6092);
let _e6158 = ((_e6149 > _e6084) || ((_e6149 == _e6084) && _e6154));
let _e6159 = (_e6153 < _e6088);
phi_13826_ = type_34(select(_e6084, _e6149, _e6158), vec3<f32>(select(select(select(select(_e5845, _e5904.member, _e5930), _e5980.member, _e6006), _e6056.member, _e6082), _e6132.member, _e6158), select(select(select(select(_e5846, _e5904.member_1, _e5930), _e5980.member_1, _e6006), _e6056.member_1, _e6082), _e6132.member_1, _e6158), select(select(select(select(_e5847, _e5904.member_2, _e5930), _e5980.member_2, _e6006), _e6056.member_2, _e6082), _e6132.member_2, _e6158)), select(_e6088, _e6153, _e6159), vec3<f32>(select(select(select(select(_e5850, _e5904.member, _e5931), _e5980.member, _e6007), _e6056.member, _e6083), _e6132.member, _e6159), select(select(select(select(_e5851, _e5904.member_1, _e5931), _e5980.member_1, _e6007), _e6056.member_1, _e6083), _e6132.member_1, _e6159), select(select(select(select(_e5852, _e5904.member_2, _e5931), _e5980.member_2, _e6007), _e6056.member_2, _e6083), _e6132.member_2, _e6159)), select(_e6092, _e6126, _e6154), select(_e6094, _e6127, (_e6127 > _e6094)), vec3<f32>(select(select(select(select(_e5857, _e5904.member, _e5926), _e5980.member, _e6002), _e6056.member, _e6078), _e6132.member, _e6154), select(select(select(select(_e5858, _e5904.member_1, _e5926), _e5980.member_1, _e6002), _e6056.member_1, _e6078), _e6132.member_1, _e6154), select(select(select(select(_e5859, _e5904.member_2, _e5926), _e5980.member_2, _e6002), _e6056.member_2, _e6078), _e6132.member_2, _e6154)));
}
let _e6179 = phi_13826_;
let _e6181 = (_e6179.member_4 < 0f);
let _e6183 = (_e6179.member_5 < 0f);
let _e6184 = (_e6181 != _e6183);
if _e6181 {
phi_13839_ = _e6179.member_3;
phi_13840_ = _e6179.member_2;
} else {
phi_13839_ = _e6179.member_1;
phi_13840_ = _e6179.member;
}
let _e6190 = phi_13839_;
let _e6192 = phi_13840_;
let _e6201 = (((_e5601.member * _e5601.member) + (_e5601.member_1 * _e5601.member_1)) + (_e5601.member_2 * _e5601.member_2));
let _e6204 = sqrt(select(0f, _e6201, (_e6201 > 0f)));
let _e6205 = ((1.5f * _e1129) * _e6204);
let _e6210 = select(0f, _e6192, _e6184);
let _e6214 = (_e1131 + (_e4119 * _e6210));
let _e6215 = (_e1144 + (_e4120 * _e6210));
let _e6216 = (_e1109 + (_e4121 * _e6210));
let _e6222 = ((((_e1163.member.member * _e6214) + (_e1163.member.member_1 * _e6215)) + (_e1163.member.member_2 * _e6216)) + _e1163.member_1);
let _e6228 = ((((_e1178.member.member * _e6214) + (_e1178.member.member_1 * _e6215)) + (_e1178.member.member_2 * _e6216)) + _e1178.member_1);
let _e6234 = ((((_e1193.member.member * _e6214) + (_e1193.member.member_1 * _e6215)) + (_e1193.member.member_2 * _e6216)) + _e1193.member_1);
let _e6236 = select(-0.5f, _e6222, (_e6222 > -0.5f));
let _e6238 = select(_e3438, _e6236, (_e6236 < _e3438));
let _e6240 = select(-0.5f, _e6228, (_e6228 > -0.5f));
let _e6242 = select(_e3448, _e6240, (_e6240 < _e3448));
let _e6244 = select(-0.5f, _e6234, (_e6234 > -0.5f));
let _e6246 = select(_e3458, _e6244, (_e6244 < _e3458));
let _e6248 = select(-1f, _e6238, (_e6238 > -1f));
let _e6250 = select(_e3437, _e6248, (_e6248 < _e3437));
let _e6257 = select(0i, select(select(i32(_e6250), i32(-2147483648), (_e6250 < -2147483600f)), 2147483647i, (_e6250 > 2147483500f)), (_e6250 == _e6250));
let _e6261 = (_e6257 - select(0i, 1i, (_e6250 < f32(_e6257))));
let _e6263 = select(-1f, _e6242, (_e6242 > -1f));
let _e6265 = select(_e3447, _e6263, (_e6263 < _e3447));
let _e6272 = select(0i, select(select(i32(_e6265), i32(-2147483648), (_e6265 < -2147483600f)), 2147483647i, (_e6265 > 2147483500f)), (_e6265 == _e6265));
let _e6276 = (_e6272 - select(0i, 1i, (_e6265 < f32(_e6272))));
let _e6278 = select(-1f, _e6246, (_e6246 > -1f));
let _e6280 = select(_e3457, _e6278, (_e6278 < _e3457));
let _e6287 = select(0i, select(select(i32(_e6280), i32(-2147483648), (_e6280 < -2147483600f)), 2147483647i, (_e6280 > 2147483500f)), (_e6280 == _e6280));
let _e6291 = (_e6287 - select(0i, 1i, (_e6280 < f32(_e6287))));
let _e6292 = (_e6261 + 1i);
let _e6293 = (_e6276 + 1i);
let _e6294 = (_e6291 + 1i);
let _e6304 = ((_e6292 >> bitcast<u32>(4i)) + (_e3524 * ((_e6293 >> bitcast<u32>(4i)) + (_e3530 * (_e6294 >> bitcast<u32>(4i))))));
let _e6306 = select(_e3542, _e6304, (_e6304 < _e3542));
let _e6312 = global_2.member[bitcast<u32>(select(0i, _e6306, (_e6306 > 0i)))];
let _e6314 = (_e6292 & 15i);
let _e6317 = ((_e6293 & 15i) * _e3511);
let _e6319 = (bitcast<i32>(_e6312) + ((_e6294 & 15i) * _e3515));
let _e6320 = (_e6317 + _e3511);
let _e6321 = (_e6317 + _e3559);
let _e6322 = (_e6319 + _e3515);
let _e6323 = (_e6319 + _e3562);
local_2 = type_29(array<i32, 4>(_e6314, _e6314, _e6314, _e6314), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_3 = vec3<f32>((_e6238 - f32(_e6261)), (_e6242 - f32(_e6276)), (_e6246 - f32(_e6291)));
let _e6337 = local_2.member[0u];
let _e6338 = ((_e6322 + _e6320) + _e6337);
let _e6340 = (_e6338 >> bitcast<u32>(2i));
let _e6343 = bitcast<u32>(((_e6338 & 3i) * 8i));
let _e6345 = select(_e3542, _e6340, (_e6340 < _e3542));
let _e6350 = global_2.member[bitcast<u32>(select(0i, _e6345, (_e6345 > 0i)))];
let _e6354 = (_e6340 + 1i);
let _e6356 = select(_e3542, _e6354, (_e6354 < _e3542));
let _e6361 = global_2.member[bitcast<u32>(select(0i, _e6356, (_e6356 > 0i)))];
let _e6368 = ((_e6350 >> bitcast<u32>((_e6343 & 31u))) | ((_e6361 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6343) & 31u))));
let _e6371 = local_2.member_1[1u];
let _e6377 = f32(bitcast<i32>(((_e6368 >> bitcast<u32>((_e6371 & 31u))) & 255u)));
let _e6380 = local_2.member_1[2u];
let _e6387 = local_3[0u];
let _e6390 = (_e6377 + ((f32(bitcast<i32>(((_e6368 >> bitcast<u32>((_e6380 & 31u))) & 255u))) - _e6377) * _e6387));
let _e6392 = local_2.member[0u];
let _e6393 = ((_e6322 + _e6321) + _e6392);
let _e6395 = (_e6393 >> bitcast<u32>(2i));
let _e6398 = bitcast<u32>(((_e6393 & 3i) * 8i));
let _e6400 = select(_e3542, _e6395, (_e6395 < _e3542));
let _e6405 = global_2.member[bitcast<u32>(select(0i, _e6400, (_e6400 > 0i)))];
let _e6409 = (_e6395 + 1i);
let _e6411 = select(_e3542, _e6409, (_e6409 < _e3542));
let _e6416 = global_2.member[bitcast<u32>(select(0i, _e6411, (_e6411 > 0i)))];
let _e6423 = ((_e6405 >> bitcast<u32>((_e6398 & 31u))) | ((_e6416 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6398) & 31u))));
let _e6424 = local_2.member_1[1u];
let _e6430 = f32(bitcast<i32>(((_e6423 >> bitcast<u32>((_e6424 & 31u))) & 255u)));
let _e6431 = local_2.member_1[2u];
let _e6438 = local_3[0u];
let _e6443 = local_3[1u];
let _e6446 = (_e6390 + (((_e6430 + ((f32(bitcast<i32>(((_e6423 >> bitcast<u32>((_e6431 & 31u))) & 255u))) - _e6430) * _e6438)) - _e6390) * _e6443));
let _e6448 = local_2.member[0u];
let _e6449 = ((_e6323 + _e6320) + _e6448);
let _e6451 = (_e6449 >> bitcast<u32>(2i));
let _e6454 = bitcast<u32>(((_e6449 & 3i) * 8i));
let _e6456 = select(_e3542, _e6451, (_e6451 < _e3542));
let _e6461 = global_2.member[bitcast<u32>(select(0i, _e6456, (_e6456 > 0i)))];
let _e6465 = (_e6451 + 1i);
let _e6467 = select(_e3542, _e6465, (_e6465 < _e3542));
let _e6472 = global_2.member[bitcast<u32>(select(0i, _e6467, (_e6467 > 0i)))];
let _e6479 = ((_e6461 >> bitcast<u32>((_e6454 & 31u))) | ((_e6472 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6454) & 31u))));
let _e6480 = local_2.member_1[1u];
let _e6486 = f32(bitcast<i32>(((_e6479 >> bitcast<u32>((_e6480 & 31u))) & 255u)));
let _e6487 = local_2.member_1[2u];
let _e6494 = local_3[0u];
let _e6497 = (_e6486 + ((f32(bitcast<i32>(((_e6479 >> bitcast<u32>((_e6487 & 31u))) & 255u))) - _e6486) * _e6494));
let _e6499 = local_2.member[0u];
let _e6500 = ((_e6323 + _e6321) + _e6499);
let _e6502 = (_e6500 >> bitcast<u32>(2i));
let _e6505 = bitcast<u32>(((_e6500 & 3i) * 8i));
let _e6507 = select(_e3542, _e6502, (_e6502 < _e3542));
let _e6512 = global_2.member[bitcast<u32>(select(0i, _e6507, (_e6507 > 0i)))];
let _e6516 = (_e6502 + 1i);
let _e6518 = select(_e3542, _e6516, (_e6516 < _e3542));
let _e6523 = global_2.member[bitcast<u32>(select(0i, _e6518, (_e6518 > 0i)))];
let _e6530 = ((_e6512 >> bitcast<u32>((_e6505 & 31u))) | ((_e6523 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6505) & 31u))));
let _e6531 = local_2.member_1[1u];
let _e6537 = f32(bitcast<i32>(((_e6530 >> bitcast<u32>((_e6531 & 31u))) & 255u)));
let _e6538 = local_2.member_1[2u];
let _e6545 = local_3[0u];
let _e6549 = local_3[1u];
let _e6554 = local_3[2u];
let _e6559 = (((_e6446 + (((_e6497 + (((_e6537 + ((f32(bitcast<i32>(((_e6530 >> bitcast<u32>((_e6538 & 31u))) & 255u))) - _e6537) * _e6545)) - _e6497) * _e6549)) - _e6446) * _e6554)) - _e3801) * _e3805);
let _e6561 = select(_e3808, _e6559, (_e6559 > _e3808));
local = select(1e9f, _e6561, (_e6561 < 1e9f));
let _e6564 = local;
local_1 = _e6564;
let _e6565 = local_1;
let _e6567 = (bitcast<i32>(_e167) - 1i);
let _e6569 = select(_e6567, 263197i, (263197i < _e6567));
let _e6574 = global_3.member[bitcast<u32>(select(0i, _e6569, (_e6569 > 0i)))];
let _e6577 = select(_e6567, 263198i, (263198i < _e6567));
let _e6582 = global_3.member[bitcast<u32>(select(0i, _e6577, (_e6577 > 0i)))];
let _e6585 = select(_e6567, 263199i, (263199i < _e6567));
let _e6590 = global_3.member[bitcast<u32>(select(0i, _e6585, (_e6585 > 0i)))];
let _e6591 = bitcast<f32>(_e6590);
let _e6593 = ((_e6565 - bitcast<f32>(_e6574)) * bitcast<f32>(_e6582));
let _e6595 = select(0f, _e6593, (_e6593 > 0f));
let _e6598 = local_1;
let _e6600 = select(_e6567, 263200i, (263200i < _e6567));
let _e6605 = global_3.member[bitcast<u32>(select(0i, _e6600, (_e6600 > 0i)))];
let _e6608 = select(_e6567, 263201i, (263201i < _e6567));
let _e6613 = global_3.member[bitcast<u32>(select(0i, _e6608, (_e6608 > 0i)))];
let _e6616 = select(_e6567, 263202i, (263202i < _e6567));
let _e6621 = global_3.member[bitcast<u32>(select(0i, _e6616, (_e6616 > 0i)))];
let _e6622 = bitcast<f32>(_e6621);
let _e6624 = ((_e6598 - bitcast<f32>(_e6605)) * bitcast<f32>(_e6613));
let _e6626 = select(0f, _e6624, (_e6624 > 0f));
let _e6630 = local_1;
let _e6632 = select(_e6567, 263203i, (263203i < _e6567));
let _e6637 = global_3.member[bitcast<u32>(select(0i, _e6632, (_e6632 > 0i)))];
let _e6640 = select(_e6567, 263204i, (263204i < _e6567));
let _e6645 = global_3.member[bitcast<u32>(select(0i, _e6640, (_e6640 > 0i)))];
let _e6648 = select(_e6567, 263205i, (263205i < _e6567));
let _e6653 = global_3.member[bitcast<u32>(select(0i, _e6648, (_e6648 > 0i)))];
let _e6654 = bitcast<f32>(_e6653);
let _e6656 = ((_e6630 - bitcast<f32>(_e6637)) * bitcast<f32>(_e6645));
let _e6658 = select(0f, _e6656, (_e6656 > 0f));
let _e6661 = local_1;
let _e6663 = select(_e6567, 263206i, (263206i < _e6567));
let _e6668 = global_3.member[bitcast<u32>(select(0i, _e6663, (_e6663 > 0i)))];
let _e6671 = select(_e6567, 263207i, (263207i < _e6567));
let _e6676 = global_3.member[bitcast<u32>(select(0i, _e6671, (_e6671 > 0i)))];
let _e6679 = select(_e6567, 263208i, (263208i < _e6567));
let _e6684 = global_3.member[bitcast<u32>(select(0i, _e6679, (_e6679 > 0i)))];
let _e6685 = bitcast<f32>(_e6684);
let _e6687 = ((_e6661 - bitcast<f32>(_e6668)) * bitcast<f32>(_e6676));
let _e6689 = select(0f, _e6687, (_e6687 > 0f));
let _e6693 = ((select(_e6591, _e6595, (_e6595 < _e6591)) + select(_e6622, _e6626, (_e6626 < _e6622))) + (select(_e6654, _e6658, (_e6658 < _e6654)) + select(_e6685, _e6689, (_e6689 < _e6685))));
let _e6695 = select(0f, _e6693, (_e6693 > 0f));
let _e6697 = select(1023f, _e6695, (_e6695 < 1023f));
let _e6704 = select(0i, select(select(i32(_e6697), i32(-2147483648), (_e6697 < -2147483600f)), 2147483647i, (_e6697 > 2147483500f)), (_e6697 == _e6697));
let _e6708 = (_e6704 - select(0i, 1i, (_e6697 < f32(_e6704))));
let _e6709 = (262147i + _e6708);
let _e6711 = select(_e6567, _e6709, (_e6709 < _e6567));
let _e6717 = global_3.member[bitcast<u32>(select(0i, _e6711, (_e6711 > 0i)))];
let _e6727 = select(_e6567, 262146i, (262146i < _e6567));
let _e6733 = global_3.member[bitcast<u32>(select(0i, _e6727, (_e6727 > 0i)))];
let _e6737 = select(_e6567, 262144i, (262144i < _e6567));
let _e6743 = global_3.member[bitcast<u32>(select(0i, _e6737, (_e6737 > 0i)))];
let _e6746 = select(_e6567, 262145i, (262145i < _e6567));
let _e6752 = global_3.member[bitcast<u32>(select(0i, _e6746, (_e6746 > 0i)))];
let _e6759 = ((bitcast<f32>(_e6743) + (f32(bitcast<i32>((_e6717 >> bitcast<u32>(12u)))) * bitcast<f32>(_e6752))) + ((f32((bitcast<i32>((_e6717 & 4095u)) - 2048i)) * bitcast<f32>(_e6733)) * (_e6693 - f32(_e6708))));
let _e6763 = select(_e6179.member_6.x, _e6190.x, _e6184);
let _e6766 = select(_e6179.member_6.y, _e6190.y, _e6184);
let _e6769 = select(_e6179.member_6.z, _e6190.z, _e6184);
let _e6770 = select(1f, _e6759, _e6183);
let _e6775 = (((_e6763 * _e6763) + (_e6766 * _e6766)) + (_e6769 * _e6769));
let _e6778 = sqrt(select(0f, _e6775, (_e6775 > 0f)));
let _e6781 = (1f / select(1e-20f, _e6778, (_e6778 > 1e-20f)));
let _e6782 = (_e6763 * _e6781);
let _e6783 = (_e6766 * _e6781);
let _e6784 = (_e6769 * _e6781);
let _e6789 = (((_e235 * _e6782) + (_e246 * _e6783)) + (_e257 * _e6784));
let _e6794 = (((_e235 * _e235) + (_e246 * _e246)) + (_e257 * _e257));
let _e6796 = ((_e6770 * _e6770) - _e6794);
let _e6797 = (_e6789 * _e6789);
let _e6798 = (_e6797 + _e6796);
let _e6801 = sqrt(select(0f, _e6798, (_e6798 > 0f)));
let _e6805 = (_e6798 <= 0f);
let _e6808 = select((select(_e6801, -(_e6801), (_e6789 < 0f)) - _e6789), (-2f * _e6789), _e6805);
let _e6809 = (_e6796 == 0f);
let _e6820 = (_e6805 && (_e6796 != 0f));
let _e6826 = (!(_e6184) && (_e6820 || (_e6797 < ((0.1f * 0.1f) * _e6794))));
let _e6828 = select(1e-12f, _e6794, (_e6794 > 1e-12f));
let _e6832 = (_e6770 / sqrt(select(0f, _e6828, (_e6828 > 0f))));
let _e6844 = ((_e6184 || (bitcast<f32>((bitcast<u32>(_e6179.member_4) & 2147483647u)) < select(1f, _e6205, (_e6205 < 1f)))) && (_e6759 != 1f));
let _e6845 = select(_e235, select(select(select((_e235 + (_e6782 * _e6808)), _e235, _e6809), _e235, _e6820), (_e235 * _e6832), _e6826), _e6844);
let _e6846 = select(_e246, select(select(select((_e246 + (_e6783 * _e6808)), _e246, _e6809), _e246, _e6820), (_e246 * _e6832), _e6826), _e6844);
let _e6847 = select(_e257, select(select(select((_e257 + (_e6784 * _e6808)), _e257, _e6809), _e257, _e6820), (_e257 * _e6832), _e6826), _e6844);
let _e6859 = global_1.member.member_7.member_2;
let _e6862 = (_e6859 / select(1e-6f, _e6847, (_e6847 > 1e-6f)));
let _e6866 = (_e1154 + (_e6845 * _e6862));
let _e6867 = (_e1159 + (_e6846 * _e6862));
let _e6868 = (_e1148 + (_e6847 * _e6862));
let _e6874 = ((((_e1163.member.member * _e6866) + (_e1163.member.member_1 * _e6867)) + (_e1163.member.member_2 * _e6868)) + _e1163.member_1);
let _e6880 = ((((_e1178.member.member * _e6866) + (_e1178.member.member_1 * _e6867)) + (_e1178.member.member_2 * _e6868)) + _e1178.member_1);
let _e6886 = ((((_e1193.member.member * _e6866) + (_e1193.member.member_1 * _e6867)) + (_e1193.member.member_2 * _e6868)) + _e1193.member_1);
let _e6887 = (-0.5f - _e6874);
let _e6888 = -(_e5621);
let _e6891 = (_e5621 - _e6887);
let _e6892 = (_e6887 - _e5621);
let _e6894 = select(_e6892, _e6891, (_e6891 > _e6892));
let _e6897 = (select(_e6888, _e5621, (_e5621 > _e6888)) / select(1e-30f, _e6894, (_e6894 > 1e-30f)));
let _e6900 = select(0f, select(2f, _e6897, (_e6887 < 0f)), _e5636);
let _e6903 = select(2f, select(0f, _e6897, _e5633), (_e6887 > 0f));
let _e6907 = ((_e6900 > -1f) || ((_e6900 == -1f) && _e5655));
let _e6908 = (_e6903 < 2f);
let _e6909 = select(-1f, _e6900, _e6907);
let _e6913 = select(2f, _e6903, _e6908);
let _e6918 = select(-1e30f, _e6887, (_e6887 > -1e30f));
let _e6922 = (_e6874 - _e3438);
let _e6923 = -(_e5661);
let _e6926 = (_e5661 - _e6922);
let _e6927 = (_e6922 - _e5661);
let _e6929 = select(_e6927, _e6926, (_e6926 > _e6927));
let _e6932 = (select(_e6923, _e5661, (_e5661 > _e6923)) / select(1e-30f, _e6929, (_e6929 > 1e-30f)));
let _e6935 = select(0f, select(2f, _e6932, (_e6922 < 0f)), _e5676);
let _e6938 = select(2f, select(0f, _e6932, _e5673), (_e6922 > 0f));
let _e6942 = ((_e6935 > _e6909) || ((_e6935 == _e6909) && _e5695));
let _e6943 = (_e6938 < _e6913);
let _e6944 = select(_e6909, _e6935, _e6942);
let _e6948 = select(_e6913, _e6938, _e6943);
let _e6953 = select(_e6918, _e6922, (_e6922 > _e6918));
let _e6957 = (-0.5f - _e6880);
let _e6958 = -(_e5700);
let _e6961 = (_e5700 - _e6957);
let _e6962 = (_e6957 - _e5700);
let _e6964 = select(_e6962, _e6961, (_e6961 > _e6962));
let _e6967 = (select(_e6958, _e5700, (_e5700 > _e6958)) / select(1e-30f, _e6964, (_e6964 > 1e-30f)));
let _e6970 = select(0f, select(2f, _e6967, (_e6957 < 0f)), _e5715);
let _e6973 = select(2f, select(0f, _e6967, _e5712), (_e6957 > 0f));
let _e6977 = ((_e6970 > _e6944) || ((_e6970 == _e6944) && _e5734));
let _e6978 = (_e6973 < _e6948);
let _e6979 = select(_e6944, _e6970, _e6977);
let _e6983 = select(_e6948, _e6973, _e6978);
let _e6988 = select(_e6953, _e6957, (_e6957 > _e6953));
let _e6992 = (_e6880 - _e3448);
let _e6993 = -(_e5740);
let _e6996 = (_e5740 - _e6992);
let _e6997 = (_e6992 - _e5740);
let _e6999 = select(_e6997, _e6996, (_e6996 > _e6997));
let _e7002 = (select(_e6993, _e5740, (_e5740 > _e6993)) / select(1e-30f, _e6999, (_e6999 > 1e-30f)));
let _e7005 = select(0f, select(2f, _e7002, (_e6992 < 0f)), _e5755);
let _e7008 = select(2f, select(0f, _e7002, _e5752), (_e6992 > 0f));
let _e7012 = ((_e7005 > _e6979) || ((_e7005 == _e6979) && _e5774));
let _e7013 = (_e7008 < _e6983);
let _e7014 = select(_e6979, _e7005, _e7012);
let _e7018 = select(_e6983, _e7008, _e7013);
let _e7023 = select(_e6988, _e6992, (_e6992 > _e6988));
let _e7027 = (-0.5f - _e6886);
let _e7028 = -(_e5779);
let _e7031 = (_e5779 - _e7027);
let _e7032 = (_e7027 - _e5779);
let _e7034 = select(_e7032, _e7031, (_e7031 > _e7032));
let _e7037 = (select(_e7028, _e5779, (_e5779 > _e7028)) / select(1e-30f, _e7034, (_e7034 > 1e-30f)));
let _e7040 = select(0f, select(2f, _e7037, (_e7027 < 0f)), _e5794);
let _e7043 = select(2f, select(0f, _e7037, _e5791), (_e7027 > 0f));
let _e7047 = ((_e7040 > _e7014) || ((_e7040 == _e7014) && _e5813));
let _e7048 = (_e7043 < _e7018);
let _e7049 = select(_e7014, _e7040, _e7047);
let _e7053 = select(_e7018, _e7043, _e7048);
let _e7058 = select(_e7023, _e7027, (_e7027 > _e7023));
let _e7062 = (_e6886 - _e3458);
let _e7063 = -(_e5819);
let _e7066 = (_e5819 - _e7062);
let _e7067 = (_e7062 - _e5819);
let _e7069 = select(_e7067, _e7066, (_e7066 > _e7067));
let _e7072 = (select(_e7063, _e5819, (_e5819 > _e7063)) / select(1e-30f, _e7069, (_e7069 > 1e-30f)));
let _e7075 = select(0f, select(2f, _e7072, (_e7062 < 0f)), _e5834);
let _e7078 = select(2f, select(0f, _e7072, _e5831), (_e7062 > 0f));
let _e7082 = ((_e7075 > _e7049) || ((_e7075 == _e7049) && _e5855));
let _e7083 = (_e7078 < _e7053);
let _e7084 = select(_e7049, _e7075, _e7082);
let _e7085 = select(select(select(select(select(select(0f, _e5601.member, _e6907), _e5601.member, _e6942), _e5609.member, _e6977), _e5609.member, _e7012), _e5617.member, _e7047), _e5617.member, _e7082);
let _e7086 = select(select(select(select(select(select(0f, _e5601.member_1, _e6907), _e5601.member_1, _e6942), _e5609.member_1, _e6977), _e5609.member_1, _e7012), _e5617.member_1, _e7047), _e5617.member_1, _e7082);
let _e7087 = select(select(select(select(select(select(1f, _e5601.member_2, _e6907), _e5601.member_2, _e6942), _e5609.member_2, _e6977), _e5609.member_2, _e7012), _e5617.member_2, _e7047), _e5617.member_2, _e7082);
let _e7089 = select(_e7053, _e7078, _e7083);
let _e7090 = select(select(select(select(select(select(0f, _e5601.member, _e6908), _e5601.member, _e6943), _e5609.member, _e6978), _e5609.member, _e7013), _e5617.member, _e7048), _e5617.member, _e7083);
let _e7091 = select(select(select(select(select(select(0f, _e5601.member_1, _e6908), _e5601.member_1, _e6943), _e5609.member_1, _e6978), _e5609.member_1, _e7013), _e5617.member_1, _e7048), _e5617.member_1, _e7083);
let _e7092 = select(select(select(select(select(select(1f, _e5601.member_2, _e6908), _e5601.member_2, _e6943), _e5609.member_2, _e6978), _e5609.member_2, _e7013), _e5617.member_2, _e7048), _e5617.member_2, _e7083);
let _e7095 = select(_e7058, _e7062, (_e7062 > _e7058));
let _e7096 = select(select(select(select(select(select(0f, _e5601.member, _e5655), _e5601.member, _e5695), _e5609.member, _e5734), _e5609.member, _e5774), _e5617.member, _e5813), _e5617.member, _e5855);
let _e7097 = select(select(select(select(select(select(0f, _e5601.member_1, _e5655), _e5601.member_1, _e5695), _e5609.member_1, _e5734), _e5609.member_1, _e5774), _e5617.member_1, _e5813), _e5617.member_1, _e5855);
let _e7098 = select(select(select(select(select(select(1f, _e5601.member_2, _e5655), _e5601.member_2, _e5695), _e5609.member_2, _e5734), _e5609.member_2, _e5774), _e5617.member_2, _e5813), _e5617.member_2, _e5855);
if _e3817 {
phi_16512_ = type_34(_e7084, vec3<f32>(_e7085, _e7086, _e7087), _e7089, vec3<f32>(_e7090, _e7091, _e7092), _e5856, _e7095, vec3<f32>(_e7096, _e7097, _e7098));
} else {
let _e7104 = global_1.member.member_16.member_1;
let _e7105 = (_e7104 != 0u);
let _e7109 = global_1.member.member_16.member;
let _e7129 = select(-1e6f, (((((_e7109.member.member * _e1154) + (_e7109.member.member_1 * _e1159)) + (_e7109.member.member_2 * _e1148)) + _e7109.member_1) * _e6204), _e7105);
let _e7130 = select(-1e6f, (((((_e7109.member.member * _e6866) + (_e7109.member.member_1 * _e6867)) + (_e7109.member.member_2 * _e6868)) + _e7109.member_1) * _e6204), _e7105);
let _e7135 = global_1.member.member_16.member.member;
let _e7139 = -(_e7129);
let _e7142 = (_e7129 - _e7130);
let _e7143 = (_e7130 - _e7129);
let _e7145 = select(_e7143, _e7142, (_e7142 > _e7143));
let _e7148 = (select(_e7139, _e7129, (_e7129 > _e7139)) / select(1e-30f, _e7145, (_e7145 > 1e-30f)));
let _e7152 = select(0f, select(2f, _e7148, (_e7130 < 0f)), (_e7129 > 0f));
let _e7156 = select(2f, select(0f, _e7148, (_e7129 < 0f)), (_e7130 > 0f));
let _e7157 = (_e7129 > _e5856);
let _e7161 = ((_e7152 > _e7084) || ((_e7152 == _e7084) && _e7157));
let _e7162 = (_e7156 < _e7089);
let _e7163 = select(_e7084, _e7152, _e7161);
let _e7167 = select(_e7089, _e7156, _e7162);
let _e7171 = select(_e5856, _e7129, _e7157);
let _e7173 = select(_e7095, _e7130, (_e7130 > _e7095));
let _e7180 = global_1.member.member_17.member_1;
let _e7181 = (_e7180 != 0u);
let _e7185 = global_1.member.member_17.member;
let _e7205 = select(-1e6f, (((((_e7185.member.member * _e1154) + (_e7185.member.member_1 * _e1159)) + (_e7185.member.member_2 * _e1148)) + _e7185.member_1) * _e6204), _e7181);
let _e7206 = select(-1e6f, (((((_e7185.member.member * _e6866) + (_e7185.member.member_1 * _e6867)) + (_e7185.member.member_2 * _e6868)) + _e7185.member_1) * _e6204), _e7181);
let _e7211 = global_1.member.member_17.member.member;
let _e7215 = -(_e7205);
let _e7218 = (_e7205 - _e7206);
let _e7219 = (_e7206 - _e7205);
let _e7221 = select(_e7219, _e7218, (_e7218 > _e7219));
let _e7224 = (select(_e7215, _e7205, (_e7205 > _e7215)) / select(1e-30f, _e7221, (_e7221 > 1e-30f)));
let _e7228 = select(0f, select(2f, _e7224, (_e7206 < 0f)), (_e7205 > 0f));
let _e7232 = select(2f, select(0f, _e7224, (_e7205 < 0f)), (_e7206 > 0f));
let _e7233 = (_e7205 > _e7171);
let _e7237 = ((_e7228 > _e7163) || ((_e7228 == _e7163) && _e7233));
let _e7238 = (_e7232 < _e7167);
let _e7239 = select(_e7163, _e7228, _e7237);
let _e7243 = select(_e7167, _e7232, _e7238);
let _e7247 = select(_e7171, _e7205, _e7233);
let _e7249 = select(_e7173, _e7206, (_e7206 > _e7173));
let _e7256 = global_1.member.member_18.member_1;
let _e7257 = (_e7256 != 0u);
let _e7261 = global_1.member.member_18.member;
let _e7281 = select(-1e6f, (((((_e7261.member.member * _e1154) + (_e7261.member.member_1 * _e1159)) + (_e7261.member.member_2 * _e1148)) + _e7261.member_1) * _e6204), _e7257);
let _e7282 = select(-1e6f, (((((_e7261.member.member * _e6866) + (_e7261.member.member_1 * _e6867)) + (_e7261.member.member_2 * _e6868)) + _e7261.member_1) * _e6204), _e7257);
let _e7287 = global_1.member.member_18.member.member;
let _e7291 = -(_e7281);
let _e7294 = (_e7281 - _e7282);
let _e7295 = (_e7282 - _e7281);
let _e7297 = select(_e7295, _e7294, (_e7294 > _e7295));
let _e7300 = (select(_e7291, _e7281, (_e7281 > _e7291)) / select(1e-30f, _e7297, (_e7297 > 1e-30f)));
let _e7304 = select(0f, select(2f, _e7300, (_e7282 < 0f)), (_e7281 > 0f));
let _e7308 = select(2f, select(0f, _e7300, (_e7281 < 0f)), (_e7282 > 0f));
let _e7309 = (_e7281 > _e7247);
let _e7313 = ((_e7304 > _e7239) || ((_e7304 == _e7239) && _e7309));
let _e7314 = (_e7308 < _e7243);
let _e7315 = select(_e7239, _e7304, _e7313);
let _e7319 = select(_e7243, _e7308, _e7314);
let _e7323 = select(_e7247, _e7281, _e7309);
let _e7325 = select(_e7249, _e7282, (_e7282 > _e7249));
let _e7332 = global_1.member.member_19.member_1;
let _e7333 = (_e7332 != 0u);
let _e7337 = global_1.member.member_19.member;
let _e7357 = select(-1e6f, (((((_e7337.member.member * _e1154) + (_e7337.member.member_1 * _e1159)) + (_e7337.member.member_2 * _e1148)) + _e7337.member_1) * _e6204), _e7333);
let _e7358 = select(-1e6f, (((((_e7337.member.member * _e6866) + (_e7337.member.member_1 * _e6867)) + (_e7337.member.member_2 * _e6868)) + _e7337.member_1) * _e6204), _e7333);
let _e7363 = global_1.member.member_19.member.member;
let _e7367 = -(_e7357);
let _e7370 = (_e7357 - _e7358);
let _e7371 = (_e7358 - _e7357);
let _e7373 = select(_e7371, _e7370, (_e7370 > _e7371));
let _e7376 = (select(_e7367, _e7357, (_e7357 > _e7367)) / select(1e-30f, _e7373, (_e7373 > 1e-30f)));
let _e7380 = select(0f, select(2f, _e7376, (_e7358 < 0f)), (_e7357 > 0f));
let _e7384 = select(2f, select(0f, _e7376, (_e7357 < 0f)), (_e7358 > 0f));
let _e7385 = (_e7357 > _e7323);
let _e7389 = ((_e7380 > _e7315) || ((_e7380 == _e7315) && _e7385));
let _e7390 = (_e7384 < _e7319);
phi_16512_ = type_34(select(_e7315, _e7380, _e7389), vec3<f32>(select(select(select(select(_e7085, _e7135.member, _e7161), _e7211.member, _e7237), _e7287.member, _e7313), _e7363.member, _e7389), select(select(select(select(_e7086, _e7135.member_1, _e7161), _e7211.member_1, _e7237), _e7287.member_1, _e7313), _e7363.member_1, _e7389), select(select(select(select(_e7087, _e7135.member_2, _e7161), _e7211.member_2, _e7237), _e7287.member_2, _e7313), _e7363.member_2, _e7389)), select(_e7319, _e7384, _e7390), vec3<f32>(select(select(select(select(_e7090, _e7135.member, _e7162), _e7211.member, _e7238), _e7287.member, _e7314), _e7363.member, _e7390), select(select(select(select(_e7091, _e7135.member_1, _e7162), _e7211.member_1, _e7238), _e7287.member_1, _e7314), _e7363.member_1, _e7390), select(select(select(select(_e7092, _e7135.member_2, _e7162), _e7211.member_2, _e7238), _e7287.member_2, _e7314), _e7363.member_2, _e7390)), select(_e7323, _e7357, _e7385), select(_e7325, _e7358, (_e7358 > _e7325)), vec3<f32>(select(select(select(select(_e7096, _e7135.member, _e7157), _e7211.member, _e7233), _e7287.member, _e7309), _e7363.member, _e7385), select(select(select(select(_e7097, _e7135.member_1, _e7157), _e7211.member_1, _e7233), _e7287.member_1, _e7309), _e7363.member_1, _e7385), select(select(select(select(_e7098, _e7135.member_2, _e7157), _e7211.member_2, _e7233), _e7287.member_2, _e7309), _e7363.member_2, _e7385)));
}
let _e7410 = phi_16512_;
let _e7419 = global_1.member.member_7.member_4;
let _e7422 = (_e3432.member_3.x * _e4020.member_2);
let _e7424 = (_e3432.member_3.y * _e4020.member_2);
let _e7426 = (_e3432.member_3.z * _e4020.member_2);
let _e7427 = (0.5f * (_e6862 * select(1f, (2f * (1f - _e6192)), (_e6184 && _e6183))));
let _e7431 = (_e6845 + (_e7422 * _e7427));
let _e7432 = (_e6846 + (_e7424 * _e7427));
let _e7433 = (_e6847 + (_e7426 * _e7427));
let _e7435 = (2f * _e6859);
let _e7437 = ((_e7433 * _e7433) + (_e7435 * _e7426));
let _e7441 = (_e7433 + sqrt(select(0f, _e7437, (_e7437 > 0f))));
let _e7445 = (select(0.5f, _e7410.member_2, (_e7410.member_2 < 1f)) * (_e7435 / select(1e-6f, _e7441, (_e7441 > 1e-6f))));
let _e7449 = (_e7431 + (_e7422 * _e7445));
let _e7450 = (_e7432 + (_e7424 * _e7445));
let _e7451 = (_e7433 + (_e7426 * _e7445));
let _e7455 = (_e7419 * _e7419);
let _e7457 = (_e7451 * _e7451);
let _e7465 = (((_e7433 <= 0f) || (_e7437 <= 0f)) || ((_e7451 <= 0f) || (_e7457 <= (_e7455 * (((_e7449 * _e7449) + (_e7450 * _e7450)) + _e7457)))));
let _e7479 = (_e6845 + ((_e3432.member_4.x * _e4020.member_2) * _e6859));
let _e7480 = (_e6846 + ((_e3432.member_4.y * _e4020.member_2) * _e6859));
let _e7481 = (_e6847 + ((_e3432.member_4.z * _e4020.member_2) * _e6859));
let _e7483 = (_e7481 * _e7481);
let _e7492 = ((_e3815 & 1u) != 0u);
let _e7497 = (select(_e7465, ((_e7481 <= 0f) || (_e7483 <= (_e7455 * (((_e7479 * _e7479) + (_e7480 * _e7480)) + _e7483)))), _e7492) || (_e6844 && ((_e6820 && _e6184) || (_e6184 && (_e6847 <= 0f)))));
phi_16664_ = vec3<f32>(select(select(select(_e7449, _e7431, _e7465), _e7479, _e7492), _e235, _e7497), select(select(select(_e7450, _e7432, _e7465), _e7480, _e7492), _e246, _e7497), select(select(select(_e7451, _e7433, _e7465), _e7481, _e7492), _e257, _e7497));
phi_16665_ = select(1f, 0f, _e7497);
} else {
phi_16664_ = vec3<f32>(_e235, _e246, _e257);
phi_16665_ = 1f;
}
let _e7504 = phi_16664_;
let _e7506 = phi_16665_;
let _e7509 = (_e5596.member * _e7506);
global_4.member[_e192] = (_e203 * (_e5596.member_2.x * _e7509));
global_4.member[_e204] = (_e213 * (_e5596.member_2.y * _e7509));
global_4.member[_e215] = (_e224 * (_e5596.member_2.z * _e7509));
global_4.member[_e226] = _e7504.x;
global_4.member[_e237] = _e7504.y;
global_4.member[_e248] = _e7504.z;
global_4.member[_e259] = _e268;
global_4.member[_e270] = _e279;
global_4.member[_e281] = _e290;
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
